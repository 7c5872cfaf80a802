"""The times of a plan at which a step of a simulation should end.

Arrays are those of evaluate.py; times[waypoint, axis] is the arrival of each axis.
"""

from segfmu.kernels.numerics.numbers import NEVER
from segfmu.kernels.trajectory.evaluate import find_piece
from segfmu.kernels.trajectory.records import Timing


def next_break(
    time: float, timing: 'float[:,:]', offsets: 'int[:]', ends: 'float[:]'
) -> float:
    """First time after `time` [s] at which a piece of any axis begins or its last one ends.

    NEVER if there is none.
    """
    following = NEVER
    for axis in range(ends.shape[0]):
        first = offsets[axis]
        last = offsets[axis + 1]
        if time < timing[first, Timing.START]:
            following = min(following, timing[first, Timing.START])
        else:
            row = find_piece(time, timing, first, last) + 1
            if row < last:
                following = min(following, timing[row, Timing.START])
            elif time < ends[axis]:
                following = min(following, ends[axis])
    return following


def same_break(time: float) -> float:
    """Events that differ by less [s] are the same; late times have a coarser resolution."""
    return 1e-8 + 1e-14 * abs(time)


def next_plan_event(
    time: float,
    start: float,
    timing: 'float[:,:]',
    offsets: 'int[:]',
    ends: 'float[:]',
    times: 'float[:,:]',
) -> float:
    """First event after `time` of a plan that begins at `start`; NEVER if there is none.

    Events are the last axis' arrival at a waypoint, the end of the motion, and the starts of all
    pieces, where a derivative of the crane's forces jumps: at smoothness 4 the first one.
    """
    event = NEVER
    for waypoint in range(1, times.shape[0] + 1):
        arrival = 0.0
        for axis in range(ends.shape[0]):
            if waypoint < times.shape[0]:
                arrival = max(arrival, times[waypoint, axis])
            else:
                arrival = max(arrival, ends[axis])
        if start + arrival > time + same_break(time):
            event = min(event, start + arrival)
    piece_end = next_break(time + same_break(time) - start, timing, offsets, ends)
    if piece_end < NEVER:
        piece_end = start + piece_end
    # long after the start, the clock may be too coarse to separate a break from the present
    if event <= piece_end + same_break(time) or piece_end <= time:
        return event
    return piece_end


def right_of_break(
    time: float, start: float, timing: 'float[:,:]', offsets: 'int[:]', ends: 'float[:]'
) -> float:
    """Time since `start`; at a break, just after it, so that all axes are on the next piece."""
    local = time - start
    # at its end an axis is still on its last piece
    behind = local + same_break(time)
    if next_break(local - same_break(time), timing, offsets, ends) <= behind:
        return behind
    return local
