"""One tick of the tracking controller, with an observer and gains of a few numbers."""

from __future__ import annotations

import numpy as np
import pytest

from segfmu.kernels.control.tracking import track_setpoint

LENGTHS = np.array([1.0])
REFERENCE = np.array([0.5, -0.2, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0])
FEEDFORWARD = np.array([1.0, 0.0, -9.81])
STIFFNESS = np.array([4.0, 5.0, 6.0])


class Tick:
    """An observer that keeps positions as measured, and proportional gains."""

    def __init__(self, driven: bool = False, tolerance: float = 0.0) -> None:
        self.parameters = np.zeros(27)
        self.parameters[:7] = driven, 0.01, 0.0, 3.0, 1.0, 1.0, 9.81
        self.parameters[9], self.parameters[10] = 1.0, 0.1
        self.parameters[12:15], self.parameters[15:18] = -1e99, 1e99
        self.parameters[18] = 1.0
        self.parameters[20:23] = tolerance
        self.table, self.gains = np.zeros((1, 18, 10)), np.zeros((1, 3, 10))
        for axis in range(3):
            self.table[0, 6 * axis, 8] = self.table[0, 6 * axis, 0] = 1.0
            self.gains[0, axis, axis] = STIFFNESS[axis]
        self.memory = np.zeros((22, 10))

    def __call__(self, deviation) -> np.ndarray:
        correction = np.zeros(3)
        measured = REFERENCE[:5] + np.append(deviation, [0.0, 0.0])
        track_setpoint(
            self.parameters, LENGTHS, self.table, LENGTHS, self.gains, measured, REFERENCE,
            FEEDFORWARD, self.memory, correction,
        )
        return correction


@pytest.mark.parametrize("driven", [False, True])
def test_the_correction_is_the_gain_on_the_deviation(driven: bool) -> None:
    tick, deviation = Tick(driven), np.array([0.1, -0.2, 0.05])
    for _ in range(3):
        assert tick(deviation) == pytest.approx(-STIFFNESS * deviation)


def test_the_setpoint_with_feedforward_stays_within_its_limits() -> None:
    tick = Tick()
    tick.parameters[12:15], tick.parameters[15:18] = [-2.0, -0.5, -10.0], [1.2, 0.5, 0.0]
    assert FEEDFORWARD + tick([-1.0, 1.0, 1.0]) == pytest.approx([1.2, -0.5, -10.0])
    # what the observer is told is what happens
    assert tick.memory[4, :2] == pytest.approx([0.2, -0.5])


def test_below_the_steps_of_the_sensors_it_sleeps_and_above_it_wakes_for_good() -> None:
    tick = Tick(tolerance=0.1)
    assert tick([0.09, -0.09, 0.09]).tolist() == [0.0, 0.0, 0.0]
    assert tick([0.0, -0.11, 0.0]) == pytest.approx([0.0, 0.55, 0.0])
    assert tick([0.05, 0.0, 0.0]) == pytest.approx([-0.2, 0.0, 0.0])


def test_switched_off_the_correction_fades() -> None:
    tick, deviation = Tick(), [0.1, 0.0, 0.0]
    tick.parameters[11] = 0.5
    assert tick(deviation)[0] == pytest.approx(-0.4)
    tick.parameters[9], tick.memory[3, 4] = 0.0, 1.0
    assert [tick(deviation)[0] for _ in range(3)] == pytest.approx([-0.2, -0.1, -0.05])


def test_switched_off_the_velocity_that_was_added_fades() -> None:
    tick = Tick(driven=True)
    for _ in range(10):
        tick([0.1, 0.0, 0.0])
    tick.parameters[9] = 0.0
    added = tick.memory[3, 0]
    for _ in range(100):
        tick([0.1, 0.0, 0.0])
    assert added < -0.03
    # a fading of 0.1 s for 1 s
    assert tick.memory[3, 0] == pytest.approx(added * np.exp(-10.0), rel=0.7)


def test_the_payload_is_estimated_from_what_holds_it() -> None:
    """A rope that would sink under m g is held by m (g - v) / g when v is asked for throughout."""
    tick = Tick()
    tick.parameters[19] = 0.02
    found = []
    for _ in range(1000):
        # the deviation that makes the feedback ask for what a load of 1.5 kg needs
        force = -9.81 * (1.0 + tick.memory[5, 3])
        missing = (force + 1.5 * 9.81) / 1.5
        tick([0.0, 0.0, missing / STIFFNESS[2]])
        found.append(1.0 + tick.memory[5, 3])
    assert found[-1] == pytest.approx(1.5, abs=1e-6)
    assert max(found) < 1.5 + 1e-6
