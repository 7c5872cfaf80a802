"""What the feedback may add to a plan: what the drive can do, and never a push on the rope."""

from __future__ import annotations

import numpy as np
import pytest

from segfmu.kernels.control.bounds import (
    bound_correction,
    greatest_correction,
    least_correction,
    return_effort,
    return_room,
    top_speed,
)
from segfmu.kernels.control.records import GainInputs, Gains, Situation, Tick, Tracking
from segfmu.kernels.crane.records import Axes, DriveMode, State

WEIGHT, GRAVITY, LENGTH = 40e3 * 9.81, 9.81, 20.0
MASS = 15e3


def parameters(mode: int, **changes: float) -> np.ndarray:
    """Drives without bounds."""
    found = np.zeros(Tracking.SIZE)
    found[Tracking.MODE], found[Tracking.GRAVITY], found[Tracking.PERIOD] = mode, GRAVITY, 0.1
    found[Tracking.MASSES : Tracking.MASSES + 3] = 300e3, MASS, 40e3
    found[Tracking.LEAST : Tracking.LEAST + 3] = -1e99
    found[Tracking.GREATEST : Tracking.GREATEST + 3] = 1e99
    for name, value in changes.items():
        found[getattr(Tracking, name) : getattr(Tracking, name) + 3] = value
    return found


def situation(velocity: float = 0.0) -> np.ndarray:
    found = np.zeros(Situation.SIZE)
    found[Situation.WEIGHT], found[Situation.LENGTH] = WEIGHT, LENGTH
    found[Situation.VELOCITY : Situation.VELOCITY + 3] = velocity
    return found


def tick(added_to: float = 0.0, correction: float = 0.0) -> np.ndarray:
    found = np.zeros((Tick.SIZE, max(Tick.COLUMNS, 3)))
    found[Tick.ADDED_TO, :3], found[Tick.CORRECTION, :3] = added_to, correction
    return found


@pytest.mark.parametrize("planned", [-1.5, -1.0, -0.11, -0.05])
def test_the_hoist_never_pushes_the_rope(planned: float) -> None:
    """A tenth of the weight stays; a plan that leaves less is not disturbed."""
    row = tick(planned * WEIGHT, 10.0 * WEIGHT)
    bound_correction(Axes.ROPE, parameters(DriveMode.FORCE), row, situation())
    told = row[Tick.ADDED_TO, Axes.ROPE] + row[Tick.CORRECTION, Axes.ROPE]
    assert told == pytest.approx(max(-0.1, planned) * WEIGHT)


def test_carriages_push_both_ways() -> None:
    own = parameters(DriveMode.FORCE, LEAST=-5.0, GREATEST=7.0)
    for axis in (Axes.BRIDGE, Axes.TROLLEY):
        assert least_correction(axis, own, tick(2.0), situation()) == -7.0
        assert greatest_correction(axis, own, tick(2.0), situation()) == 5.0
        # a plan that asks for more than there is stays as it is
        assert greatest_correction(axis, own, tick(8.0), situation()) == 0.0
        assert least_correction(axis, own, tick(-6.0), situation()) == 0.0


@pytest.mark.parametrize("velocity", [-2.0, 0.5])
def test_power_bounds_forces(velocity: float) -> None:
    own = parameters(DriveMode.FORCE, POWER_MAX=1000.0)
    for axis in (Axes.BRIDGE, Axes.TROLLEY):
        most = 1000.0 / abs(velocity)
        assert greatest_correction(axis, own, tick(), situation(velocity)) == pytest.approx(most)
        assert least_correction(axis, own, tick(), situation(velocity)) == pytest.approx(-most)


