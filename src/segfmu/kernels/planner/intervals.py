"""One waypoint interval: profiles of its axes, on a common duration.

The results of axis i in interval j are cells[j * axes + i] (Cell). Its first list of phases is the
profile or, if two profiles are averaged (synchronize.py), the one that falls short; the weight is
the share of the second one.
"""

from math import ceil

from segfmu.kernels.numerics.numbers import GAINED, HALVINGS, LAST_DIGIT, NEARLY, SAME, TRIES
from segfmu.kernels.planner.gaps import gap_ends
from segfmu.kernels.planner.parameters import ramps_suffice
from segfmu.kernels.planner.phases import append_hold, is_resting, stretch_phases, total_duration
from segfmu.kernels.planner.profile import shortest_profile
from segfmu.kernels.planner.records import (
    Axis,
    Cell,
    Interval,
    Nearest,
    Phase,
    Place,
    PlanWork,
    Way,
)
from segfmu.kernels.planner.synchronize import timed_in_way

# how a duration grows at first that is looked for in a gap, and how the growth itself does: windows
# get longer
GROWTH = 1.005
# durations that are tried before a known end of a gap, where windows are near its begin, and
# halvings towards the first feasible duration in all ways of finding profiles
BEFORE_END = 3
# meetings of axes until there is no common duration
SWEEPS = 100000
# sample times [s]
SHORTEST_SAMPLE = 1e-9
LONGEST_SAMPLE = 1e6


def set_shortest(cell: 'float[:,:]', axis: 'float[:]', work: 'float[:,:]') -> 'tuple[int, float]':
    """Write the shortest profile of a cell; returns its status (PlanStatus) and duration [s]."""
    problem, phases = cell[Cell.PROBLEM, :], cell[Cell.BELOW:Cell.ABOVE, :]
    count = shortest_profile(problem, axis, phases, work)
    cell[Cell.RESULT, Interval.BELOW_COUNT] = max(count, 0)
    cell[Cell.RESULT, Interval.ABOVE_COUNT] = 0.0
    cell[Cell.RESULT, Interval.WEIGHT] = 0.0
    if count < 0:
        return count, 0.0
    return 0, total_duration(phases, count)


def set_stretched(
    target: float, resting: bool, cell: 'float[:,:]', axis: 'float[:]', work: 'float[:,:]'
) -> None:
    """Write the shortest profile, stretched from rest to rest to the target duration [s]."""
    phases = cell[Cell.BELOW:Cell.ABOVE, :]
    shortest = cell[Cell.RESULT, Interval.SHORTEST] - cell[Cell.PLACE, Place.DELAY]
    # the shortest profile may still be stored, from the first step of planning
    duration = 0.0
    if cell[Cell.RESULT, Interval.ABOVE_COUNT] == 0.0:
        for i in range(int(cell[Cell.RESULT, Interval.BELOW_COUNT])):
            duration = duration + phases[i, Phase.DURATION]
    if duration == 0.0 or abs(duration - shortest) > SAME * shortest:
        status, duration = set_shortest(cell, axis, work)
    count = int(cell[Cell.RESULT, Interval.BELOW_COUNT])
    if resting and count == 0:
        cell[Cell.RESULT, Interval.BELOW_COUNT] = append_hold(phases, 0, 0.0, target)
    elif resting:
        stretch_phases(phases, count, target / duration)


def set_duration(target: float, cell: 'float[:,:]', axis: 'float[:]', work: 'float[:,:]') -> bool:
    """Write a profile of the given duration [s], delay included; False if that is not feasible."""
    return set_in_way(Way.ANY, target, cell, axis, work)


def set_in_way(
    way: int, target: float, cell: 'float[:,:]', axis: 'float[:]', work: 'float[:,:]'
) -> bool:
    """`set_duration` with what one way (Way) finds."""
    delay = cell[Cell.PLACE, Place.DELAY]
    shortest = cell[Cell.RESULT, Interval.SHORTEST]
    if target < shortest * (1.0 - SAME):
        return False
    resting = is_resting(cell[Cell.PROBLEM, :], axis)
    if resting or target <= shortest * (1.0 + SAME):
        set_stretched(target - delay, resting, cell, axis, work)
        return True
    weight = timed_in_way(way, target - delay, axis, cell, work)
    if weight < 0.0:
        return False
    cell[Cell.RESULT, Interval.WEIGHT] = weight
    cell[Cell.RESULT, Interval.BELOW_COUNT] = work[PlanWork.NEAREST, Nearest.BELOW_COUNT]
    cell[Cell.RESULT, Interval.ABOVE_COUNT] = work[PlanWork.NEAREST, Nearest.ABOVE_COUNT]
    return True


