"""Check of a plan's pieces against its limits and waypoints, from the polynomials only.

A polynomial on [0, h] lies in the hull of its Bernstein coefficients. If the hull exceeds a limit,
the interval is halved, until every part is within the limit or one of its ends is not. So the
answer is exact, up to the tolerance for rounding. The coefficients of a derivative are those of the
next one, integrated: running sums.
"""

from segfmu.kernels.numerics.numbers import NEVER
from segfmu.kernels.planner.records import Lower
from segfmu.kernels.trajectory.evaluate import evaluate_piece, find_piece, local_time
from segfmu.kernels.trajectory.records import Brake, Check, Hull, Timing


def bernstein_coefficients(
    coefficients: 'float[:,:]', row: int, count: int, length: float, hull: 'float[:,:]'
) -> None:
    """Bernstein coefficients on [0, length] of the `count` first powers of a row, in hull[0, :]."""
    power = 1.0
    binomial = 1.0
    for i in range(count):
        hull[0, i] = coefficients[row, i] * power / binomial
        power = power * length
        binomial = binomial * (count - 1 - i) / (i + 1)
    for r in range(1, count):
        for j in range(count - r):
            i = count - 1 - j
            hull[0, i] = hull[0, i] + hull[0, i - 1]


def integrate_hull(count: int, start: float, length: float, values: 'float[:]') -> float:
    """Replace `count` Bernstein coefficients on [0, length] by those of an integral.

    The integral begins with the value `start`, and has one coefficient more. Returns the largest
    of their absolute values.
    """
    value = start
    largest = abs(start)
    step = length / max(count, 1)
    for i in range(count):
        gain = step * values[i]
        values[i] = value
        value = value + gain
        largest = max(largest, abs(value))
    values[count] = value
    return largest


def split_hull(hull: 'float[:,:]', row: int, count: int) -> None:
    """Halve row `row` by de Casteljau's scheme: its first half stays, the second one follows."""
    for i in range(count):
        hull[row + 1, i] = hull[row, i]
    # the last coefficients of the shrinking triangle are those of the second half, reversed
    for r in range(1, count):
        for i in range(count - r):
            hull[row + 1, i] = 0.5 * (hull[row + 1, i] + hull[row + 1, i + 1])
        hull[row, r] = hull[row + 1, 0]


def within(hull: 'float[:,:]', count: int, lowest: float, highest: float) -> bool:
    """Whether a polynomial with the Bernstein coefficients hull[0, :] stays between two limits.

    hull is work space with 40 rows of `Hull`.
    """
    rows = 1
    hull[0, Hull.DEPTH] = 0.0
    while rows > 0:
        row = rows - 1
        inside = True
        for i in range(count):
            # not a number is in no range
            inside = inside and lowest <= hull[row, i] and hull[row, i] <= highest
        if inside:
            rows = rows - 1
            continue
        depth = hull[row, Hull.DEPTH]
        last = hull[row, count - 1]
        ends = lowest <= hull[row, 0] and hull[row, 0] <= highest
        ends = ends and lowest <= last and last <= highest
        if not ends or depth > 34.0:
            return False
        split_hull(hull, row, count)
        hull[row, Hull.DEPTH] = depth + 1.0
        hull[row + 1, Hull.DEPTH] = depth + 1.0
        rows = rows + 1
    return True


def least_peak(order: int, limits: 'float[:]') -> float:
    """The least peak of a derivative that counts: where it is smaller, it is mostly rounding.

    It is 1e-5 of the limit; 1e-9 of that is the rounding error of a motion within the limit. In
    place of an absent one counts the limit at which the derivative below changes as fast as the one
    below that does at its own.
    """
    below = limits[0]
    limit = limits[0]
    for i in range(1, order):
        before = limit
        limit = limits[i]
        if limit <= 0.0:
            limit = before * before / below
        below = before
    return 1e-5 * limit


def least_distance(limits: 'float[:]') -> float:
    """The least distance that counts, a billionth of that from full speed to rest.

    A velocity limit far beyond what ramps of the acceleration reach is none.
    """
    scale = limits[0] * limits[0] / limits[1]
    ramp = 0.0
    for order in range(2, min(limits.shape[0], 4)):
        if limits[order] > 0.0:
            # the square of the time that the jerk, or the snap, needs for the acceleration
            square = limits[1] / limits[order]
            if order == 2:
                square = square * square
            ramp = max(ramp, limits[1] * square)
    if ramp > 0.0:
        scale = min(scale, 1e3 * ramp)
    return 1e-9 * scale


