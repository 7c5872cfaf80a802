"""Drives that can do more in one direction: closed forms, Newton's laws, mirrored runs."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from segfmu import Crane, InputError
from segfmu.crane import Drive, Plant, Rig, Setpoints
from segfmu.kernels.crane.drives import driven_derivative, forced_derivative
from segfmu.kernels.crane.records import Action, PlantState, Work
from tests.crane.newton import accelerations
from tests.crane.test_drive_bounds import (
    ROPE,
    SIZES,
    bare,
    rigged,
    setpoints,
    weight,
)

PAIRS = (("force_max", "force_min"), ("acceleration_max", "acceleration_min"),
         ("velocity_max", "velocity_min"))


def mirrored(drive: Drive) -> Drive:
    """The drive of a crane that is seen from the other side."""
    return replace(drive, **{
        name: None if getattr(drive, other) is None else -getattr(drive, other)
        for pair in PAIRS for name, other in (pair, pair[::-1])
    })


@pytest.mark.parametrize("name", ["force_min", "acceleration_min", "velocity_min"])
@pytest.mark.parametrize("value", [0.0, 0.5, float("nan"), -float("inf"), "slow", True])
def test_a_least_bound_is_below_zero(name: str, value) -> None:
    with pytest.raises(InputError, match=f"drive {name} must be a finite number < 0, got"):
        Drive(**{name: value})


@pytest.mark.parametrize("lag", [0.0, 0.2])
@SIZES
def test_velocity_setpoints_are_clipped_by_direction(crane: Crane, lag: float) -> None:
    """A hoist that lowers at 0.05 m/s and lifts at 0.02 m/s."""
    rig = Rig(
        Drive(lag, velocity_max=0.3, velocity_min=-0.1), Drive(lag, velocity_min=-0.2),
        Drive(lag, velocity_max=0.05, velocity_min=-0.02),
    )
    for sign in (1.0, -1.0):
        told = setpoints(crane, velocity=(sign * 0.5, sign * 0.5, sign * 0.08))
        plant = rigged(crane, rig, driven=True, first=told)
        for _ in range(40):
            plant.step(0.05, told)
        reached = 1.0 - np.exp(-2.0 / lag) if lag else 1.0
        expected = [0.3, 0.5, 0.05] if sign > 0.0 else [-0.1, -0.2, -0.02]
        assert plant.state[5:8] == pytest.approx(reached * np.array(expected), abs=1e-9)
        assert plant.saturated.tolist() == [True, sign < 0.0, True]


@pytest.mark.parametrize("driven", [False, True])
@SIZES
def test_a_trolley_brakes_harder_than_it_drives(crane: Crane, driven: bool) -> None:
    """From rest at 0.2 m/s2, braked at 0.6 m/s2; without its load it has no swing."""
    own, mass = bare(crane), crane.trolley_mass
    bounds = (
        {"acceleration_max": 0.2, "acceleration_min": -0.6} if driven else
        {"force_max": 0.2 * mass, "force_min": -0.6 * mass}
    )
    ahead, back = (
        setpoints(own, (0.0, s * 9.0 * mass, 0.0), (0.0, s * 9.0, 0.0)) for s in (1.0, -1.0)
    )
    plant = rigged(own, Rig(trolley=Drive(1e-3, **bounds)), driven=driven, first=ahead)
    for _ in range(20):
        plant.step(0.05, ahead)
    assert plant.state[[1, 6]] == pytest.approx([0.1, 0.2], abs=1e-8)
    plant.step(1e-9, back)
    for _ in range(6):
        plant.step(0.05, back)
    assert plant.state[6] == pytest.approx(0.2 - 0.6 * 0.3, abs=1e-7)
    assert plant.drive_force[1] == pytest.approx(-0.6 * mass, rel=1e-6)
    assert plant.saturated[1]


@SIZES
def test_a_force_drive_keeps_the_largest_velocity_of_its_direction(crane: Crane) -> None:
    own, mass = bare(crane), crane.bridge_mass + crane.trolley_mass
    rig = Rig(Drive(velocity_max=0.2, velocity_min=-0.05))
    for sign, bound in ((1.0, 0.2), (-1.0, 0.05)):
        told = setpoints(own, (sign * 0.5 * mass, 0.0, 0.0))
        plant = rigged(own, rig, driven=False, first=told)
        for i in range(1, 21):
            plant.step(0.05, told)
            expected = sign * min(0.5 * 0.05 * i, bound)
            assert plant.state[5] == pytest.approx(expected, abs=1e-8)


@SIZES
def test_a_hoist_that_pulls_less_than_it_is_asked_to(crane: Crane) -> None:
    """`force_min` bounds the pull of the rope, `force_max` what could push it."""
    rig = Rig(hoist=Drive(force_max=0.1 * weight(crane), force_min=-1.2 * weight(crane)))
    up = setpoints(crane, (0.0, 0.0, -weight(crane)))
    plant = rigged(crane, rig, driven=False, first=up)
    plant.step(0.5, up)
    assert plant.drive_force[2] == pytest.approx(-1.2 * weight(crane), rel=1e-9)
    assert plant.state[7] == pytest.approx(-0.2 * crane.gravity * 0.5, rel=1e-9)


@pytest.mark.parametrize("driven", [False, True])
@SIZES
def test_coupled_drives_are_at_the_bound_of_their_direction_or_need_not(
    crane: Crane, driven: bool
) -> None:
    """At random states, by Newton's laws: within both bounds, and short of no demand without."""
    random = np.random.default_rng(9)
    masses = (crane.bridge_mass, crane.trolley_mass, crane.payload_mass, crane.gravity)
    scale = np.array([sum(masses[:2]), masses[1], masses[2]])
    low, high = -scale * [1.5, 0.4, 11.0], scale * [0.5, 1.2, 0.3]
    rig = Rig(*(Drive(force_max=m, force_min=n) for n, m in zip(low, high, strict=True)))
    parameters = rig.parameters(crane, driven)
    sides = np.zeros((2, 3), dtype=int)
    for _ in range(400):
        state = np.zeros(PlantState.SIZE)
        state[:10] = [
            *random.uniform(-1.0, 1.0, 2), ROPE[crane.trolley_mass],
            *random.uniform(-0.4, 0.4, 2), *random.uniform(-0.3, 0.3, 5),
        ]
        work, derivative = np.zeros((Work.SIZE, Work.COLUMNS)), np.zeros(PlantState.SIZE)
        demand = random.uniform(-3.0, 3.0, 3)
        if not driven:
            demand = scale * demand - [0.0, 0.0, weight(crane)]
        work[Work.DEMAND, :3] = demand
        (driven_derivative if driven else forced_derivative)(parameters, state, work, derivative)
        force = work[Work.ACTION, :3]
        expected = accelerations(state[:10], force, np.zeros(3), *masses)
        assert derivative[5:10] == pytest.approx(expected, rel=1e-7, abs=1e-7)
        assert (force >= low * (1.0 + 1e-9)).all() and (force <= high * (1.0 + 1e-9)).all()
        saturated = work[Work.ACTION, Action.SATURATED : Action.ROPE_FORCE] > 0.0
        met = derivative[5:8] if driven else force
        assert met[~saturated] == pytest.approx(demand[~saturated], rel=1e-9, abs=1e-9)
        at = np.where(force > 0.0, high, low)
        assert force[saturated] == pytest.approx(at[saturated], rel=1e-9)
        # a drive at a bound lags behind its demand, never ahead of it
        assert (np.sign(force) * (demand - met) >= -1e-9 * np.abs(demand))[saturated].all()
        for side, row in zip((force > 0.0, force < 0.0), sides, strict=True):
            row += saturated & side
    assert (sides[0, :2] > 10).all() and (sides[1] > 10).all()