def gap_end(
    start: float, most: float, cell: 'float[:,:]', axis: 'float[:]', work: 'float[:,:]'
) -> float:
    """The first feasible duration of those at which gaps can end, up to `most` [s]; or `most`."""
    after = start
    delay = cell[Cell.PLACE, Place.DELAY]
    for sweep in range(8):
        count = gap_ends(after - delay, cell[Cell.PROBLEM, :], axis, work)
        for i in range(count):
            duration = delay + work[PlanWork.GAP_ENDS + i, 0] * (1.0 + GAINED)
            if duration >= most:
                return most
            if set_duration(duration, cell, axis, work):
                return duration
            after = duration
        if count < PlanWork.NEAREST - PlanWork.GAP_ENDS:
            break
    return most


def next_feasible(
    start: float, most: float, cell: 'float[:,:]', axis: 'float[:]', work: 'float[:,:]'
) -> float:
    """The end of the gap that contains the infeasible duration `start` [s]; -1 if none is found.

    most: the longest duration that is looked for [s].

    The durations at which gaps can end are tried in turn, and then some that are shorter than the
    first of them that is feasible: there are windows that begin at none of them. With smoothsteps,
    whose families have more kinks, and limits above the snap slightly shorter ones are tried, too.
    """
    end = gap_end(start, most, cell, axis, work)
    after = start
    growth = GROWTH
    for i in range(HALVINGS):
        duration = min(after * growth, end)
        if i == BEFORE_END and end < most:
            duration = 0.5 * (after + end)
        elif i > BEFORE_END and end < most:
            duration = end
        if set_duration(duration, cell, axis, work):
            if duration == end and axis[Axis.PLATEAU] != 0.0 and ramps_suffice(axis):
                return duration
            return first_feasible(after, duration, cell, axis, work)
        if duration >= end:
            return -1.0
        after = duration
        growth = GROWTH * growth
    return -1.0


def first_feasible(
    outside: float, inside: float, cell: 'float[:,:]', axis: 'float[:]', work: 'float[:,:]'
) -> float:
    """The first feasible duration between an infeasible and a feasible one.

    To try all ways takes long, so after a few halvings only that is tried which found a profile
    last, and all of them again right before what it finds.
    """
    for sweep in range(TRIES):
        duration = inside * (1.0 - NEARLY)
        if duration <= outside or not set_duration(duration, cell, axis, work):
            break
        inside = duration
        for i in range(BEFORE_END):
            duration = 0.5 * (outside + inside)
            if set_duration(duration, cell, axis, work):
                inside = duration
            else:
                outside = duration
        inside = first_in_way(outside, inside, cell, axis, work)
    return inside


def first_in_way(
    outside: float, inside: float, cell: 'float[:,:]', axis: 'float[:]', work: 'float[:,:]'
) -> float:
    """`first_feasible` in the way in which the last profile was found, that of `inside`."""
    way = int(work[PlanWork.NEAREST, Nearest.WAY])
    for i in range(HALVINGS):
        if inside - outside <= NEARLY * inside:
            break
        duration = 0.5 * (outside + inside)
        if set_in_way(way, duration, cell, axis, work):
            inside = duration
        else:
            outside = duration
    return inside


def round_up(duration: float, sample_time: float) -> float:
    """The next multiple of the sample time, or the duration itself if there is none."""
    if sample_time <= 0.0:
        return duration
    samples = duration / sample_time - NEARLY
    # larger counts are no whole numbers
    if not samples * LAST_DIGIT < 1.0:
        return duration
    return ceil(samples) * sample_time


def common_duration(
    start: float, most: float, sample_time: float, first: int, last: int, axes: 'float[:,:]',
    cells: 'float[:,:,:]', work: 'float[:,:]',
) -> float:
    """The shortest duration from `start` to `most` [s] feasible for the cells first .. last - 1.

    -1 if there is none. The cells belong to one interval. Their profiles of that duration are
    written.
    """
    duration = start
    for i in range(first, last):
        duration = max(duration, cells[i, Cell.RESULT, Interval.SHORTEST])
    duration = round_up(duration, sample_time)
    place = first
    agreed = 0
    for i in range(SWEEPS):
        if agreed == last - first:
            return duration
        if duration >= most:
            return -1.0
        cell = cells[place, :, :]
        row = place % axes.shape[0]
        axis = axes[row, :]
        if set_duration(duration, cell, axis, work):
            agreed = agreed + 1
        else:
            duration = next_feasible(duration, most, cell, axis, work)
            if duration < 0.0:
                return -1.0
            duration = round_up(duration, sample_time)
            agreed = 0
        place = place + 1
        if place == last:
            place = first
    return -1.0