def reached_limit(order: int, duration: float, limits: 'float[:]') -> float:
    """The limit c_order, or the less that those above it permit to reach within a duration [s].

    limits[i] is c_{i+1}, 0 if absent. A limit that is meant as none can be far beyond that.
    """
    reached = 0.0
    for j in range(limits.shape[0] - order + 1):
        change = reached * duration
        reached = limits[limits.shape[0] - 1 - j]
        if reached <= 0.0 or (change > 0.0 and change < reached):
            reached = change
    return reached


def state_scale(order: int, duration: float, limits: 'float[:]') -> float:
    """What errors of a derivative c_order [m/s^order] are measured by, at least.

    In a motion that lasts a duration [s]; order 0 is the position. limits[i] is c_{i+1}, 0 if
    absent.
    """
    if order == 0:
        return reached_limit(1, duration, limits) * duration + least_distance(limits)
    return max(least_peak(order, limits), reached_limit(order, duration, limits))


def rounding_error(order: int, limits: 'float[:]') -> float:
    """Error of a derivative that is rounding alone: less than half of the jump that may be."""
    return 4e-10 * least_peak(order, limits)


def keep_inside(work: 'float[:,:]') -> None:
    """Allow a state outside its limits at no time; work (Check)."""
    for i in range(Brake.SIZE):
        work[Check.BRAKE, i] = 0.0


def set_bounds(
    middle: float, limits: 'float[:]', lower: 'float[:]', work: 'float[:,:]'
) -> None:
    """Set the bounds in `work` (Check) for a piece with a middle [s]; they are wider in a brake."""
    report = work[Check.BRAKE, :]
    for d in range(1, limits.shape[0] + 1):
        lowest = -limits[d - 1]
        highest = limits[d - 1]
        if d <= Lower.SIZE and lower[d - 1] > 0.0:
            lowest = -lower[d - 1]
        if highest > 0.0 and middle < report[Brake.UNTIL]:
            lowest = min(lowest, report[Brake.LOWEST + d])
            highest = max(highest, report[Brake.HIGHEST + d])
        work[Check.LOWEST, d] = lowest
        work[Check.HIGHEST, d] = highest


