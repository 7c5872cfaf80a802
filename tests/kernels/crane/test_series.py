"""Taylor arithmetic against the generated flat inverse and difference quotients of it."""

from __future__ import annotations

import numpy as np
import pytest

from segfmu.kernels import backend
from segfmu.kernels.crane.records import FlatSeries

MASSES = (2.2, 1.155, 1.3, 9.81)


def motion(t: float, order: int) -> np.ndarray:
    """Derivatives 0 .. order + 4 of a load that moves on sines, (order + 5, 3)."""
    scale, rate, phase = np.array([0.4, 0.3, 0.1]), np.array([1.1, 1.7, 2.3]), [0.2, 1.0, 2.0]
    rows = [
        scale * rate**d * np.sin(rate * t + phase + 0.5 * np.pi * d) for d in range(order + 5)
    ]
    rows[0][2] -= 1.0
    return np.array(rows)


def inverse(t: float) -> np.ndarray:
    found = np.zeros(18)
    backend.crane_flat_inverse(motion(t, 0), np.array(MASSES), found[:3], found[3:13], found[13:])
    return found


def derivatives(t: float, order: int) -> np.ndarray:
    found = np.zeros(18)
    backend.flat_derivatives(
        motion(t, order), order, np.array(MASSES), np.zeros((FlatSeries.SIZE, order + 3)), found
    )
    return found


@pytest.mark.parametrize("t", [0.0, 0.7, 1.9])
def test_order_zero_is_the_flat_inverse(t: float) -> None:
    assert derivatives(t, 0) == pytest.approx(inverse(t), rel=1e-12, abs=1e-12)


@pytest.mark.parametrize("order", [1, 2, 3, 4])
def test_each_order_is_the_rate_of_the_one_before(order: int) -> None:
    h = 1e-3
    for t in (0.3, 1.1, 2.0):
        # five-point difference quotient: error of h^4
        rows = [derivatives(t + i * h, order - 1) for i in (-2, -1, 1, 2)]
        quotient = (rows[0] - 8.0 * rows[1] + 8.0 * rows[2] - rows[3]) / (12.0 * h)
        found = derivatives(t, order)
        assert found == pytest.approx(quotient, rel=1e-7, abs=1e-7 * np.abs(found).max())
