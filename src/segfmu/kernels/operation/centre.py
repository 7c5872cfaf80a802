"""Velocities of a carriage that stop it and the swing of its load, in the middle of its bounds.

A velocity is a quadratic B-spline: it and its derivative are within bounds where the control points
c and their differences c_(i+1) - c_i over the time between knots are. The swing ends where

    sum_k m_jk (c_(k+1) - c_k) = r_j    for j = 1, 2

with the moments m_jk of controlled.py. Among all c that keep this and the bounds, Newton's method
finds the one with the largest product of the distances to the bounds, their analytic centre
(S. Boyd, L. Vandenberghe, Convex Optimization, 10.3 and 11.8.2). As each bound is on one or two
neighbours, the matrix of a step has three diagonals.

`work` is an `OperationWork`.
"""

from segfmu.kernels.crane.records import Demand
from segfmu.kernels.crane.uses import bound_magnitude
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
    """Let the control points fall to zero along a line, from the second one on."""
    points = work[OperationWork.CONTROL + axis, :]
    start = points[1]
    last = Control.INTERVALS
    for i in range(1, last + 1):
        points[i] = start * (last - i) / (last - 1)
    points[last + 1] = 0.0


def is_inside_bounds(
    axis: int, share: float, interval: float, known: 'float[:,:]', work: 'float[:,:]'
) -> bool:
    """Whether the control points and their differences are inside the bounds.

    The first two follow from the state; the proof judges what they do.
    """
    points = work[OperationWork.CONTROL + axis, :]
    fastest = most_speed(axis, 1.0, share, interval, known, work)
    slowest = most_speed(axis, -1.0, share, interval, known, work)
    rise = most_change(axis, 1.0, share, interval, known)
    fall = most_change(axis, -1.0, share, interval, known)
    for i in range(Control.INTERVALS):
        if not -slowest < points[i + 2] < fastest:
            return False
        if not -fall < points[i + 2] - points[i + 1] < rise:
            return False
    return -fall < points[1] - points[0] < rise


def condition_slope(j: int, i: int, work: 'float[:,:]') -> float:
    """Derivative of a condition by a control point."""
    return work[OperationWork.MOMENT + j, i - 1] - work[OperationWork.MOMENT + j, i]


def condition_left(j: int, aim: float, axis: int, work: 'float[:,:]') -> float:
    """What a condition lacks."""
    left = aim
    for i in range(Control.INTERVALS + 1):
        change = work[OperationWork.CONTROL + axis, i + 1] - work[OperationWork.CONTROL + axis, i]
        left = left - work[OperationWork.MOMENT + j, i] * change
    return left


def write_barrier(
    axis: int, share: float, interval: float, known: 'float[:,:]', work: 'float[:,:]'
) -> None:
    """Write the derivatives of minus the logarithm of the product, and the conditions' rows."""
    points = work[OperationWork.CONTROL + axis, :]
    fastest = most_speed(axis, 1.0, share, interval, known, work)
    slowest = most_speed(axis, -1.0, share, interval, known, work)
    rise = most_change(axis, 1.0, share, interval, known)
    fall = most_change(axis, -1.0, share, interval, known)
    # of the difference before a point
    slope = 0.0
    curve = 0.0
    for i in range(1, Control.INTERVALS):
        over = 1.0 / (rise - points[i + 1] + points[i])
        under = 1.0 / (fall + points[i + 1] - points[i])
        slope_behind = over - under
        curve_behind = over * over + under * under
        over = 1.0 / (fastest - points[i])
        under = 1.0 / (slowest + points[i])
        work[OperationWork.CHANGE, i] = slope_behind - slope - over + under
        work[OperationWork.DIAGONAL, i] = curve + curve_behind + over * over + under * under
        work[OperationWork.COUPLING, i] = -curve_behind
        for j in range(2):
            work[OperationWork.CHANGE + 1 + j, i] = condition_slope(j, i, work)
        slope = slope_behind
        curve = curve_behind


