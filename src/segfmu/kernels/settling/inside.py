"""One derivative comes inside its limits, those above it being there already.

To the next derivative it is what a position is to a velocity: that goes as far as a level, is held
there, and would be let go in time (attempt.py).
"""

from segfmu.kernels.numerics.numbers import FINE, HALVINGS, NEVER
from segfmu.kernels.numerics.roots import next_bracket, next_point
from segfmu.kernels.planner.records import Axis
from segfmu.kernels.settling.attempt import (
    lead_to,
    outside_by,
    stays_inside,
    try_brake,
    turn_round,
)
from segfmu.kernels.settling.brake_pieces import append_pieces
from segfmu.kernels.settling.records import Chain, LeadRows, LeadWork
from segfmu.kernels.trajectory.records import Brake


def level_limit(order: int, side: float, lead: 'float[:,:]') -> float:
    """The limit of the derivative above one that is to come back from a side."""
    return lead[LeadWork.HIGHEST, order + 1] if side < 0.0 else lead[LeadWork.LOWEST, order + 1]


def deepest_level(
    order: int, side: float, settled: bool, lead: 'float[:,:]', timing: 'float[:,:]',
    coefficients: 'float[:,:]',
) -> float:
    """The level from which the derivative nearly ends at its other limit, but not beyond; 0: none.

    At the limit of the derivative above it ends beyond.
    """
    edge = level_limit(order, side, lead)
    near = FINE * (lead[LeadWork.HIGHEST, order] - lead[LeadWork.LOWEST, order])
    row, last, e_other = turn_round(order, side, 0.0, settled, lead, timing, coefficients)
    if last < 0 or e_other < 0.0:
        return 0.0
    row, last, e_newest = turn_round(order, side, edge, settled, lead, timing, coefficients)
    newest, other, before = 1.0, 0.0, 0.0
    e_before = e_other
    for i in range(HALVINGS):
        level = next_point(newest, other, before, e_newest, e_other, e_before)
        row, last, room = turn_round(order, side, level * edge, settled, lead, timing, coefficients)
        if last < 0 or 0.0 <= room <= near or abs(newest - other) < FINE:
            break
        newest, other, before, e_newest, e_other, e_before = next_bracket(
            room * e_newest < 0.0, level, room, newest, other, e_newest, e_other
        )
    if room < 0.0:
        level = other
    return level * edge


def best_level(
    order: int, side: float, settled: bool, lead: 'float[:,:]', timing: 'float[:,:]',
    coefficients: 'float[:,:]',
) -> float:
    """The soonest time of `try_brake`, at the deepest level, NEVER if there is none.

    The attempt that tells it is the last one.
    """
    level = level_limit(order, side, lead)
    time = try_brake(order, side, level, settled, lead, timing, coefficients)
    if time < 0.0:
        level = deepest_level(order, side, settled, lead, timing, coefficients)
        time = try_brake(order, side, level, settled, lead, timing, coefficients)
    # a lower one where that does not keep the limits
    for i in range(6):
        if 0.0 <= time < NEVER:
            return time
        level = 0.0 if i == 5 else 0.5 * level
        time = try_brake(order, side, level, settled, lead, timing, coefficients)
    if time < 0.0:
        time = NEVER
    return time


def level_time(
    order: int, side: float, gentle: float, settled: bool, lead: 'float[:,:]', timing: 'float[:,:]',
    coefficients: 'float[:,:]',
) -> float:
    """The time of `try_brake` at a part of the limit, at the best level if gentle is 0."""
    if gentle > 0.0:
        level = (1.0 - gentle) * level_limit(order, side, lead)
        time = try_brake(order, side, level, settled, lead, timing, coefficients)
        if time >= 0.0 and time < NEVER:
            return time
    return best_level(order, side, settled, lead, timing, coefficients)


def side_beyond(
    order: int, lead: 'float[:,:]', timing: 'float[:,:]', coefficients: 'float[:,:]'
) -> float:
    """1 for a derivative that is or gets beyond its upper limit, -1 for the lower one, 0: neither.

    Though the one above it goes to zero at once.
    """
    state, reached = lead[LeadWork.STATE, :], lead[LeadWork.BRAKED, :]
    low = lead[LeadWork.LOWEST, order]
    first = int(LeadRows.PIECES)
    state[:] = reached
    last = lead_to(order + 1, 0.0, first, lead, timing, coefficients)
    for i in range(2):
        value = reached[order] if i == 1 else state[order]
        if outside_by(value, order, lead) > 0.0:
            return 1.0 if value > low else -1.0
    if last >= 0 and stays_inside(order, first, last, lead, timing, coefficients):
        return 0.0
    return 1.0 if reached[order + 1] > 0.0 else -1.0


