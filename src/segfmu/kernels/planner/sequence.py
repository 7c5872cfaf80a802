"""Sequences of levels of a derivative above the acceleration, and their equations.

Where the highest limit is that of the derivative m > 4, ramps of the acceleration cost time: each
one brings all derivatives above to zero, while the optimum passes zero jerk with snap. So profiles
here have levels of the derivative q = m - 2 instead (at most the snap), joined by its fastest
rises. Only the derivatives above q are zero at the levels. q free levels meet the q conditions at
the end: position, velocity, acceleration, and jerk where q is 4. The derivative k < q stays at its
limit on a plateau, a node of level 0 with a hold: q - k more conditions.

A free level has one unknown, the duration of the rise from 0 to it and, beyond its limit, of its
hold. That of a plateau is its hold. Where the plateau of the derivative q - 2 has no time left, its
node becomes a level, which touches the limit; that of q - 1 or q - 3 has one condition less then
(TOUCH). One level more has the peak of a derivative at its limit as its condition (instant.py).
"""

from segfmu.kernels.planner.instant import instant_error
from segfmu.kernels.planner.ramp import plateau_change, plateau_duration, rise_moments
from segfmu.kernels.planner.records import (
    Axis,
    Equations,
    Node,
    Passing,
    PlanWork,
    Problem,
    Touch,
)
from segfmu.kernels.planner.sides import fastest_velocity, side_limit


def power_of(base: float, exponent: int) -> float:
    """base to the exponent, a small whole number."""
    power = 1.0
    for i in range(exponent):
        power = power * base
    return power


def set_level(node: 'float[:]', passing: 'float[:]', axis: 'float[:]') -> None:
    """Set level and hold of a node from its time."""
    above = int(passing[Passing.ABOVE])
    kind = int(node[Node.KIND])
    pace = passing[Passing.PACE]
    time = node[Node.TIME]
    node[Node.LEVEL] = 0.0
    node[Node.HOLD] = time
    if int(node[Node.TOUCH]) != Touch.HOLDS:
        return
    if kind > 0 and (kind != above or time >= 0.0):
        return
    sign = node[Node.SIGN] * power_of(pace, above + 2)
    if time < 0.0:
        sign = -sign
    rise = abs(time)
    node[Node.HOLD] = 0.0
    most = axis[Axis.RISES + above - 1]
    if rise >= most:
        node[Node.LEVEL] = sign * axis[Axis.JERK + above - 1]
        node[Node.HOLD] = (rise - most) / pace
    elif rise > 0.0:
        change, slope = plateau_change(rise, above, axis)
        node[Node.LEVEL] = sign * change


def advance(
    time: float, level: float, change: float, variance: float, fourth: float, above: int,
    state: 'float[:]',
) -> None:
    """Advance the derivatives below q = 2 + above by a hold at a level, or a rise from it.

    The rise by `change` has the given variance and fourth cumulant of its slope over time.
    """
    half = 0.5 * time
    moment = half
    # integrals of 1 over the time, of the order 1 to 4
    second = half * time
    third = second * time / 3.0
    last = 0.25 * third * time
    for k in range(above + 2):
        order = above + 2 - k
        total = state[k]
        if order == 4:
            total = total + time * state[k + 1] + second * state[k + 2]
            farthest = k + 3
            total = total + third * state[farthest]
        elif order == 3:
            total = total + time * state[k + 1] + second * state[k + 2]
            last = third
        elif order == 2:
            total = total + time * state[k + 1]
            last = second
        else:
            last = time
        total = total + last * level
        if change != 0.0:
            square = half * half
            if order == 1:
                moment = half
            elif order == 2:
                moment = 0.5 * (square + variance)
            elif order == 3:
                moment = half * (square + 3.0 * variance) / 6.0
            else:
                moment = square * (square + 6.0 * variance) + 3.0 * variance * variance
                moment = (moment + fourth) / 24.0
            total = total + change * moment
        state[k] = total


