"""The check of gains against the eigenvalues of the loop, simulated tick by tick in NumPy."""

from __future__ import annotations

import numpy as np
import pytest

from segfmu import Crane
from segfmu.crane.feedback import SwayFeedback, design
from segfmu.crane.flat_feedback import design_flat
from segfmu.kernels import backend
from segfmu.kernels.control.records import LoopWork
from segfmu.kernels.crane.records import Axes, Plant
from segfmu.kernels.rig.records import SetupFault, SetupStatus

CRANES = {"lab": (Crane(2.2, 1.155, 1.0), 0.4), "ship": (Crane(300e3, 15e3, 40e3), 25.0)}


def checked(
    crane: Crane, feedback: SwayFeedback, driven: bool, lag: float, dead: float, predicted: bool
) -> tuple[int, np.ndarray]:
    plant, fault = crane.plant(driven, lag), np.zeros(SetupFault.SIZE)
    plant[Plant.DEAD_TIME : Plant.DEAD_TIME + Axes.SIZE] = dead
    status = backend.check_gains(
        plant, feedback.sample_time, int(predicted), feedback.lengths[[0, -1]].copy(),
        feedback.table, np.zeros((LoopWork.SIZE, LoopWork.COLUMNS)), fault,
    )
    return status, fault


def growth(
    crane: Crane, length: float, row: np.ndarray, driven: bool, lag: float, late: float,
    period: float,
) -> float:
    """Largest eigenvalue of bridge and sway in x under gains (11,), by Runge-Kutta steps.

    late: dead time in samples; of a part of a sample the correction before acts at first.
    """
    carriage, weight = crane.bridge_mass + crane.trolley_mass, crane.payload_mass * crane.gravity

    def slope(x: np.ndarray, u: float) -> np.ndarray:
        place, angle, velocity, rate, command = x
        if not driven:
            a, c = (u + weight * angle) / carriage, 0.0
        elif lag > 0.0:
            a, c = (command - velocity) / lag, u
        else:
            a, c = u, 0.0
        return np.array([velocity, rate, a, -(crane.gravity * angle + a) / length, c])

    def moved(x: np.ndarray, u: float, time: float) -> np.ndarray:
        h = time / 20
        for _ in range(20):
            a = slope(x, u)
            b = slope(x + h / 2 * a, u)
            c = slope(x + h / 2 * b, u)
            x = x + h / 6 * (a + 2 * b + 2 * c + slope(x + h * c, u))
        return x

    gains = row[[0, 3, 5, 8, 10]]
    columns, kept = [], int(np.ceil(late))
    for unit in np.eye(5 + kept):
        state, waiting = unit[:5], [*unit[5:], -float(gains @ unit[:5])]
        first = (late - kept + 1.0) % 1.0 * period
        state = moved(state, waiting[0], first)
        state = moved(state, waiting[int(first > 0.0)], period - first)
        columns.append(np.concatenate([state, waiting[1:]]))
    return float(np.abs(np.linalg.eigvals(np.array(columns).T[_used(driven, lag, kept)])).max())


def _used(driven: bool, lag: float, late: int) -> tuple[np.ndarray, np.ndarray]:
    """Without lag the command is no state."""
    kept = [i for i in range(5 + late) if i != 4 or (driven and lag > 0.0)]
    return np.ix_(kept, kept)


@pytest.mark.parametrize("size", CRANES)
@pytest.mark.parametrize(("driven", "lag"), [(False, 0.0), (True, 0.0), (True, 0.3)])
@pytest.mark.parametrize("late", [0, 1, 4])
@pytest.mark.parametrize("kind", ["lqr", "flatness"])
def test_growth_is_the_largest_eigenvalue(
    size: str, driven: bool, lag: float, late: int, kind: str
) -> None:
    crane, length = CRANES[size]
    period = 0.06 * np.sqrt(length / crane.gravity)
    make = design if kind == "lqr" else design_flat
    gains = make(
        crane, sample_time=period, shortest=length, longest=length, driven=driven, lag=lag
    )
    for factor in (1.0, 10.0, 60.0):
        scaled = gains.gains.copy()
        # the bridge alone, so that it is the first to be unstable
        scaled[:, 0] *= factor
        feedback = SwayFeedback(period, gains.lengths, scaled, gains.payload)
        expected = growth(crane, length, scaled[0, 0], driven, lag, late, period)
        status, fault = checked(crane, feedback, driven, lag, late * period, False)
        if expected > 1.001:
            assert status == SetupStatus.UNSTABLE
            assert fault[SetupFault.BOUND] >= expected * (1.0 - 1e-5)
            if fault[SetupFault.DRIVE] == Axes.BRIDGE:
                assert fault[SetupFault.BOUND] == pytest.approx(expected, rel=1e-5)
        elif expected < 0.999 and status == SetupStatus.UNSTABLE:
            assert fault[SetupFault.DRIVE] != Axes.BRIDGE


@pytest.mark.parametrize("late", [0.5, 1.25, 2.5])
@pytest.mark.parametrize("size", CRANES)
def test_of_a_part_of_a_sample_both_corrections_count(size: str, late: float) -> None:
    """Each by its share of the sample, of which only the place within it is left out."""
    crane, length = CRANES[size]
    period = 0.06 * np.sqrt(length / crane.gravity)
    gains = design(crane, sample_time=period, shortest=length, longest=length)
    scaled = gains.gains.copy()
    scaled[:, 0] *= 30.0
    feedback = SwayFeedback(period, gains.lengths, scaled, gains.payload)
    expected = growth(crane, length, scaled[0, 0], False, 0.0, late, period)
    status, fault = checked(crane, feedback, False, 0.0, late * period, False)
    assert (status, fault[SetupFault.DRIVE]) == (SetupStatus.UNSTABLE, Axes.BRIDGE)
    assert expected > 1.05
    assert fault[SetupFault.BOUND] - 1.0 == pytest.approx(expected - 1.0, rel=0.02)


def test_an_observer_predicts_over_dead_times_and_a_lag_must_be_known() -> None:
    crane = CRANES["lab"][0]
    ranges = {"sample_time": 0.01, "shortest": 0.16, "longest": 1.0, "driven": True}
    for make in (design, design_flat):
        known, unknown = make(crane, lag=0.3, **ranges), make(crane, **ranges)
        assert checked(crane, known, True, 0.3, 0.1, True)[0] == SetupStatus.FITS
        assert checked(crane, known, True, 0.3, 0.1, False)[0] == SetupStatus.UNSTABLE
        status, fault = checked(crane, unknown, True, 0.3, 0.0, True)
        assert status == SetupStatus.UNSTABLE
        assert 0.16 <= fault[SetupFault.VALUE] <= 1.0 and fault[SetupFault.BOUND] > 1.01
