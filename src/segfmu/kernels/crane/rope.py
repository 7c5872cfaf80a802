"""Check that the rope stays taut and within its range along a trajectory of the load.

Each demand of `RopeDemand` is a polynomial in time that must not become negative; codegen derives
it from crane/flatness.py (errata E7) and writes it to _rope.py. A polynomial lies in the hull of
its Bernstein coefficients; if the hull is too wide, the interval is halved. Nothing is sampled, so
nothing is missed between samples. An interval is a time between changes of piece on any axis. Most
motions are far from most bounds, which ranges over the whole trajectory tell.
"""

from math import sqrt

from segfmu.kernels.crane._rope import rope_margin, rope_pull, rope_value
from segfmu.kernels.crane.records import RopeBounds, RopeDemand, RopeFault, RopeWork
from segfmu.kernels.numerics.numbers import NEVER
from segfmu.kernels.numerics.polynomials import polynomial_shift
from segfmu.kernels.trajectory.check import bernstein_coefficients, split_hull
from segfmu.kernels.trajectory.evaluate import evaluate_piece, find_piece
from segfmu.kernels.trajectory.ranges import sum_range
from segfmu.kernels.trajectory.records import Timing


def check_rope(
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
    offsets: 'int[:]',
    bounds: 'float[:]',
    work: 'float[:,:]',
    report: 'float[:]',
) -> int:
    """Check a trajectory x, y, z, with pieces as in kernels/trajectory/evaluate.py in order of
    time.

    bounds (RopeBounds.SIZE); work (RopeWork.SIZE, 4 width - 5 or more) for pieces of `width`
    coefficients, 4 or more. Returns the first violated demand of RopeDemand, or 0. report
    (RopeFault): for the load's height [m], its downward acceleration [m/s2], or the rope length
    [m].
    """
    failed = failed_demand(False, timing, coefficients, offsets, bounds, work, report)
    if failed == RopeDemand.MET:
        return RopeDemand.MET
    report[RopeFault.WORST] = worst_value(
        failed, report[RopeFault.TIME], timing, coefficients, offsets, bounds, work
    )
    report[RopeFault.BOUND] = demand_bound(failed, bounds)
    return failed


def keeps_rope(
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
    offsets: 'int[:]',
    bounds: 'float[:]',
    work: 'float[:,:]',
    report: 'float[:]',
) -> bool:
    """Whether `check_rope` returns 0; of report only the time is written."""
    failed = failed_demand(True, timing, coefficients, offsets, bounds, work, report)
    return failed == RopeDemand.MET


def failed_demand(
    any_one: bool,
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
    offsets: 'int[:]',
    bounds: 'float[:]',
    work: 'float[:,:]',
    report: 'float[:]',
) -> int:
    """The first violated demand, or the one that is violated at the earliest time; 0: none is."""
    none = RopeDemand.NOT_TOO_SHORT + 1
    lowest, highest, pull, square = rope_ranges(timing, coefficients, offsets, bounds, work)
    first = int(RopeDemand.BELOW_TROLLEY)
    while first < none and is_easy(first, lowest, highest, pull, square, bounds):
        first = first + 1
    if first == none:
        return RopeDemand.MET
    time = timing[offsets[0], Timing.START]
    until = interval_end(time, timing, offsets)
    failed = none
    intervals = 0
    # a plan of no duration is one interval as well
    while until > time or intervals == 0:
        intervals = intervals + 1
        interval_pieces(
            time, until, timing, coefficients, offsets, bounds[RopeBounds.GRAVITY], work
        )
        for demand in range(first, failed):
            if is_easy(demand, lowest, highest, pull, square, bounds):
                continue
            count = rope_demand(demand, bounds, coefficients.shape[1], work)
            if count > 0:
                share = first_negative(count, until - time, work)
                if share >= 0.0:
                    failed = demand
                    report[RopeFault.TIME] = time + share * (until - time)
                    break
        if any_one and failed < none:
            break
        time = until
        until = interval_end(time, timing, offsets)
    if failed == none:
        return RopeDemand.MET
    return failed


def rope_ranges(
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
    offsets: 'int[:]',
    bounds: 'float[:]',
    work: 'float[:,:]',
) -> 'tuple[float, float, float, float]':
    """Ranges of the whole trajectory: the load's heights and the least pull of z.

    The last one is the square of the greatest length of the rope over its depth, where it pulls.
    """
    lowest, highest = sum_range(2, 1.0, 0.0, timing, coefficients, offsets, work[0, :])
    least, most = sum_range(2, 0.0, 1.0, timing, coefficients, offsets, work[0, :])
    # an axis may rest before the others do
    pull = bounds[RopeBounds.GRAVITY] + min(least, 0.0)
    square = 1.0
    if pull > 0.0:
        for axis in range(2):
            least, most = sum_range(axis, 0.0, 1.0, timing, coefficients, offsets, work[0, :])
            slope = max(-least, most) / pull
            square = square + slope * slope
    return lowest, highest, pull, square


