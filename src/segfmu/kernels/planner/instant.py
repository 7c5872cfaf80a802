"""Derivatives that reach their limits for an instant only, in a sequence (sequence.py).

An optimum that the velocity, or the acceleration, touches without staying there has one level more
than the conditions at the end need, and its peak at the limit as the condition for it.
"""

from segfmu.kernels.numerics.numbers import NEVER
from segfmu.kernels.planner.nested import held_level, piece_peak, rise_pieces
from segfmu.kernels.planner.ramp_peak import crossing_time, taylor
from segfmu.kernels.planner.records import Axis, Node, Passing
from segfmu.kernels.planner.sides import side_limit


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
    """Largest value of a derivative times `sign` in ramp and hold of a node.

    order: one, two or three below that of the levels.
    """
    above = int(passing[Passing.ABOVE])
    boxes = int(axis[Axis.SMOOTHNESS]) - 1 - above
    before = nodes[i - 1, Node.LEVEL] if i > 0 else passing[Passing.START]
    # the derivatives below the level, three, two and one lower, and those above it
    below = Node.STATE + above + 1
    upper = sign * nodes[i, below]
    below = below - 1
    lower = sign * nodes[i, below]
    below = below - 1
    lowest = sign * nodes[i, below]
    level = sign * before
    slope, curvature, third = 0.0, 0.0, 0.0
    ramp = nodes[i, Node.RAMP]
    change = sign * (nodes[i, Node.LEVEL] - before)
    highest = lowest
    if order == above:
        highest = lower
    elif order == above + 1:
        highest = upper
    pieces = rise_pieces(boxes)
    for piece in range(1, pieces + 2):
        # the last piece is the hold
        length = nodes[i, Node.HOLD]
        if piece <= pieces:
            length = 0.0
            if ramp > 0.0:
                held, direction = held_level(piece, boxes)
                basis = ramp * passing[Passing.PACE]
                length, peak = piece_peak(held, above, change, ramp, basis, axis)
                if held == 0:
                    slope, curvature, third = direction * peak, 0.0, 0.0
                elif held == 1:
                    curvature, third = direction * peak, 0.0
                else:
                    third = direction * peak
        else:
            level, slope, curvature, third = sign * nodes[i, Node.LEVEL], 0.0, 0.0, 0.0
        if length > 0.0:
            at = highest_in_piece(length, lowest, lower, upper, level, slope, curvature, third)
            if order == above:
                at = highest_in_piece(length, lower, upper, level, slope, curvature, third, 0.0)
            elif order == above + 1:
                at = highest_in_piece(length, upper, level, slope, curvature, third, 0.0, 0.0)
            highest = max(highest, at)
            lowest = lowest + taylor(length, lower, upper, level, slope, curvature)
            lowest = lowest + power_term(length, third)
            lower = lower + taylor(length, upper, level, slope, curvature, third)
            upper = upper + taylor(length, level, slope, curvature, third, 0.0)
            level = level + taylor(length, slope, curvature, third, 0.0, 0.0)
            slope = slope + taylor(length, curvature, third, 0.0, 0.0, 0.0)
            curvature = curvature + length * third
    return highest


def instant_error(peak: int, passing: 'float[:]', axis: 'float[:]', nodes: 'float[:,:]') -> float:
    """By how much the derivative of an instant exceeds its limit at the nodes around it."""
    order = int(passing[Passing.INSTANT_ORDER + peak])
    first = max(int(passing[Passing.INSTANT_FROM + peak]), 0)
    last = int(passing[Passing.INSTANT_TO + peak])
    highest = -NEVER
    for i in range(int(passing[Passing.COUNT]) + 1):
        if i >= first and i <= last:
            sign = passing[Passing.INSTANT_SIGN + peak]
            highest = max(highest, highest_at_node(order, sign, i, passing, axis, nodes))
    return highest - side_limit(order, passing[Passing.INSTANT_SIGN + peak], axis)


def shift_instants(place: int, by: int, passing: 'float[:]') -> None:
    """Keep the instants where they are as nodes from `place` on move."""
    for peak in range(int(passing[Passing.INSTANTS])):
        if passing[Passing.INSTANT_FROM + peak] >= place:
            passing[Passing.INSTANT_FROM + peak] = passing[Passing.INSTANT_FROM + peak] + by
        if passing[Passing.INSTANT_TO + peak] >= place:
            passing[Passing.INSTANT_TO + peak] = passing[Passing.INSTANT_TO + peak] + by


def place_instant(peak: int, order: int, sign: float, node: int, passing: 'float[:]') -> None:
    """Let the derivative of an instant be that which reaches its limit near a node."""
    passing[Passing.INSTANT_ORDER + peak] = order
    passing[Passing.INSTANT_SIGN + peak] = sign
    passing[Passing.INSTANT_FROM + peak] = node - 1
    passing[Passing.INSTANT_TO + peak] = node + 1


def add_instant(order: int, sign: float, node: int, passing: 'float[:]') -> None:
    """Add the condition that a derivative reaches its limit near a node."""
    peak = int(passing[Passing.INSTANTS])
    place_instant(peak, order, sign, node, passing)
    passing[Passing.INSTANTS] = peak + 1
