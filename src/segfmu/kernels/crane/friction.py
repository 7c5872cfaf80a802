"""Friction of the axes: viscous, drag, and dry friction that sticks.

Dry friction is that of a contact which deflects by micrometres before it slides, an elastic and
perfectly plastic element (L. Prandtl 1928; P. Dupont et al., Single state elastoplastic friction
models, IEEE Trans. Automat. Contr. 47, 2002). Below the static friction the deflection alone
carries the force: a loaded axis stays where it is for ever, and nothing drifts. While it slides,
the deflection rests at its bound, so that fast motion is not stiff. `resistance` is a
`Resistance`, or a `Plant`, which begins with one.
"""

from math import exp, sqrt

from segfmu.kernels.crane.bounds import carriage_mass, hanging_mass
from segfmu.kernels.crane.records import Axes, Resistance


def dry_level(resistance: 'float[:]', axis: int, velocity: float) -> float:
    """Dry friction [N] at a velocity: from static to Coulomb friction (R. Stribeck 1902)."""
    coulomb = resistance[Resistance.COULOMB + axis]
    if resistance[Resistance.STATIC + axis] <= coulomb:
        return coulomb
    ratio = velocity / resistance[Resistance.FRICTION_WIDTH]
    return coulomb + (resistance[Resistance.STATIC + axis] - coulomb) * exp(-ratio * ratio)


def level_slope(resistance: 'float[:]', axis: int, velocity: float) -> float:
    """Derivative of the dry friction by the velocity [N s/m]."""
    coulomb = resistance[Resistance.COULOMB + axis]
    if resistance[Resistance.STATIC + axis] <= coulomb:
        return 0.0
    width = resistance[Resistance.FRICTION_WIDTH]
    return -2.0 * velocity / (width * width) * (dry_level(resistance, axis, velocity) - coulomb)


def rubs(resistance: 'float[:]', axis: int) -> bool:
    """Whether an axis has dry friction."""
    return resistance[Resistance.COULOMB + axis] > 0.0 or resistance[Resistance.STATIC + axis] > 0.0


def deflected(resistance: 'float[:]', deflection: float) -> float:
    """Deflection of a contact over that at which it slides, -1 to 1."""
    return min(max(deflection / resistance[Resistance.PRESLIDING], -1.0), 1.0)


def contact_damping(resistance: 'float[:]', axis: int) -> float:
    """Damping [N s/m] that lets a mass come to rest in its contact without a swing."""
    mass = carriage_mass(resistance, axis)
    if axis == Axes.ROPE:
        mass = hanging_mass(resistance)
    static = max(resistance[Resistance.STATIC + axis], resistance[Resistance.COULOMB + axis])
    return 2.0 * sqrt(1.5 * static * mass / resistance[Resistance.PRESLIDING])


def dry_friction(
    resistance: 'float[:]', axis: int, level: float, velocity: float, deflection: float
) -> float:
    """Dry friction [N] of a contact that slides at a level [N]."""
    if level <= 0.0:
        return 0.0
    share = deflected(resistance, deflection)
    friction = level * 0.5 * share * (3.0 - share * share)
    # damped within the contact, by at most the friction itself
    damped = contact_damping(resistance, axis) * velocity / level
    damped = damped / sqrt(1.0 + damped * damped)
    return friction + level * damped * (1.0 - share * share)


def smooth_friction(resistance: 'float[:]', axis: int, velocity: float) -> float:
    """Viscous friction and drag [N]."""
    drag = resistance[Resistance.DRAG + axis]
    return resistance[Resistance.VISCOUS + axis] * velocity + drag * velocity * abs(velocity)


def friction_force(
    resistance: 'float[:]', axis: int, velocity: float, deflection: float
) -> float:
    """Friction [N] against a velocity [m/s], with the deflection [m] of the contact."""
    friction = smooth_friction(resistance, axis, velocity)
    if rubs(resistance, axis):
        level = dry_level(resistance, axis, velocity)
        friction = friction + dry_friction(resistance, axis, level, velocity, deflection)
    return friction


def friction_slopes(
    resistance: 'float[:]', axis: int, velocity: float, deflection: float
) -> 'tuple[float, float]':
    """Derivatives of the friction by velocity [N s/m] and deflection [N/m]."""
    drag = resistance[Resistance.DRAG + axis]
    by_velocity = resistance[Resistance.VISCOUS + axis] + 2.0 * drag * abs(velocity)
    if not rubs(resistance, axis):
        return by_velocity, 0.0
    level = dry_level(resistance, axis, velocity)
    if level <= 0.0:
        return by_velocity, 0.0
    slope = level_slope(resistance, axis, velocity)
    share = deflected(resistance, deflection)
    rest = 1.0 - share * share
    damping = contact_damping(resistance, axis)
    damped = damping * velocity / level
    root = sqrt(1.0 + damped * damped)
    by_velocity = by_velocity + slope * 0.5 * share * (3.0 - share * share)
    # level * damped / root, whose ratio changes with the level
    changed = (damping - damped * slope) / (root * root * root)
    by_velocity = by_velocity + rest * (slope * damped / root + changed)
    if abs(share) >= 1.0:
        return by_velocity, 0.0
    by_share = level * (1.5 * rest - 2.0 * share * damped / root)
    return by_velocity, by_share / resistance[Resistance.PRESLIDING]


def deflection_rate(
    resistance: 'float[:]', axis: int, velocity: float, deflection: float
) -> float:
    """Derivative of a deflection [m/s]: the velocity, but 0 where the contact slides."""
    if not rubs(resistance, axis):
        return 0.0
    if abs(deflection) >= resistance[Resistance.PRESLIDING] and deflection * velocity >= 0.0:
        return 0.0
    return velocity


def first_deflection(resistance: 'float[:]', axis: int, velocity: float) -> float:
    """Deflection [m] of a contact at the start: one that moves slides."""
    if not rubs(resistance, axis):
        return 0.0
    share = velocity / resistance[Resistance.FRICTION_WIDTH]
    return resistance[Resistance.PRESLIDING] * min(max(share, -1.0), 1.0)
