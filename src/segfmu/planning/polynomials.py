"""Exact extrema of piecewise polynomials, independent of the planner.

A polynomial on [0, h] lies in the hull of its Bernstein coefficients, which decides most pieces
at once; the others need the roots of the derivative.
"""

from __future__ import annotations

from functools import cache
from math import comb, perm

import numpy as np

from segfmu.planning.arrays import FloatArray


@cache
def _bernstein(width: int) -> FloatArray:
    """Matrix from powers of s on [0, 1] to Bernstein coefficients, shape (width, width)."""
    degree = width - 1
    return np.array(
        [
            [comb(j, i) / comb(degree, i) if i <= j else 0.0 for j in range(width)]
            for i in range(width)
        ]
    )


@cache
def _factors(width: int, derivative: int) -> FloatArray:
    return np.array([float(perm(i, derivative)) for i in range(derivative, width)])


def derivative_pieces(coefficients: FloatArray, derivative: int) -> FloatArray:
    """Ascending coefficients of a derivative of every piece, shape (pieces, width - derivative)."""
    width = coefficients.shape[1]
    if derivative >= width:
        return np.zeros((coefficients.shape[0], 1))
    return coefficients[:, derivative:] * _factors(width, derivative)


def hulls(pieces: FloatArray, lengths: FloatArray) -> FloatArray:
    """Bernstein coefficients of every piece on [0, length], shape (pieces, width)."""
    width = pieces.shape[1]
    scaled: FloatArray = pieces * lengths[:, None] ** np.arange(width)
    return scaled @ _bernstein(width)


def piece_extrema(piece: FloatArray, length: float) -> tuple[float, float]:
    """Exact minimum and maximum of one piece on [0, length], from the roots of its derivative."""
    _, values = piece_turns(piece, length)
    return float(values.min()), float(values.max())


def piece_turns(piece: FloatArray, length: float) -> tuple[FloatArray, FloatArray]:
    """Ends and turning points of one piece as shares of its length, and the values there."""
    scaled = piece * length ** np.arange(piece.size)
    slope = scaled[1:] * np.arange(1, piece.size)
    size = float(np.max(np.abs(slope), initial=0.0))
    candidates = [0.0, 1.0]
    if size > 0.0:
        significant = np.trim_zeros(np.where(np.abs(slope) > 1e-14 * size, slope, 0.0), "b")
        roots = np.polynomial.polynomial.polyroots(significant)
        real = roots.real[np.abs(roots.imag) < 1e-6]
        candidates.extend(real[(real > 0.0) & (real < 1.0)].tolist())
    shares = np.array(candidates)
    return shares, np.polynomial.polynomial.polyval(shares, scaled)


def extrema(coefficients: FloatArray, lengths: FloatArray, derivative: int) -> tuple[float, float]:
    """Exact minimum and maximum of a derivative over all pieces of one axis."""
    pieces = derivative_pieces(coefficients, derivative)
    hull = hulls(pieces, lengths)
    ends = hull[:, [0, -1]]
    low, high = float(ends.min()), float(ends.max())
    for i in np.flatnonzero((hull.min(axis=1) < low) | (hull.max(axis=1) > high)):
        if hull[i].min() < low or hull[i].max() > high:
            least, most = piece_extrema(pieces[i], float(lengths[i]))
            low, high = min(low, least), max(high, most)
    return low, high
