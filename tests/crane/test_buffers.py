"""Buffers at the end stops against closed forms and SciPy, for a lab rig and 40 t."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from segfmu import Crane, SimulationError
from segfmu.crane import Plant, Rig, Setpoints, TravelLimits
from segfmu.crane.feedback import design
from segfmu.kernels.crane.buffers import buffer_force, buffer_slopes
from segfmu.kernels.crane.records import Plant as Parameters

LAB, STS = Crane(2.2, 1.155, 1.0), Crane(300e3, 15e3, 40e3)
SIZES = pytest.mark.parametrize("crane", [LAB, STS], ids=["lab", "sts"])


def rolling(crane: Crane, axis: int, speed: float, travel: TravelLimits) -> tuple[Plant, Setpoints]:
    """A bare crane whose carriage rolls against its end stop without a drive."""
    own = replace(crane, payload_mass=1e-9 * crane.payload_mass)
    gains = design(own, sample_time=0.01, shortest=1.0, longest=5.0, rows=2)
    start = own.hanging([0.0, 0.0, -5.0])
    start[5 + axis] = speed
    given = Setpoints(np.array([0.0, 0.0, -own.payload_mass * own.gravity]), reference=start)
    return Plant(own, start, given, gains, enabled=False, rig=Rig(travel=travel)), given


def mass_of(crane: Crane, axis: int) -> float:
    return crane.trolley_mass + (crane.bridge_mass if axis == 0 else 0.0)


@pytest.mark.parametrize("axis", [0, 1])
@pytest.mark.parametrize("side", [-1.0, 1.0])
@SIZES
def test_a_spring_sends_a_carriage_back(crane: Crane, side: float, axis: int) -> None:
    """Contact takes half a period, pi / w, and reaches v / w; the energy comes back."""
    mass, speed, w = mass_of(crane, axis), 0.4, 20.0
    stiffness = np.zeros(3)
    stiffness[axis] = mass * w**2
    room = (-0.1, 0.1)
    travel = TravelLimits(
        **{("bridge", "trolley")[axis]: room}, stiffness=tuple(stiffness)
    )
    plant, given = rolling(crane, axis, side * speed, travel)
    contact = 0.1 / speed
    plant.step(contact + 0.5 * np.pi / w, given)
    assert plant.state[axis] == pytest.approx(side * (0.1 + speed / w), abs=1e-8)
    assert plant.state[5 + axis] == pytest.approx(0.0, abs=1e-7)
    assert plant.balance.dissipated == pytest.approx(0.5 * mass * speed**2, rel=1e-6)
    plant.step(0.5 * np.pi / w + contact, given)
    assert plant.state[axis] == pytest.approx(0.0, abs=1e-7)
    assert plant.state[5 + axis] == pytest.approx(-side * speed, abs=1e-7)
    assert abs(plant.balance.imbalance) < 1e-7 * mass * speed**2


@SIZES
def test_a_damped_buffer_never_pulls(crane: Crane) -> None:
    """Spring and damper until their force is zero, which is before the way back is done."""
    mass, speed, w, share = mass_of(crane, 1), 0.5, 15.0, 0.4
    travel = TravelLimits(
        trolley=(-1.0, 0.05), stiffness=(0.0, mass * w**2, 0.0),
        damping=(0.0, 2.0 * share * w * mass, 0.0),
    )
    plant, given = rolling(crane, 1, speed, travel)

    def right(_t: float, x: np.ndarray) -> np.ndarray:
        force = w**2 * (x[0] - 0.05) + 2.0 * share * w * x[1]
        return np.array([x[1], -force])

    def done(_t: float, x: np.ndarray) -> float:
        return w**2 * (x[0] - 0.05) + 2.0 * share * w * x[1]

    done.terminal, done.direction = True, -1
    pressed = solve_ivp(
        right, (0.0, 2.0), [0.05, speed], method="DOP853", rtol=1e-12, atol=1e-13, events=done
    )
    leaves, (position, velocity) = pressed.t[-1], pressed.y[:, -1]
    assert position > 0.05
    plant.step(0.1 + leaves + 0.2, given)
    assert plant.state[6] == pytest.approx(velocity, abs=1e-7)
    assert plant.state[1] == pytest.approx(position + 0.2 * velocity, abs=1e-7)
    lost = 0.5 * mass * (speed**2 - velocity**2)
    assert plant.balance.dissipated == pytest.approx(lost, rel=1e-6)


@SIZES
def test_a_velocity_drive_presses_its_buffer(crane: Crane) -> None:
    """It comes to its setpoint's place, and needs the force of the spring for it."""
    travel = TravelLimits(trolley=(-1.0, 0.02), stiffness=(0.0, 3.0 * crane.trolley_mass, 0.0))
    gains = design(crane, sample_time=0.01, shortest=1.0, longest=5.0, rows=2, driven=True)
    start = crane.hanging([0.0, 0.0, -5.0])
    given = Setpoints(velocity=np.array([0.0, 0.05, 0.0]), reference=start)
    plant = Plant(
        crane, start, given, gains, driven=True, enabled=False, rig=Rig(travel=travel)
    )
    for _ in range(100):
        plant.step(0.01, given)
    still = plant.drive_force[1] - 3.0 * crane.trolley_mass * (plant.state[1] - 0.02)
    free = Plant(crane, start, given, gains, driven=True, enabled=False)
    for _ in range(100):
        free.step(0.01, given)
    assert plant.state == pytest.approx(free.state, abs=1e-10)
    assert still == pytest.approx(free.drive_force[1], abs=1e-7 * crane.trolley_mass)


def test_other_end_stops_stay_errors() -> None:
    travel = TravelLimits(
        bridge=(-0.1, 0.1), trolley=(-0.1, 0.1), stiffness=(100.0, 0.0, 0.0)
    )
    plant, given = rolling(LAB, 1, 0.5, travel)
    with pytest.raises(SimulationError, match=r"trolley at 0\.1 m is at its end stop"):
        plant.step(1.0, given)


@pytest.mark.parametrize("side", [-1.0, 1.0])
def test_a_buffer_pushes_inwards_at_both_ends(side: float) -> None:
    own = np.zeros(Parameters.SIZE)
    own[Parameters.TRAVEL_MIN], own[Parameters.TRAVEL_MAX] = -1.0, 1.0
    own[Parameters.STIFFNESS], own[Parameters.DAMPING] = 100.0, 10.0
    for velocity in (0.5, 0.0, -0.05, -0.5):
        found = buffer_force(own, 0, side * 1.01, side * velocity)
        assert found == pytest.approx(side * max(1.0 + 10.0 * velocity, 0.0), abs=1e-12)
        slopes = buffer_slopes(own, 0, side * 1.01, side * velocity)
        assert slopes == ((100.0, 10.0) if found != 0.0 else (0.0, 0.0))
    assert buffer_force(own, 0, side * 0.99, side * 0.5) == 0.0
