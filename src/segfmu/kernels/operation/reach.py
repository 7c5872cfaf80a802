"""Ranges of what a motion of the load asks of the drives within an interval of time.

A range is a centre and a radius. Those of the load follow from the derivatives in the middle of the
interval by Taylor's formula, which ends for a polynomial; those of the demands by the flat inverse,
crane/flatness.py, with q = w_x / w_z and q = w_y / w_z in place of the sway angles: the carriage is
at p - z q, and the rope is -z sqrt(1 + q_x^2 + q_y^2) long. Nothing is sampled, so nothing is
missed; the shorter an interval, the less too wide its ranges are.

`reach` is a `Reach`, a row of it a `Range`.
"""

from math import atan, sqrt

from segfmu.kernels.crane.bounds import carriage_mass
from segfmu.kernels.crane.records import Demand, Resistance
from segfmu.kernels.numerics.polynomials import polynomial_shift
from segfmu.kernels.operation.records import OperationWork, Range, Reach
from segfmu.kernels.trajectory.evaluate import evaluate_piece, find_piece
from segfmu.kernels.trajectory.records import Timing


def set_range(centre: float, radius: float, found: 'float[:]') -> None:
    """Set a range."""
    found[Range.CENTRE] = centre
    found[Range.RADIUS] = radius


def add_range(share: float, a: 'float[:]', found: 'float[:]') -> None:
    """found = found + share a."""
    found[Range.CENTRE] = found[Range.CENTRE] + share * a[Range.CENTRE]
    found[Range.RADIUS] = found[Range.RADIUS] + abs(share) * a[Range.RADIUS]


def add_range_product(share: float, a: 'float[:]', b: 'float[:]', found: 'float[:]') -> None:
    """found = found + share a b."""
    radius = abs(a[Range.CENTRE]) * b[Range.RADIUS]
    radius = radius + a[Range.RADIUS] * (abs(b[Range.CENTRE]) + b[Range.RADIUS])
    found[Range.CENTRE] = found[Range.CENTRE] + share * a[Range.CENTRE] * b[Range.CENTRE]
    found[Range.RADIUS] = found[Range.RADIUS] + abs(share) * radius


def divide_range(a: 'float[:]', b: 'float[:]', found: 'float[:]') -> None:
    """found = a / b, with b above 0."""
    quotient = a[Range.CENTRE] / b[Range.CENTRE]
    least = b[Range.CENTRE] - b[Range.RADIUS]
    found[Range.RADIUS] = (a[Range.RADIUS] + abs(quotient) * b[Range.RADIUS]) / least
    found[Range.CENTRE] = quotient


def write_load(
    begin: float, end: float, timing: 'float[:,:]', coefficients: 'float[:,:]', offsets: 'int[:]',
    work: 'float[:,:]',
) -> None:
    """Write the ranges of the load between two times [s] that no piece begins between."""
    width = coefficients.shape[1]
    middle = 0.5 * (begin + end)
    radius = 0.5 * (end - begin)
    piece = work[OperationWork.PIECE, :]
    for axis in range(3):
        last = offsets[axis + 1]
        row = find_piece(middle, timing, offsets[axis], last)
        local = middle - timing[row, Timing.START]
        count = 1
        if local > timing[row, Timing.LENGTH]:
            # an axis rests after its end
            piece[0] = evaluate_piece(coefficients, row, width, timing[row, Timing.LENGTH], 0)
        else:
            count = width
            while count > 1 and coefficients[row, count - 1] == 0.0:
                count = count - 1
            for i in range(count):
                piece[i] = coefficients[row, i]
            polynomial_shift(piece, local, count)
        for order in range(5):
            place = OperationWork.REACH + Reach.POSITION + 3 * order + axis
            write_hull(count, radius, piece, work[place, :])
            for i in range(1, count):
                piece[i - 1] = i * piece[i]
            count = max(count - 1, 0)


def write_hull(count: int, radius: float, piece: 'float[:]', found: 'float[:]') -> None:
    """Write the range of a polynomial of `count` coefficients about the middle of an interval."""
    total = 0.0
    # without a radius the value alone counts
    if radius > 0.0:
        for j in range(count - 1):
            total = (total + abs(piece[count - 1 - j])) * radius
    value = 0.0
    if count > 0:
        value = piece[0]
    set_range(value, total, found)


