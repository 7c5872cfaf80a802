"""Parts of plans: what is left from a time on, and one plan's pieces after another's."""

from segfmu.kernels.trajectory.check import rounding_error
from segfmu.kernels.trajectory.evaluate import evaluate_piece, find_piece, local_time
from segfmu.kernels.trajectory.pieces import clear_piece
from segfmu.kernels.trajectory.records import Timing


def end_derivative(
    row: int, last: int, order: int, timing: 'float[:,:]', coefficients: 'float[:,:]'
) -> float:
    """A derivative at the end of a piece, without rounding errors if it is continuous or zero."""
    width = coefficients.shape[1]
    length = timing[row, Timing.LENGTH]
    if row + 1 < last and order <= width // 2:
        return evaluate_piece(coefficients, row + 1, width, 0.0, order)
    value = evaluate_piece(coefficients, row, width, length, order)
    largest = 0.0
    power = 1.0
    for i in range(order, width):
        start = evaluate_piece(coefficients, row, width, 0.0, i)
        largest = max(largest, abs(start) * power)
        power = power * length / (i - order + 1)
    if order > 0 and abs(value) <= 1e-13 * largest:
        return 0.0
    return value


def cut_piece(
    row: int,
    last: int,
    local: float,
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
    cut_coefficients: 'float[:,:]',
    target: int,
) -> None:
    """Write a piece from its local time on. Its second half is expanded from the end.

    Near the end of a motion all derivatives are small there; from the start on they would be
    differences of large numbers.
    """
    width = coefficients.shape[1]
    rest = timing[row, Timing.LENGTH] - local
    factorial = 1.0
    for i in range(width):
        if i > 0:
            factorial = factorial * i
        value = 0.0
        if rest > local:
            value = evaluate_piece(coefficients, row, width, local, i)
        else:
            for j in range(width - i):
                order = width - 1 - j
                end = end_derivative(row, last, order, timing, coefficients)
                value = end - value * rest / (order - i + 1)
        cut_coefficients[target, i] = value / factorial


def settle_end(
    moves: bool,
    first: int,
    last: int,
    coefficients: 'float[:,:]',
    cut_coefficients: 'float[:,:]',
    target: int,
) -> None:
    """Leave of a cut piece the position and, if the axis `moves`, velocity and acceleration.

    Less than a billionth of those in the pieces first .. last - 1 is rounding; higher derivatives
    are zero where a plan ends.
    """
    position = cut_coefficients[target, 0]
    velocity = cut_coefficients[target, 1]
    acceleration = cut_coefficients[target, 2]
    fastest = 0.0
    steepest = 0.0
    for row in range(first, last):
        fastest = max(fastest, abs(coefficients[row, 1]))
        steepest = max(steepest, abs(coefficients[row, 2]))
    clear_piece(cut_coefficients, target)
    cut_coefficients[target, 0] = position
    if moves and abs(velocity) > 1e-9 * fastest:
        cut_coefficients[target, 1] = velocity
    if moves and abs(acceleration) > 1e-9 * steepest:
        cut_coefficients[target, 2] = acceleration


def cut_plan(
    time: float,
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
    offsets: 'int[:]',
    cut_timing: 'float[:,:]',
    cut_coefficients: 'float[:,:]',
    cut_offsets: 'int[:]',
) -> int:
    """Write what is left of every axis from `time` on, which becomes time 0; the number of pieces.

    An axis at its end has one piece without length, in which it still moves if it ends so; one that
    has ended stays. The cut arrays have as many rows as there are pieces and offsets together.
    """
    target = 0
    for axis in range(offsets.shape[0] - 1):
        cut_offsets[axis] = target
        last = offsets[axis + 1]
        row = find_piece(time, timing, offsets[axis], last)
        local = max(local_time(time, timing, row), 0.0)
        start = 0.0
        rest = timing[row, Timing.LENGTH] - local
        cut_piece(row, last, local, timing, coefficients, cut_coefficients, target)
        # up to the resolution of the clock, this is the end
        if row == last - 1 and rest <= 1e-15 * time:
            end = timing[row, Timing.START] + timing[row, Timing.LENGTH]
            moves = time - end <= 1e-15 * time
            settle_end(moves, offsets[axis], last, coefficients, cut_coefficients, target)
            rest = 0.0
        while row < last:
            cut_timing[target, Timing.START] = start
            cut_timing[target, Timing.LENGTH] = rest
            start = start + rest
            target = target + 1
            row = row + 1
            if row < last:
                rest = timing[row, Timing.LENGTH]
                copy_piece(timing, coefficients, row, cut_timing, cut_coefficients, target)
    cut_offsets[offsets.shape[0] - 1] = target
    return target


