"""Where a path leaves the box of the two waypoints that it joins.

Pieces as for `evaluate`, of `width` coefficients; work (RopeWork.SIZE, 4 width - 5 or more).
"""

from segfmu.kernels.clearance.records import Excursion, PathStatus
from segfmu.kernels.crane.records import RopeWork
from segfmu.kernels.crane.rope import first_negative
from segfmu.kernels.numerics.polynomials import polynomial_shift
from segfmu.kernels.trajectory.check import bernstein_coefficients, split_hull
from segfmu.kernels.trajectory.records import Timing


def path_excursion(
    led: 'float[:,:]',
    positions: 'float[:,:]',
    times: 'float[:,:]',
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
    offsets: 'int[:]',
    work: 'float[:,:]',
    excursion: 'float[:]',
) -> int:
    """Whether a path stays in its boxes beside the waypoints of which a state is free.

    led (points, axes): 1 where it is; positions and times of arrival of the same shape. Returns a
    `PathStatus`, with the first `Excursion`.
    """
    for interval in range(led.shape[0] - 1):
        for axis in range(led.shape[1]):
            one = positions[interval, axis]
            other = positions[interval + 1, axis]
            free = led[interval, axis] + led[interval + 1, axis] > 0.5
            if free and leaves_range(
                axis, times[interval, axis], times[interval + 1, axis], min(one, other),
                max(one, other), timing, coefficients, offsets, work, excursion,
            ):
                excursion[Excursion.AXIS] = axis
                excursion[Excursion.INTERVAL] = interval
                return PathStatus.EXCURSION
    return PathStatus.INSIDE


def leaves_range(
    axis: int,
    begin: float,
    end: float,
    low: float,
    high: float,
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
    offsets: 'int[:]',
    work: 'float[:,:]',
    excursion: 'float[:]',
) -> bool:
    """Whether an axis leaves a range [m] between two times [s]; writes when first, and how far.

    A millionth of the range, and 1e-9 of the largest coordinate, is no excursion.
    """
    small = 1e-6 * (high - low)
    for row in range(coefficients.shape[0]):
        small = max(small, 1e-9 * abs(coefficients[row, 0]))
    found = False
    excursion[Excursion.DISTANCE] = 0.0
    for row in range(offsets[axis], offsets[axis + 1]):
        start = max(begin, timing[row, Timing.START])
        length = min(end, timing[row, Timing.START] + timing[row, Timing.LENGTH]) - start
        if length > 0.0:
            local = start - timing[row, Timing.START]
            share = 2.0
            for side in range(2):
                write_room(side, row, local, low - small, high + small, coefficients, work)
                beyond = first_negative(coefficients.shape[1], length, work)
                if beyond >= 0.0:
                    share = min(share, beyond)
            if share < 1.5 and not found:
                found = True
                excursion[Excursion.TIME] = start + share * length
            if share < 1.5:
                for side in range(2):
                    write_room(side, row, local, low, high, coefficients, work)
                    excursion[Excursion.DISTANCE] = greatest_lack(
                        coefficients.shape[1], length, excursion[Excursion.DISTANCE], work
                    )
    return found


def write_room(
    side: int, row: int, local: float, low: float, high: float, coefficients: 'float[:,:]',
    work: 'float[:,:]',
) -> None:
    """Write the distance of a piece, from a local time on, to the end of a range on one side."""
    sign = 1.0
    edge = high
    if side == 1:
        sign = -1.0
        edge = low
    width = coefficients.shape[1]
    for i in range(width):
        work[RopeWork.DEMAND, i] = coefficients[row, i]
    polynomial_shift(work[RopeWork.DEMAND, :], local, width)
    for i in range(width):
        work[RopeWork.DEMAND, i] = -sign * work[RopeWork.DEMAND, i]
    work[RopeWork.DEMAND, 0] = work[RopeWork.DEMAND, 0] + sign * edge


def pieces_beyond(
    side: int, low: float, high: float, count: int, timing: 'float[:,:]',
    coefficients: 'float[:,:]', work: 'float[:,:]',
) -> float:
    """How far the first pieces leave a range [m] above (side 0) or below it (1)."""
    known = 0.0
    for row in range(count):
        write_room(side, row, 0.0, low, high, coefficients, work)
        known = greatest_lack(coefficients.shape[1], timing[row, Timing.LENGTH], known, work)
    return known


def greatest_lack(count: int, length: float, known: float, work: 'float[:,:]') -> float:
    """The greatest negative value of the row DEMAND on [0, length], or a known one above 0.

    Halves of the interval that have no greater one, to nine digits, are left out.
    """
    depth = work.shape[1] - 1
    hull = work[RopeWork.HULLS:work.shape[0], :]
    bernstein_coefficients(work, RopeWork.DEMAND, count, length, hull)
    hull[0, depth] = 0.0
    rows = 1
    while rows > 0:
        row = rows - 1
        most = 0.0
        for i in range(count):
            most = max(most, -hull[row, i])
        known = max(known, max(-hull[row, 0], -hull[row, count - 1]))
        if most <= known * (1.0 + 1e-9) or hull[row, depth] > 39.5:
            rows = row
        else:
            split_hull(hull, row, count)
            hull[row, depth] = hull[row, depth] + 1.0
            hull[row + 1, depth] = hull[row, depth]
            rows = rows + 1
    return known
