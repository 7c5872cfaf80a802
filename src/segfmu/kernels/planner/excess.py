"""By how much a sequence (sequence.py) exceeds the limits below the derivative that has levels.

Each polynomial piece is cut where a derivative is zero, from that of the levels downwards: between
the cuts the next lower one rises or falls, so its extremes are at cuts.
"""

from segfmu.kernels.numerics.numbers import EXCEEDED, HALF_DIGITS, HALVINGS, TIE
from segfmu.kernels.planner.nested import held_level, piece_peak, rise_pieces
from segfmu.kernels.planner.records import Axis, Excess, Node, Passing, PlanWork
from segfmu.kernels.planner.sides import side_limit


def taylor_value(order: int, top: int, t: float, state: 'float[:]') -> float:
    """A derivative of a polynomial at t, from those at 0 up to the order `top`."""
    value = state[order]
    power = 1.0
    for i in range(order + 1, top + 1):
        power = power * (t / (i - order))
        value = value + power * state[i]
    return value


def zero_time(order: int, top: int, length: float, state: 'float[:]') -> float:
    """Where within a piece a derivative that changes its sign is zero.

    The accuracy suffices for an extremum, whose error is of second order.
    """
    lower = 0.0
    upper = length
    t = 0.5 * length
    for i in range(HALVINGS):
        value = taylor_value(order, top, t, state)
        if value * state[order] > 0.0:
            lower = t
        else:
            upper = t
        step = 0.5 * (lower + upper) - t
        slope = taylor_value(order + 1, top, t, state)
        if slope != 0.0:
            newton = -value / slope
            if t + newton >= lower and t + newton <= upper:
                step = newton
        t = t + step
        if abs(step) <= HALF_DIGITS * length:
            break
    return t


def advance_piece(top: int, length: float, state: 'float[:]', end: 'float[:]') -> None:
    """Derivatives of a polynomial at the end of a piece, up to the order `top`."""
    for order in range(top + 1):
        end[order] = state[order]
    power = 1.0
    for j in range(1, top + 1):
        power = power * (length / j)
        for order in range(top + 1 - j):
            end[order] = end[order] + power * state[order + j]


def note_excess(
    q: int, node: int, holding: bool, axis: 'float[:]', end: 'float[:]', excess: 'float[:,:]'
) -> None:
    """Note what the derivatives below q exceed their limits by (Excess)."""
    for order in range(1, q):
        limit = side_limit(order, end[order], axis)
        if limit > 0.0:
            share = abs(end[order]) / limit - 1.0
            # the first of peaks that only rounding separates, as in a symmetric motion
            if share > EXCEEDED and share > TIE * excess[order, Excess.SHARE]:
                excess[order, Excess.SHARE] = share
                excess[order, Excess.NODE] = node
                excess[order, Excess.HOLDING] = holding
                excess[order, Excess.SIGN] = -1.0 if end[order] < 0.0 else 1.0


def piece_excess(
    length: float, node: int, holding: bool, axis: 'float[:]', work: 'float[:,:]'
) -> None:
    """Note what a piece exceeds; the state in the first row MATRIX of `work` goes on to its end."""
    state, end = work[PlanWork.MATRIX, :], work[PlanWork.MATRIX + 1, :]
    excess = work[PlanWork.EXCESS:PlanWork.RESIDUAL, :]
    q = int(work[PlanWork.PASSING, Passing.ABOVE]) + 2
    # the derivative that is constant in each piece
    top = int(axis[Axis.SMOOTHNESS]) + 1
    rest = length
    # each derivative has one zero at most between those of the ones above
    for i in range(HALVINGS):
        step = rest
        advance_piece(top, step, state, end)
        for j in range(q - 1):
            order = q - j
            if state[order] * end[order] < 0.0:
                step = zero_time(order, top, step, state)
                advance_piece(top, step, state, end)
                end[order] = 0.0
        note_excess(q, node, holding, axis, end, excess)
        for order in range(top + 1):
            state[order] = end[order]
        rest = rest - step
        if rest <= 0.0:
            break


def measure_excess(axis: 'float[:]', work: 'float[:,:]') -> bool:
    """Write by how much the sequence in `work` (PlanWork) exceeds limits; whether it does."""
    passing, excess = work[PlanWork.PASSING, :], work[PlanWork.EXCESS:PlanWork.RESIDUAL, :]
    state = work[PlanWork.MATRIX, :]
    above = int(passing[Passing.ABOVE])
    q = above + 2
    boxes = int(axis[Axis.SMOOTHNESS]) - 1 - above
    level = passing[Passing.START]
    pieces = rise_pieces(boxes)
    for order in range(4):
        excess[order, Excess.SHARE] = 0.0
    for i in range(int(passing[Passing.COUNT]) + 1):
        row = PlanWork.NODES + i
        for order in range(8):
            state[order] = work[row, Node.STATE + order] if order < q else 0.0
        state[q] = level
        ramp = work[row, Node.RAMP]
        change = work[row, Node.LEVEL] - level
        if ramp > 0.0:
            for piece in range(1, pieces + 1):
                held, sign = held_level(piece, boxes)
                basis = ramp * passing[Passing.PACE]
                length, peak = piece_peak(held, above, change, ramp, basis, axis)
                for order in range(q + 1 + held, 8):
                    state[order] = 0.0
                state[q + 1 + held] = sign * peak
                if length > 0.0:
                    piece_excess(length, i, False, axis, work)
        level = work[row, Node.LEVEL]
        if work[row, Node.HOLD] > 0.0:
            for order in range(q, 8):
                state[order] = 0.0
            state[q] = level
            piece_excess(work[row, Node.HOLD], i, True, axis, work)
    for order in range(1, q):
        if excess[order, Excess.SHARE] > 0.0:
            return True
    return False
