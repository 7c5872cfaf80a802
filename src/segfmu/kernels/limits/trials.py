"""Trials of a search at the pace at which a plan just keeps the bounds.

search: `Search`; values: `SearchValues`.
"""

from math import floor, log

from segfmu.kernels.crane.records import Demand
from segfmu.kernels.limits.pace import begin_pace, next_pace
from segfmu.kernels.limits.records import (
    AxisTask,
    LimitRow,
    Pace,
    Search,
    SearchStage,
    SearchState,
    SearchValues,
    Unknown,
    Values,
)
from segfmu.kernels.numerics.numbers import NEVER


def enter_paces(wanted: float, search: 'float[:,:]') -> None:
    """Try the row BASE at the pace at which it just keeps the bounds, to 0.5 %.

    wanted: only plans with a smaller logarithm of the duration are of use.
    """
    state = search[Search.STATE, :]
    state[SearchState.WANTED] = wanted
    begin_pace(1e3, 0.995, search[Search.PACE, :])
    state[SearchState.TRIALS] = 0.0
    state[SearchState.FAILURES] = 0.0
    state[SearchState.KEPT] = NEVER
    write_paced(search)


def without_digits(value: float) -> float:
    """A value rounded to 2^-20: its last digits differ from processor to processor."""
    return floor(value * 1048576.0 + 0.5) / 1048576.0


def write_paced(search: 'float[:,:]') -> None:
    """Write the trial: the row BASE at the pace."""
    faster = log(search[Search.PACE, Pace.PACE])
    for i in range(int(search[Search.STATE, SearchState.UNKNOWNS])):
        moved = search[Search.BASE, i] + search[Search.ORDER, i] * faster
        search[Search.TRIAL, i] = search[Search.ORIGIN, i] + without_digits(moved)


def log_of(duration: float) -> float:
    """Logarithm of a duration [s], which may be 0."""
    return log(max(duration, 1e-300))


def next_of_paces(
    duration: float, uses: 'float[:]', search: 'float[:,:]', values: 'float[:,:]'
) -> bool:
    """Note a plan at a pace; whether another pace is tried, of six at most."""
    state = search[Search.STATE, :]
    use = NEVER
    if duration >= 0.0:
        use = largest_share(uses)
        if use <= 1.0 + 1e-9 and log_of(duration) < state[SearchState.KEPT] - 1e-9:
            state[SearchState.KEPT] = log_of(duration)
            write_values(duration, uses, values[SearchValues.KEPT, :])
            for i in range(int(state[SearchState.UNKNOWNS])):
                search[Search.KEPT, i] = search[Search.TRIAL, i] - search[Search.ORIGIN, i]
            note_best(search)
    else:
        state[SearchState.FAILURES] = state[SearchState.FAILURES] + 1.0
    state[SearchState.TRIALS] = state[SearchState.TRIALS] + 1.0
    if state[SearchState.TRIALS] > 5.5 or state[SearchState.FAILURES] > 1.5:
        return False
    if not next_pace(use, search[Search.PACE, :]):
        return False
    if duration >= 0.0 and is_hopeless(duration, search):
        return False
    write_paced(search)
    return True


def is_hopeless(duration: float, search: 'float[:,:]') -> bool:
    """Whether a plan at the next pace, after one of a duration [s], would be of no use to a step.

    That pace is an estimate: nine tenths of its distance in logarithms are doubted.
    """
    state = search[Search.STATE, :]
    if int(state[SearchState.STAGE]) != SearchStage.STEP:
        return False
    faster = log(search[Search.PACE, Pace.PACE] / search[Search.PACE, Pace.LAST])
    return log_of(duration) - faster - 0.9 * abs(faster) > state[SearchState.WANTED]


def has_states(search: 'float[:,:]') -> bool:
    """Whether states are free."""
    for i in range(int(search[Search.STATE, SearchState.UNKNOWNS])):
        if int(search[Search.KIND, i]) == Unknown.STATE:
            return True
    return False


def is_judged(duration: float, uses: 'float[:]', search: 'float[:,:]') -> bool:
    """Whether the path of the last trial has to be judged, as the trial would be taken else.

    Slopes of free states are judged as well, as they lead astray.
    """
    state = search[Search.STATE, :]
    stage = int(state[SearchState.STAGE])
    if stage == SearchStage.SLOPE:
        return has_states(search)
    if stage == SearchStage.POLL:
        return merit_of(duration, uses) < state[SearchState.WANTED] - 1e-4
    kept = largest_share(uses) <= 1.0 + 1e-9
    useful = min(state[SearchState.KEPT] - 1e-9, state[SearchState.WANTED])
    return kept and log_of(duration) < useful


def merit_of(duration: float, uses: 'float[:]') -> float:
    """About the logarithm of a duration [s] at the pace at which a plan just keeps the bounds."""
    return log_of(duration) + 0.5 * log(max(largest_share(uses), 1e-9))


def largest_share(uses: 'float[:]') -> float:
    """The largest use."""
    found = 0.0
    for i in range(2 * Demand.SIZE):
        found = max(found, uses[i])
    return found


def write_values(duration: float, uses: 'float[:]', row: 'float[:]') -> None:
    """Write a row of `Values`."""
    row[Values.DURATION] = log_of(duration)
    for i in range(2 * Demand.SIZE):
        row[Values.USE + i] = uses[i]


def note_best(search: 'float[:,:]') -> None:
    """Keep the plan of the row KEPT if it is the shortest."""
    state = search[Search.STATE, :]
    if state[SearchState.KEPT] < state[SearchState.BEST] - 1e-9:
        state[SearchState.BEST] = state[SearchState.KEPT]
        for i in range(int(state[SearchState.UNKNOWNS])):
            search[Search.BEST, i] = search[Search.TRIAL, i]


def cap_best(axes: 'float[:,:]', search: 'float[:,:]') -> None:
    """Lower the limits of the row BEST to their caps, so that it is one motion at slower paces."""
    for axis in range(axes.shape[0]):
        for i in range(LimitRow.SIZE):
            known = axis * LimitRow.SIZE + i
            most = log(axes[axis, AxisTask.CAP + i])
            search[Search.BEST, known] = min(search[Search.BEST, known], most)


def write_best(pace: float, search: 'float[:,:]') -> None:
    """Write the trial: the row BEST, faster by a factor."""
    faster = log(pace)
    for i in range(int(search[Search.STATE, SearchState.UNKNOWNS])):
        search[Search.TRIAL, i] = search[Search.BEST, i] + search[Search.ORDER, i] * faster


def keep_best(pace: float, search: 'float[:,:]') -> None:
    """Make the row BEST faster by a factor."""
    write_best(pace, search)
    for i in range(int(search[Search.STATE, SearchState.UNKNOWNS])):
        search[Search.BEST, i] = search[Search.TRIAL, i]
