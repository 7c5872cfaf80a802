"""One attempt to bring a derivative inside: it is turned round, held, and let go.

Seen from the derivative, the next one is its velocity: that goes to a level, is held there, and
goes back to zero. Let go so, the derivative stays inside its limits. Where it comes inside, the
attempt is cut (brake.py); the rest of it shows that there is a way on.
"""

from segfmu.kernels.numerics.bounds import polynomial_hull
from segfmu.kernels.numerics.numbers import EXCEEDED, FINE, HALVINGS, NEARLY, NEVER, SAME
from segfmu.kernels.numerics.polynomials import polynomial_differentiate, polynomial_shift
from segfmu.kernels.planner.records import Axis
from segfmu.kernels.settling.records import Chain, LeadRows, LeadTask, LeadWork
from segfmu.kernels.settling.stages import settle
from segfmu.kernels.trajectory.check import within
from segfmu.kernels.trajectory.evaluate import evaluate_piece
from segfmu.kernels.trajectory.pieces import clear_piece
from segfmu.kernels.trajectory.records import Brake, Check, Timing


def outside_by(value: float, order: int, lead: 'float[:,:]') -> float:
    """How far a value of a derivative is beyond its limits; at most 0 inside, up to rounding."""
    low = lead[LeadWork.LOWEST, order]
    high = lead[LeadWork.HIGHEST, order]
    return max(value - high, low - value) - SAME * (high - low)


def hold_highest(
    value: float, length: float, row: int, lead: 'float[:,:]', timing: 'float[:,:]',
    coefficients: 'float[:,:]',
) -> int:
    """Append the piece in which the derivative n + 1 has a value; the row after it, -1: no room.

    The row STATE of `lead` (LeadWork) goes on to its end.
    """
    state = lead[LeadWork.STATE, :]
    smoothness = int(lead[LeadWork.AXIS, Axis.SMOOTHNESS])
    if row < 0 or row >= 2 * LeadRows.PIECES:
        return -1
    if length <= 0.0:
        return row
    clear_piece(coefficients, row)
    factorial = 1.0
    for i in range(smoothness + 1):
        if i > 0:
            factorial = factorial * i
        coefficients[row, i] = state[i] / factorial
    coefficients[row, smoothness + 1] = value / (factorial * (smoothness + 1))
    timing[row, Timing.START] = state[Chain.TIME]
    timing[row, Timing.LENGTH] = length
    for i in range(smoothness + 1):
        state[i] = evaluate_piece(coefficients, row, coefficients.shape[1], length, i)
    state[Chain.TIME] = state[Chain.TIME] + length
    return row + 1


def lead_to(
    order: int, end: float, row: int, lead: 'float[:,:]', timing: 'float[:,:]',
    coefficients: 'float[:,:]',
) -> int:
    """Append pieces that lead a derivative to a value and those above to zero.

    They begin in the row STATE of `lead` (LeadWork), which goes on to their end. Returns the row
    after them, -1: there are none.
    """
    state = lead[LeadWork.STATE, :]
    if row < 0:
        return -1
    if order == int(lead[LeadWork.AXIS, Axis.SMOOTHNESS]):
        top = lead[LeadWork.HIGHEST, order + 1]
        if end < state[order]:
            top = lead[LeadWork.LOWEST, order + 1]
        length = (end - state[order]) / top
        row = hold_highest(top, length, row, lead, timing, coefficients)
        state[order] = end
        return row
    lead[LeadWork.START, :] = state
    lead[LeadWork.ENDS, :] = NEVER
    lead[LeadWork.ENDS, order] = end
    return settle(order, row, lead, timing, coefficients)


def part_hull(
    order: int, row: int, start: float, length: float, lead: 'float[:,:]',
    coefficients: 'float[:,:]',
) -> int:
    """Bernstein coefficients of a derivative on a part of a piece, from a local time on.

    They are in the row HULLS of the check in `lead`; returns their number.
    """
    check = lead[LeadWork.CHECK:LeadWork.SIZE, :]
    width = coefficients.shape[1]
    while width > order + 1 and coefficients[row, width - 1] == 0.0:
        width = width - 1
    hull = check[Check.HULLS, :]
    polynomial_differentiate(coefficients[row, :], width, order, hull)
    if start > 0.0:
        polynomial_shift(hull, start, width - order)
    polynomial_hull(hull, width - order, length)
    return width - order


def is_hull_inside(count: int, low: float, high: float, lead: 'float[:,:]') -> bool:
    """Whether the Bernstein coefficients in the row HULLS of the check are in a range."""
    check = lead[LeadWork.CHECK:LeadWork.SIZE, :]
    for i in range(count):
        if not low <= check[Check.HULLS, i] <= high:
            return False
    return True


def stays_inside(
    order: int, first: int, last: int, lead: 'float[:,:]', timing: 'float[:,:]',
    coefficients: 'float[:,:]',
) -> bool:
    """Whether a derivative stays inside its limits in the pieces first .. last - 1, nearly."""
    check = lead[LeadWork.CHECK:LeadWork.SIZE, :]
    low = lead[LeadWork.LOWEST, order]
    high = lead[LeadWork.HIGHEST, order]
    # of the range, as an attempt is checked once more
    slack = EXCEEDED * (high - low)
    for row in range(first, last):
        count = part_hull(order, row, 0.0, timing[row, Timing.LENGTH], lead, coefficients)
        if not is_hull_inside(count, low, high, lead):
            if not within(check, count, low - slack, high + slack):
                return False
    return True


