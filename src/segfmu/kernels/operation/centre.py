"""Velocities of a carriage that end the swing of its load, in the middle of its bounds.

A velocity is a cubic B-spline: it and its derivative are within bounds where the control points c
and their differences c_(i+1) - c_i over the time between knots are. The swing ends where

    sum_k m_jk (c_(k+1) - c_k) = r_j    for j = 1, 2

with the moments m_jk of controlled.py, and the carriage rests in a given place where the integral
of the velocity is the way there: a third linear condition. Among all c that keep the conditions
and the bounds, Newton's method finds the one with the largest product of the distances to the
bounds, their analytic centre (S. Boyd, L. Vandenberghe, Convex Optimization, 10.3 and 11.8.2). As
each bound is on one or two neighbours, the matrix of a step has three diagonals.

`work` is an `OperationWork`; conditions are counted from `first` up to `last`, without that.
"""

from segfmu.kernels.crane.records import Demand
from segfmu.kernels.crane.uses import bound_magnitude
from segfmu.kernels.numerics.matrices import matrix_solve
from segfmu.kernels.numerics.numbers import NEVER
from segfmu.kernels.operation.records import Control, Known, OperationWork


def most_newton() -> int:
    """Most steps of Newton's method."""
    return 60


def control_bound(
    demand: int, sense: float, share: float, fallback: float, known: 'float[:,:]'
) -> float:
    """Share of the bound of a demand in a direction, `fallback` where there is none."""
    side = 0
    if sense < 0.0:
        side = 1
    bound = share * bound_magnitude(demand, side, known[Known.BOUNDS, :])
    if bound == 0.0:
        bound = fallback
    return bound


def most_speed(
    axis: int, sense: float, share: float, interval: float, known: 'float[:,:]',
    work: 'float[:,:]',
) -> float:
    """Bound of a drive's control points in a direction [m/s]; without one, what none reaches."""
    most = most_change(axis, 1.0, share, interval, known)
    most = most + most_change(axis, -1.0, share, interval, known)
    most = abs(work[OperationWork.CONTROL + axis, 1]) + Control.POINTS * most
    return control_bound(Demand.VELOCITY + axis, sense, share, most, known)


def most_change(
    axis: int, sense: float, share: float, interval: float, known: 'float[:,:]'
) -> float:
    """Bound of their differences [m/s]: by the drive's acceleration."""
    return interval * control_bound(Demand.ACCELERATION + axis, sense, share, 0.0, known)


def decline_line(axis: int, work: 'float[:,:]') -> None:
    """Let the control points fall to zero along a line, from the last that the state sets on."""
    points = work[OperationWork.CONTROL + axis, :]
    begin = Control.FREE - 1
    last = Control.INTERVALS
    for i in range(Control.FREE, Control.POINTS):
        points[i] = points[begin] * max(last - i, 0) / (last - begin)


def is_inside_bounds(
    axis: int, share: float, interval: float, known: 'float[:,:]', work: 'float[:,:]'
) -> bool:
    """Whether the control points and their differences are inside the bounds.

    The first ones follow from the state; the proof judges what they do.
    """
    points = work[OperationWork.CONTROL + axis, :]
    fastest = most_speed(axis, 1.0, share, interval, known, work)
    slowest = most_speed(axis, -1.0, share, interval, known, work)
    rise = most_change(axis, 1.0, share, interval, known)
    fall = most_change(axis, -1.0, share, interval, known)
    for i in range(Control.FREE, Control.INTERVALS + 1):
        if not -slowest < points[i] < fastest:
            return False
        if not -fall < points[i] - points[i - 1] < rise:
            return False
    return True


def write_conditions(interval: float, work: 'float[:,:]') -> None:
    """Write the derivatives of the conditions by the free control points."""
    for i in range(Control.FREE, Control.INTERVALS):
        for j in range(Control.PLACE):
            moment = work[OperationWork.MOMENT + j, :]
            work[OperationWork.SLOPE + j, i] = moment[i - 1] - moment[i]
        work[OperationWork.SLOPE + Control.PLACE, i] = interval


