"""Friction of the axes: viscous, drag, and dry friction that sticks.

Dry friction is that of a contact which deflects by micrometres before it slides, an elastic and
perfectly plastic element (L. Prandtl 1928; P. Dupont et al., Single state elastoplastic friction
models, IEEE Trans. Automat. Contr. 47, 2002). Below the static friction the deflection alone
carries the force: a loaded axis stays where it is for ever, and nothing drifts. While it slides,
the deflection rests at its bound, so that fast motion is not stiff. `plant` is a `Plant`.
"""

from math import exp, sqrt

from segfmu.kernels.crane.bounds import carriage_mass
from segfmu.kernels.crane.records import Axes, Plant


def dry_level(plant: 'float[:]', axis: int, velocity: float) -> float:
    """Dry friction [N] at a velocity: from static to Coulomb friction (R. Stribeck 1902)."""
    coulomb = plant[Plant.COULOMB + axis]
    if plant[Plant.STATIC + axis] <= coulomb:
        return coulomb
    ratio = velocity / plant[Plant.FRICTION_WIDTH]
    return coulomb + (plant[Plant.STATIC + axis] - coulomb) * exp(-ratio * ratio)


def level_slope(plant: 'float[:]', axis: int, velocity: float) -> float:
    """Derivative of the dry friction by the velocity [N s/m]."""
    coulomb = plant[Plant.COULOMB + axis]
    if plant[Plant.STATIC + axis] <= coulomb:
        return 0.0
    width = plant[Plant.FRICTION_WIDTH]
    return -2.0 * velocity / (width * width) * (dry_level(plant, axis, velocity) - coulomb)


def rubs(plant: 'float[:]', axis: int) -> bool:
    """Whether an axis has dry friction."""
    return plant[Plant.COULOMB + axis] > 0.0 or plant[Plant.STATIC + axis] > 0.0


def deflected(plant: 'float[:]', deflection: float) -> float:
    """Deflection of a contact over that at which it slides, -1 to 1."""
    return min(max(deflection / plant[Plant.PRESLIDING], -1.0), 1.0)


def contact_damping(plant: 'float[:]', axis: int) -> float:
    """Damping [N s/m] that lets a mass come to rest in its contact without a swing."""
    mass = carriage_mass(plant, axis)
    if axis == Axes.ROPE:
        mass = plant[Plant.PAYLOAD_MASS]
    static = max(plant[Plant.STATIC + axis], plant[Plant.COULOMB + axis])
    return 2.0 * sqrt(1.5 * static * mass / plant[Plant.PRESLIDING])


def friction_force(
    plant: 'float[:]', axis: int, velocity: float, deflection: float
) -> float:
    """Friction [N] against a velocity [m/s], with the deflection [m] of the contact."""
    friction = plant[Plant.VISCOUS + axis] * velocity
    friction = friction + plant[Plant.DRAG + axis] * velocity * abs(velocity)
    if rubs(plant, axis):
        level = dry_level(plant, axis, velocity)
        share = deflected(plant, deflection)
        friction = friction + level * 0.5 * share * (3.0 - share * share)
        # damped within the contact, by at most the friction itself
        damped = contact_damping(plant, axis) * velocity / level
        damped = damped / sqrt(1.0 + damped * damped)
        friction = friction + level * damped * (1.0 - share * share)
    return friction


def friction_slopes(
    plant: 'float[:]', axis: int, velocity: float, deflection: float
) -> 'tuple[float, float]':
    """Derivatives of the friction by velocity [N s/m] and deflection [N/m]."""
    by_velocity = plant[Plant.VISCOUS + axis] + 2.0 * plant[Plant.DRAG + axis] * abs(velocity)
    if not rubs(plant, axis):
        return by_velocity, 0.0
    level = dry_level(plant, axis, velocity)
    slope = level_slope(plant, axis, velocity)
    share = deflected(plant, deflection)
    rest = 1.0 - share * share
    damping = contact_damping(plant, axis)
    damped = damping * velocity / level
    root = sqrt(1.0 + damped * damped)
    by_velocity = by_velocity + slope * 0.5 * share * (3.0 - share * share)
    # level * damped / root, whose ratio changes with the level
    changed = (damping - damped * slope) / (root * root * root)
    by_velocity = by_velocity + rest * (slope * damped / root + changed)
    if abs(share) >= 1.0:
        return by_velocity, 0.0
    by_share = level * (1.5 * rest - 2.0 * share * damped / root)
    return by_velocity, by_share / plant[Plant.PRESLIDING]


def deflection_rate(
    plant: 'float[:]', axis: int, velocity: float, deflection: float
) -> float:
    """Derivative of a deflection [m/s]: the velocity, but 0 where the contact slides."""
    if not rubs(plant, axis):
        return 0.0
    if abs(deflection) >= plant[Plant.PRESLIDING] and deflection * velocity >= 0.0:
        return 0.0
    return velocity


def first_deflection(plant: 'float[:]', axis: int, velocity: float) -> float:
    """Deflection [m] of a contact at the start: one that moves slides."""
    if not rubs(plant, axis):
        return 0.0
    share = velocity / plant[Plant.FRICTION_WIDTH]
    return plant[Plant.PRESLIDING] * min(max(share, -1.0), 1.0)
