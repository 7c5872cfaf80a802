"""Banded systems against NumPy's full ones."""

from __future__ import annotations

import numpy as np
import pytest

from segfmu.kernels.numerics.banded import band_factor, band_substitute


@pytest.mark.parametrize("width", [1, 2, 5])
@pytest.mark.parametrize("size", [1, 2, 9])
def test_the_solution_is_that_of_the_full_system(size: int, width: int) -> None:
    random = np.random.default_rng((size, width))
    lower = np.tril(np.triu(random.uniform(-1.0, 1.0, (size, size)), 1 - width))
    np.fill_diagonal(lower, 1.0)
    matrix = lower @ lower.T
    right = random.uniform(-1.0, 1.0, size)
    rows = np.zeros((size, width + 3))
    for i in range(size):
        for k in range(min(width, i + 1)):
            rows[i, 2 + k] = matrix[i, i - k]
    rows[:, 1] = right
    assert band_factor(width, 2, rows)
    band_substitute(width, 2, 1, rows)
    np.testing.assert_allclose(rows[:, 1], np.linalg.solve(matrix, right), rtol=1e-9)
    assert not rows[:, [0, width + 2]].any()


def test_a_matrix_that_is_not_positive_definite_has_no_factor() -> None:
    for diagonal in (0.0, -1.0, np.nan):
        assert not band_factor(1, 0, np.array([[1.0], [diagonal]]))
