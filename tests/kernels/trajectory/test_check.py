"""The judge of a plan: it passes what keeps the limits and finds what does not, between samples."""

from __future__ import annotations

from math import factorial

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from segfmu import Limits, Waypoint, plan
from segfmu.kernels.planner.records import WaypointState
from segfmu.kernels.trajectory.check import (
    bernstein_coefficients,
    check_plan,
    integrate_hull,
    switching_time,
    within,
)
from segfmu.kernels.trajectory.records import Check, Hull
from segfmu.planning.polynomials import piece_extrema

LIMITS = Limits([1.0, 0.4], [1.0, 0.5], [1.0, 0.5], [10.0, 5.0])
POINTS = [
    Waypoint([0.0, 0.0]), Waypoint([0.07, 0.055], [0.2, 0.17], [0.34, 0.27]),
    Waypoint([1.0, 0.8], dwell=0.5),
]


def judged(change=lambda arrays: None, limits: Limits = LIMITS) -> int:
    trajectory = plan(POINTS, LIMITS)
    arrays = {
        "states": np.stack(
            [np.column_stack([p.position, p.velocity, p.acceleration]) for p in POINTS]
        ),
        "times": np.vstack([trajectory.axis_waypoint_times, trajectory.axis_durations]),
        "timing": trajectory.timing.copy(),
        "coefficients": trajectory.coefficients.copy(),
        "offsets": trajectory.offsets.copy(),
        "limits": limits.table(2, 4).copy(),
        # as in the positive direction
        "lower": np.zeros((2, 2)),
    }
    change(arrays)
    with np.errstate(all="ignore"):
        return check_plan(*arrays.values(), 1e-9, 5e-10, np.zeros((Check.SIZE, Check.COLUMNS)))


def test_a_plan_passes() -> None:
    assert judged() == 0


@pytest.mark.parametrize("row", [0, 3, -1])
@pytest.mark.parametrize("column", range(8))
@pytest.mark.parametrize("change", [0.1, np.nan, np.inf])
def test_a_changed_coefficient_is_found(row: int, column: int, change: float) -> None:
    def add(arrays) -> None:
        arrays["coefficients"][row, column] += change * max(
            1.0, abs(arrays["coefficients"][row, column])
        )

    assert judged(add) == (2 if row == -1 else 1)


@pytest.mark.parametrize("derivative", range(WaypointState.SIZE))
@pytest.mark.parametrize("point", [0, 1, 2])
def test_a_missed_waypoint_is_found(derivative: int, point: int) -> None:
    def move(arrays) -> None:
        arrays["states"][point, 1, derivative] += 1e-7

    assert judged(move) == 2


@pytest.mark.parametrize("order", range(4))
def test_a_tighter_limit_is_found(order: int) -> None:
    peaks = np.maximum(*np.abs(np.array(plan(POINTS, LIMITS).extrema(order + 1))))

    def tighten(arrays) -> None:
        arrays["limits"][0, order] = peaks[0] * (1.0 - 1e-6)

    def touch(arrays) -> None:
        arrays["limits"][0, order] = peaks[0]

    assert judged(tighten) == 1
    assert judged(touch) == 0


def test_a_tighter_limit_of_the_negative_direction_is_found() -> None:
    peak = -plan(POINTS, LIMITS).extrema(2)[0][0]

    def tighten(arrays) -> None:
        arrays["lower"][0, 1] = peak * (1.0 - 1e-6)

    def touch(arrays) -> None:
        arrays["lower"][0, 1] = peak

    assert judged(tighten) == 1
    assert judged(touch) == 0


