"""Velocity and power bounds of the drives against closed forms, for a lab rig and 40 t."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from segfmu import Crane
from segfmu.crane import Drive, Plant, Rig, Setpoints
from segfmu.crane.feedback import design
from segfmu.kernels.crane.drives import forced_derivative
from segfmu.kernels.crane.records import Work
from tests.crane.newton import accelerations

LAB, STS = Crane(2.2, 1.155, 1.0), Crane(300e3, 15e3, 40e3)
SIZES = pytest.mark.parametrize("crane", [LAB, STS], ids=["lab", "sts"])
ROPE = {LAB.trolley_mass: 0.5, STS.trolley_mass: 20.0}


def hanging(crane: Crane) -> np.ndarray:
    return crane.hanging([0.0, 0.0, -ROPE[crane.trolley_mass]])


def weight(crane: Crane) -> float:
    return crane.payload_mass * crane.gravity


def bare(crane: Crane) -> Crane:
    """With a load that the carriages do not feel."""
    return replace(crane, payload_mass=1e-9 * crane.payload_mass)


def rigged(crane: Crane, rig: Rig, *, driven: bool, first: Setpoints | None = None) -> Plant:
    length = ROPE[crane.trolley_mass]
    gains = design(
        crane, sample_time=0.01, shortest=0.5 * length, longest=length, rows=2, driven=driven
    )
    start = hanging(crane)
    first = first or Setpoints(np.array([0.0, 0.0, -weight(crane)]), reference=start)
    return Plant(crane, start, first, gains, driven=driven, enabled=False, rig=rig)


def setpoints(crane: Crane, force=(0.0, 0.0, 0.0), velocity=(0.0, 0.0, 0.0)) -> Setpoints:
    """Forces beside the weight, and velocities."""
    total = np.array(force) - [0.0, 0.0, weight(crane)]
    return Setpoints(total, np.array(velocity), hanging(crane))


@pytest.mark.parametrize("lag", [0.0, 0.2])
@SIZES
def test_velocity_setpoints_are_clipped(crane: Crane, lag: float) -> None:
    rig = Rig(Drive(lag, velocity_max=0.3), hoist=Drive(lag, velocity_max=0.02))
    plant = rigged(crane, rig, driven=True, first=setpoints(crane, velocity=(0.5, 0.5, 0.05)))
    for i in range(1, 31):
        plant.step(0.05, setpoints(crane, velocity=(0.5, 0.5, 0.05)))
        rise = 1.0 - np.exp(-0.05 * i / lag) if lag else 1.0
        assert plant.state[[5, 7]] == pytest.approx([0.3 * rise, 0.02 * rise], abs=1e-9)
        assert plant.state[6] == pytest.approx(0.5, abs=1e-9)
        assert plant.saturated.tolist() == [True, False, True]
    plant.step(0.05, setpoints(crane, velocity=(0.0, 0.5, 0.0)))
    plant.step(0.05, setpoints(crane, velocity=(0.0, 0.5, 0.0)))
    assert not plant.saturated.any()


@SIZES
def test_force_drive_keeps_its_largest_velocity(crane: Crane) -> None:
    """From 0.2 m/s on the drive applies what holds it; a braking force acts at once."""
    own, mass = bare(crane), crane.bridge_mass + crane.trolley_mass
    force = 0.5 * mass
    plant = rigged(own, Rig(Drive(velocity_max=0.2)), driven=False,
                   first=setpoints(own, (force, 0.0, 0.0)))
    for i in range(1, 21):
        plant.step(0.05, setpoints(own, (force, 0.0, 0.0)))
        t = 0.05 * i
        reached = t >= 0.4
        assert plant.state[5] == pytest.approx(0.2 if reached else 0.5 * t, abs=1e-8)
        assert plant.state[0] == pytest.approx(
            0.04 + 0.2 * (t - 0.4) if reached else 0.25 * t**2, abs=1e-8
        )
    assert abs(plant.drive_force[0]) < 1e-6 * force
    assert plant.saturated[0]
    plant.step(1e-9, setpoints(own, (-force, 0.0, 0.0)))
    plant.step(0.2, setpoints(own, (-force, 0.0, 0.0)))
    assert plant.state[5] == pytest.approx(0.1, abs=1e-8)
    assert not plant.saturated[0]


@SIZES
def test_hoist_at_its_largest_velocity_carries_the_weight(crane: Crane) -> None:
    """The load falls at g / 4 until the hoist holds its velocity."""
    rig = Rig(hoist=Drive(velocity_max=0.3))
    down = setpoints(crane, (0.0, 0.0, 0.25 * weight(crane)))
    plant = rigged(crane, rig, driven=False, first=down)
    plant.step(0.5, down)
    assert plant.state[7] == pytest.approx(0.3, abs=1e-8)
    assert plant.drive_force[2] == pytest.approx(-weight(crane), rel=1e-9)
    assert plant.state[2] - hanging(crane)[2] == pytest.approx(
        0.3 * 0.5 - 0.5 * 0.09 / (0.25 * 9.81), abs=1e-8
    )
    assert abs(plant.balance.imbalance) < 1e-9 * abs(plant.balance.drives)


@SIZES
def test_coupled_drives_hold_their_velocities_or_need_not(crane: Crane) -> None:
    """At random states: no drive is accelerated further, and what gives way is what must."""
    random, bound = np.random.default_rng(5), 0.1
    masses = np.array([crane.bridge_mass, crane.trolley_mass, crane.payload_mass, crane.gravity])
    rig = Rig(*(Drive(velocity_max=bound) for _ in range(3)))
    parameters = rig.parameters(crane, False)
    scale = np.array([masses[:2].sum(), masses[1], masses[2]])
    held = 0
    for _ in range(300):
        state = np.concatenate([
            random.uniform(-1.0, 1.0, 2), [ROPE[crane.trolley_mass]], random.uniform(-0.4, 0.4, 2),
            bound * random.choice([-1.0, 0.5, 1.0], 3), random.uniform(-0.3, 0.3, 2),
        ])
        demand = scale * random.uniform(-2.0, 2.0, 3) - [0.0, 0.0, weight(crane)]
        work = np.zeros((Work.SIZE, Work.COLUMNS))
        work[Work.DEMAND, :3] = demand
        derivative = np.zeros(10)
        forced_derivative(parameters, state, work, derivative)
        force = work[Work.ACTION, :3]
        expected = accelerations(state, force, np.zeros(3), *masses)
        assert derivative[5:] == pytest.approx(expected, rel=1e-9, abs=1e-9)
        fast = np.abs(state[5:8]) >= bound
        away = np.sign(state[5:8]) * derivative[5:8]
        less = np.sign(state[5:8]) * (demand - force) / scale
        assert (force == demand)[~fast].all()
        assert (away[fast] <= 1e-9).all()
        assert (less[fast] >= -1e-9).all()
        assert np.abs(away * less)[fast] == pytest.approx(0.0, abs=1e-9)
        held += int((less > 1e-9).sum())
    assert held > 200


@pytest.mark.parametrize("driven", [False, True])
@SIZES
def test_power_bounds_the_force_of_a_moving_drive(crane: Crane, driven: bool) -> None:
    """Constant power gives v^2 = v0^2 + 2 P t / M, once it is less than the largest force."""
    own, mass = bare(crane), crane.trolley_mass
    force, power = 0.5 * mass, 0.1 * mass
    rig = Rig(trolley=Drive(0.1, force_max=force, power_max=power))
    given = setpoints(own, (0.0, 2.0 * force, 0.0), (0.0, 5.0, 0.0))
    plant = rigged(own, rig, driven=driven, first=given)
    # up to 0.2 m/s by the force, which takes 0.4 s
    for i in range(1, 21):
        plant.step(0.05, given)
        t = 0.05 * i
        expected = 0.5 * t if t <= 0.4 else np.sqrt(0.04 + 0.2 * (t - 0.4))
        assert plant.state[6] == pytest.approx(expected, abs=1e-8)
        assert abs(plant.drive_power[1]) <= power * (1.0 + 1e-9)
        assert plant.saturated.tolist() == [False, True, False]
    # braking has the same bound
    back = setpoints(own, (0.0, -2.0 * force, 0.0), (0.0, -5.0, 0.0))
    plant.step(1e-9, back)
    before = plant.state[6]
    plant.step(0.2, back)
    assert plant.drive_power[1] == pytest.approx(-power, rel=1e-9)
    assert plant.state[6] == pytest.approx(np.sqrt(before**2 - 0.2 * 0.2), abs=1e-8)


def test_hoisting_speed_follows_from_power_and_load() -> None:
    """A hoist of 300 kW lifts 40 t at 0.76 m/s and 10 t at three times that, not faster."""
    for mass in (40e3, 10e3):
        crane = replace(STS, payload_mass=mass)
        # the bare force bound starts it
        rig = Rig(hoist=Drive(0.2, force_max=1.2 * weight(crane), power_max=300e3))
        up = setpoints(crane, velocity=(0.0, 0.0, -0.9 * 300e3 / weight(crane)))
        plant = rigged(crane, rig, driven=True, first=up)
        for _ in range(40):
            plant.step(0.05, up)
            assert abs(plant.drive_power[2]) <= 300e3 * (1.0 + 1e-9)
        assert plant.state[7] == pytest.approx(-0.9 * 300e3 / weight(crane), rel=1e-2)


@SIZES
def test_power_bound_against_scipy_with_a_swinging_load(crane: Crane) -> None:
    length, mass = ROPE[crane.trolley_mass], crane.trolley_mass
    force, power = 0.6 * mass, 0.6 * mass * 0.1 * np.sqrt(length)
    given = setpoints(crane, (0.0, force, 0.0))
    plant = rigged(crane, Rig(trolley=Drive(power_max=power)), driven=False, first=given)
    masses = (crane.bridge_mass, mass, crane.payload_mass, crane.gravity)

    def right(_t: float, x: np.ndarray) -> np.ndarray:
        pushed = min(force, power / max(abs(x[6]), 1e-12))
        net = np.array([0.0, pushed, -weight(crane)])
        return np.concatenate([x[5:], accelerations(x, net, np.zeros(3), *masses)])

    end = 1.5 * np.sqrt(length)
    expected = solve_ivp(
        right, (0.0, end), plant.state, method="DOP853", rtol=1e-11, atol=1e-12,
        max_step=end / 2000,
    ).y[:, -1]
    for _ in range(30):
        plant.step(end / 30, given)
    assert plant.state == pytest.approx(expected, rel=1e-7, abs=1e-8)
