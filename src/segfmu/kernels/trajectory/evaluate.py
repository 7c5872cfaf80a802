"""Phases -> polynomial pieces -> value of any derivative.

A phase is a row [duration, rise, acceleration at its start, acceleration change]: a hold when
the change is zero, else a ramp of (11a-d). Its integrals (15a-g, errata E4) become polynomial
pieces of the position in local time, ascending powers, 2 n coefficients each: one for a hold
or a smoothstep ramp, up to three (jerk rises, stays, falls) for a plateau ramp, each rise being
three where the snap has a plateau as well. timing[row] is [start, length] of a piece: the length
is kept beside the starts, as the difference of two late starts would not be exact.
"""

from segfmu.kernels.planner.transition import transition_coefficients


def append_piece(
    duration: float,
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
    row: int,
    width: int,
    state: 'float[:]',
) -> int:
    """Close the piece in `row`: add position to jerk from `state`, which is advanced.

    state = position, velocity, acceleration, jerk and time at the start of the piece. Returns
    row + 1.
    """
    coefficients[row, 0] = state[0]
    coefficients[row, 1] = state[1]
    coefficients[row, 2] = 0.5 * state[2]
    coefficients[row, 3] = coefficients[row, 3] + state[3] / 6.0
    timing[row, 0] = state[4]
    timing[row, 1] = duration
    y = 0.0
    v = 0.0
    for j in range(width):
        i = width - 1 - j
        y = y * duration + coefficients[row, i]
        if i > 0:
            v = v * duration + i * coefficients[row, i]
    state[0] = y
    state[1] = v
    state[2] = evaluate_piece(coefficients, row, width, duration, 2)
    state[3] = evaluate_piece(coefficients, row, width, duration, 3)
    state[4] = state[4] + duration
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
        coefficients[row, i + 3] = coefficients[row, i + 3] + scale / rise**i


def add_snap(
    snap: float, rise: float, order: int, psi: 'float[:]', coefficients: 'float[:,:]', row: int
) -> None:
    """Add to a piece the fourfold integral of snap * Psi(t, rise) with Psi of the given order."""
    for i in range(order + 1, 2 * order + 2):
        scale = snap * psi[i] / ((i + 1.0) * (i + 2.0) * (i + 3.0) * (i + 4.0))
        coefficients[row, i + 4] = coefficients[row, i + 4] + scale / rise**i


def expand_jerk_change(
    jerk: float,
    rise: float,
    share: float,
    order: int,
    psi: 'float[:]',
    state: 'float[:]',
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
    row: int,
    width: int,
) -> int:
    """Pieces in which the jerk changes by `jerk` within `rise`; returns the row after them."""
    clear_piece(coefficients, row)
    if share <= 0.0:
        add_rise(jerk, rise, order, psi, coefficients, row)
        return append_piece(rise, timing, coefficients, row, width, state)
    snap = jerk / (rise * (1.0 - share))
    edge = share * rise
    add_snap(snap, edge, order, psi, coefficients, row)
    row = append_piece(edge, timing, coefficients, row, width, state)
    clear_piece(coefficients, row)
    coefficients[row, 4] = snap / 24.0
    row = append_piece(rise - 2.0 * edge, timing, coefficients, row, width, state)
    clear_piece(coefficients, row)
    coefficients[row, 4] = snap / 24.0
    add_snap(-snap, edge, order, psi, coefficients, row)
    return append_piece(edge, timing, coefficients, row, width, state)


