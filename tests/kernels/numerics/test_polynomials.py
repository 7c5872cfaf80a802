"""Polynomials against NumPy's."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.polynomial import Polynomial

from segfmu.kernels.numerics import polynomials

A, B = np.random.default_rng(8).normal(size=(2, 6))


@pytest.mark.parametrize("order", [0, 1, 2, 5])
def test_derivatives(order: int) -> None:
    found = np.full(7, 9.0)
    polynomials.polynomial_differentiate(A, 6, order, found)
    assert found[: 6 - order] == pytest.approx(Polynomial(A).deriv(order).coef)
    assert list(found[6 - order :]) == [9.0] * (1 + order)


def test_products_are_added() -> None:
    found = np.ones(11)
    polynomials.polynomial_add_product(A, 6, B, 4, found)
    assert found[:9] == pytest.approx(1.0 + np.convolve(A, B[:4]))
    assert list(found[9:]) == [1.0, 1.0]
    polynomials.polynomial_clear(found)
    assert not found.any()


def test_a_shifted_polynomial_has_the_values_further_on() -> None:
    shifted = A.copy()
    polynomials.polynomial_shift(shifted, 0.7, 6)
    t = np.linspace(-1.0, 1.0, 5)
    assert Polynomial(shifted)(t) == pytest.approx(Polynomial(A)(t + 0.7))