@pytest.mark.parametrize("driven", [False, True])
@SIZES
def test_a_mirrored_crane_runs_mirrored(crane: Crane, driven: bool) -> None:
    length, mass = ROPE[crane.trolley_mass], crane.trolley_mass
    pace, moved = np.sqrt(length), np.array([mass + crane.bridge_mass, mass, 0.0])
    drives = [
        Drive(0.1, force_max=0.9 * m, force_min=-0.5 * m, acceleration_max=0.5,
              acceleration_min=-0.3, velocity_max=0.2 * pace, velocity_min=-0.1 * pace)
        for m in moved[:2]
    ]
    ends = []
    for sign in (1.0, -1.0):
        rig = Rig(*(drives if sign > 0.0 else map(mirrored, drives)))
        flip = np.array([sign, sign, 1.0, sign, sign])

        def told(time: float, sign: float = sign) -> Setpoints:
            wave = sign * np.array([np.sin(3.0 * time), np.cos(2.0 * time), 0.0])
            return setpoints(crane, 2.0 * moved * wave, 0.4 * pace * wave)

        plant = rigged(crane, rig, driven=driven, first=told(0.0))
        rows = []
        for i in range(1, 61):
            plant.step(0.05, told(0.05 * i))
            rows.append(np.concatenate([
                plant.state * np.tile(flip, 2), plant.drive_force * flip[:3], plant.saturated,
            ]))
        ends.append(rows)
    assert np.array(ends[1]) == pytest.approx(np.array(ends[0]), rel=1e-12, abs=1e-12)
    assert np.array(ends[0])[:, 13:15].any(axis=0).all()


