"""Plans within the bounds of the drives: kept exactly, and as short as they allow."""

from __future__ import annotations

import numpy as np
import pytest
from benchmarks.drive_oracle import demands, largest_use, shortest_transfer
from benchmarks.drive_problems import drive_problems

from segfmu import (
    ActuatorBounds,
    Clearance,
    Crane,
    InfeasibleError,
    InputError,
    Limits,
    Obstacle,
    Waypoint,
    excursions,
    plan,
    plan_actuated,
)
from segfmu.crane.bounds import NAMES
from segfmu.crane.demand import peaks
from segfmu.kernels.crane.records import Demand
from tests.campaign import campaign, soaked

CRANE = Crane(2.2, 1.155, 1.0)
SHIP_TO_SHORE = Crane(300e3, 15e3, 40e3)
LIMITS = Limits([1.0, 0.8, 0.5], [1.0, 0.8, 0.8], [4.0, 4.0, 4.0], [30.0, 30.0, 30.0])
MOVE = [Waypoint([0.0, 0.0, -1.0]), Waypoint([1.0, 0.8, -0.7])]


def test_limits_that_keep_the_bounds_are_taken_as_they_are() -> None:
    found = plan_actuated(CRANE, MOVE, LIMITS, ActuatorBounds(force=100.0, sway_angle=1.0))
    assert found.active == ()
    assert found.passed
    assert found.trajectory.limits is LIMITS
    assert found.trajectory.duration == plan(MOVE, LIMITS).duration


@pytest.mark.parametrize(
    ("bounds", "active"),
    [
        (ActuatorBounds(force=[1.5, 100.0, 100.0]), "bridge force"),
        (ActuatorBounds(force=[100.0, 0.8, 100.0]), "trolley force"),
        (ActuatorBounds(velocity=[0.5, np.inf, np.inf]), "bridge velocity"),
        (ActuatorBounds(velocity=[np.inf, np.inf, 0.1]), "hoist velocity"),
        (ActuatorBounds(acceleration=[np.inf, 0.3, np.inf]), "trolley acceleration"),
        (ActuatorBounds(power=[np.inf, np.inf, 1.0]), "hoist power"),
        (ActuatorBounds(sway_angle=[0.02, np.inf]), "sway angle x"),
    ],
)
def test_the_bound_is_kept_and_used(bounds, active) -> None:
    found = plan_actuated(CRANE, MOVE, LIMITS, bounds)
    assert active in [use.name for use in found.active]
    assert 0.999 < largest_use(CRANE, found.trajectory, bounds, 20001) <= 1.0 + 1e-9
    # and so are the limits of the load
    assert (found.trajectory.limits.table(3, 4) <= LIMITS.table(3, 4)).all()
    use = next(use for use in found.uses if use.name == active)
    at = abs(demands(CRANE, found.trajectory, np.array([use.time]))[0, NAMES.index(active)])
    assert at == pytest.approx(use.peak, rel=1e-9)


def test_bounds_alone_suffice_and_a_tighter_one_takes_longer() -> None:
    durations = [
        plan_actuated(
            CRANE, MOVE, None, ActuatorBounds(acceleration=1.0, sway_angle=angle)
        ).trajectory.duration
        for angle in (0.06, 0.03, 0.01)
    ]
    assert durations == sorted(durations)
    assert durations[2] > 1.3 * durations[0]


@pytest.mark.parametrize(("shape", "ratio"), [("smoothstep", 1.13), ("plateau", 1.15)])
def test_a_transfer_of_45_m_is_near_the_linear_programs(shape, ratio) -> None:
    points = [Waypoint([0.0, 0.0, -30.0]), Waypoint([0.0, 45.0, -30.0])]
    bounds = ActuatorBounds(velocity=[None, 4.0, None], acceleration=[None, 0.8, None])
    found = plan_actuated(SHIP_TO_SHORE, points, None, bounds, shape=shape)
    optimum = shortest_transfer(45.0, 30.0, 9.81, 4.0, 0.8, 200, 1e-3)
    assert optimum == pytest.approx(17.5, abs=0.1)
    assert optimum < found.trajectory.duration <= ratio * optimum
    assert largest_use(SHIP_TO_SHORE, found.trajectory, bounds, 20001) <= 1.0 + 1e-9


def test_the_load_sets_the_hoisting_speed_where_power_is_bounded() -> None:
    points = [Waypoint([0.0, 0.0, -30.0]), Waypoint([0.0, 0.0, -10.0])]
    bounds = ActuatorBounds(
        velocity=[None, None, 3.0], acceleration=[None, None, 0.8], power=[None, None, 450e3]
    )
    full, empty = (
        plan_actuated(Crane(300e3, 15e3, load), points, None, bounds) for load in (40e3, 10e3)
    )
    fastest = [found.trajectory.extrema(1)[1][2] for found in (full, empty)]
    assert 0.9 * 450e3 / (40e3 * 9.81) < fastest[0] < 450e3 / (40e3 * 9.81)
    assert fastest[1] > 2.0
    assert "hoist power" in [use.name for use in full.active]


