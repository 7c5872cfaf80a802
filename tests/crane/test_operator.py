"""Operated motions: safe, smooth, and where the operator wants them."""

from __future__ import annotations

import pickle
from copy import copy, deepcopy
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from benchmarks.operated import LAB, PORT, SITES, Site, commands, met, needs

from segfmu import (
    ActuatorBounds,
    Clearance,
    Crane,
    InfeasibleError,
    InputError,
    Limits,
    Obstacle,
    Operator,
    Trajectory,
    Waypoint,
    load_mission,
    plan,
    plan_actuated,
)
from segfmu.crane import Friction
from segfmu.kernels import backend
from tests.campaign import campaign, soaked

MODELS = Path(__file__).parents[2] / "models"
FREE = Limits(velocity=[0.4, 0.4, 0.3], acceleration=0.5, jerk=1.5, snap=10.0)
BEYOND = r": a place 1e\+09 m from the origin is beyond 1e\+06 m"
LEVEL = Limits(velocity=0.4, acceleration=0.5, jerk=1.5, snap=10.0)


def values_of(operator: Operator, time: float, orders: int) -> np.ndarray:
    """Derivatives of the load at a time [s] by the present plan, (orders, 3)."""
    pieces = operator.plan
    ends = pieces.stops()
    found = np.empty((orders, 3))
    backend.evaluate_orders(
        time - operator.plan_begins, pieces.timing, pieces.coefficients, pieces.offsets, ends, found
    )
    return found


def scales(limits: Limits, smoothness: int) -> np.ndarray:
    table = limits.table(3, smoothness).T
    return np.vstack([table[0] ** 2 / table[1], table])


@campaign(3, 300, "seeds")
@pytest.mark.parametrize("name", SITES)
def test_random_commands_keep_everything(name: str, seeds: int) -> None:
    site = SITES[name]
    steps, fine = 300, 16
    plans = 0
    for seed in range(seeds):
        operator = site.operator()
        rng = np.random.default_rng(2 + seed)
        path = []
        for command in commands(site, rng, steps):
            before = values_of(operator, operator.time, 5)
            operator.command(**command)
            now = operator.time
            operator.step(site.step)
            # smooth: the snap too, as it is the fourth of smoothness 4
            jump = np.abs(values_of(operator, now, 5) - before)
            assert (jump <= 1e-9 * scales(site.limits, 4)[:5]).all()
            path += [values_of(operator, now + site.step * i / fine, 5) for i in range(fine)]
        plans += operator.plans
        motion = np.array(path)
        require(site, motion, site.step / fine)
    # the operator is not idle
    assert plans > 15 * seeds


def require(site: Site, motion: np.ndarray, step: float) -> None:
    """Check a motion (samples, 5, 3) at equal steps [s]."""
    table = site.limits.table(3, 4)
    assert (np.abs(motion[:, 1:]).max(axis=0) <= table[:, :4].T * (1.0 + 1e-9)).all()
    places = motion[:, 0]
    # limits, workspace and drives
    touch = 1e-9 * np.abs(places).max()
    assert (places >= site.clearance.minimum - touch).all()
    assert (places <= site.clearance.maximum + touch).all()
    found = needs(site.crane, places, step)
    for quantity in ("force", "velocity", "acceleration", "sway_angle"):
        bound = getattr(site.bounds, quantity)
        # finite differences know no more of the motion
        assert (np.abs(found[quantity]).max(axis=0) <= 1.002 * bound).all(), quantity
    assert (found["rope"] >= site.crane.rope_min - 1e-6).all()
    assert (found["rope"] <= site.crane.rope_max + 1e-6).all()
    assert met(site, places[2:-2], found["carriage"]).max() <= 1e-5 * np.abs(places).max()


@pytest.mark.parametrize("name", SITES)
def test_a_load_released_does_not_sway(name: str) -> None:
    site = SITES[name]
    operator = site.operator()
    state = operator.setpoints[3:13].copy()
    parts, swayed = 4, 0.0
    operator.command("velocity", velocity=0.8 * np.asarray(site.limits.velocity) * [1, 1, -0.3])

    def follow(duration: float) -> None:
        nonlocal state, swayed
        for _ in range(round(duration / site.step)):
            now = operator.time
            operator.step(site.step)
            # the forces have kinks where pieces begin
            joints = operator.plan_begins + operator.plan.timing[:, 0]
            inner = joints[(joints > now) & (joints < operator.time)]
            times = np.unique([now, *inner, operator.time])
            for begin, end in pairwise(times):
                h = (end - begin) / parts
                for i in range(parts):
                    # classical Runge-Kutta, with the forces of the present plan
                    forces = [force_at(operator, begin + h * (i + s)) for s in (0.0, 0.5, 1.0)]
                    k1 = site.crane.rhs(state, forces[0])
                    k2 = site.crane.rhs(state + 0.5 * h * k1, forces[1])
                    k3 = site.crane.rhs(state + 0.5 * h * k2, forces[1])
                    k4 = site.crane.rhs(state + h * k3, forces[2])
                    state = state + h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4)
            swayed = max(swayed, float(np.abs(state[3:5]).max()))

    follow(60 * site.step)
    assert swayed > 5e-3
    operator.command("stop")
    follow(1.0 + operator.rests_at - operator.time)
    follow(site.step + max(operator.rests_at - operator.time, 0.0))
    assert operator.time > operator.rests_at
    assert np.abs(state[3:5]).max() < 1e-6
    assert np.abs(state[8:10]).max() < 1e-6


