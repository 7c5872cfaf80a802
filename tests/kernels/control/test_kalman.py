"""Design of the observer: what its table must satisfy, and the same table compiled."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import quad_vec
from scipy.linalg import expm

from segfmu.kernels import backend
from segfmu.kernels.control import kalman
from segfmu.kernels.control.records import Kalman, ModelWork, Observer
from segfmu.kernels.crane.records import Plant
from tests.compiler import needs_kernels

MASSES = (2.2, 1.155, 1.0, 9.81)
LAG = np.array([0.025, 0.0, 0.03])
EXPECTED = np.array([1e-4, 2e-4, 2.0 * np.pi / 4096, 2.9, 0.5])


def plant(driven: bool) -> np.ndarray:
    parameters = np.zeros(Plant.SIZE)
    parameters[: len(MASSES)] = MASSES
    parameters[Plant.MODE] = driven
    parameters[Plant.LAG : Plant.LAG + 3] = LAG
    return parameters


def design(module, driven: bool, length: float, sample_time: float = 0.01) -> np.ndarray:
    table = np.full((Observer.SIZE, Observer.COLUMNS), np.nan)
    work = np.full((Kalman.SIZE, 16), np.nan)
    module.observer_design(plant(driven), sample_time, length, EXPECTED, work, table)
    assert table[Observer.LENGTH, 0] == length
    return table[Observer.BRIDGE :]


def model(axis: int, driven: bool, length: float) -> np.ndarray:
    found = np.full((8, 8), np.nan)
    kalman.kalman_model(axis, plant(driven), length, found)
    return found


@pytest.mark.parametrize("driven", [False, True])
@pytest.mark.parametrize("axis", [0, 1, 2])
def test_transition_and_covariance_are_their_integrals(axis: int, driven: bool) -> None:
    """For a sample that is short, and for one of several swings, which takes many doublings."""
    own = model(axis, driven, 0.4)
    walks = np.diag([0.0, 0.0, 0.0, 0.0, 2.9**2, 0.5**2])
    for time in (1e-3, 3.0):
        transition, covariance = np.zeros((8, 8)), np.zeros((6, 6))
        kalman.kalman_sampled(
            time, 2.9, 0.5, own, transition, covariance, np.zeros((ModelWork.SIZE, 16))
        )
        assert transition == pytest.approx(expm(own * time), rel=1e-9, abs=1e-10)

        def grown(s: float) -> np.ndarray:
            part = expm(own[:6, :6] * s)
            return part @ walks @ part.T

        expected = quad_vec(grown, 0.0, time, epsabs=0.0, epsrel=1e-11)[0]
        scale = np.sqrt(np.outer(np.diag(expected), np.diag(expected))) + 1e-300
        assert np.abs((covariance - expected) / scale).max() < 1e-8


@pytest.mark.parametrize("length", [0.05, 0.5, 30.0])
@pytest.mark.parametrize("driven", [False, True])
def test_the_filter_forgets(driven: bool, length: float) -> None:
    """An error of the estimate decays, for every axis, whatever the true state does."""
    table = design(kalman, driven, length)
    for axis, read in enumerate((np.eye(6)[:2], np.eye(6)[:2], np.eye(6)[:1])):
        block = table[6 * axis : 6 * axis + 6]
        kept = np.arange(6) if axis < 2 else np.array([0, 2, 4])
        gain = block[:, 8 : 8 + len(read)]
        loop = (np.eye(6) - gain @ read) @ block[:, :6]
        assert np.abs(np.linalg.eigvals(loop[np.ix_(kept, kept)])).max() < 0.995
        assert np.isfinite(block).all()
    # the hoist has neither angle nor load
    assert not table[[13, 15, 17]].any() and not table[12:, [1, 3, 5, 9]].any()


@needs_kernels
@pytest.mark.parametrize("driven", [False, True])
def test_compiled_gives_the_same(driven: bool) -> None:
    for length in (0.16, 1.0):
        assert design(backend, driven, length) == pytest.approx(
            design(kalman, driven, length), rel=1e-12, abs=1e-14
        )
