"""What the C entry points refuse: the status, and the report where it says more."""

from __future__ import annotations

import re
from math import inf, nan

import numpy as np
import pytest

from segfmu import Limits, Waypoint
from segfmu.kernels.messages import PLAN
from segfmu.kernels.planner.records import PlanStatus
from tests.kernels.planner.c_planner import Asked, Planner

LIMITS = Limits([1.0, 0.8], 1.0, [4.0, 3.0], 20.0)
TABLE = LIMITS.table(2, 4)
START, TARGET, OTHER = Waypoint([0.0, 0.0]), Waypoint([1.0, 0.5]), Waypoint([0.2, -0.4])
OUT_OF_RANGE = int(PlanStatus.OUT_OF_RANGE)


def limits(axis: int, order: int, value: float) -> np.ndarray:
    table = TABLE.copy()
    table[axis, order - 1] = value
    return table


def shown(report: list[float]) -> list[float]:
    """With a text for NaN, which equals itself."""
    return ["nan" if np.isnan(x) else x for x in report]


# changes of a problem of two waypoints, the status, and the report as far as it counts
PROBLEMS = [
    ({"shape": 7}, OUT_OF_RANGE, []),
    ({"shape": -3}, OUT_OF_RANGE, []),
    ({"synchronization": 9}, OUT_OF_RANGE, []),
    ({"sample_time": -1.0}, OUT_OF_RANGE, []),
    ({"sample_time": nan}, OUT_OF_RANGE, []),
    ({"sample_time": inf}, PlanStatus.SAMPLE_TIME, []),
    ({"duration": -1.0}, OUT_OF_RANGE, []),
    ({"duration": nan}, OUT_OF_RANGE, []),
    ({"duration": inf}, OUT_OF_RANGE, []),
    ({"dwells": [0.0, -1.0]}, OUT_OF_RANGE, [0, 1, -1.0]),
    ({"dwells": [0.0, nan]}, OUT_OF_RANGE, [0, 1, nan]),
    ({"dwells": [0.0, inf]}, OUT_OF_RANGE, [0, 1, inf]),
    ({"limits": limits(1, 1, 0.0)}, PlanStatus.NO_VELOCITY_LIMIT, [1, 0, 0.0]),
    ({"limits": limits(1, 1, nan)}, PlanStatus.NO_VELOCITY_LIMIT, [1, 0, nan]),
    ({"limits": limits(0, 2, -1.0)}, PlanStatus.NO_ACCELERATION_LIMIT, [0, 0, -1.0]),
    ({"limits": limits(1, 3, -1.0)}, OUT_OF_RANGE, [1, 0, -1.0]),
    ({"limits": limits(1, 3, nan)}, OUT_OF_RANGE, [1, 0, nan]),
    ({"limits": limits(0, 4, -1.0)}, OUT_OF_RANGE, [0, 0, -1.0]),
    ({"limits": limits(0, 5, nan)}, OUT_OF_RANGE, [0, 0, nan]),
    ({"positions": [[0, 0], [0, inf]]}, OUT_OF_RANGE, [1, 1, inf]),
    ({"positions": [[0, 0], [nan, 0]]}, OUT_OF_RANGE, [0, 1, nan]),
    ({"velocities": [[0, 0], [0, nan]]}, PlanStatus.WAYPOINT_VELOCITY, [1, 1, nan, 0.8]),
    ({"velocities": [[0, 0], [inf, 0]]}, PlanStatus.WAYPOINT_VELOCITY, [0, 1, inf, 1.0]),
    ({"accelerations": [[0, 0], [nan, 0]]}, PlanStatus.WAYPOINT_ACCELERATION, [0, 1, nan, 1.0]),
    ({"velocities": [[0, 0], [0.1, 0]], "dwells": [0, 1]}, PlanStatus.MOVING_DWELL, [0, 1]),
]


@pytest.mark.parametrize(("changes", "status", "report"), PROBLEMS)
def test_plan_refuses(planner: Planner, changes, status: int, report) -> None:
    found = planner.plan(Asked([START, TARGET], LIMITS, **changes))
    assert found.status == status
    assert shown(found.report[: len(report)]) == shown(report)


@pytest.mark.parametrize("target", [TARGET, OTHER])
@pytest.mark.parametrize(("changes", "status", "report"), PROBLEMS)
def test_replan_refuses_the_same(
    planner: Planner, target: Waypoint, changes, status: int, report
) -> None:
    old = planner.plan(Asked([START, TARGET], LIMITS))
    found = planner.replan(old, 0.7, Asked([START, target], LIMITS, **changes))
    assert found.status == status
    assert shown(found.report[: len(report)]) == shown(report)


@pytest.mark.parametrize(
    "changes", [{"points": 1}, {"axes": 1}, {"smoothness": 3}, {"dwells": [1.0, 0.0]}]
)
def test_replan_refuses_other_forms(planner: Planner, changes) -> None:
    old = planner.plan(Asked([START, TARGET], LIMITS))
    assert planner.replan(old, 0.7, Asked([START, OTHER], LIMITS, **changes)).status == OUT_OF_RANGE