def bring_highest(lead: 'float[:,:]', timing: 'float[:,:]', coefficients: 'float[:,:]') -> None:
    """Bring the derivative n inside."""
    order = int(lead[LeadWork.AXIS, Axis.SMOOTHNESS])
    value = lead[LeadWork.BRAKED, order]
    end = min(max(value, lead[LeadWork.LOWEST, order]), lead[LeadWork.HIGHEST, order])
    if outside_by(value, order, lead) > 0.0:
        lead[LeadWork.STATE, :] = lead[LeadWork.BRAKED, :]
        last = lead_to(order, end, int(LeadRows.PIECES), lead, timing, coefficients)
        until = lead[LeadWork.STATE, Chain.TIME]
        append_pieces(until, last, lead, timing, coefficients)
        lead[LeadWork.BRAKE, Brake.UNTIL] = until
    lead[LeadWork.BRAKED, order] = end


def bring_gently(
    order: int, lead: 'float[:,:]', timing: 'float[:,:]', coefficients: 'float[:,:]'
) -> bool:
    """Bring a derivative to its limit, those above it to zero; False: that is not possible."""
    first = int(LeadRows.PIECES)
    reached, state = lead[LeadWork.BRAKED, :], lead[LeadWork.STATE, :]
    value = reached[order]
    if not outside_by(value, order, lead) > 0.0:
        return False
    end = min(max(value, lead[LeadWork.LOWEST, order]), lead[LeadWork.HIGHEST, order])
    state[:] = reached
    last = lead_to(order, end, first, lead, timing, coefficients)
    if last < 0:
        return False
    for i in range(order + 1, int(lead[LeadWork.AXIS, Axis.SMOOTHNESS]) + 2):
        if not stays_inside(i, first, last, lead, timing, coefficients):
            return False
    until = state[Chain.TIME]
    append_pieces(until, last, lead, timing, coefficients)
    for i in range(order + 1, int(lead[LeadWork.AXIS, Axis.SMOOTHNESS]) + 1):
        reached[i] = 0.0
    reached[order] = end
    lead[LeadWork.BRAKE, Brake.UNTIL] = until
    lead[LeadWork.INSIDE, order] = until
    return True


def bring_inside(
    order: int, whole: bool, lead: 'float[:,:]', timing: 'float[:,:]', coefficients: 'float[:,:]'
) -> bool:
    """Bring a derivative inside, those above it are; False: no attempt does.

    whole: let it go as well, so that those above end at zero.
    """
    report, reached = lead[LeadWork.BRAKE, :], lead[LeadWork.BRAKED, :]
    gentle = report[Brake.GENTLE + order]
    lead[LeadWork.INSIDE, order] = 0.0
    if gentle == 1.0 and bring_gently(order, lead, timing, coefficients):
        return True
    side = side_beyond(order, lead, timing, coefficients)
    if side == 0.0 and not whole:
        return True
    time, settled = NEVER, False
    for i in range(2):
        if time >= NEVER:
            settled = i == 1
            if side == 0.0:
                time = try_brake(order, 1.0, 0.0, settled, lead, timing, coefficients)
            else:
                time = level_time(order, side, gentle, settled, lead, timing, coefficients)
    if time >= NEVER:
        return False
    # the pieces are those of the last attempt
    start = reached[Chain.TIME]
    if time > start:
        report[Brake.UNTIL] = time
        lead[LeadWork.INSIDE, order] = time
    elif not whole:
        return True
    if whole:
        time = NEVER
    append_pieces(time, int(report[Brake.LAST]), lead, timing, coefficients)
    for i in range(order, reached.shape[0] - 2):
        if i <= int(lead[LeadWork.AXIS, Axis.SMOOTHNESS]):
            if whole and i > order:
                reached[i] = 0.0
            low = lead[LeadWork.LOWEST, i]
            reached[i] = min(max(reached[i], low), lead[LeadWork.HIGHEST, i])
    return True
