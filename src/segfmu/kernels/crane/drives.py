"""Forces on the crane in addition to gravity: drives with bounds, friction, wind.

`plant` is a `Plant`, `work` a `Work`, see crane/records.py.
"""

from math import cos, sin, tanh

from segfmu.kernels.crane._crane import crane_driven, crane_rhs
from segfmu.kernels.crane.records import (
    Action,
    Axes,
    ForceLimit,
    GeneralisedForce,
    GustShape,
    Plant,
    State,
    Work,
)
from segfmu.kernels.numerics.noise import full_circle
from segfmu.kernels.numerics.records import Sinusoid


def friction_force(plant: 'float[:]', axis: int, velocity: float) -> float:
    """Viscous and Coulomb friction and drag [N] against a velocity; the sign change is a tanh."""
    friction = plant[Plant.VISCOUS + axis] * velocity
    friction = friction + plant[Plant.DRAG + axis] * velocity * abs(velocity)
    if plant[Plant.COULOMB + axis] > 0.0:
        share = tanh(velocity / plant[Plant.FRICTION_WIDTH])
        friction = friction + plant[Plant.COULOMB + axis] * share
    return friction


def friction_slope(plant: 'float[:]', axis: int, velocity: float) -> float:
    """Derivative of the friction force of an axis by its velocity [N s/m]."""
    slope = plant[Plant.VISCOUS + axis] + 2.0 * plant[Plant.DRAG + axis] * abs(velocity)
    if plant[Plant.COULOMB + axis] > 0.0:
        width = plant[Plant.FRICTION_WIDTH]
        share = tanh(velocity / width)
        slope = slope + plant[Plant.COULOMB + axis] * (1.0 - share * share) / width
    return slope


def gust_factor(shape: float, share: float) -> float:
    """Force of a gust relative to its peak, at a share of its duration."""
    if share <= 0.0 or share >= 1.0:
        return 0.0
    if int(shape) == GustShape.SINE:
        return sin(0.5 * full_circle() * share)
    return 0.5 * (1.0 - cos(full_circle() * share))


def wind_force(
    plant: 'float[:]', components: 'float[:,:]', time: float, work: 'float[:,:]'
) -> None:
    """Force on the load [N]: the given one, constant wind, gust and noise."""
    gust = 0.0
    if plant[Plant.GUST_DURATION] > 0.0:
        share = (time - plant[Plant.GUST_START]) / plant[Plant.GUST_DURATION]
        gust = gust_factor(plant[Plant.GUST_SHAPE], share)
    force = work[Work.WIND, :]
    for i in range(3):
        steady = work[Work.LOAD_FORCE, i] + plant[Plant.WIND + i]
        force[i] = steady + gust * plant[Plant.GUST_FORCE + i]
    for k in range(components.shape[0]):
        sine = sin(components[k, Sinusoid.FREQUENCY] * time)
        cosine = cos(components[k, Sinusoid.FREQUENCY] * time)
        for i in range(3):
            added = force[i] + components[k, Sinusoid.SINE + i] * sine
            force[i] = added + components[k, Sinusoid.COSINE + i] * cosine


def exceeds(value: float, bound: float) -> bool:
    """Whether a magnitude exceeds a bound by more than rounding; 0 is no bound."""
    return bound > 0.0 and abs(value) > bound * (1.0 + 1e-12)


def limited(value: float, bound: float) -> float:
    """A value, limited to plus and minus a bound."""
    return min(max(value, -bound), bound)


def forced_derivative(
    plant: 'float[:]', state: 'float[:]', work: 'float[:,:]', derivative: 'float[:]'
) -> None:
    """Derivative of the crane under force demands; see `driven_derivative`."""
    force = work[Work.GENERALISED, :]
    action = work[Work.ACTION, :]
    for i in range(3):
        drive = work[Work.DEMAND, i]
        if exceeds(drive, plant[Plant.FORCE_MAX + i]):
            drive = limited(drive, plant[Plant.FORCE_MAX + i])
            action[Action.SATURATED + i] = 1.0
        action[Action.FORCE + i] = drive
        force[i] = drive - work[Work.FRICTION, i]
    action[Action.ROPE_FORCE] = force[GeneralisedForce.FORCE + Axes.ROPE]
    crane_rhs(state, force, work[Work.WIND, :], plant, derivative)


