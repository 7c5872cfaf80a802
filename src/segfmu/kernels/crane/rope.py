"""Proof that the rope stays taut and within its range along a trajectory of the load.

With w = p'' + g e_z the rope's length is l = -z |w| / w_z (errata E7). So each demand is a
polynomial in time that must not become negative: -z (1) and w_z (2), and with a bound L of the
length L^2 w_z^2 - z^2 |w|^2 (3, the greatest) or its negative (4, the least). A polynomial lies in
the hull of its Bernstein coefficients; where the hull is too wide, the interval is halved. Nothing
is sampled, so nothing is missed between samples. An interval is a time in which no axis goes from
one of its pieces to the next.

`work` (52, 4 width - 5) for pieces of `width` coefficients, 4 or more: rows 0:3 position and 3:6
pull w of each axis as polynomials in the interval's local time, 6 the demand, 7:10 products, from
10 on the hulls, whose last two columns hold where they start and how often they were halved.
"""

from math import sqrt

from segfmu.kernels.trajectory.check import bernstein_coefficients, split_hull
from segfmu.kernels.trajectory.evaluate import evaluate_piece, find_piece


def check_rope(
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
    offsets: 'int[:]',
    gravity: float,
    shortest: float,
    longest: float,
    work: 'float[:,:]',
    report: 'float[:]',
) -> int:
    """Check a trajectory x, y, z; pieces as in kernels/trajectory/evaluate.py, pieces rise in time.

    shortest and longest: bounds of the rope's length [m], 0 where there is none. Returns 0, or the
    first demand, 1 to 4, that is not met; the later ones rely on the earlier ones. report (3): the
    time [s] from which on it is not, the worst value after that, and its bound: of the load's
    height [m], of its acceleration downwards [m/s2], or of the rope's length [m].
    """
    tolerance = 1e-9
    time = timing[offsets[0], 0]
    until = interval_end(time, timing, offsets)
    failed = 5
    while until > time:
        interval_pieces(time, until, timing, coefficients, offsets, gravity, work)
        for demand in range(1, failed):
            count = rope_demand(demand, gravity, shortest, longest, tolerance, work)
            if count > 0:
                share = first_negative(count, until - time, work)
                if share >= 0.0:
                    failed = demand
                    report[0] = time + share * (until - time)
                    break
        time = until
        until = interval_end(time, timing, offsets)
    if failed == 5:
        return 0
    report[2] = 0.0
    if failed == 2:
        report[2] = gravity
    elif failed == 3:
        report[2] = longest
    elif failed == 4:
        report[2] = shortest
    report[1] = worst_value(failed, report[0], timing, coefficients, offsets, gravity, work)
    return failed


def interval_end(time: float, timing: 'float[:,:]', offsets: 'int[:]') -> float:
    """First end of a piece of any of three axes after a time, or the time if there is none."""
    until = time
    for axis in range(3):
        last = offsets[axis + 1]
        row = find_piece(time, timing, offsets[axis], last)
        end = timing[row, 0] + timing[row, 1]
        if row + 1 < last:
            end = timing[row + 1, 0]
        if end > time and (until == time or end < until):
            until = end
    return until


def interval_pieces(
    time: float,
    until: float,
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
    offsets: 'int[:]',
    gravity: float,
    work: 'float[:,:]',
) -> None:
    """Position and pull of all axes in an interval's local time; an axis that has ended stays."""
    width = coefficients.shape[1]
    middle = 0.5 * (time + until)
    for axis in range(3):
        last = offsets[axis + 1]
        row = find_piece(middle, timing, offsets[axis], last)
        for i in range(width):
            work[axis, i] = coefficients[row, i]
        if middle > timing[row, 0] + timing[row, 1]:
            work[axis, 0] = evaluate_piece(coefficients, row, width, timing[row, 1], 0)
            for i in range(1, width):
                work[axis, i] = 0.0
        else:
            # the piece about a later time, by repeated synthetic division
            offset = time - timing[row, 0]
            for i in range(width - 1):
                for j in range(width - 1 - i):
                    k = width - 2 - j
                    work[axis, k] = work[axis, k] + offset * work[axis, k + 1]
        for i in range(width - 2):
            work[3 + axis, i] = (i + 1.0) * (i + 2.0) * work[axis, i + 2]
    work[5, 0] = work[5, 0] + gravity


def add_product(
    first: int, first_count: int, second: int, second_count: int, row: int, work: 'float[:,:]'
) -> None:
    """Add the product of the polynomials in two rows to a third one."""
    for i in range(first_count):
        for j in range(second_count):
            work[row, i + j] = work[row, i + j] + work[first, i] * work[second, j]


