"""In which order and direction free states are searched for.

A search goes from state to state and tries more before less. So that motions which are mirrored or
run backwards end alike, its unknowns are those of one of them: heading is a `Heading`.
"""

from segfmu.kernels.limits.records import Heading, LimitRow


def write_heading(places: 'float[:,:]', heading: 'float[:]') -> None:
    """Write the heading of a motion through places (places, 3) [m].

    Of a motion and its reverse the one whose ways are longer at first leads, of a mirrored pair the
    one whose longest way is positive.
    """
    last = places.shape[0] - 1
    longest = 0.0
    for axis in range(places.shape[1]):
        for k in range(last):
            longest = max(longest, abs(places[k + 1, axis] - places[k, axis]))
    heading[Heading.LAST] = last
    heading[Heading.TIME] = direction_of(places, 1e-9 * longest)
    for axis in range(places.shape[1]):
        farthest = 0.0
        heading[Heading.AXIS + axis] = 1.0
        for k in range(last):
            first = k
            if heading[Heading.TIME] < 0.0:
                first = last - 1 - k
            way = heading[Heading.TIME] * (places[first + 1, axis] - places[first, axis])
            if abs(way) > farthest + 1e-9 * longest:
                farthest = abs(way)
                heading[Heading.AXIS + axis] = way / farthest


def direction_of(places: 'float[:,:]', least: float) -> float:
    """1 if the ways are longer at first, -1 if at last; the first that differ by `least` decide."""
    last = places.shape[0] - 1
    for k in range(last):
        for axis in range(places.shape[1]):
            early = abs(places[k + 1, axis] - places[k, axis])
            late = abs(places[last - k, axis] - places[last - k - 1, axis])
            if early > late + least:
                return 1.0
            if late > early + least:
                return -1.0
    return 1.0


def state_of(place: int, order: int, axis: int, heading: 'float[:]') -> int:
    """Index among the unknowns of a velocity (order 0) or acceleration at a place, from 0."""
    passed = place
    if heading[Heading.TIME] < 0.0:
        passed = int(heading[Heading.LAST]) - place
    return 3 * LimitRow.SIZE + ((passed - 1) * 2 + order) * 3 + axis


def heading_sign(order: int, axis: int, heading: 'float[:]') -> float:
    """Sign of a velocity (order 0) or acceleration whose unknown is positive."""
    if order == 0:
        return heading[Heading.TIME] * heading[Heading.AXIS + axis]
    return heading[Heading.AXIS + axis]
