"""The shortest form between two boundary states, with and without braking, and beyond ramps.

The forms are tried from the given boundary states and, if that exceeds the velocity limit inside a
ramp, after braking the boundary accelerations to zero. After braking both, the paper's form always
exists: its distance is continuous in the cruise velocity and unbounded at the two limits.
"""

from math import sqrt

from segfmu.kernels.numerics.numbers import GAINED, NEVER, SAME, WORTH
from segfmu.kernels.planner.braking import braked, surround
from segfmu.kernels.planner.cruise import shorter_cruise, slower_cruise, with_cruise
from segfmu.kernels.planner.merged import merged_form, same_members, set_family, tempered_form
from segfmu.kernels.planner.orientation import reverse_search
from segfmu.kernels.planner.parameters import ramps_suffice
from segfmu.kernels.planner.passing import passing_form
from segfmu.kernels.planner.phases import (
    append_change,
    copy_phases,
    reverse_phases,
    total_duration,
    valid_duration,
)
from segfmu.kernels.planner.records import (
    Axis,
    Braking,
    Family,
    Passing,
    Phase,
    PlanStatus,
    PlanWork,
    Problem,
)
from segfmu.kernels.planner.sides import fastest_velocity, slowest_velocity


def usual_duration(problem: 'float[:]', axis: 'float[:]') -> float:
    """Upper bound [s] for the duration of the paper's form with cruise."""
    top = min(axis[Axis.ACCELERATION], axis[Axis.LOWER + 1])
    distance = abs(problem[Problem.DISTANCE])
    # a cruise that is fast enough for the boundary states and worth its ramps
    cruise = max(abs(problem[Problem.V]), abs(problem[Problem.W])) + sqrt(top * distance)
    cruise = min(slowest_velocity(axis), cruise + top * axis[Axis.FULL_RAMP])
    return 4.0 * (cruise / top + axis[Axis.FULL_RAMP]) + distance / cruise


def fastest_between(phases: 'float[:,:]', problem: 'float[:]', axis: 'float[:]') -> int:
    """The optimal forms, one ramp or cruise at the limit; 0 if none is valid."""
    v, a, w, b = problem[Problem.V], problem[Problem.A], problem[Problem.W], problem[Problem.B]
    # nothing is faster than one ramp (phase I.1 alone), if it joins the boundary states
    count = append_change(phases, 0, a, b, axis)
    if count > 0:
        duration = phases[0, Phase.DURATION]
        end = v + 0.5 * (a + b) * duration
        # relative to the motion, which can be tiny
        scale = abs(v) + abs(w) + (abs(a) + abs(b)) * duration
        if abs(end - w) <= SAME * min(fastest_velocity(axis), scale):
            if valid_duration(phases, count, problem, axis) >= 0.0:
                return count
    # both cannot be valid; that in the direction of the distance is more likely
    first = 1 if problem[Problem.DISTANCE] < 0.0 else 0
    # from rest to rest the other one leads away from the target
    sides = 1 if v == 0.0 and a == 0.0 and w == 0.0 and b == 0.0 else 2
    for i in range(sides):
        side = (first + i) % 2
        cruise = -axis[Axis.LOWER] if side == 1 else axis[Axis.VELOCITY]
        count = with_cruise(phases, cruise, problem, axis)
        if count > 0 and valid_duration(phases, count, problem, axis) >= 0.0:
            return count
    return 0


def shortest_between(
    attempt: int, phases: 'float[:,:]', problem: 'float[:]', axis: 'float[:]', work: 'float[:,:]'
) -> int:
    """The shortest candidate between two boundary states, without braking; 0 if none is valid.

    The first attempt (0) tries the optimal forms; the second one tries those that take longer to
    keep the velocity limit. Returns the number of phases.
    """
    trial, family = work[PlanWork.TRIAL:PlanWork.BEST, :], work[PlanWork.FAMILY, :]
    best, shortest = 0, 0.0
    if attempt == 0:
        best = fastest_between(phases, problem, axis)
        if best > 0:
            return best
    found = -1
    for branch in range(4 + attempt):
        if attempt == 0 and found == branch - 1 and same_members(branch, problem, family):
            continue
        if branch == 4:
            count = slower_cruise(trial, problem, axis)
        else:
            set_family(branch, problem, axis, family)
            if attempt == 0:
                count = merged_form(trial, family[Family.TOP], family, axis)
            else:
                count = tempered_form(trial, family, axis)
        if count > 0:
            duration = valid_duration(trial, count, problem, axis)
            if attempt == 0:
                family[Family.FREE] = min(family[Family.FREE], total_duration(trial, count))
            if duration >= 0.0:
                found = branch
            if duration >= 0.0 and (best == 0 or duration < shortest * (1.0 - WORTH)):
                copy_phases(trial, phases, count)
                best = count
                shortest = duration
    return best