def write_slope(axis: int, reach: 'float[:,:]') -> None:
    """Write w_x / w_z, or w_y / w_z, and two derivatives."""
    slope = reach[Reach.SLOPE + axis, :]
    rate = reach[Reach.SLOPE_RATE + axis, :]
    pull = reach[Reach.PULL, :]
    pull_rate = reach[Reach.JERK + 2, :]
    total = reach[Reach.SUM, :]
    divide_range(reach[Reach.ACCELERATION + axis, :], pull, slope)
    set_range(0.0, 0.0, total)
    add_range(1.0, reach[Reach.JERK + axis, :], total)
    add_range_product(-1.0, slope, pull_rate, total)
    divide_range(total, pull, rate)
    set_range(0.0, 0.0, total)
    add_range(1.0, reach[Reach.SNAP + axis, :], total)
    add_range_product(-2.0, rate, pull_rate, total)
    add_range_product(-1.0, slope, reach[Reach.SNAP + 2, :], total)
    divide_range(total, pull, reach[Reach.SLOPE_CHANGE + axis, :])


def write_stretch(reach: 'float[:,:]') -> None:
    """Write s = sqrt(1 + q_x^2 + q_y^2) and two derivatives."""
    total = reach[Reach.SUM, :]
    stretch = reach[Reach.STRETCH, :]
    rate = reach[Reach.STRETCH_RATE, :]
    set_range(1.0, 0.0, total)
    for axis in range(2):
        add_range_product(1.0, reach[Reach.SLOPE + axis, :], reach[Reach.SLOPE + axis, :], total)
    root = sqrt(total[Range.CENTRE])
    # the square is 1 at least
    set_range(root, total[Range.RADIUS] / (1.0 + root), stretch)
    set_range(0.0, 0.0, total)
    for axis in range(2):
        slope_rate = reach[Reach.SLOPE_RATE + axis, :]
        add_range_product(1.0, reach[Reach.SLOPE + axis, :], slope_rate, total)
    divide_range(total, stretch, rate)
    set_range(0.0, 0.0, total)
    for axis in range(2):
        slope_rate = reach[Reach.SLOPE_RATE + axis, :]
        add_range_product(1.0, slope_rate, slope_rate, total)
        add_range_product(
            1.0, reach[Reach.SLOPE + axis, :], reach[Reach.SLOPE_CHANGE + axis, :], total
        )
    add_range_product(-1.0, rate, rate, total)
    divide_range(total, stretch, reach[Reach.STRETCH_CHANGE, :])


def write_drive(
    drive: int, ahead: float, factor: 'float[:]', rate: 'float[:]', change: 'float[:]',
    reach: 'float[:,:]',
) -> None:
    """Write the motion of a drive that is at ahead p - z f; rate and change are of f."""
    place = reach[Reach.DEMAND + Demand.PLACE + drive, :]
    velocity = reach[Reach.DEMAND + Demand.VELOCITY + drive, :]
    acceleration = reach[Reach.DEMAND + Demand.ACCELERATION + drive, :]
    set_range(0.0, 0.0, place)
    add_range(ahead, reach[Reach.POSITION + drive, :], place)
    add_range_product(-1.0, reach[Reach.POSITION + 2, :], factor, place)
    set_range(0.0, 0.0, velocity)
    add_range(ahead, reach[Reach.VELOCITY + drive, :], velocity)
    add_range_product(-1.0, reach[Reach.VELOCITY + 2, :], factor, velocity)
    add_range_product(-1.0, reach[Reach.POSITION + 2, :], rate, velocity)
    set_range(0.0, 0.0, acceleration)
    add_range(ahead, reach[Reach.ACCELERATION + drive, :], acceleration)
    add_range_product(-1.0, reach[Reach.ACCELERATION + 2, :], factor, acceleration)
    add_range_product(-2.0, reach[Reach.VELOCITY + 2, :], rate, acceleration)
    add_range_product(-1.0, reach[Reach.POSITION + 2, :], change, acceleration)


def add_resistance(drive: int, crane: 'float[:]', reach: 'float[:,:]') -> None:
    """Widen the force of a drive by the friction that it may have to overcome."""
    velocity = reach[Reach.DEMAND + Demand.VELOCITY + drive, :]
    most = abs(velocity[Range.CENTRE]) + velocity[Range.RADIUS]
    dry = max(crane[Resistance.STATIC + drive], crane[Resistance.COULOMB + drive])
    smooth = crane[Resistance.VISCOUS + drive] + crane[Resistance.DRAG + drive] * most
    set_range(0.0, dry + smooth * most, reach[Reach.PRODUCT, :])
    add_range(1.0, reach[Reach.PRODUCT, :], reach[Reach.DEMAND + Demand.FORCE + drive, :])


