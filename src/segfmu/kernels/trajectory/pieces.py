"""Phases -> polynomial pieces.

A phase (Phase) is a hold or a ramp of (11a-d). Its integrals (15a-g, errata E4) become polynomial
pieces of the position: one for a hold or a smoothstep ramp, up to three (jerk rises, stays, falls)
for a plateau ramp; each rise has three if the snap has a plateau too.
"""

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
    """Complete the piece in `row`: add position to jerk from `state`, and advance `state`.

    state (PieceState) is that at the start of the piece. Returns row + 1.
    """
    width = coefficients.shape[1]
    coefficients[row, Piece.POSITION] = state[PieceState.POSITION]
    coefficients[row, Piece.VELOCITY] = state[PieceState.VELOCITY]
    coefficients[row, Piece.ACCELERATION] = 0.5 * state[PieceState.ACCELERATION]
    jerk = coefficients[row, Piece.JERK] + state[PieceState.JERK] / 6.0
    coefficients[row, Piece.JERK] = jerk
    timing[row, Timing.START] = state[PieceState.TIME]
    timing[row, Timing.LENGTH] = duration
    y = 0.0
    v = 0.0
    for j in range(width):
        i = width - 1 - j
        y = y * duration + coefficients[row, i]
        if i > 0:
            v = v * duration + i * coefficients[row, i]
    state[PieceState.POSITION] = y
    state[PieceState.VELOCITY] = v
    state[PieceState.ACCELERATION] = evaluate_piece(coefficients, row, width, duration, 2)
    state[PieceState.JERK] = evaluate_piece(coefficients, row, width, duration, 3)
    state[PieceState.TIME] = state[PieceState.TIME] + duration
    return row + 1


def clear_piece(coefficients: 'float[:,:]', row: int) -> None:
    """Set every coefficient of a piece to zero."""
    for i in range(coefficients.shape[1]):
        coefficients[row, i] = 0.0


def add_rise(
    jerk: float, rise: float, order: int, psi: 'float[:]', coefficients: 'float[:,:]', row: int
) -> None:
    """Add to a piece the triple integral of jerk * Psi(t, rise) with Psi of the given order."""
    for i in range(order + 1, 2 * order + 2):
        scale = jerk * psi[i] / ((i + 1.0) * (i + 2.0) * (i + 3.0))
        coefficient = coefficients[row, Piece.JERK + i] + scale / rise**i
        coefficients[row, Piece.JERK + i] = coefficient


def add_snap(
    snap: float, rise: float, order: int, psi: 'float[:]', coefficients: 'float[:,:]', row: int
) -> None:
    """Add to a piece the fourfold integral of snap * Psi(t, rise) with Psi of the given order."""
    for i in range(order + 1, 2 * order + 2):
        scale = snap * psi[i] / ((i + 1.0) * (i + 2.0) * (i + 3.0) * (i + 4.0))
        coefficient = coefficients[row, Piece.SNAP + i] + scale / rise**i
        coefficients[row, Piece.SNAP + i] = coefficient


def ramp_order(axis: 'float[:]') -> int:
    """Order of the transition polynomial in the curved part of the ramps of an axis."""
    order = int(axis[Axis.SMOOTHNESS]) - 2
    if axis[Axis.PLATEAU] > 0.5:
        order = order - 1
        if axis[Axis.SNAP_SHARE] > 0.0:
            order = order - 1
    return order


def expand_jerk_change(
    jerk: float,
    rise: float,
    axis: 'float[:]',
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
    row: int,
    work: 'float[:,:]',
) -> int:
    """Pieces in which the jerk changes by `jerk` within `rise` [s]; returns the row after them."""
    order = ramp_order(axis)
    share = axis[Axis.SNAP_SHARE]
    psi = work[Expansion.PSI, :]
    state = work[Expansion.STATE, :]
    clear_piece(coefficients, row)
    if share <= 0.0:
        add_rise(jerk, rise, order, psi, coefficients, row)
        return append_piece(rise, timing, coefficients, row, state)
    snap = jerk / (rise * (1.0 - share))
    edge = share * rise
    add_snap(snap, edge, order, psi, coefficients, row)
    row = append_piece(edge, timing, coefficients, row, state)
    clear_piece(coefficients, row)
    coefficients[row, Piece.SNAP] = snap / 24.0
    row = append_piece(rise - 2.0 * edge, timing, coefficients, row, state)
    clear_piece(coefficients, row)
    coefficients[row, Piece.SNAP] = snap / 24.0
    add_snap(-snap, edge, order, psi, coefficients, row)
    return append_piece(edge, timing, coefficients, row, state)


def expand_plateau(
    phase: 'float[:]',
    axis: 'float[:]',
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
    row: int,
    work: 'float[:,:]',
) -> int:
    """Pieces of a ramp whose jerk has a plateau; returns the row after them."""
    state = work[Expansion.STATE, :]
    duration = phase[Phase.DURATION]
    rise = phase[Phase.RISE]
    a = phase[Phase.ACCELERATION]
    change = phase[Phase.CHANGE]
    jerk = change / (duration - rise)
    flat = duration - 2.0 * rise
    row = expand_jerk_change(jerk, rise, axis, timing, coefficients, row, work)
    state[PieceState.ACCELERATION] = a + 0.5 * jerk * rise
    state[PieceState.JERK] = jerk
    if flat > 0.0:
        clear_piece(coefficients, row)
        row = append_piece(flat, timing, coefficients, row, state)
        state[PieceState.ACCELERATION] = a + change - 0.5 * jerk * rise
        state[PieceState.JERK] = jerk
    return expand_jerk_change(-jerk, rise, axis, timing, coefficients, row, work)


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

    The row STATE of `work` (Expansion) holds position, velocity and time at the start, and is
    advanced to the end.
    """
    psi = work[Expansion.PSI, :]
    state = work[Expansion.STATE, :]
    order = ramp_order(axis)
    plateau = axis[Axis.PLATEAU] > 0.5
    transition_coefficients(order, psi)
    for i in range(count):
        a = phases[i, Phase.ACCELERATION]
        change = phases[i, Phase.CHANGE]
        state[PieceState.ACCELERATION] = a
        state[PieceState.JERK] = 0.0
        if plateau and change != 0.0:
            row = expand_plateau(phases[i, :], axis, timing, coefficients, row, work)
        else:
            duration = phases[i, Phase.DURATION]
            clear_piece(coefficients, row)
            if change != 0.0:
                for j in range(order + 1, 2 * order + 2):
                    scale = change * psi[j] / ((j + 1.0) * (j + 2.0))
                    coefficients[row, Piece.ACCELERATION + j] = scale / duration**j
            row = append_piece(duration, timing, coefficients, row, state)
        state[PieceState.ACCELERATION] = a + change
        state[PieceState.JERK] = 0.0
    return row
