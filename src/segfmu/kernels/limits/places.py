"""The places that waypoints are at, and their free states.

states: of the waypoints (points, axes, WaypointState), not a number where one is free. Waypoints
that follow each other and are equal are one place, in which the load may rest.
"""

from segfmu.kernels.limits.heading import heading_sign, state_of
from segfmu.kernels.limits.records import LimitRow, Unknown
from segfmu.kernels.planner.records import WaypointState


def is_free(state: float) -> bool:
    """Whether a state is not a number."""
    return state != state


def unite_waypoints(states: 'float[:,:,:]', place: 'float[:]') -> None:
    """Write the place of every waypoint, counted from 0, and give all waypoints of one its states.

    A free state is equal to any other, and becomes that one.
    """
    first = 0
    place[0] = 0.0
    for point in range(1, states.shape[0]):
        place[point] = place[point - 1]
        if may_be_same(states[first, :, :], states[point, :, :]):
            take_states(False, states[point, :, :], states[first, :, :])
        else:
            first = point
            place[point] = place[point - 1] + 1.0
    for point in range(1, states.shape[0]):
        if place[point] == place[point - 1]:
            take_states(True, states[point - 1, :, :], states[point, :, :])


def may_be_same(one: 'float[:,:]', other: 'float[:,:]') -> bool:
    """Whether what is known of both waypoints is the same but for rounding."""
    for axis in range(one.shape[0]):
        for i in range(WaypointState.SIZE):
            # no comparison with what is not a number is true
            if abs(one[axis, i] - other[axis, i]) > 1e-15 * max(abs(other[axis, i]), 1.0):
                return False
    return True


def take_states(every: bool, given: 'float[:,:]', found: 'float[:,:]') -> None:
    """Take the given states, every one or those that are free."""
    for axis in range(found.shape[0]):
        for i in range(WaypointState.SIZE):
            if every or is_free(found[axis, i]):
                found[axis, i] = given[axis, i]


def write_free(
    states: 'float[:,:,:]', place: 'float[:]', dwells: 'float[:]', heading: 'float[:]',
    kinds: 'float[:]', led: 'float[:,:]',
) -> None:
    """Put rest in place of free states, and write which of them are searched for.

    It is those of places that an axis passes; where it turns back or rests, it would leave the box
    of the waypoints. kinds (`Unknown`): limits come first, see `state_of`. led (points, 3): 1 where
    velocity or acceleration is searched for.
    """
    points = states.shape[0]
    for i in range(3 * LimitRow.SIZE, kinds.shape[0]):
        kinds[i] = Unknown.GIVEN
    for point in range(points):
        for axis in range(3):
            led[point, axis] = 0.0
            if is_passed(point, axis, states, place, dwells):
                for order in range(2):
                    if is_free(states[point, axis, WaypointState.VELOCITY + order]):
                        led[point, axis] = 1.0
                        i = state_of(int(place[point]), order, axis, heading)
                        kinds[i] = Unknown.STATE
    for point in range(points):
        for axis in range(3):
            for i in range(WaypointState.VELOCITY, WaypointState.SIZE):
                if is_free(states[point, axis, i]):
                    states[point, axis, i] = 0.0


def is_passed(
    point: int, axis: int, states: 'float[:,:,:]', place: 'float[:]', dwells: 'float[:]'
) -> bool:
    """Whether an axis moves on at the place of a waypoint, without a rest."""
    before = point
    after = point
    last = states.shape[0] - 1
    while before > 0 and place[before] == place[point]:
        before = before - 1
    while after < last and place[after] == place[point]:
        after = after + 1
    if place[before] == place[point] or place[after] == place[point]:
        return False
    for k in range(before + 1, after):
        if dwells[k] > 0.0:
            return False
    here = states[point, axis, WaypointState.POSITION]
    come = here - states[before, axis, WaypointState.POSITION]
    goes = states[after, axis, WaypointState.POSITION] - here
    return come * goes > 0.0


def write_states(
    unknowns: 'float[:]', kinds: 'float[:]', table: 'float[:,:]', place: 'float[:]',
    heading: 'float[:]', states: 'float[:,:,:]',
) -> None:
    """Write the states that unknowns stand for: shares of the limits (3, LimitRow.SIZE)."""
    points = states.shape[0]
    for point in range(points):
        if 0.5 < place[point] < place[points - 1]:
            for axis in range(3):
                for order in range(2):
                    i = state_of(int(place[point]), order, axis, heading)
                    if int(kinds[i]) == Unknown.STATE:
                        limit = table[axis, LimitRow.VELOCITY + order]
                        share = min(max(unknowns[i], -1.0), 1.0)
                        value = heading_sign(order, axis, heading) * share * limit
                        states[point, axis, WaypointState.VELOCITY + order] = value
