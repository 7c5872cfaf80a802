"""Time events: samples, changes of the payload, ends of a gust.

`settings`, `changes` and `memory` are described in kernels/rig/rig.py.
"""

from segfmu.kernels.crane.records import Plant, Work
from segfmu.kernels.crane.suspension import suspended_energy
from segfmu.kernels.numerics.numbers import NEVER
from segfmu.kernels.rig.records import (
    Clock,
    Energies,
    EnergyMemory,
    Loop,
    Memory,
    PayloadChange,
    Settings,
)
from segfmu.kernels.rig.sensing import (
    next_sample,
    sense_signals,
    sensing_end,
    take_sample,
)


def time_tolerance(settings: 'float[:,:]') -> float:
    """Times [s] that differ by less are equal, because sums of steps are rounded.

    A controller that is slow or never acts makes samples and changes no less exact.
    """
    return 1e-9 * min(settings[Settings.LOOP, Loop.PERIOD], 1.0)


def present_time(memory: 'float[:,:]') -> float:
    """Time [s] since the start."""
    return memory[Memory.CLOCK, Clock.REACHED] + memory[Memory.CLOCK, Clock.DONE]


def next_tick(settings: 'float[:,:]', memory: 'float[:,:]') -> float:
    """Time [s] since the start of the controller's next tick."""
    return memory[Memory.CLOCK, Clock.TICKS] * settings[Settings.LOOP, Loop.PERIOD]


def next_reading(settings: 'float[:,:]', memory: 'float[:,:]') -> float:
    """Time [s] since the start of the sensors' next sample; NEVER for continuous signals."""
    return next_sample(
        settings[Settings.SENSORS, :], memory[Memory.SENSING:sensing_end(settings), :]
    )


def rig_next_event(settings: 'float[:,:]', memory: 'float[:,:]') -> float:
    """Time [s] since the start of the next tick, sample, or change of payload or wind."""
    time = min(next_tick(settings, memory), memory[Memory.CLOCK, Clock.NEXT_CHANGE])
    return min(time, next_reading(settings, memory))


def next_event(settings: 'float[:,:]', duration: float, memory: 'float[:,:]') -> float:
    """Time [s] within the step of the next event, or the step's end."""
    until = rig_next_event(settings, memory) - memory[Memory.CLOCK, Clock.REACHED]
    if until >= duration - time_tolerance(settings):
        return duration
    return until


def handle_events(
    settings: 'float[:,:]', changes: 'float[:,:]', memory: 'float[:,:]'
) -> None:
    """Take the samples and change the payload if they are due."""
    clock = memory[Memory.CLOCK, :]
    energy = memory[Memory.ENERGY, :]
    time = present_time(memory)
    latest = time + time_tolerance(settings)
    while next_reading(settings, memory) <= latest:
        take_sample(
            settings[Settings.SENSORS, :], memory[Memory.STATE, :],
            memory[Memory.SENSING:sensing_end(settings), :],
        )
    while clock[Clock.NEXT_CHANGE] <= latest:
        clock[Clock.NEXT_CHANGE] = next_change(changes, clock[Clock.NEXT_CHANGE], memory)
        before = mechanical_energy(memory)
        change_payload(settings, changes, clock[Clock.START] + time, memory)
        added = mechanical_energy(memory) - before
        energy[EnergyMemory.PAYLOAD] = energy[EnergyMemory.PAYLOAD] + added


def next_change(changes: 'float[:,:]', after: float, memory: 'float[:,:]') -> float:
    """Time [s] of the first change of payload or wind after another time; NEVER: there is none."""
    start = memory[Memory.CLOCK, Clock.START]
    gust = memory[Memory.PLANT, Plant.GUST_START]
    duration = memory[Memory.PLANT, Plant.GUST_DURATION]
    first = NEVER
    for i in range(changes.shape[0]):
        time = changes[i, PayloadChange.TIME] - start
        if time > after:
            first = min(first, time)
    if duration > 0.0:
        time = gust - start
        if time > after:
            first = min(first, time)
        time = gust + duration - start
        if time > after:
            first = min(first, time)
    return first


def change_payload(
    settings: 'float[:,:]', changes: 'float[:,:]', time: float, memory: 'float[:,:]'
) -> None:
    """Set the mass of the load that is valid from a time [s] on."""
    chosen = -1
    for i in range(changes.shape[0]):
        start = changes[i, PayloadChange.TIME]
        if start <= time + time_tolerance(settings):
            if chosen < 0 or start > changes[chosen, PayloadChange.TIME]:
                chosen = i
    if chosen >= 0:
        memory[Memory.PLANT, Plant.PAYLOAD_MASS] = changes[chosen, PayloadChange.MASS]


def mechanical_energy(memory: 'float[:,:]') -> float:
    """Kinetic and potential energy of the crane [J]."""
    energy = memory[Memory.ENERGY, :]
    suspended_energy(
        memory[Memory.PLANT, :], memory[Memory.STATE, :],
        memory[Memory.WORK:Memory.WORK + Work.SIZE, :], energy,
    )
    return energy[Energies.KINETIC] + energy[Energies.POTENTIAL]


def update_signals(settings: 'float[:,:]', time: float, memory: 'float[:,:]') -> None:
    """Signals of the sensors at a time [s] since the start that does not decrease."""
    sense_signals(
        settings[Settings.SENSORS, :], time, memory[Memory.STATE, :],
        memory[Memory.SENSING:sensing_end(settings), :], memory[Memory.SIGNALS, :],
    )
