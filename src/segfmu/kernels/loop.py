"""The sampled controller and the drives' commands between two events.

`loop`, `setpoints` and `memory` are told in kernels/rig.py.
"""

from math import exp

from segfmu.kernels.events import instant
from segfmu.kernels.feedback import feedback_correction
from segfmu.kernels.plant import plant_advance
from segfmu.kernels.sensing import sense_signals
from segfmu.kernels.tracking import track_setpoint


def between(start: float, end: float, share: float) -> float:
    """Value a share of the way from start to end."""
    return start + (end - start) * share


def controller_due(loop: 'float[:]', memory: 'float[:,:]') -> bool:
    """Whether the controller's next tick has come."""
    return memory[2, 3] * loop[1] <= memory[2, 1] + memory[2, 2] + instant(loop)


def prepare_tick(
    sensors: 'float[:]', setpoints: 'float[:]', duration: float, memory: 'float[:,:]'
) -> None:
    """What the controller gets at the tick that is due."""
    time = memory[2, 1] + memory[2, 2]
    share = memory[2, 2] / duration
    memory[2, 3] = memory[2, 3] + 1.0
    memory[2, 7] = memory[2, 0] + time
    sense_signals(sensors, time, memory[0, :], memory[30:memory.shape[0], :], memory[5, :])
    for i in range(10):
        memory[6, i] = between(memory[3, 6 + i], setpoints[6 + i], share)
    for i in range(3):
        if memory[1, 4] > 0.5:
            memory[7, i] = (setpoints[3 + i] - memory[3, 3 + i]) / duration
        else:
            memory[7, i] = between(memory[3, i], setpoints[i], share)


def correct_setpoints(
    loop: 'float[:]',
    tracking: 'float[:]',
    lengths: 'float[:]',
    table: 'float[:,:,:]',
    gain_lengths: 'float[:]',
    gains: 'float[:,:,:]',
    tracker: 'float[:,:]',
    memory: 'float[:,:]',
) -> None:
    """The correction at a tick; the tracking controller's observer goes on when it is off."""
    if loop[0] > 1.5:
        track_setpoint(
            tracking, lengths, table, gain_lengths, gains, memory[5, :], memory[6, :],
            memory[7, :], tracker, memory[8, :],
        )
    else:
        feedback_correction(memory[0, :], memory[6, :], gain_lengths, gains, memory[8, :])
    switch_correction(loop, memory)


def switch_correction(loop: 'float[:]', memory: 'float[:,:]') -> None:
    """Let the new correction act or not; what that would make it jump by fades out instead.

    Callers that correct by themselves call it after they have put theirs into memory[8].
    """
    acts = 1.0
    if loop[2] > 0.5:
        acts = 2.0
    decay = 0.0
    if loop[4] > 0.0:
        decay = exp(-loop[1] / loop[4])
    for i in range(3):
        if acts < 1.5:
            memory[8, i] = 0.0
            if memory[1, 4] > 0.5:
                # a velocity that was added must not stay
                memory[8, i] = -memory[9, i] / max(loop[4], loop[1])
        if memory[8, 6] > 0.5 and memory[8, 6] != acts:
            memory[8, 3 + i] = memory[8, 7 + i] - memory[8, i]
        memory[8, 3 + i] = decay * memory[8, 3 + i]
        memory[8, i] = memory[8, i] + memory[8, 3 + i]
        memory[8, 7 + i] = memory[8, i]
    memory[8, 6] = acts


def advance_plant(
    loop: 'float[:]',
    components: 'float[:,:]',
    setpoints: 'float[:]',
    duration: float,
    until: float,
    memory: 'float[:,:]',
) -> int:
    """Integrate until a time within the step; returns the status of kernels/plant.py."""
    time = memory[2, 0] + memory[2, 1] + memory[2, 2]
    if memory[1, 4] > 0.5:
        command_velocities(setpoints, duration, until, memory)
    else:
        for i in range(3):
            force = between(memory[3, i], setpoints[i], memory[2, 2] / duration)
            memory[10, i] = force + memory[8, i]
            memory[11, i] = (setpoints[i] - memory[3, i]) / duration
    for i in range(3):
        memory[12, i] = setpoints[16 + i]
    status = plant_advance(
        memory[1, :], components, time, memory[0, :], memory[10, :], memory[11, :], memory[12, :],
        until - memory[2, 2], loop[3], memory[14:30, :], memory[4, :],
    )
    for i in range(3):
        memory[4, 10 + i] = max(memory[4, 10 + i], memory[4, 3 + i])
    if status != 0:
        memory[2, 7] = time + memory[4, 9]
    return status


def command_velocities(
    setpoints: 'float[:]', duration: float, until: float, memory: 'float[:,:]'
) -> None:
    """Commands of velocity drives now and their rates until a time; advances what is added."""
    done = memory[2, 2]
    length = until - done
    for i in range(3):
        start = memory[3, 3 + i]
        end = setpoints[3 + i]
        command = between(start, end, done / duration) + memory[9, i]
        rate = (end - start) / duration + memory[8, i]
        memory[9, i] = memory[9, i] + memory[8, i] * length
        if memory[1, 5 + i] == 0.0:
            # at the end it has its setpoint, wherever a bound has left it before
            aim = between(start, end, until / duration) + memory[9, i]
            command = (aim - memory[0, 5 + i]) / length
            rate = 0.0
        memory[10, i] = command
        memory[11, i] = rate