def driven_derivative(
    plant: 'float[:]', state: 'float[:]', work: 'float[:,:]', derivative: 'float[:]'
) -> None:
    """Derivative of the crane under velocity demands, without lag acceleration demands.

    work contains the demands, the torques on the sway angles, wind and friction; the forces and
    accelerations that act are written to it.
    """
    action = work[Work.ACTION, :]
    for i in range(3):
        demand = work[Work.DEMAND, i]
        if plant[Plant.LAG + i] > 0.0:
            demand = (demand - state[State.VELOCITY + i]) / plant[Plant.LAG + i]
        if exceeds(demand, plant[Plant.ACCELERATION_MAX + i]):
            demand = limited(demand, plant[Plant.ACCELERATION_MAX + i])
            action[Action.SATURATED + i] = 1.0
        work[Work.DEMAND, i] = demand
    driven_forces(plant, state, work, derivative)
    for i in range(3):
        if exceeds(action[Action.FORCE + i], plant[Plant.FORCE_MAX + i]):
            limit_accelerations(
                plant, state, action, work[Work.DEMAND, :], work[Work.LIMIT, :]
            )
            driven_forces(plant, state, work, derivative)
            break


def driven_forces(
    plant: 'float[:]', state: 'float[:]', work: 'float[:,:]', derivative: 'float[:]'
) -> None:
    """Derivative and drive forces under the accelerations demanded."""
    action = work[Work.ACTION, :]
    crane_driven(
        state, work[Work.DEMAND, :], work[Work.GENERALISED, :], work[Work.WIND, :], plant,
        derivative, action,
    )
    action[Action.ROPE_FORCE] = action[Action.FORCE + Axes.ROPE]
    for i in range(3):
        action[Action.FORCE + i] = action[Action.FORCE + i] + work[Work.FRICTION, i]


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
    phi_x = state[State.ANGLE]
    phi_y = state[State.ANGLE + 1]
    limit[ForceLimit.ROPE] = sin(phi_x)
    limit[ForceLimit.ROPE + Axes.TROLLEY] = -cos(phi_x) * sin(phi_y)
    limit[ForceLimit.ROPE + Axes.ROPE] = 1.0
    for i in range(3):
        limit[ForceLimit.SIDE + i] = 0.0
        limit[ForceLimit.CHANGE + i] = 0.0
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
    needed = needed + plant[Plant.PAYLOAD_MASS] * limit[ForceLimit.ROPE + axis] * along
    if not exceeds(needed, plant[Plant.FORCE_MAX + axis]):
        return 0.0
    if needed > 0.0:
        return 1.0
    return -1.0


def missing_force(plant: 'float[:]', axis: int, action: 'float[:]', limit: 'float[:]') -> float:
    """Difference [N] from a drive's demanded force to the bound on its side."""
    bound = limit[ForceLimit.SIDE + axis] * plant[Plant.FORCE_MAX + axis]
    return bound - action[Action.FORCE + axis]


def change_accelerations(plant: 'float[:]', action: 'float[:]', limit: 'float[:]') -> None:
    """Acceleration changes that bring the drives with a side to their bounds; 0 for the others.

    Forces change by (M + m e e') times the changes, with the carriages' masses M, the load's mass m
    and the rope's direction e: the load resists only along the rope.
    """
    payload = plant[Plant.PAYLOAD_MASS]
    total = 0.0
    weight = 1.0
    for i in range(2):
        if limit[ForceLimit.SIDE + i] != 0.0:
            missing = missing_force(plant, i, action, limit)
            mass = carriage_mass(plant, i)
            rope = limit[ForceLimit.ROPE + i]
            total = total + rope * missing / mass
            weight = weight + payload * rope * rope / mass
    along = total / weight
    hoist_limited = limit[ForceLimit.SIDE + Axes.ROPE] != 0.0
    if hoist_limited:
        along = missing_force(plant, Axes.ROPE, action, limit) / payload
    rest = along
    for i in range(2):
        limit[ForceLimit.CHANGE + i] = 0.0
        if limit[ForceLimit.SIDE + i] != 0.0:
            missing = missing_force(plant, i, action, limit)
            missing = missing - payload * limit[ForceLimit.ROPE + i] * along
            limit[ForceLimit.CHANGE + i] = missing / carriage_mass(plant, i)
        rest = rest - limit[ForceLimit.ROPE + i] * limit[ForceLimit.CHANGE + i]
    limit[ForceLimit.CHANGE + Axes.ROPE] = 0.0
    if hoist_limited:
        limit[ForceLimit.CHANGE + Axes.ROPE] = rest
