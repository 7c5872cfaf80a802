"""The rope that bears nothing: a force drive runs on, a velocity drive leaves a slack rope.

The drum has no inertia. In mode force a hoist cannot push: where it would, drum and rope follow the
load without a force, and the rope is never longer than it has to be. In mode velocity the drum
follows its demand whatever the load does. The rope is slack from when its force would be positive
until the load is as far from the trolley as rope is paid out; the load falls freely. Then the load
takes the rope's rate in an inelastic impulse along it, while the drives keep their velocities.
`plant` is a `Plant`, `state` a `PlantState`.
"""

from math import cos, sin

from segfmu.kernels.crane.records import Axes, Plant, PlantState, SlackRope, State


def may_slacken(plant: 'float[:]') -> bool:
    """Whether a rope without tension is allowed."""
    return int(plant[Plant.SLACK]) == SlackRope.FREE_FALL


def is_slack(state: 'float[:]') -> bool:
    """Whether the load is nearer to the trolley than rope is paid out."""
    return state[PlantState.SLACK] > 0.5


def axis_position(state: 'float[:]', axis: int) -> float:
    """Position of a carriage, or length of the rope that is paid out [m]."""
    if axis == Axes.ROPE and is_slack(state):
        return state[PlantState.PAID_OUT]
    return state[State.POSITION + axis]


def axis_velocity(state: 'float[:]', axis: int) -> float:
    """Velocity of a carriage, or rate of the rope that is paid out [m/s]."""
    if axis == Axes.ROPE and is_slack(state):
        return state[PlantState.PAYING_OUT]
    return state[State.VELOCITY + axis]


def bears_wrongly(plant: 'float[:]', state: 'float[:]', rope_force: float) -> bool:
    """Whether a taut rope would have to push, or a slack one is too short."""
    if is_slack(state):
        over = state[State.POSITION + Axes.ROPE] - state[PlantState.PAID_OUT]
        return over > 1e-10 * state[PlantState.PAID_OUT]
    return rope_force > 1e-9 * plant[Plant.PAYLOAD_MASS] * plant[Plant.GRAVITY]


def change_rope(plant: 'float[:]', state: 'float[:]') -> None:
    """Let a taut rope go slack, or end a slack rope by the impulse that makes it taut.

    With the load's mass m, its rate against the rope u, and the velocity v along the rope of the
    rope's end, the drives do the work -m u v, and m u^2 / 2 is lost.
    """
    rope = State.VELOCITY + Axes.ROPE
    if not is_slack(state):
        state[PlantState.SLACK] = 1.0
        state[PlantState.PAID_OUT] = state[State.POSITION + Axes.ROPE]
        state[PlantState.PAYING_OUT] = state[rope]
        return
    mass = plant[Plant.PAYLOAD_MASS]
    against = state[rope] - state[PlantState.PAYING_OUT]
    along = state[PlantState.PAYING_OUT] + sin(state[State.ANGLE]) * state[State.VELOCITY]
    across = cos(state[State.ANGLE]) * sin(state[State.ANGLE + 1])
    along = along - across * state[State.VELOCITY + Axes.TROLLEY]
    drives = state[PlantState.DRIVE_WORK] - mass * against * along
    lost = 0.5 * mass * against * against
    state[PlantState.DRIVE_WORK] = drives
    state[PlantState.DISSIPATED] = state[PlantState.DISSIPATED] + lost
    state[rope] = state[PlantState.PAYING_OUT]
    state[PlantState.SLACK] = 0.0
    state[PlantState.PAID_OUT] = 0.0
    state[PlantState.PAYING_OUT] = 0.0