def test_replan_takes_equal_targets_for_one(planner: Planner) -> None:
    old = planner.plan(Asked([START, TARGET], LIMITS))
    stays = planner.replan(old, 0.0, Asked([START, START], LIMITS))
    assert (stays.status, stays.duration) == (PlanStatus.PLANNED, 0.0)
    once = planner.replan(old, 0.7, Asked([START, OTHER], LIMITS))
    twice = planner.replan(old, 0.7, Asked([START, OTHER, OTHER], LIMITS))
    assert (twice.status, twice.duration) == (PlanStatus.PLANNED, once.duration)


@pytest.mark.parametrize("time", [-1.0, nan, inf])
def test_times_that_are_none(planner: Planner, time: float) -> None:
    request = Asked([START, TARGET], LIMITS)
    old = planner.plan(request)
    assert planner.replan(old, time, request).status == OUT_OF_RANGE
    assert planner.reach(old, time, [0.0, 0.0], TABLE).status == OUT_OF_RANGE


@pytest.mark.parametrize(
    ("velocity", "table", "status", "report"),
    [
        ([0.0, 0.9], TABLE, PlanStatus.WAYPOINT_VELOCITY, [1, 1, 0.9, 0.8]),
        ([-2.0, 0.0], TABLE, PlanStatus.WAYPOINT_VELOCITY, [0, 1, -2.0, 1.0]),
        ([0.0, nan], TABLE, PlanStatus.WAYPOINT_VELOCITY, [1, 1, nan, 0.8]),
        ([inf, 0.0], TABLE, PlanStatus.WAYPOINT_VELOCITY, [0, 1, inf, 1.0]),
        ([0.0, 0.0], limits(1, 1, 0.0), PlanStatus.NO_VELOCITY_LIMIT, [1, 0, 0.0]),
        ([0.0, 0.0], limits(0, 1, nan), PlanStatus.NO_VELOCITY_LIMIT, [0, 0, nan]),
        ([0.0, 0.0], limits(1, 2, 0.0), PlanStatus.NO_ACCELERATION_LIMIT, [1, 0, 0.0]),
        ([0.0, 0.0], limits(1, 3, nan), OUT_OF_RANGE, [1, 0, nan]),
    ],
)
def test_reach_velocity_refuses(planner: Planner, velocity, table, status: int, report) -> None:
    old = planner.plan(Asked([START, TARGET], LIMITS))
    found = planner.reach(old, 0.7, velocity, table)
    assert found.status == status
    assert shown(found.report[: len(report)]) == shown(report)


LOWER = [[0.5, 0.0], [0.8, 2.0]]
SIDES = [
    ({"velocities": [[0, 0], [-0.6, 0]]}, PlanStatus.WAYPOINT_VELOCITY, [0, 1, -0.6, 0.5, 1],
     "limits.velocity_min"),
    ({"velocities": [[0, 0], [1.6, 0]]}, PlanStatus.WAYPOINT_VELOCITY, [0, 1, 1.6, 1.0, 0],
     "limits.velocity"),
    # the same number in both directions is one limit
    ({"velocities": [[0, 0], [0, -0.9]]}, PlanStatus.WAYPOINT_VELOCITY, [1, 1, -0.9, 0.8, 0],
     "limits.velocity"),
    ({"accelerations": [[0, 0], [-1.5, 0]]}, PlanStatus.WAYPOINT_ACCELERATION,
     [0, 1, -1.5, 1.0, 0], "limits.acceleration"),
    ({"accelerations": [[0, 0], [0, -2.5]]}, PlanStatus.WAYPOINT_ACCELERATION,
     [1, 1, -2.5, 2.0, 1], "limits.acceleration_min"),
    # braking down from -0.49 m/s, and building up an acceleration to -0.49 m/s
    ({"velocities": [[-0.49, 0], [0, 0]], "accelerations": [[-1, 0], [0, 0]]},
     PlanStatus.START_BRAKING, [0, 0, -1.0, 0.5, 1], "limits.velocity_min"),
    ({"velocities": [[0, 0], [-0.49, 0]], "accelerations": [[0, 0], [1, 0]]},
     PlanStatus.END_BRAKING, [0, 0, 1.0, 0.5, 1], "limits.velocity_min"),
    ({"velocities": [[0, 0], [0.99, 0]], "accelerations": [[0, 0], [-1, 0]]},
     PlanStatus.END_BRAKING, [0, 0, -1.0, 1.0, 0], "limits.velocity"),
]


@pytest.mark.parametrize(("changes", "status", "report", "limit"), SIDES)
def test_refusals_tell_the_direction(
    planner: Planner, changes, status: int, report, limit: str
) -> None:
    found = planner.plan(Asked([START, TARGET], LIMITS, lower=LOWER, **changes))
    assert (found.status, found.report) == (status, report)
    said = PLAN.text(status, found.report)
    assert re.search(rf"raise {re.escape(limit)}(?!_)", said)


@pytest.mark.parametrize(
    ("velocity", "report"),
    [([-0.6, 0.0], [0, 1, -0.6, 0.5, 1]), ([1.1, 0.0], [0, 1, 1.1, 1.0, 0]),
     ([0.0, -0.9], [1, 1, -0.9, 0.8, 0])],
)
def test_reach_velocity_tells_the_direction(planner: Planner, velocity, report) -> None:
    old = planner.plan(Asked([START, TARGET], LIMITS))
    found = planner.reach(old, 0.7, velocity, TABLE, LOWER)
    assert (found.status, found.report) == (PlanStatus.WAYPOINT_VELOCITY, report)
