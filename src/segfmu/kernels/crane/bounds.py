"""Drives at their bounds: largest forces and velocities.

Forces of the drives depend on their accelerations by (M + m e e'), with the carriages' masses M,
the load's mass m and the rope's direction e: the load resists only along the rope, and what
is above it with what it has of the load's mass there. `plant` is a `Plant`, `limit` a
`ForceLimit`, see crane/records.py.
"""

from math import cos, sin

from segfmu.kernels.crane.records import (
    Action,
    Axes,
    ForceLimit,
    Plant,
    Resistance,
    State,
)
from segfmu.kernels.crane.suspension import suspended_mass


def side_bound(sign: float, greatest: float, least: float) -> float:
    """Magnitude of the bound in the direction of a sign; 0: no bound.

    greatest: of positive values, 0: none; least: of negative ones, below 0, or 0: as the other.
    """
    if sign < 0.0 and least < 0.0:
        return -least
    return greatest


def exceeds(value: float, bound: float) -> bool:
    """Whether a magnitude exceeds a bound by more than rounding; 0 is no bound."""
    return bound > 0.0 and abs(value) > bound * (1.0 + 1e-12)


def limited(value: float, bound: float) -> float:
    """A value, limited to plus and minus a bound."""
    return min(max(value, -bound), bound)


def velocity_bound(plant: 'float[:]', axis: int, sign: float) -> float:
    """Largest speed [m/s] of a drive in the direction of a sign; 0: no bound."""
    return side_bound(sign, plant[Plant.VELOCITY_MAX + axis], plant[Plant.VELOCITY_MIN + axis])


def acceleration_bound(plant: 'float[:]', axis: int, sign: float) -> float:
    """Largest acceleration [m/s2] of a velocity drive in the direction of a sign; 0: no bound."""
    return side_bound(
        sign, plant[Plant.ACCELERATION_MAX + axis], plant[Plant.ACCELERATION_MIN + axis]
    )


def static_bound(plant: 'float[:]', axis: int, sign: float) -> float:
    """Largest force [N] of a drive at rest in the direction of a sign; 0: no bound."""
    return side_bound(sign, plant[Plant.FORCE_MAX + axis], plant[Plant.FORCE_MIN + axis])


def force_bound(plant: 'float[:]', axis: int, sign: float, velocity: float) -> float:
    """Largest force [N] of a drive in the direction of a sign, at a velocity [m/s]; 0: no bound.

    Power bounds hold for driving and braking: in the field-weakening range the force that a motor
    has falls with its speed in both directions, and a converter that feeds back is sized alike.
    """
    bound = static_bound(plant, axis, sign)
    if plant[Plant.POWER_MAX + axis] > 0.0:
        speed = max(abs(velocity), 1e-99)
        by_power = plant[Plant.POWER_MAX + axis] / speed
        if bound == 0.0 or by_power < bound:
            bound = by_power
    return bound


def rope_direction(plant: 'float[:]', state: 'float[:]', limit: 'float[:]') -> None:
    """Write the direction of the rope in the coordinates of the drives, and what resists there."""
    limit[ForceLimit.MASS] = suspended_mass(plant, state)
    phi_x = state[State.ANGLE]
    phi_y = state[State.ANGLE + 1]
    limit[ForceLimit.ROPE] = sin(phi_x)
    limit[ForceLimit.ROPE + Axes.TROLLEY] = -cos(phi_x) * sin(phi_y)
    limit[ForceLimit.ROPE + Axes.ROPE] = 1.0


