"""The sensors' signals over time: sampled, noisy, quantised, and available after a dead time.

`sensors` (18) is a `Sensors`; `memory` (`sensing_rows` rows) a `Sensing`, with a ring of
samples that wait, each a `Sample`, six a row.
"""

from math import ceil, floor

from segfmu.kernels.crane.records import Coordinates
from segfmu.kernels.numerics.noise import next_normal, seed_numbers
from segfmu.kernels.numerics.numbers import NEVER
from segfmu.kernels.rig.records import (
    Memory,
    Queue,
    Ring,
    Sample,
    Sensing,
    Sensors,
    Settings,
)


def sensing_rows(sample_time: float, dead_time: float) -> int:
    """Rows of memory, for the samples within the dead time, the new one, and one for rounding."""
    if sample_time <= 0.0:
        return Sensing.RING
    samples = ceil(dead_time / sample_time) + 2
    return Sensing.RING + (samples + Ring.SAMPLES_A_ROW - 1) // Ring.SAMPLES_A_ROW


def sensing_end(settings: 'float[:,:]') -> int:
    """Row of a rig's memory behind that of the sensors."""
    sensors = settings[Settings.SENSORS, :]
    return Memory.SENSING + sensing_rows(sensors[Sensors.SAMPLE_TIME], sensors[Sensors.DEAD_TIME])


def measure_state(
    state: 'float[:]', sensors: 'float[:]', numbers: 'float[:]', measured: 'float[:]'
) -> None:
    """Measured coordinates (5) of a state: offset, noise, quantisation.

    numbers (2): state of the random numbers. If any sensor has noise, five numbers are drawn, so
    that the noise of one sensor does not depend on the others.
    """
    noisy = False
    for i in range(Coordinates.SIZE):
        noisy = noisy or sensors[Sensors.DEVIATION + i] > 0.0
    for i in range(Coordinates.SIZE):
        value = state[i] + sensors[Sensors.OFFSET + i]
        if noisy:
            value = value + sensors[Sensors.DEVIATION + i] * next_normal(numbers)
        step = sensors[Sensors.RESOLUTION + i]
        # a step below the value's precision would not change it
        if abs(value) < 1e15 * step:
            value = floor(value / step + 0.5) * step
        measured[i] = value


def start_sensing(sensors: 'float[:]', state: 'float[:]', memory: 'float[:,:]') -> None:
    """Reset the memory and take the first sample."""
    for i in range(Queue.SIZE):
        memory[Sensing.QUEUE, i] = 0.0
    seed_numbers(int(sensors[Sensors.SEED]), memory[Sensing.RANDOM, :])
    if sensors[Sensors.SAMPLE_TIME] > 0.0:
        take_sample(sensors, state, memory)


def next_sample(sensors: 'float[:]', memory: 'float[:,:]') -> float:
    """Time of the next sample since the start [s]; NEVER for continuous signals."""
    if sensors[Sensors.SAMPLE_TIME] <= 0.0:
        return NEVER
    return memory[Sensing.QUEUE, Queue.TAKEN] * sensors[Sensors.SAMPLE_TIME]


def ring_size(memory: 'float[:,:]') -> int:
    """Capacity of the ring in samples."""
    return Ring.SAMPLES_A_ROW * (memory.shape[0] - Sensing.RING)


def ring_place(number: int, memory: 'float[:,:]') -> 'tuple[int, int]':
    """Row and first column of a sample of the ring."""
    sample = number % ring_size(memory)
    row = Sensing.RING + sample // Ring.SAMPLES_A_ROW
    return row, Sample.SIZE * (sample % Ring.SAMPLES_A_ROW)


def take_sample(sensors: 'float[:]', state: 'float[:]', memory: 'float[:,:]') -> None:
    """Store the sample that is due in the ring."""
    queue = memory[Sensing.QUEUE, :]
    taken = memory[Sensing.TAKEN, :]
    time = next_sample(sensors, memory)
    deliver_samples(sensors, time, memory)
    measure_state(state, sensors, memory[Sensing.RANDOM, :], taken)
    row, column = ring_place(int(queue[Queue.OLDEST]) + int(queue[Queue.WAITING]), memory)
    memory[row, column + Sample.AVAILABLE] = time + sensors[Sensors.DEAD_TIME]
    for i in range(Coordinates.SIZE):
        memory[row, column + Sample.VALUES + i] = taken[i]
    queue[Queue.TAKEN] = queue[Queue.TAKEN] + 1.0
    queue[Queue.WAITING] = queue[Queue.WAITING] + 1.0


def deliver_samples(sensors: 'float[:]', time: float, memory: 'float[:,:]') -> None:
    """Take the samples available at a time from the ring; the first one at once."""
    queue = memory[Sensing.QUEUE, :]
    latest = time + 1e-9 * sensors[Sensors.SAMPLE_TIME]
    while queue[Queue.WAITING] > 0.5:
        row, column = ring_place(int(queue[Queue.OLDEST]), memory)
        if queue[Queue.DELIVERED] > 0.5 and memory[row, column + Sample.AVAILABLE] > latest:
            return
        for i in range(Coordinates.SIZE):
            memory[Sensing.LATEST, i] = memory[row, column + Sample.VALUES + i]
        queue[Queue.OLDEST] = float((int(queue[Queue.OLDEST]) + 1) % ring_size(memory))
        queue[Queue.WAITING] = queue[Queue.WAITING] - 1.0
        queue[Queue.DELIVERED] = 1.0


def sense_signals(
    sensors: 'float[:]', time: float, state: 'float[:]', memory: 'float[:,:]', measured: 'float[:]'
) -> None:
    """Signals (5) at a time [s] since the start; times must not decrease."""
    if sensors[Sensors.SAMPLE_TIME] <= 0.0:
        measure_state(state, sensors, memory[Sensing.RANDOM, :], measured)
        return
    deliver_samples(sensors, time, memory)
    for i in range(Coordinates.SIZE):
        measured[i] = memory[Sensing.LATEST, i]