@SIZES
def test_bounds_by_direction_against_scipy_with_a_swinging_load(crane: Crane) -> None:
    length, mass = ROPE[crane.trolley_mass], crane.trolley_mass
    most, least = 0.4 * mass, -1.0 * mass
    period = 2.0 * np.sqrt(length)
    given = [setpoints(crane, (0.0, s * 2.0 * mass, 0.0)) for s in (1.0, -1.0)]
    drive = Drive(force_max=most, force_min=least)
    plant = rigged(crane, Rig(trolley=drive), driven=False, first=given[0])
    masses = (crane.bridge_mass, mass, crane.payload_mass, crane.gravity)
    expected = plant.state
    for told, pushed in zip(given, (most, least), strict=True):
        net = np.array([0.0, pushed, -weight(crane)])
        plant.step(1e-9, told)
        expected = solve_ivp(
            lambda _, x, net=net: np.concatenate(
                [x[5:], accelerations(x, net, np.zeros(3), *masses)]
            ),
            (0.0, period), plant.state, method="DOP853", rtol=1e-12, atol=1e-12,
        ).y[:, -1]
        for _ in range(40):
            plant.step(period / 40, told)
            assert least * (1.0 + 1e-12) <= plant.drive_force[1] <= most * (1.0 + 1e-12)
        assert plant.state == pytest.approx(expected, rel=1e-7, abs=1e-8)


def test_a_plant_without_directions_is_what_it_was() -> None:
    """The same numbers in both directions are no difference, bit for bit."""
    crane = Crane(2.2, 1.155, 1.0)
    own = {"force_max": 3.0, "acceleration_max": 0.5, "velocity_max": 0.2}
    told = {f"{name[:-4]}_min": -value for name, value in own.items()}
    plants: list[Plant] = [
        rigged(crane, Rig(Drive(0.1, **bounds), Drive(0.1, **bounds)), driven=True,
               first=setpoints(crane))
        for bounds in (own, own | told)
    ]
    for i in range(40):
        for plant in plants:
            wave = np.sin(0.3 * i)
            plant.step(0.05, setpoints(crane, velocity=(0.5 * wave, -0.5 * wave, 0.0)))
        assert np.array_equal(plants[0].state, plants[1].state)
