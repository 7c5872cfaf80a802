"""A rope that goes slack and taut again against free flight, for a lab rig and 40 t."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import brentq

from segfmu import Crane, InputError, SimulationError
from segfmu.crane import Drive, Friction, Plant, Rig, Setpoints, TravelLimits
from segfmu.crane.feedback import design

LAB, STS = Crane(2.2, 1.155, 1.0), Crane(300e3, 15e3, 40e3)
SIZES = pytest.mark.parametrize("crane, rope", [(LAB, 1.0), (STS, 20.0)], ids=["lab", "sts"])
FALLS = TravelLimits(slack="free_fall")
LOWERING = 2.0  # acceleration of the drum over gravity


def swinging(
    crane: Crane, rope: float, *, driven: bool, travel: TravelLimits = FALLS, lag: float = 0.0,
    sway: float = 0.0,
) -> tuple[Plant, np.ndarray]:
    """A load that swings in both directions below carriages that move."""
    gains = design(crane, sample_time=0.01, shortest=0.3 * rope, longest=5.0 * rope, rows=2)
    w = np.sqrt(crane.gravity / rope)
    start = np.array(
        [0.1, -0.2, rope, 0.15, -0.1, 0.3, -0.2, 0.2, 0.2 * w, 0.1 * w], dtype=np.float64
    )
    given = Setpoints(
        np.array([0.0, 0.0, -crane.payload_mass * crane.gravity]), start[5:8], start
    )
    rig = Rig(travel=travel, hoist=Drive(lag), friction=Friction(sway=sway))
    return Plant(crane, start, given, gains, driven=driven, enabled=False, rig=rig), start


def load_of(state: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Position of the load relative to the trolley's zero, and direction of the rope."""
    e = np.array([
        np.sin(state[3]), -np.cos(state[3]) * np.sin(state[4]),
        -np.cos(state[3]) * np.cos(state[4]),
    ])
    return np.array([state[0], state[1], 0.0]) + state[2] * e, e


class Flight:
    """The closed form: the load falls freely, carriages move evenly, the drum pays out."""

    def __init__(self, crane: Crane, plant: Plant, start: np.ndarray) -> None:
        self.load, self.start, self.g = plant.load, start, crane.gravity
        self.drum = LOWERING * crane.gravity

    def apart(self, t: float) -> np.ndarray:
        """The load's position relative to the trolley."""
        position, velocity = self.load
        trolley = np.array([*(self.start[:2] + t * self.start[5:7]), 0.0])
        return position + t * velocity - [0.0, 0.0, 0.5 * self.g * t**2] - trolley

    def rope(self, t: float, whole: float) -> tuple[float, float]:
        """Rope paid out and its rate: accelerated for a time, decelerated for the same time."""
        first = min(t, whole)
        rate = self.start[7] + self.drum * first
        length = self.start[2] + self.start[7] * first + 0.5 * self.drum * first**2
        rest = t - first
        return (length + rate * rest - 0.5 * self.drum * rest**2, rate - self.drum * rest)


@SIZES
def test_slack_until_the_load_has_fallen_far_enough(crane: Crane, rope: float) -> None:
    """A drum at twice gravity leaves the load behind; it is caught as the drum brakes."""
    plant, start = swinging(crane, rope, driven=True)
    flight = Flight(crane, plant, start)
    whole = 0.15 * np.sqrt(rope / crane.gravity)
    hoisting = start[5:8] + np.array([0.0, 0.0, flight.drum * whole])

    def missing(t: float) -> float:
        return float(np.linalg.norm(flight.apart(t)) - flight.rope(t, whole)[0])

    caught = brentq(missing, 0.5 * whole, 2.0 * whole, xtol=1e-14)
    assert whole < caught < 2.0 * whole
    hanging = Setpoints(np.zeros(3), hoisting, start)
    plant.step(whole, hanging)
    assert plant.rope_force == 0.0
    position, _ = load_of(plant.state)
    expected = flight.apart(whole) + np.array([*(start[:2] + whole * start[5:7]), 0.0])
    assert position == pytest.approx(expected, rel=1e-9)
    # braking: the rope is taut at the closed form's time, a little later it is not slack
    left = caught - whole + 2e-6
    braking = Setpoints(np.zeros(3), hoisting - [0.0, 0.0, flight.drum * left], start)
    before = plant.balance
    plant.step(left, braking)
    apart, (length, rate) = flight.apart(caught), flight.rope(caught, whole)
    e = apart / length
    velocity = flight.load[1] - [0.0, 0.0, crane.gravity * caught]
    along = float(e @ (velocity - [*start[5:7], 0.0]))
    assert plant.state[2] == pytest.approx(length, rel=1e-5)
    assert plant.state[7] == pytest.approx(rate, abs=1e-5 * flight.drum)
    expected = velocity - (along - rate) * e
    assert plant.load[1] == pytest.approx(expected, abs=1e-5 * flight.drum)
    lost = 0.5 * crane.payload_mass * (along - rate) ** 2
    assert along > rate
    assert plant.balance.dissipated - before.dissipated == pytest.approx(lost, rel=1e-5)
    assert abs(plant.balance.imbalance) < 1e-8 * crane.payload_mass * crane.gravity * rope