def force_at(operator: Operator, time: float) -> np.ndarray:
    found = np.zeros(18)
    backend.crane_flat_inverse(
        values_of(operator, time, 5), np.array(operator.crane.masses), found[:3], found[3:13],
        found[13:],
    )
    return found[:3]


def free(**options: object) -> Operator:
    return Operator(LAB.crane, FREE, [0.0, 0.0, -0.5], **options)


def follow(operator: Operator, duration: float, step: float = 0.01) -> np.ndarray:
    return np.array([operator.step(step) for _ in range(round(duration / step))])


def test_a_velocity_is_reached_held_and_left() -> None:
    operator = free()
    operator.command("velocity", velocity=[0.3, -0.2, 0.0])
    motion = follow(operator, 3.0)
    assert operator.status == "taken"
    np.testing.assert_allclose(motion[-1, 1], [0.3, -0.2, 0.0], atol=1e-12)
    np.testing.assert_allclose(motion[-1, 2:], 0.0, atol=1e-9)
    operator.command("stop")
    follow(operator, 3.0)
    np.testing.assert_allclose(operator.load[1:], 0.0, atol=1e-12)


def test_a_velocity_that_nothing_renews_ends() -> None:
    operator = free(hold=0.25)
    operator.command("velocity", velocity=[0.3, 0.0, 0.0])
    follow(operator, 2.0)
    stops = free(hold=0.25)
    stops.command("velocity", velocity=[0.3, 0.0, 0.0])
    follow(stops, 2.0)
    stops.command("stop")
    follow(stops, 0.01)
    braking = stops.rests_at - 2.0
    assert 0.0 < operator.rests_at - 2.0 - braking <= 0.26


def test_velocities_beyond_the_limits_are_the_limits() -> None:
    operator = free()
    operator.command("velocity", velocity=[9.0, -9.0, 0.0], scale=0.5)
    follow(operator, 3.0)
    np.testing.assert_allclose(operator.load[1], [0.2, -0.2, 0.0], atol=1e-12)
    operator.command("velocity", scale=1.0)
    follow(operator, 2.0)
    np.testing.assert_allclose(operator.load[1], [0.4, -0.4, 0.0], atol=1e-12)


def test_the_load_stops_at_the_end_of_the_workspace() -> None:
    operator = LAB.operator()
    operator.command("velocity", velocity=[0.0, 0.4, 0.0])
    motion = follow(operator, 8.0)
    assert operator.load[0, 1] == pytest.approx(1.0, abs=1e-8)
    assert motion[:, 0, 1].max() <= 1.0 + 1e-9
    # at full speed until it has to brake
    assert motion[:, 1, 1].max() == pytest.approx(0.4)
    operator.command("velocity", velocity=[0.0, -0.4, 0.0])
    follow(operator, 3.0)
    assert operator.load[1, 1] == pytest.approx(-0.4)


def test_a_command_near_the_end_uses_what_is_left_of_the_way() -> None:
    operator = Operator(
        LAB.crane, FREE, [0.0, 0.0, -0.5],
        clearance=Clearance(minimum=[-1.0, -1.0, -0.9], maximum=[0.05, 1.0, -0.1]),
    )
    operator.command("velocity", velocity=[0.4, 0.2, 0.0])
    follow(operator, 3.0)
    assert operator.load[0, 0] == pytest.approx(0.05, abs=1e-6)
    # the other axis goes on
    assert operator.load[1, 1] == pytest.approx(0.2)


def test_a_target_at_the_trolley_is_refused_without_rope_min_too() -> None:
    free = load_mission({
        "crane": {"bridge_mass": 2.2, "trolley_mass": 1.155, "payload_mass": 1.0},
        "limits": Limits(1.0, 1.0, 2.0, 20.0), "waypoints": [{"position": [0.0, 0.0, -0.5]}] * 2,
    }).operator()
    free.command("target", target=[0.0, 0.0, -6e-17])
    follow(free, 10.0)
    assert free.refused and free.load[0, 2] <= -1e-6


