"""Derivatives that reach their limits for an instant only, in a sequence of levels of the snap.

An optimum that the velocity, or the acceleration, touches without staying there has one level more
than the conditions at the end need, and its peak at the limit as the condition for it.
"""

from segfmu.kernels.planner.nested import held_level, piece_peak
from segfmu.kernels.planner.ramp_peak import crossing_time, taylor
from segfmu.kernels.planner.records import Axis, Node, Passing


def highest_in_piece(
    length: float, value: float, first: float, second: float, third: float, fourth: float,
    fifth: float, sixth: float,
) -> float:
    """Largest value of a polynomial on [0, length] at its end, or where a rise becomes a fall.

    It is given by its value and its derivatives at 0. One such place is looked for; whether a
    sequence keeps its limits is judged by `measure_excess`.
    """
    end = length
    highest = value + taylor(end, first, second, third, fourth, fifth)
    highest = highest + power_term(end, sixth)
    slope = first + taylor(end, second, third, fourth, fifth, sixth)
    if first > 0.0 and slope < 0.0:
        end = crossing_time(first, length, second, third, fourth, fifth, sixth)
        at = value + taylor(end, first, second, third, fourth, fifth)
        highest = max(highest, at + power_term(end, sixth))
    return highest


def power_term(t: float, sixth: float) -> float:
    """Change within t by the sixth derivative."""
    return t * t * t * t * t * t * sixth / 720.0


def highest_at_node(
    order: int, sign: float, i: int, passing: 'float[:]', axis: 'float[:]', nodes: 'float[:,:]'
) -> float:
    """Largest value of the derivative `order`, 1 or 2, times `sign` in ramp and hold of a node."""
    boxes = int(axis[Axis.SMOOTHNESS]) - 3
    before = passing[Passing.START]
    if i > 0:
        before = nodes[i - 1, Node.LEVEL]
    jerk_at = Node.STATE + 3
    v = sign * nodes[i, Node.STATE + 1]
    a = sign * nodes[i, Node.STATE + 2]
    jerk = sign * nodes[i, jerk_at]
    snap = sign * before
    crackle = 0.0
    pop = 0.0
    seventh = 0.0
    ramp = nodes[i, Node.RAMP]
    change = sign * (nodes[i, Node.LEVEL] - before)
    highest = v
    if order == 2:
        highest = a
    for piece in range(1, 2**boxes + 1):
        # the last piece is the hold
        length = nodes[i, Node.HOLD]
        if piece < 2**boxes:
            length = 0.0
            if ramp > 0.0:
                held, direction = held_level(piece, boxes)
                length, peak = piece_peak(held, 2, change, ramp, ramp * passing[Passing.PACE], axis)
                if held == 0:
                    crackle, pop, seventh = direction * peak, 0.0, 0.0
                elif held == 1:
                    pop, seventh = direction * peak, 0.0
                else:
                    seventh = direction * peak
        else:
            snap, crackle, pop, seventh = sign * nodes[i, Node.LEVEL], 0.0, 0.0, 0.0
        if length > 0.0:
            at = highest_in_piece(length, v, a, jerk, snap, crackle, pop, seventh)
            if order == 2:
                at = highest_in_piece(length, a, jerk, snap, crackle, pop, seventh, 0.0)
            highest = max(highest, at)
            v = v + taylor(length, a, jerk, snap, crackle, pop) + power_term(length, seventh)
            a = a + taylor(length, jerk, snap, crackle, pop, seventh)
            jerk = jerk + taylor(length, snap, crackle, pop, seventh, 0.0)
            snap = snap + taylor(length, crackle, pop, seventh, 0.0, 0.0)
            crackle = crackle + taylor(length, pop, seventh, 0.0, 0.0, 0.0)
            pop = pop + length * seventh
    return highest


def instant_error(
    peak: int, passing: 'float[:]', axis: 'float[:]', nodes: 'float[:,:]'
) -> float:
    """By how much the derivative of an instant exceeds its limit at the nodes around it."""
    order = int(passing[Passing.INSTANT_ORDER + peak])
    first = max(int(passing[Passing.INSTANT_FROM + peak]), 0)
    last = int(passing[Passing.INSTANT_TO + peak])
    highest = -1e300
    for i in range(int(passing[Passing.COUNT]) + 1):
        if i >= first and i <= last:
            sign = passing[Passing.INSTANT_SIGN + peak]
            highest = max(highest, highest_at_node(order, sign, i, passing, axis, nodes))
    return highest - axis[Axis.VELOCITY + order - 1]


def shift_instants(place: int, by: int, passing: 'float[:]') -> None:
    """Keep the instants where they are as nodes from `place` on move."""
    for peak in range(int(passing[Passing.INSTANTS])):
        if passing[Passing.INSTANT_FROM + peak] >= place:
            passing[Passing.INSTANT_FROM + peak] = passing[Passing.INSTANT_FROM + peak] + by
        if passing[Passing.INSTANT_TO + peak] >= place:
            passing[Passing.INSTANT_TO + peak] = passing[Passing.INSTANT_TO + peak] + by


def add_instant(order: int, sign: float, node: int, passing: 'float[:]') -> None:
    """Add the condition that a derivative reaches its limit near a node."""
    peak = int(passing[Passing.INSTANTS])
    passing[Passing.INSTANT_ORDER + peak] = order
    passing[Passing.INSTANT_SIGN + peak] = sign
    passing[Passing.INSTANT_FROM + peak] = node - 1
    passing[Passing.INSTANT_TO + peak] = node + 1
    passing[Passing.INSTANTS] = peak + 1
