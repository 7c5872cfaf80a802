"""Predictions over a part of a sample against the exact motion of a linear model."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.linalg import expm

from segfmu.kernels.control.delay import predict_present
from segfmu.kernels.control.records import (
    AxisModel,
    Estimate,
    Observer,
    Past,
    Tracker,
    Tracking,
    VelocityCommand,
)

RANDOM = np.random.default_rng(7)
MODEL = np.zeros((AxisModel.SIZE, AxisModel.SIZE))
MODEL[: Estimate.SIZE] = RANDOM.normal(size=(Estimate.SIZE, AxisModel.SIZE))
MODEL[AxisModel.COMMAND, AxisModel.CORRECTION] = 1.0
START = RANDOM.normal(size=AxisModel.SIZE)


def error(share: float, period: float) -> float:
    """Of the state after a share of a sample, with a correction that is held."""
    table = np.zeros((1, Observer.SIZE, Observer.COLUMNS))
    block = slice(Observer.BRIDGE, Observer.BRIDGE + Estimate.SIZE)
    table[0, block, : AxisModel.SIZE] = expm(period * MODEL)[: Estimate.SIZE]
    memory = np.zeros((Tracker.SIZE, Tracker.COLUMNS))
    memory[Tracker.ESTIMATE, : Estimate.SIZE] = START[: Estimate.SIZE]
    memory[Tracker.PAST, Past.INPUT] = START[AxisModel.CORRECTION]
    # the command is that of the end of the prediction
    memory[Tracker.COMMAND, VelocityCommand.VELOCITY] = (
        START[AxisModel.COMMAND] + share * period * START[AxisModel.CORRECTION]
    )
    parameters = np.zeros(Tracking.SIZE)
    parameters[Tracking.PERIOD], parameters[Tracking.DELAY] = period, share
    predict_present(parameters, 1.0, table, memory)
    exact = (expm(share * period * MODEL) @ START)[: Estimate.SIZE]
    return float(np.abs(memory[Tracker.PRESENT, : Estimate.SIZE] - exact).max())


@pytest.mark.parametrize("share", [0.2, 0.5, 0.9])
def test_the_error_of_a_part_of_a_sample_is_of_third_order(share: float) -> None:
    assert error(share, 1e-3) < 1e-6
    assert error(share, 2e-3) / error(share, 1e-3) == pytest.approx(8.0, rel=0.05)


def test_whole_samples_are_exact() -> None:
    assert error(1.0, 0.05) < 1e-13