def test_an_obstacle_blocks_until_the_load_is_above_it() -> None:
    operator = LAB.operator()
    operator.command("target", target=[0.0, 0.0, -0.6])
    follow(operator, 2.0)
    operator.command("velocity", velocity=[0.4, 0.0, 0.0])
    follow(operator, 4.0)
    assert operator.refused == "obstacle"
    # its margin is 20 mm
    assert operator.load[0, 0] == pytest.approx(0.18, abs=1e-8)
    np.testing.assert_allclose(operator.load[1:], 0.0, atol=1e-9)
    # up while it is pushed against the box, then over it
    operator.command("velocity", velocity=[0.4, 0.0, 0.2])
    follow(operator, 6.0)
    assert operator.load[0, 0] == pytest.approx(1.0, abs=1e-6)


def test_drives_that_do_not_follow_stop_at_the_obstacle_too() -> None:
    # a long rope: with the limits of the load the trolley accelerates by more than its bound
    operator = PORT.operator()
    operator.command("target", target=[0.0, 0.0, -30.0])
    follow(operator, 40.0, PORT.step)
    operator.command("velocity", velocity=[0.0, 3.0, 0.0])
    follow(operator, 40.0, PORT.step)
    # half of the load is 1.2 m wide, the margin 0.5 m
    assert operator.load[0, 1] == pytest.approx(20.0 - 1.2 - 0.5, abs=1e-6)
    np.testing.assert_allclose(operator.load[1:], 0.0, atol=1e-9)


def test_what_only_slow_plans_keep_ends_at_the_obstacle_too() -> None:
    # the bridge is too weak for its limit, and only slower plans come as far as the obstacle
    operator = Operator(
        PORT.crane, PORT.limits, [0.0, 46.0, -17.0], bounds=PORT.bounds, clearance=PORT.clearance
    )
    operator.command("velocity", velocity=[-0.05, -1.5, 0.0])
    follow(operator, 40.0, PORT.step)
    assert operator.load[0, 1] == pytest.approx(30.0 + 1.2 + 0.5, abs=1e-6)


@pytest.mark.parametrize("gap", [0.0, 1e-10, 1e-6, 1e-4, 1e-2])
def test_other_axes_go_on_beside_an_obstacle_that_the_rope_leans_over(gap: float) -> None:
    box = Obstacle("box", [0.3, -0.5, -0.9], [0.6, 0.5, -0.6])
    operator = Operator(
        LAB.crane, LAB.limits, [0.3 - gap, 0.0, -0.8], bounds=LAB.bounds,
        clearance=Clearance([box], minimum=[-1.0, -1.0, -0.9], maximum=[1.0, 1.0, -0.2]),
    )
    operator.command("velocity", velocity=[0.3, 0.2, 0.0])
    follow(operator, 2.0)
    assert operator.load[0, 1] > 0.2


def test_a_load_beside_an_obstacle_rises_at_full_speed_and_goes_on_above() -> None:
    operator = LAB.operator()
    operator.command("target", target=[0.18, 0.0, -0.8])
    follow(operator, 4.0)
    operator.command("velocity", velocity=[0.4, 0.0, 0.3])
    motion = follow(operator, 4.0)
    place, velocity = motion[:, 0], motion[:, 1]
    below = place[:, 2] < -0.48
    assert (place[below, 0] < 0.18 + 1e-8).all()
    assert velocity[below, 2].max() == pytest.approx(0.3)
    # nothing is in the way any more, and within two tenths of a second it is tried again
    above = int(np.argmax(~below))
    assert velocity[above + 20, 0] > 0.0


def test_the_obstacle_behind_the_first_one_is_the_next_end() -> None:
    boxes = [
        Obstacle("near", [0.2, -0.2, -0.9], [0.3, 0.2, -0.6], 0.0),
        Obstacle("far", [0.6, -0.2, -0.9], [0.7, 0.2, -0.3], 0.0),
    ]
    operator = free(clearance=Clearance(boxes, minimum=[-1.0, -1.0, -0.9]))
    operator.command("target", target=[0.0, 0.0, -0.7])
    follow(operator, 3.0)
    operator.command("velocity", velocity=[0.3, 0.0, 0.05])
    follow(operator, 8.0)
    assert operator.load[0, 0] == pytest.approx(0.6, abs=1e-8)
    assert operator.load[0, 2] < -0.3


