"""Plans within drives that can do more in one direction: kept, used, mirrored."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np
import pytest
from benchmarks.drive_oracle import demands, largest_use, shares, shortest_transfer
from benchmarks.drive_problems import DriveProblem, drive_problems

from segfmu import (
    ActuatorBounds,
    Crane,
    InfeasibleError,
    InputError,
    Limits,
    Trajectory,
    Waypoint,
    plan_actuated,
)
from segfmu.crane import Friction, bound_uses
from tests.campaign import campaign

LAB, STS = Crane(2.2, 1.155, 1.0), Crane(300e3, 15e3, 40e3)
# crane, distance and rope [m], velocity [m/s], acceleration [m/s2]
SIZES = pytest.mark.parametrize(
    ("crane", "way", "rope", "fast", "rise"),
    [(LAB, 1.0, 0.5, 1.0, 0.6), (STS, 40.0, 20.0, 4.0, 0.6)], ids=["lab", "sts"],
)
MIRROR = np.array([-1.0, -1.0, 1.0])


def only(axis: int, value: float) -> list[float | None]:
    """A bound of one drive."""
    return [value if i == axis else None for i in range(3)]


def moved(axis: int, way: float, rope: float) -> list[Waypoint]:
    """From rest to rest along one axis."""
    start, end = np.array([0.0, 0.0, -rope]), np.array([0.0, 0.0, -rope])
    end[axis] += way
    return [Waypoint(start), Waypoint(end)]


def mirrored(problem: DriveProblem) -> DriveProblem:
    """The problem seen from the other side: x and y change their sign."""
    bounds, limits = problem.bounds, problem.limits
    turned = {
        name: np.where(MIRROR < 0.0, bounds.lower(name), getattr(bounds, name))
        for name in ("force", "velocity", "acceleration")
    }
    least = {
        f"{name}_min": -np.where(MIRROR < 0.0, getattr(bounds, name), bounds.lower(name))
        for name in turned
    }
    if limits is not None:
        upper, lower = limits.table(3, 4), limits.lower(3)
        ahead = np.where(MIRROR[:, None] < 0.0, lower, upper[:, :2])
        back = np.where(MIRROR[:, None] < 0.0, upper[:, :2], lower)
        limits = Limits(
            *ahead.T, *upper[:, 2:4].T, velocity_min=-back[:, 0], acceleration_min=-back[:, 1]
        )
    return replace(
        problem, limits=limits, waypoints=tuple(
            Waypoint(p.position * MIRROR, *(
                [None if np.isnan(v) else v for v in values * MIRROR]
                for values in (p.velocity, p.acceleration)
            ), dwell=p.dwell)
            for p in problem.waypoints
        ),
        bounds=ActuatorBounds(**turned, **least, power=bounds.power, sway_angle=bounds.sway_angle),
    )


def given_states(count: int, seed: int) -> Iterator[DriveProblem]:
    """Those of so many random problems whose states are given: their searches are short."""
    for problem in drive_problems(count, seed, directed=True):
        if not any(np.isnan(p.velocity).any() for p in problem.waypoints):
            yield problem


def solved(problem: DriveProblem, **options) -> Trajectory | None:
    try:
        return plan_actuated(
            problem.crane, problem.waypoints, problem.limits, problem.bounds, **options
        ).trajectory
    except InfeasibleError:
        return None


@SIZES
def test_a_trolley_that_brakes_harder_arrives_sooner(crane, way, rope, fast, rise) -> None:
    points = moved(1, way, rope)
    weak = ActuatorBounds(velocity=only(1, fast), acceleration=only(1, rise))
    strong = ActuatorBounds(
        velocity=only(1, fast), acceleration=only(1, rise), acceleration_min=only(1, -2.0 * rise)
    )
    slow = plan_actuated(crane, points, None, weak).trajectory
    quick = plan_actuated(crane, points, None, strong)
    assert quick.passed
    assert quick.trajectory.duration < 0.98 * slow.duration
    assert largest_use(crane, quick.trajectory, strong, 20001) <= 1.0 + 1e-9
    # it brakes harder than it drives, by the linear program as well
    found = demands(crane, quick.trajectory, np.linspace(0.0, quick.trajectory.duration, 2001))
    assert found[:, 7].min() < -1.2 * rise
    optimum = shortest_transfer(way, rope, 9.81, fast, rise, 160, 1e-3, braking=2.0 * rise)
    assert 1.0 <= quick.trajectory.duration / optimum < 1.3
    # the way back, seen from the other side
    back = ActuatorBounds(
        velocity=only(1, fast), acceleration=only(1, 2.0 * rise), acceleration_min=only(1, -rise)
    )
    other = plan_actuated(crane, moved(1, -way, rope), None, back).trajectory
    assert other.duration == pytest.approx(quick.trajectory.duration, rel=1e-9)
    times = np.linspace(0.0, other.duration, 500)
    for order in range(5):
        expected = quick.trajectory(times, order)
        size = np.abs(expected).max()
        assert other(times, order) == pytest.approx(expected * MIRROR, abs=1e-9 * size)


@SIZES
def test_a_trolley_that_goes_both_ways_is_faster_one_way(crane, way, rope, fast, rise) -> None:
    start, end = moved(1, way, rope)
    bounds = ActuatorBounds(
        velocity=only(1, fast), velocity_min=only(1, -0.2 * fast), acceleration=only(1, rise)
    )
    slow = ActuatorBounds(velocity=only(1, 0.2 * fast), acceleration=only(1, rise))
    found, same = (plan_actuated(crane, [start, end, start], None, b) for b in (bounds, slow))
    assert found.passed
    assert largest_use(crane, found.trajectory, bounds, 20001) <= 1.0 + 1e-9
    ahead, back = np.diff(found.trajectory.waypoint_times)
    assert ahead < 0.8 * back
    assert found.trajectory.duration < 0.9 * same.trajectory.duration


@SIZES
def test_a_hoist_lowers_faster_than_it_lifts(crane, way, rope, fast, rise) -> None:
    bounds = ActuatorBounds(
        velocity=only(2, 0.5 * fast), velocity_min=only(2, -0.2 * fast), acceleration=only(2, rise)
    )
    slow = ActuatorBounds(velocity=only(2, 0.2 * fast), acceleration=only(2, rise))
    down, up = (plan_actuated(crane, moved(2, s * 0.4 * way, 0.5 * way + rope), None, bounds)
                for s in (-1.0, 1.0))
    same = plan_actuated(crane, moved(2, 0.4 * way, 0.5 * way + rope), None, slow)
    assert down.passed and up.passed
    assert down.trajectory.duration < 0.8 * up.trajectory.duration
    assert up.trajectory.duration == pytest.approx(same.trajectory.duration, rel=1e-9)
    assert "hoist velocity_min" in [use.name for use in up.active]
    peaks = {use.name: use.peak for use in down.uses}
    assert peaks["hoist velocity"] > 0.4 * fast and peaks["hoist velocity_min"] < 1e-9
    for found in (down, up):
        assert largest_use(crane, found.trajectory, bounds, 20001) <= 1.0 + 1e-9


@SIZES
def test_a_bridge_that_pushes_harder_than_it_pulls(crane, way, rope, fast, rise) -> None:
    mass = crane.bridge_mass + crane.trolley_mass + crane.payload_mass
    bounds = ActuatorBounds(
        force=only(0, 2.0 * rise * mass), force_min=only(0, -rise * mass), velocity=only(0, fast)
    )
    weak = ActuatorBounds(force=only(0, rise * mass), velocity=only(0, fast))
    points = moved(0, way, rope)
    found, slow = (plan_actuated(crane, points, None, b) for b in (bounds, weak))
    assert found.passed
    assert found.trajectory.duration < 0.98 * slow.trajectory.duration
    used = shares(crane, found.trajectory, bounds, 20001)
    assert used.max() <= 1.0 + 1e-9
    # more than the weaker direction has
    assert used[0, 0] > 0.55


@campaign(4, 12)
def test_random_problems_keep_their_bounds_and_have_mirrored_plans(count: int) -> None:
    planned = 0
    for problem in given_states(count, 31):
        one, other = solved(problem), solved(mirrored(problem))
        assert (one is None) == (other is None)
        if one is None or other is None:
            continue
        planned += 1
        assert largest_use(problem.crane, one, problem.bounds, 20001) <= 1.0 + 1e-9
        assert other.duration == pytest.approx(one.duration, rel=1e-9)
        times = np.linspace(0.0, one.duration, 200)
        size = np.abs(one(times)).max()
        assert other(times) == pytest.approx(one(times) * MIRROR, abs=1e-9 * size)
    assert planned > 0


@campaign(2, 12)
def test_more_in_one_direction_never_takes_longer(count: int) -> None:
    for problem in given_states(count, 8):
        both = np.minimum(*problem.bounds.table)
        weak = ActuatorBounds(both[:3], both[3:6], both[6:9], both[15:], both[9:12])
        slow, quick = solved(replace(problem, bounds=weak)), solved(problem)
        assert slow is None or (quick is not None and quick.duration <= slow.duration)


def test_the_same_numbers_in_both_directions_are_no_difference() -> None:
    points = [Waypoint([0.0, 0.0, -1.0]), Waypoint([0.5, 0.3, -0.8]), Waypoint([1.0, 0.8, -0.7])]
    own = {"force": [12.0, 8.0, 20.0], "velocity": [0.5, 0.4, 0.3], "acceleration": 0.8}
    told = {f"{name}_min": -np.broadcast_to(values, 3) for name, values in own.items()}
    alone, both = (
        plan_actuated(LAB, points, None, ActuatorBounds(**bounds)) for bounds in (own, own | told)
    )
    assert np.array_equal(alone.trajectory.coefficients, both.trajectory.coefficients)
    assert [use.name for use in alone.uses] == [use.name for use in both.uses]


def test_limits_of_the_load_are_kept_by_direction() -> None:
    points = [Waypoint([0.0, 0.0, -1.0]), Waypoint([1.5, 0.0, -1.0]), Waypoint([0.0, 0.0, -1.0])]
    limits = Limits(0.8, 1.0, 8.0, 100.0, velocity_min=[-0.3, -0.8, -0.8])
    found = plan_actuated(LAB, points, limits, ActuatorBounds(acceleration=[0.5, 0.5, 0.5]))
    low, high = found.trajectory.extrema(1)
    assert low[0] == pytest.approx(-0.3, rel=1e-6) and 0.5 < high[0] <= 0.8 * (1.0 + 1e-9)
    assert found.trajectory.limits.velocity_min[0] >= -0.3
    arrival = found.trajectory.waypoint_times[1]
    assert found.trajectory.duration - arrival > 1.3 * arrival


def test_a_direction_that_an_axis_does_not_take_needs_no_force() -> None:
    """A drive that cannot push back against its dry friction still takes a load one way."""
    friction = Friction(coulomb=(0.0, 1.0, 0.0))
    bounds = ActuatorBounds(
        force=[None, 6.0, None], force_min=[None, -0.9, None], velocity=only(1, 0.4)
    )
    found = plan_actuated(LAB, moved(1, 1.0, 0.5), None, bounds, friction=friction)
    assert found.passed
    assert largest_use(LAB, found.trajectory, bounds, 20001, friction) <= 1.0 + 1e-6
    with pytest.raises(InfeasibleError, match=r"trolley force_min needs more than 1 N") as refused:
        plan_actuated(LAB, moved(1, -1.0, 0.5), None, bounds, friction=friction)
    assert (refused.value.limit, refused.value.bound) == ("trolley force_min", 0.9)


def test_refusals_name_the_direction() -> None:
    bounds = ActuatorBounds(
        velocity=[1.0, 1.0, 0.5], velocity_min=[-0.2, -1.0, -0.5], acceleration=1.0
    )
    points = [Waypoint([0.0, 0.0, -1.0]), Waypoint([-0.5, 0.0, -1.0], [-0.4, 0.0, 0.0]),
              Waypoint([-1.0, 0.0, -1.0])]
    with pytest.raises(
        InfeasibleError, match=r"waypoint 2: bridge velocity_min needs 0.4 m/s .* bound is 0.2 m/s"
    ) as refused:
        plan_actuated(LAB, points, None, bounds)
    assert refused.value.limit == "bridge velocity_min"
    with pytest.raises(InfeasibleError, match=r"hoist force_min needs") as refused:
        plan_actuated(
            LAB, moved(0, 1.0, 1.0), None, ActuatorBounds(
                force=[20.0, 20.0, 30.0], force_min=[-20.0, -20.0, -9.0]
            ),
        )
    with pytest.raises(InputError, match=r"trolley velocity_min must have a bound of at least"):
        plan_actuated(LAB, moved(1, 1.0, 1.0), None, ActuatorBounds(
            velocity=1.0, velocity_min=[-1.0, -1e-7, -1.0], acceleration=1.0
        ))


def test_uses_show_both_directions_where_their_bounds_differ() -> None:
    found = plan_actuated(
        LAB, moved(1, 1.0, 0.5), Limits(1.0, 1.0, 5.0, 60.0), ActuatorBounds()
    ).trajectory
    bounds = ActuatorBounds(acceleration=[None, 3.0, None], acceleration_min=[None, -2.0, None])
    told = {use.name: use for use in bound_uses(LAB, found, bounds)}
    assert len(told) == 21
    ahead, back = told["trolley acceleration"], told["trolley acceleration_min"]
    assert (ahead.bound, back.bound, back.unit) == (3.0, 2.0, "m/s2")
    assert 0.0 < ahead.time < back.time + found.duration
    assert ahead.peak == pytest.approx(back.peak, rel=1e-6)
    assert back.use == pytest.approx(1.5 * ahead.use, rel=1e-6)


@pytest.mark.parametrize("name", ["force_min", "velocity_min", "acceleration_min"])
@pytest.mark.parametrize(
    ("value", "message"),
    [
        (0.5, "must be less than 0, got 0.5; leave it out"), (0.0, "must be less than 0, got 0.0"),
        ([-1.0, 0.0, -1.0], r"must be less than 0, got \[-1.0, 0.0, -1.0\]"),
        (float("nan"), "must be less than 0"), ([-1.0, -2.0], "has 2 values; give one, or 3"),
        ([[-1.0]], "must be a number or one per axis"), ("slow", "must be a number"),
    ],
)
def test_bounds_in_the_negative_direction_are_below_zero(name: str, value, message) -> None:
    with pytest.raises(InputError, match=f"{name} {message}"):
        ActuatorBounds(**{name: value})


def test_bounds_that_tighten_each_other_do_so_in_each_direction() -> None:
    drives = ActuatorBounds(velocity=[1.0, 2.0, None], velocity_min=[-0.5, None, -3.0])
    both = drives.tightened(ActuatorBounds(velocity=[0.8, 3.0, None], velocity_min=only(2, -4.0)))
    assert both.velocity.tolist() == [0.8, 2.0, np.inf]
    assert both.lower("velocity").tolist() == [0.5, 2.0, 3.0]
    # a drive without a bound in one direction
    one = ActuatorBounds(velocity_min=-1.0).tightened(ActuatorBounds(velocity=2.0))
    assert (one.velocity[0], one.lower("velocity")[0]) == (2.0, 1.0)
    free = ActuatorBounds(velocity=only(0, 1.0), velocity_min=only(0, -1e300))
    assert free.tightened(ActuatorBounds()).lower("velocity")[0] == 1e300
    assert ActuatorBounds(force_min=-1.0).known
