"""A profile of prescribed duration, and whether a duration is feasible at all.

For a given duration T the valid motions between two boundary states form a convex set (the limits
bound linear functions of y). So their distances form an interval, and the weighted mean of two
valid motions is valid. A duration is therefore feasible if one profile of that duration falls short
of the distance and another one covers at least as much. Between two moving waypoints the feasible
durations can have gaps (errata E10). Outside the gaps the profile is, in this order:

* from rest to rest the shortest profile stretched in time, as in section 3.2;
* three ramps over two levels, slowed down alike (gentle.py): slower ramps are smoother;
* the paper's form with the cruise velocity that makes it last T, if it exists as the form of a
  faster time, stretched;
* the shortest profile, and a wait, where a motion that begins or ends at rest has to turn back,
  which slower ramps do farther from its path;
* that form with full ramps: the first one for a motion that turns back, as it stays near its path;
* the weighted mean of two profiles that last T, one short of the distance and one beyond it;
* the shortest profile at a slower pace, if it passes zero jerk with snap;
* the mean of the motions over about the least and the largest distance (extremes.py).
"""

from segfmu.kernels.planner.arcs import timed_loop
from segfmu.kernels.planner.braking import braked
from segfmu.kernels.planner.dipped import timed_dipped
from segfmu.kernels.planner.enclose import (
    clear_nearest,
    nearest_weight,
    note_known,
    surround_nearest,
    timed_between,
)
from segfmu.kernels.planner.extremes import timed_extremes
from segfmu.kernels.planner.orientation import orient, reverse_search, turn_back, turn_phases
from segfmu.kernels.planner.parameters import ramps_suffice
from segfmu.kernels.planner.passing import slowed_sequence, slower_form
from segfmu.kernels.planner.phases import boundary_problem, fit_duration
from segfmu.kernels.planner.profile import plain_profile, shortest_profile
from segfmu.kernels.planner.records import (
    Axis,
    Braking,
    Cell,
    Effort,
    Interval,
    Nearest,
    PlanWork,
    Problem,
    Way,
    Weight,
)
from segfmu.kernels.planner.repeats import search_again
from segfmu.kernels.planner.smoothly import timed_smoothly, timed_waiting
from segfmu.kernels.planner.timed_cruise import is_enclosed


def timed_profile(target: float, axis: 'float[:]', cell: 'float[:,:]', work: 'float[:,:]') -> float:
    """Two profiles of a cell's problem (Cell) that last `target` [s] and enclose the distance.

    Returns the weight of the second one, or -1 if that duration is not feasible. The motion is
    (1 - weight) * BELOW + weight * ABOVE; the counts of phases are in the row NEAREST of `work`.
    """
    return timed_in_way(Way.ANY, target, axis, cell, work)


def timed_in_way(
    only: int, target: float, axis: 'float[:]', cell: 'float[:,:]', work: 'float[:,:]'
) -> float:
    """`timed_profile` in one way (Way) alone."""
    problem, nearest = work[PlanWork.PROBLEM, :], work[PlanWork.NEAREST, :]
    boundary_problem(cell[Cell.PROBLEM, :], axis, problem)
    problem[Problem.DURATION] = target
    mirrored, turned = orient(problem, axis)
    weight = -1.0
    for turn in range(2):
        if weight < 0.0:
            # the other direction may find what this one does not
            if turn > 0:
                turned = 1 - turned
                reverse_search(problem, axis)
            weight = timed_forwards(only, Way.TURNED * turn, axis, cell, work)
    turn_back(mirrored, turned, problem, axis)
    if weight >= 0.0:
        below = int(nearest[Nearest.BELOW_COUNT])
        above = int(nearest[Nearest.ABOVE_COUNT])
        turn_phases(mirrored, turned, below, cell[Cell.BELOW:Cell.ABOVE, :])
        turn_phases(mirrored, turned, above, cell[Cell.ABOVE:Cell.PROBLEM, :])
    return weight


def timed_forwards(
    only: int, first: int, axis: 'float[:]', cell: 'float[:,:]', work: 'float[:,:]'
) -> float:
    """`timed_in_way` of the row PROBLEM in one direction, whose ways are those from `first` on."""
    for way in range(Way.TURNED):
        asked = only == Way.ANY or only == first + way
        # motions over the extreme distances depend on what ramps reach
        asked = asked or (way == Way.RAMPS and only == first + Way.EXTREMES)
        # passing profiles are slowed down in the direction in which they were found
        again = first > 0 and way >= Way.PASSING and way <= Way.PASSING_PLAIN
        if asked and not again:
            weight = timed_one(way, axis, cell, work)
            if weight >= 0.0:
                work[PlanWork.NEAREST, Nearest.WAY] = first + way
                return weight
            if weight == Weight.UNBRAKED:
                break
    return -1.0