def test_a_load_that_brakes_goes_on_when_a_far_obstacle_is_the_next_end() -> None:
    boxes = [
        Obstacle("near", [0.2, -0.2, -0.9], [0.3, 0.2, -0.6], 0.0),
        Obstacle("far", [0.8, -0.2, -0.9], [0.9, 0.2, -0.3], 0.0),
    ]
    operator = free(clearance=Clearance(boxes, minimum=[-1.0, -1.0, -0.9]))
    operator.command("target", target=[-0.1, 0.0, -0.75])
    follow(operator, 4.0)
    operator.command("velocity", velocity=[0.3, 0.0, 0.12])
    follow(operator, 4.0, 0.02)
    # one that went on to its stop before the near one would be 6 mm behind
    assert operator.load[0, 0] > 0.795


@pytest.mark.parametrize(
    ("start", "sense"), [([-0.5, -0.6, -0.7], 1.0), ([1.0, 0.6, -0.7], -1.0)]
)
def test_the_axis_that_is_the_last_to_enter_an_obstacle_waits(
    start: list[float], sense: float
) -> None:
    # it is beside the box along both axes; when it comes to it along x, it is there along y
    operator = Operator(LAB.crane, FREE, start, clearance=Clearance(LAB.clearance.obstacles))
    operator.command("velocity", velocity=[sense * 0.4, sense * 0.25, 0.0])
    place = follow(operator, 8.0)[:, 0]
    beside = np.abs(place[:, 1]) < 0.32
    face = 0.18 if sense > 0.0 else 0.52
    left = sense * face - (sense * place[beside, 0]).max()
    assert -1e-8 <= left < 0.03
    # it goes on behind
    assert sense * operator.load[0, 0] > sense * face + 0.1


@pytest.mark.parametrize("name", ["lab", *soaked("port")])
def test_what_is_built_up_slowly_does_not_turn_back(name: str) -> None:
    site = SITES[name]
    low, high = (np.asarray(end) for end in (site.clearance.minimum, site.clearance.maximum))
    rng = np.random.default_rng(5)
    most = np.asarray(site.limits.velocity)
    moved = 0
    while moved < 40:
        start = rng.uniform(low, high)
        start[2] = max(start[2], -site.crane.rope_max)
        velocity = rng.uniform(-1.0, 1.0, 3) * most
        try:
            operator = Operator(
                site.crane, site.limits, start, bounds=site.bounds, clearance=site.clearance
            )
        except InfeasibleError:
            continue
        operator.command("velocity", velocity=velocity)
        motion = follow(operator, 400 * site.step, site.step)
        moved += 1
        assert (motion[:, 1] * np.sign(velocity) / most).min() > -0.01


def test_a_target_is_reached_and_left_for_another() -> None:
    operator = free()
    operator.command("target", target=[0.5, -0.3, -0.4])
    follow(operator, 1.0)
    assert np.abs(operator.load[1]).max() > 0.1
    operator.command("target", target=[0.1, 0.3, -0.45])
    follow(operator, 5.0)
    np.testing.assert_allclose(operator.load[0], [0.1, 0.3, -0.45], atol=1e-9)
    np.testing.assert_allclose(operator.load[1:], 0.0, atol=1e-9)


def test_a_scaled_target_is_slower() -> None:
    operator = free()
    operator.command("target", target=[1.0, -0.5, -0.5], scale=0.25)
    motion = follow(operator, 12.0)
    assert np.abs(motion[:, 1]).max() <= 0.1 + 1e-12
    assert operator.load[0, 0] == pytest.approx(1.0)


@pytest.mark.parametrize("sense", [-1.0, 1.0])
def test_the_scale_acts_while_the_load_goes_to_a_target(sense: float) -> None:
    operator = free()
    operator.command("target", target=[2.0 * sense, 0.0, -0.5])
    follow(operator, 2.0)
    assert sense * operator.load[1, 0] > 0.35
    operator.command("target", scale=0.1)
    velocity = sense * follow(operator, 4.0)[:, 1, 0]
    assert velocity[-1] == pytest.approx(0.04)
    # it slows down, and does not swing back
    assert (velocity >= 0.04 - 1e-9).all()
    operator.command("target", scale=0.0)
    follow(operator, 2.0)
    np.testing.assert_allclose(operator.load[1:], 0.0, atol=1e-12)


def test_a_load_that_is_slowed_down_on_its_way_does_not_come_back() -> None:
    turned = 0
    for seed in range(40):
        rng = np.random.default_rng(seed)
        operator = Operator(LAB.crane, LAB.limits, LAB.start, bounds=LAB.bounds)
        target = rng.uniform([-0.9, -0.9, -0.8], [0.9, 0.9, -0.25])
        operator.command("target", target=target)
        follow(operator, rng.uniform(0.3, 1.5), 0.02)
        operator.command("target", scale=float(rng.choice([0.3, 0.1])))
        velocity = follow(operator, 4.0, 0.02)[:, 1] * np.sign(target - LAB.start)
        turned += bool(velocity.min() < -1e-3)
    assert turned <= 1


