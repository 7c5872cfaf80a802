"""Leads: they begin in any state, keep the limits, and end settled."""

from __future__ import annotations

from math import factorial

import numpy as np
import pytest

from segfmu.kernels.planner.parameters import axis_limits
from segfmu.kernels.planner.records import Axis, Problem
from segfmu.kernels.settling.chain import chain_limits, lift_pieces
from segfmu.kernels.settling.lead import find_lead
from segfmu.kernels.settling.records import Chain, Lead, LeadRows, LeadTask, LeadWork
from segfmu.planning.polynomials import derivative_pieces, extrema

pytestmark = pytest.mark.interpreted

LIMITS = {
    2: [1.0, 1.0, 4.0],
    3: [1.0, 1.0, 4.0, 0.0],
    4: [1.0, 1.0, 4.0, 20.0, 0.0],
    5: [1.0, 1.0, 4.0, 20.0, 0.0, 0.0],
    6: [1.0, 1.0, 4.0, 20.0, 400.0, 0.0, 0.0],
}
STATE = [0.3, 0.4, -0.3, 1.0, -4.0, 20.0, 100.0]


def found(
    n: int, order: int, state: list[float], velocity: float = 0.0, within: float = 0.0
) -> tuple:
    work = np.zeros((LeadWork.SIZE, LeadWork.COLUMNS))
    work[LeadWork.TASK, LeadTask.SHAPE] = 1.0
    work[LeadWork.NOW, : n + 1] = state[: n + 1]
    work[LeadWork.TARGET, Problem.W] = velocity
    work[LeadWork.TARGET, Problem.DISTANCE] = 1.0
    timing = np.zeros((LeadRows.ALL, 2))
    coefficients = np.zeros((LeadRows.ALL, 2 * n))
    none = np.zeros(2, dtype=np.int64)
    limits = np.array(LIMITS[n])
    ok = find_lead(
        order, within, 0, none, np.zeros((1, 2)), np.zeros((1, 2 * n)), limits, work, timing,
        coefficients,
    )
    count = int(work[LeadWork.BEST, Lead.COUNT])
    return ok, work, timing[:count], coefficients[:count]


@pytest.mark.parametrize("order", [1, 2])
@pytest.mark.parametrize("n", [3, 4, 5, 6])
def test_a_lead_joins_the_state_to_a_settled_one_within_the_limits(n: int, order: int) -> None:
    ok, work, timing, coefficients = found(n, order, STATE, 0.2 if order == 1 else 0.0)
    assert ok
    for i in range(n + 1):
        assert coefficients[0, i] * factorial(i) == pytest.approx(STATE[i], rel=1e-9, abs=1e-12)
    for i, bound in enumerate(LIMITS[n], 1):
        low, high = extrema(coefficients, timing[:, 1], i)
        assert bound == 0.0 or max(-low, high) <= bound * (1.0 + 1e-9)
    for i in range(n + 1):
        piece = derivative_pieces(coefficients, i)
        right = np.sum(piece * timing[:, 1:] ** np.arange(piece.shape[1]), axis=1)
        scale = np.abs(piece[:, 0]).max()
        np.testing.assert_allclose(right[:-1], piece[1:, 0], atol=1e-9 * scale)
        if i > order:
            assert abs(right[-1]) <= 1e-9 * scale
    reached = work[LeadWork.REACHED]
    assert reached[Chain.TIME] == pytest.approx(timing[:, 1].sum())
    if order == 1:
        assert reached[1] == 0.2


@pytest.mark.parametrize("n", [4, 5, 6])
def test_a_late_lead_goes_over_a_level_to_the_target(n: int) -> None:
    times = []
    for within in (np.inf, 0.0):
        ok, work, timing, _ = found(n, 2, STATE, within=within)
        assert ok
        times.append(work[LeadWork.BEST, Lead.TIME])
        reached = work[LeadWork.REACHED]
        over = reached[0] == 1.0 and timing[:, 1].sum() == pytest.approx(times[-1])
        assert over == (within == 0.0)
    assert times[1] < times[0]


def test_the_time_of_a_stop_is_known_in_closed_form() -> None:
    # n = 2: full jerk to -1 m/s2, hold, and back: 0.3 to 0.7 m/s of acceleration change
    ok, work, _, _ = found(2, 1, [0.0, 0.8, 0.0])
    assert ok
    assert work[LeadWork.BEST, Lead.TIME] == pytest.approx(0.8 / 1.0 + 1.0 / 4.0)


def test_a_state_that_cannot_keep_the_limits_has_no_lead() -> None:
    assert not found(4, 1, [0.0, 0.999, 0.9, 3.0, 0.0])[0]


def test_absent_limits_are_replaced_by_ones_that_the_state_keeps() -> None:
    axis, limits = np.zeros(Axis.SIZE), np.zeros(Chain.SIZE)
    axis_limits(6, 1, np.array([1.0, 2.0, 0.0, 50.0, 0.0, 0.0, 0.0]), axis)
    state = np.array([0.0, 0.5, 1.0, 100.0, 10.0, 1e6, 0.0, 0.0, 0.0])
    chain_limits(1.0, axis, state, limits)
    assert limits[[1, 2, 4]].tolist() == [1.0, 2.0, 50.0]
    assert limits[3] >= 200.0
    assert limits[5] >= 2e6
    assert (limits[1:8] > 0.0).all()
    # and brake in time: the crackle before the snap is at its limit
    assert limits[6] >= 1e12 / (50.0 - 10.0)


def test_pieces_of_a_derivative_become_pieces_of_the_position() -> None:
    state = np.array([1.0, 2.0, 3.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0])
    timing = np.array([[0.0, 0.5], [0.5, 0.25]])
    coefficients = np.zeros((2, 8))
    coefficients[:, :2] = [[3.0, 4.0], [5.0, -1.0]]
    lift_pieces(2, 0, 2, state, timing, coefficients)
    first = np.polynomial.Polynomial(coefficients[0])
    np.testing.assert_allclose(first.coef[:4], [1.0, 2.0, 1.5, 4.0 / 6.0])
    np.testing.assert_allclose(coefficients[1, :2], [first(0.5), first.deriv()(0.5)])
    second = np.polynomial.Polynomial(coefficients[1])
    np.testing.assert_allclose(state[:2], [second(0.25), second.deriv()(0.25)])
