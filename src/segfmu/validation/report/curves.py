"""Curves with as many points as a screen can show."""

from __future__ import annotations

from itertools import pairwise
from math import ceil, log10

import numpy as np
from numpy.typing import NDArray

from segfmu.arrays import FloatArray

# over the width of a chart, each with its least and its greatest value
BUCKETS = 400
# of the height of a chart, about a third of a pixel
TOLERANCE = 2e-3


def thinned(x: FloatArray, y: FloatArray, height: float) -> tuple[FloatArray, FloatArray]:
    """The points of a curve that show in a chart of this height [unit of y].

    Peaks are kept: first the least and the greatest value of each bucket, of these the points that
    are off the straight line between those that stay. What is no number is left out.
    """
    finite = np.isfinite(y)
    x, y = x[finite], y[finite]
    if y.size == 0:
        return x, y
    places = _extremes(y)
    x, y = x[places], y[places]
    kept = _bent(x, y, TOLERANCE * height)
    return x[kept], y[kept]


def digits(values: FloatArray, height: float) -> list[float]:
    """Finite numbers rounded to what shows in a chart of this height."""
    places = max(0, ceil(-log10(height * TOLERANCE * 0.05))) if height > 0.0 else 0
    return [round(float(value), places) for value in values]


def _extremes(y: FloatArray) -> NDArray[np.intp]:
    """Places of the least and the greatest value of each bucket, and both ends."""
    if y.size <= 2 * BUCKETS:
        return np.arange(y.size)
    edges = np.linspace(0, y.size, BUCKETS + 1).astype(int)
    found = {0, y.size - 1}
    for first, last in pairwise(edges):
        found |= {first + int(y[first:last].argmin()), first + int(y[first:last].argmax())}
    return np.array(sorted(found))


def _bent(x: FloatArray, y: FloatArray, tolerance: float) -> NDArray[np.intp]:
    """Places of the points that a polyline within a tolerance needs.

    D. Douglas, T. Peucker, Algorithms for the reduction of the number of points, 1973; with the
    distance along y.
    """
    kept = np.zeros(y.size, dtype=bool)
    kept[[0, -1]] = True
    spans = [(0, y.size - 1)]
    while spans:
        first, last = spans.pop()
        if last - first < 2:
            continue
        inner = slice(first + 1, last)
        line = np.interp(x[inner], x[[first, last]], y[[first, last]])
        off = np.abs(y[inner] - line)
        place = int(off.argmax())
        if off[place] > tolerance:
            middle = first + 1 + place
            kept[middle] = True
            spans += [(first, middle), (middle, last)]
    return np.flatnonzero(kept)
