"""Phases of a whole plan -> the polynomial pieces of every axis.

The indices are those of intervals.py; where two profiles are averaged, their pieces are cut at
the switching times of both and added with their weights.
"""

from segfmu.kernels.trajectory.evaluate import evaluate_piece, expand_phases


def count_pieces(counts: 'int[:]', cells: int) -> int:
    """An upper bound of the number of pieces: seven a phase, and one a dwell."""
    total = cells + 1
    for i in range(2 * cells):
        total = total + 7 * counts[i]
    return total


def shift_piece(
    coefficients: 'float[:,:]',
    source: int,
    width: int,
    t: float,
    weight: float,
    target: 'float[:,:]',
    row: int,
) -> None:
    """Add weight times a piece, taken from its local time t on, to another piece."""
    factorial = 1.0
    for i in range(width):
        if i > 0:
            factorial = factorial * i
        value = evaluate_piece(coefficients, source, width, t, i) / factorial
        target[row, i] = target[row, i] + weight * value


def merge_pieces(
    weight: float,
    now: float,
    first_a: int,
    last_a: int,
    last_b: int,
    scratch_timing: 'float[:,:]',
    scratch: 'float[:,:]',
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
    row: int,
) -> int:
    """(1 - weight) * pieces first_a .. last_a - 1 + weight * pieces last_a .. last_b - 1."""
    width = coefficients.shape[1]
    a = first_a
    b = last_a
    t = now
    t_a = 0.0
    t_b = 0.0
    while a < last_a and b < last_b:
        for i in range(width):
            coefficients[row, i] = 0.0
        shift_piece(scratch, a, width, t_a, 1.0 - weight, coefficients, row)
        shift_piece(scratch, b, width, t_b, weight, coefficients, row)
        rest_a = scratch_timing[a, 1] - t_a
        rest_b = scratch_timing[b, 1] - t_b
        step = min(rest_a, rest_b)
        timing[row, 0] = t
        timing[row, 1] = step
        t = t + step
        t_a = t_a + step
        t_b = t_b + step
        row = row + 1
        if rest_a <= step:
            a = a + 1
            t_a = 0.0
        if rest_b <= step:
            b = b + 1
            t_b = 0.0
    return row


def expand_plan(
    positions: 'float[:,:]',
    velocities: 'float[:,:]',
    dwells: 'float[:]',
    smoothness: int,
    shape: int,
    phases: 'float[:,:,:]',
    counts: 'int[:]',
    weights: 'float[:]',
    durations: 'float[:,:]',
    ramps: 'float[:,:]',
    scratch_timing: 'float[:,:]',
    scratch: 'float[:,:]',
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
    offsets: 'int[:]',
    times: 'float[:,:]',
) -> int:
    """Expand a plan into the pieces of every axis; returns the number of pieces.

    times[j, axis] becomes the arrival at waypoint j; offsets (axes + 1,); timing and
    coefficients (.., 2 smoothness) hold at least count_pieces rows, the scratch arrays (200,) and
    (200, 16), of which the last two rows serve as work space.
    """
    intervals = durations.shape[0]
    axes = durations.shape[1]
    row = 0
    for axis in range(axes):
        offsets[axis] = row
        now = 0.0
        times[0, axis] = 0.0
        for j in range(intervals + 1):
            times[j, axis] = now
            if dwells[j] > 0.0 or (j == intervals and row == offsets[axis]):
                for i in range(2 * smoothness):
                    coefficients[row, i] = 0.0
                coefficients[row, 0] = positions[j, axis]
                timing[row, 0] = now
                timing[row, 1] = dwells[j]
                now = now + dwells[j]
                row = row + 1
            if j < intervals:
                row = expand_interval(
                    j, axis, axes, now, positions, velocities, smoothness, shape, phases, counts,
                    weights, ramps, scratch_timing, scratch, timing, coefficients, row,
                )
                now = now + durations[j, axis]
    offsets[axes] = row
    return row


def expand_interval(
    interval: int,
    axis: int,
    axes: int,
    now: float,
    positions: 'float[:,:]',
    velocities: 'float[:,:]',
    smoothness: int,
    shape: int,
    phases: 'float[:,:,:]',
    counts: 'int[:]',
    weights: 'float[:]',
    ramps: 'float[:,:]',
    scratch_timing: 'float[:,:]',
    scratch: 'float[:,:]',
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
    row: int,
) -> int:
    """Expand one interval of one axis from `row` on; returns the row after its last piece."""
    cell = interval * axes + axis
    weight = weights[cell]
    state = scratch[199, :]
    psi = scratch[198, :]
    state[0] = positions[interval, axis]
    state[1] = velocities[interval, axis]
    state[4] = now
    if weight <= 0.0 or weight >= 1.0:
        which = 2 * cell
        if weight >= 1.0:
            which = which + 1
        return expand_phases(
            phases[which, :, :], counts[which], smoothness, shape, ramps[axis, 40], psi, state,
            timing, coefficients, row,
        )
    middle = expand_phases(
        phases[2 * cell, :, :], counts[2 * cell], smoothness, shape, ramps[axis, 40], psi, state,
        scratch_timing, scratch, 0,
    )
    state[0] = positions[interval, axis]
    state[1] = velocities[interval, axis]
    state[4] = now
    last = expand_phases(
        phases[2 * cell + 1, :, :], counts[2 * cell + 1], smoothness, shape, ramps[axis, 40], psi,
        state, scratch_timing, scratch, middle,
    )
    return merge_pieces(
        weight, now, 0, middle, last, scratch_timing, scratch,
        timing, coefficients, row,
    )
