"""Phases of a whole plan -> the polynomial pieces of every axis.

If two profiles are averaged, their pieces are cut at the switching times of both and added with
their weights.
"""

from segfmu.kernels.numerics.numbers import LAST_DIGIT
from segfmu.kernels.planner.nested import ramp_pieces
from segfmu.kernels.planner.records import (
    Cell,
    Interval,
    Phase,
    Place,
    Problem,
    WaypointState,
)
from segfmu.kernels.trajectory.evaluate import evaluate_piece
from segfmu.kernels.trajectory.pieces import clear_piece, expand_phases
from segfmu.kernels.trajectory.records import Expansion, Piece, PieceState, Spare, Timing


def count_pieces(axes: 'float[:,:]', cells: 'float[:,:,:]') -> int:
    """Rows that `expand_plan` needs: pieces of each phase, one per dwell, and the spare ones."""
    total = Spare.ROWS + axes.shape[0] + cells.shape[0]
    each = ramp_pieces(axes[0, :])
    for i in range(cells.shape[0]):
        for j in range(int(cells[i, Cell.RESULT, Interval.BELOW_COUNT])):
            total = total + (1 if cells[i, Cell.BELOW + j, Phase.CHANGE] == 0.0 else each)
        total = total + each * int(cells[i, Cell.RESULT, Interval.ABOVE_COUNT])
    return total


def shift_piece(
    coefficients: 'float[:,:]', source: int, t: float, weight: float, target: int
) -> None:
    """Add weight times the piece in row `source`, from its local time t on, to row `target`."""
    width = coefficients.shape[1]
    factorial = 1.0
    for i in range(width):
        if i > 0:
            factorial = factorial * i
        value = evaluate_piece(coefficients, source, width, t, i) / factorial
        coefficients[target, i] = coefficients[target, i] + weight * value


def merge_pieces(
    weight: float,
    now: float,
    middle: int,
    last: int,
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
    row: int,
) -> int:
    """Average the pieces in the spare rows, from the time `now` [s]; returns the row after them.

    The result is (1 - weight) * pieces before the row `middle` + weight * pieces from there to
    `last`.
    """
    a = timing.shape[0] - Spare.ROWS
    b = middle
    total = 0.0
    for i in range(a, middle):
        total = total + timing[i, Timing.LENGTH]
    # what only the rounding of all lengths tells apart is one switching time: so much of a piece of
    # nanoseconds is a jump of its highest derivative
    same = LAST_DIGIT * (last - a) * total
    t = now
    t_a = 0.0
    t_b = 0.0
    while a < middle and b < last:
        clear_piece(coefficients, row)
        shift_piece(coefficients, a, t_a, 1.0 - weight, row)
        shift_piece(coefficients, b, t_b, weight, row)
        rest_a = timing[a, Timing.LENGTH] - t_a
        rest_b = timing[b, Timing.LENGTH] - t_b
        step = min(rest_a, rest_b)
        if abs(rest_a - rest_b) <= same:
            step = rest_a
            if timing[b, Timing.LENGTH] < timing[a, Timing.LENGTH]:
                step = rest_b
        timing[row, Timing.START] = t
        timing[row, Timing.LENGTH] = step
        t = t + step
        t_a = t_a + step
        t_b = t_b + step
        row = row + 1
        if rest_a <= step + same:
            a = a + 1
            t_a = 0.0
        if rest_b <= step + same:
            b = b + 1
            t_b = 0.0
    return row


def begin_state(cell: 'float[:,:]', work: 'float[:,:]') -> None:
    """Write the state at the start of a cell to the row STATE."""
    state = work[Expansion.STATE, :]
    for i in range(PieceState.SIZE):
        state[i] = 0.0
    state[PieceState.POSITION] = cell[Cell.PLACE, Place.POSITION]
    state[PieceState.VELOCITY] = cell[Cell.PROBLEM, Problem.V]
    state[PieceState.ACCELERATION] = cell[Cell.PROBLEM, Problem.A]
    state[PieceState.TIME] = cell[Cell.PLACE, Place.START]


def expand_profile(
    cell: 'float[:,:]',
    second: bool,
    axis: 'float[:]',
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
    row: int,
    work: 'float[:,:]',
) -> int:
    """Expand the first or the second profile of a cell; returns the row after its last piece."""
    begin_state(cell, work)
    if second:
        count = int(cell[Cell.RESULT, Interval.ABOVE_COUNT])
        return expand_phases(
            cell[Cell.ABOVE:Cell.PROBLEM, :], count, axis, timing, coefficients, row, work
        )
    count = int(cell[Cell.RESULT, Interval.BELOW_COUNT])
    return expand_phases(
        cell[Cell.BELOW:Cell.PROBLEM, :], count, axis, timing, coefficients, row, work
    )


def expand_cell(
    cell: 'float[:,:]',
    axis: 'float[:]',
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
    row: int,
    work: 'float[:,:]',
) -> int:
    """Expand one interval of one axis from `row` on; returns the row after its last piece."""
    weight = cell[Cell.RESULT, Interval.WEIGHT]
    if weight <= 0.0 or weight >= 1.0:
        return expand_profile(cell, weight >= 1.0, axis, timing, coefficients, row, work)
    spare = timing.shape[0] - Spare.ROWS
    middle = expand_profile(cell, False, axis, timing, coefficients, spare, work)
    last = expand_profile(cell, True, axis, timing, coefficients, middle, work)
    now = cell[Cell.PLACE, Place.START]
    return merge_pieces(weight, now, middle, last, timing, coefficients, row)


def expand_plan(
    states: 'float[:,:,:]',
    dwells: 'float[:]',
    axes: 'float[:,:]',
    cells: 'float[:,:,:]',
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
    offsets: 'int[:]',
    times: 'float[:,:]',
    work: 'float[:,:]',
) -> int:
    """Expand a plan into the pieces of every axis; returns the number of pieces.

    The first four arrays are those of `plan_phases`. Written: timing (.., Timing) and coefficients
    (.., 2 smoothness), which hold at least count_pieces rows; offsets (axes + 1,), the first piece
    of each axis; times (waypoints + 1, axes), the arrival of each axis at each waypoint and, in the
    last row, the end of its motion [s]. work (Expansion rows, Expansion columns).
    """
    points = states.shape[0]
    count = axes.shape[0]
    row = 0
    for axis in range(count):
        offsets[axis] = row
        now = 0.0
        for j in range(points):
            times[j, axis] = now
            if dwells[j] > 0.0 or (j == points - 1 and row == offsets[axis]):
                clear_piece(coefficients, row)
                # an axis that has nothing to do may move all the same
                a = states[j, axis, WaypointState.ACCELERATION]
                coefficients[row, Piece.POSITION] = states[j, axis, WaypointState.POSITION]
                coefficients[row, Piece.VELOCITY] = states[j, axis, WaypointState.VELOCITY]
                coefficients[row, Piece.ACCELERATION] = 0.5 * a
                timing[row, Timing.START] = now
                timing[row, Timing.LENGTH] = dwells[j]
                now = now + dwells[j]
                row = row + 1
            if j < points - 1:
                cell = cells[j * count + axis, :, :]
                cell[Cell.PLACE, Place.POSITION] = states[j, axis, WaypointState.POSITION]
                cell[Cell.PLACE, Place.START] = now + cell[Cell.PLACE, Place.DELAY]
                row = expand_cell(cell, axes[axis, :], timing, coefficients, row, work)
                now = now + cell[Cell.RESULT, Interval.DURATION]
        times[points, axis] = now
    offsets[count] = row
    return row
