"""Units of a choice of free states: what follows from them does not depend on those that are given.

An axis' unit of velocity is its limit, the unit of time is that in which the first axis reaches its
limit. What is given is rounded in these units, so a mission in other units, or at another place,
is the same problem but for bits that rounding removes.
"""

from segfmu.kernels.limits.places import is_free
from segfmu.kernels.numerics.numbers import NEVER
from segfmu.kernels.passage.records import Free, Track
from segfmu.kernels.planner.records import WaypointState

# one more than 2^19: numbers keep 34 of 53 binary digits
SPLIT = 524289.0


def few_digits(value: float) -> float:
    """A number without its last digits, by Veltkamp's splitting; NEVER and what is beyond stay."""
    if not abs(value) < NEVER:
        return value
    shifted = SPLIT * value
    return shifted - (shifted - value)


def take_units(
    places: int, choice: 'float[:,:,:]', limits: 'float[:,:]', lower: 'float[:,:]',
    axes: 'float[:,:]',
) -> None:
    """Write units (Track) and measure states of places, limits and ranges in them.

    choice (places or more, k, WaypointState), limits (k, smoothness + 1), lower (k, Lower).
    """
    time = limits[0, 0] / limits[0, 1]
    for axis in range(axes.shape[0]):
        speed = limits[axis, 0]
        length = speed * time
        axes[axis, Track.UNIT] = speed
        axes[axis, Track.UNIT + 1] = speed / time
        first = choice[0, axis, WaypointState.POSITION]
        for side in range(2):
            edge = axes[axis, Track.ALLOWED + side]
            if abs(edge) < NEVER:
                axes[axis, Track.ALLOWED + side] = few_digits((edge - first) / length)
        # a chosen velocity may be at its limit, and be measured in other units again
        lower[axis, 0] = lower[axis, 0] / speed
        lower[axis, 1] = few_digits(lower[axis, 1] / axes[axis, Track.UNIT + 1])
        unit = length
        for order in range(limits.shape[1]):
            unit = unit / time
            if limits[axis, order] < NEVER:
                limits[axis, order] = few_digits(limits[axis, order] / unit)
        measure_states(axis, places, lower[axis, 0], choice, axes[axis, :])


def measure_states(
    axis: int, places: int, slowest: float, choice: 'float[:,:,:]', track: 'float[:]'
) -> None:
    """Measure an axis' states in its units, positions from the first one on.

    slowest: limit of the velocity in the negative direction, in units.
    """
    length = track[Track.UNIT] * track[Track.UNIT] / track[Track.UNIT + 1]
    before = choice[0, axis, WaypointState.POSITION]
    position = 0.0
    for point in range(places):
        here = choice[point, axis, WaypointState.POSITION]
        position = position + few_digits((here - before) / length)
        before = here
        choice[point, axis, WaypointState.POSITION] = position
        for field in range(Free.SIZE):
            state = choice[point, axis, WaypointState.VELOCITY + field] / track[Track.UNIT + field]
            state = few_digits(state)
            if field == Free.VELOCITY:
                state = min(max(state, -slowest), 1.0)
            choice[point, axis, WaypointState.VELOCITY + field] = state


def return_states(point: int, choice: 'float[:,:,:]', axes: 'float[:,:]') -> None:
    """Measure velocities and accelerations of a place in the units that were given."""
    for axis in range(axes.shape[0]):
        for field in range(Free.SIZE):
            state = choice[point, axis, WaypointState.VELOCITY + field]
            if state != 0.0:
                state = state * axes[axis, Track.UNIT + field]
            choice[point, axis, WaypointState.VELOCITY + field] = state


def restore_given(given: 'float[:,:]', found: 'float[:,:]') -> None:
    """Write the states of a waypoint that are given, which were rounded, to those of its place."""
    for axis in range(found.shape[0]):
        for i in range(WaypointState.SIZE):
            if not is_free(given[axis, i]):
                found[axis, i] = given[axis, i]
