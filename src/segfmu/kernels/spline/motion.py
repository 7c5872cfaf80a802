"""The motion of one axis between two states that needs least of its limits, as a spline.

A spline of degree n + 1 is in C^n. It lies in the hull of its control points, and so do its
derivatives: limits and a range of positions are linear in the control points (program.py).
"""

from segfmu.kernels.numerics.numbers import HALF_DIGITS, NEVER
from segfmu.kernels.planner.records import Axis, WaypointState
from segfmu.kernels.planner.sides import side_limit
from segfmu.kernels.spline.basis import derivative_rows, finer_rows, write_end_points
from segfmu.kernels.spline.equations import begin_smoothly
from segfmu.kernels.spline.program import least_share
from segfmu.kernels.spline.records import Bound, Program, SplineWork


def spline_share(
    highest: bool, duration: float, first: 'float[:]', last: 'float[:]', allowed: 'float[:]',
    axis: 'float[:]', work: 'float[:,:]',
) -> float:
    """The least share of limits that a motion of a duration [s] needs; 1e300: there is none.

    highest: of the highest limit alone, within the others and the range of the positions; else of
    all limits and the range. first, last (Derivatives): the states at the ends. allowed (2,): range
    of the positions [m]. axis (Axis): the limits. work (SplineWork rows, columns): the control
    points. A share above 1 is no motion.
    """
    n = int(axis[Axis.SMOOTHNESS])
    program = work[SplineWork.PROGRAM, :]
    program[Program.DEGREE] = n + 1
    program[Program.COUNT] = 0.0
    unit = scale_states(duration, first, last, work)
    if not 0.0 < unit < NEVER:
        return NEVER
    top = 0
    for order in range(1, n + 2):
        if axis[Axis.VELOCITY + order - 1] > 0.0:
            top = order
    write_end_points(work)
    power = 1.0 / unit
    for order in range(1, n + 2):
        power = power * duration
        if axis[Axis.VELOCITY + order - 1] > 0.0:
            begin = int(program[Program.COUNT])
            derivative_rows(order, work)
            bound_derivative(order, begin, power, not highest or order == top, axis, work)
    if not begin_smoothly(top, work):
        return NEVER
    begin = int(program[Program.COUNT])
    if allowed[0] > -NEVER or allowed[1] < NEVER:
        finer_rows(work)
        low = (allowed[0] - first[WaypointState.POSITION]) / unit
        high = (allowed[1] - first[WaypointState.POSITION]) / unit
        bound_positions(begin, low, high, not highest, work)
    return least_share(1.0 if highest else NEVER, work)


def scale_states(
    duration: float, first: 'float[:]', last: 'float[:]', work: 'float[:,:]'
) -> float:
    """Write the states at the ends in the unit of length, which is returned [m].

    That is how far the ends alone would lead in the time.
    """
    program = work[SplineWork.PROGRAM, :]
    begin, end = work[SplineWork.BEGIN, :], work[SplineWork.END, :]
    unit = 0.0
    power = 1.0
    for order in range(int(program[Program.DEGREE])):
        begin[order] = first[order] * power
        end[order] = last[order] * power
        if order == 0:
            end[order] = end[order] - begin[order]
            begin[order] = 0.0
        unit = max(unit, max(abs(begin[order]), abs(end[order])))
        power = power * duration
    if unit > 0.0:
        for order in range(int(program[Program.DEGREE])):
            begin[order] = begin[order] / unit
            end[order] = end[order] / unit
    return unit


def bound_derivative(
    order: int, begin: int, power: float, shared: bool, axis: 'float[:]', work: 'float[:,:]'
) -> None:
    """Set the limits of a derivative's control points, whose bounds begin in a row.

    power: of the duration over the unit of length. shared: the share is that of these limits.
    """
    larger = max(side_limit(order, 1.0, axis), side_limit(order, -1.0, axis))
    for i in range(begin, int(work[SplineWork.PROGRAM, Program.COUNT])):
        bound = work[SplineWork.BOUNDS + i, :]
        scale_bound(1.0 / (larger * power), bound)
        for side in range(2):
            sign = 1.0 - 2.0 * side
            limit = side_limit(order, sign, axis) / larger * (1.0 - HALF_DIGITS)
            bound[Bound.PART + side] = limit if shared else 0.0
            bound[Bound.ROOM + side] = -sign * bound[Bound.GIVEN]
            if not shared:
                bound[Bound.ROOM + side] = limit - sign * bound[Bound.GIVEN]


def bound_positions(
    begin: int, low: float, high: float, shared: bool, work: 'float[:,:]'
) -> None:
    """Set the range of the finer control points, whose bounds begin in a row.

    low, high: over the unit of length. The share is measured from that range, or from one of a
    unit.
    """
    size = min(high - low, 1.0)
    if not size > 0.0:
        size = 1.0
    part = 1.0 if shared else 0.0
    for i in range(begin, int(work[SplineWork.PROGRAM, Program.COUNT])):
        bound = work[SplineWork.BOUNDS + i, :]
        # positions are means of control points; beside the ends few of what counts is free
        weight = 0.0
        for k in range(int(bound[Bound.COUNT])):
            weight = weight + bound[Bound.BY + k]
        scale_bound(1.0 / weight, bound)
        given = bound[Bound.GIVEN] / size
        scale_bound(1.0 / size, bound)
        for side in range(2):
            sign = 1.0 - 2.0 * side
            edge = high if side == 0 else -low
            bound[Bound.PART + side] = part
            bound[Bound.ROOM + side] = NEVER
            if edge < NEVER:
                room = edge / (weight * size) - sign * given
                bound[Bound.ROOM + side] = room - HALF_DIGITS - part


def scale_bound(factor: float, bound: 'float[:]') -> None:
    """Multiply what a bound depends on."""
    bound[Bound.GIVEN] = bound[Bound.GIVEN] * factor
    for k in range(int(bound[Bound.COUNT])):
        bound[Bound.BY + k] = bound[Bound.BY + k] * factor