def rope_demand(
    demand: int,
    gravity: float,
    shortest: float,
    longest: float,
    tolerance: float,
    work: 'float[:,:]',
) -> int:
    """Put the polynomial of a demand into work[6, :]; returns its length, 0: no such demand."""
    columns = work.shape[1] - 2
    width = (columns + 7) // 4
    if demand == 1:
        for i in range(width):
            work[6, i] = -work[2, i]
        work[6, 0] = work[6, 0] - tolerance
        return width
    if demand == 2:
        for i in range(width - 2):
            work[6, i] = work[5, i]
        work[6, 0] = work[6, 0] - tolerance * gravity
        return width - 2
    if demand == 3:
        if longest <= 0.0:
            return 0
        length_margin(width, longest * (1.0 + tolerance), 1.0, work)
    else:
        if shortest <= 0.0:
            return 0
        length_margin(width, shortest * (1.0 - tolerance), -1.0, work)
    return columns


def length_margin(width: int, bound: float, sign: float, work: 'float[:,:]') -> None:
    """sign * (bound^2 w_z^2 - z^2 |w|^2) in work[6, :]."""
    columns = work.shape[1] - 2
    count = width - 2
    for row in range(6, 10):
        for i in range(columns):
            work[row, i] = 0.0
    add_product(2, width, 2, width, 7, work)
    for axis in range(3):
        add_product(3 + axis, count, 3 + axis, count, 8, work)
    add_product(5, count, 5, count, 9, work)
    add_product(7, 2 * width - 1, 8, 2 * count - 1, 6, work)
    for i in range(columns):
        work[6, i] = sign * (bound * bound * work[9, i] - work[6, i])


def first_negative(count: int, length: float, work: 'float[:,:]') -> float:
    """Where, as a share of the interval, work[6, :] is first not proved to be zero or more.

    -1: nowhere. Hulls are reversed, so that the first half of an interval is on top.
    """
    start = work.shape[1] - 2
    depth = work.shape[1] - 1
    hull = work[10:work.shape[0], :]
    bernstein_coefficients(work, 6, count, 0, length, hull)
    for i in range(count // 2):
        swapped = hull[0, i]
        hull[0, i] = hull[0, count - 1 - i]
        hull[0, count - 1 - i] = swapped
    hull[0, start] = 0.0
    hull[0, depth] = 0.0
    rows = 1
    while rows > 0:
        row = rows - 1
        smallest = hull[row, 0]
        for i in range(1, count):
            smallest = min(smallest, hull[row, i])
        if smallest >= 0.0:
            rows = row
        elif hull[row, count - 1] < 0.0 or hull[row, depth] > 39.5:
            return hull[row, start]
        else:
            split_hull(hull, row, count)
            hull[row + 1, start] = hull[row, start]
            hull[row, depth] = hull[row, depth] + 1.0
            hull[row + 1, depth] = hull[row, depth]
            hull[row, start] = hull[row, start] + 0.5 ** hull[row, depth]
            rows = rows + 1
    return -1.0


def rope_value(demand: int, local: float, gravity: float, work: 'float[:,:]') -> float:
    """What a demand bounds, at a local time of the interval: height, fall or length."""
    width = (work.shape[1] + 5) // 4
    z = evaluate_piece(work, 2, width, local, 0)
    pull = evaluate_piece(work, 5, width - 2, local, 0)
    if demand == 1:
        return z
    if demand == 2:
        return gravity - pull
    x_pull = evaluate_piece(work, 3, width - 2, local, 0)
    y_pull = evaluate_piece(work, 4, width - 2, local, 0)
    return -z * sqrt(x_pull * x_pull + y_pull * y_pull + pull * pull) / pull


def worst_value(
    demand: int,
    first: float,
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
    offsets: 'int[:]',
    gravity: float,
    work: 'float[:,:]',
) -> float:
    """The worst of samples, 33 an interval, of what a demand bounds from a time on."""
    sign = 1.0
    if demand == 4:
        sign = -1.0
    worst = -1e300
    time = timing[offsets[0], 0]
    until = interval_end(time, timing, offsets)
    while until > time:
        if until >= first:
            interval_pieces(time, until, timing, coefficients, offsets, gravity, work)
            for i in range(33):
                local = max((until - time) * i / 32.0, first - time)
                worst = max(worst, sign * rope_value(demand, local, gravity, work))
        time = until
        until = interval_end(time, timing, offsets)
    return sign * worst
