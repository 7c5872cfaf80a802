"""Commands that reach their drives after a dead time.

What a drive is sent, setpoint and correction, is a cubic of time between the ticks of the
controller and the ends of communication steps. A ring keeps these cubics, oldest first, for all
drives at once; a drive with a dead time follows the one that was sent its dead time ago. The ends
of the cubics become events of the integration, so that a delay is exact. Before the start the
setpoints were those of the start.

`memory` is a `Memory`; `delayed` its rows from `sensing_end` on, a `Delayed`.
"""

from math import ceil

from segfmu.kernels.control.records import Correction
from segfmu.kernels.crane.records import Axes, Plant
from segfmu.kernels.rig.events import present_time, time_tolerance
from segfmu.kernels.rig.records import (
    Clock,
    CommandQueue,
    Delay,
    Delayed,
    Memory,
    SentCommand,
    Setpoints,
)
from segfmu.kernels.rig.setpoints import (
    follow_velocity,
    is_driven,
    set_command,
    setpoint_at,
    setpoint_rates,
)


def delay_rows(longest: float, period: float) -> int:
    """Rows of memory for the longest dead time [s] and the period of the controller [s].

    Two neighbours that no tick parts are at least a share of the dead time long, see `Delay`.
    """
    if longest <= 0.0:
        return 0
    commands = 2 * (Delay.RESOLUTION + ceil(longest / period)) + 8
    return Delayed.RING + (commands + Delay.COMMANDS_A_ROW - 1) // Delay.COMMANDS_A_ROW


def longest_delay(plant: 'float[:]') -> float:
    """Longest dead time of the drives [s]."""
    longest = 0.0
    for i in range(Axes.SIZE):
        longest = max(longest, plant[Plant.DEAD_TIME + i])
    return longest


def is_late(memory: 'float[:,:]') -> bool:
    """Whether a drive has a dead time."""
    return longest_delay(memory[Memory.PLANT, :]) > 0.0


def command_place(number: int, delayed: 'float[:,:]') -> 'tuple[int, int]':
    """Row and first column of a command of the ring, counted from the oldest one."""
    size = Delay.COMMANDS_A_ROW * (delayed.shape[0] - Delayed.RING)
    place = (int(delayed[Delayed.QUEUE, CommandQueue.OLDEST]) + number) % size
    row = Delayed.RING + place // Delay.COMMANDS_A_ROW
    return row, SentCommand.SIZE * (place % Delay.COMMANDS_A_ROW)


def command_start(number: int, delayed: 'float[:,:]') -> float:
    """When [s] a command of the ring was sent, counted from the oldest one."""
    row, column = command_place(number, delayed)
    return delayed[row, column + SentCommand.START]


def start_delay(
    setpoints: 'float[:]', delayed: 'float[:,:]', memory: 'float[:,:]'
) -> None:
    """The only command is that of the start, for all times."""
    delayed[Delayed.QUEUE, CommandQueue.WAITING] = 1.0
    row, column = command_place(0, delayed)
    delayed[row, column + SentCommand.START] = -1e100
    first = Setpoints.FORCE
    if is_driven(memory):
        first = Setpoints.VELOCITY
    for i in range(Axes.SIZE):
        delayed[row, column + SentCommand.VALUE + i] = setpoints[first + i]


def send_commands(
    setpoints: 'float[:]', duration: float, memory: 'float[:,:]', delayed: 'float[:,:]'
) -> None:
    """Put the commands from now on into the ring, where a step begins or a tick has come."""
    clock = memory[Memory.CLOCK, :]
    queue = delayed[Delayed.QUEUE, :]
    ticked = queue[CommandQueue.TICKS] != clock[Clock.TICKS]
    if clock[Clock.DONE] > 0.0 and not ticked:
        return
    time = present_time(memory)
    # a step that failed is tried again
    newest = int(queue[CommandQueue.WAITING]) - 1
    while newest > 0 and command_start(newest, delayed) >= time:
        newest = newest - 1
    queue[CommandQueue.WAITING] = newest + 1.0
    queue[CommandQueue.TICKS] = clock[Clock.TICKS]
    longest = longest_delay(memory[Memory.PLANT, :])
    join_commands(time, longest / Delay.RESOLUTION, delayed)
    drop_commands(time - longest, delayed)
    row, column = command_place(int(queue[CommandQueue.WAITING]), delayed)
    queue[CommandQueue.WAITING] = queue[CommandQueue.WAITING] + 1.0
    delayed[row, column + SentCommand.START] = time
    delayed[row, column + SentCommand.AT_TICK] = 0.0
    if ticked:
        delayed[row, column + SentCommand.AT_TICK] = 1.0
    share = clock[Clock.DONE] / duration
    for i in range(Axes.SIZE):
        write_command(i, setpoints, share, duration, memory, column, delayed[row, :])


