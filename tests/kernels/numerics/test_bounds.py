"""Bounds of polynomials against samples, and those of straight lines, which are exact."""

from __future__ import annotations

import numpy as np
import pytest

from segfmu.kernels.numerics.bounds import polynomial_bounds


@pytest.mark.parametrize("count", range(1, 13))
@pytest.mark.parametrize("length", [0.0, 1e-3, 1.0, 7.0])
def test_a_polynomial_stays_between_its_bounds(count: int, length: float) -> None:
    random = np.random.default_rng(count)
    coefficients = random.uniform(-1.0, 1.0, count)
    values = np.polynomial.Polynomial(coefficients)(np.linspace(0.0, length, 200))
    least, most = polynomial_bounds(coefficients.copy(), count, length)
    small = 1e-13 * np.abs(coefficients * length ** np.arange(count)).sum()
    assert least <= values.min() + small and most >= values.max() - small
    if count <= 2:
        assert (least, most) == pytest.approx((values.min(), values.max()), abs=small)
    # halves of an interval have closer ones
    half = polynomial_bounds(coefficients.copy(), count, 0.5 * length)
    assert least - small <= half[0] and half[1] <= most + small


def test_a_constant_sign_of_all_bernstein_coefficients_is_told() -> None:
    # (1 - t)^2 on [0, 1] has the coefficients 1, 0, 0
    assert polynomial_bounds(np.array([1.0, -2.0, 1.0]), 3, 1.0) == (0.0, 1.0)
