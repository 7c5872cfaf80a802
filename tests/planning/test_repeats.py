"""Equal waypoints in a row are one waypoint; a plan to where one is lasts no time."""

from __future__ import annotations

import numpy as np
import pytest

from segfmu import (
    ActuatorBounds,
    Crane,
    FlatInverse,
    InfeasibleError,
    Limits,
    Trajectory,
    Waypoint,
    plan,
    plan_actuated,
    reach_velocity,
    replan,
    stop,
    verify,
)
from tests.campaign import campaign
from tests.planning.routes import route

LIMITS = Limits([1.0, 0.8, 0.5], [1.0, 0.8, 0.8], 4.0, 30.0)
CRANE = Crane(bridge_mass=2.2, trolley_mass=1.155, payload_mass=1.0)
HERE, THERE = Waypoint([0.1, 0.2, -1.0]), Waypoint([1.0, 0.5, -0.7])
OPTIONS = [
    {}, {"synchronize": "total"}, {"synchronize": "none"}, {"shape": "smoothstep"},
    {"smoothness": 5}, {"sample_time": 0.05}, {"duration": 30.0}, {"smoothness": 2},
]


def limits(options) -> Limits:
    """At the smoothness 2 the snap has none."""
    return Limits(LIMITS.velocity, LIMITS.acceleration, 4.0) if "smoothness" in options else LIMITS


def same_path(one: Trajectory, other: Trajectory) -> bool:
    times = np.linspace(0.0, one.duration, 501)
    return abs(one.duration - other.duration) <= 1e-12 * one.duration and np.allclose(
        one(times), other(times), rtol=0.0, atol=1e-11
    )


@pytest.mark.parametrize("options", OPTIONS)
@campaign(2, 10)
def test_repeats_change_nothing(options, count: int) -> None:
    random = np.random.default_rng(5)
    for _ in range(count):
        points = route(random)
        once = plan(points, limits(options), **options)
        counts = random.integers(1, 4, len(points))
        repeated = []
        for point, times in zip(points, counts, strict=True):
            # one of them has the dwell
            states = ("free", "free") if point.free else (point.velocity, point.acceleration)
            still = Waypoint(point.position, *states)
            repeated += [still] * (times - 1) + [point]
        found = plan(repeated, limits(options), **options)
        assert verify(found).passed
        assert same_path(once, found)
        first = np.cumsum(counts) - counts
        assert np.allclose(
            found.axis_waypoint_times[first], once.axis_waypoint_times, rtol=0.0, atol=1e-12
        )


def test_dwells_add_up() -> None:
    points = [HERE, Waypoint(THERE.position, dwell=0.5), Waypoint(THERE.position, dwell=1.0), HERE]
    found = plan(points, LIMITS)
    once = plan([HERE, Waypoint(THERE.position, dwell=1.5), HERE], LIMITS)
    assert same_path(once, found)
    assert found.waypoint_times[2] - found.waypoint_times[1] == pytest.approx(0.5, abs=1e-12)


def test_waypoints_that_differ_by_rounding_are_one() -> None:
    found = plan([HERE, Waypoint([0.3, 0.3, -1.0]), Waypoint([0.1 + 0.2, 0.3, -1.0])], LIMITS)
    assert found.waypoint_times[2] == found.waypoint_times[1]


def test_a_free_state_is_equal_to_a_given_one() -> None:
    moving = Waypoint([0.5, 0.3, -0.9], [0.3, 0.1, 0.05])
    for pair in ([Waypoint(moving.position, "free", "free"), moving],
                 [moving, Waypoint(moving.position, "free", "free")]):
        found = plan([HERE, *pair, THERE], LIMITS)
        assert found.waypoint_times[1] == found.waypoint_times[2]
        assert same_path(plan([HERE, moving, THERE], LIMITS), found)


def test_equal_places_with_other_velocities_are_two_waypoints() -> None:
    found = plan([HERE, Waypoint([0.5, 0.3, -0.9], [0.3, 0.0, 0.0]), Waypoint([0.5, 0.3, -0.9])],
                 LIMITS)
    assert found.waypoint_times[2] > found.waypoint_times[1]


def test_a_dwell_of_a_moving_waypoint_is_refused_where_it_is_given() -> None:
    moving = [0.3, 0.1, 0.05]
    place = [0.5, 0.3, -0.9]
    points = [HERE, Waypoint(place, moving), Waypoint(place, moving, dwell=1.0), THERE]
    with pytest.raises(InfeasibleError, match="axis x, waypoint 3: a dwell needs"):
        plan(points, LIMITS)


@pytest.mark.parametrize("options", OPTIONS)
def test_a_plan_to_where_one_is_takes_no_time(options) -> None:
    found = plan([HERE, HERE, HERE], limits(options), **options)
    assert found.duration == options.get("duration", 0.0)
    assert verify(found).passed
    assert np.array_equal(found([-1.0, 0.0, 2.0]), [HERE.position] * 3)
    assert not found(0.0, 1).any()


def test_a_plan_of_no_time_is_one_in_all_uses() -> None:
    found = plan([HERE, HERE], LIMITS)
    assert FlatInverse(CRANE, found).force(0.0).tolist() == [0.0, 0.0, -CRANE.gravity]
    assert replan(found, 0.0, HERE).duration == 0.0
    assert same_path(plan([HERE, THERE], LIMITS), replan(found, 1.0, THERE))
    assert stop(found, 0.0).duration == 0.0
    assert reach_velocity(found, [0.0, 0.0, 0.0], 0.0).duration == 0.0
    assert found.state(0.0).position.tolist() == HERE.position.tolist()
    assert found.interval(0.0) == 1


def test_replans_to_equal_targets() -> None:
    old = plan([HERE, THERE], LIMITS)
    other = Waypoint([0.4, 0.1, -0.9])
    assert same_path(replan(old, 0.7, other), replan(old, 0.7, [other, other]))
    assert replan(old, old.duration, [THERE, THERE]).duration == 0.0


def test_repeats_within_the_bounds_of_drives() -> None:
    bounds = ActuatorBounds(force=[12.0, 8.0, 20.0], velocity=[0.5, 0.4, 0.3])
    free, end = Waypoint([0.5, 0.2, -1.0], "free", "free"), Waypoint([1.0, 0.2, -1.0])
    once = plan_actuated(CRANE, [HERE, free, end], None, bounds)
    found = plan_actuated(CRANE, [HERE, HERE, free, free, end], None, bounds)
    assert found.passed
    # one search like the other
    assert found.trajectory.duration == pytest.approx(once.trajectory.duration, rel=1e-9)
    assert found.trajectory.waypoint_times[2] == found.trajectory.waypoint_times[3]
    still = plan_actuated(CRANE, [HERE, HERE], None, bounds)
    assert (still.trajectory.duration, still.passed) == (0.0, True)


def test_sample_times_round_dwells() -> None:
    points = [
        Waypoint(HERE.position, dwell=0.25), THERE, Waypoint(THERE.position, dwell=0.31),
        Waypoint(HERE.position, dwell=1e-9),
    ]
    found = plan(points, LIMITS, sample_time=0.1)
    assert [p.dwell for p in found.waypoints] == pytest.approx([0.3, 0.0, 0.4, 0.1])
    samples = np.append(found.waypoint_times, found.duration) / 0.1
    assert samples == pytest.approx(np.round(samples), abs=1e-9)
    # whole samples stay as they are
    still = plan([Waypoint(HERE.position, dwell=0.3), THERE], LIMITS, sample_time=0.1)
    assert still.waypoints[0].dwell == pytest.approx(0.3, abs=1e-15)
