"""Where a path leads at most: boxes beyond that need no closer look.

The trolley is ahead of the load by lean p'', with lean = -z / (z'' + g). In each piece of an axis
it is between the load and where the greatest lean of all pieces would have it.
"""

from segfmu.kernels.clearance.records import Box, Part, Ranges
from segfmu.kernels.crane.records import RopeWork
from segfmu.kernels.numerics.bounds import polynomial_bounds
from segfmu.kernels.numerics.numbers import NEVER
from segfmu.kernels.trajectory.ranges import sum_range


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
        least, most = sum_range(axis, 1.0, 0.0, timing, coefficients, offsets, work[0, :])
        begin_range(axis, least, most, ranges)
    least, most = sum_range(2, 0.0, 1.0, timing, coefficients, offsets, work[0, :])
    lean = lean_of(gravity + least, ranges)
    if lean < 0.0:
        return
    for axis in range(2):
        least, most = sum_range(axis, 1.0, lean, timing, coefficients, offsets, work[0, :])
        widen_range(Ranges.ROPE_LOW, axis, least, most, ranges)


def span_ranges(
    part: int, length: float, width: int, work: 'float[:,:]', ranges: 'float[:,:]'
) -> None:
    """The same of a part in an interval of a length [s], which `interval_pieces` has written."""
    for axis in range(3):
        least, most = row_bounds(RopeWork.LOAD + axis, width, length, work)
        begin_range(axis, least, most, ranges)
    if part == Part.LOAD:
        return
    pull, most = row_bounds(RopeWork.PULL + 2, width - 2, length, work)
    lean = lean_of(pull, ranges)
    if lean < 0.0:
        return
    for axis in range(2):
        for i in range(width):
            work[RopeWork.PRODUCTS, i] = work[RopeWork.LOAD + axis, i]
        for i in range(width - 2):
            ahead = lean * work[RopeWork.PULL + axis, i]
            work[RopeWork.PRODUCTS, i] = work[RopeWork.PRODUCTS, i] + ahead
        least, most = row_bounds(RopeWork.PRODUCTS, width, length, work)
        widen_range(Ranges.ROPE_LOW, axis, least, most, ranges)


def begin_range(axis: int, least: float, most: float, ranges: 'float[:,:]') -> None:
    """Set the ranges of load and rope of an axis to what is between two values [m]."""
    for row in range(Ranges.LOAD_LOW, Ranges.PLACE, 2):
        ranges[row, axis] = least
        ranges[row + 1, axis] = most


def lean_of(pull: float, ranges: 'float[:,:]') -> float:
    """The greatest way of the trolley ahead of the load over its acceleration [s2].

    pull: the least acceleration that the rope gives [m/s2]. The rope goes up to the trolley. -1: it
    may not pull, and may be anywhere.
    """
    widen_range(Ranges.ROPE_LOW, 2, 0.0, 0.0, ranges)
    if pull <= 0.0:
        for axis in range(2):
            widen_range(Ranges.ROPE_LOW, axis, -NEVER, NEVER, ranges)
        return -1.0
    return max(-ranges[Ranges.LOAD_LOW, 2], 0.0) / pull


def row_bounds(
    row: int, count: int, length: float, work: 'float[:,:]'
) -> 'tuple[float, float]':
    """Bounds of the polynomial of `count` coefficients in a row of `work` (RopeWork)."""
    for i in range(count):
        work[RopeWork.DEMAND, i] = work[row, i]
    return polynomial_bounds(work[RopeWork.DEMAND, :], count, length)


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


def is_any_near(part: int, boxes: 'float[:,:]', ranges: 'float[:,:]') -> bool:
    """Whether the range of a part overlaps one of the boxes (.., Box)."""
    for number in range(boxes.shape[0]):
        if is_near(part, boxes[number, :], ranges):
            return True
    return False
