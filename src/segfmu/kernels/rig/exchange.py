"""The rig of kernels/rig/rig.py for a caller that integrates it: derivatives, and events by time.

The caller sets the state and the setpoints of the present time, in `memory` and `setpoints`, and
calls `rig_event` at the times that `rig_next_event` names. Between events corrections are held:
added to the forces, or with velocity drives integrated and added to the velocities. All times are
seconds since the start. Beside what kernels/rig/rig.py tells, memory[2, 8] is the time of the last
tick. Velocity drives need a lag: without it, the acceleration is not a function of the setpoints.
"""

from segfmu.kernels.crane.plant import plant_derivative, plant_status
from segfmu.kernels.rig.events import meet_events
from segfmu.kernels.rig.loop import controller_due, correct_setpoints, prepare_tick
from segfmu.kernels.rig.sensing import next_sample, sense_signals


def rig_next_event(loop: 'float[:]', sensors: 'float[:]', memory: 'float[:,:]') -> float:
    """Time of the next tick, sample, or change of payload or wind."""
    time = min(memory[2, 3] * loop[1], memory[2, 4])
    return min(time, next_sample(sensors, memory[30:memory.shape[0], :]))


def rig_event(
    loop: 'float[:]',
    sensors: 'float[:]',
    changes: 'float[:,:]',
    tracking: 'float[:]',
    lengths: 'float[:]',
    table: 'float[:,:,:]',
    gain_lengths: 'float[:]',
    gains: 'float[:,:,:]',
    tracker: 'float[:,:]',
    setpoints: 'float[:]',
    time: float,
    memory: 'float[:,:]',
) -> None:
    """Take samples, change the payload and correct the setpoints where it is due at a time.

    What the setpoints' slopes are is not known, so with velocity drives the limits of a tracking
    controller count for its correction alone.
    """
    rig_signals(sensors, time, memory)
    for i in range(19):
        memory[3, i] = setpoints[i]
    meet_events(loop, sensors, changes, memory)
    if controller_due(loop, memory):
        for i in range(3):
            memory[9, i] = memory[9, i] + memory[8, i] * (time - memory[2, 8])
        memory[2, 8] = time
        prepare_tick(sensors, setpoints, 1.0, memory)
        correct_setpoints(
            loop, tracking, lengths, table, gain_lengths, gains, tracker, memory
        )


def rig_signals(sensors: 'float[:]', time: float, memory: 'float[:,:]') -> None:
    """Signals of the sensors at a time that does not decrease."""
    memory[2, 1] = time
    memory[2, 2] = 0.0
    sense_signals(sensors, time, memory[0, :], memory[30:memory.shape[0], :], memory[5, :])


def rig_rates(
    components: 'float[:,:]',
    setpoints: 'float[:]',
    time: float,
    memory: 'float[:,:]',
    derivative: 'float[:]',
) -> int:
    """Derivative of the state (13) at a time; the report, memory[4, :9], is that of the plant.

    Returns `plant_status`.
    """
    for i in range(3):
        memory[10, i] = setpoints[i] + memory[8, i]
        if memory[1, 4] > 0.5:
            added = memory[9, i] + memory[8, i] * (time - memory[2, 8])
            memory[10, i] = setpoints[3 + i] + added
        memory[11, i] = 0.0
        memory[12, i] = setpoints[16 + i]
    work = memory[14:30, :]
    plant_derivative(
        memory[1, :], components, memory[2, 0] + time, 0.0, memory[0, :], memory[10, :],
        memory[11, :], memory[12, :], work, derivative,
    )
    for i in range(7):
        memory[4, i] = work[10, i]
    memory[4, 7] = derivative[11]
    memory[4, 8] = derivative[12]
    return plant_status(memory[1, :], memory[0, :], work[10, 6])
