"""Evaluation of the gain table: interpolation inside, constant outside."""

from __future__ import annotations

import numpy as np
import pytest

from segfmu.crane import SwayFeedback
from segfmu.kernels.control.feedback import feedback_correction

LENGTHS = np.array([1.0, 2.0, 4.0])
GAINS = np.random.default_rng(7).normal(size=(3, 3, 11))
ADDED = np.array([0.4, -0.7, 0.2])
TABLE = SwayFeedback(0.01, LENGTHS, GAINS, 1.0).table
REFERENCE = np.arange(10.0)


def correction(gain: np.ndarray, state: np.ndarray) -> np.ndarray:
    return -gain[:, :10] @ (state - REFERENCE) - gain[:, 10] * ADDED


@pytest.mark.parametrize("length", [0.5, 1.0, 1.3, 2.0, 3.1, 4.0, 9.0])
def test_correction_is_the_interpolated_gain_times_the_error(length: float) -> None:
    state = np.linspace(-1.0, 1.0, 10)
    state[2] = length
    gain = np.array(
        [[np.interp(length, LENGTHS, GAINS[:, i, j]) for j in range(11)] for i in range(3)]
    )
    found = np.zeros(3)
    feedback_correction(state, REFERENCE, ADDED, TABLE, found)
    assert found == pytest.approx(correction(gain, state))


def test_one_row_serves_every_length() -> None:
    state, found = np.ones(10), np.zeros(3)
    feedback_correction(state, REFERENCE, ADDED, TABLE[:1], found)
    assert found == pytest.approx(correction(GAINS[0], state))