def test_pushes_move_the_load_by_a_distance_each() -> None:
    operator = free()
    operator.command("inching", velocity=[0.0, 0.0, 0.0], distance=0.01)
    follow(operator, 0.1)
    for _ in range(3):
        operator.command("inching", velocity=[1.0, 0.0, 0.0])
        follow(operator, 0.3)
        operator.command("inching", velocity=[0.0, 0.0, 0.0])
        follow(operator, 0.3)
    follow(operator, 2.0)
    np.testing.assert_allclose(operator.load[0], [0.03, 0.0, -0.5], atol=1e-9)
    operator.command("inching", velocity=[-1.0, 0.0, -1.0])
    follow(operator, 2.0)
    np.testing.assert_allclose(operator.load[0], [0.02, 0.0, -0.51], atol=1e-9)


def test_a_push_that_is_held_on_entry_does_not_count() -> None:
    operator = free()
    operator.command("inching", velocity=[1.0, 0.0, 0.0], distance=0.01)
    follow(operator, 1.0)
    np.testing.assert_array_equal(operator.load[0], [0.0, 0.0, -0.5])


def test_a_push_does_not_lead_beyond_the_workspace() -> None:
    operator = LAB.operator()
    operator.command("inching", velocity=[0.0, 0.0, 0.0], distance=5.0)
    follow(operator, 0.1)
    operator.command("inching", velocity=[0.0, -1.0, 0.0])
    follow(operator, 8.0)
    assert operator.load[0, 1] == pytest.approx(-1.0, abs=1e-8)


def mission(x: float = 0.0) -> Trajectory:
    return plan([Waypoint([x, 0.0, -0.5]), Waypoint([x + 0.8, 0.3, -0.4])], FREE)


def test_a_plan_is_followed_until_a_command_takes_over() -> None:
    found = mission()
    operator = Operator(LAB.crane, FREE, found)
    motion = follow(operator, 1.0)
    np.testing.assert_allclose(motion[-1, 0], found(1.0), atol=1e-12)
    operator.command("stop")
    follow(operator, 3.0)
    np.testing.assert_allclose(operator.load[1:], 0.0, atol=1e-12)
    assert 0.05 < operator.load[0, 0] < 0.6
    operator.command("mission")
    at = operator.load[0].copy()
    follow(operator, 1.0)
    np.testing.assert_array_equal(operator.load[0], at)


def test_drives_that_are_too_weak_make_the_motion_slower() -> None:
    weak = ActuatorBounds(acceleration=[0.5, 0.5, 1.0])
    operator = Operator(LAB.crane, FREE, [0.0, 0.0, -0.5], bounds=weak)
    operator.command("velocity", velocity=[0.3, 0.0, 0.0])
    motion = follow(operator, 4.0)
    assert operator.load[1, 0] == pytest.approx(0.3)
    assert np.abs(needs(LAB.crane, motion[:, 0], 0.01)["acceleration"]).max() < 0.51
    assert operator.refused == "drives"


@pytest.mark.parametrize("share", [0.99, 0.7, 0.1])
def test_a_drive_that_is_slower_than_the_limit_takes_what_it_can(share: float) -> None:
    fastest = 0.4 * share
    operator = Operator(
        LAB.crane, LEVEL, [0.0, 0.0, -0.5], bounds=ActuatorBounds(velocity=fastest)
    )
    operator.command("velocity", velocity=[0.4, 0.0, 0.0])
    follow(operator, 10.0)
    assert 0.93 * fastest < operator.load[1, 0] <= fastest
    assert (operator.status, operator.refused) == ("reduced", "drives")
    operator.command("stop")
    follow(operator, 5.0)
    np.testing.assert_allclose(operator.load[1:], 0.0, atol=1e-12)
    operator.command("target", target=[0.2, 0.3, -0.6])
    follow(operator, 0.1)
    assert operator.status == "taken"
    follow(operator, operator.rests_at)
    np.testing.assert_allclose(operator.load[0], [0.2, 0.3, -0.6], atol=1e-9)


@pytest.mark.parametrize("axis", [0, 1])
def test_a_stop_begins_soon_where_only_flat_ramps_keep_the_drives(axis: int) -> None:
    # no limit of the snap: the carriage would have to jerk
    steep = Limits(velocity=0.4, acceleration=0.5, jerk=[20.0, 5.0, 2.0])
    bounds = ActuatorBounds(acceleration=0.15, force=[0.8, 0.5, 10.0])
    operator = Operator(LAB.crane, steep, [0.0, 0.0, -0.5], bounds=bounds)
    operator.command("target", target=np.where(np.arange(3) == axis, 20.0, [0.0, 0.0, -0.5]))
    for _ in range(4):
        follow(operator, 0.6)
        stopped = copy(operator)
        stopped.command("stop")
        follow(stopped, 0.5)
        assert stopped.status == "taken"
        assert stopped.rests_at - operator.time < 8.0