def test_free_states_are_found_with_the_limits() -> None:
    bounds = ActuatorBounds(velocity=0.8, acceleration=0.6)
    ends = [Waypoint([0.0, 0.0, -1.0]), Waypoint([2.0, 1.0, -0.8])]
    middle = [1.0, 0.5, -0.9]
    resting, free = (
        plan_actuated(CRANE, [ends[0], point, ends[1]], None, bounds).trajectory
        for point in (Waypoint(middle), Waypoint(middle, "free", "free"))
    )
    assert free.duration < 0.8 * resting.duration
    assert largest_use(CRANE, free, bounds, 20001) <= 1.0 + 1e-9


def test_a_given_duration_is_kept() -> None:
    bounds = ActuatorBounds(velocity=0.8, acceleration=0.6)
    found = plan_actuated(CRANE, MOVE, None, bounds, duration=6.0)
    assert found.trajectory.duration == pytest.approx(6.0, rel=1e-12)
    assert found.passed
    with pytest.raises(InfeasibleError, match="duration"):
        plan_actuated(CRANE, MOVE, None, bounds, duration=1.0)


def test_a_sample_time_is_kept() -> None:
    bounds = ActuatorBounds(velocity=0.8, acceleration=0.6)
    found = plan_actuated(CRANE, MOVE, None, bounds, sample_time=0.05)
    samples = found.trajectory.duration / 0.05
    assert samples == pytest.approx(round(samples))
    assert found.passed


def test_peaks_are_exact() -> None:
    points = [MOVE[0], Waypoint([0.4, 0.5, -0.8], [0.3, 0.2, 0.1], [0.1, 0.0, 0.05]), MOVE[1]]
    trajectory = plan(points, LIMITS)
    found, times = peaks(CRANE, trajectory)
    sampled = demands(CRANE, trajectory, np.linspace(0.0, trajectory.duration, 200_001))
    # where a drive rests, rounding of what it does elsewhere
    rounding = 1e-12 * np.abs(sampled).max(axis=0)
    for side, sign in enumerate((1.0, -1.0)):
        # of places the least one counts as well where it is positive
        none = np.zeros(Demand.SIZE)
        none[Demand.PLACE : Demand.SWAY] = -np.inf
        dense = np.maximum((sign * sampled).max(axis=0), none)
        assert (found[side] >= dense - rounding).all()
        # samples miss a peak with a kink
        assert found[side] == pytest.approx(dense, rel=1e-4)
        at = [sign * demands(CRANE, trajectory, np.array([t]))[0, i]
              for i, t in enumerate(times[side])]
        assert found[side] == pytest.approx(np.maximum(at, none), rel=1e-9, abs=1e-12)
    # the hoist never pushes
    assert found[0, 2] == 0.0 < found[1, 2]


@campaign(2, 8)
def test_random_cranes_of_any_size_keep_their_bounds(count: int) -> None:
    for problem in drive_problems(count, seed=5):
        found = plan_actuated(problem.crane, problem.waypoints, problem.limits, problem.bounds)
        used = largest_use(problem.crane, found.trajectory, problem.bounds, 20001)
        assert used <= 1.0 + 1e-9
        assert found.passed


def test_the_static_force_cannot_be_slowed_down() -> None:
    with pytest.raises(
        InfeasibleError, match=r"waypoint 1: hoist force needs 9.81 N .*the bound is 9 N"
    ) as info:
        plan_actuated(CRANE, MOVE, LIMITS, ActuatorBounds(force=[100.0, 100.0, 9.0]))
    assert info.value.limit == "hoist force"


@pytest.mark.parametrize("crane", [CRANE, SHIP_TO_SHORE])
def test_a_hoist_that_just_holds_the_load_cannot_move_it(crane: Crane) -> None:
    weight = crane.payload_mass * crane.gravity
    bounds = ActuatorBounds(force=[10.0 * weight, 10.0 * weight, weight], velocity=1.0)
    with pytest.raises(InfeasibleError, match=r"hoist force needs more than .* the load's weight"):
        plan_actuated(crane, MOVE, None, bounds)
    # the mass changes no velocity
    with pytest.raises(InfeasibleError, match="or lower the waypoints' velocities"):
        points = [MOVE[0], Waypoint([0.5, 0.4, -0.8], [0.8, 0.5, 0.0]), MOVE[1]]
        plan_actuated(crane, points, None, ActuatorBounds(velocity=[0.3, 1.0, 1.0]))


def test_a_waypoint_beyond_a_bound_is_named() -> None:
    points = [MOVE[0], Waypoint([0.5, 0.4, -0.8], [0.8, 0.5, 0.0]), MOVE[1]]
    with pytest.raises(InfeasibleError, match=r"waypoint 2: bridge velocity needs 0.8 m/s"):
        plan_actuated(CRANE, points, LIMITS, ActuatorBounds(velocity=[0.3, 1.0, 1.0]))