def solve_barrier(work: 'float[:,:]') -> None:
    """Solve for the three right-hand sides in CHANGE, by elimination."""
    for i in range(3, Control.INTERVALS):
        ratio = work[OperationWork.COUPLING, i - 1] / work[OperationWork.DIAGONAL, i - 1]
        work[OperationWork.DIAGONAL, i] = (
            work[OperationWork.DIAGONAL, i] - ratio * work[OperationWork.COUPLING, i - 1]
        )
        for j in range(3):
            work[OperationWork.CHANGE + j, i] = (
                work[OperationWork.CHANGE + j, i] - ratio * work[OperationWork.CHANGE + j, i - 1]
            )
    for k in range(2, Control.INTERVALS):
        i = Control.INTERVALS + 1 - k
        for j in range(3):
            found = work[OperationWork.CHANGE + j, i]
            if k > 2:
                found = found - work[OperationWork.COUPLING, i] * work[
                    OperationWork.CHANGE + j, i + 1
                ]
            work[OperationWork.CHANGE + j, i] = found / work[OperationWork.DIAGONAL, i]


def join_changes(first: float, second: float, work: 'float[:,:]') -> float:
    """Join Newton's step in the first row of CHANGE; what the conditions lack. Returns its size.

    That is the largest change of a control point.
    """
    # the 2 x 2 matrix of what the steps by condition do to the conditions
    a = 0.0
    b = 0.0
    d = 0.0
    for i in range(2, Control.INTERVALS):
        row = condition_slope(0, i, work)
        other = condition_slope(1, i, work)
        first = first - row * work[OperationWork.CHANGE, i]
        second = second - other * work[OperationWork.CHANGE, i]
        a = a + row * work[OperationWork.CHANGE + 1, i]
        b = b + row * work[OperationWork.CHANGE + 2, i]
        d = d + other * work[OperationWork.CHANGE + 2, i]
    determinant = a * d - b * b
    share_first = (d * first - b * second) / determinant
    share_second = (a * second - b * first) / determinant
    if not abs(share_first) + abs(share_second) < NEVER:
        return NEVER
    largest = 0.0
    for i in range(2, Control.INTERVALS):
        work[OperationWork.CHANGE, i] = (
            work[OperationWork.CHANGE, i] + share_first * work[OperationWork.CHANGE + 1, i]
            + share_second * work[OperationWork.CHANGE + 2, i]
        )
        largest = max(largest, abs(work[OperationWork.CHANGE, i]))
    for i in range(2):
        work[OperationWork.CHANGE, i] = 0.0
        work[OperationWork.CHANGE, Control.INTERVALS + i] = 0.0
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
    for i in range(1, Control.INTERVALS):
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
    axis: int, share: float, interval: float, first: float, second: float, known: 'float[:,:]',
    work: 'float[:,:]',
) -> bool:
    """Find the control points of bridge or trolley; False if none are inside the bounds.

    share: of the bounds, interval: time between knots [s], first and second: r_1 and r_2 [m/s].
    """
    decline_line(axis, work)
    if not is_inside_bounds(axis, share, interval, known, work):
        return False
    met = False
    for _ in range(most_newton()):
        write_barrier(axis, share, interval, known, work)
        solve_barrier(work)
        largest = join_changes(
            condition_left(0, first, axis, work), condition_left(1, second, axis, work), work
        )
        step = min(0.9 * way_to_bounds(axis, share, interval, known, work), 1.0)
        # nor is what is no number a step
        if not step > 1e-4 or not largest < NEVER:
            return False
        for i in range(2, Control.INTERVALS):
            work[OperationWork.CONTROL + axis, i] = (
                work[OperationWork.CONTROL + axis, i] + step * work[OperationWork.CHANGE, i]
            )
        if step == 1.0:
            met = True
            if largest <= 1e-9 * most_change(axis, 1.0, share, interval, known):
                return True
    return met
