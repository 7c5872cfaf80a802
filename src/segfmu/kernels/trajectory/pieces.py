"""Phases -> polynomial pieces.

A phase (Phase) is a hold or a ramp of (11a-d). Its integrals (15a-g, errata E4) become polynomial
pieces of the position: one for a hold or a smoothstep ramp; a plateau ramp has one for each hold of
its derivatives and for each rise between (nested.py).
"""

from segfmu.kernels.planner.nested import held_level, held_peak, rise_pieces
from segfmu.kernels.planner.records import Axis, Phase
from segfmu.kernels.planner.transition import transition_coefficients
from segfmu.kernels.trajectory.evaluate import evaluate_piece
from segfmu.kernels.trajectory.records import Expansion, Piece, PieceState, Timing


def append_piece(
    duration: float,
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
    row: int,
    state: 'float[:]',
) -> int:
    """Complete the piece in `row`: add the derivatives of `state`, and advance `state`.

    state (PieceState) is that at the start of the piece. Returns row + 1.
    """
    width = coefficients.shape[1]
    order = width // 2 + 1
    coefficients[row, 0] = coefficients[row, 0] + state[PieceState.POSITION]
    coefficients[row, 1] = coefficients[row, 1] + state[PieceState.VELOCITY]
    factorial = 1.0
    for i in range(2, order + 1):
        factorial = factorial * i
        if state[i] != 0.0:
            coefficients[row, i] = coefficients[row, i] + state[i] / factorial
    timing[row, Timing.START] = state[PieceState.TIME]
    timing[row, Timing.LENGTH] = duration
    # the powers that there are
    used = width
    while used > 1 and coefficients[row, used - 1] == 0.0:
        used = used - 1
    # one pass for the first four derivatives takes less time than one each
    y = 0.0
    v = 0.0
    a = 0.0
    jerk = 0.0
    for j in range(used):
        i = used - 1 - j
        y = y * duration + coefficients[row, i]
        if i > 0:
            v = v * duration + i * coefficients[row, i]
        if i > 1:
            a = a * duration + i * (i - 1) * coefficients[row, i]
        if i > 2:
            jerk = jerk * duration + i * (i - 1) * (i - 2) * coefficients[row, i]
    state[PieceState.POSITION] = y
    state[PieceState.VELOCITY] = v
    state[PieceState.ACCELERATION] = a
    state[PieceState.JERK] = jerk
    for i in range(4, order):
        state[i] = evaluate_piece(coefficients, row, used, duration, i)
    state[PieceState.TIME] = state[PieceState.TIME] + duration
    return row + 1


def clear_piece(coefficients: 'float[:,:]', row: int) -> None:
    """Set every coefficient of a piece to zero."""
    for i in range(coefficients.shape[1]):
        coefficients[row, i] = 0.0


def set_held(above: int, level: float, state: 'float[:]') -> None:
    """Set the derivative of order 2 + above of a state, and those above it to zero."""
    state[PieceState.ACCELERATION + above] = level
    for i in range(PieceState.JERK + above, PieceState.TIME):
        state[i] = 0.0


def expand_plateau(
    phase: 'float[:]',
    axis: 'float[:]',
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
    row: int,
    work: 'float[:,:]',
) -> int:
    """Pieces of a plateau ramp; returns the row after them."""
    state = work[Expansion.STATE, :]
    lengths = work[Expansion.LENGTHS, :]
    peaks = work[Expansion.PEAKS, :]
    duration = phase[Phase.DURATION]
    basis = phase[Phase.BASIS]
    peak = phase[Phase.CHANGE]
    first = int(phase[Phase.ABOVE])
    boxes = int(axis[Axis.SMOOTHNESS]) - 1 - first
    rise = basis
    for level in range(boxes):
        length, peak, rise = held_peak(level, first, rise, peak, duration / basis, axis)
        lengths[level] = length
        peaks[level] = peak
    count = rise_pieces(boxes)
    for piece in range(1, count + 1):
        level, sign = held_level(piece, boxes)
        held = PieceState.JERK + first + level
        for i in range(held, PieceState.TIME):
            state[i] = 0.0
        state[held] = sign * peaks[level]
        if lengths[level] > 0.0:
            clear_piece(coefficients, row)
            row = append_piece(lengths[level], timing, coefficients, row, state)
    return row


def is_unnoticed(phase: 'float[:]', time: float, axis: 'float[:]') -> bool:
    """Whether a ramp changes the acceleration by a rounding error only, faster than a clock tells.

    Its snap would nevertheless reach the limit, and not come back to zero by that clock.
    time: since the start of the plan [s].
    """
    if phase[Phase.ABOVE] > 0.5 or phase[Phase.DURATION] > 1e-6 * time:
        return False
    return abs(phase[Phase.CHANGE]) <= 1e-13 * axis[Axis.ACCELERATION]


def expand_phases(
    phases: 'float[:,:]',
    count: int,
    axis: 'float[:]',
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
    row: int,
    work: 'float[:,:]',
) -> int:
    """Expand `count` phases into pieces from `row` on; returns the row after the last one.

    The row STATE of `work` (Expansion) holds position, velocity, acceleration and time at the
    start, and is advanced to the end.
    """
    psi = work[Expansion.PSI, :]
    state = work[Expansion.STATE, :]
    order = int(axis[Axis.SMOOTHNESS]) - 2
    plateau = axis[Axis.PLATEAU] > 0.5
    if not plateau:
        transition_coefficients(order, psi)
    for i in range(count):
        a = phases[i, Phase.ACCELERATION]
        change = phases[i, Phase.CHANGE]
        above = int(phases[i, Phase.ABOVE])
        set_held(above, a, state)
        ramp = change != 0.0 and not is_unnoticed(phases[i, :], state[PieceState.TIME], axis)
        if plateau and ramp:
            row = expand_plateau(phases[i, :], axis, timing, coefficients, row, work)
        else:
            duration = phases[i, Phase.DURATION]
            clear_piece(coefficients, row)
            if ramp:
                for j in range(order + 1, 2 * order + 2):
                    scale = change * psi[j] / ((j + 1.0) * (j + 2.0))
                    coefficients[row, Piece.ACCELERATION + j] = scale / duration**j
            row = append_piece(duration, timing, coefficients, row, state)
        set_held(above, a + change, state)
    return row
