"""Banded systems of positive definite matrices, in columns of an array.

A row has its matrix's entries from the diagonal to the left, `width` of them from a column on.
"""

from math import sqrt


def band_factor(width: int, first: int, rows: 'float[:,:]') -> bool:
    """Factor a matrix in place (Cholesky); False if it is not positive definite."""
    for i in range(rows.shape[0]):
        for j in range(max(0, i - width + 1), i + 1):
            total = rows[i, first + i - j]
            for k in range(max(0, i - width + 1), j):
                total = total - rows[i, first + i - k] * rows[j, first + j - k]
            if i == j:
                if not total > 0.0:
                    return False
                rows[i, first] = sqrt(total)
            else:
                rows[i, first + i - j] = total / rows[j, first]
    return True


def band_substitute(width: int, first: int, column: int, rows: 'float[:,:]') -> None:
    """Replace a column, the right-hand side, by the solution, with the factor of the matrix."""
    for i in range(rows.shape[0]):
        total = rows[i, column]
        for k in range(max(0, i - width + 1), i):
            total = total - rows[i, first + i - k] * rows[k, column]
        rows[i, column] = total / rows[i, first]
    for step in range(rows.shape[0]):
        i = rows.shape[0] - 1 - step
        total = rows[i, column]
        for k in range(i + 1, min(i + width, rows.shape[0])):
            total = total - rows[k, first + k - i] * rows[k, column]
        rows[i, column] = total / rows[i, first]
