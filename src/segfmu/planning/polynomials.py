"""Exact extrema of piecewise polynomials, independent of the planner.

A polynomial on [0, h] lies in the hull of its Bernstein coefficients, which decides most pieces
at once; the others need the roots of the derivative.
"""

from __future__ import annotations

from functools import cache
from math import comb, perm

import numpy as np

from segfmu.arrays import FloatArray


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


def inside_from(
    starts: FloatArray, lengths: FloatArray, coefficients: FloatArray, derivative: int,
    least: float, most: float,
) -> float:
    """Time from which on a derivative of one axis is within least .. most; 0 if always."""
    pieces = derivative_pieces(coefficients, derivative)
    hull = hulls(pieces, lengths)
    for i in np.flatnonzero((hull.min(axis=1) < least) | (hull.max(axis=1) > most))[::-1].tolist():
        shares, values = piece_turns(pieces[i], float(lengths[i]))
        order = np.argsort(shares)
        shares, values = shares[order], values[order]
        beyond = np.flatnonzero((values < least) | (values > most))
        if beyond.size == 0:
            continue
        last = int(beyond[-1])
        scaled = pieces[i] * lengths[i] ** np.arange(pieces.shape[1])
        # from its last turn beyond the limit the derivative is monotonic to the next one
        low, high = float(shares[last]), float(shares[min(last + 1, shares.size - 1)])
        for _ in range(60):
            middle = 0.5 * (low + high)
            if least <= float(np.polynomial.polynomial.polyval(middle, scaled)) <= most:
                high = middle
            else:
                low = middle
        return float(starts[i] + high * lengths[i])
    return 0.0


def split(
    starts: FloatArray, lengths: FloatArray, coefficients: FloatArray, time: float
) -> tuple[tuple[FloatArray, FloatArray], tuple[FloatArray, FloatArray]]:
    """Lengths and coefficients of the pieces of one axis before a time [s], and of those after."""
    before = np.clip(time - starts, 0.0, lengths)
    first, width = before > 0.0, coefficients.shape[1]
    rest = coefficients.copy()
    for i in np.flatnonzero(first):
        for j in range(width):
            shifted = derivative_pieces(coefficients[i : i + 1], j)[0] / float(perm(j, j))
            rest[i, j] = np.polynomial.polynomial.polyval(before[i], shifted)
    behind = before < lengths
    return (before[first], coefficients[first]), ((lengths - before)[behind], rest[behind])
