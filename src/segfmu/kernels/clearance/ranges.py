"""Where a path leads at most: boxes beyond that need no closer look.

The trolley is ahead of the load by lean p'', with lean = -z / (z'' + g). In each piece of an axis
it is between the load and where the greatest lean of all pieces would have it.
"""

from segfmu.kernels.clearance.records import Box, Part, Ranges
from segfmu.kernels.numerics.numbers import NEVER
from segfmu.kernels.trajectory.check import bernstein_coefficients
from segfmu.kernels.trajectory.records import Timing


def path_ranges(
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
    offsets: 'int[:]',
    gravity: float,
    work: 'float[:,:]',
    ranges: 'float[:,:]',
) -> None:
    """Write ranges of load and rope along a trajectory x, y, z of any duration, (Ranges, 3).

    Pieces as for `check_rope`, of `width` coefficients; work (2, width).
    """
    for axis in range(3):
        for row in range(Ranges.LOAD_LOW, Ranges.PLACE, 2):
            ranges[row, axis] = NEVER
            ranges[row + 1, axis] = -NEVER
        least, most = sum_range(axis, 1.0, 0.0, timing, coefficients, offsets, work)
        widen_range(Ranges.LOAD_LOW, axis, least, most, ranges)
        widen_range(Ranges.ROPE_LOW, axis, least, most, ranges)
    # up to the trolley
    widen_range(Ranges.ROPE_LOW, 2, 0.0, 0.0, ranges)
    least, most = sum_range(2, 0.0, 1.0, timing, coefficients, offsets, work)
    pull = gravity + least
    if pull <= 0.0:
        for axis in range(2):
            widen_range(Ranges.ROPE_LOW, axis, -NEVER, NEVER, ranges)
        return
    lean = max(-ranges[Ranges.LOAD_LOW, 2], 0.0) / pull
    for axis in range(2):
        least, most = sum_range(axis, 1.0, lean, timing, coefficients, offsets, work)
        widen_range(Ranges.ROPE_LOW, axis, least, most, ranges)


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


def widen_range(row: int, axis: int, least: float, most: float, ranges: 'float[:,:]') -> None:
    """Widen the range of an axis in two rows so that it has what is between two values."""
    ranges[row, axis] = min(ranges[row, axis], least)
    ranges[row + 1, axis] = max(ranges[row + 1, axis], most)


def is_near(part: int, box: 'float[:]', ranges: 'float[:,:]') -> bool:
    """Whether the range of a part overlaps a box."""
    low = Box.LOAD_LOW
    high = Box.LOAD_HIGH
    row = Ranges.LOAD_LOW
    if part == Part.ROPE:
        low = Box.ROPE_LOW
        high = Box.ROPE_HIGH
        row = Ranges.ROPE_LOW
        if box[Box.ROPE] < 0.5:
            return False
    for axis in range(3):
        if ranges[row + 1, axis] <= box[low + axis] or ranges[row, axis] >= box[high + axis]:
            return False
    return True


def is_any_near(boxes: 'float[:,:]', ranges: 'float[:,:]') -> bool:
    """Whether the range of load or rope overlaps one of the boxes (.., Box)."""
    for number in range(boxes.shape[0]):
        box = boxes[number, :]
        if is_near(Part.LOAD, box, ranges) or is_near(Part.ROPE, box, ranges):
            return True
    return False