@campaign(24, 300, "seeds")
def test_a_stop_is_soon_where_limits_are_far_above_the_drives(seeds: int) -> None:
    """And nothing limits the snap: a slower plan has not that of the steep one which failed."""
    took = []
    for seed in range(seeds):
        rng = np.random.default_rng((9, seed))
        mass, rope = 10.0 ** rng.uniform(-1.0, 4.8), rng.uniform(0.3, 50.0)
        period = np.sqrt(rope / 9.81)
        fast = rope / period * 10.0 ** rng.uniform(-1.5, -0.3, 3)
        quick = 9.81 * 10.0 ** rng.uniform(-2.0, -0.5, 3)
        far = 10.0 ** rng.uniform(0.5, 1.5) * quick
        operator = Operator(
            Crane(
                bridge_mass=5.0 * mass, trolley_mass=mass, payload_mass=mass, rope_min=0.1 * rope
            ),
            Limits(fast, far, far / period * 10.0 ** rng.uniform(0.0, 1.0, 3)),
            [0.0, 0.0, -rope],
            bounds=ActuatorBounds(velocity=1.2 * fast, acceleration=quick),
            smoothness=int(rng.integers(4, 7)),
        )
        operator.command("velocity", velocity=fast * rng.uniform(-1.0, 1.0, 3) * [1.0, 1.0, 0.3])
        follow(operator, 4.0 * period, 0.1 * period)
        least = float((np.abs(operator.load[1]) / quick).max()) + period
        begin = operator.time
        operator.command("stop")
        follow(operator, 3.0 * period, 0.1 * period)
        took.append((operator.rests_at - begin) / least)
    assert np.median(took) < 8.0
    assert max(took) < 40.0


def test_targets_take_little_longer_than_the_shortest_plan_within_the_drives() -> None:
    # the shortest one by a search over the limits; half of the targets are too much for the drives
    rng = np.random.default_rng(9)
    low, high = (np.asarray(end) for end in (PORT.clearance.minimum, PORT.clearance.maximum))
    ratios = []
    while len(ratios) < 8:
        target = low + (high - low) * rng.uniform(0.1, 0.9, 3)
        operator = Operator(PORT.crane, PORT.limits, PORT.start, bounds=PORT.bounds)
        operator.command("target", target=target)
        follow(operator, 2.0, PORT.step)
        if operator.refused != "drives":
            continue
        shortest = plan_actuated(
            PORT.crane, [Waypoint(PORT.start), Waypoint(target)], PORT.limits, PORT.bounds
        ).trajectory.duration
        ratios.append(operator.rests_at / shortest)
    assert np.mean(ratios) < 1.12 and max(ratios) < 1.25


def test_the_setpoint_of_a_slow_drive_keeps_its_velocity() -> None:
    lag, most = 0.3, 0.32
    bounds = ActuatorBounds(velocity=most, lag=lag)
    operator = Operator(LAB.crane, FREE, [0.0, 0.0, -0.5], bounds=bounds)
    operator.command("velocity", velocity=[0.3, 0.0, 0.0])
    found = needs(LAB.crane, follow(operator, 6.0)[:, 0], 0.01)
    assert operator.load[1, 0] == pytest.approx(0.3)
    assert np.abs(found["velocity"] + lag * found["acceleration"]).max() < most * 1.001
    assert operator.refused == "drives"


def test_rest_where_the_drives_cannot_hold_the_load_is_refused() -> None:
    with pytest.raises(InfeasibleError, match=r"keep drives: .* % of the bound of the hoist force"):
        Operator(LAB.crane, FREE, [0.0, 0.0, -0.5], bounds=ActuatorBounds(force=5.0))
    with pytest.raises(InfeasibleError, match=r"keep workspace: .* x leaves its range -1 to 1"):
        Operator(LAB.crane, FREE, [2.0, 0.0, -0.5], clearance=LAB.clearance)
    with pytest.raises(InfeasibleError, match=r"keep rope: .* rope_max, 0\.9 m, and reaches 2 m"):
        Operator(LAB.crane, FREE, [0.0, 0.0, -2.0])
    with pytest.raises(InfeasibleError, match="keep obstacle: obstacle box: the load meets it"):
        Operator(LAB.crane, FREE, [0.3, 0.0, -0.6], clearance=LAB.clearance)
    with pytest.raises(InfeasibleError, match=r"keep travel: .* % of the bound of the rope travel"):
        Operator(LAB.crane, FREE, [0.0, 0.0, -0.5], bounds=ActuatorBounds(travel=[1.0, 1.0, 0.4]))


