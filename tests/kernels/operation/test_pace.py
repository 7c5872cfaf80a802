"""The pace that a plan tells is about that of the fastest one which the drives follow."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from segfmu import ActuatorBounds, Limits, Trajectory, Waypoint, plan
from segfmu.arrays import FloatArray
from segfmu.crane.demand import peaks
from segfmu.kernels.crane.records import Demand
from segfmu.kernels.operation.pace import LOWEST, ease_within, pace_within
from segfmu.kernels.operation.records import Known, OperationWork
from tests.kernels.operation.test_reach import SIZES, known_of

ACCELERATION = slice(Demand.ACCELERATION, Demand.ACCELERATION + 3)


def moved(way: FloatArray, fast: float, pace: float = 1.0) -> Trajectory:
    limits = Limits(fast, 0.5 * fast * pace**2, fast * pace**3, 5.0 * fast * pace**4)
    return plan([Waypoint(p) for p in way], limits)


def ways(rope: float, count: int) -> FloatArray:
    """Ways of the bridge: an axis that waits for others gets slower by less than its pace."""
    found = np.zeros((count, 2, 3))
    found[:, :, 2] = -rope
    found[:, 1, 0] = np.random.default_rng(5).uniform(-3.0, 3.0, count) * rope
    return found


def given(found: Trajectory, size: str, bounds: ActuatorBounds) -> tuple[Any, ...]:
    known = known_of(SIZES[size][0])
    known[Known.BOUNDS, : bounds.record.size] = bounds.record
    work = np.zeros((OperationWork.SIZE, OperationWork.COLUMNS))
    limits = found.limits.table(3, found.smoothness)
    return limits, found.timing, found.coefficients, found.offsets, known, work


def told(found: Trajectory, size: str, bounds: ActuatorBounds) -> tuple[float, float, float]:
    """Pace, steepness of ramps, and share of the velocity."""
    return ease_within(*given(found, size, bounds))


@pytest.mark.parametrize("size", SIZES)
def test_at_the_pace_told_the_drives_follow_and_much_faster_they_do_not(size: str) -> None:
    crane, rope, fast = SIZES[size]
    for way in ways(rope, 6):
        found = moved(way, fast)
        most = np.abs(peaks(crane, found)[0][:, ACCELERATION]).max(axis=0)
        for share in (0.95, 0.7):
            bound = np.array([share * most[0], np.inf, np.inf])
            pace, steepness, speed = told(found, size, ActuatorBounds(acceleration=bound))
            assert LOWEST < pace < 1.0
            assert (steepness, speed) == (1.0, 1.0)
            for at, follows in ((0.97 * pace, True), (min(1.1 * pace, 1.0), False)):
                asked = np.abs(peaks(crane, moved(way, fast, at))[0][:, ACCELERATION]).max(axis=0)
                assert (asked[0] <= bound[0]) == follows


@pytest.mark.parametrize("size", SIZES)
def test_a_plan_that_keeps_the_bounds_tells_nothing(size: str) -> None:
    crane, rope, fast = SIZES[size]
    found = moved(ways(rope, 1)[0], fast)
    most = np.abs(peaks(crane, found)[0]).max(axis=0)
    bounds = ActuatorBounds(acceleration=1.01 * most[ACCELERATION].max())
    assert told(found, size, bounds) == (1.0, 1.0, 1.0)


@pytest.mark.parametrize("size", SIZES)
def test_a_velocity_that_is_held_is_slowed_down(size: str) -> None:
    """It asks for as much however slowly it is built up."""
    crane, rope, fast = SIZES[size]
    found = moved(10.0 * ways(rope, 1)[0], fast)
    for share in (0.95, 0.2):
        _, _, speed = told(found, size, ActuatorBounds(velocity=share * fast))
        assert 0.95 * share < speed <= share


@pytest.mark.parametrize("size", SIZES)
def test_steep_ramps_get_flat_rather_than_the_acceleration_small(size: str) -> None:
    """Without a limit of the snap it is that of the ramps which asks for most."""
    crane, rope, fast = SIZES[size]
    way = ways(rope, 1)[0]
    found = plan([Waypoint(p) for p in way], Limits(fast, 0.5 * fast, 50.0 * fast))
    slow = plan([Waypoint(p) for p in way], Limits(fast, 0.5 * fast, 0.5 * fast))
    bound = np.abs(peaks(crane, slow)[0][:, ACCELERATION]).max()
    bounds = ActuatorBounds(acceleration=bound)
    pace, steepness, speed = told(found, size, bounds)
    assert steepness < 1.0
    assert speed == 1.0
    assert pace > 1.5 * pace_within(1.0, 1.0, *given(found, size, bounds))
