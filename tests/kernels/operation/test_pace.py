"""The pace that a plan tells is about that of the fastest one which the drives follow."""

from __future__ import annotations

import numpy as np
import pytest

from segfmu import ActuatorBounds, Limits, Trajectory, Waypoint, plan
from segfmu.arrays import FloatArray
from segfmu.crane.demand import peaks
from segfmu.kernels.crane.records import Demand
from segfmu.kernels.operation.pace import LOWEST, pace_within
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


def told(found: Trajectory, size: str, bounds: ActuatorBounds) -> float:
    known = known_of(SIZES[size][0])
    known[Known.BOUNDS, : bounds.record.size] = bounds.record
    work = np.zeros((OperationWork.SIZE, OperationWork.COLUMNS))
    return pace_within(found.timing, found.coefficients, found.offsets, known, work)


@pytest.mark.parametrize("size", SIZES)
def test_at_the_pace_told_the_drives_follow_and_much_faster_they_do_not(size: str) -> None:
    crane, rope, fast = SIZES[size]
    for way in ways(rope, 6):
        found = moved(way, fast)
        most = np.abs(peaks(crane, found)[0][:, ACCELERATION]).max(axis=0)
        for share in (0.95, 0.7):
            bound = np.array([share * most[0], np.inf, np.inf])
            pace = told(found, size, ActuatorBounds(acceleration=bound))
            assert LOWEST < pace < 1.0
            for at, follows in ((0.97 * pace, True), (min(1.1 * pace, 1.0), False)):
                asked = np.abs(peaks(crane, moved(way, fast, at))[0][:, ACCELERATION]).max(axis=0)
                assert (asked[0] <= bound[0]) == follows


@pytest.mark.parametrize("size", SIZES)
def test_a_plan_that_keeps_the_bounds_or_that_no_pace_helps_tells_none(size: str) -> None:
    crane, rope, fast = SIZES[size]
    found = moved(ways(rope, 1)[0], fast)
    most = np.abs(peaks(crane, found)[0]).max(axis=0)
    assert told(found, size, ActuatorBounds(acceleration=1.01 * most[ACCELERATION].max())) == 1.0
    # a velocity that is held asks for as much however slowly it is built up
    assert told(found, size, ActuatorBounds(velocity=0.95 * fast)) == 1.0