def pass_node(i: int, passing: 'float[:]', axis: 'float[:]', nodes: 'float[:,:]') -> None:
    """Ramp to the level of a node; the state after it is written to the next node."""
    above = int(passing[Passing.ABOVE])
    pace = passing[Passing.PACE]
    before = nodes[i - 1, Node.LEVEL] if i > 0 else passing[Passing.START]
    change = nodes[i, Node.LEVEL] - before
    for k in range(above + 2):
        nodes[i + 1, Node.STATE + k] = nodes[i, Node.STATE + k]
    nodes[i, Node.RAMP] = 0.0
    if change != 0.0:
        basis, slope = plateau_duration(abs(change) / power_of(pace, above + 2), above, axis)
        variance, fourth = rise_moments(basis, above, axis)
        square = 1.0 / (pace * pace)
        nodes[i, Node.RAMP] = basis / pace
        advance(
            basis / pace, before, change, variance * square, fourth * square * square, above,
            nodes[i + 1, :],
        )


def dropped_condition(q: int, node: 'float[:]') -> int:
    """Derivative whose condition at a plateau is that of the hold instead, its order; -1: none."""
    if int(node[Node.TOUCH]) == Touch.BELOW:
        return int(node[Node.KIND])
    return q - 1 if int(node[Node.TOUCH]) != Touch.HOLDS else -1


def node_residuals(
    i: int, row: int, passing: 'float[:]', axis: 'float[:]', nodes: 'float[:,:]',
    residual: 'float[:]',
) -> int:
    """Write the conditions at a plateau, after the ramp to it, from `row` on; the next row."""
    q = int(passing[Passing.ABOVE]) + 2
    kind = int(nodes[i, Node.KIND])
    dropped = dropped_condition(q, nodes[i, :])
    if kind == 0:
        return row
    for k in range(kind, q):
        error = nodes[i + 1, Node.STATE + k]
        if k == kind:
            sign = nodes[i, Node.SIGN]
            error = error - sign * side_limit(kind, sign, axis)
        residual[Equations.VALUES + row] = error / residual_scale(k, passing, axis)
        if k == dropped:
            error = nodes[i, Node.TIME] - nodes[i, Node.AIM]
            residual[Equations.VALUES + row] = error / passing[Passing.TIME]
        row = row + 1
    return row


def stays_at_limit(node: 'float[:]') -> bool:
    """Whether a derivative is held at its limit at a node, rather than touching it."""
    if node[Node.KIND] == 0.0 or node[Node.LEVEL] != 0.0:
        return False
    return int(node[Node.TOUCH]) == Touch.HOLDS


def hold_limit(q: int, node: 'float[:]', axis: 'float[:]', state: 'float[:]') -> None:
    """Remove the rounding errors of a state on a plateau, which a long hold would enlarge."""
    if stays_at_limit(node):
        kind = int(node[Node.KIND])
        state[Node.STATE + kind] = node[Node.SIGN] * side_limit(kind, node[Node.SIGN], axis)
        for k in range(kind + 1, q):
            state[Node.STATE + k] = 0.0


def first_row(node: int, passing: 'float[:]', nodes: 'float[:,:]') -> int:
    """The first row of the conditions at a node, or at the end: the number of those before."""
    q = int(passing[Passing.ABOVE]) + 2
    row = 0
    for i in range(node):
        if nodes[i, Node.KIND] != 0.0:
            row = row + q - int(nodes[i, Node.KIND])
    return row


def follow_node(
    i: int, row: int, problem: 'float[:]', passing: 'float[:]', axis: 'float[:]',
    nodes: 'float[:,:]', residual: 'float[:]',
) -> int:
    """Follow a sequence to the end of a node and write the residuals there from `row` on.

    The node after the last one is the end. Returns the next row.
    """
    q = int(passing[Passing.ABOVE]) + 2
    if i == int(passing[Passing.COUNT]):
        nodes[i, Node.KIND] = 0.0
        nodes[i, Node.LEVEL] = 0.0
        nodes[i, Node.HOLD] = 0.0
        pass_node(i, passing, axis, nodes)
        end_residuals(row, problem, passing, axis, nodes[i + 1, :], residual)
        return row + q
    set_level(nodes[i, :], passing, axis)
    pass_node(i, passing, axis, nodes)
    row = node_residuals(i, row, passing, axis, nodes, residual)
    hold = nodes[i, Node.HOLD]
    hold_limit(q, nodes[i, :], axis, nodes[i + 1, :])
    if hold != 0.0:
        advance(hold, nodes[i, Node.LEVEL], 0.0, 0.0, 0.0, q - 2, nodes[i + 1, :])
    return row