def write_command(
    axis: int, setpoints: 'float[:]', share: float, duration: float, memory: 'float[:,:]',
    column: int, sent: 'float[:]',
) -> None:
    """Write what a drive is sent from a share of the step on, in a row of the ring."""
    place = Setpoints.FORCE + axis
    added = memory[Memory.CORRECTION, Correction.VALUE + axis]
    gained = 0.0
    if is_driven(memory):
        place = Setpoints.VELOCITY + axis
        gained = added
        added = memory[Memory.ADDED, axis]
    value = setpoint_at(setpoints, place, share, memory)
    slope, square, cube = setpoint_rates(setpoints, place, share, duration, memory)
    sent[column + SentCommand.VALUE + axis] = value + added
    sent[column + SentCommand.LINEAR + axis] = slope + gained
    sent[column + SentCommand.SQUARE + axis] = square
    sent[column + SentCommand.CUBE + axis] = cube


def join_commands(time: float, shortest: float, delayed: 'float[:,:]') -> None:
    """Make one command of the two newest, up to a time, that are shorter together than a bound [s].

    So the ring is large enough for any communication step. A tick, where forces jump, is kept.
    """
    newest = int(delayed[Delayed.QUEUE, CommandQueue.WAITING]) - 1
    if newest < 1:
        return
    row, column = command_place(newest, delayed)
    before, place = command_place(newest - 1, delayed)
    length = time - delayed[before, place + SentCommand.START]
    if delayed[row, column + SentCommand.AT_TICK] > 0.5 or length >= shortest:
        return
    after = time - delayed[row, column + SentCommand.START]
    for i in range(Axes.SIZE):
        value, _, _, _ = shifted_command(i, after, column, delayed[row, :])
        slope = (value - delayed[before, place + SentCommand.VALUE + i]) / length
        delayed[before, place + SentCommand.LINEAR + i] = slope
        delayed[before, place + SentCommand.SQUARE + i] = 0.0
        delayed[before, place + SentCommand.CUBE + i] = 0.0
    delayed[Delayed.QUEUE, CommandQueue.WAITING] = float(newest)


def drop_commands(time: float, delayed: 'float[:,:]') -> None:
    """Drop the commands that ended before a time [s], and the oldest if the ring is full."""
    queue = delayed[Delayed.QUEUE, :]
    size = Delay.COMMANDS_A_ROW * (delayed.shape[0] - Delayed.RING)
    while queue[CommandQueue.WAITING] > 1.5 and (
        command_start(1, delayed) <= time or queue[CommandQueue.WAITING] >= size
    ):
        queue[CommandQueue.OLDEST] = float((int(queue[CommandQueue.OLDEST]) + 1) % size)
        queue[CommandQueue.WAITING] = queue[CommandQueue.WAITING] - 1.0


def shifted_command(
    axis: int, after: float, column: int, sent: 'float[:]'
) -> 'tuple[float, float, float, float]':
    """Coefficients of a command of a row of the ring about a time [s] after its start."""
    cube = sent[column + SentCommand.CUBE + axis]
    square = sent[column + SentCommand.SQUARE + axis]
    linear = sent[column + SentCommand.LINEAR + axis]
    value = sent[column + SentCommand.VALUE + axis]
    value = value + after * (linear + after * (square + after * cube))
    linear = linear + after * (2.0 * square + 3.0 * after * cube)
    return value, linear, square + 3.0 * after * cube, cube


def command_number(time: float, delayed: 'float[:,:]') -> int:
    """The command of the ring that was sent at a time [s], counted from the oldest one."""
    first = 0
    last = int(delayed[Delayed.QUEUE, CommandQueue.WAITING]) - 1
    while first < last:
        middle = (first + last + 1) // 2
        if command_start(middle, delayed) <= time:
            first = middle
        else:
            last = middle - 1
    return first


def next_command(
    settings: 'float[:,:]', until: float, memory: 'float[:,:]', delayed: 'float[:,:]'
) -> float:
    """Time [s] within the step when a drive gets its next command, at most `until`."""
    clock = memory[Memory.CLOCK, :]
    first = until
    newest = int(delayed[Delayed.QUEUE, CommandQueue.WAITING]) - 1
    for i in range(Axes.SIZE):
        late = memory[Memory.PLANT, Plant.DEAD_TIME + i]
        latest = present_time(memory) - late + time_tolerance(settings)
        number = command_number(latest, delayed)
        if late > 0.0 and number < newest:
            due = command_start(number + 1, delayed) + late - clock[Clock.REACHED]
            if due < until - time_tolerance(settings):
                first = min(first, due)
    return first


def late_commands(
    settings: 'float[:,:]', length: float, memory: 'float[:,:]', delayed: 'float[:,:]'
) -> None:
    """Commands of the drives with a dead time for a length of time [s] from now on."""
    for i in range(Axes.SIZE):
        late = memory[Memory.PLANT, Plant.DEAD_TIME + i]
        if late > 0.0:
            time = present_time(memory) - late
            number = command_number(time + time_tolerance(settings), delayed)
            row, column = command_place(number, delayed)
            after = time - delayed[row, column + SentCommand.START]
            value, slope, square, cube = shifted_command(i, after, column, delayed[row, :])
            if is_driven(memory) and memory[Memory.PLANT, Plant.LAG + i] == 0.0:
                end = value + length * (slope + length * (square + length * cube))
                follow_velocity(i, end, square, cube, length, memory)
            else:
                set_command(i, value, slope, square, cube, memory)