def write_forces(crane: 'float[:]', reach: 'float[:,:]') -> None:
    """Write forces and powers of the drives."""
    payload = crane[Resistance.PAYLOAD_MASS]
    for drive in range(2):
        force = reach[Reach.DEMAND + Demand.FORCE + drive, :]
        set_range(0.0, 0.0, force)
        acceleration = reach[Reach.DEMAND + Demand.ACCELERATION + drive, :]
        add_range(carriage_mass(crane, drive), acceleration, force)
        add_range(payload, reach[Reach.ACCELERATION + drive, :], force)
    force = reach[Reach.DEMAND + Demand.FORCE + 2, :]
    set_range(0.0, 0.0, force)
    add_range_product(-payload, reach[Reach.PULL, :], reach[Reach.STRETCH, :], force)
    for drive in range(3):
        add_resistance(drive, crane, reach)
        power = reach[Reach.DEMAND + Demand.POWER + drive, :]
        set_range(0.0, 0.0, power)
        add_range_product(
            1.0, reach[Reach.DEMAND + Demand.FORCE + drive, :],
            reach[Reach.DEMAND + Demand.VELOCITY + drive, :], power,
        )


def lead_velocities(crane: 'float[:]', reach: 'float[:,:]') -> None:
    """Put the setpoints in place of the drives' velocities: they lead by lag times acceleration."""
    for drive in range(3):
        add_range(
            crane[Resistance.LAG + drive], reach[Reach.DEMAND + Demand.ACCELERATION + drive, :],
            reach[Reach.DEMAND + Demand.VELOCITY + drive, :],
        )


def write_sway(reach: 'float[:,:]') -> None:
    """Write the sway angles: both change less than q_x and q_y do."""
    q_x = reach[Reach.SLOPE, :]
    q_y = reach[Reach.SLOPE + 1, :]
    across = q_x[Range.CENTRE] / sqrt(1.0 + q_y[Range.CENTRE] * q_y[Range.CENTRE])
    most = abs(q_x[Range.CENTRE]) + q_x[Range.RADIUS]
    set_range(
        -atan(across), q_x[Range.RADIUS] + most * q_y[Range.RADIUS],
        reach[Reach.DEMAND + Demand.SWAY, :],
    )
    set_range(
        atan(q_y[Range.CENTRE]), q_y[Range.RADIUS], reach[Reach.DEMAND + Demand.SWAY + 1, :]
    )


def write_reach(
    begin: float, end: float, timing: 'float[:,:]', coefficients: 'float[:,:]', offsets: 'int[:]',
    crane: 'float[:]', work: 'float[:,:]',
) -> bool:
    """Write the ranges of all demands between two times [s] that no piece begins between.

    crane: `Resistance`, work: `OperationWork`. False if the rope may become slack.
    """
    write_load(begin, end, timing, coefficients, offsets, work)
    return write_demands(crane, work)


def write_demands(crane: 'float[:]', work: 'float[:,:]') -> bool:
    """`write_reach`, where the ranges of the load are written."""
    reach = work[OperationWork.REACH:OperationWork.SIZE, :]
    pull = reach[Reach.PULL, :]
    set_range(crane[Resistance.GRAVITY], 0.0, pull)
    add_range(1.0, reach[Reach.ACCELERATION + 2, :], pull)
    if not pull[Range.CENTRE] > pull[Range.RADIUS]:
        return False
    write_slope(0, reach)
    write_slope(1, reach)
    write_stretch(reach)
    for axis in range(2):
        write_drive(
            axis, 1.0, reach[Reach.SLOPE + axis, :], reach[Reach.SLOPE_RATE + axis, :],
            reach[Reach.SLOPE_CHANGE + axis, :], reach,
        )
    # the rope is -z f long
    write_drive(
        2, 0.0, reach[Reach.STRETCH, :], reach[Reach.STRETCH_RATE, :],
        reach[Reach.STRETCH_CHANGE, :], reach,
    )
    write_forces(crane, reach)
    lead_velocities(crane, reach)
    write_sway(reach)
    return True
