"""The last search: one free state after the other is moved while its two intervals get shorter.

Arrays as in judge.py. A move changes the profiles of one axis in two intervals; the others stay.
The planner makes a quick effort (Effort), which takes five sixths of the time and hardly changes
the result.
"""

from segfmu.kernels.numerics.numbers import HALVINGS, NEVER, TIE
from segfmu.kernels.passage.judge import (
    leaves_box,
    meet_at,
    plan_alone,
    plan_lengths,
    shortest_of,
)
from segfmu.kernels.passage.path import FASTER, LAST_GAP
from segfmu.kernels.passage.records import Free, Link, Path, Spot, Stretch
from segfmu.kernels.passage.search import highest_state
from segfmu.kernels.planner.plan import set_problems
from segfmu.kernels.planner.records import Axis, Cell, Effort, Interval, WaypointState

# a state is moved by LAST_GAP of half its range at first, by less (FASTER) in each sweep; a fourth
# one gains 0.05 % for a fourth more plans
SWEEPS = 3


def keep_cells(
    point: int, axis: int, back: bool, axes: 'float[:,:]', cells: 'float[:,:,:]',
    links: 'float[:,:,:]',
) -> None:
    """Keep what is known of an axis in the intervals beside a waypoint, or bring it back."""
    for place in range(point - 1, point + 1):
        i = place * axes.shape[0] + axis
        if back:
            cells[i, Cell.RESULT, Interval.SHORTEST] = links[i, Link.KEPT, 0]
            cells[i, Cell.RESULT, Interval.PASSING] = links[i, Link.KEPT, 1]
        else:
            links[i, Link.KEPT, 0] = cells[i, Cell.RESULT, Interval.SHORTEST]
            links[i, Link.KEPT, 1] = cells[i, Cell.RESULT, Interval.PASSING]


def forget_profiles(point: int, axis: int, axes: 'float[:,:]', cells: 'float[:,:,:]') -> None:
    """Mark the phases of an axis beside a waypoint as those of other states (`set_stretched`)."""
    for place in range(point - 1, point + 1):
        cells[place * axes.shape[0] + axis, Cell.RESULT, Interval.ABOVE_COUNT] = 1.0


def set_state(
    value: float, point: int, axis: int, field: int, states: 'float[:,:,:]', axes: 'float[:,:]',
    cells: 'float[:,:,:]',
) -> None:
    """Write a state, and the boundary problems beside it."""
    states[point, axis, WaypointState.VELOCITY + field] = value
    count = axes.shape[0]
    first = (point - 1) * count
    set_problems(states[point - 1:point + 2, :, :], cells[first:first + 2 * count, :, :])


def longest_of(place: int, without: int, axes: 'float[:,:]', cells: 'float[:,:,:]') -> float:
    """The longest of the shortest durations of all axes but one in an interval [s]."""
    longest = 0.0
    for other in range(axes.shape[0]):
        if other != without:
            longest = max(longest, shortest_of(place, other, axes, cells))
    return longest


def tried_length(
    point: int, axis: int, states: 'float[:,:,:]', path: 'float[:]', links: 'float[:,:,:]',
    spans: 'float[:,:]', axes: 'float[:,:]', cells: 'float[:,:,:]', timing: 'float[:,:]',
    coefficients: 'float[:,:]', work: 'float[:,:]',
) -> float:
    """Duration of the two intervals beside a waypoint [s] after a state of an axis has changed.

    NEVER if that is no less than KNOWN of the path, leaves a box, or lies in a gap of an axis: to
    search for its end takes longer than all else, and gains nothing.
    """
    # the other axes alone may already take as long
    least = 0.0
    for place in range(point - 1, point + 1):
        spans[place, Stretch.TRIED] = longest_of(place, axis, axes, cells)
        least = least + spans[place, Stretch.TRIED]
    for place in range(point - 1, point + 1):
        if not least < path[Path.KNOWN]:
            return NEVER
        if not plan_alone(place, axis, axes, cells, work):
            return NEVER
        later = max(shortest_of(place, axis, axes, cells) - spans[place, Stretch.TRIED], 0.0)
        spans[place, Stretch.TRIED] = spans[place, Stretch.TRIED] + later
        least = least + later
    if not least < path[Path.KNOWN]:
        return NEVER
    for place in range(point - 1, point + 1):
        if not meet_at(spans[place, Stretch.TRIED], place, axes, cells, work):
            return NEVER
    for place in range(point - 1, point + 1):
        if leaves_box(place, states, path, links, axes, cells, timing, coefficients, work):
            return NEVER
    return spans[point - 1, Stretch.TRIED] + spans[point, Stretch.TRIED]


