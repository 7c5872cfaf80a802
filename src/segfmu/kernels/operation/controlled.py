"""A load below carriages whose velocities are cubic B-splines: its motion, and its pieces.

The load's swing is integrated with its Taylor series (swing.py). Beside it two free swings are,
with the pull s(t) of the rope in this motion: p_j'' = -s p_j, which begin with p_1 = 1, p_1' = 0
and p_2 = 0, p_2' = w, w^2 = g / l. As the way r from the suspension to the load keeps
r'' = -u - s r under an acceleration u of the carriage,

    (p_j r' - p_j' r)' = -p_j u,

so the load hangs at rest at the end if the integral of p_j u is p_j(0) r'(0) - p_j'(0) r(0) for
both. u is a sum of quadratic B-splines; the integrals of p_j with each are the moments.
"""

from math import sqrt

from segfmu.kernels.crane.records import Masses
from segfmu.kernels.numerics.numbers import NEVER
from segfmu.kernels.operation.records import (
    Control,
    Known,
    Operation,
    OperationWork,
    Slot,
    Swing,
    SwingTerms,
)
from segfmu.kernels.operation.swing import (
    expand_swing,
    gather_axes,
    move_swing,
    write_swing_piece,
)
from segfmu.kernels.trajectory.records import Timing


def swing_frequency(gravity: float, swing: 'float[:]') -> float:
    """Of small swings [rad/s]."""
    return sqrt(gravity / swing[Swing.POSITION + 2])


def set_control_start(interval: float, swing: 'float[:]', work: 'float[:,:]') -> None:
    """Set the first control points by velocities and two derivatives; interval: of knots [s]."""
    for axis in range(3):
        change = interval * swing[Swing.ACCELERATION + axis]
        bend = interval * interval * swing[Swing.JERK + axis]
        for i in range(Control.FREE):
            since = i - 1.0
            work[OperationWork.CONTROL + axis, i] = swing[Swing.VELOCITY + axis] + (
                since * change + (0.5 * since * since - 1.0 / 6.0) * bend
            )


def set_knot(k: int, interval: float, ahead: 'float[:]', control: 'float[:,:]') -> None:
    """Set velocities, accelerations and their derivatives at a knot of the splines (3, points)."""
    for axis in range(3):
        points = control[axis, :]
        last = k + Control.DEGREE
        before = (points[k + 1] - points[k]) / interval
        here = (points[k + 2] - points[k + 1]) / interval
        behind = (points[last] - points[k + 2]) / interval
        ahead[Swing.VELOCITY + axis] = (points[k] + 4.0 * points[k + 1] + points[k + 2]) / 6.0
        ahead[Swing.ACCELERATION + axis] = 0.5 * (before + here)
        ahead[Swing.JERK + axis] = (here - before) / interval
        ahead[Swing.SNAP + axis] = (behind - 2.0 * here + before) / (interval * interval)


def begin_controlled(operation: 'float[:,:]') -> None:
    """Begin in the state SWING; carriages rest when the control points say so."""
    for i in range(Swing.SIZE):
        operation[Operation.AHEAD, i] = operation[Operation.SWING, i]
    for axis in range(3):
        operation[Operation.AHEAD, Swing.LEFT + axis] = NEVER


def run_controlled(
    interval: float, operation: 'float[:,:]', known: 'float[:,:]', work: 'float[:,:]'
) -> float:
    """Move the load from the state SWING to AHEAD, and write the moments.

    Returns the angle that it then swings with, nearly [rad]; NEVER if the rope is slack. interval:
    time between knots [s].
    """
    gravity = known[Known.CRANE, Masses.GRAVITY]
    ahead = operation[Operation.AHEAD, :]
    begin_controlled(operation)
    for j in range(2):
        for k in range(Control.POINTS):
            work[OperationWork.MOMENT + j, k] = 0.0
        work[OperationWork.FREE + j, SwingTerms.CONSTANT] = 1.0 - j
        work[OperationWork.FREE + j, SwingTerms.LINEAR] = j * swing_frequency(gravity, ahead)
    parts = interval_parts(0.3, interval, operation, gravity, work)
    step = interval / parts
    for k in range(Control.INTERVALS):
        set_knot(k, interval, ahead, work[OperationWork.CONTROL:OperationWork.MOMENT, :])
        for i in range(parts):
            expand_swing(gravity, ahead, work)
            if not work[OperationWork.PULL, SwingTerms.CONSTANT] > 0.0:
                return NEVER
            for j in range(2):
                add_moments(k, i * step, step, interval, work[OperationWork.MOMENT + j, :],
                            work[OperationWork.FREE + j, :], work[OperationWork.PULL, :])
            move_swing(step, ahead, work)
    frequency = swing_frequency(gravity, ahead)
    found = 0.0
    for axis in range(2):
        away = ahead[Swing.PATH + axis]
        rate = ahead[Swing.RATE + axis] / frequency
        found = found + away * away + rate * rate
    return sqrt(found) / ahead[Swing.POSITION + 2]


