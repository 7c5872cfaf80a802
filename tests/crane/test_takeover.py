"""Swings that are taken over: Newton's laws from the measured state on, bounds, the least time."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from benchmarks.operated import SITES, Site
from benchmarks.takeovers import LIMITS, Swinging, drives_of, exceeds, optimum, problem
from scipy.integrate import solve_ivp

from segfmu import ActuatorBounds, Clearance, Crane, InfeasibleError, InputError, Limits, Operator
from segfmu.kernels import backend
from segfmu.kernels.operation.records import Control
from tests.campaign import campaign

GRAVITY = 9.81


def bounds_of(site: Site, **changed: Any) -> ActuatorBounds:
    """Without those of forces and sway."""
    known = {"velocity": site.bounds.velocity, "acceleration": site.bounds.acceleration}
    return ActuatorBounds(**(known | changed))


def swinging(site: Site, sway: float, moving: float = 0.3) -> np.ndarray:
    """A measured state; sway [deg], and the share of their velocities that all drives have."""
    rope = -site.start[2]
    speed = moving * np.asarray(site.bounds.velocity) * [1.0, -1.0, 0.5]
    turn = np.sqrt(GRAVITY / rope) * np.radians(sway)
    return np.array(
        [
            0.1,
            0.2,
            rope,
            0.6 * np.radians(sway),
            -0.5 * np.radians(sway),
            *speed,
            0.5 * turn,
            0.3 * turn,
        ]
    )


def operator_of(site: Site, state: np.ndarray, **options: Any) -> Operator:
    return Operator(site.crane, site.limits, state, **({"bounds": bounds_of(site)} | options))


def forces(operator: Operator, time: float) -> np.ndarray:
    found = np.zeros(18)
    backend.crane_flat_inverse(
        operator.load_at(time), np.array(operator.crane.masses), found[:3], found[3:13], found[13:]
    )
    return found[:3]


def simulated(operator: Operator, state: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """The crane under the plan's forces by Lagrange's equations: its last state, and of the drives
    velocities and accelerations on the way."""
    rhs = operator.crane.rhs
    knots = np.linspace(operator.time, operator.rests_at, Control.INTERVALS + 1)
    velocities, accelerations = [], []
    for begin, end in pairwise(knots):
        # forces have kinks at the knots
        inside = begin + 1e-9 * (end - begin), end - 1e-9 * (end - begin)
        run = solve_ivp(
            lambda t, y, i=inside: rhs(y, forces(operator, float(np.clip(t, *i)))),
            (begin, end),
            state,
            "DOP853",
            rtol=1e-9,
            atol=1e-10,
        )
        for time, row in zip(run.t, run.y.T, strict=True):
            velocities.append(row[5:8])
            accelerations.append(rhs(row, forces(operator, float(np.clip(time, *inside))))[5:8])
        state = run.y[:, -1]
    return state, np.array(velocities), np.array(accelerations)


@pytest.mark.parametrize("sway", [5.0, 20.0])
@pytest.mark.parametrize("name", SITES)
def test_a_measured_swing_comes_to_rest_within_the_bounds(name: str, sway: float) -> None:
    site = SITES[name]
    start = swinging(site, sway)
    operator = operator_of(site, start)
    assert operator.status == "taken"
    # the reference begins where the crane is
    np.testing.assert_allclose(operator.setpoints[3:13], start, atol=1e-7)
    last, velocities, accelerations = simulated(operator, start)
    assert np.abs(last[3:5]).max() < 1e-6
    assert np.abs(last[8:]).max() < 1e-6 * np.sqrt(GRAVITY / last[2])
    assert np.abs(last[5:8]).max() < 1e-6
    assert (np.abs(velocities).max(axis=0) <= site.bounds.velocity).all()
    assert (np.abs(accelerations).max(axis=0) <= site.bounds.acceleration).all()
    # a drive is at its bound, or there would be a shorter way
    assert (np.abs(accelerations).max(axis=0) / site.bounds.acceleration).max() > 0.95


@campaign(3, 200, "seeds")
@pytest.mark.parametrize("sway", [5.0, 10.0, 20.0])
def test_the_time_is_near_the_least(sway: float, seeds: int) -> None:
    ratios = []
    for seed in range(seeds):
        asked = problem(np.random.default_rng((5, int(sway), seed)), sway)
        try:
            operator = Operator(asked.crane, LIMITS, asked.state, bounds=asked.bounds)
        except InfeasibleError:
            continue
        assert not exceeds(asked, operator)
        ratios.append(operator.rests_at / optimum(asked, 1.05 * operator.rests_at))
    assert len(ratios) >= 0.9 * seeds
    assert np.quantile(ratios, 0.95) < 1.5


def test_a_shorter_time_than_the_least_is_none() -> None:
    # a load that hangs still below a trolley at full speed: v / a, and not a swing more
    crane = Crane(bridge_mass=2.2, trolley_mass=1.155, payload_mass=1.0)
    bounds = ActuatorBounds(velocity=1.0, acceleration=0.5)
    rope, speed = 0.5, 0.9
    state = np.array([0.0, 0.0, rope, 0.0, 0.0, 0.0, speed, 0.0, 0.0, 0.0])
    operator = Operator(crane, LIMITS, state, bounds=bounds)
    swing = 2.0 * np.pi * np.sqrt(rope / GRAVITY)
    assert speed / 0.5 <= operator.rests_at < speed / 0.5 + swing


def test_a_crane_near_full_speed_is_taken_over_and_one_beyond_is_not() -> None:
    site = SITES["lab"]
    start = swinging(site, 5.0)
    # more than the velocities afterwards may use
    start[6] = 0.9985 * site.bounds.velocity[1]
    operator = operator_of(site, start)
    assert np.isfinite(operator.rests_at)
    start[6] *= 1.002
    with pytest.raises(InfeasibleError, match="keeps drives"):
        operator_of(site, start)


def test_a_load_that_hangs_still_stays() -> None:
    site = SITES["lab"]
    operator = operator_of(site, swinging(site, 0.0, moving=0.0))
    assert operator.rests_at < 0.1
    operator.step(0.2)
    np.testing.assert_allclose(operator.load[0], [0.1, 0.2, site.start[2]], atol=1e-12)


@pytest.mark.parametrize("smoothness", [4, 5, 6])
def test_commands_are_followed_when_the_load_rests(smoothness: int) -> None:
    site = SITES["lab"]
    operator = operator_of(site, swinging(site, 10.0), smoothness=smoothness)
    rests = operator.rests_at
    operator.command("velocity", velocity=[0.2, 0.1, 0.0])
    while operator.time < rests - 0.01:
        operator.step(0.01)
        assert operator.status == "reduced"
        assert operator.rests_at == rests
    for _ in range(200):
        operator.step(0.01)
    assert operator.status == "taken"
    np.testing.assert_allclose(operator.load[1], [0.2, 0.1, 0.0], atol=1e-9)


@pytest.mark.parametrize("name", SITES)
def test_a_command_takes_the_swing_behind_an_emergency_stop_over(name: str) -> None:
    site = SITES[name]
    operator = site.operator(bounds=bounds_of(site), clearance=Clearance())
    operator.command("velocity", velocity=0.9 * np.asarray(site.limits.velocity))
    for _ in range(60):
        operator.step(site.step)
    operator.command("emergency")
    stands = operator.time + operator.emergency.duration
    operator.step(site.step)
    operator.command("stop")
    # fine steps: each that would try in vain would take milliseconds
    while operator.time < stands - site.step / 20.0:
        operator.step(site.step / 20.0)
        assert operator.rests_at == np.inf
    assert operator.attempts <= 2 + operator.plans
    for _ in range(40):
        operator.step(site.step / 20.0)
    assert operator.status == "taken"
    state = operator.setpoints[3:13]
    last, _, accelerations = simulated(operator, state)
    assert np.abs(last[3:5]).max() < 1e-6
    assert (np.abs(accelerations).max(axis=0) <= site.bounds.acceleration).all()
    # another emergency stop is still one
    operator.command("emergency")
    operator.step(site.step)
    assert operator.rests_at == np.inf


def test_a_direction_has_a_bound_of_its_own() -> None:
    site = SITES["lab"]
    least = [-0.3, -0.2, -0.7]
    start = swinging(site, 10.0)
    free = operator_of(site, start)
    operator = operator_of(site, start, bounds=bounds_of(site, acceleration_min=least))
    accelerations = drives_of(operator, operator.rests_at / 2000)[1]
    assert (accelerations.min(axis=0) >= least).all()
    assert accelerations.max() > 0.5
    assert operator.rests_at > free.rests_at


def test_a_force_that_is_too_small_makes_the_way_slower() -> None:
    site = SITES["port"]
    start = swinging(site, 2.0)
    free = operator_of(site, start)
    knots = np.linspace(0.0, free.rests_at, 400)
    used = np.abs([forces(free, t) for t in knots]).max(axis=0)
    most = [*(0.75 * used[:2]), 1e9]
    operator = operator_of(site, start, bounds=bounds_of(site, force=most))
    assert operator.rests_at > 1.05 * free.rests_at
    found = np.abs([forces(operator, t) for t in np.linspace(0.0, operator.rests_at, 2000)])
    assert (found.max(axis=0) <= most).all()


def test_what_cannot_be_taken_over_is_told() -> None:
    site = SITES["lab"]
    start = swinging(site, 20.0)
    with pytest.raises(InputError, match="of the bridge has no bound"):
        operator_of(site, start, bounds=ActuatorBounds(velocity=1.0))
    weak = bounds_of(site, acceleration=1e-3)
    with pytest.raises(InfeasibleError, match="keeps drives"):
        operator_of(site, start, bounds=weak)
    # nothing is integrated that a plan has no room for
    with pytest.raises(InfeasibleError, match="keeps drives"):
        operator_of(site, start, bounds=bounds_of(site, acceleration=1e-12))
    narrow = Clearance(minimum=[0.0, 0.0, -0.9], maximum=[0.12, 0.3, -0.1])
    with pytest.raises(InfeasibleError, match="keeps workspace"):
        operator_of(site, start, clearance=narrow)
    for place, value in ((2, -0.5), (3, 1.6)):
        state = start.copy()
        state[place] = value
        with pytest.raises(InputError, match="are no state of a load"):
            operator_of(site, state)
    with pytest.raises(InputError, match="start"):
        operator_of(site, np.full(10, np.nan))


def test_a_swing_of_all_directions_is_the_same() -> None:
    # turned by a right angle: bridge and trolley with the same bounds
    crane = Crane(bridge_mass=2.2, trolley_mass=1.155, payload_mass=1.0)
    bounds = ActuatorBounds(velocity=0.6, acceleration=0.9)
    limits = Limits(velocity=0.4, acceleration=0.5, jerk=1.5, snap=10.0)
    one = np.array([0.0, 0.0, 0.5, 0.2, 0.0, 0.1, 0.0, 0.0, 0.3, 0.0])
    # phi_y turns the load to -y
    other = np.array([0.0, 0.0, 0.5, 0.0, -0.2, 0.0, 0.1, 0.0, 0.0, -0.3])
    found = [Operator(crane, limits, s, bounds=bounds) for s in (one, other)]
    assert found[0].rests_at == pytest.approx(found[1].rests_at, rel=1e-9)
    np.testing.assert_allclose(
        found[0].load_at(0.4)[:, [0, 1]], found[1].load_at(0.4)[:, [1, 0]], atol=1e-8
    )


def test_the_optimum_of_a_swing_at_the_right_time_is_known() -> None:
    # w = 1 / s; a load that passes the middle of its swing with 2 a / w: a push along and one back
    # bring it to rest in half a swing, as their sign is that of the cosine
    asked = Swinging(
        Crane(3.0, 1.5, 1.0),
        np.array([9.0, 9.0]),
        np.array([1.0, 1.0]),
        np.array([0.0, 0.0, GRAVITY, 0.0, 0.0, 0.0, 0.0, 0.0, 2.0 / GRAVITY, 0.0]),
    )
    assert optimum(asked, 20.0) == pytest.approx(np.pi, rel=0.02)
    operator = Operator(asked.crane, LIMITS, asked.state, bounds=asked.bounds)
    assert np.pi * 0.99 < operator.rests_at < np.pi * 1.2
