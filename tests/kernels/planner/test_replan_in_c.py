"""The C entry points of replanning, without Python, give what Python's give."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pytest

from segfmu import Limits, Trajectory, Waypoint, plan, reach_velocity, replan, stop, verify
from segfmu.planning.problem import SYNCHRONIZATIONS
from tests.campaign import campaign
from tests.kernels.planner.c_planner import Asked, Planner, Result
from tests.property.replan_in_c import Replanner
from tests.property.soak_replan import soak

LIMITS = Limits([1.0, 0.8], 1.0, [4.0, 3.0], 20.0)
START, TARGET = Waypoint([0.0, 0.0]), Waypoint([1.0, 0.5])
RESTING = Waypoint(TARGET.position, dwell=5.0)
PASSED = Waypoint(TARGET.position, [0.3, 0.2], [0.0, 0.1])
SHARES = [5e-324, 1e-15, 1e-11, 0.05, 0.2, 0.5, 0.8, 1.0 - 1e-5, 1.0 - 1e-9, 1.0 - 1e-15, 1.0]


def require_same(found: Result, expected: Trajectory) -> None:
    """Require the durations, the states at the start and the positions of Python's plan."""
    n = expected.smoothness
    assert found.status == 0
    assert found.duration == pytest.approx(expected.duration, rel=1e-12)
    for d in range(n + 1):
        assert found(0.0, d) == pytest.approx(expected(0.0, d), rel=1e-9, abs=1e-9)
    times = np.linspace(0.0, expected.duration, 20)
    assert np.array([found(t) for t in times]) == pytest.approx(expected(times), abs=1e-11)
    for d in range(3):
        end = found(found.duration, d)
        assert end == pytest.approx(expected(expected.duration, d), rel=1e-9, abs=1e-9)
    assert found.arrivals == pytest.approx(expected.axis_waypoint_times[-1], rel=1e-9, abs=1e-12)


def asked(targets: Waypoint | Sequence[Waypoint], n: int = 4, **changes) -> Asked:
    points = [targets] if isinstance(targets, Waypoint) else targets
    return Asked([START, *points], LIMITS, n, **changes)


@pytest.mark.parametrize("n", [3, 4, 5, 6])
@pytest.mark.parametrize("share", SHARES)
def test_c_replans_as_python_does(planner: Planner, n: int, share: float) -> None:
    old, expected = planner.plan(asked(TARGET, n)), plan([START, TARGET], LIMITS, smoothness=n)
    time, other = share * expected.duration, Waypoint([0.2, -0.4])
    require_same(old, expected)
    require_same(planner.replan(old, time, asked(TARGET, n)), replan(expected, time, TARGET))
    require_same(planner.replan(old, time, asked(other, n)), replan(expected, time, other))
    require_same(planner.reach(old, time, [0.0, 0.0], LIMITS.table(2, n)), stop(expected, time))


@pytest.mark.parametrize("share", [0.2, 0.5, 0.9])
@pytest.mark.parametrize(
    "targets",
    [
        Waypoint([1.0, 0.5], [0.1, 0.0]), Waypoint([1.0, 0.5], [0.5, 0.0]),
        Waypoint([1.0, 0.5], [0.0, 0.0], [0.2, 0.0]), PASSED, RESTING,
        Waypoint([0.2, -0.4], dwell=2.0), [Waypoint([0.2, -0.4], dwell=1.0), TARGET],
        Waypoint([1.0, 0.4], [1e-12, 0.0], dwell=1.0),
    ],
)
def test_other_states_and_dwells_at_the_target(planner: Planner, targets, share: float) -> None:
    old, expected = planner.plan(asked(TARGET)), plan([START, TARGET], LIMITS)
    time = share * expected.duration
    require_same(planner.replan(old, time, asked(targets)), replan(expected, time, targets))


