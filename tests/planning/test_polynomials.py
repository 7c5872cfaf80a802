"""Exact extrema against dense sampling and closed forms."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from segfmu.planning.polynomials import extrema, piece_extrema


def test_parabola_in_closed_form() -> None:
    assert piece_extrema(np.array([1.0, -2.0, 1.0]), 3.0) == pytest.approx((0.0, 4.0))
    assert piece_extrema(np.array([2.0]), 1.0) == (2.0, 2.0)


@given(
    st.lists(st.lists(st.floats(-5.0, 5.0), min_size=8, max_size=8), min_size=1, max_size=4),
    st.floats(0.05, 2.0),
    st.integers(0, 5),
)
def test_extrema_bound_and_reach_the_samples(rows, length: float, derivative: int) -> None:
    coefficients = np.array(rows)
    low, high = extrema(coefficients, np.full(len(rows), length), derivative)
    times = np.linspace(0.0, length, 2001)
    values = np.array([np.polynomial.Polynomial(r).deriv(derivative)(times) for r in rows])
    scale = max(1.0, float(np.abs(values).max()))
    assert low <= values.min() + 1e-9 * scale
    assert high >= values.max() - 1e-9 * scale
    assert low == pytest.approx(values.min(), abs=1e-3 * scale)
    assert high == pytest.approx(values.max(), abs=1e-3 * scale)
