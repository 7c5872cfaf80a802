"""The direction in time in which free states are chosen.

A mission and its reverse are one motion, but a search that begins at the other end may stop at
other states. So both are chosen in the same direction: that of the longer first step.
"""

from segfmu.kernels.numerics.numbers import NEVER
from segfmu.kernels.passage.records import Free, Spot, Track
from segfmu.kernels.planner.records import WaypointState


def step_length(place: int, choice: 'float[:,:,:]') -> float:
    """How far the axes go from a place to the next, in their units."""
    length = 0.0
    for axis in range(choice.shape[1]):
        here = choice[place, axis, WaypointState.POSITION]
        length = length + abs(choice[place + 1, axis, WaypointState.POSITION] - here)
    return length


def state_size(place: int, choice: 'float[:,:,:]', spots: 'float[:,:,:]') -> float:
    """How fast the axes are at a place, in their units; more where that is free."""
    count = choice.shape[1]
    size = 0.0
    for axis in range(count):
        for field in range(Free.SIZE):
            size = size + abs(choice[place, axis, WaypointState.VELOCITY + field])
            size = size + 2.0 * spots[place * count + axis, Spot.FREE, field]
    return size


def runs_backwards(places: int, choice: 'float[:,:,:]', spots: 'float[:,:,:]') -> bool:
    """Whether a mission is chosen from its end, as its last steps or states are larger ones."""
    last = places - 1
    for place in range(last):
        ahead = step_length(place, choice) - step_length(last - 1 - place, choice)
        if ahead != 0.0:
            return ahead < 0.0
    for place in range(places):
        ahead = state_size(place, choice, spots) - state_size(last - place, choice, spots)
        if ahead != 0.0:
            return ahead < 0.0
    return False


def reverse_places(places: int, choice: 'float[:,:,:]') -> None:
    """Write the states of a mission that runs from the last place, which is then the origin."""
    count = choice.shape[1]
    last = places - 1
    for axis in range(count):
        origin = choice[last, axis, WaypointState.POSITION]
        for place in range(places):
            here = choice[place, axis, WaypointState.POSITION]
            choice[place, axis, WaypointState.POSITION] = here - origin
            # no zero becomes a negative one
            velocity = choice[place, axis, WaypointState.VELOCITY]
            choice[place, axis, WaypointState.VELOCITY] = 0.0 - velocity
        for place in range(places // 2):
            for field in range(WaypointState.SIZE):
                kept = choice[place, axis, field]
                choice[place, axis, field] = choice[last - place, axis, field]
                choice[last - place, axis, field] = kept


def reverse_spots(places: int, count: int, spots: 'float[:,:,:]') -> None:
    """Write which states of the places of `count` axes are free in a mission that is reversed."""
    for place in range(places // 2):
        for axis in range(count):
            first = place * count + axis
            last = (places - 1 - place) * count + axis
            for field in range(Free.SIZE):
                kept = spots[first, Spot.FREE, field]
                spots[first, Spot.FREE, field] = spots[last, Spot.FREE, field]
                spots[last, Spot.FREE, field] = kept


def reverse_limits(
    places: int, choice: 'float[:,:,:]', limits: 'float[:,:]', lower: 'float[:,:]',
    axes: 'float[:,:]',
) -> None:
    """Exchange the limits of the velocity in both directions, and move ranges to the new origin.

    choice: states before they are reversed.
    """
    for axis in range(limits.shape[0]):
        origin = choice[places - 1, axis, WaypointState.POSITION]
        for side in range(2):
            edge = axes[axis, Track.ALLOWED + side]
            if abs(edge) < NEVER:
                axes[axis, Track.ALLOWED + side] = edge - origin
        kept = limits[axis, 0]
        limits[axis, 0] = lower[axis, 0]
        lower[axis, 0] = kept
