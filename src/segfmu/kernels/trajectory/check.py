"""Check of a plan's pieces against its limits and waypoints, from the polynomials only.

A polynomial on [0, h] lies in the hull of its Bernstein coefficients. If the hull exceeds a limit,
the interval is halved, until every part is within the limit or one of its ends is not. So the
answer is exact, up to the tolerance for rounding.
"""

from segfmu.kernels.trajectory.evaluate import evaluate_piece, find_piece, local_time
from segfmu.kernels.trajectory.records import Check, Hull, Timing


def bernstein_coefficients(
    coefficients: 'float[:,:]',
    row: int,
    width: int,
    derivative: int,
    length: float,
    hull: 'float[:,:]',
) -> int:
    """Bernstein coefficients of a derivative of one piece on [0, length] in hull[0, :].

    Returns their number.
    """
    count = width - derivative
    power = 1.0
    binomial = 1.0
    for i in range(count):
        factor = 1.0
        for m in range(derivative):
            factor = factor * (i + derivative - m)
        hull[0, i] = factor * coefficients[row, i + derivative] * power / binomial
        power = power * length
        binomial = binomial * (count - 1 - i) / (i + 1)
    for r in range(1, count):
        for j in range(count - r):
            i = count - 1 - j
            hull[0, i] = hull[0, i] + hull[0, i - 1]
    return count


def split_hull(hull: 'float[:,:]', row: int, count: int) -> None:
    """Halve row `row` by de Casteljau's scheme: its first half stays, the second one follows."""
    for i in range(count):
        hull[row + 1, i] = hull[row, i]
    # the last coefficients of the shrinking triangle are those of the second half, reversed
    for r in range(1, count):
        for i in range(count - r):
            hull[row + 1, i] = 0.5 * (hull[row + 1, i] + hull[row + 1, i + 1])
        hull[row, r] = hull[row + 1, 0]


def within(hull: 'float[:,:]', count: int, limit: float) -> bool:
    """Whether a polynomial with the Bernstein coefficients hull[0, :] keeps a limit.

    hull is work space with 40 rows of `Hull`.
    """
    rows = 1
    hull[0, Hull.DEPTH] = 0.0
    while rows > 0:
        row = rows - 1
        largest = 0.0
        total = 0.0
        for i in range(count):
            largest = max(largest, abs(hull[row, i]))
            total = total + abs(hull[row, i])
        # the sum detects NaN, for which every comparison is false
        if largest <= limit and total <= count * limit:
            rows = rows - 1
            continue
        ends = max(abs(hull[row, 0]), abs(hull[row, count - 1]))
        depth = hull[row, Hull.DEPTH]
        if not ends <= limit or depth > 34.0:
            return False
        split_hull(hull, row, count)
        hull[row, Hull.DEPTH] = depth + 1.0
        hull[row + 1, Hull.DEPTH] = depth + 1.0
        rows = rows + 1
    return True


def check_axis(
    first: int,
    last: int,
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
    limits: 'float[:]',
    tolerance: float,
    work: 'float[:,:]',
) -> bool:
    """Whether the pieces first .. last - 1 of one axis keep its limits c_1 .. and join smoothly.

    The row PEAKS of `work` (Check) becomes the peaks of the derivatives.
    """
    order = limits.shape[0]
    for i in range(Hull.SIZE):
        work[Check.PEAKS, i] = 0.0
        work[Check.JUMPS, i] = 0.0
    low = coefficients[first, 0]
    high = low
    for row in range(first, last):
        low = min(low, coefficients[row, 0])
        high = max(high, coefficients[row, 0])
        length = timing[row, Timing.LENGTH]
        if not check_piece(row, row > first, length, coefficients, limits, tolerance, work):
            return False
    low = min(low, work[Check.ENDS, 0])
    high = max(high, work[Check.ENDS, 0])
    # where the position is large, its rounding is a part of the distance that counts
    work[Check.PEAKS, 0] = max(high - low, 1e-5 * max(-low, high))
    for d in range(order):
        if not work[Check.JUMPS, d] <= tolerance * work[Check.PEAKS, d]:
            return False
    return work[Check.PEAKS, 0] < 1e300


def check_piece(
    row: int,
    joined: bool,
    length: float,
    coefficients: 'float[:,:]',
    limits: 'float[:]',
    tolerance: float,
    work: 'float[:,:]',
) -> bool:
    """Whether a piece keeps the limits of its axis; notes peaks and, if it is joined, jumps."""
    order = limits.shape[0]
    hull = work[Check.HULLS:Check.ENDS, :]
    degree = coefficients.shape[1] - 1
    while degree > 0 and coefficients[row, degree] == 0.0:
        degree = degree - 1
    for d in range(order + 1):
        hull[0, 0] = 0.0
        count = 1
        if d <= degree:
            count = bernstein_coefficients(coefficients, row, degree + 1, d, length, hull)
        for i in range(count):
            work[Check.PEAKS, d] = max(work[Check.PEAKS, d], abs(hull[0, i]))
        if joined:
            jump = abs(hull[0, 0] - work[Check.ENDS, d])
            work[Check.JUMPS, d] = max(work[Check.JUMPS, d], jump)
        # not max(), which would ignore NaN
        if not abs(hull[0, 0]) < 1e300:
            return False
        work[Check.ENDS, d] = hull[0, count - 1]
        if d > 0 and limits[d - 1] > 0.0:
            if not within(hull, count, limits[d - 1] * (1.0 + tolerance)):
                return False
    return True


def check_plan(
    states: 'float[:,:,:]',
    times: 'float[:,:]',
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
    offsets: 'int[:]',
    limits: 'float[:,:]',
    tolerance: float,
    work: 'float[:,:]',
) -> int:
    """Check the pieces of every axis: 0, or 1 + the first axis that may be wrong.

    Up to the relative tolerance, limits hold, the derivatives 0 .. n are continuous (in units of
    the range of the position and of the peaks of the others), and the trajectory
    passes the waypoints. Arrays as in `expand_plan`; limits[axis, i] is c_{i+1}, 0 if absent; work
    (Check rows, Check columns).
    """
    width = coefficients.shape[1]
    points = states.shape[0]
    for axis in range(limits.shape[0]):
        first = offsets[axis]
        last = offsets[axis + 1]
        if not check_axis(
            first, last, timing, coefficients, limits[axis, :], tolerance, work
        ):
            return 1 + axis
        for j in range(points + 1):
            # the last waypoint is checked on arrival and, after its dwell, at the end
            point = min(j, points - 1)
            row = find_piece(times[j, axis], timing, first, last)
            local = local_time(times[j, axis], timing, row)
            for d in range(states.shape[2]):
                value = evaluate_piece(coefficients, row, width, local, d)
                scale = work[Check.PEAKS, d]
                if d > 0 and limits[axis, d - 1] > 0.0:
                    scale = limits[axis, d - 1]
                if not abs(value - states[point, axis, d]) <= tolerance * scale:
                    return 1 + axis
    return 0