def is_done(problem: 'float[:]') -> bool:
    """Whether start and end states are equal."""
    if problem[Problem.DISTANCE] != 0.0 or problem[Problem.V] != problem[Problem.W]:
        return False
    return problem[Problem.A] == problem[Problem.B]


def braked_variant(
    variant: int, longest: float, problem: 'float[:]', axis: 'float[:]', phases: 'float[:,:]',
    work: 'float[:,:]',
) -> 'tuple[int, float]':
    """Write the shortest ramps of a variant if they take less than `longest` [s].

    Variants 0 to 3: braking none, the first, the last or both of the accelerations to zero; 4 to 7
    the same with the second attempt. Returns the number of phases, 0 if there are none, or a
    status; and their duration.
    """
    candidate, rest = work[PlanWork.BEST:PlanWork.GAP_ENDS, :], work[PlanWork.REST, :]
    taken, spent = braked(variant % 4, problem, axis, work)
    if taken == Braking.NOT_NEEDED:
        return 0, 0.0
    if taken < 0:
        return taken, 0.0
    count = shortest_between(variant // 4, candidate, rest, axis, work)
    if count == 0 and variant == 4:
        trial = work[PlanWork.TRIAL:PlanWork.BEST, :]
        count = shorter_cruise(0, candidate, rest, axis, trial)
    if count == 0 and not (is_done(rest) and rest[Problem.A] == 0.0):
        return 0, 0.0
    # braking keeps the limit
    duration = valid_duration(candidate, count, rest, axis)
    if duration < 0.0 or spent + duration >= longest:
        return 0, 0.0
    count = surround(candidate, count, variant % 4, problem, axis, work)
    copy_phases(candidate, phases, count)
    return count, spent + duration


def braked_ramps(
    count: int, problem: 'float[:]', axis: 'float[:]', phases: 'float[:,:]', work: 'float[:,:]'
) -> int:
    """Replace a profile of `count` ramps, 0 if there is none, by the shortest one that brakes.

    It may take longer to keep the limit. Returns the new number of phases, or a status.
    """
    best = count
    shortest = total_duration(phases, count) * (1.0 - GAINED) if count > 0 else NEVER
    usual = usual_duration(problem, axis)
    for variant in range(1, 8):
        # the last three are the fallback
        if variant > 4 and best > 0 and shortest <= usual:
            break
        used, duration = braked_variant(variant, shortest, problem, axis, phases, work)
        if used < 0 and count == 0:
            return used
        if used > 0:
            best = used
            shortest = duration
    return PlanStatus.NO_PROFILE if best == 0 else best


def passing_either_way(
    count: int, phases: 'float[:,:]', asked: 'float[:]', axis: 'float[:]', work: 'float[:,:]'
) -> int:
    """Replace a profile of ramps by the shorter passing one of the motion and of that reversed.

    Returns the new number of phases. Settled, both are the same where the jerk has the levels.
    """
    ramps, passing = work[PlanWork.TRIAL:PlanWork.BEST, :], work[PlanWork.PASSING, :]
    passing[Passing.START] = 0.0
    passing[Passing.JERK] = 0.0
    copy_phases(phases, ramps, count)
    longest = total_duration(ramps, count) * (1.0 - WORTH)
    whole = longest
    forwards = passing_form(whole, longest, count, ramps, phases, asked, axis, work)
    settled = passing[Passing.SETTLED]
    passing[Passing.REVERSED] = 0.0
    result = count
    if forwards > 0:
        if settled != 0.0 and ramps_suffice(axis):
            return forwards
        longest = total_duration(phases, forwards) * (1.0 - WORTH)
        result = forwards
    reverse_search(asked, axis)
    reverse_phases(ramps, 0, count)
    backwards = passing_form(whole, longest, count, ramps, phases, asked, axis, work)
    reverse_search(asked, axis)
    if backwards > 0:
        reverse_phases(phases, 0, backwards)
        passing[Passing.REVERSED] = 1.0
        return backwards
    if forwards > 0:
        passing[Passing.SETTLED] = settled
    return result