@SIZES
def test_flight_and_catch_do_not_depend_on_the_step(crane: Crane, rope: float) -> None:
    """Through a slack rope and afterwards, with lag and damped sway; energy is balanced."""
    ends = []
    time = 0.4 * np.sqrt(rope / crane.gravity)
    for steps in (1, 7, 100):
        plant, start = swinging(crane, rope, driven=True, lag=0.1 * time, sway=0.01 * rope)
        fast = start[5:8] + np.array([0.0, 0.0, 3.0 * crane.gravity * time])
        before = start[5:8]
        for goal in (fast, start[5:8], start[5:8]):
            for share in np.arange(1, steps + 1) / steps:
                given = Setpoints(np.zeros(3), before + share * (goal - before), start)
                plant.step(time / steps, given)
            before = goal
        assert abs(plant.balance.imbalance) < 1e-7 * crane.payload_mass * crane.gravity * rope
        assert plant.balance.dissipated > 1e-3 * crane.payload_mass * crane.gravity * rope
        assert plant.rope_force < 0.0
        ends.append(plant.state)
    assert ends[1] == pytest.approx(ends[0], rel=1e-5, abs=1e-5 * rope)
    assert ends[2] == pytest.approx(ends[0], rel=1e-5, abs=1e-5 * rope)


@SIZES
def test_a_force_drive_does_not_push(crane: Crane, rope: float) -> None:
    """Pushed or let go, the load falls freely and the drum follows it; no drive does work on it."""
    plant, start = swinging(crane, rope, driven=False, sway=0.01 * rope)
    (position, velocity), trolley = plant.load, start[5:7]
    time = 0.3 * np.sqrt(rope / crane.gravity)
    push = Setpoints(np.array([0.0, 0.0, 5.0 * crane.payload_mass]), start[5:8], start)
    plant.step(1e-9 * time, push)
    plant.step(time, push)
    t = time * (1.0 + 1e-9)
    fallen = position + t * velocity - [0.0, 0.0, 0.5 * crane.gravity * t**2]
    assert plant.load[0] == pytest.approx(fallen, abs=1e-7 * rope)
    assert plant.rope_force == 0.0
    assert plant.state[5:7] == pytest.approx(trolley, abs=1e-7)
    assert plant.balance.drives == pytest.approx(0.0, abs=1e-7 * crane.payload_mass * rope)
    assert abs(plant.balance.imbalance) < 1e-8 * crane.payload_mass * crane.gravity * rope


@SIZES
@pytest.mark.parametrize("driven", [True, False])
def test_an_error_by_default(crane: Crane, rope: float, driven: bool) -> None:
    plant, start = swinging(crane, rope, driven=driven, travel=TravelLimits())
    given = Setpoints(
        np.array([0.0, 0.0, crane.payload_mass]), start[5:8] + np.array([0.0, 0.0, 9.0 * rope]),
        start,
    )
    with pytest.raises(SimulationError, match="slack"):
        plant.step(0.3 * np.sqrt(rope / crane.gravity), given)


def test_another_word() -> None:
    with pytest.raises(InputError, match="error or free_fall, got 'loose'"):
        TravelLimits(slack="loose")  # type: ignore[arg-type]