def run_sequence(
    problem: 'float[:]', passing: 'float[:]', axis: 'float[:]', nodes: 'float[:,:]',
    residual: 'float[:]',
) -> None:
    """Follow a sequence, and write its residuals."""
    for k in range(int(passing[Passing.ABOVE]) + 2):
        nodes[0, Node.STATE + k] = 0.0
    nodes[0, Node.STATE + 1] = problem[Problem.V]
    nodes[0, Node.STATE + 2] = problem[Problem.A]
    jerk = Node.STATE + 3
    if int(passing[Passing.ABOVE]) > 1:
        nodes[0, jerk] = passing[Passing.JERK]
    row = 0
    for i in range(int(passing[Passing.COUNT]) + 1):
        row = follow_node(i, row, problem, passing, axis, nodes, residual)
    for peak in range(int(passing[Passing.INSTANTS])):
        scale = residual_scale(int(passing[Passing.INSTANT_ORDER + peak]), passing, axis)
        error = instant_error(peak, passing, axis, nodes)
        residual[Equations.VALUES + row] = error / scale
        row = row + 1
    if passing[Passing.TARGET] > 0.0:
        error = sequence_duration(passing, nodes) - passing[Passing.TARGET]
        if passing[Passing.FREE] != 0.0:
            # in place of the distance
            row = first_row(int(passing[Passing.COUNT]), passing, nodes)
        residual[Equations.VALUES + row] = error / passing[Passing.TIME]


def follow_change(
    first: int, row: int, passing: 'float[:]', axis: 'float[:]', nodes: 'float[:,:]',
    change: 'float[:]', slopes: 'float[:]',
) -> None:
    """Follow a small change of the state before the ramp to node `first`, which is linear.

    Written: the change of the residuals from `row` on, those of that node.
    """
    q = int(passing[Passing.ABOVE]) + 2
    count = int(passing[Passing.COUNT])
    for i in range(first, count + 1):
        advance(nodes[i, Node.RAMP], 0.0, 0.0, 0.0, 0.0, q - 2, change)
        kind = int(nodes[i, Node.KIND])
        dropped = -1
        if i < count:
            dropped = dropped_condition(q, nodes[i, :])
        if kind > 0 or i == count:
            for k in range(kind, q):
                slope = change[Node.STATE + k] / residual_scale(k, passing, axis)
                if k == dropped:
                    slope = 0.0
                slopes[Equations.VALUES + row] = slope
                row = row + 1
        if stays_at_limit(nodes[i, :]):
            for k in range(kind, q):
                change[Node.STATE + k] = 0.0
        if nodes[i, Node.HOLD] != 0.0:
            advance(nodes[i, Node.HOLD], 0.0, 0.0, 0.0, 0.0, q - 2, change)


def end_residuals(
    row: int, problem: 'float[:]', passing: 'float[:]', axis: 'float[:]', end: 'float[:]',
    residual: 'float[:]',
) -> None:
    """Write the conditions at the end of a sequence, whose state is in `end`, from `row` on."""
    for k in range(int(passing[Passing.ABOVE]) + 2):
        target = 0.0
        if k == 0:
            target = problem[Problem.DISTANCE]
        elif k == 1:
            target = problem[Problem.W]
        elif k == 2:
            target = problem[Problem.B]
        error = end[Node.STATE + k] - target
        residual[Equations.VALUES + row + k] = error / residual_scale(k, passing, axis)


def residual_scale(order: int, passing: 'float[:]', axis: 'float[:]') -> float:
    """What a derivative is measured in: about its peak, for the same rounding errors of all."""
    acceleration, time = passing[Passing.ACCELERATION], passing[Passing.TIME]
    if order > 1:
        return acceleration / power_of(min(time, axis[Axis.FULL_RAMP]), order - 2)
    speed = min(fastest_velocity(axis), acceleration * time)
    return speed if order == 1 else speed * time


def sequence_duration(passing: 'float[:]', nodes: 'float[:,:]') -> float:
    """Duration of a sequence [s]."""
    total = 0.0
    for i in range(int(passing[Passing.COUNT]) + 1):
        total = total + nodes[i, Node.RAMP] + nodes[i, Node.HOLD]
    return total


def is_square(passing: 'float[:]', nodes: 'float[:,:]') -> bool:
    """Whether a sequence has as many unknowns as conditions."""
    count = int(passing[Passing.COUNT])
    conditions = first_row(count, passing, nodes) + int(passing[Passing.ABOVE]) + 2
    conditions = conditions + int(passing[Passing.INSTANTS])
    return conditions == count and count + 2 <= PlanWork.KEPT - PlanWork.NODES