def check_axis(
    first: int,
    last: int,
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
    limits: 'float[:]',
    lower: 'float[:]',
    tolerance: float,
    joints: float,
    work: 'float[:,:]',
) -> bool:
    """Whether the pieces first .. last - 1 of one axis keep its limits c_1 .. and join smoothly.

    tolerance of limits, joints of jumps; both are relative. How far the axis may be outside the
    limits at first is in the row BRAKE of `work` (Check).
    The row PEAKS of `work` becomes the peaks of the derivatives, or bounds of them.
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
        middle = timing[row, Timing.START] + 0.5 * length
        set_bounds(middle, limits, lower, work)
        if not check_piece(order, row, row > first, length, coefficients, tolerance, work):
            return False
    low = min(low, work[Check.ENDS, 0])
    high = max(high, work[Check.ENDS, 0])
    # where the position is large, its rounding is a part of the distance that counts
    least = least_distance(limits)
    work[Check.PEAKS, 0] = max(max(high - low, least), 1e-5 * max(-low, high))
    for d in range(1, order):
        work[Check.PEAKS, d] = max(work[Check.PEAKS, d], least_peak(d, limits))
    for d in range(order):
        if not work[Check.JUMPS, d] <= joints * work[Check.PEAKS, d]:
            return False
    return work[Check.PEAKS, 0] < NEVER


def check_piece(
    order: int,
    row: int,
    joined: bool,
    length: float,
    coefficients: 'float[:,:]',
    tolerance: float,
    work: 'float[:,:]',
) -> bool:
    """Whether a piece keeps the bounds of the derivatives 1 .. order in `work` (Check).

    Notes peaks and, if it is joined, jumps.
    """
    values = work[Check.VALUES, :]
    degree = coefficients.shape[1] - 1
    while degree > 0 and coefficients[row, degree] == 0.0:
        degree = degree - 1
    for d in range(degree + 1, order + 1):
        note_ends(d, joined, 0.0, 0.0, 0.0, work)
    starts = work[Check.STARTS, :]
    factorial = 1.0
    for d in range(degree + 1):
        if d > 1:
            factorial = factorial * d
        starts[d] = coefficients[row, d] * factorial
    for count in range(degree + 1):
        # the derivatives from the highest one, which is constant, downwards
        d = degree - count
        start = starts[d]
        largest = integrate_hull(count, start, length, values)
        # not a number, or an infinite one, passes on to the derivatives below
        if not abs(values[count]) < NEVER:
            return False
        if d <= order:
            note_ends(d, joined, start, values[count], largest, work)
            lowest = work[Check.LOWEST, d]
            highest = work[Check.HIGHEST, d]
            if d > 0 and highest > 0.0:
                if largest > min(-lowest, highest) * (1.0 + tolerance):
                    hull = work[Check.HULLS:Check.ENDS, :]
                    for i in range(count + 1):
                        hull[0, i] = values[i]
                    share = 1.0 + tolerance
                    if not within(hull, count + 1, lowest * share, highest * share):
                        return False
    return True


def note_ends(
    d: int, joined: bool, start: float, end: float, largest: float, work: 'float[:,:]'
) -> None:
    """Note peak, end and, if a piece is joined to the one before, jump of a derivative."""
    work[Check.PEAKS, d] = max(work[Check.PEAKS, d], largest)
    if joined:
        jump = abs(start - work[Check.ENDS, d])
        work[Check.JUMPS, d] = max(work[Check.JUMPS, d], jump)
    work[Check.ENDS, d] = end


def switching_time(
    time: float, duration: float, timing: 'float[:,:]', row: int
) -> float:
    """Local time in a piece, its start or end where only rounding tells them apart.

    Late in a long plan a rounding error of the clock is much for a derivative that changes within
    microseconds. Times have to be right to 1e-12 of the duration.
    """
    length = timing[row, Timing.LENGTH]
    local = local_time(time, timing, row)
    same = 1e-12 * duration
    # a piece may be shorter than that
    if local < length - local:
        if local < same:
            local = 0.0
    elif local > length - same:
        local = length
    return local


def check_plan(
    states: 'float[:,:,:]',
    times: 'float[:,:]',
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
    offsets: 'int[:]',
    limits: 'float[:,:]',
    lower: 'float[:,:]',
    tolerance: float,
    joints: float,
    work: 'float[:,:]',
) -> int:
    """Check the pieces of every axis: 0, or 1 + the first axis that may be wrong.

    Up to the relative tolerance limits hold. Up to `joints` the derivatives 0 .. n are continuous
    (in units of the range of the position and of the peaks of the others), and the trajectory
    passes the waypoints. Half of what is promised for these leaves room for rounding errors of
    another evaluation, and for bounds of peaks above them.

    Arrays as in `expand_plan`; limits[axis, i] is c_{i+1}, 0 if absent; lower (k, Lower); work
    (Check rows, Check columns).
    """
    keep_inside(work)
    for axis in range(limits.shape[0]):
        if not check_motion(
            axis, states, times, timing, coefficients, offsets, limits, lower, tolerance, joints,
            work,
        ):
            return 1 + axis
    return 0


def check_braked_plan(
    states: 'float[:,:,:]',
    times: 'float[:,:]',
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
    offsets: 'int[:]',
    limits: 'float[:,:]',
    lower: 'float[:,:]',
    brakes: 'float[:,:]',
    tolerance: float,
    joints: float,
    work: 'float[:,:]',
) -> int:
    """`check_plan`, but each axis may be outside its limits at first, as a brake tells (Brake)."""
    for axis in range(limits.shape[0]):
        for i in range(Brake.SIZE):
            work[Check.BRAKE, i] = brakes[axis, i]
        if not check_motion(
            axis, states, times, timing, coefficients, offsets, limits, lower, tolerance, joints,
            work,
        ):
            return 1 + axis
    return 0


def check_motion(
    axis: int,
    states: 'float[:,:,:]',
    times: 'float[:,:]',
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
    offsets: 'int[:]',
    limits: 'float[:,:]',
    lower: 'float[:,:]',
    tolerance: float,
    joints: float,
    work: 'float[:,:]',
) -> bool:
    """Whether one axis is right, as in `check_plan`; its brake is in the row BRAKE of `work`."""
    width = coefficients.shape[1]
    points = states.shape[0]
    first = offsets[axis]
    last = offsets[axis + 1]
    if not check_axis(
        first, last, timing, coefficients, limits[axis, :], lower[axis, :], tolerance, joints, work
    ):
        return False
    duration = times[points, axis] - times[0, axis]
    for j in range(points + 1):
        # the last waypoint is checked on arrival and, after its dwell, at the end
        point = min(j, points - 1)
        row = find_piece(times[j, axis], timing, first, last)
        local = switching_time(times[j, axis], times[points, axis], timing, row)
        for d in range(min(states.shape[2], limits.shape[1])):
            value = evaluate_piece(coefficients, row, width, local, d)
            scale = work[Check.PEAKS, d]
            if d > 0 and limits[axis, d - 1] > 0.0:
                scale = max(scale, state_scale(d, duration, limits[axis, :]))
            if not abs(value - states[point, axis, d]) <= joints * scale:
                return False
    return True
