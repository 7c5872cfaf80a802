"""Ranges of an axis over all of its pieces, from Bernstein coefficients: wide, but cheap."""

from segfmu.kernels.numerics.bounds import polynomial_bounds
from segfmu.kernels.numerics.numbers import NEVER
from segfmu.kernels.trajectory.records import Timing


def sum_range(
    axis: int,
    share: float,
    lean: float,
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
    offsets: 'int[:]',
    values: 'float[:]',
) -> 'tuple[float, float]':
    """Bounds of share p + lean p'' in all pieces of an axis; values are work space."""
    width = coefficients.shape[1]
    count = width if share != 0.0 else width - 2
    lowest = NEVER
    highest = -NEVER
    for piece in range(offsets[axis], offsets[axis + 1]):
        for i in range(count):
            values[i] = share * coefficients[piece, i]
        for i in range(width - 2):
            second = (i + 1) * (i + 2) * coefficients[piece, i + 2]
            values[i] = values[i] + lean * second
        least, most = polynomial_bounds(values, count, timing[piece, Timing.LENGTH])
        lowest = min(lowest, least)
        highest = max(highest, most)
    return lowest, highest
