"""How the plant calls a controller, and what becomes of its corrections."""

from __future__ import annotations

import numpy as np
import pytest

from segfmu import Crane
from segfmu.crane import Plant, Rig, Sensors, Setpoints
from tests.crane.test_rig import HANGING

pytestmark = pytest.mark.interpreted

LAB = Crane(2.2, 1.155, 1.0)
HOLD = Setpoints(np.array([0.0, 0.0, -9.81]), reference=HANGING)


class Recorder:
    """A controller that writes down what it gets and answers with a constant."""

    sample_time = 0.02

    def __init__(self, correction=(0.0, 0.0, 0.0)) -> None:
        self.correction = np.array(correction)
        self.times: list[float] = []
        self.measured: list[np.ndarray] = []
        self.references: list[np.ndarray] = []
        self.feedforwards: list[np.ndarray] = []

    def sample(self, time, measured, reference, feedforward) -> np.ndarray:
        self.times.append(time)
        self.measured.append(measured)
        self.references.append(reference)
        self.feedforwards.append(feedforward)
        return self.correction


@pytest.mark.parametrize("step", [0.001, 0.013, 0.02, 0.1])
def test_sampled_at_its_ticks_with_the_reference_of_that_time(step: float) -> None:
    controller = Recorder()
    plant = Plant(LAB, HANGING, HOLD, controller, start_time=3.0)
    for i in range(1, round(0.3 / step) + 1):
        plant.step(step, Setpoints(HOLD.force, reference=HANGING + 0.1 * i * step))
    ticks = np.arange(len(controller.times)) * 0.02
    assert ticks[-1] == pytest.approx(0.28)
    assert controller.times == pytest.approx(3.0 + ticks)
    for tick, reference in zip(ticks, controller.references, strict=True):
        assert reference == pytest.approx(HANGING + 0.1 * tick, abs=1e-12)


def test_it_gets_the_signals_of_the_sensors_not_the_state() -> None:
    start = HANGING.copy()
    start[5] = 0.5
    rig = Rig(sensors=Sensors(0.02, 0.02, offset=(0.0, 0.0, 0.1, 0.0, 0.0)))
    controller = Recorder()
    plant = Plant(LAB, start, HOLD, controller, driven=True, rig=rig)
    for _ in range(5):
        plant.step(0.02, HOLD)
    found = np.array(controller.measured)
    assert found[:, 2] == pytest.approx(0.6, abs=1e-6)
    assert found[0].tolist() == found[1].tolist()
    # velocity mode stops the bridge within the first step; one sample later it is seen
    assert found[2:, 0] == pytest.approx(0.005)


@pytest.mark.parametrize("driven", [False, True])
def test_it_gets_what_it_is_added_to(driven: bool) -> None:
    controller = Recorder()
    plant = Plant(LAB, HANGING, HOLD, controller, driven=driven)
    end = Setpoints(np.array([1.0, 0.0, -9.81]), np.array([0.0, 0.1, 0.0]))
    plant.step(0.05, end)
    if driven:
        assert np.array(controller.feedforwards) == pytest.approx(np.array([[0.0, 2.0, 0.0]] * 3))
    else:
        expected = np.array([[0.0, 0.0, -9.81], [0.4, 0.0, -9.81], [0.8, 0.0, -9.81]])
        assert np.array(controller.feedforwards) == pytest.approx(expected)


def test_correction_is_a_force_in_force_mode() -> None:
    plant = Plant(LAB, HANGING, HOLD, Recorder((0.3, -0.2, 0.1)))
    plant.step(0.05, HOLD)
    assert plant.drive_force == pytest.approx([0.3, -0.2, -9.71])


def test_correction_is_an_acceleration_in_velocity_mode_until_it_is_switched_off() -> None:
    plant = Plant(LAB, HANGING, HOLD, Recorder((0.3, -0.2, 0.1)), driven=True, fade=0.0)
    plant.step(0.05, HOLD)
    assert plant.state[5:8] == pytest.approx([0.015, -0.01, 0.005])
    plant.enabled = False
    plant.step(0.01, HOLD)
    # until the tick at 0.06 s the last correction holds
    assert plant.state[5:8] == pytest.approx([0.018, -0.012, 0.006])
    plant.step(0.04, HOLD)
    assert plant.state[5:8] == pytest.approx(np.zeros(3), abs=1e-12)


def test_a_correction_from_outside_fades_when_it_is_switched() -> None:
    plant = Plant(LAB, HANGING, HOLD, Recorder((0.3, -0.2, 0.1)), fade=0.02 / np.log(2.0))
    plant.step(0.05, HOLD)
    plant.enabled = False
    plant.step(0.02, HOLD)
    assert plant.drive_force == pytest.approx([0.15, -0.1, -9.76])
    plant.enabled = True
    plant.step(0.02, HOLD)
    assert plant.drive_force == pytest.approx([0.225, -0.15, -9.735])


def test_a_controller_that_is_off_goes_on_sampling_without_effect() -> None:
    controller = Recorder((1.0, 1.0, 1.0))
    plant = Plant(LAB, HANGING, HOLD, controller, enabled=False)
    plant.step(0.1, HOLD)
    assert len(controller.times) == 5
    assert plant.drive_force == pytest.approx([0.0, 0.0, -9.81])
