"""When a trajectory is within given bounds, from the roots of its polynomial pieces.

Bernstein hulls decide most pieces; only those that may cross a bound need roots. Times are
sorted, disjoint intervals, shape (intervals, 2).
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from segfmu.arrays import FloatArray
from segfmu.planning.polynomials import hulls
from segfmu.planning.trajectory import Trajectory

# of the duration: shorter gaps between pieces and intervals are rounding
ROUNDING = 1e-11


def within(trajectory: Trajectory, axis: int, low: float, high: float) -> FloatArray:
    """Intervals of time [s] in which low < position < high, shape (intervals, 2)."""
    starts, lengths, coefficients = _gapless(trajectory, axis)
    hull = hulls(coefficients, lengths)
    least, most = hull.min(axis=1), hull.max(axis=1)
    inside = (least > low) & (most < high)
    crossing = ~inside & (most > low) & (least < high)
    found = [np.column_stack([starts[inside], starts[inside] + lengths[inside]])]
    for i in np.flatnonzero(crossing):
        levels = [level for level in (low, high) if least[i] <= level <= most[i]]
        cuts = _cuts(coefficients[i], float(lengths[i]), levels)
        found.append(starts[i] + _between(cuts, coefficients[i], low, high))
    return joined(np.concatenate(found), ROUNDING * trajectory.duration)


def outside(intervals: FloatArray, end: float) -> FloatArray:
    """The times from 0 to an end that are in no interval."""
    edges = np.concatenate([[0.0], intervals.ravel(), [end]]).reshape(-1, 2)
    return np.asarray(edges[edges[:, 1] - edges[:, 0] > ROUNDING * end])


def joined(intervals: FloatArray, gap: float) -> FloatArray:
    """Intervals in order, those that follow each other within a gap joined."""
    order = intervals[np.argsort(intervals[:, 0], kind="stable")]
    found: list[list[float]] = []
    for begin, end in order:
        if found and begin <= found[-1][1] + gap:
            found[-1][1] = max(found[-1][1], float(end))
        else:
            found.append([float(begin), float(end)])
    return np.array(found).reshape(-1, 2)


def _gapless(trajectory: Trajectory, axis: int) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Pieces from 0 to the trajectory's end, with pieces of rest where the axis has none."""
    starts, lengths, coefficients = trajectory.pieces(axis)
    ends = starts + lengths
    edges = np.concatenate([[0.0], ends]), np.concatenate([starts, [trajectory.duration]])
    rest = np.flatnonzero(edges[1] - edges[0] > ROUNDING * trajectory.duration)
    if rest.size == 0:
        return starts, lengths, coefficients
    still = np.zeros((rest.size, coefficients.shape[1]))
    # a moment within the rest, where the trajectory itself gives the position
    still[:, 0] = trajectory(0.5 * (edges[0][rest] + edges[1][rest]))[:, axis]
    return (
        np.concatenate([starts, edges[0][rest]]),
        np.concatenate([lengths, edges[1][rest] - edges[0][rest]]),
        np.concatenate([coefficients, still]),
    )


def _cuts(piece: FloatArray, length: float, levels: Sequence[float]) -> FloatArray:
    """Ends of one piece and where it passes levels, in local time."""
    scaled = piece * length ** np.arange(piece.size)
    passed = [_roots(scaled, level) for level in levels]
    return np.unique(np.concatenate([[0.0, 1.0], *passed])) * length


def _between(cuts: FloatArray, piece: FloatArray, low: float, high: float) -> FloatArray:
    """Intervals between cuts in which one piece is within the bounds."""
    middles = np.polynomial.polynomial.polyval(0.5 * (cuts[:-1] + cuts[1:]), piece)
    inside = (middles > low) & (middles < high)
    return np.asarray(np.column_stack([cuts[:-1], cuts[1:]])[inside])


def _roots(scaled: FloatArray, level: float) -> FloatArray:
    """Times in (0, 1) at which a polynomial has a value, those of double roots included."""
    shifted = scaled.copy()
    shifted[0] -= level
    size = float(np.abs(shifted).max())
    significant = np.trim_zeros(np.where(np.abs(shifted) > 1e-15 * size, shifted, 0.0), "b")
    if significant.size < 2:
        return np.zeros(0)
    roots = np.polynomial.polynomial.polyroots(significant)
    # rounding moves a double root off the axis by the square root of the precision
    real = np.asarray(roots.real[np.abs(roots.imag) < 1e-6])
    return real[(real > 0.0) & (real < 1.0)]