def test_power_bounds_accelerations() -> None:
    """By the mass that moves: the load's too, and for the hoist beyond holding it."""
    power, velocity = 2e6, 0.8
    own = parameters(DriveMode.VELOCITY, POWER_MAX=power)
    force = power / velocity
    found = -least_correction(Axes.TROLLEY, own, tick(), situation(velocity))
    assert found == pytest.approx(force / (MASS + 40e3))
    found = -least_correction(Axes.ROPE, own, tick(), situation(velocity))
    assert found == pytest.approx(force / 40e3 - GRAVITY)
    # one that is too fast to be held is braked nevertheless
    fast = situation(100.0 * velocity)
    assert -least_correction(Axes.ROPE, own, tick(), fast) == pytest.approx(1e-3 * GRAVITY)


def test_a_hoist_is_no_faster_than_it_can_hold_the_load() -> None:
    own = parameters(DriveMode.VELOCITY, POWER_MAX=1e6, VELOCITY_MAX=4.0)
    assert top_speed(Axes.TROLLEY, 1.0, own, situation()) == 4.0
    assert top_speed(Axes.ROPE, 1.0, own, situation()) == pytest.approx(1e6 / WEIGHT)
    own = parameters(DriveMode.VELOCITY, VELOCITY_MAX=4.0)
    assert top_speed(Axes.ROPE, 1.0, own, situation()) == 4.0
    assert top_speed(Axes.ROPE, 1.0, parameters(DriveMode.VELOCITY), situation()) == 1e99


def test_velocities_are_bounded_by_their_direction() -> None:
    own = parameters(DriveMode.VELOCITY, VELOCITY_MAX=4.0, VELOCITY_MIN=-2.0)
    assert top_speed(Axes.BRIDGE, 1.0, own, situation()) == 4.0
    assert top_speed(Axes.BRIDGE, -1.0, own, situation()) == 2.0
    for asked, velocity, expected in (
        (-1e3, 0.0, -20.0), (-1e3, -1.5, -5.0), (-1e3, -2.5, 0.0), (1e3, -2.5, 65.0),
        (1e3, 3.5, 5.0),
    ):
        row = tick(0.0, asked)
        bound_correction(Axes.BRIDGE, own, row, situation(velocity))
        assert row[Tick.CORRECTION, Axes.BRIDGE] == pytest.approx(expected)


@pytest.mark.parametrize(("velocity", "expected"), [(0.0, 40.0), (3.5, 5.0), (4.5, 0.0)])
def test_a_correction_does_not_pass_the_drives_velocity(velocity: float, expected) -> None:
    own = parameters(DriveMode.VELOCITY, VELOCITY_MAX=4.0)
    for sign in (1.0, -1.0):
        row = tick(0.0, sign * 1e3)
        bound_correction(Axes.BRIDGE, own, row, situation(sign * velocity))
        assert row[Tick.CORRECTION, Axes.BRIDGE] == pytest.approx(sign * expected)


@pytest.mark.parametrize("mode", [DriveMode.FORCE, DriveMode.VELOCITY])
@pytest.mark.parametrize("axis", [Axes.BRIDGE, Axes.TROLLEY])
def test_the_way_back_has_room_for_what_the_sway_takes_from_it(axis: int, mode: int) -> None:
    """A load at -a / g is opposed with its gain; so much more the way back may ask for."""
    gains = np.zeros((1, Gains.AXES + 3, max(GainInputs.SIZE, Gains.COLUMNS, State.SIZE)))
    sign = 1.0 if axis == Axes.BRIDGE else -1.0
    place, angle = 3e3, -sign * 7e5
    gains[0, Gains.AXES + axis, State.POSITION + axis] = place
    gains[0, Gains.AXES + axis, State.ANGLE + axis] = angle
    own = parameters(mode)
    moved = own[Tracking.MASSES + axis] * GRAVITY + WEIGHT if mode == DriveMode.FORCE else GRAVITY
    opposed = LENGTH * place + 7e5
    assert return_room(axis, own, gains, situation()) == pytest.approx(
        return_effort() * (1.0 + opposed / moved)
    )
    # gains that do not oppose take nothing away
    assert return_room(axis, own, -gains, situation()) == return_effort()
    assert return_room(Axes.ROPE, own, gains, situation()) == 1.0