@pytest.mark.parametrize("share", [0.2, 0.5, 0.9, 1.0 - 1e-9])
@pytest.mark.parametrize(
    ("target", "synchronize"),
    [(PASSED, "waypoints"), (PASSED, "total"), *((RESTING, s) for s in SYNCHRONIZATIONS)],
)
def test_the_rest_is_kept(
    planner: Planner, target: Waypoint, share: float, synchronize: str
) -> None:
    request = asked(target, synchronization=SYNCHRONIZATIONS.index(synchronize))
    old = planner.plan(request)
    expected = plan([START, target], LIMITS, synchronize=synchronize)
    time = share * expected.duration
    kept = planner.replan(old, time, request)
    require_same(kept, replan(expected, time, target))
    assert kept.duration == pytest.approx(old.duration - time, rel=1e-6)
    # of the dwell, what is left: then the same again
    left = min(target.dwell, kept.duration)
    again = planner.replan(kept, 0.1 * kept.duration, asked(
        Waypoint(target.position, target.velocity, target.acceleration, dwell=left),
        synchronization=SYNCHRONIZATIONS.index(synchronize),
    ))
    assert again.status == 0
    assert again.duration == pytest.approx(0.9 * kept.duration, rel=1e-6)


@pytest.mark.parametrize("before", [0.0, 4e-16, 1e-12])
def test_at_its_end_a_plan_that_ends_moving_is_kept(planner: Planner, before: float) -> None:
    rng = np.random.default_rng(3)
    for _ in range(20):
        target = Waypoint(rng.uniform(-1.0, 1.0, 2), rng.uniform(-0.5, 0.5, 2))
        old = planner.plan(asked(target))
        found = planner.replan(old, old.duration - before, asked(target))
        assert found.status == 0
        assert found.duration <= before + 1e-14 * old.duration


@pytest.mark.parametrize("synchronize", ["waypoints", "total"])
def test_axes_meet_where_the_old_plan_let_them_not(planner: Planner, synchronize: str) -> None:
    old = planner.plan(asked(TARGET, synchronization=SYNCHRONIZATIONS.index("none")))
    assert old.ends[1] < old.ends[0] - 0.1
    request = asked(TARGET, synchronization=SYNCHRONIZATIONS.index(synchronize))
    found = planner.replan(old, 0.5 * old.duration, request)
    assert found.status == 0
    assert found.ends[1] == pytest.approx(found.ends[0], rel=1e-12)
    assert found(found.duration) == pytest.approx(TARGET.position, abs=1e-9)


@pytest.mark.parametrize("target", [TARGET, Waypoint([0.2, -0.4])])
def test_duration_and_sample_time_hold_for_any_target(planner: Planner, target: Waypoint) -> None:
    old = planner.plan(asked(TARGET))
    found = planner.replan(old, 0.7, asked(target, duration=20.0))
    assert (found.status, found.duration) == (0, pytest.approx(20.0, rel=1e-12))
    found = planner.replan(old, 0.7, asked(target, sample_time=0.5))
    assert found.status == 0
    assert found.duration / 0.5 == pytest.approx(round(found.duration / 0.5), rel=1e-12)


def test_the_rest_is_kept_if_it_takes_the_duration(planner: Planner) -> None:
    request = asked(TARGET, duration=20.0)
    old = planner.plan(request)
    left = planner.replan(old, 7.0, asked(TARGET, duration=13.0))
    assert left(6.0) == pytest.approx(old(13.0), abs=1e-12)
    more = planner.replan(old, 7.0, request)
    assert (more.status, more.duration) == (0, pytest.approx(20.0, rel=1e-12))


@pytest.mark.parametrize("share", [0.0, 0.2, 0.7, 1.0])
@pytest.mark.parametrize(
    "velocity", [[0.3, -0.2], [1.0, 0.8], [0.0, 0.4], [1.0 + 1e-10, 0.8 - 1e-10]]
)
def test_c_reaches_velocities_as_python_does(planner: Planner, share: float, velocity) -> None:
    old, expected = planner.plan(asked(TARGET)), plan([START, TARGET], LIMITS)
    time = share * expected.duration
    found = planner.reach(old, time, velocity, LIMITS.table(2, 4))
    require_same(found, reach_velocity(expected, velocity, time))