def is_easy(
    demand: int, lowest: float, highest: float, pull: float, square: float, bounds: 'float[:]'
) -> bool:
    """Whether a demand is met by `rope_ranges` alone.

    The rope is as long as the load is deep where it is vertical, and longer by the most where its
    slope is the greatest.
    """
    if demand == RopeDemand.TAUT:
        return pull > 0.0
    if demand == RopeDemand.NOT_TOO_SHORT:
        return -highest >= bounds[RopeBounds.SHORTEST]
    if highest > -least_depth():
        return False
    if demand == RopeDemand.BELOW_TROLLEY or bounds[RopeBounds.LONGEST] <= 0.0:
        return True
    return pull > 0.0 and -lowest * sqrt(square) <= bounds[RopeBounds.LONGEST]


def least_depth() -> float:
    """Least distance of the load below the trolley [m]; nothing swings on a shorter rope."""
    return 1e-6


def demand_bound(demand: int, bounds: 'float[:]') -> float:
    """Bound of a demand: height [m], downward acceleration [m/s2] or length [m]."""
    if demand == RopeDemand.TAUT:
        return bounds[RopeBounds.GRAVITY]
    if demand == RopeDemand.NOT_TOO_LONG:
        return bounds[RopeBounds.LONGEST]
    if demand == RopeDemand.NOT_TOO_SHORT:
        return bounds[RopeBounds.SHORTEST]
    return -least_depth()


def rope_demand(demand: int, bounds: 'float[:]', width: int, work: 'float[:,:]') -> int:
    """Write a demand's polynomial to work[RopeWork.DEMAND, :]; returns its length, 0: no demand."""
    tolerance = 1e-9
    bound = demand_bound(demand, bounds)
    if demand == RopeDemand.BELOW_TROLLEY:
        return rope_margin(demand, -bound, width, work)
    if demand == RopeDemand.TAUT:
        return rope_margin(demand, tolerance * bound, width, work)
    if bound <= 0.0:
        return 0
    if demand == RopeDemand.NOT_TOO_LONG:
        return rope_margin(demand, bound * (1.0 + tolerance), width, work)
    return rope_margin(demand, bound * (1.0 - tolerance), width, work)


def interval_end(time: float, timing: 'float[:,:]', offsets: 'int[:]') -> float:
    """First end of a piece of any axis after a time, or the time itself if there is none."""
    until = time
    for axis in range(3):
        last = offsets[axis + 1]
        row = find_piece(time, timing, offsets[axis], last)
        end = timing[row, Timing.START] + timing[row, Timing.LENGTH]
        if row + 1 < last:
            end = timing[row + 1, Timing.START]
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
    """Position and pull of all axes in an interval's local time; an axis rests after its end."""
    width = coefficients.shape[1]
    middle = 0.5 * (time + until)
    for axis in range(3):
        last = offsets[axis + 1]
        row = find_piece(middle, timing, offsets[axis], last)
        piece = work[RopeWork.LOAD + axis, :]
        for i in range(width):
            piece[i] = coefficients[row, i]
        if middle > timing[row, Timing.START] + timing[row, Timing.LENGTH]:
            piece[0] = evaluate_piece(coefficients, row, width, timing[row, Timing.LENGTH], 0)
            for i in range(1, width):
                piece[i] = 0.0
        else:
            polynomial_shift(piece, time - timing[row, Timing.START], width)
    rope_pull(gravity, width, work)


def first_negative(count: int, length: float, work: 'float[:,:]') -> float:
    """First share of the interval at which a demand is not proved to hold; -1: it holds.

    Hulls are reversed, so that the first half of an interval is on top.
    """
    start = work.shape[1] - 2
    depth = work.shape[1] - 1
    hull = work[RopeWork.HULLS:work.shape[0], :]
    bernstein_coefficients(work, RopeWork.DEMAND, count, length, hull)
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


def value_at(
    demand: int, local: float, gravity: float, width: int, work: 'float[:,:]'
) -> float:
    """Value bounded by a demand at a local time: height, downward acceleration or length."""
    z = evaluate_piece(work, RopeWork.LOAD + 2, width, local, 0)
    w_x = evaluate_piece(work, RopeWork.PULL, width - 2, local, 0)
    w_y = evaluate_piece(work, RopeWork.PULL + 1, width - 2, local, 0)
    w_z = evaluate_piece(work, RopeWork.PULL + 2, width - 2, local, 0)
    return rope_value(demand, gravity, z, w_x, w_y, w_z)


def worst_value(
    demand: int,
    first: float,
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
    offsets: 'int[:]',
    bounds: 'float[:]',
    work: 'float[:,:]',
) -> float:
    """Worst value bounded by a demand from a time on, of 33 samples per interval."""
    gravity = bounds[RopeBounds.GRAVITY]
    width = coefficients.shape[1]
    sign = 1.0
    if demand == RopeDemand.NOT_TOO_SHORT:
        sign = -1.0
    worst = -NEVER
    time = timing[offsets[0], Timing.START]
    until = interval_end(time, timing, offsets)
    intervals = 0
    while until > time or intervals == 0:
        intervals = intervals + 1
        if until >= first:
            interval_pieces(time, until, timing, coefficients, offsets, gravity, work)
            for i in range(33):
                local = max((until - time) * i / 32.0, first - time)
                worst = max(worst, sign * value_at(demand, local, gravity, width, work))
        time = until
        until = interval_end(time, timing, offsets)
    return sign * worst
