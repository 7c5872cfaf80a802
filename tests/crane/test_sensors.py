"""Sensors: quantisation, sample time, dead time, noise; what they refuse."""

from __future__ import annotations

import numpy as np
import pytest

from segfmu import Crane, InputError
from segfmu.crane import Plant, Rig, Sensors, Setpoints
from segfmu.crane.sensors import resolution
from tests.crane.test_rig import HANGING, feedback

pytestmark = pytest.mark.interpreted

LAB = Crane(2.2, 1.155, 1.0)


def swinging(sensors: Sensors) -> Plant:
    start = HANGING.copy()
    start[[3, 4, 5]] = 0.2, -0.1, 0.3
    return Plant(
        LAB, start, Setpoints(force=np.array([0.0, 0.0, -9.81])), feedback(False), enabled=False,
        rig=Rig(sensors=sensors),
    )


def go(plant: Plant, duration: float) -> None:
    plant.step(duration, Setpoints(force=np.array([0.0, 0.0, -9.81])))


def test_encoder_counts_give_the_resolution() -> None:
    assert resolution(4096) == pytest.approx(2.0 * np.pi / 4096)
    assert resolution(1000, 0.5) == pytest.approx(5e-4)
    with pytest.raises(InputError, match="counts must be a finite number > 0"):
        resolution(0)


def test_by_default_the_state_is_measured() -> None:
    plant = swinging(Sensors())
    for _ in range(5):
        assert plant.measured.tolist() == plant.state[:5].tolist()
        go(plant, 0.013)


def test_quantised_signals_are_steps_within_half_a_step() -> None:
    steps = (0.01, 0.01, 0.002, resolution(256), resolution(4096))
    plant = swinging(Sensors(resolution=steps))
    for _ in range(50):
        go(plant, 0.017)
        error = plant.measured - plant.state[:5]
        assert (np.abs(error) <= 0.5 * np.array(steps) * (1.0 + 1e-9)).all()
        counts = plant.measured / steps
        assert counts == pytest.approx(np.round(counts), abs=1e-6)


def test_rope_offset_makes_the_rope_seem_longer() -> None:
    plant = swinging(Sensors(offset=(0.0, 0.0, 0.025, 0.0, 0.0)))
    go(plant, 0.1)
    assert plant.measured - plant.state[:5] == pytest.approx([0.0, 0.0, 0.025, 0.0, 0.0], abs=1e-15)


@pytest.mark.parametrize("step", [0.001, 0.004, 0.0075, 0.02])
def test_samples_are_held_and_late_by_the_dead_time(step: float) -> None:
    truth, plant = swinging(Sensors()), swinging(Sensors(sample_time=0.01, dead_time=0.015))
    true = [truth.state[:5]]
    for _ in range(60):
        go(truth, 0.005)
        true.append(truth.state[:5])
    for i in range(1, int(0.3 / step) + 1):
        go(plant, step)
        tick = int(np.floor((i * step - 0.015) / 0.01 + 1e-9))
        assert plant.measured == pytest.approx(true[2 * max(tick, 0)], abs=1e-9)


def test_noise_is_new_at_every_sample_and_held_between() -> None:
    plant = swinging(Sensors(sample_time=0.01, deviation=(0.001,) * 5, seed=5))
    errors = []
    for _ in range(400):
        go(plant, 0.01)
        errors.append(plant.measured - plant.state[:5])
    assert np.std(errors, axis=0) == pytest.approx([0.001] * 5, rel=0.15)
    assert np.abs(np.corrcoef(np.array(errors).T) - np.eye(5)).max() < 0.2
    held = plant.measured
    assert plant.measured.tolist() == held.tolist()
    go(plant, 0.004)
    assert plant.measured.tolist() == held.tolist()


@pytest.mark.parametrize(
    ("values", "words"),
    [
        ({"sample_time": -0.01}, "sensor sample_time must be a finite number >= 0"),
        ({"sample_time": float("nan")}, "sensor sample_time"),
        ({"dead_time": -1.0, "sample_time": 0.01}, "sensor dead_time"),
        ({"dead_time": 10.1, "sample_time": 1e-4}, "longer than 100000 samples of 0.0001 s; lower"),
        ({"dead_time": 0.01}, "set sensor.sample_time above 0 s"),
        ({"deviation": (0.1,) * 5}, "set sensor.sample_time above 0 s"),
        ({"resolution": (0.1,) * 4}, "sensor resolution must have 5 values, got 4"),
        ({"resolution": (0.1, 0.0, 0.0, -1.0, 0.0)}, "sensor resolution"),
        ({"offset": (float("inf"), 0.0, 0.0, 0.0, 0.0)}, "sensor offset must be finite"),
        ({"seed": -1}, "sensor seed must be an integer from 0"),
        ({"seed": 2**31}, "sensor seed"),
        ({"seed": 1.5}, "sensor seed"),
        ({"seed": True}, "sensor seed"),
    ],
)
def test_bad_sensors_are_refused(values, words: str) -> None:
    with pytest.raises(InputError, match=words):
        Sensors(**values)
