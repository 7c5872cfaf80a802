"""The sampled controller and the drives' commands between two events.

`loop`, `setpoints` and `memory` are told in kernels/rig/rig.py.
"""

from math import exp

from segfmu.kernels.control.feedback import feedback_correction
from segfmu.kernels.control.tracking import track_setpoint
from segfmu.kernels.crane.plant import plant_advance
from segfmu.kernels.rig.events import instant
from segfmu.kernels.rig.sensing import sense_signals


def course(setpoints: 'float[:]', i: int, share: float, memory: 'float[:,:]') -> float:
    """A setpoint at a share of the step."""
    bend = memory[10, 10 + i] + memory[11, 10 + i] * (share + 1.0)
    return memory[3, i] + (setpoints[i] - memory[3, i] + bend * (share - 1.0)) * share


def course_rates(
    setpoints: 'float[:]', i: int, share: float, duration: float, memory: 'float[:,:]',
    rates: 'float[:]', place: int,
) -> None:
    """Taylor coefficients of a setpoint at a share of the step, by time: rates[place], every third.
    """
    square = memory[10, 10 + i]
    cube = memory[11, 10 + i]
    slope = setpoints[i] - memory[3, i] - square - cube
    slope = slope + (2.0 * square + 3.0 * cube * share) * share
    rates[place] = slope / duration
    rates[place + 3] = (square + 3.0 * cube * share) / (duration * duration)
    rates[place + 6] = cube / (duration * duration * duration)


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
        memory[6, i] = course(setpoints, 6 + i, share, memory)
    for i in range(3):
        if memory[1, 4] > 0.5:
            course_rates(setpoints, 3 + i, share, duration, memory, memory[11, :], i)
            memory[7, i] = memory[11, i]
        else:
            memory[7, i] = course(setpoints, i, share, memory)


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
    """Integrate until a time within the step; returns the status of kernels/crane/plant.py."""
    time = memory[2, 0] + memory[2, 1] + memory[2, 2]
    if memory[1, 4] > 0.5:
        command_velocities(setpoints, duration, until, memory)
    else:
        for i in range(3):
            share = memory[2, 2] / duration
            memory[10, i] = course(setpoints, i, share, memory) + memory[8, i]
            course_rates(setpoints, i, share, duration, memory, memory[11, :], i)
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
        command = course(setpoints, 3 + i, done / duration, memory) + memory[9, i]
        course_rates(setpoints, 3 + i, done / duration, duration, memory, memory[11, :], i)
        memory[11, i] = memory[11, i] + memory[8, i]
        memory[9, i] = memory[9, i] + memory[8, i] * length
        if memory[1, 5 + i] == 0.0:
            # at the end it has its setpoint, wherever a bound has left it before
            aim = course(setpoints, 3 + i, until / duration, memory) + memory[9, i]
            command = (aim - memory[0, 5 + i]) / length
            for j in range(3):
                memory[11, 3 * j + i] = 0.0
        memory[10, i] = command
