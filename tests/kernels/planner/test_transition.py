"""Transition polynomials against closed forms and against plain numerical integration."""

from __future__ import annotations

from math import factorial, sqrt

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from segfmu.kernels.planner.nested import ramp_pieces
from segfmu.kernels.planner.parameters import axis_limits, ramp_parameters
from segfmu.kernels.planner.ramp import ramp_change, ramp_distance, ramp_duration
from segfmu.kernels.planner.ramp_peak import ramp_extreme_velocity
from segfmu.kernels.planner.records import Axis
from segfmu.kernels.planner.transition import transition_coefficients, transition_peaks
from segfmu.kernels.trajectory.pieces import expand_phases
from segfmu.kernels.trajectory.records import Expansion
from tests.problems import packed_axis, work_space


def coefficients(order: int) -> np.ndarray:
    psi = np.zeros(2 * order + 2)
    transition_coefficients(order, psi)
    return psi


@pytest.mark.parametrize("order", range(7))
def test_coefficients_are_the_sum_of_equation_12(order: int) -> None:
    k = order
    expected = np.zeros(2 * k + 2)
    for i in range(k + 1):
        scale = factorial(2 * k + 1) / factorial(k) * (-1) ** (k - i)
        expected[2 * k - i + 1] = scale / (factorial(i) * factorial(k - i) * (2 * k - i + 1))
    assert coefficients(order) == pytest.approx(expected, rel=1e-13)


def test_known_polynomials_of_errata_e2() -> None:
    assert coefficients(1).tolist() == [0.0, 0.0, 3.0, -2.0]
    assert coefficients(2).tolist() == [0.0, 0.0, 0.0, 10.0, -15.0, 6.0]


@pytest.mark.parametrize(
    ("order", "expected"),
    [(0, [1.0]), (1, [1.5, 6.0]), (2, [1.875, 10.0 / sqrt(3.0), 60.0]), (3, [2.1875])],
)
def test_peaks_of_errata_e3(order: int, expected: list[float]) -> None:
    peaks = np.zeros(order + 2)
    transition_peaks(order, np.zeros(2 * order + 2), peaks)
    assert peaks[1 : len(expected) + 1] == pytest.approx(expected, rel=1e-12)


@pytest.mark.parametrize("order", range(6))
def test_peaks_bound_every_derivative_and_are_reached(order: int) -> None:
    peaks = np.zeros(order + 2)
    transition_peaks(order, np.zeros(2 * order + 2), peaks)
    s = np.linspace(0.0, 1.0, 20001)
    for j in range(1, order + 2):
        values = np.polynomial.Polynomial(coefficients(order)).deriv(j)(s)
        assert np.abs(values).max() <= peaks[j] * (1.0 + 1e-12)
        assert np.abs(values).max() >= peaks[j] * (1.0 - 1e-6)


def ramp_limits(smoothness: int, highest: int) -> list[float]:
    """Limits c_1 .. c_{n+1}, those above c_highest absent."""
    limits = [1.0, 1.0, 1.3, 4.0, 20.0, 90.0, 0.0][: smoothness + 1]
    limits[highest:] = [0.0] * len(limits[highest:])
    return limits


def expanded(axis: np.ndarray, a: float, b: float) -> tuple[np.ndarray, np.ndarray]:
    """Lengths and polynomials of the pieces of a ramp that starts at 0 with no velocity."""
    duration, _ = ramp_duration(abs(b - a), axis)
    width = 2 * int(axis[Axis.SMOOTHNESS])
    timing, pieces = np.zeros((31, 2)), np.zeros((31, width))
    phases = np.array([[duration, duration, a, b - a, 0.0]])
    work = np.zeros((Expansion.SIZE, Expansion.COLUMNS))
    used = expand_phases(phases, 1, axis, timing, pieces, 0, work)
    assert used <= ramp_pieces(axis)
    return timing[:used, 1], pieces[:used]