def swing_left(j: int, aim: float, axis: int, work: 'float[:,:]') -> float:
    """What a condition of the swing lacks [m/s]."""
    left = aim
    for i in range(Control.POINTS - 1):
        change = work[OperationWork.CONTROL + axis, i + 1] - work[OperationWork.CONTROL + axis, i]
        left = left - work[OperationWork.MOMENT + j, i] * change
    return left


def place_left(aim: float, axis: int, interval: float, work: 'float[:,:]') -> float:
    """What the way of a carriage lacks [m]."""
    points = work[OperationWork.CONTROL + axis, :]
    # at the start the splines are cut off; at the end the control points are 0
    left = aim - interval * (points[0] + 12.0 * points[1] + 23.0 * points[2]) / 24.0
    for i in range(Control.FREE, Control.INTERVALS):
        left = left - interval * points[i]
    return left


def write_barrier(
    axis: int, share: float, interval: float, known: 'float[:,:]', work: 'float[:,:]'
) -> None:
    """Write the derivatives of minus the logarithm of the product."""
    points = work[OperationWork.CONTROL + axis, :]
    fastest = most_speed(axis, 1.0, share, interval, known, work)
    slowest = most_speed(axis, -1.0, share, interval, known, work)
    rise = most_change(axis, 1.0, share, interval, known)
    fall = most_change(axis, -1.0, share, interval, known)
    # of the difference before a point
    slope = 0.0
    curve = 0.0
    for i in range(Control.FREE - 1, Control.INTERVALS):
        over = 1.0 / (rise - points[i + 1] + points[i])
        under = 1.0 / (fall + points[i + 1] - points[i])
        slope_behind = over - under
        curve_behind = over * over + under * under
        over = 1.0 / (fastest - points[i])
        under = 1.0 / (slowest + points[i])
        work[OperationWork.CHANGE, i] = slope_behind - slope - over + under
        work[OperationWork.DIAGONAL, i] = curve + curve_behind + over * over + under * under
        work[OperationWork.COUPLING, i] = -curve_behind
        slope = slope_behind
        curve = curve_behind


def solve_barrier(first: int, last: int, work: 'float[:,:]') -> None:
    """Solve for Newton's step in CHANGE, and for a step by condition, by elimination."""
    change = work[OperationWork.CHANGE:OperationWork.SCHUR, :]
    for i in range(Control.FREE, Control.INTERVALS):
        for j in range(first, last):
            change[1 + j, i] = work[OperationWork.SLOPE + j, i]
    for i in range(Control.FREE + 1, Control.INTERVALS):
        ratio = work[OperationWork.COUPLING, i - 1] / work[OperationWork.DIAGONAL, i - 1]
        work[OperationWork.DIAGONAL, i] = (
            work[OperationWork.DIAGONAL, i] - ratio * work[OperationWork.COUPLING, i - 1]
        )
        change[0, i] = change[0, i] - ratio * change[0, i - 1]
        for j in range(first, last):
            change[1 + j, i] = change[1 + j, i] - ratio * change[1 + j, i - 1]
    for k in range(Control.FREE, Control.INTERVALS):
        i = Control.INTERVALS + Control.FREE - 1 - k
        coupling = work[OperationWork.COUPLING, i]
        if k == Control.FREE:
            coupling = 0.0
        change[0, i] = (change[0, i] - coupling * change[0, i + 1]) / work[
            OperationWork.DIAGONAL, i
        ]
        for j in range(first, last):
            change[1 + j, i] = (change[1 + j, i] - coupling * change[1 + j, i + 1]) / work[
                OperationWork.DIAGONAL, i
            ]


