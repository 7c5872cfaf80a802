"""The plant with hook and sling: against Newton's equations, energies, drives at their bounds."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from segfmu import Limits, Waypoint, plan
from segfmu.crane import Crane, Drive, Friction, Plant, Rig, Setpoints, TravelLimits, Wind
from segfmu.crane.hook import HookCrane
from segfmu.crane.hook.model import HOOK
from segfmu.crane.inverse import FlatInverse
from segfmu.errors import InputError, SimulationError
from segfmu.kernels.crane.suspension import suspended_mass
from segfmu.kernels.hook._hook import hook_driven, hook_load, hook_rhs
from segfmu.kernels.hook.records import HookState
from tests.crane.hook_newton import driven, forced

LAB = HookCrane(Crane(2.2, 1.155, 1.0), 0.2, 0.3)
PORT = HookCrane(Crane(8e4, 1.2e4, 1e4), 500.0, 4.0)
SWAYING = np.array(
    [0.1, -0.2, 0.6, 0.2, -0.1, -0.3, 0.4, 0.1, -0.05, 0.02, 0.3, -0.2, 0.5, 0.6]
)
WIND = np.array([0.3, -0.2, 0.1])


class Idle:
    """A controller that corrects nothing."""

    sample_time = 0.01

    def sample(self, time, measured, reference, setpoint):
        return np.zeros(3)


def setpoints(force=(0.0, 0.0, 0.0), velocity=(0.0, 0.0, 0.0)) -> Setpoints:
    return Setpoints(np.array(force), np.array(velocity), np.zeros(10))


def test_forced_motion_is_newtons() -> None:
    force = np.array([0.8, -0.5, -11.9])
    plant = Plant(LAB, SWAYING, setpoints(force), Idle(), rig=Rig(wind=Wind(tuple(WIND))))
    run = solve_ivp(
        lambda _, x: [*x[7:], *forced(x, force, WIND, LAB.masses).coordinates], (0.0, 2.0),
        SWAYING, method="DOP853", rtol=1e-12, atol=1e-13,
    )
    for _ in range(40):
        plant.step(0.05, setpoints(force))
    assert plant.state == pytest.approx(run.y[:, -1], abs=1e-8)
    assert plant.sling_tension == pytest.approx(
        forced(run.y[:, -1], force, WIND, LAB.masses).tension, abs=1e-7
    )
    assert abs(plant.balance.imbalance) <= 1e-8


def test_motion_of_velocity_drives_is_newtons() -> None:
    """Ideal velocity drives: accelerations are the slopes of the setpoints."""
    slope = np.array([0.3, -0.2, 0.1])
    start = SWAYING.copy()
    plant = Plant(LAB, start, setpoints(velocity=start[7:10]), Idle(), driven=True)
    run = solve_ivp(
        lambda _, x: [*x[7:], *driven(x, slope, np.zeros(3), LAB.masses).coordinates], (0.0, 2.0),
        start, method="DOP853", rtol=1e-12, atol=1e-13,
    )
    for i in range(1, 41):
        plant.step(0.05, setpoints(velocity=start[7:10] + slope * 0.05 * i))
    end = run.y[:, -1]
    assert plant.state == pytest.approx(end, abs=1e-8)
    needed = driven(end, slope, np.zeros(3), LAB.masses).force
    assert plant.drive_force == pytest.approx(needed, abs=1e-6)
    assert abs(plant.balance.imbalance) <= 1e-8


@pytest.mark.parametrize("crane", [LAB, PORT])
def test_load_is_below_the_hook(crane: HookCrane) -> None:
    state = np.array([1.0, 2.0, 0.7, *np.zeros(11)])
    weight = -(crane.hook_mass + crane.crane.payload_mass) * 9.81
    plant = Plant(crane, state, setpoints((0.0, 0.0, weight)), Idle())
    assert plant.load[0] == pytest.approx([1.0, 2.0, -0.7 - crane.sling], rel=1e-14)
    plant.step(1.0, setpoints((0.0, 0.0, weight)))
    assert plant.state == pytest.approx(state, abs=1e-12)


def test_mass_along_the_rope_is_that_of_newtons_forces() -> None:
    """Forces change by (M + m e e') times the accelerations of the drives."""
    random = np.random.default_rng(7)
    for crane in (LAB, PORT):
        bridge = crane.masses[0] + crane.masses[1]
        parameters = Rig().parameters(crane, True)
        for _ in range(50):
            state = np.concatenate([
                random.uniform(-1.0, 1.0, 2), random.uniform(0.5, 8.0, 1),
                random.uniform(-1.0, 1.0, 11),
            ])
            before = driven(state, np.zeros(3), np.zeros(3), crane.masses).force
            after = driven(state, np.array([0.0, 0.0, 1.0]), np.zeros(3), crane.masses).force
            mass = suspended_mass(parameters, HOOK.kept(state))
            assert after[2] - before[2] == pytest.approx(mass, rel=1e-9)
            along = np.sin(state[3])
            moved = driven(state, np.array([1.0, 0.0, 0.0]), np.zeros(3), crane.masses).force
            assert moved[0] - before[0] == pytest.approx(bridge + mass * along**2, rel=1e-9)
            assert moved[2] - before[2] == pytest.approx(mass * along, rel=1e-6, abs=1e-6 * mass)


@pytest.mark.parametrize("mode", ["force", "velocity"])
def test_real_drives_keep_bounds_and_energy(mode: str) -> None:
    drives = [Drive(lag=0.05, force_max=m, velocity_max=0.3) for m in (1.0, 0.6, 14.0)]
    rig = Rig(*drives, friction=Friction((0.5, 0.4, 0.3), (0.05, 0.05, 0.05), sway=0.01),
              wind=Wind((0.1, 0.05, 0.0)))
    given = setpoints((3.0, -2.0, -13.0), (0.5, -0.4, -0.1))
    start = np.array([0.0, 0.0, 0.8, *np.zeros(11)])
    plant = Plant(LAB, start, given, Idle(), rig=rig, driven=mode == "velocity")
    most, flagged = np.zeros(3), np.zeros(3, dtype=bool)
    for _ in range(40):
        plant.step(0.02, given)
        most, flagged = np.maximum(most, np.abs(plant.drive_force)), flagged | plant.saturated
    assert (most <= np.array([1.0, 0.6, 14.0]) * (1.0 + 1e-9)).all()
    assert flagged[:2].all()
    assert np.abs(plant.state[5:7]).max() > 0.01
    assert abs(plant.balance.imbalance) <= 1e-8


def test_a_sling_that_would_push_is_told() -> None:
    state = np.array([0.0, 0.0, 0.6, *np.zeros(11)])
    upwards = setpoints(velocity=(0.0, 0.0, 0.0))
    plant = Plant(LAB, state, upwards, Idle(), rig=Rig(wind=Wind((0.0, 0.0, 11.0))), driven=True)
    with pytest.raises(SimulationError, match="the sling went slack"):
        plant.step(0.1, upwards)


def test_an_angle_of_a_sling_is_named() -> None:
    state = np.array([0.0, 0.0, 0.6, *np.zeros(11)])
    state[13] = -100.0
    heavy = replace(LAB, hook_mass=1e6)
    plant = Plant(heavy, state, setpoints(), Idle(), driven=True)
    with pytest.raises(SimulationError, match=r"sling\.y\.angle reached -1\.57 rad, with 0\.6 m "):
        plant.step(0.1, setpoints())


def test_a_rope_with_a_hook_does_not_slacken() -> None:
    with pytest.raises(InputError, match=r"with a sling rope\.slack must be error"):
        Plant(LAB, SWAYING, setpoints(), Idle(), rig=Rig(travel=TravelLimits(slack="free_fall")))


def test_sizes_of_states_are_checked() -> None:
    with pytest.raises(InputError, match="state"):
        Plant(LAB, SWAYING[:10], setpoints(), Idle())


@pytest.mark.parametrize("forced_mode", [True, False], ids=["force", "acceleration"])
def test_the_inverse_leads_the_load_along_its_plan(forced_mode: bool) -> None:
    """The equations under the exact setpoints of a plan with hoisting."""
    limits = Limits(velocity=[0.8, 0.5, 0.3], acceleration=[1.0, 0.8, 0.5], jerk=4.0, snap=20.0)
    trajectory = plan(
        [Waypoint([0.0, 0.0, -0.9]), Waypoint([1.0, 0.6, -0.7])], limits, smoothness=6
    )
    inverse = FlatInverse(LAB, trajectory)
    masses, calm = np.array(LAB.masses), np.zeros(3)

    def rate(t: float, x: np.ndarray) -> np.ndarray:
        derivative, tension = np.zeros(HookState.SIZE), np.zeros(1)
        if forced_mode:
            force = np.append(inverse.force(t), [0.0, 0.0])
            hook_rhs(x, force, calm, masses, derivative, tension)
        else:
            carriage = inverse.acceleration(t)[:3]
            hook_driven(x, carriage, np.zeros(5), calm, masses, derivative, np.zeros(3), tension)
        return derivative

    state, load = inverse.state(0.0), np.zeros((2, 3))
    # from kink to kink of the setpoints
    for begin, end in pairwise([0.0, *trajectory.events[trajectory.events > 0.0]]):
        run = solve_ivp(rate, (begin, end), state, method="DOP853", rtol=1e-12, atol=1e-14)
        state = run.y[:, -1]
        hook_load(state, masses, load)
        assert load[0] == pytest.approx(trajectory(end), abs=1e-9)
    assert end == trajectory.duration
