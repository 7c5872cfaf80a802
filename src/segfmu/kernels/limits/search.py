"""The search for limits, and free states, with which a plan within the bounds is shortest.

Whoever plans calls `next_limits` with the duration of the last trial and its uses of the bounds,
until it tells that the row BEST is the result. Each point is judged at the pace at which it just
keeps the bounds. From the shortest starts the search descends: it changes each unknown by a little,
takes the step that is best as far as these slopes tell (`write_step`), and goes on where that made
the plan shorter, else with smaller steps. Where states are free, those of a point are first polled
one after the other, as durations jump with them.

search: `Search`; values: `SearchValues`; slopes: duration and uses (n, 1 + 28) by unknown; newton:
(2 n, n) for n unknowns.
"""

from segfmu.kernels.limits.polls import (
    enter_poll,
    leave_poll,
    next_poll,
)
from segfmu.kernels.limits.records import (
    LimitRow,
    Search,
    SearchStage,
    SearchState,
    SearchValues,
    Starts,
    Unknown,
    Values,
)
from segfmu.kernels.limits.slopes import (
    correct_slopes,
    enter_slopes,
    next_slope,
)
from segfmu.kernels.limits.step import write_step
from segfmu.kernels.limits.trials import (
    enter_paces,
    has_states,
    next_of_paces,
)
from segfmu.kernels.numerics.numbers import NEVER


def begin_limits(starts: 'float[:,:]', kinds: 'float[:]', search: 'float[:,:]') -> None:
    """Begin a search from starts, one per row; the first trial is the first of them.

    kinds (n,): what each unknown is, see `Unknown`; the limits of all axes come first.
    """
    n = kinds.shape[0]
    state = search[Search.STATE, :]
    for i in range(SearchState.SIZE):
        state[i] = 0.0
    for i in range(n):
        search[Search.KIND, i] = kinds[i]
        search[Search.ORDER, i] = 0.0
        if int(kinds[i]) == Unknown.LIMIT:
            # velocity to snap, then velocity and acceleration again
            search[Search.ORDER, i] = 1.0 + i % LimitRow.SIZE % LimitRow.VELOCITY_MIN
    state[SearchState.UNKNOWNS] = n
    state[SearchState.STAGE] = SearchStage.START
    state[SearchState.BEST] = NEVER
    for slot in range(Starts.DESCENTS):
        search[Search.DURATIONS, slot] = NEVER
    enter_start(starts, search)


def next_limits(
    duration: float,
    uses: 'float[:]',
    starts: 'float[:,:]',
    search: 'float[:,:]',
    values: 'float[:,:]',
    slopes: 'float[:,:]',
    newton: 'float[:,:]',
) -> bool:
    """Whether another trial is needed, the row TRIAL.

    duration [s] of the last one, below 0 if it has no plan or one that may not be taken; uses
    (28,) of the bounds in the positive, then in the negative direction.
    """
    state = search[Search.STATE, :]
    stage = int(state[SearchState.STAGE])
    if stage == SearchStage.POLL:
        if next_poll(duration, uses, search):
            return True
        return leave_poll(search)
    if stage == SearchStage.SLOPE:
        if next_slope(duration, uses, search, values, slopes):
            return True
        return enter_step(search, values, slopes, newton)
    if next_of_paces(duration, uses, search, values):
        return True
    if stage == SearchStage.START:
        note_start(search)
        state[SearchState.START] = state[SearchState.START] + 1.0
        if int(state[SearchState.START]) < starts.shape[0]:
            enter_start(starts, search)
            return True
        state[SearchState.START] = -1.0
        return enter_descent(search)
    if stage == SearchStage.ENTER:
        return enter_round(search, values)
    return judge_step(search, values, slopes, newton)


def enter_start(starts: 'float[:,:]', search: 'float[:,:]') -> None:
    """Begin with a start at its own pace."""
    row = int(search[Search.STATE, SearchState.START])
    for i in range(starts.shape[1]):
        search[Search.ORIGIN, i] = starts[row, i]
        search[Search.BASE, i] = 0.0
    # it is to become one of the shortest
    enter_paces(search[Search.DURATIONS, Starts.DESCENTS - 1], search)


def note_start(search: 'float[:,:]') -> None:
    """Keep a start at its pace if it is among the shortest; the earlier one of equals."""
    state = search[Search.STATE, :]
    n = int(state[SearchState.UNKNOWNS])
    found = state[SearchState.KEPT]
    slot = int(Starts.DESCENTS)
    while slot > 0 and found < search[Search.DURATIONS, slot - 1] - 1e-9:
        slot = slot - 1
        if slot + 1 < Starts.DESCENTS:
            search[Search.DURATIONS, slot + 1] = search[Search.DURATIONS, slot]
            for i in range(n):
                search[Search.CHOSEN + slot + 1, i] = search[Search.CHOSEN + slot, i]
    if slot < Starts.DESCENTS:
        search[Search.DURATIONS, slot] = found
        for i in range(n):
            search[Search.CHOSEN + slot, i] = search[Search.ORIGIN, i] + search[Search.KEPT, i]