def late_arrival(shift: float) -> int:
    """The verdict of minutes that end with a pop that changes within 74 us, all times shifted."""
    limits = Limits(velocity=0.1354, acceleration=0.0534, snap=0.437, crackle=13.0)
    trajectory = plan([Waypoint(0.0), Waypoint(45.0)], limits, smoothness=6)
    states = np.stack([point.state(6) for point in trajectory.waypoints])
    times = np.vstack([trajectory.axis_waypoint_times, trajectory.axis_durations])
    times[1:] += shift * trajectory.duration
    return check_plan(
        states, times, trajectory.timing, trajectory.coefficients, trajectory.offsets,
        limits.table(1, 6), limits.lower(1), 1e-9, 5e-10, np.zeros((Check.SIZE, Check.COLUMNS)),
    )


@pytest.mark.parametrize("shift", [0.0, -1e-15, 1e-15, -2e-13])
def test_rounding_of_the_clock_is_no_error(shift: float) -> None:
    assert late_arrival(shift) == 0


@pytest.mark.parametrize("shift", [-1e-10, -1e-3])
def test_an_arrival_too_soon_is_found(shift: float) -> None:
    assert late_arrival(shift) == 1


@pytest.mark.parametrize(
    ("time", "row", "local"),
    [(0.0, 0, 0.0), (1e-13, 0, 1e-13), (2e-13, 1, 0.0), (0.4, 1, 0.4), (1.0, 1, 1.0)],
)
def test_a_waypoint_lies_at_the_nearest_switching_time(time, row: int, local: float) -> None:
    timing = np.array([[0.0, 1e-13], [1e-13, 1.0]])
    assert switching_time(time, 1.0, timing, row) == pytest.approx(local, rel=1e-12, abs=1e-15)


@settings(max_examples=200, deadline=None)
@given(
    st.lists(st.floats(-3.0, 3.0), min_size=4, max_size=12), st.floats(0.1, 3.0),
    st.integers(0, 2), st.floats(-0.2, 0.2),
)
@example([0.0, 0.0, 0.0, 0.0], 1.0, 0, -0.125)
def test_verdict_is_that_of_the_roots(values, length: float, derivative: int, margin) -> None:
    coefficients = np.array([values])
    hull = np.zeros((40, Hull.SIZE))
    count = len(values)
    if derivative == 0:
        bernstein_coefficients(coefficients, 0, count, length, hull)
    else:
        # from its own derivative
        count -= derivative
        slopes = np.polynomial.Polynomial(values).deriv(derivative + 1).coef[None]
        bernstein_coefficients(slopes, 0, count - 1, length, hull)
        start = factorial(derivative) * values[derivative]
        largest = integrate_hull(count - 1, start, length, hull[0])
        assert largest == np.abs(hull[0, :count]).max()
    polynomial = np.polynomial.Polynomial(values).deriv(derivative)
    low, high = piece_extrema(polynomial.coef, length)
    largest = max(-low, high)
    peak = max(largest, 1e-9)
    assert hull[0, 0] == pytest.approx(polynomial(0.0), abs=1e-9 * peak)
    assert hull[0, count - 1] == pytest.approx(polynomial(length), abs=1e-9 * peak)
    if abs(margin) > 1e-6:
        bound = peak * (1.0 + margin)
        assert within(hull.copy(), count, -bound, bound) == (largest <= bound)
        # on one side alone
        lowest, highest = (-bound, 2.0 * peak) if -low >= high else (-2.0 * peak, bound)
        assert within(hull, count, lowest, highest) == (largest <= bound)


def test_the_end_after_a_dwell_is_checked() -> None:
    """The last dwell drifts away, smoothly and within all limits."""
    def drift(arrays) -> None:
        arrays["coefficients"][-1, 7] = 1e-5

    assert plan(POINTS, LIMITS).timing[-1, 1] == pytest.approx(0.5)
    assert judged(drift) == 2


@pytest.mark.parametrize("count", [4, 9])
def test_what_is_no_number_keeps_no_limit(count: int) -> None:
    for place in range(count):
        hull = np.zeros((40, Hull.SIZE))
        hull[0, place] = np.nan
        assert not within(hull, count, -1.0, 1.0)
