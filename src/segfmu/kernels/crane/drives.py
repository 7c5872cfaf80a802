"""Forces on the crane in addition to gravity: drives, friction, wind.

`plant` is a `Plant`, `work` a `Work`, see crane/records.py.
"""

from math import cos, sin

from segfmu.kernels.crane._crane import crane_driven, crane_rhs
from segfmu.kernels.crane.bounds import (
    at_velocity_bound,
    exceeds,
    force_bound,
    hold_velocities,
    limit_accelerations,
    limited,
)
from segfmu.kernels.crane.records import (
    Action,
    Axes,
    GeneralisedForce,
    GustShape,
    Plant,
    State,
    Work,
)
from segfmu.kernels.numerics.noise import full_circle
from segfmu.kernels.numerics.records import Sinusoid


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


def forced_derivative(
    plant: 'float[:]', state: 'float[:]', work: 'float[:,:]', derivative: 'float[:]'
) -> None:
    """Derivative of the crane under force demands; see `driven_derivative`."""
    force = work[Work.GENERALISED, :]
    action = work[Work.ACTION, :]
    fast = False
    for i in range(3):
        drive = work[Work.DEMAND, i]
        bound = force_bound(plant, i, state[State.VELOCITY + i])
        if exceeds(drive, bound):
            drive = limited(drive, bound)
            action[Action.SATURATED + i] = 1.0
        fast = fast or at_velocity_bound(plant, i, state)
        action[Action.FORCE + i] = drive
        force[i] = drive - work[Work.FRICTION, i]
    crane_rhs(state, force, work[Work.WIND, :], plant, derivative)
    if fast:
        hold_velocities(plant, state, derivative, action, work[Work.LIMIT, :])
        for i in range(3):
            force[i] = action[Action.FORCE + i] - work[Work.FRICTION, i]
        crane_rhs(state, force, work[Work.WIND, :], plant, derivative)
    action[Action.ROPE_FORCE] = force[GeneralisedForce.FORCE + Axes.ROPE]


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
            if exceeds(demand, plant[Plant.VELOCITY_MAX + i]):
                demand = limited(demand, plant[Plant.VELOCITY_MAX + i])
                action[Action.SATURATED + i] = 1.0
            demand = (demand - state[State.VELOCITY + i]) / plant[Plant.LAG + i]
        if exceeds(demand, plant[Plant.ACCELERATION_MAX + i]):
            demand = limited(demand, plant[Plant.ACCELERATION_MAX + i])
            action[Action.SATURATED + i] = 1.0
        work[Work.DEMAND, i] = demand
    driven_forces(plant, state, work, derivative)
    for i in range(3):
        bound = force_bound(plant, i, state[State.VELOCITY + i])
        if exceeds(action[Action.FORCE + i], bound):
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