def test_a_plan_beyond_the_bounds_is_refused() -> None:
    with pytest.raises(InfeasibleError, match="% of the bound of the hoist force"):
        Operator(LAB.crane, FREE, mission(), bounds=ActuatorBounds(force=[99.0, 99.0, 9.82]))


def test_numbers_that_are_none_stop_the_load() -> None:
    operator = free()
    record = operator._motion.command
    operator.command("velocity", velocity=[0.3, 0.0, 0.0])
    follow(operator, 1.0)
    record[:] = np.where(np.arange(record.size) < 3, record, np.nan)
    follow(operator, 3.0)
    np.testing.assert_allclose(operator.load[1:], 0.0, atol=1e-9)


@pytest.mark.parametrize(("call", "words"), [
    (lambda o: o.command("fly"), "mode must be one of mission, target"),
    (lambda o: o.command("velocity", velocity=[1.0]), "velocity must have 3 values"),
    (lambda o: o.command("velocity", scale=2.0), "scale must be from 0 to 1"),
    (lambda o: o.command("target", target=[0.0, np.nan, 0.0]), "target"),
    (lambda o: o.command("target", target=[0.5, 1e300, -0.4]), r"target must be at most 1e\+06 m"),
    (lambda o: o.command("inching", distance=2e6), r"distance must be at most 1e\+06 m"),
    (lambda o: o.command("target", [0.5, 0.3, -0.4]), r"mode target needs a target \[m\]: give it "
     "once, as target="),
    (lambda o: o.command("inching", [1.0, 0.0, 0.0]), r"mode inching needs a distance \[m\]"),
    (lambda o: o.command("inching", [1.0, 0.0, 0.0], distance=[0.1, -0.1, 0.1]),
     r"distance must be at least 0 m, got \[0.1, -0.1, 0.1\]; the sign of the velocity is"),
    (lambda o: Operator(LAB.crane, FREE, plan([Waypoint([0.0, 0.0]), Waypoint([1.0, 1.0])], LEVEL)),
     "needs axes x, y, z; got 2 axes"),
    (lambda o: o.step(0.0), "duration must be a time > 0 s"),
    (lambda o: free(hold=0.0), "hold must be a time > 0 s"),
    (lambda o: free(bounds=3), "bounds"),
    (lambda o: free(clearance=3), "clearance must be a segfmu.Clearance"),
    (lambda o: free(friction=3), "friction"),
    (lambda o: free(smoothness=3), "smooth"),
    (lambda o: Operator(LAB.crane, 3, [0.0, 0.0, -0.5]), "limits must be a segfmu.Limits"),
    (lambda o: Operator(LAB.crane, FREE, [0.0, -0.5]), "start must have 3 values"),
    (lambda o: Operator(LAB.crane, FREE, [1e9, 0.0, -0.5]), "start" + BEYOND),
    (lambda o: Operator(LAB.crane, FREE, [0.0, -1e9, 0.5] + 7 * [0.0]), "start" + BEYOND),
    (lambda o: Operator(LAB.crane, FREE, mission(1e9)), "start" + BEYOND),
    (lambda o: o.take_over([1e9, 0.0, 0.5] + 7 * [0.0]), "state" + BEYOND),
    (lambda o: free(clearance=Clearance(
        [Obstacle(str(i), [5.0, 5.0, -1.0], [6.0, 6.0, -0.5]) for i in range(17)])),
     "17 obstacles, at most 16"),
])
def test_wrong_arguments_are_told(call, words: str) -> None:
    with pytest.raises(InputError, match=words):
        call(free())


def test_a_command_that_is_refused_changes_nothing() -> None:
    refused, untouched = free(), free()
    for operator in (refused, untouched):
        operator.command("velocity", velocity=[0.3, 0.0, 0.0])
    for wrong in (
        {"mode": "velocity", "velocity": [0.1, np.nan, 0.0], "scale": 0.5},
        {"mode": "target", "velocity": [0.0, 0.3, 0.0], "scale": 0.1},
    ):
        with pytest.raises(InputError):
            refused.command(**wrong)
    follow(refused, 1.0)
    follow(untouched, 1.0)
    assert np.array_equal(refused.load, untouched.load)


def test_copies_go_on_by_themselves() -> None:
    """A shallow copy shared its plan with the operator, and had another time."""
    operator = free()
    operator.command("velocity", velocity=[0.3, 0.0, 0.0])
    follow(operator, 0.5)
    copies = copy(operator), deepcopy(operator), pickle.loads(pickle.dumps(operator))
    for other in copies:
        other.command("velocity", velocity=[0.0, 0.2, 0.0])
        follow(other, 0.5)
    follow(operator, 0.5)
    assert operator.load[1, 0] > 0.1 and operator.load[0, 1] == 0.0
    assert copies[0].load[0, 1] > 0.0
    assert np.array_equal([other.load for other in copies], 3 * [copies[0].load])


