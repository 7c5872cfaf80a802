"""Parts of plans have the values of the plans."""

from __future__ import annotations

import numpy as np
import pytest

from segfmu import Limits, Waypoint, plan
from segfmu.kernels.trajectory.cut import (
    anchor_plan,
    cut_plan,
    end_derivative,
    join_plans,
    meet_ends,
)
from segfmu.kernels.trajectory.evaluate import evaluate

PLAN = plan(
    [Waypoint([0.0, 3.0]), Waypoint([0.4, 3.1], [0.3, 0.1]), Waypoint([1.0, 2.0])],
    Limits(1.0, 1.0, 4.0, 20.0), synchronize="none",
)


def cut(time: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    rows = len(PLAN.timing) + 3
    timing, coefficients = np.zeros((rows, 2)), np.zeros((rows, 8))
    offsets = np.zeros(3, dtype=np.int64)
    cut_plan(time, PLAN.timing, PLAN.coefficients, PLAN.offsets, timing, coefficients, offsets)
    return timing, coefficients, offsets


@pytest.mark.parametrize("time", [0.0, 0.3, 1.234, float(PLAN.axis_durations.min()), 9.0])
@pytest.mark.parametrize("derivative", range(5))
def test_what_is_left_has_the_same_values(time: float, derivative: int) -> None:
    timing, coefficients, offsets = cut(time)
    ends = timing[offsets[1:] - 1].sum(axis=1)
    np.testing.assert_allclose(ends, np.maximum(PLAN.axis_durations - time, 0.0), atol=1e-12)
    times = np.linspace(0.01, 3.0, 50)
    values = np.zeros((50, 2))
    evaluate(times, timing, coefficients, offsets, ends, derivative, values)
    np.testing.assert_allclose(values, PLAN(times + time, derivative), atol=1e-9)


def test_near_its_end_a_piece_keeps_its_digits() -> None:
    # one piece of y = (1 - t)^4: near t = 1 its derivatives are differences of large numbers
    timing = np.array([[0.0, 1.0]])
    coefficients = np.array([[1.0, -4.0, 6.0, -4.0, 1.0, 0.0, 0.0, 0.0]])
    left, pieces, offsets = np.zeros((3, 2)), np.zeros((3, 8)), np.zeros(2, dtype=np.int64)
    cut_plan(1.0 - 2.0**-20, timing, coefficients, np.array([0, 1]), left, pieces, offsets)
    h = 2.0**-20
    expected = [h**4, -4.0 * h**3, 6.0 * h**2, -4.0 * h, 1.0]
    np.testing.assert_allclose(pieces[0, 1:5], expected[1:], rtol=1e-14)
    assert end_derivative(0, 1, 2, timing, coefficients) == 0.0


def test_a_derivative_that_is_rounding_at_the_end_is_zero() -> None:
    """One piece of y = 3 (0.7 - t)^4: its powers do not cancel to the last bit."""
    timing = np.array([[0.0, 0.7]])
    coefficients = np.zeros((1, 8))
    coefficients[0, :5] = 3.0 * np.array([0.7**4, -4.0 * 0.7**3, 6.0 * 0.7**2, -4.0 * 0.7, 1.0])
    bare = [np.polynomial.Polynomial(coefficients[0]).deriv(order)(0.7) for order in (1, 2, 3)]
    assert np.abs(bare).max() > 0.0
    for order in (1, 2, 3):
        assert end_derivative(0, 1, order, timing, coefficients) == 0.0
    assert end_derivative(0, 1, 4, timing, coefficients) == pytest.approx(72.0)


def test_plans_are_joined_axis_by_axis() -> None:
    timing, coefficients, offsets = cut(0.5)
    rows = len(timing)
    lead = np.tile([9.0, 1.0], (rows, 1)), np.full((rows, 8), 7.0), np.array([0, 1, 1])
    joined = np.zeros((2 * rows, 2)), np.zeros((2 * rows, 8)), np.zeros(3, dtype=np.int64)
    used = join_plans(*lead, timing, coefficients, offsets, *joined)
    assert used == offsets[-1] + 1
    assert joined[2].tolist() == [0, offsets[1] + 1, used]
    assert joined[0][0].tolist() == [9.0, 1.0]
    np.testing.assert_array_equal(joined[1][1 : used], coefficients[: offsets[-1]])


def test_an_anchored_plan_ends_where_it_should() -> None:
    timing, coefficients, offsets = cut(0.5)
    ends = np.array([[1.0 + 1e-12, 1e-13], [2.0, 0.0]])
    before = coefficients.copy()
    anchor_plan(ends, PLAN.limits.table(2, 4), timing, coefficients, offsets)
    lengths = timing[offsets[1:] - 1, 1]
    for axis, row in enumerate(offsets[1:] - 1):
        piece = np.polynomial.Polynomial(coefficients[row])
        np.testing.assert_allclose(piece(lengths[axis]), ends[axis, 0], rtol=0.0, atol=4e-16)
        np.testing.assert_allclose(piece.deriv()(lengths[axis]), ends[axis, 1], atol=4e-16)
    np.testing.assert_allclose(coefficients, before, atol=1e-10)


@pytest.mark.parametrize(("start", "end"), [(0.0, 40.0), (17.3, 40.0), (17.3, -0.0121)])
def test_an_anchored_cruise_of_minutes_stays_where_it_is(start: float, end: float) -> None:
    # an error of the pop of 1e-17 at its end would be one of the position of metres at its start
    limits = Limits(0.0447, 1.88, 1.0, None, None, 0.2145)
    found = plan([Waypoint(start), Waypoint(end)], limits, smoothness=6)
    before = found.coefficients.copy()
    coefficients = before.copy()
    anchor_plan(
        np.array([[end]]), limits.table(1, 6), found.timing, coefficients, found.offsets
    )
    np.testing.assert_allclose(coefficients, before, rtol=0.0, atol=1e-12)


def test_axes_meet_where_rounding_alone_keeps_them_apart() -> None:
    # two axes end together but for rounding, the third one ends earlier
    timing = np.array([[0.0, 0.5], [0.5, 1e-7], [0.0, 0.5 + 1e-7 - 3e-16], [0.0, 0.4]])
    offsets = np.array([0, 2, 3, 4])
    before = timing.copy()
    meet_ends(0.5, 0.0, timing, offsets)
    ends = timing[offsets[1:] - 1].sum(axis=1)
    assert ends[0] == ends[1]
    assert ends[2] == 0.4
    # a short piece stays as it is
    assert timing[1, 1] == before[1, 1]
    np.testing.assert_allclose(timing, before, rtol=0.0, atol=1e-15)


def test_a_dwell_lasts_as_long_where_axes_meet() -> None:
    # motion and dwell, the motion of the second axis a rounding error shorter
    timing = np.array([[0.0, 0.1], [0.1, 0.5], [0.0, 0.1 - 3e-16], [0.1 - 3e-16, 0.5]])
    offsets = np.array([0, 2, 4])
    meet_ends(0.5, 0.5, timing, offsets)
    assert timing[3, 1] == 0.5
    np.testing.assert_allclose(timing[2:], timing[:2], rtol=0.0, atol=1e-16)
