"""Noise of signals against what it was made of."""

from __future__ import annotations

import numpy as np
import pytest

from segfmu.validation.identification.log import Log
from segfmu.validation.identification.noise import dependence, rough_noise
from segfmu.validation.identification.prediction import fit_index

DRAW = np.random.default_rng(3)


@pytest.mark.parametrize("ratio", [0.0, 0.5, 0.9])
def test_samples_of_a_first_order_process_depend_as_its_formula_says(ratio: float) -> None:
    values = np.zeros(100_000)
    noise = DRAW.normal(size=values.size)
    for i in range(1, values.size):
        values[i] = ratio * values[i - 1] + noise[i]
    assert dependence(values) == pytest.approx((1.0 + ratio) / (1.0 - ratio), rel=0.1)


def test_a_signal_without_noise_or_change_depends_on_nothing() -> None:
    assert dependence(np.full(50, 2.0)) == 1.0


def test_noise_on_a_smooth_motion_is_found_before_any_fit() -> None:
    times = np.linspace(0.0, 10.0, 2000)
    signals = np.sin(times)[:, None] + DRAW.normal(0.0, 0.01, (2000, 5))
    signals[:, 4] = np.nan
    found = rough_noise(Log("log", times, np.zeros((2000, 3)), signals))
    assert found[:4] == pytest.approx(0.01, rel=0.1) and np.isnan(found[4])


def test_the_fit_index_is_one_for_equal_signals_and_zero_for_the_mean() -> None:
    signal = np.array([[1.0, 0.0], [3.0, 4.0]])
    assert fit_index(signal, signal) == 1.0
    assert fit_index(signal, np.tile(signal.mean(axis=0), (2, 1))) == 0.0
    assert np.isnan(fit_index(np.ones(3), np.ones(3)))
