"""Feedforward alone on the perfect model: the error over the step; lag compensated."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

import segfmu
from segfmu.crane import Drive, Plant, Rig, Setpoints
from segfmu.crane.feedback import design
from segfmu.crane.feedforward import Compensation, Feedforward

LAB = segfmu.Crane(2.2, 1.155, 1.0)
LAG = (0.025, 0.025, 0.025)


@cache
def inverse(smoothness: int = 6, shape: str = "smoothstep") -> segfmu.FlatInverse:
    """A diagonal move with hoisting, in the ranges of the rig."""
    limits = segfmu.Limits([0.22, 0.22, 0.2], 0.3, 0.8, 6.0)
    points = [segfmu.Waypoint([-0.25, -0.3, -0.8]), segfmu.Waypoint([0.25, 0.3, -0.7])]
    trajectory = segfmu.plan(points, limits, smoothness=smoothness, shape=shape)
    return segfmu.FlatInverse(LAB, trajectory)


def largest_error(
    step: float,
    compensation: Compensation,
    flat: segfmu.FlatInverse | None = None,
    *,
    events: bool = False,
    driven: bool = False,
    settle: float = 0.0,
) -> float:
    """Largest distance of the load from its plan [m], setpoints linear between steps."""
    flat = flat or inverse()
    feedforward = Feedforward(flat, compensation)
    trajectory = flat.trajectory
    times = np.arange(int((trajectory.duration + settle) / step) + 1) * step
    if events:
        times = np.union1d(times, trajectory.events)
    forces, velocities = feedforward.force(times), feedforward.velocity(times)
    states, planned = flat.state(times), trajectory(times)
    drive = Drive(LAG[0] if driven else 0.0)
    rig = Rig(drive, drive, drive)
    feedback = design(LAB, sample_time=0.1, shortest=0.5, longest=1.0, rows=2)
    plant = Plant(
        LAB, states[0], Setpoints(forces[0], velocities[0]), feedback, driven=driven,
        enabled=False, rig=rig,
    )
    largest = 0.0
    for length, force, velocity, load in zip(
        np.diff(times), forces[1:], velocities[1:], planned[1:], strict=True
    ):
        plant.step(length, Setpoints(force, velocity))
        largest = max(largest, float(np.linalg.norm(plant.load[0] - load)))
    return largest


def test_force_mode_error_at_1_ms_and_its_order() -> None:
    steps = np.array([8e-3, 4e-3, 2e-3, 1e-3])
    errors = [largest_error(step, Compensation()) for step in steps]
    assert errors[-1] < 1e-6
    order = np.polyfit(np.log(steps), np.log(errors), 1)[0]
    assert order > 1.99


@pytest.mark.parametrize("shape", ["plateau", "smoothstep"])
def test_force_mode_of_smoothness_4_with_steps_that_end_at_its_kinks(shape: str) -> None:
    """The rate of the forces jumps at the plan's events; between them it is smooth."""
    found = inverse(4, shape)
    steps = np.array([4e-3, 2e-3, 1e-3])
    errors = [largest_error(step, Compensation(), found, events=True) for step in steps]
    assert errors[-1] < 1e-6
    assert np.polyfit(np.log(steps), np.log(errors), 1)[0] > 1.95
    assert largest_error(1e-3, Compensation(), found) > 2.0 * errors[-1]


def test_velocity_mode_with_lag_compensated() -> None:
    assert largest_error(1e-3, Compensation(LAG), driven=True, settle=1.0) < 1e-6
    # and without: what a lag of 25 ms makes at 0.2 m/s
    assert largest_error(1e-3, Compensation(), driven=True, settle=1.0) > 4e-3


SHIP = segfmu.Crane(300e3, 15e3, 40e3)


@cache
def ship_to_shore() -> segfmu.FlatInverse:
    """45 m at 30 m of rope, bridge and trolley, with hoisting on the way."""
    limits = segfmu.Limits([0.5, 4.0, 1.0], [0.2, 0.6, 0.3], [0.2, 0.4, 0.3], [0.2, 0.4, 0.3])
    points = [segfmu.Waypoint([0.0, 0.0, -30.0]), segfmu.Waypoint([3.0, 45.0, -20.0])]
    return segfmu.FlatInverse(SHIP, segfmu.plan(points, limits))


@pytest.mark.parametrize("dead", [(0.02, 0.02, 0.02), (0.0, 0.35, 0.02)])
def test_velocity_drives_with_lag_and_dead_time(dead) -> None:
    """A ship-to-shore crane of lag 0.2 s: within 1 mm, and far off without compensation."""
    lag = (0.2, 0.2, 0.3)
    assert late_error(Compensation(lag, dead_time=dead), lag, dead) < 1e-3
    assert late_error(Compensation(), lag, dead) > 0.4


def late_error(compensation: Compensation, lag, dead) -> float:
    """Largest distance of the load from its plan [m], with drives that act a dead time late."""
    flat, step = ship_to_shore(), 0.01
    feedforward = Feedforward(flat, compensation)
    times = np.arange(int((flat.trajectory.duration + 10.0) / step)) * step
    arriving = np.stack(
        [feedforward.velocity(times - d)[:, i] for i, d in enumerate(dead)], axis=1
    )
    states, planned = feedforward.state(times), feedforward.load(times)
    feedback = design(SHIP, sample_time=0.1, shortest=10.0, longest=40.0, rows=2)
    plant = Plant(
        SHIP, states[0], Setpoints(velocity=arriving[0]), feedback, driven=True, enabled=False,
        rig=Rig(*(Drive(t) for t in lag)),
    )
    largest = 0.0
    for velocity, load in zip(arriving[1:], planned[1:], strict=True):
        plant.step(step, Setpoints(velocity=velocity))
        largest = max(largest, float(np.linalg.norm(plant.load[0] - load)))
    return largest


def test_shapes_and_single_times() -> None:
    feedforward = Feedforward(inverse(), Compensation(LAG))
    assert feedforward.force(0.5).shape == feedforward.velocity(0.5).shape == (3,)
    assert feedforward.force(np.zeros((2, 4))).shape == (2, 4, 3)
    times = np.array([0.4, 1.3])
    expected = inverse().velocity(times) + 0.025 * inverse().acceleration(times)[:, :3]
    assert feedforward.velocity(times) == pytest.approx(expected)
    assert feedforward.force(times) == pytest.approx(inverse().force(times))


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"lag": (0.1, -0.1, 0.0)}, "lag of the trolley"),
        ({"lag": (np.inf, 0.0, 0.0)}, "lag"),
        ({"lag": (1.0, 0.0)}, "must have 3 values"),
        ({"dead_time": (0.0, 0.0, -0.1)}, "dead_time of the hoist"),
    ],
)
def test_bad_values_are_refused(arguments, message: str) -> None:
    with pytest.raises(segfmu.InputError, match=message):
        Compensation(**arguments)
