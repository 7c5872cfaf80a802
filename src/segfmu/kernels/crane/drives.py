"""What acts on the crane beside gravity: drives with bounds, friction, wind.

`parameters` is the array that kernels/crane/plant.py describes.
"""

from math import cos, sin, tanh

from segfmu.kernels.crane._crane import crane_driven, crane_rhs
from segfmu.kernels.numerics.noise import full_circle


def friction_force(parameters: 'float[:]', axis: int, velocity: float) -> float:
    """Viscous and Coulomb friction against a velocity; the sign change is a tanh."""
    friction = parameters[14 + axis] * velocity
    if parameters[17 + axis] > 0.0:
        friction = friction + parameters[17 + axis] * tanh(velocity / parameters[20])
    return friction


def gust_share(shape: float, share: float) -> float:
    """Course of a gust over its duration: 1 - cosine, or half a sine; both rise to 1."""
    if share <= 0.0 or share >= 1.0:
        return 0.0
    if shape > 0.5:
        return sin(0.5 * full_circle() * share)
    return 0.5 * (1.0 - cos(full_circle() * share))


def wind_force(
    parameters: 'float[:]',
    components: 'float[:,:]',
    time: float,
    load_force: 'float[:]',
    force: 'float[:]',
) -> None:
    """Force on the load: the given one, constant wind, gust and noise."""
    gust = 0.0
    if parameters[32] > 0.0:
        gust = gust_share(parameters[33], (time - parameters[31]) / parameters[32])
    for i in range(3):
        force[i] = load_force[i] + parameters[28 + i] + gust * parameters[34 + i]
    for k in range(components.shape[0]):
        sine = sin(components[k, 0] * time)
        cosine = cos(components[k, 0] * time)
        for i in range(3):
            force[i] = force[i] + components[k, 1 + i] * sine + components[k, 4 + i] * cosine


def beyond(value: float, bound: float) -> bool:
    """Whether a magnitude is above a bound by more than rounding; 0 is no bound."""
    return bound > 0.0 and abs(value) > bound * (1.0 + 1e-12)


def clamped(value: float, bound: float) -> float:
    """A value within plus and minus a bound."""
    return min(max(value, -bound), bound)


def forced_derivative(
    parameters: 'float[:]', state: 'float[:]', work: 'float[:,:]', derivative: 'float[:]'
) -> None:
    """Derivative of the crane under the force commands of work[14, :3]; see `driven_derivative`."""
    for i in range(3):
        drive = work[14, i]
        if beyond(drive, parameters[8 + i]):
            drive = clamped(drive, parameters[8 + i])
            work[10, 3 + i] = 1.0
        work[10, i] = drive
        work[9, i] = drive - work[15, i]
    work[10, 6] = work[9, 2]
    crane_rhs(
        state, work[9, :], work[11, :], parameters[0], parameters[1], parameters[2],
        parameters[3], derivative,
    )


def driven_derivative(
    parameters: 'float[:]', state: 'float[:]', work: 'float[:,:]', derivative: 'float[:]'
) -> None:
    """Derivative of the crane under the velocity commands of work[14, :3].

    Without lag the commands are accelerations. work[9, 3:5]: torques on the sway angles, work[11]:
    force on the load, work[15, :3]: friction. Results beside the derivative are work[10]: forces
    of the drives (3), whether they are at a bound (3), and the force on the rope.
    """
    for i in range(3):
        demand = work[14, i]
        if parameters[5 + i] > 0.0:
            demand = (demand - state[5 + i]) / parameters[5 + i]
        if beyond(demand, parameters[11 + i]):
            demand = clamped(demand, parameters[11 + i])
            work[10, 3 + i] = 1.0
        work[14, i] = demand
    driven_forces(parameters, state, work, derivative)
    for i in range(3):
        if beyond(work[10, i], parameters[8 + i]):
            limit_accelerations(parameters, state, work[10, :], work[14, :], work[15, :])
            driven_forces(parameters, state, work, derivative)
            break


