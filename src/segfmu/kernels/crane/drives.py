"""Forces on the crane in addition to gravity: drives and what resists them.

`plant` is a `Plant`, `work` a `Work`, see crane/records.py.
"""

from segfmu.kernels.crane.bounds import (
    acceleration_bound,
    at_velocity_bound,
    carriage_mass,
    exceeds,
    force_bound,
    hold_velocities,
    limit_accelerations,
    limited,
    velocity_bound,
)
from segfmu.kernels.crane.records import (
    Action,
    Axes,
    GeneralisedForce,
    Plant,
    PlantState,
    State,
    Work,
)
from segfmu.kernels.crane.slack import axis_velocity, is_slack, may_slacken
from segfmu.kernels.crane.suspension import suspended_driven, suspended_rhs


def forced_derivative(
    plant: 'float[:]', state: 'float[:]', work: 'float[:,:]', derivative: 'float[:]'
) -> None:
    """Derivative of the crane under force demands; see `driven_derivative`."""
    force = work[Work.GENERALISED, :]
    action = work[Work.ACTION, :]
    fast = False
    for i in range(3):
        drive = work[Work.DEMAND, i]
        bound = force_bound(plant, i, drive, state[State.VELOCITY + i])
        if exceeds(drive, bound):
            drive = limited(drive, bound)
            action[Action.SATURATED + i] = 1.0
        fast = fast or at_velocity_bound(plant, i, state)
        action[Action.FORCE + i] = drive
        force[i] = drive - work[Work.FRICTION, i]
    run_on(plant, work)
    suspended_rhs(plant, state, work, derivative)
    if fast:
        hold_velocities(plant, state, derivative, action, work[Work.LIMIT, :])
        for i in range(3):
            force[i] = action[Action.FORCE + i] - work[Work.FRICTION, i]
        run_on(plant, work)
        suspended_rhs(plant, state, work, derivative)
    action[Action.ROPE_FORCE] = force[GeneralisedForce.FORCE + Axes.ROPE]


def run_on(plant: 'float[:]', work: 'float[:,:]') -> None:
    """Where a force drive would push a rope that may slacken, let the drum follow the load."""
    force = work[Work.GENERALISED, :]
    rope = GeneralisedForce.FORCE + Axes.ROPE
    if not may_slacken(plant) or force[rope] < 0.0:
        return
    work[Work.ACTION, Action.FORCE + Axes.ROPE] = work[Work.FRICTION, Axes.ROPE]
    force[rope] = 0.0
    for i in range(2):
        force[GeneralisedForce.TORQUE + i] = 0.0


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
            bound = velocity_bound(plant, i, demand)
            if exceeds(demand, bound):
                demand = limited(demand, bound)
                action[Action.SATURATED + i] = 1.0
            demand = (demand - axis_velocity(state, i)) / plant[Plant.LAG + i]
        bound = acceleration_bound(plant, i, demand)
        if exceeds(demand, bound):
            demand = limited(demand, bound)
            action[Action.SATURATED + i] = 1.0
        work[Work.DEMAND, i] = demand
    if is_slack(state):
        slack_derivative(plant, state, work, derivative)
        return
    driven_forces(plant, state, work, derivative)
    for i in range(3):
        bound = force_bound(plant, i, action[Action.FORCE + i], state[State.VELOCITY + i])
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
    suspended_driven(plant, state, work, derivative)
    action[Action.ROPE_FORCE] = action[Action.FORCE + Axes.ROPE]
    for i in range(3):
        action[Action.FORCE + i] = action[Action.FORCE + i] + work[Work.FRICTION, i]


def slack_derivative(
    plant: 'float[:]', state: 'float[:]', work: 'float[:,:]', derivative: 'float[:]'
) -> None:
    """The same while the rope is slack: the load falls freely, the drum follows its demand.

    Each carriage has its own mass to move, the drum only its friction.
    """
    force = work[Work.GENERALISED, :]
    action = work[Work.ACTION, :]
    for i in range(3):
        needed = carriage_mass(plant, i) * work[Work.DEMAND, i]
        drive = needed + work[Work.FRICTION, i]
        bound = force_bound(plant, i, drive, axis_velocity(state, i))
        if exceeds(drive, bound) and i != Axes.ROPE:
            drive = limited(drive, bound)
            action[Action.SATURATED + i] = 1.0
        action[Action.FORCE + i] = drive
        force[i] = drive - work[Work.FRICTION, i]
    force[GeneralisedForce.FORCE + Axes.ROPE] = 0.0
    for i in range(2):
        force[GeneralisedForce.TORQUE + i] = 0.0
    suspended_rhs(plant, state, work, derivative)
    derivative[PlantState.PAID_OUT] = state[PlantState.PAYING_OUT]
    derivative[PlantState.PAYING_OUT] = work[Work.DEMAND, Axes.ROPE]
    action[Action.ROPE_FORCE] = 0.0
