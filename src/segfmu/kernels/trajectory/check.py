"""A plan's pieces against its limits and waypoints, from the polynomials alone.

A polynomial on [0, h] lies in the hull of its Bernstein coefficients. Where the hull passes a
limit the interval is halved, until every part is within it or one of its ends is not. So the answer
is exact, up to the tolerance that is allowed for rounding.
"""

from segfmu.kernels.trajectory.evaluate import evaluate_piece, find_piece


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
    """Whether a polynomial given by the Bernstein coefficients hull[0, :] keeps a limit.

    hull (40, 14) is work space.
    """
    rows = 1
    hull[0, 13] = 0.0
    while rows > 0:
        row = rows - 1
        largest = 0.0
        total = 0.0
        for i in range(count):
            largest = max(largest, abs(hull[row, i]))
            total = total + abs(hull[row, i])
        # the sum is for values that are no numbers, which no comparison holds for
        if largest <= limit and total <= count * limit:
            rows = rows - 1
            continue
        ends = max(abs(hull[row, 0]), abs(hull[row, count - 1]))
        depth = hull[row, 13]
        if not ends <= limit or depth > 34.0:
            return False
        split_hull(hull, row, count)
        hull[row, 13] = depth + 1.0
        hull[row + 1, 13] = depth + 1.0
        rows = rows + 1
    return True


def check_axis(
    axis: int,
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
    first: int,
    last: int,
    limits: 'float[:,:]',
    tolerance: float,
    work: 'float[:,:]',
) -> bool:
    """Whether the pieces first .. last - 1 of one axis keep its limits and join smoothly.

    work[41, d] becomes the peak of the d-th derivative, or for the position its range, at least 1.
    """
    order = limits.shape[1]
    hull = work[0:40, :]
    for i in range(14):
        work[41, i] = 0.0
        work[42, i] = 0.0
    low = coefficients[first, 0]
    high = low
    for row in range(first, last):
        length = timing[row, 1]
        low = min(low, coefficients[row, 0])
        high = max(high, coefficients[row, 0])
        degree = coefficients.shape[1] - 1
        while degree > 0 and coefficients[row, degree] == 0.0:
            degree = degree - 1
        for d in range(order + 1):
            hull[0, 0] = 0.0
            count = 1
            if d <= degree:
                count = bernstein_coefficients(coefficients, row, degree + 1, d, length, hull)
            for i in range(count):
                work[41, d] = max(work[41, d], abs(hull[0, i]))
            if row > first:
                work[42, d] = max(work[42, d], abs(hull[0, 0] - work[40, d]))
            # not max(), which a value that is no number would leave as it is
            if not abs(hull[0, 0]) < 1e300:
                return False
            work[40, d] = hull[0, count - 1]
            if d > 0 and limits[axis, d - 1] > 0.0:
                if not within(hull, count, limits[axis, d - 1] * (1.0 + tolerance)):
                    return False
    work[41, 0] = max(1.0, high - low)
    for d in range(order):
        if not work[42, d] <= tolerance * work[41, d]:
            return False
    return work[41, 0] < 1e300


def check_plan(
    positions: 'float[:,:]',
    velocities: 'float[:,:]',
    accelerations: 'float[:,:]',
    times: 'float[:,:]',
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
    offsets: 'int[:]',
    ends: 'float[:]',
    limits: 'float[:,:]',
    tolerance: float,
    work: 'float[:,:]',
) -> int:
    """Judge the pieces of every axis: 0, or 1 + the first axis that is not surely right.

    Limits hold up to the relative tolerance, the derivatives 0 .. n are continuous up to it (in
    units of the range of the position, at least 1 m, and of the peaks of the others), and the
    waypoints are met up to it. Arrays as in `expand_plan`; work is (43, 14).
    """
    width = coefficients.shape[1]
    points = positions.shape[0]
    for axis in range(limits.shape[0]):
        first = offsets[axis]
        last = offsets[axis + 1]
        if not check_axis(
            axis, timing, coefficients, first, last, limits, tolerance, work
        ):
            return 1 + axis
        for j in range(points + 1):
            # the last waypoint is met on arrival and, after its dwell, at the end
            point = min(j, points - 1)
            time = times[point, axis]
            if j == points:
                time = ends[axis]
            row = find_piece(time, timing, first, last)
            local = min(time - timing[row, 0], timing[row, 1])
            y = evaluate_piece(coefficients, row, width, local, 0)
            v = evaluate_piece(coefficients, row, width, local, 1)
            a = evaluate_piece(coefficients, row, width, local, 2)
            if not abs(y - positions[point, axis]) <= tolerance * work[41, 0]:
                return 1 + axis
            if not abs(v - velocities[point, axis]) <= tolerance * limits[axis, 0]:
                return 1 + axis
            if not abs(a - accelerations[point, axis]) <= tolerance * limits[axis, 1]:
                return 1 + axis
    return 0
