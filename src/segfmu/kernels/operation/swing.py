"""A load that swings below carriages of given accelerations, by Taylor series.

The rope's vector r from the suspension to the load keeps |r| = l, and r'' = -G - s r with the
suspension's acceleration in G = (a_x, a_y, g); s is the rope's pull over the load's mass and the
rope's length. As a_x and a_y are quadratic in time and l is quartic, both series follow term by
term, for any angle. The motion becomes polynomial pieces around the middles of short intervals,
which a plan consists of as well.
"""

from math import atan2, sqrt

from segfmu.kernels.crane.records import Masses
from segfmu.kernels.operation.records import (
    Known,
    Operation,
    OperationWork,
    Slot,
    Swing,
    SwingTerms,
)
from segfmu.kernels.trajectory.cut import copy_piece
from segfmu.kernels.trajectory.records import Timing


def expand_swing(gravity: float, swing: 'float[:]', work: 'float[:,:]') -> None:
    """Write the series of the rope's vector and of its pull around the present state."""
    series = work[OperationWork.PATH:OperationWork.PULL, :]
    square = work[OperationWork.SQUARE, :]
    write_square(swing, square)
    for axis in range(3):
        series[axis, SwingTerms.CONSTANT] = swing[Swing.PATH + axis]
        series[axis, SwingTerms.LINEAR] = swing[Swing.RATE + axis]
    pull = work[OperationWork.PULL, :]
    for k in range(SwingTerms.COUNT - 2):
        # half the second derivative of the square
        found = -0.5 * (k + 1) * (k + 2) * square[k + 2]
        for axis in range(3):
            for i in range(min(k, 2) + 1):
                found = found - suspension_pull(axis, i, gravity, swing) * series[axis, k - i]
            for i in range(k + 1):
                product = series[axis, i + 1] * series[axis, k - i + 1]
                found = found + (i + 1) * (k - i + 1) * product
        for i in range(k):
            found = found - pull[i] * square[k - i]
        pull[k] = found / square[SwingTerms.CONSTANT]
        for axis in range(3):
            value = -suspension_pull(axis, k, gravity, swing)
            for i in range(k + 1):
                value = value - pull[i] * series[axis, k - i]
            series[axis, k + 2] = value / ((k + 1) * (k + 2))


def write_square(swing: 'float[:]', square: 'float[:]') -> None:
    """Write the series of the rope's length, squared."""
    for i in range(SwingTerms.COUNT):
        square[i] = 0.0
    for i in range(SwingTerms.QUARTIC + 1):
        for j in range(SwingTerms.QUARTIC + 1):
            square[i + j] = square[i + j] + length_term(i, swing) * length_term(j, swing)


def length_term(order: int, swing: 'float[:]') -> float:
    """Coefficient of the rope's length as a quartic of time."""
    if order == SwingTerms.CONSTANT:
        return swing[Swing.POSITION + 2]
    if order == SwingTerms.LINEAR:
        return swing[Swing.VELOCITY + 2]
    if order == SwingTerms.QUADRATIC:
        return 0.5 * swing[Swing.ACCELERATION + 2]
    if order == SwingTerms.CUBIC:
        return swing[Swing.JERK + 2] / 6.0
    return swing[Swing.SNAP + 2] / 24.0


def suspension_pull(axis: int, order: int, gravity: float, swing: 'float[:]') -> float:
    """Coefficient of a component of G: acceleration of the suspension, upwards gravity [m/s2]."""
    found = 0.0
    if order == 0:
        found = gravity
        if axis < 2:
            found = swing[Swing.ACCELERATION + axis]
    elif order == 1 and axis < 2:
        found = swing[Swing.JERK + axis]
    elif order == 2 and axis < 2:
        found = 0.5 * swing[Swing.SNAP + axis]
    return found