def test_an_axis_without_any_bound_is_named() -> None:
    with pytest.raises(InputError, match=r"axis z: nothing bounds the acceleration.*hoist"):
        plan_actuated(CRANE, MOVE, None, ActuatorBounds(acceleration=[1.0, 1.0, None]))


def test_the_lower_bound_of_two_holds() -> None:
    drives = ActuatorBounds(velocity=[1.0, 2.0, None], power=5.0)
    both = drives.tightened(ActuatorBounds(velocity=[3.0, 1.5, 0.5]))
    assert both.velocity.tolist() == [1.0, 1.5, 0.5]
    assert both.power.tolist() == [5.0, 5.0, 5.0]
    assert not ActuatorBounds().known
    assert drives.known


@pytest.mark.parametrize("given", [[1.0, 2.0], 0.0, -1.0, "strong", [[1.0]]])
def test_wrong_bounds_are_refused(given) -> None:
    with pytest.raises(InputError, match="force"):
        ActuatorBounds(force=given)


def test_bounds_of_another_type_are_refused() -> None:
    with pytest.raises(InputError, match="bounds must be an ActuatorBounds, got NoneType"):
        plan_actuated(CRANE, MOVE, LIMITS, None)


def test_free_states_do_not_run_up_backwards() -> None:
    crane = Crane(300e3, 15e3, 40e3)
    points = [
        Waypoint([0.0, 0.0, -30.0]), Waypoint([0.0, 8.0, -20.0], "free", "free"),
        Waypoint([0.0, 45.0, -30.0]),
    ]
    bounds = ActuatorBounds(velocity=[1.0, 4.0, 1.5], acceleration=[0.5, 0.8, 0.75])
    found = plan_actuated(crane, points, None, bounds)
    assert excursions(found.trajectory) == ()
    assert found.trajectory(found.trajectory.waypoint_times[1], 1)[1] > 0.0


@pytest.mark.parametrize("places", [
    [[0.4, 0.0, -1.0], [0.5, 0.0, -1.0]],
    *soaked(
        [[0.4, 0.1, -1.0], [0.5, 0.4, -1.0]],
        [[0.1, 0.05, -1.0], [0.4, 0.1, -1.0], [0.5, 0.4, -1.0]],
    ),
])
def test_free_states_are_never_slower_than_rest(places: list[list[float]]) -> None:
    crane, bounds = Crane(1.2, 0.8, 0.5), ActuatorBounds(force=[8.0, 6.0, 8.0], velocity=0.3)
    *inner, end = places
    shares: list[float] = []
    resting, free = (
        plan_actuated(
            crane,
            [Waypoint([0.0, 0.0, -1.0]), *(Waypoint(p, *words) for p in inner), Waypoint(end)],
            None, bounds, progress=shares.append,
        ).trajectory.duration
        for words in ((), ("free", "free"))
    )
    assert free <= resting * (1.0 + 1e-6)
    assert min(shares) > 0.0 and max(shares) <= 1.0


@pytest.mark.parametrize("way", ["clearance", "range"])
def test_a_wall_is_kept_whatever_the_limits(way: str) -> None:
    crane = Crane(5e3, 1e3, 5e3)
    bounds = ActuatorBounds(force=[8e4, 5e4, 6e5], velocity=[12.0, 8.0, 3.0])
    points = [
        Waypoint([0, 0, -8]), Waypoint([6, 2, -8], "free", "free"), Waypoint([5, 6, -8]),
    ]
    wall = {
        "clearance": {"clearance": Clearance([Obstacle("wall", [6.01, -5, -20], [9, 20, 0])])},
        "range": {"position_max": [6.01, 20.0, 0.0]},
    }[way]
    limits = Limits(1.0, 0.4, 0.4, 0.4)
    limited, resting = (
        plan_actuated(crane, [points[0], point, points[2]], limits, bounds, **wall)
        for point in (points[1], Waypoint([6, 2, -8]))
    )
    assert limited.passed and limited.trajectory.extrema(0)[1][0] <= 6.01 + 1e-9
    assert limited.trajectory.duration < resting.trajectory.duration


def test_a_plan_at_its_largest_limits_may_become_slower() -> None:
    # free states at the limit of velocity were possible at no other pace
    free = [Waypoint([0.0, 0.25, -0.6], "free", "free"), Waypoint([0.0, 1.2, -0.6], "free", "free")]
    inner = [free, [Waypoint(p.position) for p in free]]
    bounds = ActuatorBounds(
        velocity=[0.7, 0.7, 0.3], acceleration=[0.9, 0.9, 0.6], force=[None, 3.0, 18.0],
        power=[None, None, 5.0],
    )
    moving, resting = (
        plan_actuated(
            CRANE, [Waypoint([0.0, 0.0, -1.0]), *points, Waypoint([0.0, 1.5, -1.0])],
            Limits(0.65, 0.7, 5.0, 60.0), bounds, shape="smoothstep",
        )
        for points in inner
    )
    assert moving.passed
    assert moving.trajectory.duration < 0.9 * resting.trajectory.duration