def meet_ends(
    clock: float, dwell: float, timing: 'float[:,:]', offsets: 'int[:]'
) -> None:
    """Let axes end together that end a rounding error before the last one.

    clock: the time [s] whose rounding that is, the duration of the plan that the pieces are left
    of. dwell: that at the end [s], the last piece of every axis that has not begun it; it stays as
    long. The longest other piece takes the difference, as it changes least by it.
    """
    latest = 0.0
    for axis in range(offsets.shape[0] - 1):
        row = offsets[axis + 1] - 1
        latest = max(latest, timing[row, Timing.START] + timing[row, Timing.LENGTH])
    for axis in range(offsets.shape[0] - 1):
        row = offsets[axis + 1] - 1
        late = latest - (timing[row, Timing.START] + timing[row, Timing.LENGTH])
        if late > 1e-12 * clock:
            continue
        longest = row
        if dwell > 0.0 and row > offsets[axis]:
            longest = row - 1
        for i in range(offsets[axis], longest):
            if timing[i, Timing.LENGTH] > timing[longest, Timing.LENGTH]:
                longest = i
        timing[longest, Timing.LENGTH] = timing[longest, Timing.LENGTH] + late
        for i in range(longest + 1, row + 1):
            timing[i, Timing.START] = timing[i, Timing.START] + late


def add_power(
    value: float, order: int, before: float, coefficients: 'float[:,:]', row: int
) -> None:
    """Add to a piece what has but one derivative, of a value, `before` [s] after its start."""
    for power in range(order + 1):
        term = value
        for i in range(1, order - power + 1):
            term = -term * before / i
        for i in range(1, power + 1):
            term = term / i
        coefficients[row, power] = coefficients[row, power] + term


def anchor_plan(
    ends: 'float[:,:]',
    limits: 'float[:,:]',
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
    offsets: 'int[:]',
) -> None:
    """Change pieces by rounding errors so that every axis ends exactly in its state ends[axis, :].

    Derivatives that it does not have are zero there. Rounding errors of a whole motion may be large
    against what is left of it: from the last piece on, each one is led to the start of the next.
    What is rounding against the limits (axes, c_1 ..) stays: on a long piece it would add up.
    """
    width = coefficients.shape[1]
    for axis in range(offsets.shape[0] - 1):
        last = offsets[axis + 1] - 1
        for i in range(offsets[axis + 1] - offsets[axis]):
            row = last - i
            length = timing[row, Timing.LENGTH]
            # a correction leaves rounding errors in the lower orders, and no others
            for j in range(width // 2 + 1):
                order = width // 2 - j
                wanted = 0.0
                rounding = 0.0
                if order > 0 and order <= limits.shape[1]:
                    rounding = rounding_error(order, limits[axis, :])
                if i > 0:
                    wanted = evaluate_piece(coefficients, row + 1, width, 0.0, order)
                elif order < ends.shape[1]:
                    wanted = ends[axis, order]
                # the second time without the rounding errors of what the first one removes
                for repeat in range(2):
                    missed = wanted - evaluate_piece(coefficients, row, width, length, order)
                    if abs(missed) > rounding:
                        add_power(missed, order, length, coefficients, row)


def join_plans(
    lead_timing: 'float[:,:]',
    lead_coefficients: 'float[:,:]',
    lead_offsets: 'int[:]',
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
    offsets: 'int[:]',
    joined_timing: 'float[:,:]',
    joined_coefficients: 'float[:,:]',
    joined_offsets: 'int[:]',
) -> int:
    """Write the pieces of each axis of leads and then those of a plan; returns their number.

    Times stay as they are; axes may have no lead. The arrays of leads and plan have the same number
    of rows, the joined ones twice as many.
    """
    target = 0
    for axis in range(offsets.shape[0] - 1):
        joined_offsets[axis] = target
        for row in range(lead_offsets[axis], lead_offsets[axis + 1]):
            copy_piece(
                lead_timing, lead_coefficients, row, joined_timing, joined_coefficients, target
            )
            target = target + 1
        for row in range(offsets[axis], offsets[axis + 1]):
            copy_piece(timing, coefficients, row, joined_timing, joined_coefficients, target)
            target = target + 1
    joined_offsets[offsets.shape[0] - 1] = target
    return target


def copy_piece(
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
    row: int,
    target_timing: 'float[:,:]',
    target_coefficients: 'float[:,:]',
    target: int,
) -> None:
    """Copy one piece."""
    for i in range(Timing.SIZE):
        target_timing[target, i] = timing[row, i]
    for i in range(coefficients.shape[1]):
        target_coefficients[target, i] = coefficients[row, i]
