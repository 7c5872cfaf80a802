"""Small matrices against NumPy; beyond their first rows and columns nothing is touched."""

from __future__ import annotations

import numpy as np
import pytest

from segfmu.kernels.numerics import matrices

pytestmark = pytest.mark.interpreted


def padded(a: np.ndarray) -> np.ndarray:
    """In the corner of a larger array of sevens."""
    array = np.full((a.shape[0] + 2, a.shape[1] + 3), 7.0)
    array[: a.shape[0], : a.shape[1]] = a
    return array


@pytest.fixture(params=[1, 2, 6])
def pair(request) -> tuple[int, np.ndarray, np.ndarray]:
    random = np.random.default_rng(request.param)
    return request.param, *random.normal(size=(2, request.param, request.param))


def test_products_sums_and_copies(pair) -> None:
    n, a, b = pair
    for function, expected in (
        (matrices.matrix_product, a @ b), (matrices.matrix_product_transposed, a @ b.T),
    ):
        found = padded(np.zeros((n, n)))
        function(n, padded(a), padded(b), found)
        assert found == pytest.approx(padded(expected), abs=1e-14)
    for call, expected in (
        (lambda c: matrices.matrix_add(n, 0.5, padded(a), c), b + 0.5 * a),
        (lambda c: matrices.matrix_copy(n, padded(a), c), a),
        (lambda c: matrices.matrix_transpose(n, padded(a), c), a.T),
        (lambda c: matrices.matrix_set(n, 3.0, c), 3.0 * np.eye(n)),
    ):
        found = padded(b)
        call(found)
        assert found.tolist() == padded(expected).tolist()


@pytest.mark.parametrize("columns", [1, 4])
def test_solution_is_that_of_numpy(pair, columns: int) -> None:
    n, a, _ = pair
    b = np.random.default_rng(5).normal(size=(n, columns))
    found = padded(b)
    matrices.matrix_solve(n, columns, padded(a), found)
    assert found == pytest.approx(padded(np.linalg.solve(a, b)), rel=1e-10, abs=1e-11)


def test_rows_are_exchanged_where_a_pivot_is_zero() -> None:
    a = np.array([[0.0, 2.0, 0.0], [1e-20, 0.0, 3.0], [4.0, 1.0, 1.0]])
    found = np.array([[2.0], [6.0], [7.0]])
    matrices.matrix_solve(3, 1, a.copy(), found)
    assert found.ravel() == pytest.approx([1.0, 1.0, 2.0], rel=1e-14)