def move_swing(step: float, swing: 'float[:]', work: 'float[:,:]') -> None:
    """Move the state by a time [s] along its series; no carriage comes to rest between."""
    for axis in range(3):
        series = work[OperationWork.PATH + axis, :]
        place = 0.0
        rate = 0.0
        for j in range(SwingTerms.COUNT):
            i = SwingTerms.COUNT - 1 - j
            rate = rate * step + place
            place = place * step + series[i]
        swing[Swing.PATH + axis] = place
        swing[Swing.RATE + axis] = rate
        snap = swing[Swing.SNAP + axis]
        jerk = swing[Swing.JERK + axis]
        acceleration = swing[Swing.ACCELERATION + axis]
        mean = (
            swing[Swing.VELOCITY + axis]
            + (0.5 * acceleration + (jerk / 6.0 + snap * step / 24.0) * step) * step
        )
        swing[Swing.POSITION + axis] = swing[Swing.POSITION + axis] + mean * step
        swing[Swing.VELOCITY + axis] = (
            swing[Swing.VELOCITY + axis]
            + (acceleration + (0.5 * jerk + snap * step / 6.0) * step) * step
        )
        swing[Swing.ACCELERATION + axis] = acceleration + (jerk + 0.5 * snap * step) * step
        swing[Swing.JERK + axis] = jerk + snap * step
        swing[Swing.LEFT + axis] = max(swing[Swing.LEFT + axis] - step, 0.0)
        if swing[Swing.LEFT + axis] == 0.0:
            swing[Swing.VELOCITY + axis] = 0.0
            swing[Swing.ACCELERATION + axis] = 0.0
            swing[Swing.JERK + axis] = 0.0
            swing[Swing.SNAP + axis] = 0.0
    tighten_rope(swing)


def tighten_rope(swing: 'float[:]') -> None:
    """Remove what rounding changes of the rope's length and its rate."""
    length = swing[Swing.POSITION + 2]
    square = 0.0
    for axis in range(3):
        square = square + swing[Swing.PATH + axis] * swing[Swing.PATH + axis]
    ratio = length / sqrt(square)
    stray = -length * swing[Swing.VELOCITY + 2]
    for axis in range(3):
        swing[Swing.PATH + axis] = swing[Swing.PATH + axis] * ratio
        stray = stray + swing[Swing.PATH + axis] * swing[Swing.RATE + axis]
    for axis in range(3):
        along = stray * swing[Swing.PATH + axis] / (length * length)
        swing[Swing.RATE + axis] = swing[Swing.RATE + axis] - along


def swing_step(longest: float, swing: 'float[:]') -> float:
    """Time [s] up to the longest until a carriage comes to rest."""
    found = longest
    for axis in range(3):
        left = swing[Swing.LEFT + axis]
        if 0.0 < left < found:
            found = left
    return found


def resolved_step(gravity: float, swing: 'float[:]') -> float:
    """Length of a piece [s]: 1/20 of a radian of the phase of a pendulum's swing."""
    return 0.05 * sqrt(swing[Swing.POSITION + 2] / gravity)


def stand_time(swing: 'float[:]') -> float:
    """Time [s] until all carriages rest."""
    latest = 0.0
    for axis in range(3):
        latest = max(latest, swing[Swing.LEFT + axis])
    return latest


def sway_amplitude(gravity: float, swing: 'float[:]') -> float:
    """Largest angle [rad] between rope and vertical, from a state in which all carriages rest.

    Energy and moment around the vertical stay: w = 1 - cos(angle) is largest where
    w (2 - w) (e - w) = c, and is found between its present value and e by halving.
    """
    length = swing[Swing.POSITION + 2]
    x = swing[Swing.PATH]
    y = swing[Swing.PATH + 1]
    low = (x * x + y * y) / (length * (length - swing[Swing.PATH + 2]))
    squares = 0.0
    for axis in range(3):
        squares = squares + swing[Swing.RATE + axis] * swing[Swing.RATE + axis]
    energy = low + squares / (2.0 * gravity * length)
    moment = x * swing[Swing.RATE + 1] - y * swing[Swing.RATE]
    least = moment * moment / (2.0 * gravity * length * length * length)
    high = min(energy, 2.0)
    for _ in range(60):
        middle = 0.5 * (low + high)
        if middle * (2.0 - middle) * (energy - middle) >= least:
            low = middle
        else:
            high = middle
    return 2.0 * atan2(sqrt(low), sqrt(max(2.0 - low, 0.0)))


def advance_swing(
    duration: float, gravity: float, swing: 'float[:]', work: 'float[:,:]'
) -> None:
    """Move the state by a time [s]."""
    left = duration
    # so that the longest step takes a bounded time
    longest = max(resolved_step(gravity, swing), duration / SwingTerms.LONGEST)
    while left > 0.0:
        step = min(swing_step(longest, swing), left)
        expand_swing(gravity, swing, work)
        move_swing(step, swing, work)
        left = left - step


