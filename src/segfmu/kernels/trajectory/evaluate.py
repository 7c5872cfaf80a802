"""Polynomial pieces -> value of any derivative.

A piece is a polynomial of the position in local time, ascending powers, 2 n coefficients; row i of
`timing` has its start and length (Timing). The pieces of axis i are the rows offsets[i] ..
offsets[i + 1] - 1; ends[i] is the end of its motion [s].
"""

from segfmu.kernels.trajectory.records import Order, Timing


def find_piece(time: float, timing: 'float[:,:]', first: int, last: int) -> int:
    """The row of first .. last - 1 whose piece contains `time`, by bisection."""
    lower = first
    upper = last
    while upper - lower > 1:
        middle = (lower + upper) // 2
        if time >= timing[middle, Timing.START]:
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


def local_time(time: float, timing: 'float[:,:]', row: int) -> float:
    """Time since the start of a piece, at most its length.

    The clock may be coarser than the length of a piece, which must not be exceeded.
    """
    return min(time - timing[row, Timing.START], timing[row, Timing.LENGTH])


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

    Before its start and after its end an axis stays in its end position, all derivatives zero.
    """
    width = coefficients.shape[1]
    for axis in range(ends.shape[0]):
        first = offsets[axis]
        last = offsets[axis + 1]
        row = first
        for i in range(times.shape[0]):
            t = min(max(times[i], timing[first, Timing.START]), ends[axis])
            behind = row + 1 < last and t >= timing[row + 1, Timing.START]
            if t < timing[row, Timing.START] or behind:
                row = find_piece(t, timing, first, last)
            if derivative > 0 and t != times[i]:
                values[i, axis] = 0.0
            else:
                local = local_time(t, timing, row)
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
        t = min(max(time, timing[offsets[axis], Timing.START]), ends[axis])
        row = find_piece(t, timing, offsets[axis], offsets[axis + 1])
        local = local_time(t, timing, row)
        for derivative in range(values.shape[0]):
            if derivative > 0 and t != time:
                values[derivative, axis] = 0.0
            else:
                values[derivative, axis] = evaluate_piece(
                    coefficients, row, width, local, derivative
                )


def evaluate_near(
    time: float,
    near: 'float[:]',
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
    offsets: 'int[:]',
    ends: 'float[:]',
    values: 'float[:,:]',
) -> None:
    """As `evaluate_orders` but for rounding, fast where many times follow each other closely.

    near: rows of the pieces of the time before, one per axis; they become those of this time.
    """
    for axis in range(ends.shape[0]):
        first = offsets[axis]
        last = offsets[axis + 1]
        t = min(max(time, timing[first, Timing.START]), ends[axis])
        row = min(max(int(near[axis]), first), last - 1)
        behind = row + 1 < last and t >= timing[row + 1, Timing.START]
        if behind or t < timing[row, Timing.START]:
            row = find_piece(t, timing, first, last)
        near[axis] = row
        evaluate_derivatives(coefficients, row, local_time(t, timing, row), axis, values)
        if t != time:
            for derivative in range(1, values.shape[0]):
                values[derivative, axis] = 0.0


def evaluate_derivatives(
    coefficients: 'float[:,:]', row: int, t: float, axis: int, values: 'float[:,:]'
) -> None:
    """Write the first 5 or 7 derivatives of one piece at local time t, by Horner's scheme."""
    width = coefficients.shape[1]
    position = 0.0
    velocity = 0.0
    acceleration = 0.0
    jerk = 0.0
    snap = 0.0
    crackle = 0.0
    pop = 0.0
    for j in range(width):
        # over their factorials
        pop = pop * t + crackle
        crackle = crackle * t + snap
        snap = snap * t + jerk
        jerk = jerk * t + acceleration
        acceleration = acceleration * t + velocity
        velocity = velocity * t + position
        position = position * t + coefficients[row, width - 1 - j]
    values[0, axis] = position
    values[1, axis] = velocity
    values[2, axis] = 2.0 * acceleration
    values[Order.JERK, axis] = 6.0 * jerk
    values[Order.SNAP, axis] = 24.0 * snap
    if values.shape[0] > Order.CRACKLE:
        values[Order.CRACKLE, axis] = 120.0 * crackle
        values[Order.POP, axis] = 720.0 * pop