def join_changes(first: int, last: int, work: 'float[:,:]') -> float:
    """Join Newton's step in the first row of CHANGE, for what is in LACK. Returns its size.

    That is the largest change of a control point.
    """
    change = work[OperationWork.CHANGE:OperationWork.SCHUR, :]
    schur = work[OperationWork.SCHUR:OperationWork.LACK, :]
    lack = work[OperationWork.LACK:OperationWork.FLAT, :]
    for j in range(first, last):
        slopes = work[OperationWork.SLOPE + j, :]
        for k in range(first, last):
            schur[j - first, k - first] = 0.0
        for i in range(Control.FREE, Control.INTERVALS):
            lack[j - first, 0] = lack[j - first, 0] - slopes[i] * change[0, i]
            for k in range(first, last):
                schur[j - first, k - first] = (
                    schur[j - first, k - first] + slopes[i] * change[1 + k, i]
                )
    matrix_solve(last - first, 1, schur, lack)
    largest = 0.0
    for i in range(Control.FREE, Control.INTERVALS):
        for j in range(first, last):
            change[0, i] = change[0, i] + lack[j - first, 0] * change[1 + j, i]
        if not abs(change[0, i]) < NEVER:
            return NEVER
        largest = max(largest, abs(change[0, i]))
    for i in range(Control.FREE):
        change[0, i] = 0.0
        change[0, Control.INTERVALS + i] = 0.0
    return largest


def way_to_bounds(
    axis: int, share: float, interval: float, known: 'float[:,:]', work: 'float[:,:]'
) -> float:
    """How many times the step in CHANGE reaches a bound."""
    points = work[OperationWork.CONTROL + axis, :]
    change = work[OperationWork.CHANGE, :]
    fastest = most_speed(axis, 1.0, share, interval, known, work)
    slowest = most_speed(axis, -1.0, share, interval, known, work)
    rise = most_change(axis, 1.0, share, interval, known)
    fall = most_change(axis, -1.0, share, interval, known)
    inverse = 0.0
    for i in range(Control.FREE - 1, Control.INTERVALS):
        moved = change[i + 1] - change[i]
        step = points[i + 1] - points[i]
        inverse = max(inverse, moved / (rise - step))
        inverse = max(inverse, -moved / (fall + step))
        inverse = max(inverse, change[i] / (fastest - points[i]))
        inverse = max(inverse, -change[i] / (slowest + points[i]))
    if inverse > 0.0:
        return 1.0 / inverse
    return NEVER


def find_centre(
    axis: int, share: float, interval: float, first: int, last: int, aims: 'float[:]',
    known: 'float[:,:]', work: 'float[:,:]',
) -> bool:
    """Find the control points of a drive; False if none are inside the bounds.

    share: of the bounds, interval: time between knots [s], aims: r_1 and r_2 [m/s] and the way [m].
    """
    decline_line(axis, work)
    if not is_inside_bounds(axis, share, interval, known, work):
        return False
    write_conditions(interval, work)
    met = False
    for _ in range(most_newton()):
        write_barrier(axis, share, interval, known, work)
        solve_barrier(first, last, work)
        for j in range(first, last):
            if j < Control.PLACE:
                work[OperationWork.LACK + j - first, 0] = swing_left(j, aims[j], axis, work)
            else:
                work[OperationWork.LACK + j - first, 0] = place_left(aims[j], axis, interval, work)
        largest = join_changes(first, last, work)
        step = min(0.9 * way_to_bounds(axis, share, interval, known, work), 1.0)
        # nor is what is no number a step
        if not step > 1e-4 or not largest < NEVER:
            return False
        for i in range(Control.FREE, Control.INTERVALS):
            work[OperationWork.CONTROL + axis, i] = (
                work[OperationWork.CONTROL + axis, i] + step * work[OperationWork.CHANGE, i]
            )
        if step == 1.0:
            met = True
            if largest <= 1e-9 * most_change(axis, 1.0, share, interval, known):
                return True
    return met
