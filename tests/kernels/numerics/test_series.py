"""Arithmetic with Taylor series against series known in closed form."""

from __future__ import annotations

from math import factorial

import numpy as np
import pytest

from segfmu.kernels.numerics import series

COUNT = 8
K = np.arange(COUNT)
FACTORIALS = np.array([factorial(k) for k in K], dtype=float)
EXP = 1.0 / FACTORIALS
SIN = np.array([0.0, 1.0, 0.0, -1.0] * 2) / FACTORIALS
COS = np.array([1.0, 0.0, -1.0, 0.0] * 2) / FACTORIALS


def formed(operation, *operands: np.ndarray, scratch: bool = False) -> np.ndarray:
    found = np.full(COUNT + 1, 7.0)
    work = [np.zeros(COUNT)] if scratch else []
    operation(*operands, COUNT, *work, found)
    assert found[COUNT] == 7.0
    return found[:COUNT]


def test_sums_are_of_coefficients() -> None:
    assert formed(series.series_sum, SIN, COS) == pytest.approx(SIN + COS)
    assert formed(series.series_difference, SIN, COS) == pytest.approx(SIN - COS)
    assert formed(series.series_negative, SIN) == pytest.approx(-SIN)


def test_a_result_may_take_an_operands_place() -> None:
    a = SIN.copy()
    series.series_difference(a, COS, COUNT, a)
    series.series_negative(a, COUNT, a)
    series.series_sum(a, SIN, COUNT, a)
    assert a == pytest.approx(COS)


def test_product_and_quotient() -> None:
    assert formed(series.series_product, EXP, EXP) == pytest.approx(2.0**K * EXP)
    assert formed(series.series_quotient, SIN, EXP) == pytest.approx(
        np.convolve(SIN, (-1.0) ** K * EXP)[:COUNT]
    )


def test_root_of_a_square() -> None:
    assert formed(series.series_root, 2.0**K * EXP) == pytest.approx(EXP)


def test_angle_of_a_turning_pointer() -> None:
    # the pointer r (cos, sin) at the angle t + 2, with r = exp(t)
    c, s = np.cos(2.0), np.sin(2.0)
    x = np.convolve(EXP, c * COS - s * SIN)[:COUNT]
    y = np.convolve(EXP, s * COS + c * SIN)[:COUNT]
    expected = np.zeros(COUNT)
    expected[:2] = 2.0, 1.0
    found = formed(series.series_angle, y, x, 2.0**K * EXP, scratch=True)
    assert found == pytest.approx(expected, abs=1e-14)


def test_derivatives_and_back() -> None:
    values = np.arange(30.0).reshape(10, 3) + 1.0
    found = np.zeros(COUNT)
    series.series_of_derivatives(values, 2, 1, COUNT, found)
    assert found == pytest.approx(values[2:, 1] / FACTORIALS)
    for order in K:
        assert series.series_derivative(found, int(order)) == pytest.approx(values[2 + order, 1])
        assert series.series_factorial(int(order)) == factorial(order)
