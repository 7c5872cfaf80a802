"""What happens at times of its own: samples, changes of the payload, ends of a gust.

`loop`, `changes` and `memory` are told in kernels/rig/rig.py.
"""

from segfmu.kernels.crane._crane import crane_energy
from segfmu.kernels.rig.sensing import next_sample, take_sample


def instant(loop: 'float[:]') -> float:
    """Times that differ by less are the same; sums of steps are rounded."""
    return 1e-9 * loop[1]


def next_event(
    loop: 'float[:]', sensors: 'float[:]', duration: float, memory: 'float[:,:]'
) -> float:
    """Time within the step of the next event, or the step's end."""
    time = min(memory[2, 3] * loop[1], memory[2, 4])
    time = min(time, next_sample(sensors, memory[30:memory.shape[0], :]))
    until = time - memory[2, 1]
    if until >= duration - instant(loop):
        return duration
    return until


def meet_events(
    loop: 'float[:]', sensors: 'float[:]', changes: 'float[:,:]', memory: 'float[:,:]'
) -> None:
    """Take the samples and change the payload if they are due."""
    time = memory[2, 1] + memory[2, 2]
    latest = time + instant(loop)
    while next_sample(sensors, memory[30:memory.shape[0], :]) <= latest:
        take_sample(sensors, memory[0, :], memory[30:memory.shape[0], :])
    while memory[2, 4] <= latest:
        memory[2, 4] = next_edge(changes, memory[2, 4], memory)
        before = mechanical_energy(memory)
        change_payload(loop, changes, memory[2, 0] + time, memory)
        memory[2, 6] = memory[2, 6] + (mechanical_energy(memory) - before)


def next_edge(changes: 'float[:,:]', after: float, memory: 'float[:,:]') -> float:
    """Time of the first change of payload or wind after another time; 1e300 if there is none."""
    first = 1e300
    for i in range(changes.shape[0]):
        time = changes[i, 0] - memory[2, 0]
        if time > after:
            first = min(first, time)
    if memory[1, 32] > 0.0:
        time = memory[1, 31] - memory[2, 0]
        if time > after:
            first = min(first, time)
        time = memory[1, 31] + memory[1, 32] - memory[2, 0]
        if time > after:
            first = min(first, time)
    return first


def change_payload(
    loop: 'float[:]', changes: 'float[:,:]', time: float, memory: 'float[:,:]'
) -> None:
    """Give the load the mass that it has from a time on."""
    chosen = -1
    for i in range(changes.shape[0]):
        if changes[i, 0] <= time + instant(loop):
            if chosen < 0 or changes[i, 0] > changes[chosen, 0]:
                chosen = i
    if chosen >= 0:
        memory[1, 2] = changes[chosen, 1]


def mechanical_energy(memory: 'float[:,:]') -> float:
    """Kinetic and potential energy of the crane [J]."""
    crane_energy(
        memory[0, :], memory[1, 0], memory[1, 1], memory[1, 2], memory[1, 3], memory[13, :]
    )
    return memory[13, 0] + memory[13, 1]