def driven_forces(
    parameters: 'float[:]', state: 'float[:]', work: 'float[:,:]', derivative: 'float[:]'
) -> None:
    """Derivative and drive forces under the accelerations of work[14, :3]."""
    crane_driven(
        state, work[14, :], work[9, :], work[11, :], parameters[0], parameters[1], parameters[2],
        parameters[3], derivative, work[10, :],
    )
    work[10, 6] = work[10, 2]
    for i in range(3):
        work[10, i] = work[10, i] + work[15, i]


def limit_accelerations(
    parameters: 'float[:]',
    state: 'float[:]',
    force: 'float[:]',
    acceleration: 'float[:]',
    scratch: 'float[:]',
) -> None:
    """Reduce accelerations until no drive needs more than its largest force.

    A drive is at its bound and lags behind its demand, or it has its demand: a complementarity
    problem in three unknowns with a positive definite matrix, solved by K. G. Murty's least-index
    pivoting (Linear Algebra and its Applications 7, 1974). force (6): what the demand needs, and
    flags that are set where the bound acts. In scratch, 3:6 are the sides (-1, 0, 1), 6:9 the
    changes of the accelerations, 9:12 the rope's direction in the drives' coordinates.
    """
    scratch[9] = sin(state[3])
    scratch[10] = -cos(state[3]) * sin(state[4])
    scratch[11] = 1.0
    for i in range(3):
        scratch[3 + i] = 0.0
        scratch[6 + i] = 0.0
    for _ in range(16):
        changed = False
        for i in range(3):
            if not changed:
                side = limit_side(parameters, i, force, scratch)
                changed = side != scratch[3 + i]
                scratch[3 + i] = side
        if not changed:
            break
        change_accelerations(parameters, force, scratch)
    for i in range(3):
        acceleration[i] = acceleration[i] + scratch[6 + i]
        if scratch[3 + i] != 0.0:
            force[3 + i] = 1.0


def carriage_mass(parameters: 'float[:]', axis: int) -> float:
    """Mass that a drive moves beside the load."""
    if axis == 0:
        return parameters[0] + parameters[1]
    if axis == 1:
        return parameters[1]
    return 0.0


def limit_side(parameters: 'float[:]', axis: int, force: 'float[:]', scratch: 'float[:]') -> float:
    """At which bound a drive has to be under the changes found so far: -1, 0 or 1."""
    if scratch[3 + axis] != 0.0:
        # it may only lag behind what was demanded of it
        if scratch[3 + axis] * scratch[6 + axis] > 0.0:
            return 0.0
        return scratch[3 + axis]
    along = 0.0
    for i in range(3):
        along = along + scratch[9 + i] * scratch[6 + i]
    needed = force[axis] + carriage_mass(parameters, axis) * scratch[6 + axis]
    needed = needed + parameters[2] * scratch[9 + axis] * along
    if not beyond(needed, parameters[8 + axis]):
        return 0.0
    if needed > 0.0:
        return 1.0
    return -1.0


def change_accelerations(
    parameters: 'float[:]', force: 'float[:]', scratch: 'float[:]'
) -> None:
    """Changes that bring the drives with a side to their bounds and leave the others alone.

    Forces change by (M + m e e') times the changes: M are the carriages' masses, m the load's,
    and e is the rope's direction, as the load resists along the rope alone.
    """
    payload = parameters[2]
    total = 0.0
    weight = 1.0
    for i in range(2):
        if scratch[3 + i] != 0.0:
            missing = scratch[3 + i] * parameters[8 + i] - force[i]
            mass = carriage_mass(parameters, i)
            total = total + scratch[9 + i] * missing / mass
            weight = weight + payload * scratch[9 + i] * scratch[9 + i] / mass
    along = total / weight
    if scratch[5] != 0.0:
        along = (scratch[5] * parameters[10] - force[2]) / payload
    rest = along
    for i in range(2):
        scratch[6 + i] = 0.0
        if scratch[3 + i] != 0.0:
            missing = scratch[3 + i] * parameters[8 + i] - force[i]
            missing = missing - payload * scratch[9 + i] * along
            scratch[6 + i] = missing / carriage_mass(parameters, i)
        rest = rest - scratch[9 + i] * scratch[6 + i]
    scratch[8] = 0.0
    if scratch[5] != 0.0:
        scratch[8] = rest
