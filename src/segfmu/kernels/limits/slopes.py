"""The slopes of a search: how duration and uses change with each unknown, one after the other.

search: `Search`; values: `SearchValues`; slopes: duration and uses (n, 1 + 28) by unknown.
"""

from segfmu.kernels.crane.records import Demand
from segfmu.kernels.limits.records import (
    Search,
    SearchStage,
    SearchState,
    SearchValues,
    Unknown,
    Values,
)
from segfmu.kernels.limits.trials import log_of


def enter_slopes(search: 'float[:,:]') -> bool:
    """Find the slopes at the row CENTRE."""
    state = search[Search.STATE, :]
    state[SearchState.STAGE] = SearchStage.SLOPE
    state[SearchState.UNKNOWN] = -1.0
    state[SearchState.WAY] = 1.0
    state[SearchState.STALE] = 0.0
    return write_changed(search)


def write_changed(search: 'float[:,:]') -> bool:
    """Write the trial with the next unknown changed, first less, then more; False after the last.

    A change of more is tried only if that of less has no plan.
    """
    state = search[Search.STATE, :]
    n = int(state[SearchState.UNKNOWNS])
    changed = int(state[SearchState.UNKNOWN])
    if state[SearchState.WAY] > 0.5:
        changed = changed + 1
        while changed < n and int(search[Search.KIND, changed]) == Unknown.GIVEN:
            changed = changed + 1
        state[SearchState.WAY] = 0.0
    else:
        state[SearchState.WAY] = 1.0
    state[SearchState.UNKNOWN] = changed
    if changed >= n:
        return False
    for i in range(n):
        search[Search.TRIAL, i] = search[Search.ORIGIN, i] + search[Search.CENTRE, i]
    search[Search.TRIAL, changed] = search[Search.TRIAL, changed] + change_of(search)
    return True


def change_of(search: 'float[:,:]') -> float:
    """By how much an unknown is changed for its slope: more than samples miss of a peak."""
    size = 0.02
    if int(search[Search.KIND, int(search[Search.STATE, SearchState.UNKNOWN])]) == Unknown.STATE:
        size = 0.01
    if search[Search.STATE, SearchState.WAY] > 0.5:
        return size
    return -size


def next_slope(
    duration: float, uses: 'float[:]', search: 'float[:,:]', values: 'float[:,:]',
    slopes: 'float[:,:]',
) -> bool:
    """Note a slope; whether there is another one to find."""
    state = search[Search.STATE, :]
    i = int(state[SearchState.UNKNOWN])
    search[Search.FREE, i] = 0.0
    if duration >= 0.0:
        search[Search.FREE, i] = 1.0
        change = change_of(search)
        centre = values[SearchValues.CENTRE, :]
        slopes[i, Values.DURATION] = (log_of(duration) - centre[Values.DURATION]) / change
        for j in range(2 * Demand.SIZE):
            slopes[i, Values.USE + j] = (uses[j] - centre[Values.USE + j]) / change
        state[SearchState.WAY] = 1.0
    return write_changed(search)


def correct_slopes(
    search: 'float[:,:]', values: 'float[:,:]', slopes: 'float[:,:]'
) -> None:
    """Change the slopes, by as little as possible, to those that lead from CENTRE to KEPT."""
    n = int(search[Search.STATE, SearchState.UNKNOWNS])
    squared = 0.0
    for i in range(n):
        change = search[Search.FREE, i] * (search[Search.KEPT, i] - search[Search.CENTRE, i])
        search[Search.STEP, i] = change
        squared = squared + change * change
    if squared <= 0.0:
        return
    for j in range(Values.SIZE):
        missing = values[SearchValues.KEPT, j] - values[SearchValues.CENTRE, j]
        for i in range(n):
            missing = missing - slopes[i, j] * search[Search.STEP, i]
        for i in range(n):
            slopes[i, j] = slopes[i, j] + missing * search[Search.STEP, i] / squared
