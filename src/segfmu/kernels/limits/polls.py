"""Polls of a search: free states are changed one after the other.

Durations jump with them, so slopes alone do not lead on. search: `Search`.
"""

from segfmu.kernels.limits.records import (
    Search,
    SearchStage,
    SearchState,
    Unknown,
)
from segfmu.kernels.limits.trials import (
    enter_paces,
    merit_of,
)
from segfmu.kernels.numerics.numbers import NEVER


def enter_poll(search: 'float[:,:]') -> bool:
    """Begin to poll the free states of the row CENTRE; the first trial changes nothing."""
    state = search[Search.STATE, :]
    state[SearchState.STAGE] = SearchStage.POLL
    state[SearchState.WANTED] = NEVER
    state[SearchState.UNKNOWN] = -1.0
    state[SearchState.WAY] = -1.0
    for i in range(int(state[SearchState.UNKNOWNS])):
        search[Search.TRIAL, i] = search[Search.ORIGIN, i] + search[Search.CENTRE, i]
    return True


def next_poll(duration: float, uses: 'float[:]', search: 'float[:,:]') -> bool:
    """Keep a change of a free state that is worth it; whether there is another one to try."""
    state = search[Search.STATE, :]
    n = int(state[SearchState.UNKNOWNS])
    if duration >= 0.0:
        merit = merit_of(duration, uses)
        if merit < state[SearchState.WANTED] - 1e-4:
            state[SearchState.WANTED] = merit
            for i in range(n):
                search[Search.CENTRE, i] = search[Search.TRIAL, i] - search[Search.ORIGIN, i]
    while state[SearchState.UNKNOWN] < n:
        i = int(state[SearchState.UNKNOWN])
        way = int(state[SearchState.WAY]) + 1
        if i < 0 or way > 3 or int(search[Search.KIND, i]) != Unknown.STATE:
            state[SearchState.UNKNOWN] = state[SearchState.UNKNOWN] + 1.0
            state[SearchState.WAY] = -1.0
        else:
            state[SearchState.WAY] = way
            here = search[Search.ORIGIN, i] + search[Search.CENTRE, i]
            changed = min(max(here + poll_change(way), -1.0), 1.0)
            if abs(changed - here) > 1e-6:
                for j in range(n):
                    search[Search.TRIAL, j] = search[Search.ORIGIN, j] + search[Search.CENTRE, j]
                search[Search.TRIAL, i] = changed
                return True
    return False


def poll_change(way: int) -> float:
    """By how much a free state is changed, in shares of its limit."""
    size = 0.15
    if way > 1:
        size = 0.45
    if way % 2 == 1:
        return -size
    return size


def leave_poll(search: 'float[:,:]') -> bool:
    """Descend from the point that was found, at its pace."""
    state = search[Search.STATE, :]
    for i in range(int(state[SearchState.UNKNOWNS])):
        search[Search.BASE, i] = search[Search.CENTRE, i]
    state[SearchState.STAGE] = SearchStage.ENTER
    enter_paces(NEVER, search)
    return True
