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

from segfmu.kernels.numerics.numbers import EQUAL
from segfmu.kernels.planner.arcs import timed_loop
from segfmu.kernels.planner.braking import braked, surround
from segfmu.kernels.planner.dipped import timed_dipped
from segfmu.kernels.planner.enclose import (
    clear_nearest,
    nearest_weight,
    note_known,
    timed_between,
    usual_cruise,
)
from segfmu.kernels.planner.extremes import timed_extremes
from segfmu.kernels.planner.gentle import solve_gentle, write_gentle
from segfmu.kernels.planner.orientation import orient, reverse_search, turn_back, turn_phases
from segfmu.kernels.planner.parameters import ramps_suffice
from segfmu.kernels.planner.passing import slowed_sequence, slower_form
from segfmu.kernels.planner.phases import (
    boundary_problem,
    fit_duration,
    measure_phases,
    stretch_phases,
)
from segfmu.kernels.planner.profile import plain_profile, shortest_profile
from segfmu.kernels.planner.records import (
    Axis,
    Braking,
    Cell,
    Effort,
    Gentle,
    Interval,
    Nearest,
    PlanWork,
    Problem,
    Weight,
)
from segfmu.kernels.planner.repeats import search_again
from segfmu.kernels.planner.sides import is_beyond
from segfmu.kernels.planner.timed_cruise import is_enclosed
from segfmu.kernels.planner.waiting import timed_waiting

# stretches of a cruise from the whole one on: each has this power of the one before, up to nearly
# none
LESS = 0.75
NONE = 0.99
STRETCHES = 9


def is_turning(lowest: float, highest: float) -> bool:
    """Whether a motion with these velocities goes both ways, not by rounding alone."""
    return min(-lowest, highest) > EQUAL * max(-lowest, highest)


def turns_back(
    problem: 'float[:]', axis: 'float[:]', cell: 'float[:,:]', work: 'float[:,:]'
) -> bool:
    """Whether one of the profiles whose mean covers the distance goes both ways.

    Where one of the two is enough the other one may be far away: it does not tell.
    """
    nearest = work[PlanWork.NEAREST, :]
    weight = nearest_weight(problem, axis, nearest)
    v = problem[Problem.V]
    if weight < 1.0:
        count = int(nearest[Nearest.BELOW_COUNT])
        duration, y, end, lowest, highest = measure_phases(
            cell[Cell.BELOW:Cell.ABOVE, :], count, v, 0.0, axis
        )
        if is_turning(lowest, highest):
            return True
    if weight > 0.0:
        count = int(nearest[Nearest.ABOVE_COUNT])
        duration, y, end, lowest, highest = measure_phases(
            cell[Cell.ABOVE:Cell.PROBLEM, :], count, v, 0.0, axis
        )
        return is_turning(lowest, highest)
    return False


def timed_gently(turning: bool, axis: 'float[:]', cell: 'float[:,:]', work: 'float[:,:]') -> bool:
    """Three ramps that are slow enough to last the duration (gentle.py); False: there are none.

    turning: also those that turn back.
    """
    problem, gentle = work[PlanWork.PROBLEM, :], work[PlanWork.GENTLE, :]
    phases = cell[Cell.BELOW:Cell.ABOVE, :]
    target = problem[Problem.DURATION]
    for attempt in range(6):
        if not solve_gentle(attempt, problem, axis, gentle):
            continue
        if gentle[Gentle.STRETCH] < 1.0:
            return False
        count = write_gentle(phases, problem, axis, gentle)
        count = fit_duration(phases, count, target)
        duration, y, end, lowest, highest = measure_phases(
            phases, count, problem[Problem.V], 0.0, axis
        )
        if is_beyond(lowest, highest, 1.0 + EQUAL, axis):
            return False
        if is_turning(lowest, highest) and not turning:
            return False
        fastest = max(-lowest, highest)
        if abs(end - problem[Problem.W]) > EQUAL * fastest:
            return False
        if abs(y - problem[Problem.DISTANCE]) > EQUAL * fastest * target:
            return False
        work[PlanWork.NEAREST, Nearest.BELOW_COUNT] = count
        work[PlanWork.NEAREST, Nearest.ABOVE_COUNT] = 0.0
        return True
    return False


