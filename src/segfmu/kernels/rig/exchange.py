"""The rig of kernels/rig/rig.py for a caller that integrates it: derivatives and time events.

The caller sets the state and the setpoints of the present time, in `memory` and `setpoints`, and
calls `rig_event` at the times given by `rig_next_event`. Between events corrections are held: added
to the forces, or with velocity drives integrated and added to the velocities. All times are seconds
since the start. Velocity drives need a lag: without it, the setpoints do not determine the
acceleration.
"""

from segfmu.kernels.control.records import Correction
from segfmu.kernels.crane.plant import plant_derivative, plant_status
from segfmu.kernels.crane.records import Action, PlantState, Report, Work
from segfmu.kernels.rig.events import handle_events, update_signals
from segfmu.kernels.rig.loop import (
    controller_due,
    correct_setpoints,
    prepare_tick,
)
from segfmu.kernels.rig.records import Clock, Memory, Setpoints
from segfmu.kernels.rig.setpoints import is_driven, set_command, set_load_force


def rig_event(
    settings: 'float[:,:]',
    changes: 'float[:,:]',
    table: 'float[:,:,:]',
    gains: 'float[:,:,:]',
    tracker: 'float[:,:]',
    setpoints: 'float[:]',
    time: float,
    memory: 'float[:,:]',
) -> None:
    """Take samples, change the payload and correct the setpoints if due at a time."""
    clock = memory[Memory.CLOCK, :]
    rig_signals(settings, time, memory)
    for i in range(Setpoints.SIZE):
        memory[Memory.LAST, i] = setpoints[i]
    handle_events(settings, changes, memory)
    if controller_due(settings, memory):
        for i in range(3):
            memory[Memory.ADDED, i] = added_velocity(i, time, memory)
        clock[Clock.LAST_TICK] = time
        prepare_tick(settings, setpoints, 1.0, memory)
        correct_setpoints(settings, table, gains, tracker, memory)


def added_velocity(axis: int, time: float, memory: 'float[:,:]') -> float:
    """Velocity [m/s] that corrections have added to a velocity setpoint at a time."""
    held = time - memory[Memory.CLOCK, Clock.LAST_TICK]
    correction = memory[Memory.CORRECTION, Correction.VALUE + axis]
    return memory[Memory.ADDED, axis] + correction * held


def rig_signals(settings: 'float[:,:]', time: float, memory: 'float[:,:]') -> None:
    """Signals of the sensors at a time that does not decrease."""
    memory[Memory.CLOCK, Clock.REACHED] = time
    memory[Memory.CLOCK, Clock.DONE] = 0.0
    update_signals(settings, time, memory)


def rig_rates(
    components: 'float[:,:]',
    setpoints: 'float[:]',
    time: float,
    memory: 'float[:,:]',
    derivative: 'float[:]',
) -> int:
    """Derivative of the state (13) at a time; the plant's report goes to the memory.

    Returns a `PlantStatus`.
    """
    for i in range(3):
        if is_driven(memory):
            command = setpoints[Setpoints.VELOCITY + i] + added_velocity(i, time, memory)
        else:
            correction = memory[Memory.CORRECTION, Correction.VALUE + i]
            command = setpoints[Setpoints.FORCE + i] + correction
        set_command(i, command, 0.0, 0.0, 0.0, memory)
    return commanded_rates(components, setpoints, time, memory, derivative)


def commanded_rates(
    components: 'float[:,:]',
    setpoints: 'float[:]',
    time: float,
    memory: 'float[:,:]',
    derivative: 'float[:]',
) -> int:
    """The same under the commands of the drives in the memory."""
    work = memory[Memory.WORK:Memory.WORK + Work.SIZE, :]
    report = memory[Memory.REPORT, :]
    for i in range(3):
        set_load_force(i, setpoints[Setpoints.WIND + i], 0.0, 0.0, 0.0, memory)
    plant_derivative(
        memory[Memory.PLANT, :], components, memory[Memory.CLOCK, Clock.START] + time, 0.0,
        memory[Memory.STATE, :], work, derivative,
    )
    for i in range(Action.SIZE):
        report[i] = work[Work.ACTION, i]
    report[Report.WIND_POWER] = derivative[PlantState.WIND_WORK]
    report[Report.FRICTION_POWER] = derivative[PlantState.DISSIPATED]
    return plant_status(
        memory[Memory.PLANT, :], memory[Memory.STATE, :], work[Work.ACTION, :]
    )
