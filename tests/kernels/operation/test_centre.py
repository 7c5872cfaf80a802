"""Control points in the middle of their bounds: the conditions, the bounds, and that it is one."""

from __future__ import annotations

import numpy as np
import pytest

from segfmu import ActuatorBounds
from segfmu.kernels.operation.centre import find_centre
from segfmu.kernels.operation.records import Control, Known, OperationWork

COUNT = Control.POINTS
INTERVAL = 0.1
BOUNDS = ActuatorBounds(velocity=1.0, acceleration=2.0, velocity_min=-0.8, acceleration_min=-1.5)


def known_of(bounds: ActuatorBounds) -> np.ndarray:
    known = np.zeros((Known.SIZE, Known.COLUMNS))
    known[Known.BOUNDS, : bounds.record.size] = bounds.record
    return known


def work_of(start: float) -> np.ndarray:
    """Moments of free swings of 1 rad/s; the first control points are set."""
    work = np.zeros((OperationWork.SIZE, OperationWork.COLUMNS))
    knots = INTERVAL * np.arange(COUNT - 1)
    work[OperationWork.MOMENT, : COUNT - 1] = np.cos(knots)
    work[OperationWork.MOMENT + 1, : COUNT - 1] = np.sin(knots)
    work[OperationWork.CONTROL, : Control.FREE] = start
    return work


def finds(
    share: float, aims: tuple[float, ...], known: np.ndarray, work: np.ndarray,
    first: int = Control.SWING,
) -> bool:
    """Whether there is a centre for conditions from the first on, as many as there are aims."""
    row = np.zeros(work.shape[1])
    row[first : first + len(aims)] = aims
    return find_centre(0, share, INTERVAL, first, first + len(aims), row, known, work)


def way_of(points: np.ndarray) -> float:
    """Integral of the spline, by Gauss's rule in each interval."""
    whole = 0.0
    for k in range(Control.INTERVALS):
        for t in (0.5 - 0.5 / np.sqrt(3.0), 0.5 + 0.5 / np.sqrt(3.0)):
            weights = np.array([
                (1.0 - t) ** 3, 3.0 * t**3 - 6.0 * t**2 + 4.0,
                -3.0 * t**3 + 3.0 * t**2 + 3.0 * t + 1.0, t**3,
            ]) / 6.0
            whole += 0.5 * INTERVAL * float(weights @ points[k : k + 4])
    return whole


@pytest.mark.parametrize("start", [0.0, 0.5, -0.7])
@pytest.mark.parametrize("first", [Control.SWING, Control.PLACE])
def test_the_centre_rests_in_a_place(start: float, first: int) -> None:
    work = work_of(start)
    # a carriage that brakes: no weight of a control point is another one's
    work[OperationWork.CONTROL, : Control.FREE] *= 1.0, 0.9, 0.6
    aims = (0.4, -0.2, 1.7)
    assert finds(1.0, aims[first:], known_of(BOUNDS), work, first)
    points = work[OperationWork.CONTROL, :COUNT]
    assert way_of(points) == pytest.approx(1.7, abs=1e-12)
    moments = work[OperationWork.MOMENT : OperationWork.MOMENT + 2, : COUNT - 1]
    if first == Control.SWING:
        np.testing.assert_allclose(moments @ np.diff(points[:COUNT]), aims[:2], atol=1e-12)


@pytest.mark.parametrize(
    ("start", "aims"),
    [
        (0.0, (0.0, 0.0)),
        (0.5, (0.6, -0.3)),
        (-0.7, (-2.0, 1.0)),
        (0.2, (2.0, 2.0)),
    ],
)
def test_the_centre_keeps_bounds_and_conditions(start: float, aims: tuple[float, float]) -> None:
    work = work_of(start)
    assert finds(1.0, aims, known_of(BOUNDS), work)
    points = work[OperationWork.CONTROL, :COUNT]
    changes = np.diff(points)
    moments = work[OperationWork.MOMENT : OperationWork.MOMENT + 2, : COUNT - 1]
    np.testing.assert_allclose(moments @ changes, aims, atol=1e-12)
    assert (points[:3] == start).all()
    assert (points[-3:] == 0.0).all()
    inner, steps = points[3:-3], changes[2:-2]
    assert (inner < 1.0).all()
    assert (inner > -0.8).all()
    assert (steps < 2.0 * INTERVAL).all()
    assert (steps > -1.5 * INTERVAL).all()
    # the gradient of the logarithms is one of the conditions'
    own = 1.0 / (1.0 - inner) - 1.0 / (inner + 0.8)
    across = 1.0 / (2.0 * INTERVAL - steps) - 1.0 / (steps + 1.5 * INTERVAL)
    gradient = own + across[:-1] - across[1:]
    normals = (moments[:, :-1] - moments[:, 1:])[:, 2:-2].T
    rest = gradient - normals @ np.linalg.lstsq(normals, gradient, rcond=None)[0]
    assert np.abs(rest).max() < 1e-6 * np.abs(across).max()


def test_what_no_acceleration_brings_about_is_not_found() -> None:
    known = known_of(BOUNDS)
    # more than the bounds times all moments, much more than the fastest, no time to brake
    assert not finds(1.0, (20.0, 0.0), known, work_of(0.0))
    assert not finds(1.0, (0.0, 0.0), known, work_of(1.03))
    assert not finds(0.2, (0.0, 0.0), known, work_of(0.5))
    assert not finds(1.0, (np.nan, 0.0), known, work_of(0.0))


def test_a_velocity_without_a_bound_has_none() -> None:
    work = work_of(3.0)
    free = ActuatorBounds(acceleration=2.0)
    assert finds(1.0, (0.5, 0.5), known_of(free), work)
    assert work[OperationWork.CONTROL].max() >= 3.0
