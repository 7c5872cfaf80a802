"""Signals that are old and drives that act late: what was, and what will be when corrections act.

Of an axis with the delay d + f samples, d whole and f a share, the estimate in memory is that of so
long ago. From tick to tick it advances by one sample; then it is predicted to the present under the
corrections made since. A dead time of the drive is as good as that much age of the signals: the
estimate is then of when the correction of this tick will act. A correction is held from tick to
tick, so that two of them act within a shifted sample; their mean takes their place, with the term
of second order in the sample time.

memory is a `Tracker`, parameters a `Tracking`.
"""

from segfmu.kernels.control.observer import observer_bend, observer_input, observer_predict
from segfmu.kernels.control.records import (
    AxisModel,
    Estimate,
    Held,
    History,
    Past,
    Tracker,
    Tracking,
    VelocityCommand,
)
from segfmu.kernels.crane.records import Axes, State


def remembered_ticks(parameters: 'float[:]') -> int:
    """Past ticks that the delays need."""
    longest = parameters[Tracking.AGE]
    for axis in range(Axes.SIZE):
        longest = max(longest, parameters[Tracking.DELAY + axis])
    return min(int(longest) + 3, History.MOST)


def remember_tick(
    parameters: 'float[:]', reference: 'float[:]', memory: 'float[:,:]'
) -> None:
    """Add the corrections since the tick before, and the reference of this one; advance commands.

    The first row then has the corrections that end now, and the reference that begins now.
    """
    held = memory[Tracker.HELD, :]
    command = memory[Tracker.COMMAND, :]
    rows = remembered_ticks(parameters)
    for back in range(rows - 1):
        row = Tracker.PAST + rows - 1 - back
        for i in range(Past.SIZE):
            memory[row, i] = memory[row - 1, i]
    for i in range(Axes.SIZE):
        memory[Tracker.PAST, Past.INPUT + i] = held[Held.INPUT + i]
        added = parameters[Tracking.PERIOD] * held[Held.INPUT + i]
        command[VelocityCommand.VELOCITY + i] = command[VelocityCommand.VELOCITY + i] + added
    for i in range(State.SIZE):
        memory[Tracker.PAST, Past.REFERENCE + i] = reference[i]


def remember_start(reference: 'float[:]', memory: 'float[:,:]') -> None:
    """Before the first tick the reference was as it is, and nothing was corrected."""
    for row in range(History.MOST):
        for i in range(State.SIZE):
            memory[Tracker.PAST + row, Past.REFERENCE + i] = reference[i]


def aged_reference(parameters: 'float[:]', memory: 'float[:,:]') -> None:
    """The reference of when the signals were taken, linear between the ticks."""
    age = parameters[Tracking.AGE]
    whole = min(int(age + 1e-9), History.MOST - 2)
    share = min(max(age - whole, 0.0), 1.0)
    for i in range(State.SIZE):
        later = memory[Tracker.PAST + whole, Past.REFERENCE + i]
        earlier = memory[Tracker.PAST + whole + 1, Past.REFERENCE + i]
        memory[Tracker.REFERENCE, i] = later + share * (earlier - later)


def advance_axis(
    axis: int,
    back: int,
    share: float,
    parameters: 'float[:]',
    length: float,
    table: 'float[:,:,:]',
    memory: 'float[:,:]',
    estimate: 'float[:]',
) -> None:
    """Advance an estimate of an axis by the sample that began `back` + 1 + share samples ago."""
    period = parameters[Tracking.PERIOD]
    before = memory[Tracker.PAST + back + 1, Past.INPUT + axis]
    after = memory[Tracker.PAST + back, Past.INPUT + axis]
    command = memory[Tracker.COMMAND, VelocityCommand.VELOCITY + axis] - share * period * before
    for i in range(back + 1):
        command = command - period * memory[Tracker.PAST + i, Past.INPUT + axis]
    observer_predict(
        axis, length, table, command, share * before + (1.0 - share) * after, estimate,
        memory[Tracker.INPUTS, :],
    )
    if share > 1e-9:
        # what acts earlier has moved the axis for longer
        change = memory[Tracker.CHANGE, :]
        observer_input(axis, length, table, period, before - after, change)
        observer_bend(axis, length, table, 0.5 * share * (1.0 - share), change, estimate)


def advance_estimates(
    parameters: 'float[:]', length: float, table: 'float[:,:,:]', memory: 'float[:,:]'
) -> None:
    """Bring the estimates from when the signals of the tick before were taken to those of now."""
    for axis in range(Axes.SIZE):
        delay = parameters[Tracking.DELAY + axis]
        whole = min(int(delay + 1e-9), History.MOST - 2)
        share = min(max(delay - whole, 0.0), 1.0)
        advance_axis(
            axis, whole, share, parameters, length, table, memory,
            memory[Tracker.ESTIMATE + axis, :],
        )


def predict_present(
    parameters: 'float[:]', length: float, table: 'float[:,:,:]', memory: 'float[:,:]'
) -> None:
    """Predict the estimates to when the correction of this tick will act."""
    for axis in range(Axes.SIZE):
        delay = parameters[Tracking.DELAY + axis]
        whole = min(int(delay + 1e-9), History.MOST - 2)
        share = min(max(delay - whole, 0.0), 1.0)
        present = memory[Tracker.PRESENT + axis, :]
        for i in range(Estimate.SIZE):
            present[i] = memory[Tracker.ESTIMATE + axis, i]
        for back in range(whole):
            advance_axis(
                axis, whole - 1 - back, share, parameters, length, table, memory, present
            )
        if share > 1e-9:
            predict_share(axis, share, parameters, length, table, memory)


def predict_share(
    axis: int,
    share: float,
    parameters: 'float[:]',
    length: float,
    table: 'float[:,:,:]',
    memory: 'float[:,:]',
) -> None:
    """The last part of a sample: a parabola through the estimates at its ends."""
    present = memory[Tracker.PRESENT + axis, :]
    ahead = memory[Tracker.AHEAD, :]
    change = memory[Tracker.CHANGE, :]
    for i in range(Estimate.SIZE):
        ahead[i] = present[i]
    latest = memory[Tracker.PAST, Past.INPUT + axis]
    command = memory[Tracker.COMMAND, VelocityCommand.VELOCITY + axis]
    command = command - share * parameters[Tracking.PERIOD] * latest
    observer_predict(
        axis, length, table, command, latest, ahead, memory[Tracker.INPUTS, :]
    )
    for i in range(Estimate.SIZE):
        change[i] = ahead[i] - present[i]
        present[i] = present[i] + share * change[i]
    change[AxisModel.COMMAND] = parameters[Tracking.PERIOD] * latest
    observer_bend(axis, length, table, -0.5 * share * (1.0 - share), change, present)
