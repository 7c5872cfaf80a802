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
    """Moments of free swings of 1 rad/s."""
    work = np.zeros((OperationWork.SIZE, OperationWork.COLUMNS))
    knots = INTERVAL * np.arange(COUNT - 1)
    work[OperationWork.MOMENT, : COUNT - 1] = np.cos(knots)
    work[OperationWork.MOMENT + 1, : COUNT - 1] = np.sin(knots)
    work[OperationWork.CONTROL, :2] = start
    return work


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
    assert find_centre(0, 1.0, INTERVAL, *aims, known_of(BOUNDS), work)
    points = work[OperationWork.CONTROL]
    changes = np.diff(points)
    moments = work[OperationWork.MOMENT : OperationWork.MOMENT + 2, : COUNT - 1]
    np.testing.assert_allclose(moments @ changes, aims, atol=1e-12)
    assert (points[:2] == start).all()
    assert (points[-2:] == 0.0).all()
    inner, steps = points[2:-2], changes[1:-1]
    assert (inner < 1.0).all()
    assert (inner > -0.8).all()
    assert (steps < 2.0 * INTERVAL).all()
    assert (steps > -1.5 * INTERVAL).all()
    # the gradient of the logarithms is one of the conditions'
    own = 1.0 / (1.0 - inner) - 1.0 / (inner + 0.8)
    across = 1.0 / (2.0 * INTERVAL - steps) - 1.0 / (steps + 1.5 * INTERVAL)
    gradient = own + across[:-1] - across[1:]
    normals = (moments[:, :-1] - moments[:, 1:])[:, 1:-1].T
    rest = gradient - normals @ np.linalg.lstsq(normals, gradient, rcond=None)[0]
    assert np.abs(rest).max() < 1e-6 * np.abs(across).max()


def test_what_no_acceleration_brings_about_is_not_found() -> None:
    known = known_of(BOUNDS)
    # more than the bounds times all moments, much more than the fastest, no time to brake
    assert not find_centre(0, 1.0, INTERVAL, 20.0, 0.0, known, work_of(0.0))
    assert not find_centre(0, 1.0, INTERVAL, 0.0, 0.0, known, work_of(1.03))
    assert not find_centre(0, 0.2, INTERVAL, 0.0, 0.0, known, work_of(0.5))
    assert not find_centre(0, 1.0, INTERVAL, np.nan, 0.0, known, work_of(0.0))


def test_a_velocity_without_a_bound_has_none() -> None:
    work = work_of(3.0)
    free = ActuatorBounds(acceleration=2.0)
    assert find_centre(0, 1.0, INTERVAL, 0.5, 0.5, known_of(free), work)
    assert work[OperationWork.CONTROL].max() >= 3.0