def timed_slower(
    turning: bool, shortest: float, axis: 'float[:]', cell: 'float[:,:]', work: 'float[:,:]'
) -> bool:
    """A cruise of prescribed duration whose ramps are stretched, as those from rest to rest are.

    shortest: the shortest duration of the problem [s]. turning: also one that turns back. False if
    there is none; the boundary states must not exceed the limits that remain.
    """
    problem, rest = work[PlanWork.PROBLEM, :], work[PlanWork.REST, :]
    velocity, backwards = axis[Axis.VELOCITY], axis[Axis.LOWER]
    factor = shortest / problem[Problem.DURATION]
    factor = factor * factor
    steepest = max(problem[Problem.A], problem[Problem.B])
    lowest = min(problem[Problem.A], problem[Problem.B])
    for attempt in range(STRETCHES):
        room = axis[Axis.ACCELERATION] * factor * factor * (1.0 - EQUAL)
        fits = steepest <= room
        room = axis[Axis.LOWER + 1] * factor * factor * (1.0 - EQUAL)
        if fits and -lowest <= room and factor < NONE:
            rest[Problem.V] = problem[Problem.V] / factor
            rest[Problem.A] = problem[Problem.A] / (factor * factor)
            rest[Problem.W] = problem[Problem.W] / factor
            rest[Problem.B] = problem[Problem.B] / (factor * factor)
            rest[Problem.DISTANCE] = problem[Problem.DISTANCE]
            rest[Problem.DURATION] = problem[Problem.DURATION] * factor
            axis[Axis.VELOCITY] = velocity / factor
            axis[Axis.LOWER] = backwards / factor
            clear_nearest(work)
            usual_cruise(rest, axis, cell, work)
            axis[Axis.VELOCITY] = velocity
            axis[Axis.LOWER] = backwards
            if is_enclosed(work):
                nearest = work[PlanWork.NEAREST, :]
                below = int(nearest[Nearest.BELOW_COUNT])
                above = int(nearest[Nearest.ABOVE_COUNT])
                if not turning and turns_back(rest, axis, cell, work):
                    return False
                stretch_phases(cell[Cell.BELOW:Cell.ABOVE, :], below, 1.0 / factor)
                stretch_phases(cell[Cell.ABOVE:Cell.PROBLEM, :], above, 1.0 / factor)
                return True
        factor = factor ** LESS
    return False


def timed_profile(target: float, axis: 'float[:]', cell: 'float[:,:]', work: 'float[:,:]') -> float:
    """Two profiles of a cell's problem (Cell) that last `target` [s] and enclose the distance.

    Returns the weight of the second one, or -1 if that duration is not feasible. The motion is
    (1 - weight) * BELOW + weight * ABOVE; the counts of phases are in the row NEAREST of `work`.
    """
    problem = work[PlanWork.PROBLEM, :]
    boundary_problem(cell[Cell.PROBLEM, :], axis, problem)
    problem[Problem.DURATION] = target
    mirrored, turned = orient(problem, axis)
    weight = timed_forwards(axis, cell, work)
    if weight < 0.0:
        # the other direction may find what this one does not
        turned = 1 - turned
        reverse_search(problem, axis)
        weight = timed_forwards(axis, cell, work)
    turn_back(mirrored, turned, problem, axis)
    if weight >= 0.0:
        nearest = work[PlanWork.NEAREST, :]
        below = int(nearest[Nearest.BELOW_COUNT])
        above = int(nearest[Nearest.ABOVE_COUNT])
        turn_phases(mirrored, turned, below, cell[Cell.BELOW:Cell.ABOVE, :])
        turn_phases(mirrored, turned, above, cell[Cell.ABOVE:Cell.PROBLEM, :])
    return weight