def test_it_tells_what_it_does() -> None:
    operator = free()
    assert repr(operator) == "Operator(mission at 0 s, load at (0, 0, -0.5) m, taken)"
    operator.command("velocity", velocity=[0.3, 0.0, 0.0])
    operator.step(0.01)
    assert operator.mode == "velocity"
    assert operator.plan.used >= 3


@pytest.mark.parametrize("smoothness", [5, 6])
def test_other_smoothness(smoothness: int) -> None:
    operator = free(smoothness=smoothness)
    operator.command("velocity", velocity=[0.3, -0.2, 0.1])
    follow(operator, 1.0)
    operator.command("target", target=[0.4, 0.1, -0.5])
    follow(operator, 4.0)
    np.testing.assert_allclose(operator.load[0], [0.4, 0.1, -0.5], atol=1e-8)


def test_friction_leaves_the_motion_as_it_is() -> None:
    rubbing = free(friction=Friction(coulomb=(0.1, 0.1, 0.1)), bounds=ActuatorBounds(force=60.0))
    smooth = free()
    for operator in (rubbing, smooth):
        operator.command("velocity", velocity=[0.3, -0.2, 0.1])
        follow(operator, 1.0)
    np.testing.assert_array_equal(rubbing.load, smooth.load)




def test_a_mission_is_operated() -> None:
    operator = load_mission(MODELS / "pick_and_place.toml").operator()
    follow(operator, 1.0)
    operator.command("stop")
    follow(operator, 5.0)
    np.testing.assert_allclose(operator.load[1:], 0.0, atol=1e-9)


@campaign(20_000, 100_000)
def test_many_steps_end_when_they_should(count: int) -> None:
    operator = free()
    for _ in range(count):
        operator.step(0.001)
    assert operator.time == count / 1000


@pytest.mark.parametrize("tries", [1, 3, 9])
def test_a_step_tries_no_more_plans_than_it_may(tries: int) -> None:
    site = LAB
    operator = site.operator(tries=tries)
    pending = most = 0
    for command in commands(site, np.random.default_rng((71, 1)), 400):
        before = operator.attempts, operator.plans, operator.plan_begins
        operator.command(**command)
        now = operator.time
        operator.step(site.step)
        # one more is the plan before, whose velocity is held longer
        tried = operator.attempts - before[0]
        assert tried <= tries + 1
        most = max(most, tried)
        if tried > 0 and operator.status == "pending":
            # the plan before goes on
            assert (operator.plans, operator.plan_begins) == before[1:]
            pending += 1
        if operator.plans > before[1]:
            assert operator.plan_begins == now
    assert most >= min(tries, 4)
    assert (pending > 0) is (tries < 9)


def test_less_tries_find_the_same_plans_later() -> None:
    # out of the workspace, which the stop in the last tries keeps
    found = {}
    for tries in (1, 9):
        operator = free(tries=tries, clearance=Clearance(maximum=[0.4, 1.0, 0.0]))
        operator.command("target", target=[2.0, 0.0, -0.5])
        steps = 0
        while operator.status != "reduced":
            operator.step(0.01)
            steps += 1
        found[tries] = steps
    assert found[9] == 1
    assert found[1] > 1


@pytest.mark.parametrize("tries", [1, 3])
def test_a_command_that_is_tried_once_more_keeps_its_status(tries: int) -> None:
    # a corner of three boxes, before which the load rests and tries again and again
    far = 2.0
    boxes = [
        Obstacle("east", [0.5, -far, -far], [0.8, far, 0.0]),
        Obstacle("north", [-far, 0.5, -far], [far, 0.8, 0.0]),
        Obstacle("floor", [-far, -far, -far], [far, far, -0.9]),
    ]
    operator = free(tries=tries, clearance=Clearance(obstacles=boxes))
    operator.command("velocity", [0.3, 0.2, -0.1])
    statuses = []
    for _ in range(1000):
        operator.step(0.01)
        statuses.append(operator.status)
    changes = [statuses[0]] + [b for a, b in pairwise(statuses) if a != b]
    assert changes == ["taken", "reduced"]
    np.testing.assert_allclose(operator.load[0], [0.5, 0.5, -0.9], atol=1e-6)


@pytest.mark.parametrize("tries", [0, 10, 1.5, True])
def test_tries_are_a_few(tries: float) -> None:
    with pytest.raises(InputError, match="tries must be"):
        free(tries=tries)
