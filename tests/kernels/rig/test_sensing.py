"""Signals of sensors against a plain list of samples, and noise by its statistics."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from segfmu.crane import Sensors
from segfmu.kernels.numerics.noise import seed_numbers
from segfmu.kernels.rig.records import Queue, Sensing
from segfmu.kernels.rig.sensing import (
    measure_state,
    next_sample,
    sense_signals,
    sensing_rows,
    start_sensing,
    take_sample,
)
from tests.campaign import SOAK


def seeded(seed: int) -> np.ndarray:
    numbers = np.zeros(2)
    seed_numbers(seed, numbers)
    return numbers


def memory_of(sensors: Sensors) -> np.ndarray:
    return np.zeros((sensing_rows(sensors.sample_time, sensors.dead_time), Sensing.COLUMNS))


def state_at(time: float) -> np.ndarray:
    return time + np.arange(10.0)


def signals(sensors: Sensors, time: float, memory: np.ndarray) -> np.ndarray:
    measured = np.zeros(5)
    sense_signals(sensors.vector, time, state_at(time), memory, measured)
    return measured


def test_measured_is_offset_noisy_and_rounded_to_steps() -> None:
    state, measured = np.linspace(-1.0, 1.0, 10), np.zeros(5)
    offset = (0.0, 0.02, 0.2, 0.0, 0.3)
    sensors = Sensors(offset=offset, resolution=(0.1, 0.1, 0.1, 0.1, 0.0))
    measure_state(state, sensors.vector, seeded(1), measured)
    exact = state[:5] + offset
    assert measured[4] == exact[4]
    assert measured[:4] == pytest.approx(np.round(exact[:4] / 0.1) * 0.1)
    sensors = Sensors(0.1, deviation=(0.1, 0.0, 0.2, 0.3, 0.4), offset=offset)
    numbers, rows = seeded(5), []
    for _ in range(2000):
        measure_state(state, sensors.vector, numbers, measured)
        rows.append(measured - exact)
    assert np.mean(rows, axis=0) == pytest.approx(np.zeros(5), abs=0.03)
    assert np.std(rows, axis=0) == pytest.approx([0.1, 0.0, 0.2, 0.3, 0.4], rel=0.05, abs=1e-12)


def test_noise_of_a_sensor_does_not_depend_on_that_of_the_others() -> None:
    found = []
    for deviation in ((0.1, 0.0, 0.2, 0.0, 0.0), (0.0, 0.3, 0.2, 0.0, 0.1)):
        measured = np.zeros(5)
        measure_state(np.zeros(10), Sensors(0.1, deviation=deviation).vector, seeded(4), measured)
        found.append(measured[2])
    assert found[0] == found[1] != 0.0


def test_a_step_below_the_last_digit_changes_nothing() -> None:
    state, measured = np.full(10, 1e3), np.zeros(5)
    measure_state(state, Sensors(resolution=(1e-200,) * 5).vector, seeded(0), measured)
    assert measured.tolist() == [1e3] * 5


def test_continuous_signals_are_those_of_the_state() -> None:
    sensors = Sensors()
    memory = memory_of(sensors)
    start_sensing(sensors.vector, state_at(0.0), memory)
    assert next_sample(sensors.vector, memory) == 1e300
    assert signals(sensors, 0.3, memory).tolist() == state_at(0.3)[:5].tolist()


@pytest.mark.soak
@settings(max_examples=100 if SOAK else 40, deadline=None)
@given(st.floats(1e-3, 0.1), st.floats(0.0, 12.0), st.floats(0.01, 30.0))
def test_signals_are_the_latest_available_samples(period: float, late: float, pause: float) -> None:
    """late and pause, between two looks at the signals, in periods."""
    sensors = Sensors(period, late * period)
    memory = memory_of(sensors)
    start_sensing(sensors.vector, state_at(0.0), memory)
    look = 0.0
    for _ in range(60):
        look += pause * period
        while (tick := next_sample(sensors.vector, memory)) <= look:
            take_sample(sensors.vector, state_at(tick), memory)
        found = signals(sensors, look, memory)
        latest = max(np.floor(look / period - late + 1e-9), 0.0)
        # what is due within a billionth of a period may be there or not
        sure = abs(look / period - late - round(look / period - late)) > 1e-8
        if sure:
            assert found == pytest.approx(state_at(latest * period)[:5], abs=1e-9)
        assert memory[Sensing.QUEUE, Queue.WAITING] <= np.ceil(late) + 2
        assert signals(sensors, look, memory).tolist() == found.tolist()


def test_the_first_sample_is_there_at_once() -> None:
    sensors = Sensors(0.01, 0.05)
    memory = memory_of(sensors)
    start_sensing(sensors.vector, state_at(7.0), memory)
    assert signals(sensors, 0.0, memory).tolist() == state_at(7.0)[:5].tolist()


def test_rounding_of_the_clock_holds_back_no_sample() -> None:
    """3 * 0.1 + 0.3 is later than 0.6 by the last digit."""
    sensors = Sensors(sample_time=0.1, dead_time=0.3)
    assert 3 * 0.1 + 0.3 > 0.6
    memory = memory_of(sensors)
    start_sensing(sensors.vector, state_at(0.0), memory)
    for _ in range(3):
        take_sample(sensors.vector, state_at(next_sample(sensors.vector, memory)), memory)
    assert signals(sensors, 0.6, memory) == pytest.approx(state_at(0.3)[:5], abs=1e-12)
    assert signals(sensors, 0.6, memory)[0] > 0.25