def polish_state(
    spot: int, field: int, states: 'float[:,:,:]', path: 'float[:]', links: 'float[:,:,:]',
    spans: 'float[:,:]', axes: 'float[:,:]', cells: 'float[:,:,:]', timing: 'float[:,:]',
    coefficients: 'float[:,:]', work: 'float[:,:]',
) -> None:
    """Move a state of a spot within its limits, the way that gains more, as long as it gains."""
    point = spot // axes.shape[0]
    axis = spot % axes.shape[0]
    high = highest_state(field, axes[axis, Axis.VELOCITY + field])
    low = -highest_state(field, axes[axis, Axis.LOWER + field])
    least = spans[point - 1, Stretch.LENGTH] + spans[point, Stretch.LENGTH]
    move = path[Path.STEP] * 0.5 * (high - low)
    before = NEVER
    # both ways first, then the better one
    for trial in range(HALVINGS):
        here = states[point, axis, WaypointState.VELOCITY + field]
        value = min(max(here + move, low), high)
        keep_cells(point, axis, False, axes, cells, links)
        set_state(value, point, axis, field, states, axes, cells)
        path[Path.KNOWN] = least / TIE
        found = tried_length(
            point, axis, states, path, links, spans, axes, cells, timing, coefficients, work
        )
        if trial > 1 and found < NEVER:
            least = found
            for place in range(point - 1, point + 1):
                spans[place, Stretch.LENGTH] = spans[place, Stretch.TRIED]
            continue
        set_state(here, point, axis, field, states, axes, cells)
        keep_cells(point, axis, True, axes, cells, links)
        forget_profiles(point, axis, axes, cells)
        if trial > 1:
            return
        if trial == 0:
            before = found
            move = -move
        elif before >= NEVER and found >= NEVER:
            return
        elif before <= found:
            move = -move


def polish_states(
    states: 'float[:,:,:]', path: 'float[:]', spots: 'float[:,:,:]', links: 'float[:,:,:]',
    spans: 'float[:,:]', axes: 'float[:,:]', cells: 'float[:,:,:]', timing: 'float[:,:]',
    coefficients: 'float[:,:]', work: 'float[:,:]',
) -> float:
    """Move all states that are chosen, by smaller and smaller steps; the duration then [s]."""
    count = axes.shape[0]
    plan_lengths(states, spans, axes, cells, work)
    for axis in range(count):
        axes[axis, Axis.EFFORT] = Effort.QUICK
    path[Path.STEP] = LAST_GAP
    for sweep in range(SWEEPS):
        for point in range(1, states.shape[0] - 1):
            for spot in range(point * count, (point + 1) * count):
                for field in range(Free.SIZE):
                    if spots[spot, Spot.CHOSEN, field] != 0.0:
                        polish_state(
                            spot, field, states, path, links, spans, axes, cells, timing,
                            coefficients, work,
                        )
        path[Path.STEP] = path[Path.STEP] / FASTER
    for axis in range(count):
        axes[axis, Axis.EFFORT] = Effort.USUAL
    total = 0.0
    for j in range(spans.shape[0]):
        total = total + spans[j, Stretch.LENGTH]
    return total
