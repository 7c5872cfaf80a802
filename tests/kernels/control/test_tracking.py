"""One tick of the tracking controller, with an observer and gains of a few numbers."""

from __future__ import annotations

import numpy as np
import pytest

from segfmu.kernels.control.records import (
    AxisTable,
    Estimate,
    Fading,
    Gains,
    Held,
    Observer,
    OffsetCause,
    Tracker,
    Tracking,
    VelocityCommand,
)
from segfmu.kernels.control.records import Tick as Records
from segfmu.kernels.control.tracking import track_deviation, track_hoist, track_setpoint
from segfmu.kernels.crane.records import Axes, Coordinates, State

REFERENCE = np.array([0.5, -0.2, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0])
FEEDFORWARD = np.array([1.0, 0.0, -9.81])
LEAST = slice(Tracking.LEAST, Tracking.GREATEST)
GREATEST = slice(Tracking.GREATEST, Tracking.GAINS_PAYLOAD)
STIFFNESS = np.array([4.0, 5.0, 6.0])


class Tick:
    """An observer that keeps positions as measured, and proportional gains."""

    def __init__(self, driven: bool = False, tolerance: float = 0.0) -> None:
        self.parameters = np.zeros(Tracking.SIZE)
        self.parameters[: Tracking.REJECTED_DRIFT] = driven, 0.01, 0.0, 3.0, 1.0, 1.0, 9.81
        self.parameters[Tracking.ENABLED], self.parameters[Tracking.FADE] = 1.0, 0.1
        self.parameters[LEAST], self.parameters[GREATEST] = -1e99, 1e99
        self.parameters[Tracking.GAINS_PAYLOAD] = 1.0
        self.parameters[Tracking.WAKE_POSITION : Tracking.OFFSET_EXPECTED] = tolerance
        self.table = np.zeros((1, Observer.SIZE, Observer.COLUMNS))
        self.gains = np.zeros((1, Gains.SIZE, Gains.COLUMNS))
        for axis in range(3):
            position = self.table[0, Observer.BRIDGE + Estimate.SIZE * axis]
            position[AxisTable.POSITION] = position[AxisTable.POSITION_GAIN] = 1.0
            self.gains[0, Gains.AXES + axis, axis] = STIFFNESS[axis]
        self.memory = np.zeros((Tracker.SIZE, Tracker.COLUMNS))

    def __call__(self, deviation) -> np.ndarray:
        tick = np.zeros((Records.SIZE, Records.COLUMNS))
        tick[Records.SIGNALS, :5] = REFERENCE[:5] + np.append(deviation, [0.0, 0.0])
        tick[Records.REFERENCE], tick[Records.ADDED_TO, :3] = REFERENCE, FEEDFORWARD
        track_setpoint(self.parameters, self.table, self.gains, tick, self.memory)
        return tick[Records.CORRECTION, :3]


@pytest.mark.parametrize("driven", [False, True])
def test_the_correction_is_the_gain_on_the_deviation(driven: bool) -> None:
    tick, deviation = Tick(driven), np.array([0.1, -0.2, 0.05])
    for _ in range(3):
        assert tick(deviation) == pytest.approx(-STIFFNESS * deviation)


def test_the_setpoint_with_feedforward_stays_within_its_limits() -> None:
    tick = Tick()
    tick.parameters[LEAST], tick.parameters[GREATEST] = [-2.0, -0.5, -10.0], [1.2, 0.5, 0.0]
    assert FEEDFORWARD + tick([-1.0, 1.0, 1.0]) == pytest.approx([1.2, -0.5, -10.0])
    # what the observer is told is what happens
    assert tick.memory[Tracker.HELD, :2] == pytest.approx([0.2, -0.5])


def test_below_the_steps_of_the_sensors_it_sleeps_and_above_it_wakes_for_good() -> None:
    tick = Tick(tolerance=0.1)
    assert tick([0.09, -0.09, 0.09]).tolist() == [0.0, 0.0, 0.0]
    assert tick([0.0, -0.11, 0.0]) == pytest.approx([0.0, 0.55, 0.0])
    assert tick([0.05, 0.0, 0.0]) == pytest.approx([-0.2, 0.0, 0.0])