@pytest.mark.parametrize("share", [0.0, 0.2, 0.7, 1.0])
@pytest.mark.parametrize("velocity", [[-0.3, 0.5], [0.8, -0.4], [-0.3 * (1.0 + 1e-10), 0.0]])
def test_c_reaches_velocities_within_limits_by_direction(
    planner: Planner, share: float, velocity
) -> None:
    limits = Limits(
        [1.0, 0.8], 1.0, [4.0, 3.0], 20.0, velocity_min=[-0.3, -np.inf],
        acceleration_min=[-2.0, -0.5],
    )
    expected = plan([START, TARGET], limits)
    old, time = planner.plan(Asked([START, TARGET], limits)), share * expected.duration
    lower = limits.lower(2)
    found = reach_velocity(expected, velocity, time)
    require_same(planner.reach(old, time, velocity, limits.table(2, 4), lower), found)


@pytest.mark.parametrize("share", [0.75, 0.85, 0.95])
@pytest.mark.parametrize("n", [3, 4, 5, 6])
def test_a_stop_within_limits_that_the_rest_of_the_old_plan_breaks(
    planner: Planner, n: int, share: float
) -> None:
    old, expected = planner.plan(asked(TARGET, n)), plan([START, TARGET], LIMITS, smoothness=n)
    time = share * expected.duration
    state = [np.abs(expected(np.linspace(time, expected.duration, 999), d)) for d in (2, 3)]
    # the state keeps these limits, what is left does not
    tight = [0.5 * (s[0] + s.max(axis=0)) for s in state]
    limits = Limits([1.0, 0.8], *tight, 30.0)
    found = stop(expected, time, limits)
    assert verify(found).passed
    require_same(planner.reach(old, time, [0.0, 0.0], limits.table(2, n)), found)


def test_a_kept_rest_does_not_jump_at_its_start(planner: Planner) -> None:
    # on a long way small differences at the end are large ones at the start
    targets = [Waypoint([50.0, 50.0], [0.3, 0.3], [0.1 + e, 0.1 + e]) for e in (0.0, 0.9e-9)]
    old = planner.plan(asked(targets[0]))
    found = planner.replan(old, 1.0, asked(targets[1]))
    assert found.status == 0
    for d in range(5):
        assert found(0.0, d) == pytest.approx(old(1.0, d), abs=1e-9)


@pytest.mark.parametrize("synchronize", ["waypoints", "total"])
def test_a_dwell_of_a_kept_rest_begins_where_its_motion_ends(
    planner: Planner, synchronize: str
) -> None:
    # a long plan: its clock is coarse against what is left of it
    points = [Waypoint([0.0, 0.0]), Waypoint([50.0, 3.0], dwell=0.01)]
    limits = Limits([1.0, 0.8], [2.0, 0.7], [4.0, 3.0], 20.0)
    old = plan(points, limits, synchronize=synchronize)
    c = Replanner(planner)
    for before in np.linspace(1e-4, 5e-3, 40):
        given = old, old.duration - 0.01 - before, (points[-1],), limits
        for replanned in (replan, c.replan):
            found = replanned(*given, synchronize=synchronize)
            assert found.duration <= (0.01 + before) * (1.0 + 1e-9)
            assert verify(found).passed


@campaign(48, 2000)
@pytest.mark.parametrize("n", [2, 3, 4, 5])
def test_random_plans_are_replanned(planner: Planner, n: int, count: int) -> None:
    tally = soak(n, count, seed=7, c=Replanner(planner))
    assert tally.states >= count
    assert tally.refused == tally.invalid == tally.late == []


def test_a_target_that_moves_is_seen_beside_a_velocity_limit_that_is_none(
    planner: Planner,
) -> None:
    loose, old_target = Limits(1e9, 1.0, 2.0, 5.0), Waypoint([1.0, 0.5])
    old, expected = (
        planner.plan(Asked([START, old_target], loose)), plan([START, old_target], loose)
    )
    for target in (old_target, Waypoint([1.0, 0.501]), Waypoint([1.0, 0.5], [0.01, 0.0])):
        found = planner.replan(old, 0.5, Asked([START, target], loose))
        require_same(found, replan(expected, 0.5, target))
        assert found(found.duration) == pytest.approx(target.position, rel=1e-9)
        assert found(found.duration, 1) == pytest.approx(target.velocity, abs=1e-9)