def timed_one(way: int, axis: 'float[:]', cell: 'float[:,:]', work: 'float[:,:]') -> float:
    """`timed_forwards` in one way."""
    if way == Way.SMOOTH or way == Way.TURNING:
        return timed_smoothly(way == Way.TURNING, axis, cell, work)
    if way == Way.WAITING:
        return timed_waiting(axis, cell, work)
    if way == Way.RAMPS:
        return timed_braked(axis, cell, work)
    if axis[Axis.ABOVE] == 0.0:
        return -1.0
    if way == Way.EXTREMES:
        return between_extremes(axis, cell, work)
    if way == Way.DIPPED:
        return timed_dipped(axis, cell, work)
    return slower_passing(way, axis, cell, work)


def timed_braked(axis: 'float[:]', cell: 'float[:,:]', work: 'float[:,:]') -> float:
    """`timed_profile` with ramps, also after braking the accelerations.

    Below zero as `Weight`.
    """
    problem, rest = work[PlanWork.PROBLEM, :], work[PlanWork.REST, :]
    for variant in range(4):
        taken, spent = braked(variant, problem, axis, work)
        if taken == Braking.NOT_NEEDED:
            continue
        if taken < 0:
            return float(Weight.UNBRAKED)
        if rest[Problem.DURATION] <= 0.0:
            continue
        clear_nearest(work)
        timed_between(rest, axis, cell, work)
        if variant == 0 and not is_enclosed(work):
            timed_loop(rest, axis, cell, work)
            note_known(work)
        if is_enclosed(work):
            weight = nearest_weight(rest, axis, work[PlanWork.NEAREST, :])
            surround_nearest(variant, axis, cell, work)
            return weight
    return -1.0


def between_extremes(axis: 'float[:]', cell: 'float[:,:]', work: 'float[:,:]') -> float:
    """`timed_profile` with motions over about the least and the largest distance.

    Ramps take the place of one that is not found.
    """
    problem = work[PlanWork.PROBLEM, :]
    if not timed_extremes(axis, cell, work):
        return -1.0
    if not is_enclosed(work):
        timed_between(problem, axis, cell, work)
        timed_loop(problem, axis, cell, work)
    if not is_enclosed(work):
        return -1.0
    surround_nearest(0, axis, cell, work)
    return nearest_weight(problem, axis, work[PlanWork.NEAREST, :])


def slowed_shortest(
    plain: float, phases: 'float[:,:]', problem: 'float[:]', axis: 'float[:]', work: 'float[:,:]'
) -> int:
    """The shortest profile, slowed down if it passes zero jerk with snap; 0: that fails.

    plain: 1.0: the one without the ways that are tried last.
    """
    again = search_again(plain, problem, axis, work)
    if again > 0:
        return slowed_sequence(phases, problem, axis, work)
    if again == 0:
        return 0
    if plain != 0.0:
        count = plain_profile(problem, axis, phases, work)
    else:
        count = shortest_profile(problem, axis, phases, work)
    return slower_form(count, phases, problem, axis, work)


def slower_passing(way: int, axis: 'float[:]', cell: 'float[:,:]', work: 'float[:,:]') -> float:
    """The shortest profile, if it passes zero jerk with snap, slowed down; as `timed_profile`.

    Where that fails, another one that is not as short may be slowed down: one whose velocity
    touches its limit may be alone between gaps.
    """
    problem, phases = work[PlanWork.PROBLEM, :], cell[Cell.BELOW:Cell.ABOVE, :]
    effort = axis[Axis.EFFORT]
    plain = 0.0
    if way == Way.PASSING_PLAIN:
        plain = 1.0
        if ramps_suffice(axis):
            return -1.0
    elif cell[Cell.RESULT, Interval.PASSING] == 0.0:
        return -1.0
    elif way == Way.PASSING_USUAL:
        if effort != Effort.THOROUGH:
            return -1.0
        axis[Axis.EFFORT] = Effort.USUAL
    count = slowed_shortest(plain, phases, problem, axis, work)
    axis[Axis.EFFORT] = effort
    if count == 0:
        return -1.0
    count = fit_duration(phases, count, problem[Problem.DURATION])
    work[PlanWork.NEAREST, Nearest.BELOW_COUNT] = count
    work[PlanWork.NEAREST, Nearest.ABOVE_COUNT] = 0.0
    return 0.0
