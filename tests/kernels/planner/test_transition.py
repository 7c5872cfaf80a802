"""Transition polynomials against closed forms and against plain numerical integration."""

from __future__ import annotations

from math import comb, factorial, sqrt

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from segfmu.kernels.planner.parameters import axis_limits, ramp_parameters
from segfmu.kernels.planner.ramp import ramp_change, ramp_distance, ramp_duration
from segfmu.kernels.planner.ramp_peak import ramp_extreme_velocity
from segfmu.kernels.planner.records import Axis
from segfmu.kernels.planner.transition import transition_coefficients, transition_peaks
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


def psi_curve(order: int, s: float) -> float:
    """The transition polynomial, from its definition as a normalised integral."""
    s = min(max(s, 0.0), 1.0)
    scale = factorial(2 * order + 1) / factorial(order) ** 2
    return scale * sum(
        (-1) ** i * comb(order, i) * s ** (order + 1 + i) / (order + 1 + i)
        for i in range(order + 1)
    )


def snap_plateau(order: int, share: float):
    """Rise of the jerk whose snap rises in a share of the time, stays, and falls, on a grid."""
    s = np.linspace(0.0, 1.0, 20001)
    snap = np.array([psi_curve(order, min(x, 1.0 - x) / share) for x in s])
    rise = np.concatenate([[0.0], np.cumsum(0.5 * (snap[1:] + snap[:-1]))])
    return lambda x: float(np.interp(x, s, rise / rise[-1]))


def jerk_profile(smoothness: int, shape: int, duration: float, rise: float, share: float = 0.0):
    """Jerk of a axis of unit peak, written down from the definition of the two shapes."""
    k = smoothness - 2
    if share > 0.0:
        curve = snap_plateau(k - 2, share)
        return lambda t: curve(min(1.0, t / rise, (duration - t) / rise))
    if shape == 0 or k == 0:
        return lambda t: (t * (duration - t) * 4.0 / duration**2) ** k
    psi = np.polynomial.Polynomial(
        [0.0] * k + [(-1) ** i * comb(k - 1, i) * factorial(2 * k - 1) / factorial(k - 1) ** 2
                     / (k + i) for i in range(k)]
    )
    return lambda t: psi(min(1.0, t / rise, (duration - t) / rise))


@pytest.mark.parametrize("shape", [0, 1])
@pytest.mark.parametrize("smoothness", [2, 3, 4, 5, 6])
@pytest.mark.parametrize("change", [1e-3, 0.2, 3.0])
@pytest.mark.parametrize("highest", [3, 4, 6])
def test_distance_and_velocity_match_integrated_jerk(
    smoothness: int, shape: int, change: float, highest: int
) -> None:
    limits = [1.0, 1.0, 1.3, 4.0, 20.0, 90.0, 0.0][: smoothness + 1]
    limits[highest:] = [0.0] * len(limits[highest:])
    axis = packed_axis(smoothness, shape, limits)
    duration, rise, _ = ramp_duration(change, axis)
    jerk = jerk_profile(smoothness, shape, duration, rise, float(axis[Axis.SNAP_SHARE]))
    times = np.linspace(0.0, duration, 40001)
    values = np.array([jerk(t) for t in times])
    total = np.trapezoid(values, times)
    moment = np.trapezoid(0.5 * (duration - times) ** 2 * values, times)
    v, a = 0.4, -0.7
    expected = v * duration + 0.5 * a * duration**2 + change * moment / total
    found = ramp_distance(v, a, a + change, duration, rise, axis)
    assert found == pytest.approx(expected, abs=1e-7 * change * duration**2)


@given(
    smoothness=st.integers(2, 6),
    shape=st.integers(0, 1),
    exponent=st.floats(-14.0, 2.0),
)
def test_change_inverts_duration(smoothness: int, shape: int, exponent: float) -> None:
    limits = [1.0, 1.0, 1.3, 4.0, 20.0, 90.0, 0.0][: smoothness + 1]
    axis = packed_axis(smoothness, shape, limits)
    change = 10.0**exponent
    duration, _, slope = ramp_duration(change, axis)
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
    limits = [1.0, 1.0, 1.3, 4.0, 20.0, 90.0, 0.0][: smoothness + 1]
    limits[highest:] = [0.0] * len(limits[highest:])
    axis = packed_axis(smoothness, shape, limits)
    duration, rise, _ = ramp_duration(abs(b - a), axis)
    jerk = jerk_profile(smoothness, shape, duration, rise, float(axis[Axis.SNAP_SHARE]))
    times = np.linspace(0.0, duration, 20001)
    values = np.array([jerk(t) for t in times])
    step = times[1] - times[0]
    acceleration = np.concatenate([[0.0], np.cumsum(0.5 * (values[1:] + values[:-1]) * step)])
    acceleration = a + (b - a) * acceleration / acceleration[-1]
    velocity = np.concatenate(
        [[0.0], np.cumsum(0.5 * (acceleration[1:] + acceleration[:-1]) * step)]
    )
    expected = velocity.max() if a > 0.0 else velocity.min()
    found = ramp_extreme_velocity(0.0, a, b, duration, rise, axis)
    assert found == pytest.approx(expected, abs=1e-7)


def test_no_limit_on_the_ramp_is_reported() -> None:
    axis = np.zeros(Axis.SIZE)
    for shape in (0, 1):
        axis_limits(4, shape, np.array([1.0, 1.0, 0.0, 0.0, 0.0]), axis)
        assert not ramp_parameters(0.1, axis, work_space())