def interval_parts(
    longest: float, interval: float, operation: 'float[:,:]', gravity: float, work: 'float[:,:]'
) -> int:
    """In how many parts an interval between knots is moved; longest: of a swing's phase [rad]."""
    swing = operation[Operation.SWING, :]
    length = swing[Swing.POSITION + 2]
    shortest = length
    for k in range(Control.INTERVALS):
        points = work[OperationWork.CONTROL + 2, :]
        inner = points[k + 1] + points[k + 2]
        last = k + Control.DEGREE
        length = length + interval * (points[k] + 11.0 * inner + points[last]) / 24.0
        shortest = min(shortest, length)
    if not shortest > 0.0:
        shortest = swing[Swing.POSITION + 2]
    phase = interval * sqrt(gravity / shortest)
    # nor has what is no number a few parts
    if not phase < longest * Control.MANY:
        return Control.MANY
    return 1 + int(phase / longest)


def fits_plan(
    interval: float, operation: 'float[:,:]', known: 'float[:,:]', work: 'float[:,:]'
) -> bool:
    """Whether a plan has room for the pieces of the motion, before it is known."""
    gravity = known[Known.CRANE, Masses.GRAVITY]
    return interval_parts(0.2, interval, operation, gravity, work) <= Control.STEPS


def add_moments(
    knot: int, since: float, step: float, interval: float, moment: 'float[:]', free: 'float[:]',
    pull: 'float[:]',
) -> None:
    """Add a step from a time since a knot on [s] to the moments of its free swing, and move it."""
    for k in range(SwingTerms.COUNT - 2):
        value = 0.0
        for i in range(k + 1):
            value = value - pull[i] * free[k - i]
        free[k + 2] = value / ((k + 1) * (k + 2))
    # integrals of the swing, and of it times the time, and its square, since the step's start
    whole = 0.0
    late = 0.0
    later = 0.0
    place = 0.0
    rate = 0.0
    for j in range(SwingTerms.COUNT):
        i = SwingTerms.COUNT - 1 - j
        whole = whole * step + free[i] / (i + 1)
        late = late * step + free[i] / (i + 2)
        later = later * step + free[i] / (i + 3)
        rate = rate * step + place
        place = place * step + free[i]
    whole = whole * step
    late = late * step * step
    later = later * step * step * step
    # the same since the knot, in shares of the interval
    later = (since * since * whole + 2.0 * since * late + later) / (interval * interval)
    late = (since * whole + late) / interval
    moment[knot] = moment[knot] + (0.5 * whole - late + 0.5 * later) / interval
    moment[knot + 1] = moment[knot + 1] + (0.5 * whole + late - later) / interval
    moment[knot + 2] = moment[knot + 2] + 0.5 * later / interval
    free[SwingTerms.CONSTANT] = place
    free[SwingTerms.LINEAR] = rate


def write_controlled(
    interval: float, operation: 'float[:,:]', known: 'float[:,:]', timing: 'float[:,:,:]',
    coefficients: 'float[:,:,:]', offsets: 'int[:]', work: 'float[:,:]',
) -> None:
    """Write the pieces of the motion into the slot TRIED."""
    gravity = known[Known.CRANE, Masses.GRAVITY]
    ahead = operation[Operation.AHEAD, :]
    # two more, as a jerk may rise to its largest within an interval
    parts = min(2 + interval_parts(0.05, interval, operation, gravity, work), Control.STEPS)
    begin_controlled(operation)
    step = interval / parts
    rows = Control.INTERVALS * Control.STEPS
    count = 0
    for k in range(Control.INTERVALS):
        set_knot(k, interval, ahead, work[OperationWork.CONTROL:OperationWork.MOMENT, :])
        for i in range(parts):
            expand_swing(gravity, ahead, work)
            move_swing(0.5 * step, ahead, work)
            expand_swing(gravity, ahead, work)
            for axis in range(3):
                row = axis * rows + count
                write_swing_piece(axis, row, 0.5 * step, ahead, coefficients, work)
                timing[Slot.TRIED, row, Timing.START] = k * interval + i * step
                timing[Slot.TRIED, row, Timing.LENGTH] = step
            move_swing(0.5 * step, ahead, work)
            count = count + 1
    gather_axes(rows, count, Slot.TRIED, timing, coefficients, offsets)