def test_switched_off_the_correction_fades() -> None:
    tick, deviation = Tick(), [0.1, 0.0, 0.0]
    tick.parameters[Tracking.DECAY] = 0.5
    assert tick(deviation)[0] == pytest.approx(-0.4)
    tick.parameters[Tracking.ENABLED] = 0.0
    tick.memory[Tracker.COMMAND, VelocityCommand.SWITCHED] = 1.0
    assert [tick(deviation)[0] for _ in range(3)] == pytest.approx([-0.2, -0.1, -0.05])


@pytest.mark.parametrize("tolerance", [0.0, 0.1])
@pytest.mark.parametrize("driven", [False, True])
def test_what_setpoints_ask_beyond_the_drives_is_not_corrected(
    driven: bool, tolerance: float
) -> None:
    """Awake or not: without a deviation nothing is to be done, and corrections may only help."""
    tick = Tick(driven, tolerance)
    tick.parameters[LEAST], tick.parameters[GREATEST] = -0.6, 0.6
    for _ in range(3):
        assert tick([0.0, 0.0, 0.0]).tolist() == [0.0, 0.0, 0.0]
    assert tick([-0.2, 0.0, 0.0])[0] == 0.0
    assert tick([0.2, 0.0, 0.0])[0] == pytest.approx(-0.8)


def test_switched_off_the_velocity_that_was_added_fades() -> None:
    tick = Tick(driven=True)
    for _ in range(10):
        tick([0.1, 0.0, 0.0])
    tick.parameters[Tracking.ENABLED] = 0.0
    added = tick.memory[Tracker.COMMAND, 0]
    for _ in range(100):
        tick([0.1, 0.0, 0.0])
    assert added < -0.03
    # a fading of 0.1 s for 1 s
    assert tick.memory[Tracker.COMMAND, 0] == pytest.approx(added * np.exp(-10.0), rel=0.7)


def test_the_payload_is_estimated_from_what_holds_it() -> None:
    """A rope that would sink under m g is held by m (g - v) / g when v is asked for throughout."""
    tick = Tick()
    tick.parameters[Tracking.PAYLOAD_SHARE] = 0.02
    found = []
    for _ in range(1000):
        # the deviation that makes the feedback ask for what a load of 1.5 kg needs
        force = -9.81 * (1.0 + tick.memory[Tracker.FADING, Fading.PAYLOAD])
        missing = (force + 1.5 * 9.81) / 1.5
        tick([0.0, 0.0, missing / STIFFNESS[2]])
        found.append(1.0 + tick.memory[Tracker.FADING, Fading.PAYLOAD])
    assert found[-1] == pytest.approx(1.5, abs=1e-6)
    assert max(found) < 1.5 + 1e-6


@pytest.mark.parametrize("cause", [int(OffsetCause.WIND), int(OffsetCause.SENSOR)])
def test_wind_moves_carriage_and_rope_and_a_wrong_sensor_neither(cause: int) -> None:
    """At 2 m, wind of g / 10: the rope hangs at 0.1 rad, by 0.2 m aside and 0.01 m too high."""
    tick = Tick()
    tick.parameters[Tracking.REJECTED_WIND] = 1.0
    tick.parameters[Tracking.OFFSET_CAUSE] = cause
    tick.memory[Tracker.SIGNALS, Coordinates.POSITION + Axes.ROPE] = 2.0
    tick.memory[Tracker.PRESENT, Estimate.WIND] = 0.981
    track_deviation(tick.parameters, tick.memory)
    moves = cause != OffsetCause.SENSOR
    deviation, target = tick.memory[Tracker.DEVIATION], tick.memory[Tracker.TARGET]
    assert deviation[State.POSITION] == pytest.approx(0.2 * moves)
    assert deviation[State.ANGLE] == pytest.approx(-0.1)
    assert target[State.POSITION + Axes.ROPE] == pytest.approx(2.0 + 0.01 * moves)


@pytest.mark.parametrize(("share", "force", "bound"), [(8.9, -1e4, 9.0), (-0.9, 1e3, -0.98)])
def test_the_estimate_of_the_payload_has_bounds(share: float, force: float, bound: float) -> None:
    tick = Tick()
    tick.parameters[Tracking.PAYLOAD_SHARE] = 0.02
    tick.memory[Tracker.HELD, Held.AWAKE] = 1.0
    tick.memory[Tracker.HELD, Held.CORRECTION + Axes.ROPE] = force
    tick.memory[Tracker.FADING, Fading.PAYLOAD] = share
    track_hoist(tick.parameters, tick.memory)
    assert tick.memory[Tracker.FADING, Fading.PAYLOAD] == bound
