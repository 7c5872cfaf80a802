"""Phases to pieces to values, against numerical integration of the acceleration."""

from __future__ import annotations

import numpy as np
import pytest

from segfmu import Limits, Waypoint, plan
from segfmu.kernels.backend import evaluate
from segfmu.kernels.planner.records import Phase
from segfmu.kernels.trajectory.evaluate import evaluate_orders, find_piece
from segfmu.kernels.trajectory.pieces import expand_phases
from segfmu.kernels.trajectory.records import Expansion, PieceState
from tests.problems import packed_axis


@pytest.mark.parametrize("shape", [0, 1])
@pytest.mark.parametrize("smoothness", [2, 3, 4, 5, 6])
@pytest.mark.parametrize("stretch", [1.0, 1.7])
def test_pieces_join_and_integrate(smoothness: int, shape: int, stretch: float) -> None:
    phases = np.zeros((4, Phase.SIZE))
    phases[:, Phase.DURATION] = 0.5, 0.3, 0.7, 0.2
    phases[:, Phase.BASIS] = 0.5 / stretch, 0.0, 0.7 / stretch, 0.0
    phases[:, Phase.ACCELERATION] = 0.0, 0.8, 0.8, -0.3
    phases[:, Phase.CHANGE] = 0.8, 0.0, -1.1, 0.0
    timing, coefficients = np.zeros((124, 2)), np.zeros((124, 2 * smoothness))
    limits = [1.0, 1.0, 2.0, 20.0, 300.0, 9000.0, 0.0][: smoothness + 1]
    axis = packed_axis(smoothness, shape, limits)
    work = np.zeros((Expansion.SIZE, Expansion.COLUMNS))
    state = work[Expansion.STATE]
    state[PieceState.POSITION], state[PieceState.VELOCITY] = 1.0, -0.2
    state[PieceState.TIME] = 2.0
    rows = expand_phases(phases, 4, axis, timing, coefficients, 0, work)
    end = state[PieceState.TIME]
    assert end == pytest.approx(3.7)
    times = np.linspace(2.0, end, 40001)
    values = {d: np.zeros((times.size, 1)) for d in range(smoothness + 1)}
    for d, found in values.items():
        evaluate(
            times, timing, coefficients, np.array([0, rows]), np.array([end]), d, found
        )
    assert values[0][0, 0] == 1.0
    assert values[1][0, 0] == pytest.approx(-0.2)
    # every derivative below the n-th one is the integral of the next
    step = times[1] - times[0]
    for d in range(smoothness):
        middle = 0.5 * (values[d + 1][1:] + values[d + 1][:-1])
        integral = values[d][0] + np.cumsum(middle, axis=0) * step
        scale = max(1.0, np.abs(values[d]).max())
        # the n-th derivative of n = 2 jumps nowhere, but its kinks cost the sum its order
        assert np.abs(values[d][1:] - integral).max() < 2e-4 * scale
    assert values[2][-1, 0] == pytest.approx(-0.3)


def test_outside_it_stays_in_the_end_position() -> None:
    timing, coefficients = np.array([[0.0, 1.0]]), np.array([[1.0, 2.0, 0.0, 0.0]])
    found = np.zeros((4, 1))
    arguments = (timing, coefficients, np.array([0, 1]), np.array([1.0]))
    evaluate(np.array([-1.0, 0.0, 1.0, 2.0]), *arguments, 0, found)
    assert found[:, 0].tolist() == [1.0, 1.0, 3.0, 3.0]
    evaluate(np.array([-1.0, 0.0, 1.0, 2.0]), *arguments, 1, found)
    assert found[:, 0].tolist() == [0.0, 2.0, 2.0, 0.0]


def test_piece_is_found_by_its_start() -> None:
    timing = np.zeros((5, 2))
    timing[:, 0] = [0.0, 1.0, 2.0, 0.0, 5.0]
    assert [find_piece(t, timing, 0, 3) for t in (-1.0, 0.0, 0.9, 1.0, 2.0, 9.0)] == [
        0, 0, 0, 1, 2, 2,
    ]
    assert [find_piece(t, timing, 3, 5) for t in (1.0, 5.0)] == [3, 4]


def test_a_piece_does_not_go_on_beyond_its_length() -> None:
    # as where the clock of late starts is coarser than a piece is long
    timing, coefficients = np.array([[0.0, 0.5], [1.0, 1.0]]), np.array([[0.0, 1.0], [0.5, 1.0]])
    found = np.zeros((2, 1))
    evaluate(
        np.array([0.4, 0.9]), timing, coefficients, np.array([0, 2]), np.array([2.0]), 0, found
    )
    assert found[:, 0].tolist() == [0.4, 0.5]


def test_all_derivatives_at_once_are_those_one_by_one() -> None:
    trajectory = plan([Waypoint([0.0, 1.0]), Waypoint([1.0, 0.5])], Limits(1.0, 1.0, 2.0))
    for time in (-0.1, 0.0, 0.3, trajectory.duration, 99.0):
        found = np.zeros((5, 2))
        evaluate_orders(
            time, trajectory.timing, trajectory.coefficients, trajectory.offsets,
            trajectory.axis_durations, found,
        )
        assert found.tolist() == [trajectory(time, d).tolist() for d in range(5)]