def enter_descent(search: 'float[:,:]') -> bool:
    """Descend from the next of the chosen starts; False if there is none."""
    state = search[Search.STATE, :]
    state[SearchState.START] = state[SearchState.START] + 1.0
    slot = int(state[SearchState.START])
    if slot == Starts.DESCENTS or search[Search.DURATIONS, slot] >= NEVER:
        return False
    for i in range(int(state[SearchState.UNKNOWNS])):
        search[Search.ORIGIN, i] = search[Search.CHOSEN + slot, i]
        search[Search.CENTRE, i] = 0.0
        search[Search.BASE, i] = 0.0
    state[SearchState.ROUND] = 0.0
    if has_states(search):
        state[SearchState.BEFORE] = search[Search.DURATIONS, slot]
        return enter_poll(search)
    state[SearchState.STAGE] = SearchStage.ENTER
    enter_paces(NEVER, search)
    return True


def enter_centre(search: 'float[:,:]', values: 'float[:,:]') -> None:
    """Go on from the row KEPT."""
    for i in range(int(search[Search.STATE, SearchState.UNKNOWNS])):
        search[Search.CENTRE, i] = search[Search.KEPT, i]
    for i in range(Values.SIZE):
        values[SearchValues.CENTRE, i] = values[SearchValues.KEPT, i]


def enter_round(search: 'float[:,:]', values: 'float[:,:]') -> bool:
    """Descend from a point at its pace, if it has a plan."""
    state = search[Search.STATE, :]
    if state[SearchState.KEPT] >= NEVER:
        return enter_descent(search)
    enter_centre(search, values)
    state[SearchState.STEPS] = 0.0
    # of logarithms of limits
    state[SearchState.RADIUS] = 0.3
    return enter_slopes(search)


def enter_step(
    search: 'float[:,:]', values: 'float[:,:]', slopes: 'float[:,:]', newton: 'float[:,:]'
) -> bool:
    """Try the best step within the radius."""
    state = search[Search.STATE, :]
    write_step(search, values, slopes, newton)
    if state[SearchState.PREDICTED] <= worth_while():
        if state[SearchState.STALE] > 0.5:
            return enter_slopes(search)
        return leave_round(search)
    # a descent that would need many such steps to the best plan is given up
    behind = values[SearchValues.CENTRE, Values.DURATION] - state[SearchState.BEST]
    if behind > 0.01 and behind > 4.0 * state[SearchState.PREDICTED]:
        return leave_round(search)
    for i in range(int(state[SearchState.UNKNOWNS])):
        search[Search.BASE, i] = search[Search.CENTRE, i] + search[Search.STEP, i]
    state[SearchState.STAGE] = SearchStage.STEP
    enter_paces(values[SearchValues.CENTRE, Values.DURATION], search)
    return True


def worth_while() -> float:
    """The least gain, of logarithms of durations, that is worth a step."""
    return 5e-4


def judge_step(
    search: 'float[:,:]', values: 'float[:,:]', slopes: 'float[:,:]', newton: 'float[:,:]'
) -> bool:
    """Take a step that made the plan shorter, else try a smaller one.

    The radius grows where the plan gained about what the slopes promised, and shrinks where it did
    not: the slopes hold as far as that. Where they held, and durations do not jump with free
    states, they are corrected by what the step told (Broyden, Mathematics of Computation 19, 1965).
    """
    state = search[Search.STATE, :]
    gain = values[SearchValues.CENTRE, Values.DURATION] - state[SearchState.KEPT]
    if gain > 0.2 * worth_while():
        if gain > 0.7 * state[SearchState.PREDICTED]:
            state[SearchState.RADIUS] = min(1.5 * state[SearchState.RADIUS], 1.0)
        elif gain < 0.3 * state[SearchState.PREDICTED]:
            state[SearchState.RADIUS] = 0.6 * state[SearchState.RADIUS]
        state[SearchState.STEPS] = state[SearchState.STEPS] + 1.0
        if state[SearchState.STEPS] > 11.5:
            return leave_round(search)
        correct_slopes(search, values, slopes)
        enter_centre(search, values)
        if has_states(search) or gain < 0.5 * state[SearchState.PREDICTED]:
            return enter_slopes(search)
        state[SearchState.STALE] = 1.0
        return enter_step(search, values, slopes, newton)
    if state[SearchState.STALE] > 0.5:
        return enter_slopes(search)
    state[SearchState.RADIUS] = 0.4 * state[SearchState.RADIUS]
    if state[SearchState.RADIUS] < least_radius(search):
        return leave_round(search)
    return enter_step(search, values, slopes, newton)


def least_radius(search: 'float[:,:]') -> float:
    """The least radius of a step: small ones gain where durations jump with free states."""
    if has_states(search):
        return 0.01
    return 0.02


def leave_round(search: 'float[:,:]') -> bool:
    """Poll free states again if the round was worth 0.2 %, else go on with the next start."""
    state = search[Search.STATE, :]
    state[SearchState.ROUND] = state[SearchState.ROUND] + 1.0
    gain = state[SearchState.BEFORE] - state[SearchState.BEST]
    if not has_states(search) or gain < 2e-3 or state[SearchState.ROUND] > 7.5:
        return enter_descent(search)
    state[SearchState.BEFORE] = state[SearchState.BEST]
    return enter_poll(search)
