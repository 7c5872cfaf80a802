"""The feedback on a ship-to-shore crane: bridge 300 t, load 40 t, rope 14 to 32 m, slow drives."""

from __future__ import annotations

from functools import cache
from itertools import product

import numpy as np
import pytest

from segfmu import Crane, FlatInverse, Limits, Waypoint, plan
from segfmu.crane import (
    Compensation,
    Drive,
    Feedforward,
    Gust,
    Plant,
    Rig,
    Sensors,
    Setpoints,
    Wind,
)
from segfmu.crane.feedback import design
from segfmu.crane.flat_feedback import design_flat
from segfmu.crane.observer import Uncertainty, design_observer
from segfmu.crane.stability import largest_eigenvalue
from segfmu.crane.tracking import TrackingController
from tests.campaign import soaked, soaked_rows

SHIP, LAB = Crane(300e3, 15e3, 40e3), Crane(2.2, 1.155, 1.0)
LAG, PERIOD, MOST = 0.2, 0.01, 0.8
# 1 mm, and 12 bits in a turn: 49 mm of the load at 32 m
STEPS = (1e-3, 1e-3, 2.0 * np.pi / 4096.0)
SENSORS = Sensors(
    sample_time=PERIOD, dead_time=PERIOD, resolution=(STEPS[0],) * 3 + (STEPS[2],) * 2
)
DESIGNS = {"lqr": design, "flatness": design_flat}
SWAY = np.radians([0.0, 0.0, 0.0, 5.0, 5.0, 0.0, 0.0, 0.0, 0.0, 0.0])
CASES = {
    "undisturbed": {},
    "gust": {"wind": Wind(gust=Gust(5.0, 6.0, (0.0, 20e3, 0.0)))},
    "wind": {"wind": Wind(constant=(0.0, 9e3, 0.0))},
    "sway": {"start": SWAY},
}


def controller(
    crane: Crane, kind: str, lag: float, ropes: tuple[float, float], delayed: float = 1.0,
    period: float = PERIOD, **options,
) -> TrackingController:
    """Feedback that is awake from the start and knows lag and delay."""
    ranges = {"sample_time": period, "shortest": ropes[0], "longest": ropes[1], "driven": True}
    observer = design_observer(
        crane, lag=(lag,) * 3, delayed=delayed, uncertainty=Uncertainty(*STEPS, wake=0.0),
        **ranges,
    )
    gains = DESIGNS[kind](crane, lag=lag, dead_time=delayed * period, **ranges)
    return TrackingController(observer, gains, **options)


@cache
def inverse(hoisting: bool) -> FlatInverse:
    """45 m, within 0.8 m/s2 of the trolley."""
    limits = Limits([0.5, 4.0, 1.0], [0.2, 0.45, 0.25], [0.2, 0.2, 0.2], [0.2, 0.1, 0.1])
    rope = (32.0, 15.0) if hoisting else (30.0, 30.0)
    points = [Waypoint([0.0, 0.0, -rope[0]]), Waypoint([float(hoisting), 45.0, -rope[1]])]
    return FlatInverse(SHIP, plan(points, limits))


def last_error(kind: str, hoisting: bool, start=None, wind: Wind | None = None) -> float:
    """Largest horizontal error of the load [m] in the last 10 s."""
    flat, step = inverse(hoisting), 0.02
    feedforward = Feedforward(flat, Compensation((LAG,) * 3))
    times = np.arange(0.0, flat.trajectory.duration + 40.0, step)
    velocities, states = feedforward.velocity(times), feedforward.state(times)
    drive = Drive(LAG, acceleration_max=MOST)
    plant = Plant(
        SHIP, states[0] + (0.0 if start is None else start),
        Setpoints(velocity=velocities[0], reference=states[0]),
        controller(SHIP, kind, LAG, (12.0, 34.0), lower=[-MOST] * 3, upper=[MOST] * 3),
        driven=True, rig=Rig(drive, drive, drive, sensors=SENSORS, wind=wind or Wind()),
    )
    errors = []
    for velocity, state, load in zip(velocities, states, feedforward.load(times), strict=True):
        plant.step(step, Setpoints(velocity=velocity, reference=state))
        errors.append(np.hypot(*(plant.load[0] - load)[:2]))
    # the crane is one step behind the setpoints that it was given first
    return float(max(errors[-round(10.0 / step) :]))


@pytest.mark.parametrize("hoisting", [False, True], ids=["level", "hoisting"])
@pytest.mark.parametrize("case", CASES)
@pytest.mark.parametrize("kind", DESIGNS)
def test_it_does_not_hunt_between_steps_of_its_encoder(
    kind: str, case: str, hoisting: bool
) -> None:
    assert last_error(kind, hoisting, **CASES[case]) < 15e-3


LAGGED = [(0.0, 0.0), (0.0, 3.0), (0.02, 1.0), (0.1, 2.4), (0.3, 1.0), (0.5, 0.0), (0.5, 3.0)]


# each lag and each delay, both ends of one with both of the other
@pytest.mark.parametrize(("lag", "delayed"), [
    *LAGGED,
    *soaked_rows(*(
        case for case in product([0.0, 0.02, 0.1, 0.3, 0.5], [0.0, 1.0, 2.4, 3.0])
        if case not in LAGGED
    )),
])
@pytest.mark.parametrize("kind", DESIGNS)
def test_it_is_stable_with_any_lag_and_delay_at_both_sizes(
    kind: str, delayed: float, lag: float
) -> None:
    for crane, ropes in ((LAB, (0.16, 1.5)), (SHIP, (14.0, 32.0))):
        loop = controller(crane, kind, lag, ropes, delayed)
        for length in np.geomspace(*ropes, 4):
            payload = crane.payload_mass
            assert largest_eigenvalue(loop, float(length), payload, (lag,) * 3) < 0.999


@pytest.mark.parametrize("delayed", [0.3, 2.5, *soaked(1.4, 2.4)])
@pytest.mark.parametrize("kind", DESIGNS)
def test_it_is_stable_with_long_samples_and_any_part_of_one(kind: str, delayed: float) -> None:
    """50 ms are 0.4 rad of the shortest pendulum of the lab rig."""
    for lag in (0.0, 0.02, 0.5):
        loop = controller(LAB, kind, lag, (0.16, 1.5), delayed, period=0.05)
        for length in np.geomspace(0.16, 1.5, 5):
            assert largest_eigenvalue(loop, float(length), 1.0, (lag,) * 3) < 0.998


@pytest.mark.parametrize("cause", ["wind", "sensor"])
def test_a_wrong_zero_of_the_angle_is_what_the_user_says(cause) -> None:
    """Half a degree: the carriage makes room for a wind, and stays for a sensor."""
    zero, rope = np.radians(0.5), 32.0
    rest = SHIP.hanging([0.0, 0.0, -rope])
    drive = Drive(LAG, acceleration_max=MOST)
    plant = Plant(
        SHIP, rest, Setpoints(reference=rest),
        controller(SHIP, "flatness", LAG, (12.0, 34.0), 0.0, lower=[-MOST] * 3,
                   upper=[MOST] * 3, offset_cause=cause),
        driven=True,
        rig=Rig(drive, drive, drive, sensors=Sensors(offset=(0.0, 0.0, 0.0, 0.0, zero))),
    )
    for _ in range(6000):
        plant.step(PERIOD, Setpoints(reference=rest))
    aside = abs(float(plant.load[0][1]))
    assert aside == pytest.approx(rope * zero if cause == "wind" else 0.0, abs=5e-3)