def limit_accelerations(
    plant: 'float[:]',
    state: 'float[:]',
    action: 'float[:]',
    acceleration: 'float[:]',
    limit: 'float[:]',
) -> None:
    """Reduce accelerations until no drive needs more than its largest force.

    A drive either meets its demand, or it is at its bound and lags behind: a complementarity
    problem in three unknowns with a positive definite matrix, solved by K. G. Murty's least-index
    pivoting (Linear Algebra and its Applications 7, 1974). action: an `Action` with the demanded
    forces; its flags are set for drives at their bound. limit: a `ForceLimit`.
    """
    rope_direction(plant, state, limit)
    for i in range(3):
        limit[ForceLimit.SIDE + i] = 0.0
        limit[ForceLimit.CHANGE + i] = 0.0
        velocity = state[State.VELOCITY + i]
        limit[ForceLimit.BOUND + i] = force_bound(plant, i, 1.0, velocity)
        limit[ForceLimit.LOWER + i] = force_bound(plant, i, -1.0, velocity)
    for _ in range(16):
        changed = False
        for i in range(3):
            if not changed:
                side = limit_side(plant, i, action, limit)
                changed = side != limit[ForceLimit.SIDE + i]
                limit[ForceLimit.SIDE + i] = side
        if not changed:
            break
        change_accelerations(plant, action, limit)
    for i in range(3):
        acceleration[i] = acceleration[i] + limit[ForceLimit.CHANGE + i]
        if limit[ForceLimit.SIDE + i] != 0.0:
            action[Action.SATURATED + i] = 1.0


def carriage_mass(masses: 'float[:]', axis: int) -> float:
    """Mass [kg] that a drive moves in addition to the load."""
    if axis == Axes.BRIDGE:
        return masses[Plant.BRIDGE_MASS] + masses[Plant.TROLLEY_MASS]
    if axis == Axes.TROLLEY:
        return masses[Plant.TROLLEY_MASS]
    return 0.0


def hanging_mass(resistance: 'float[:]') -> float:
    """Mass [kg] that hangs on the rope."""
    return resistance[Resistance.PAYLOAD_MASS] + resistance[Resistance.TACKLE_MASS]


def limit_side(plant: 'float[:]', axis: int, action: 'float[:]', limit: 'float[:]') -> float:
    """The bound at which a drive must be for the present changes: -1, 1, or 0 for none."""
    side = limit[ForceLimit.SIDE + axis]
    change = limit[ForceLimit.CHANGE + axis]
    if side != 0.0:
        # it may only lag behind its demand
        if side * change > 0.0:
            return 0.0
        return side
    along = 0.0
    for i in range(3):
        along = along + limit[ForceLimit.ROPE + i] * limit[ForceLimit.CHANGE + i]
    needed = action[Action.FORCE + axis] + carriage_mass(plant, axis) * change
    needed = needed + limit[ForceLimit.MASS] * limit[ForceLimit.ROPE + axis] * along
    if needed > 0.0:
        side = 1.0
    else:
        side = -1.0
    if not exceeds(needed, available_force(axis, side, limit)):
        return 0.0
    return side


def available_force(axis: int, side: float, limit: 'float[:]') -> float:
    """Magnitude [N] of the largest force of a drive on a side; 0: no bound."""
    if side < 0.0:
        return limit[ForceLimit.LOWER + axis]
    return limit[ForceLimit.BOUND + axis]


def missing_force(axis: int, action: 'float[:]', limit: 'float[:]') -> float:
    """Difference [N] from a drive's demanded force to the bound on its side."""
    side = limit[ForceLimit.SIDE + axis]
    bound = side * available_force(axis, side, limit)
    return bound - action[Action.FORCE + axis]


def change_accelerations(plant: 'float[:]', action: 'float[:]', limit: 'float[:]') -> None:
    """Acceleration changes that bring the drives with a side to their bounds; 0 for the others.

    Forces change by (M + m e e') times the changes, with the carriages' masses M, the load's mass m
    and the rope's direction e: the load resists only along the rope.
    """
    payload = limit[ForceLimit.MASS]
    total = 0.0
    weight = 1.0
    for i in range(2):
        if limit[ForceLimit.SIDE + i] != 0.0:
            missing = missing_force(i, action, limit)
            mass = carriage_mass(plant, i)
            rope = limit[ForceLimit.ROPE + i]
            total = total + rope * missing / mass
            weight = weight + payload * rope * rope / mass
    along = total / weight
    hoist_limited = limit[ForceLimit.SIDE + Axes.ROPE] != 0.0
    if hoist_limited:
        along = missing_force(Axes.ROPE, action, limit) / payload
    rest = along
    for i in range(2):
        limit[ForceLimit.CHANGE + i] = 0.0
        if limit[ForceLimit.SIDE + i] != 0.0:
            missing = missing_force(i, action, limit)
            missing = missing - payload * limit[ForceLimit.ROPE + i] * along
            limit[ForceLimit.CHANGE + i] = missing / carriage_mass(plant, i)
        rest = rest - limit[ForceLimit.ROPE + i] * limit[ForceLimit.CHANGE + i]
    limit[ForceLimit.CHANGE + Axes.ROPE] = 0.0
    if hoist_limited:
        limit[ForceLimit.CHANGE + Axes.ROPE] = rest