def inside_from(
    order: int, first: int, last: int, lead: 'float[:,:]', timing: 'float[:,:]',
    coefficients: 'float[:,:]',
) -> 'tuple[int, float]':
    """The piece and its local time [s] from which on a derivative is inside its limits."""
    width = coefficients.shape[1]
    low = lead[LeadWork.LOWEST, order]
    high = lead[LeadWork.HIGHEST, order]
    slack = SAME * (high - low)
    for i in range(last - first):
        row = last - 1 - i
        length = timing[row, Timing.LENGTH]
        upper = length
        step = length
        while upper > 0.0:
            lower = max(upper - step, 0.0)
            count = part_hull(order, row, lower, upper - lower, lead, coefficients)
            if is_hull_inside(count, low - slack, high + slack, lead):
                upper = lower
                step = 2.0 * step
                continue
            value = evaluate_piece(coefficients, row, width, lower, order)
            if outside_by(value, order, lead) > 0.0:
                # where it is monotonic it comes inside once
                count = part_hull(order + 1, row, lower, upper - lower, lead, coefficients)
                if (
                    is_hull_inside(count, 0.0, NEVER, lead)
                    or is_hull_inside(count, -NEVER, 0.0, lead)
                    or step <= FINE * length
                ):
                    return row, time_crossed(order, row, lower, upper, lead, coefficients)
            if step > NEARLY * length:
                step = 0.25 * step
            else:
                upper = lower
    return first, 0.0


def time_crossed(
    order: int, row: int, lower: float, upper: float, lead: 'float[:,:]', coefficients: 'float[:,:]'
) -> float:
    """Local time of a piece [s] at which a derivative comes inside, between two times."""
    values = lead[LeadWork.CHECK + Check.VALUES, :]
    count = coefficients.shape[1] - order
    polynomial_differentiate(coefficients[row, :], coefficients.shape[1], order, values)
    while count > 1 and values[count - 1] == 0.0:
        count = count - 1
    near = 0.0
    if lead[LeadWork.TASK, LeadTask.COARSE] > 0.5:
        near = EXCEEDED * (upper + lead[LeadWork.BRAKED, Chain.TIME])
    for k in range(HALVINGS):
        middle = 0.5 * (lower + upper)
        if middle == lower or middle == upper or upper - lower < near:
            break
        value = 0.0
        for i in range(count):
            value = value * middle + values[count - 1 - i]
        if outside_by(value, order, lead) > 0.0:
            lower = middle
        else:
            upper = middle
    return upper


def turn_round(
    order: int, side: float, level: float, settled: bool, lead: 'float[:,:]', timing: 'float[:,:]',
    coefficients: 'float[:,:]',
) -> 'tuple[int, int, float]':
    """The derivative above one goes to a level, as in `try_brake`, and is let go at once.

    Returns the row after the pieces to the level, the one after all (-1: there are none), and how
    far the derivative then is from its other limit, below 0: beyond. The row TURN of `lead` becomes
    the state at the level.
    """
    state, turn = lead[LeadWork.STATE, :], lead[LeadWork.TURN, :]
    row = int(LeadRows.PIECES)
    state[:] = lead[LeadWork.BRAKED, :]
    if settled and order + 2 <= int(lead[LeadWork.AXIS, Axis.SMOOTHNESS]):
        row = lead_to(order + 2, 0.0, row, lead, timing, coefficients)
    row = lead_to(order + 1, level, row, lead, timing, coefficients)
    turn[:] = state
    last = lead_to(order + 1, 0.0, row, lead, timing, coefficients)
    far = lead[LeadWork.HIGHEST, order] if side < 0.0 else lead[LeadWork.LOWEST, order]
    return row, last, side * (state[order] - far)


def try_brake(
    order: int, side: float, level: float, settled: bool, lead: 'float[:,:]', timing: 'float[:,:]',
    coefficients: 'float[:,:]',
) -> float:
    """Time [s] at which a derivative comes inside its limits for good; NEVER: it does not.

    It is beyond its upper limit (side 1) or its lower one (-1), now or later. The one above goes to
    a level; settled: those above that one have gone to zero before. -1: at this level the
    derivative ends beyond its other limit.

    The pieces are in the rows from LeadRows.PIECES to Brake.LAST.
    """
    state, turn = lead[LeadWork.STATE, :], lead[LeadWork.TURN, :]
    smoothness = int(lead[LeadWork.AXIS, Axis.SMOOTHNESS])
    first = int(LeadRows.PIECES)
    row, last, room = turn_round(order, side, level, settled, lead, timing, coefficients)
    if last < 0:
        return NEVER
    if room < 0.0:
        return -1.0
    if level != 0.0:
        # held until the derivative is inside, unless it has to be let go before
        near = lead[LeadWork.LOWEST, order] if side < 0.0 else lead[LeadWork.HIGHEST, order]
        hold = min(side * (turn[order] - near), room) / abs(level)
        state[:] = turn
        row = hold_highest(0.0, hold, row, lead, timing, coefficients)
        last = lead_to(order + 1, 0.0, row, lead, timing, coefficients)
    if last < 0 or outside_by(state[order], order, lead) > 0.0:
        return NEVER
    for i in range(order + 1, smoothness + 2):
        if not stays_inside(i, first, last, lead, timing, coefficients):
            return NEVER
    row, local = inside_from(order, first, last, lead, timing, coefficients)
    if last > first and not stays_inside(order, row + 1, last, lead, timing, coefficients):
        return NEVER
    lead[LeadWork.BRAKE, Brake.LAST] = last
    return lead[LeadWork.BRAKED, Chain.TIME] if last == first else timing[row, Timing.START] + local
