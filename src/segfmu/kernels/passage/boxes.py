"""The range of the positions between two waypoints, and the states that it admits.

links and spots are those of a passage, whose first waypoint is `first` of all `given` ones.
"""

from segfmu.kernels.numerics.numbers import NEARLY, NEVER
from segfmu.kernels.passage.judge import farthest_beyond, plan_lengths
from segfmu.kernels.passage.records import Free, Link, Path, Spot, Track
from segfmu.kernels.planner.records import WaypointState


def write_boxes(
    room: float, first: int, given: 'float[:,:,:]', path: 'float[:]', axes: 'float[:,:]',
    links: 'float[:,:,:]',
) -> None:
    """Write the range of two waypoints, the one before and the one after them, and `room` of it.

    The waypoints are inside, whatever range is allowed.
    """
    count = int(path[Path.AXES])
    farthest = 0.0
    for i in range(links.shape[0]):
        point = first + i // count
        axis = i % count
        here = given[point, axis, WaypointState.POSITION]
        there = given[point + 1, axis, WaypointState.POSITION]
        farthest = max(farthest, abs(there - here))
        before = given[max(point - 1, 0), axis, WaypointState.POSITION]
        last = min(point + 2, given.shape[0] - 1)
        after = given[last, axis, WaypointState.POSITION]
        low = min(min(here, there), min(before, after))
        high = max(max(here, there), max(before, after))
        beyond = room * (high - low) if room < NEVER else NEVER
        # boxes are narrower by twice the margin
        inwards = 2.0 * NEARLY * extent(axis, given)
        low = max(low - beyond, axes[axis, Track.ALLOWED] + inwards)
        high = min(high + beyond, axes[axis, Track.ALLOWED + 1] - inwards)
        links[i, Link.BOX, 0] = min(low, min(here, there))
        links[i, Link.BOX, 1] = max(high, max(here, there))
    for i in range(links.shape[0]):
        links[i, Link.BOX, 2] = NEARLY * farthest


def extent(axis: int, given: 'float[:,:,:]') -> float:
    """Range of an axis' positions at all waypoints [m]."""
    low = given[0, axis, WaypointState.POSITION]
    high = low
    for point in range(given.shape[0]):
        low = min(low, given[point, axis, WaypointState.POSITION])
        high = max(high, given[point, axis, WaypointState.POSITION])
    return high - low


def admit_states(
    states: 'float[:,:,:]', path: 'float[:]', spots: 'float[:,:,:]', links: 'float[:,:,:]'
) -> bool:
    """Write which states are chosen; false if none is.

    None at the ends, no velocity where a motion would leave the range, nothing of an axis that may
    not move.
    """
    count = int(path[Path.AXES])
    found = False
    for i in range(spots.shape[0]):
        axis = i % count
        inner = count <= i < spots.shape[0] - count
        turns, fixed = False, False
        if inner:
            here = states[i // count, axis, WaypointState.POSITION]
            for j in range(2):
                low = links[i - j * count, Link.BOX, 0]
                high = links[i - j * count, Link.BOX, 1]
                turns = turns or here == low or here == high
                fixed = fixed or low == high
        for field in range(Free.SIZE):
            admitted = inner and spots[i, Spot.FREE, field] != 0.0
            if field == Free.VELOCITY:
                admitted = admitted and not turns
            else:
                admitted = admitted and not fixed
            spots[i, Spot.ADMITTED, field] = admitted
            spots[i, Spot.CHOSEN, field] = admitted
            found = found or admitted
    return found


def is_moving(states: 'float[:,:,:]') -> bool:
    """Whether a velocity or acceleration is not zero."""
    for point in range(states.shape[0]):
        for axis in range(states.shape[1]):
            for i in range(WaypointState.VELOCITY, WaypointState.SIZE):
                if states[point, axis, i] != 0.0:
                    return True
    return False


def widen_boxes(
    room: float, states: 'float[:,:,:]', path: 'float[:]', links: 'float[:,:,:]',
    spans: 'float[:,:]', axes: 'float[:,:]', cells: 'float[:,:,:]', timing: 'float[:,:]',
    coefficients: 'float[:,:]', work: 'float[:,:]',
) -> None:
    """Widen the boxes to what given states need, and by `room` of that.

    It is what the plan needs that rests in the free ones.
    """
    count = int(path[Path.AXES])
    if is_moving(states):
        planned = plan_lengths(states, spans, axes, cells, work) < NEVER
        for i in range(links.shape[0]):
            axis = i % count
            low = links[i, Link.BOX, 0]
            high = links[i, Link.BOX, 1]
            here = states[i // count, axis, WaypointState.POSITION]
            for side in range(2):
                beyond = NEVER
                if planned and high - low < NEVER:
                    beyond = farthest_beyond(
                        side, low, high, here, cells[i, :, :], axes[axis, :], timing,
                        coefficients, work,
                    )
                    beyond = min((1.0 + room) * beyond, NEVER)
                # above first
                edge = 1 - side
                links[i, Link.BOX, edge] = links[i, Link.BOX, edge] + (1.0 - 2.0 * side) * beyond
    write_margin(path, links)


def write_margin(path: 'float[:]', links: 'float[:,:,:]') -> None:
    """Write by how much a plan may leave its box: a share of the range of all of them."""
    least, most = NEVER, -NEVER
    for i in range(links.shape[0]):
        for edge in range(2):
            value = links[i, Link.BOX, edge]
            if abs(value) < NEVER:
                least = min(least, value)
                most = max(most, value)
    path[Path.MARGIN] = NEARLY * (most - least) if most > least else 0.0