@pytest.mark.parametrize("shape", [0, 1])
@pytest.mark.parametrize("smoothness", [2, 3, 4, 5, 6])
@pytest.mark.parametrize("change", [1e-3, 0.2, 3.0])
@pytest.mark.parametrize("highest", [3, 4, 5, 6])
def test_a_ramp_is_smooth_keeps_its_limits_and_reaches_one(
    smoothness: int, shape: int, change: float, highest: int
) -> None:
    limits = ramp_limits(smoothness, highest)
    axis = packed_axis(smoothness, shape, limits)
    lengths, pieces = expanded(axis, -0.7, change - 0.7)
    duration, _ = ramp_duration(change, axis)
    peaks = np.zeros(smoothness + 1)
    state = np.zeros(smoothness + 1)
    state[2] = -0.7
    for length, row in zip(lengths, pieces, strict=True):
        curve = np.polynomial.Polynomial(row)
        for d in range(smoothness + 1):
            scale = max(1.0, *peaks, *limits)
            assert curve.deriv(d)(0.0) == pytest.approx(state[d], abs=1e-9 * scale)
            state[d] = curve.deriv(d)(length)
        for d in range(1, smoothness + 2):
            values = curve.deriv(d)(length * np.linspace(0.0, 1.0, 33))
            peaks[d - 1] = max(peaks[d - 1], np.abs(values).max())
    assert lengths.sum() == pytest.approx(duration, rel=1e-12)
    assert state[2] == pytest.approx(change - 0.7, rel=1e-12)
    assert np.abs(state[3:]).max(initial=0.0) <= 1e-9 * max(peaks)
    reached = [p / c for p, c in zip(peaks[2:], limits[2:], strict=True) if c > 0.0]
    # the grid of the peaks misses that of a polynomial by a little
    assert 0.99 < max(reached) <= 1.0 + 1e-9
    distance = ramp_distance(0.4, -0.7, change - 0.7, duration, duration, axis)
    assert distance == pytest.approx(state[0] + 0.4 * duration, rel=1e-12)


@pytest.mark.parametrize("smoothness", [4, 5, 6])
def test_a_loose_limit_above_the_snap_changes_nothing(smoothness: int) -> None:
    given = [1.0, 1.0, 1.3, 4.0, 0.0, 0.0, 0.0][: smoothness + 1]
    expected = ramp_duration(0.7, packed_axis(smoothness, 1, given))
    for d in range(4, smoothness + 1):
        loose = [*given]
        loose[d] = 1e9
        assert ramp_duration(0.7, packed_axis(smoothness, 1, loose)) == expected


@given(
    smoothness=st.integers(2, 6),
    shape=st.integers(0, 1),
    exponent=st.floats(-14.0, 2.0),
)
def test_change_inverts_duration(smoothness: int, shape: int, exponent: float) -> None:
    limits = [1.0, 1.0, 1.3, 4.0, 20.0, 90.0, 0.0][: smoothness + 1]
    axis = packed_axis(smoothness, shape, limits)
    change = 10.0**exponent
    duration, slope = ramp_duration(change, axis)
    back, growth = ramp_change(duration, axis)
    assert back == pytest.approx(change, rel=1e-12)
    assert growth * slope == pytest.approx(1.0, rel=1e-9)


@pytest.mark.parametrize("shape", [0, 1])
@pytest.mark.parametrize("smoothness", [2, 3, 4, 5, 6])
@pytest.mark.parametrize(
    ("a", "b"), [(0.3, -1.0), (1.0, -0.01), (-1e-3, 0.9), (-0.5, 0.5), (0.01, -0.05), (0.1, -0.1)]
)
@pytest.mark.parametrize("highest", [4, 6])
def test_extreme_velocity_is_where_the_acceleration_vanishes(
    smoothness: int, shape: int, a: float, b: float, highest: int
) -> None:
    axis = packed_axis(smoothness, shape, ramp_limits(smoothness, highest))
    lengths, pieces = expanded(axis, a, b)
    reached = [0.0]
    for length, row in zip(lengths, pieces, strict=True):
        velocity = np.polynomial.Polynomial(row).deriv(1)
        zeros = velocity.deriv(1).trim(1e-14).roots() if velocity.degree() > 0 else np.zeros(0)
        inside = zeros.real[(abs(zeros.imag) < 1e-6) & (zeros.real >= 0) & (zeros.real <= length)]
        reached.extend(velocity(np.append(inside, length)))
    expected = max(reached) if a > 0.0 else min(reached)
    duration, _ = ramp_duration(abs(b - a), axis)
    found = ramp_extreme_velocity(0.0, a, b, duration, duration, axis)
    assert found == pytest.approx(expected, abs=1e-12)


def test_no_limit_on_the_ramp_is_reported() -> None:
    axis = np.zeros(Axis.SIZE)
    for shape in (0, 1):
        axis_limits(4, shape, np.array([1.0, 1.0, 0.0, 0.0, 0.0]), axis)
        assert not ramp_parameters(0.1, axis, work_space())