def write_swing(
    least: float, operation: 'float[:,:]', known: 'float[:,:]', timing: 'float[:,:,:]',
    coefficients: 'float[:,:,:]', offsets: 'int[:]', work: 'float[:,:]',
) -> None:
    """Write the motion from the state SWING on into the slot PRESENT, for a time [s] at least."""
    gravity = known[Known.CRANE, Masses.GRAVITY]
    swing = operation[Operation.SWING, :]
    ahead = operation[Operation.AHEAD, :]
    for i in range(Swing.SIZE):
        ahead[i] = swing[i]
    longest = max(resolved_step(gravity, swing), least / SwingTerms.PIECES)
    rows = SwingTerms.PIECES + SwingTerms.SPARE
    time = 0.0
    count = 0
    while count < rows and (time < least or stand_time(ahead) > 0.0 or count < SwingTerms.SPARE):
        step = swing_step(longest, ahead)
        expand_swing(gravity, ahead, work)
        move_swing(0.5 * step, ahead, work)
        expand_swing(gravity, ahead, work)
        for axis in range(3):
            write_swing_piece(axis, axis * rows + count, 0.5 * step, ahead, coefficients, work)
            timing[Slot.TRIED, axis * rows + count, Timing.START] = time
            timing[Slot.TRIED, axis * rows + count, Timing.LENGTH] = step
        move_swing(0.5 * step, ahead, work)
        time = time + step
        count = count + 1
    gather_axes(rows, count, Slot.PRESENT, timing, coefficients, offsets)
    swing[Swing.COVERED] = time


def gather_axes(
    rows: int, count: int, slot: int, timing: 'float[:,:,:]', coefficients: 'float[:,:,:]',
    offsets: 'int[:]',
) -> None:
    """Copy the pieces of all axes, `count` from each multiple of `rows` in TRIED, into a slot."""
    for axis in range(3):
        offsets[slot * Slot.OFFSETS + axis] = axis * count
        for i in range(count):
            copy_piece(
                timing[Slot.TRIED, :, :], coefficients[Slot.TRIED, :, :], axis * rows + i,
                timing[slot, :, :], coefficients[slot, :, :], axis * count + i,
            )
    offsets[slot * Slot.OFFSETS + Slot.AXES] = Slot.AXES * count


def write_swing_piece(
    axis: int, row: int, before: float, swing: 'float[:]', coefficients: 'float[:,:,:]',
    work: 'float[:,:]',
) -> None:
    """Write the piece of a coordinate of the load that begins a time [s] before the state."""
    width = coefficients.shape[2]
    for i in range(width):
        coefficients[Slot.TRIED, row, i] = work[OperationWork.PATH + axis, i]
    if axis < 2:
        coefficients[Slot.TRIED, row, SwingTerms.CONSTANT] = (
            coefficients[Slot.TRIED, row, SwingTerms.CONSTANT] + swing[Swing.POSITION + axis]
        )
        coefficients[Slot.TRIED, row, SwingTerms.LINEAR] = (
            coefficients[Slot.TRIED, row, SwingTerms.LINEAR] + swing[Swing.VELOCITY + axis]
        )
        coefficients[Slot.TRIED, row, SwingTerms.QUADRATIC] = (
            coefficients[Slot.TRIED, row, SwingTerms.QUADRATIC]
            + 0.5 * swing[Swing.ACCELERATION + axis]
        )
        coefficients[Slot.TRIED, row, SwingTerms.CUBIC] = (
            coefficients[Slot.TRIED, row, SwingTerms.CUBIC] + swing[Swing.JERK + axis] / 6.0
        )
        coefficients[Slot.TRIED, row, SwingTerms.QUARTIC] = (
            coefficients[Slot.TRIED, row, SwingTerms.QUARTIC] + swing[Swing.SNAP + axis] / 24.0
        )
    # expanded around the start, by Horner's scheme
    for i in range(width - 1):
        for j in range(width - 1 - i):
            k = width - 2 - j
            coefficients[Slot.TRIED, row, k] = (
                coefficients[Slot.TRIED, row, k] - before * coefficients[Slot.TRIED, row, k + 1]
            )
