"""Ranges of an axis over all of its pieces, from Bernstein coefficients: wide, but cheap."""

from segfmu.kernels.numerics.numbers import NEVER
from segfmu.kernels.trajectory.check import bernstein_coefficients
from segfmu.kernels.trajectory.records import Timing


def sum_range(
    axis: int,
    share: float,
    lean: float,
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
    offsets: 'int[:]',
    work: 'float[:,:]',
) -> 'tuple[float, float]':
    """Bounds of share p + lean p'' in all pieces of an axis, from their Bernstein coefficients."""
    width = coefficients.shape[1]
    least = NEVER
    most = -NEVER
    for piece in range(offsets[axis], offsets[axis + 1]):
        for i in range(width):
            work[1, i] = share * coefficients[piece, i]
        for i in range(width - 2):
            second = (i + 1) * (i + 2) * coefficients[piece, i + 2]
            work[1, i] = work[1, i] + lean * second
        bernstein_coefficients(work, 1, width, timing[piece, Timing.LENGTH], work)
        for i in range(width):
            least = min(least, work[0, i])
            most = max(most, work[0, i])
    return least, most
