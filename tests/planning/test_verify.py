"""What `verify` measures on plans with known faults."""

from __future__ import annotations

from dataclasses import replace
from math import factorial

import numpy as np
import pytest

from segfmu import InfeasibleError, Limits, Trajectory, Waypoint, plan, verify
from segfmu.planning.verify import require

pytestmark = pytest.mark.interpreted

LIMITS = Limits([1.0, 0.4], [1.0, 0.5], [1.0, 0.5], [10.0, 5.0])
WIDE = Limits([2.0, 0.8], [2.0, 1.0], [2.0, 1.0], [20.0, 10.0])
POINTS = [
    Waypoint([0.0, 0.0]), Waypoint([0.07, 0.055], [0.2, 0.17], [0.34, 0.27]), Waypoint([1.0, 0.8])
]


def planned(order: int) -> Trajectory:
    """A plan far within the limits that it is judged by."""
    limits = LIMITS if order > 2 else Limits([1.0, 0.4], [1.0, 0.5], [1.0, 0.5])
    return replace(plan(POINTS, limits, smoothness=order), limits=WIDE)


def bent(trajectory: Trajectory, derivative: int, size: float) -> Trajectory:
    """The last piece but one of the second axis gains a power of its local time.

    So at its start one derivative jumps, and at its end the lower ones do as well.
    """
    coefficients = trajectory.coefficients.copy()
    last = coefficients.shape[0] - 1
    coefficients[last - 1, derivative] += size / factorial(derivative)
    return replace(trajectory, coefficients=coefficients)


@pytest.mark.parametrize("order", [3, 4, 5])
def test_a_sound_plan_passes(order: int) -> None:
    found = verify(planned(order))
    assert found.passed
    assert found.jumps.max() < 1e-10
    assert found.waypoint_error < 1e-11


@pytest.mark.parametrize(
    ("order", "derivative"), [(n, d) for n in (3, 4, 5) for d in range(n + 1)]
)
def test_a_jump_of_any_derivative_that_must_be_smooth_fails(order: int, derivative: int) -> None:
    sound = planned(order)
    found = verify(bent(sound, derivative, 1e-6))
    assert not found.passed
    # every limit and the waypoints are still met: the jump alone is what fails
    assert (found.usage <= 1.0).all()
    low, high = sound.extrema(derivative)
    scale = max(float(high[1] - low[1]), 1.0)
    if derivative > 0:
        bounds = WIDE.table(2, order)[1]
        peak = max(float(-low[1]), float(high[1]))
        scale = min(bounds[derivative - 1] or np.inf, peak)
    assert found.jumps[derivative, 1] == pytest.approx(1e-6 / scale, rel=1e-3)
    assert found.jumps[:, 0].max() < 1e-10
    with pytest.raises(InfeasibleError, match="jumps by"):
        require(bent(sound, derivative, 1e-6))


def test_a_missed_waypoint_fails() -> None:
    sound = planned(4)
    for name, change in (("position", 1e-6), ("velocity", 1e-6), ("acceleration", 1e-6)):
        middle = sound.waypoints[1]
        states = {n: getattr(middle, n) for n in ("position", "velocity", "acceleration")}
        states[name] = states[name] + [0.0, change]
        points = (sound.waypoints[0], Waypoint(**states), sound.waypoints[2])
        found = verify(replace(sound, waypoints=points))
        assert not found.passed
        assert found.waypoint_error >= 0.9 * change


@pytest.mark.parametrize("derivative", [1, 2, 3, 4])
def test_a_limit_that_is_passed_between_the_switches_fails(derivative: int) -> None:
    sound = plan(POINTS, LIMITS)
    names = ("velocity", "acceleration", "jerk", "snap")
    low, high = sound.extrema(derivative)
    peak = np.maximum(-low, high)
    bounds = {n: getattr(WIDE, n) for n in names}
    bounds[names[derivative - 1]] = peak * [1.0, 1.0 - 1e-6]
    found = verify(replace(sound, limits=Limits(**bounds)))
    assert not found.passed
    assert np.argwhere(found.usage > 1.0 + 1e-9).tolist() == [[derivative - 1, 1]]


@pytest.mark.parametrize("end", [0, 2])
def test_a_missed_end_fails(end: int) -> None:
    sound = planned(4)
    points = list(sound.waypoints)
    points[end] = Waypoint(np.add(points[end].position, [0.0, 1e-6]))
    found = verify(replace(sound, waypoints=tuple(points)))
    assert not found.passed
    assert found.waypoint_error == pytest.approx(1e-6, rel=1e-3)
