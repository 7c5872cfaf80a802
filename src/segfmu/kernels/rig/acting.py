"""What acts on the crane at the start, before the first tick of the controller.

`setpoints` and `memory` are described in kernels/rig/rig.py.
"""

from segfmu.kernels.crane.bounds import acceleration_bound, force_bound
from segfmu.kernels.crane.records import Axes, Plant, PlantState, PlantStatus, Report, Work
from segfmu.kernels.crane.slack import axis_velocity, change_rope, may_slacken
from segfmu.kernels.numerics.records import Stages
from segfmu.kernels.rig.exchange import commanded_rates
from segfmu.kernels.rig.records import Memory, Setpoints
from segfmu.kernels.rig.setpoints import bounded_velocity, is_driven, set_command


def first_command(axis: int, setpoints: 'float[:]', memory: 'float[:,:]') -> float:
    """Command of a drive at the start: force, velocity, or without lag acceleration.

    Without lag, a drive that is not at its setpoint goes there as fast as its bounds permit. One
    without bounds would jump, which takes no finite force: it keeps its velocity.
    """
    plant = memory[Memory.PLANT, :]
    if not is_driven(memory):
        return setpoints[Setpoints.FORCE + axis]
    velocity = setpoints[Setpoints.VELOCITY + axis]
    if plant[Plant.LAG + axis] > 0.0:
        return velocity
    velocity = bounded_velocity(axis, velocity, memory)
    present = axis_velocity(memory[Memory.STATE, :], axis)
    change = velocity - present
    by_force = force_bound(plant, axis, change, present)
    if max(acceleration_bound(plant, axis, change), by_force) == 0.0:
        return 0.0
    # at once is within a microsecond
    return 1e6 * change


def act_first(
    components: 'float[:,:]', setpoints: 'float[:]', memory: 'float[:,:]'
) -> None:
    """Report forces and powers at the start; the state's derivative is the last stage's."""
    state = memory[Memory.STATE, :]
    plant = memory[Memory.PLANT, :]
    report = memory[Memory.REPORT, :]
    derivative = memory[Memory.WORK + Work.STAGES + Stages.K7, :]
    for i in range(Axes.SIZE):
        command = first_command(i, setpoints, memory)
        set_command(i, command, 0.0, 0.0, 0.0, memory)
    status = commanded_rates(components, setpoints, 0.0, memory, derivative)
    if status == PlantStatus.SLACK_ROPE and may_slacken(plant):
        # it goes slack in the first step
        change_rope(plant, state)
        commanded_rates(components, setpoints, 0.0, memory, derivative)
        state[PlantState.SLACK] = 0.0
        state[PlantState.PAID_OUT] = 0.0
        state[PlantState.PAYING_OUT] = 0.0
    for i in range(Axes.SIZE):
        before = report[Report.STEP_SATURATED + i]
        report[Report.STEP_SATURATED + i] = max(before, report[Report.SATURATED + i])