def timed_forwards(axis: 'float[:]', cell: 'float[:,:]', work: 'float[:,:]') -> float:
    """`timed_profile` of the row PROBLEM, in the direction that this has."""
    weight = timed_smoothly(False, axis, cell, work)
    if weight < 0.0:
        weight = timed_waiting(axis, cell, work)
    if weight >= 0.0:
        return weight
    weight = timed_braked(axis, cell, work)
    if weight == Weight.UNBRAKED:
        return -1.0
    if weight < 0.0 and axis[Axis.ABOVE] != 0.0:
        weight = slower_passing(axis, cell, work)
        if weight < 0.0:
            weight = between_extremes(axis, cell, work)
        if weight < 0.0:
            weight = timed_dipped(axis, cell, work)
    if weight < 0.0:
        weight = timed_smoothly(True, axis, cell, work)
    return weight


def timed_smoothly(
    turning: bool, axis: 'float[:]', cell: 'float[:,:]', work: 'float[:,:]'
) -> float:
    """`timed_profile` with ramps that are as slow as time permits; -1: there are none.

    turning: also motions that turn back, which slow ramps lead farther from their path.
    """
    shortest = cell[Cell.RESULT, Interval.SHORTEST]
    if shortest <= 0.0:
        return -1.0
    if timed_gently(turning, axis, cell, work):
        return 0.0
    if not timed_slower(turning, shortest, axis, cell, work):
        return -1.0
    weight = nearest_weight(work[PlanWork.PROBLEM, :], axis, work[PlanWork.NEAREST, :])
    surround_nearest(0, axis, cell, work)
    return weight


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


def slower_passing(axis: 'float[:]', cell: 'float[:,:]', work: 'float[:,:]') -> float:
    """The shortest profile, if it passes zero jerk with snap, slowed down; as `timed_profile`.

    Where that fails, another one that is not as short may be slowed down.
    """
    if axis[Axis.ABOVE] == 0.0:
        return -1.0
    problem = work[PlanWork.PROBLEM, :]
    phases = cell[Cell.BELOW:Cell.ABOVE, :]
    count = 0
    if cell[Cell.RESULT, Interval.PASSING] != 0.0:
        count = slowed_shortest(0.0, phases, problem, axis, work)
        if count == 0 and axis[Axis.EFFORT] == Effort.THOROUGH:
            # one whose velocity touches its limit may be alone between gaps
            axis[Axis.EFFORT] = Effort.USUAL
            count = slowed_shortest(0.0, phases, problem, axis, work)
            axis[Axis.EFFORT] = Effort.THOROUGH
    if count == 0 and not ramps_suffice(axis):
        count = slowed_shortest(1.0, phases, problem, axis, work)
    if count == 0:
        return -1.0
    count = fit_duration(phases, count, problem[Problem.DURATION])
    work[PlanWork.NEAREST, Nearest.BELOW_COUNT] = count
    work[PlanWork.NEAREST, Nearest.ABOVE_COUNT] = 0.0
    return 0.0


def surround_nearest(
    variant: int, axis: 'float[:]', cell: 'float[:,:]', work: 'float[:,:]'
) -> None:
    """Add a variant's braking phases to both profiles, and give them the exact duration."""
    problem, nearest = work[PlanWork.PROBLEM, :], work[PlanWork.NEAREST, :]
    below, above = cell[Cell.BELOW:Cell.ABOVE, :], cell[Cell.ABOVE:Cell.PROBLEM, :]
    count = int(nearest[Nearest.BELOW_COUNT])
    count = surround(below, count, variant, problem, axis, work)
    nearest[Nearest.BELOW_COUNT] = fit_duration(below, count, problem[Problem.DURATION])
    count = int(nearest[Nearest.ABOVE_COUNT])
    count = surround(above, count, variant, problem, axis, work)
    nearest[Nearest.ABOVE_COUNT] = fit_duration(above, count, problem[Problem.DURATION])
