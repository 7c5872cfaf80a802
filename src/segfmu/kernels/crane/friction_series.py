"""Time derivatives of the friction along a plan, in arithmetic with Taylor series."""

from segfmu.kernels.crane.contact import (
    find_contact,
    planned_deflection,
    release_rate,
    resists,
    stops,
)
from segfmu.kernels.crane.friction import contact_damping, rubs
from segfmu.kernels.crane.records import Contact, FrictionSeries, Resistance
from segfmu.kernels.numerics.series import (
    series_derivative,
    series_exponential,
    series_factorial,
    series_product,
    series_quotient,
    series_root,
)
from segfmu.kernels.trajectory.breaks import same_break


def friction_derivative(
    resistance: 'float[:]',
    axis: int,
    time: float,
    motion: 'float[:]',
    order: int,
    contacts: 'float[:,:]',
    work: 'float[:,:]',
) -> float:
    """A derivative of what `planned_friction` gives; where it jumps, that from then on.

    motion: position of the axis and its derivatives to `order` + 1; work: a `FrictionSeries` of at
    least `order` + 1 columns.
    """
    if time < 0.0 or not resists(resistance, axis):
        return 0.0
    count = order + 1
    friction = work[FrictionSeries.FRICTION, :]
    velocity = work[FrictionSeries.VELOCITY, :]
    share_series(resistance, time, motion, order, contacts, work)
    side = 0.0
    for i in range(count):
        if side == 0.0 and velocity[i] != 0.0:
            side = velocity[i] / abs(velocity[i])
    square = work[FrictionSeries.PRODUCT, :]
    series_product(velocity, velocity, count, square)
    for i in range(count):
        friction[i] = resistance[Resistance.VISCOUS + axis] * velocity[i]
        friction[i] = friction[i] + side * resistance[Resistance.DRAG + axis] * square[i]
    if rubs(resistance, axis):
        later = time + same_break(time)
        level_series(resistance, axis, count, work)
        if stops(later, contacts, find_contact(later, contacts)):
            for i in range(count):
                work[FrictionSeries.LEVEL, i] = 0.0
            work[FrictionSeries.LEVEL, 0] = resistance[Resistance.COULOMB + axis]
        if work[FrictionSeries.LEVEL, 0] > 0.0:
            add_dry_series(resistance, axis, count, work)
    return series_derivative(friction, order)


def share_series(
    resistance: 'float[:]',
    time: float,
    motion: 'float[:]',
    order: int,
    contacts: 'float[:,:]',
    work: 'float[:,:]',
) -> None:
    """Velocity of an axis and share of its deflection, as series."""
    share = work[FrictionSeries.SHARE, :]
    velocity = work[FrictionSeries.VELOCITY, :]
    later = time + same_break(time)
    row = find_contact(later, contacts)
    most = resistance[Resistance.PRESLIDING]
    for i in range(order + 1):
        velocity[i] = motion[i + 1] / series_factorial(i)
    released = contacts[row, Contact.RELEASED]
    if released > 0.0:
        first = contacts[row, Contact.DEFLECTION]
        for i in range(order + 1):
            velocity[i] = 0.0
        if later < contacts[row, Contact.SLIDES]:
            at = (later - contacts[row, Contact.TIME]) / released
            velocity[0] = release_rate(later, contacts, row)
            if order > 0:
                velocity[1] = -6.0 * first * (1.0 - 2.0 * at) / (released * released)
            if order > 1:
                velocity[2] = 6.0 * first / (released * released * released)
    share[0] = planned_deflection(resistance, later, motion[0], contacts, row) / most
    for i in range(order):
        share[i + 1] = velocity[i] / ((i + 1) * most)
        if released == 0.0 and later >= contacts[row, Contact.SLIDES]:
            share[i + 1] = 0.0


def add_dry_series(
    resistance: 'float[:]', axis: int, count: int, work: 'float[:,:]'
) -> None:
    """Add the dry friction to the series of the friction."""
    velocity = work[FrictionSeries.VELOCITY, :]
    share = work[FrictionSeries.SHARE, :]
    level = work[FrictionSeries.LEVEL, :]
    rest = work[FrictionSeries.REST, :]
    damped = work[FrictionSeries.DAMPED, :]
    first = work[FrictionSeries.PRODUCT, :]
    second = work[FrictionSeries.PRODUCT + 1, :]
    third = work[FrictionSeries.PRODUCT + 2, :]
    friction = work[FrictionSeries.FRICTION, :]
    # damping of the contact over its level: D v / sqrt(level^2 + (D v)^2)
    damping = contact_damping(resistance, axis)
    series_product(velocity, velocity, count, first)
    series_product(level, level, count, second)
    for i in range(count):
        first[i] = second[i] + damping * damping * first[i]
        second[i] = damping * velocity[i]
    series_root(first, count, third)
    series_quotient(second, third, count, damped)
    series_product(share, share, count, first)
    for i in range(count):
        rest[i] = -first[i]
        second[i] = -0.5 * first[i]
    rest[0] = rest[0] + 1.0
    second[0] = second[0] + 1.5
    series_product(share, second, count, first)
    series_product(damped, rest, count, second)
    for i in range(count):
        third[i] = first[i] + second[i]
    series_product(level, third, count, first)
    for i in range(count):
        friction[i] = friction[i] + first[i]


def level_series(
    resistance: 'float[:]', axis: int, count: int, work: 'float[:,:]'
) -> None:
    """Dry friction at the velocity, as a series."""
    velocity = work[FrictionSeries.VELOCITY, :]
    level = work[FrictionSeries.LEVEL, :]
    first = work[FrictionSeries.PRODUCT, :]
    coulomb = resistance[Resistance.COULOMB + axis]
    width = resistance[Resistance.FRICTION_WIDTH]
    series_product(velocity, velocity, count, first)
    for i in range(count):
        first[i] = -first[i] / (width * width)
    series_exponential(first, count, level)
    rise = max(resistance[Resistance.STATIC + axis] - coulomb, 0.0)
    for i in range(count):
        level[i] = rise * level[i]
    level[0] = level[0] + coulomb
