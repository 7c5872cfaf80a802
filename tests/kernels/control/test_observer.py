"""One tick of the observer against plain matrix algebra."""

from __future__ import annotations

import numpy as np
import pytest

from segfmu.kernels.control.observer import observer_correct, observer_predict
from segfmu.kernels.control.records import Observer

RANDOM = np.random.default_rng(11)
LENGTHS = np.array([0.5, 1.0, 2.0])
BLOCKS = RANDOM.normal(size=(3, 18, 10))
TABLE = np.concatenate([np.zeros((3, 1, 10)), BLOCKS], axis=1)
TABLE[:, Observer.LENGTH, 0] = LENGTHS
START = RANDOM.normal(size=(3, 6))
SIGNS = np.array([1.0, -1.0])


def rows(length: float) -> np.ndarray:
    """The table at a rope length, one block (6, 10) an axis."""
    flat = [np.interp(length, LENGTHS, column) for column in BLOCKS.reshape(3, -1).T]
    return np.array(flat).reshape(3, 6, 10)


@pytest.mark.parametrize("length", [0.2, 0.5, 0.8, 1.7, 3.0])
def test_prediction_is_transition_and_inputs(length: float) -> None:
    command, held = RANDOM.normal(size=(2, 3))
    found = START.copy()
    for axis, block in enumerate(rows(length)):
        observer_predict(
            axis, length, TABLE, command[axis], held[axis], found[axis], np.zeros(10)
        )
        inputs = np.array([command[axis], held[axis]])
        assert found[axis] == pytest.approx(block[:, :6] @ START[axis] + block[:, 6:8] @ inputs)


@pytest.mark.parametrize("length", [0.2, 0.5, 0.8, 1.7, 3.0])
def test_correction_is_the_gain_on_the_innovation(length: float) -> None:
    measured, reference = RANDOM.normal(size=5), RANDOM.normal(size=10)
    found = START.copy()
    observer_correct(length, TABLE, measured, reference, found)
    deviation = measured - reference[:5]
    for axis, block in enumerate(rows(length)):
        innovation = np.zeros(2)
        innovation[0] = deviation[axis] - START[axis, 0]
        if axis < 2:
            innovation[1] = SIGNS[axis] * deviation[3 + axis] - START[axis, 1]
        assert found[axis] == pytest.approx(START[axis] + block[:, 8:] @ innovation)
