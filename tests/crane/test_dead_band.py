"""The dead band: what its controller sees."""

from __future__ import annotations

import numpy as np
import pytest

from segfmu import InputError
from segfmu.crane.dead_band import DeadBand

STEPS = (0.2, 0.2, 0.02, 0.1, 0.0)


class Recorder:
    """Keeps what it was given."""

    sample_time = 0.01

    def sample(self, time, measured, reference, feedforward) -> np.ndarray:
        self.deviation = measured - reference[:5]
        return np.array([time, 1.0, 2.0])


def seen(measured, *references, delayed: bool = False) -> np.ndarray:
    inner = Recorder()
    band = DeadBand(inner, STEPS, delayed=delayed)
    for i, position in enumerate(references):
        reference = np.zeros(10)
        reference[0] = position
        assert band.sample(float(i), np.array(measured), reference, np.zeros(3))[0] == i
    return inner.deviation


def test_deviations_lose_half_a_step() -> None:
    found = seen([0.15, -0.15, 0.005, -0.05, 1e-9], 0.0)
    assert found == pytest.approx([0.05, -0.05, 0.0, 0.0, 1e-9], abs=1e-15)


def test_late_signals_belong_to_the_reference_before() -> None:
    # at the second tick the reference has gone on to 1, the signal is that of 0.05
    found = seen([0.05, 0.0, 0.0, 0.0, 0.0], 0.0, 1.0, delayed=True)
    assert found[0] == pytest.approx(-1.0)
    assert seen([0.05, 0.0, 0.0, 0.0, 0.0], 0.0, 1.0)[0] == pytest.approx(-0.85)


def test_rounding_alone_is_never_seen() -> None:
    numbers = np.random.default_rng(1)
    steps = np.array(STEPS)
    for state in numbers.uniform(-1.0, 1.0, (200, 5)):
        inner = Recorder()
        rounded = np.where(steps > 0.0, np.round(state / np.maximum(steps, 1e-9)) * steps, state)
        reference = np.append(state, np.zeros(5))
        DeadBand(inner, STEPS).sample(0.0, rounded, reference, np.zeros(3))
        assert inner.deviation == pytest.approx(np.zeros(5), abs=1e-12)


def test_negative_steps_are_refused() -> None:
    with pytest.raises(InputError, match="dead band resolution"):
        DeadBand(Recorder(), (-1.0, 0.0, 0.0, 0.0, 0.0))
