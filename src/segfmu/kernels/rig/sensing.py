"""The sensors' signals over time: sampled, noisy, quantised, and available after a dead time.

`sensors` (18): 0 sample time [s], 0 for continuous signals; 1 dead time [s]; 2 seed of the noise;
then five each, bridge, trolley, rope length and the two sway angles: 3:8 offset, 8:13 standard
deviation of the noise, 13:18 resolution (width of a quantisation step, 0 for none).

`memory` (`sensing_rows`, 36 or more), integers kept as floats: row 0 is the number of samples
taken, the place of the oldest one in the queue, how many are in it, and whether one has come out of
it; row 1 the state of the random numbers (2), row 2 the sample that came out last (5), row 3 work
space. From row 4 on, six samples a row, lies the queue, a ring: time at which a sample is
available, and its five values.
"""

from math import ceil, floor

from segfmu.kernels.numerics.noise import next_normal, seed_numbers


def sensing_rows(sample_time: float, dead_time: float) -> int:
    """Rows of memory; samples younger than the dead time, the new one, and one for rounding."""
    if sample_time <= 0.0:
        return 4
    return 4 + (ceil(dead_time / sample_time) + 7) // 6


def measure_state(
    state: 'float[:]', sensors: 'float[:]', numbers: 'float[:]', measured: 'float[:]'
) -> None:
    """Measured values (5) of the first components of the state: offset, noise, quantisation.

    Where there is noise, five random numbers are used, so that the noise of one sensor does not
    depend on that of the others.
    """
    noisy = False
    for i in range(5):
        noisy = noisy or sensors[8 + i] > 0.0
    for i in range(5):
        value = state[i] + sensors[3 + i]
        if noisy:
            value = value + sensors[8 + i] * next_normal(numbers)
        # a step below the last digit of the value is none, nor are there integers for it
        if abs(value) < 1e15 * sensors[13 + i]:
            value = floor(value / sensors[13 + i] + 0.5) * sensors[13 + i]
        measured[i] = value


def start_sensing(sensors: 'float[:]', state: 'float[:]', memory: 'float[:,:]') -> None:
    """Forget the past and take the first sample."""
    for i in range(4):
        memory[0, i] = 0.0
    seed_numbers(int(sensors[2]), memory[1, :])
    if sensors[0] > 0.0:
        take_sample(sensors, state, memory)


def next_sample(sensors: 'float[:]', memory: 'float[:,:]') -> float:
    """Time of the next sample since the start [s]; 1e300 for continuous signals."""
    if sensors[0] <= 0.0:
        return 1e300
    return memory[0, 0] * sensors[0]


def queue_entry(place: int, memory: 'float[:,:]') -> 'tuple[int, int]':
    """Row and column of an entry of the ring."""
    entry = place % (6 * (memory.shape[0] - 4))
    return 4 + entry // 6, 6 * (entry % 6)


def take_sample(sensors: 'float[:]', state: 'float[:]', memory: 'float[:,:]') -> None:
    """Put the sample that is due into the queue."""
    time = next_sample(sensors, memory)
    deliver_samples(sensors, time, memory)
    measure_state(state, sensors, memory[1, :], memory[3, :])
    row, column = queue_entry(int(memory[0, 1]) + int(memory[0, 2]), memory)
    memory[row, column] = time + sensors[1]
    for i in range(5):
        memory[row, column + 1 + i] = memory[3, i]
    memory[0, 0] = memory[0, 0] + 1.0
    memory[0, 2] = memory[0, 2] + 1.0


def deliver_samples(sensors: 'float[:]', time: float, memory: 'float[:,:]') -> None:
    """Take the samples that are available at a time out of the queue; the first one at once."""
    latest = time + 1e-9 * sensors[0]
    while memory[0, 2] > 0.5:
        row, column = queue_entry(int(memory[0, 1]), memory)
        if memory[0, 3] > 0.5 and memory[row, column] > latest:
            return
        for i in range(5):
            memory[2, i] = memory[row, column + 1 + i]
        memory[0, 1] = float((int(memory[0, 1]) + 1) % (6 * (memory.shape[0] - 4)))
        memory[0, 2] = memory[0, 2] - 1.0
        memory[0, 3] = 1.0


def sense_signals(
    sensors: 'float[:]', time: float, state: 'float[:]', memory: 'float[:,:]', measured: 'float[:]'
) -> None:
    """Signals (5) at a time [s] since the start; times must not decrease."""
    if sensors[0] <= 0.0:
        measure_state(state, sensors, memory[1, :], measured)
        return
    deliver_samples(sensors, time, memory)
    for i in range(5):
        measured[i] = memory[2, i]