def at_velocity_bound(plant: 'float[:]', axis: int, state: 'float[:]') -> bool:
    """Whether a drive has its largest velocity in its direction."""
    velocity = state[State.VELOCITY + axis]
    bound = velocity_bound(plant, axis, velocity)
    return bound > 0.0 and abs(velocity) >= bound


def hold_velocities(
    plant: 'float[:]', state: 'float[:]', derivative: 'float[:]', action: 'float[:]',
    limit: 'float[:]',
) -> None:
    """Change forces until no drive at its largest velocity is accelerated further.

    There a drive's speed control takes over: it either applies its demand, or what holds its
    velocity, if it is less; a complementarity problem as that of `limit_accelerations`. A force
    beyond its bound is not available, and the drive becomes faster. action: an `Action` with the
    demanded forces, which change; derivative: that of the state under them.
    """
    rope_direction(plant, state, limit)
    for i in range(3):
        limit[ForceLimit.SIDE + i] = 0.0
        limit[ForceLimit.CHANGE + i] = 0.0
        limit[ForceLimit.ADDED + i] = 0.0
    for _ in range(16):
        changed = False
        for i in range(3):
            if not changed and at_velocity_bound(plant, i, state):
                side = held_side(i, state, derivative, limit)
                changed = side != limit[ForceLimit.SIDE + i]
                limit[ForceLimit.SIDE + i] = side
        if not changed:
            break
        hold_accelerations(plant, derivative, limit)
    for i in range(3):
        if limit[ForceLimit.SIDE + i] != 0.0:
            force = action[Action.FORCE + i] + limit[ForceLimit.ADDED + i]
            bound = force_bound(plant, i, force, state[State.VELOCITY + i])
            if exceeds(force, bound):
                force = limited(force, bound)
            action[Action.FORCE + i] = force
            action[Action.SATURATED + i] = 1.0


def held_side(axis: int, state: 'float[:]', derivative: 'float[:]', limit: 'float[:]') -> float:
    """Whether a drive at its largest velocity must be held: its direction, or 0."""
    side = 1.0
    if state[State.VELOCITY + axis] < 0.0:
        side = -1.0
    if limit[ForceLimit.SIDE + axis] != 0.0:
        # it must not be pushed on
        if side * limit[ForceLimit.ADDED + axis] > 0.0:
            return 0.0
        return side
    if side * (derivative[State.VELOCITY + axis] + limit[ForceLimit.CHANGE + axis]) > 0.0:
        return side
    return 0.0


def hold_accelerations(plant: 'float[:]', derivative: 'float[:]', limit: 'float[:]') -> None:
    """Changes that bring the accelerations of the held drives to 0, and the forces for them."""
    payload = limit[ForceLimit.MASS]
    along = 0.0
    weight = 1.0
    for i in range(3):
        rope = limit[ForceLimit.ROPE + i]
        limit[ForceLimit.CHANGE + i] = 0.0
        if limit[ForceLimit.SIDE + i] != 0.0:
            limit[ForceLimit.CHANGE + i] = -derivative[State.VELOCITY + i]
            along = along + rope * limit[ForceLimit.CHANGE + i]
        elif i != Axes.ROPE:
            weight = weight + payload * rope * rope / carriage_mass(plant, i)
    if limit[ForceLimit.SIDE + Axes.ROPE] == 0.0:
        # the rope gives way
        limit[ForceLimit.CHANGE + Axes.ROPE] = -along
        along = 0.0
    along = along / weight
    for i in range(3):
        mass = carriage_mass(plant, i)
        pull = payload * limit[ForceLimit.ROPE + i] * along
        limit[ForceLimit.ADDED + i] = 0.0
        if limit[ForceLimit.SIDE + i] != 0.0:
            limit[ForceLimit.ADDED + i] = mass * limit[ForceLimit.CHANGE + i] + pull
        elif i != Axes.ROPE:
            limit[ForceLimit.CHANGE + i] = -pull / mass