def expand_phases(
    phases: 'float[:,:]',
    count: int,
    smoothness: int,
    shape: int,
    share: float,
    psi: 'float[:]',
    state: 'float[:]',
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
    row: int,
) -> int:
    """Expand `count` phases into pieces from `row` on; returns the row after the last one.

    state holds position and velocity, and in state[4] the time, at the start, and is advanced
    to the end; psi is work space for 2 n numbers; share is the one of the snap's rise in that of
    the jerk, 0 where the snap has no plateau.
    """
    width = 2 * smoothness
    k = smoothness - 2
    plateau = shape == 1 and k > 0
    order = k
    if plateau:
        order = k - 1
        if share > 0.0:
            order = k - 2
    transition_coefficients(order, psi)
    for i in range(count):
        duration = phases[i, 0]
        rise = phases[i, 1]
        a = phases[i, 2]
        change = phases[i, 3]
        state[2] = a
        state[3] = 0.0
        clear_piece(coefficients, row)
        if change == 0.0 or not plateau:
            if change != 0.0:
                for j in range(order + 1, 2 * order + 2):
                    scale = change * psi[j] / ((j + 1.0) * (j + 2.0))
                    coefficients[row, j + 2] = scale / duration**j
            row = append_piece(duration, timing, coefficients, row, width, state)
        else:
            jerk = change / (duration - rise)
            flat = duration - 2.0 * rise
            row = expand_jerk_change(
                jerk, rise, share, order, psi, state, timing, coefficients, row, width
            )
            state[2] = a + 0.5 * jerk * rise
            state[3] = jerk
            if flat > 0.0:
                clear_piece(coefficients, row)
                row = append_piece(flat, timing, coefficients, row, width, state)
                state[2] = a + change - 0.5 * jerk * rise
                state[3] = jerk
            row = expand_jerk_change(
                -jerk, rise, share, order, psi, state, timing, coefficients, row, width
            )
        state[2] = a + change
        state[3] = 0.0
    return row


def find_piece(time: float, timing: 'float[:,:]', first: int, last: int) -> int:
    """The row of first .. last - 1 whose piece holds `time`, by bisection."""
    lower = first
    upper = last
    while upper - lower > 1:
        middle = (lower + upper) // 2
        if time >= timing[middle, 0]:
            lower = middle
        else:
            upper = middle
    return lower


def evaluate_piece(
    coefficients: 'float[:,:]', row: int, width: int, t: float, derivative: int
) -> float:
    """Value of a derivative of one piece at local time t."""
    value = 0.0
    for j in range(width - derivative):
        i = width - 1 - j
        factor = 1.0
        for m in range(derivative):
            factor = factor * (i - m)
        value = value * t + factor * coefficients[row, i]
    return value


def evaluate(
    times: 'float[:]',
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
    offsets: 'int[:]',
    ends: 'float[:]',
    derivative: int,
    values: 'float[:,:]',
) -> None:
    """One derivative of every axis at many times: values[time, axis].

    The pieces of axis i are the rows offsets[i] .. offsets[i + 1] - 1; ends[i] is its duration.
    Before its start and after its end an axis stays in its end position, all derivatives zero.
    """
    width = coefficients.shape[1]
    for axis in range(ends.shape[0]):
        first = offsets[axis]
        last = offsets[axis + 1]
        row = first
        for i in range(times.shape[0]):
            t = min(max(times[i], timing[first, 0]), ends[axis])
            if t < timing[row, 0] or (row + 1 < last and t >= timing[row + 1, 0]):
                row = find_piece(t, timing, first, last)
            if derivative > 0 and t != times[i]:
                values[i, axis] = 0.0
            else:
                # where the clock is coarser than a piece is long, the piece must not go on
                local = min(t - timing[row, 0], timing[row, 1])
                values[i, axis] = evaluate_piece(coefficients, row, width, local, derivative)


def evaluate_orders(
    time: float,
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
    offsets: 'int[:]',
    ends: 'float[:]',
    values: 'float[:,:]',
) -> None:
    """The first derivatives of every axis at one time: values[derivative, axis], as `evaluate`."""
    width = coefficients.shape[1]
    for axis in range(ends.shape[0]):
        t = min(max(time, timing[offsets[axis], 0]), ends[axis])
        row = find_piece(t, timing, offsets[axis], offsets[axis + 1])
        local = min(t - timing[row, 0], timing[row, 1])
        for derivative in range(values.shape[0]):
            if derivative > 0 and t != time:
                values[derivative, axis] = 0.0
            else:
                values[derivative, axis] = evaluate_piece(
                    coefficients, row, width, local, derivative
                )
