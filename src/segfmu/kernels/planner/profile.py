"""One axis, one pair of boundary states -> the phases of the shortest profile.

The paper's profile (Fig. 3) is a ramp to a first acceleration level, a hold (I.1, I.c), a ramp
to zero, a cruise, a ramp to a second level, a hold and a ramp to the end (I.2, c, II.1, II.c,
II.2). Phases of zero length vanish. docs/planner.md lists the candidates: one ramp alone, a cruise
at the velocity limit, the merged form without cruise (levels.py), tempered where the velocity
exceeds its limit, and the paper's form with a lower cruise velocity; beside these, arcs of two
levels next to a single ramp (arcs.py) and profiles that pass zero jerk with snap (passing.py).

The forms are tried from the given boundary states and, if that exceeds the velocity limit inside a
ramp, after braking the boundary accelerations to zero. After braking both, the paper's form always
exists: its distance is continuous in the cruise velocity and unbounded at the two limits.
"""

from segfmu.kernels.planner.arcs import loop_form
from segfmu.kernels.planner.braking import braked, nearly_brakes, surround
from segfmu.kernels.planner.cruise import direct_form, shorter_cruise, slower_cruise, with_cruise
from segfmu.kernels.planner.merged import merged_form, set_family, tempered_form
from segfmu.kernels.planner.parameters import ramps_suffice, snap_is_last
from segfmu.kernels.planner.passing import passing_form
from segfmu.kernels.planner.phases import (
    append_change,
    boundary_problem,
    copy_phases,
    is_resting,
    reverse_phases,
    reverse_problem,
    total_duration,
    valid_duration,
)
from segfmu.kernels.planner.records import (
    Axis,
    Braking,
    Family,
    LoopArc,
    Passing,
    Phase,
    PlanStatus,
    PlanWork,
    Problem,
)
from segfmu.kernels.planner.window import early_window, short_window


def usual_duration(problem: 'float[:]', axis: 'float[:]') -> float:
    """Upper bound [s] for the duration of the paper's form with cruise."""
    limit = axis[Axis.VELOCITY]
    change = limit / axis[Axis.ACCELERATION] + axis[Axis.FULL_RAMP]
    return 4.0 * change + abs(problem[Problem.DISTANCE]) / limit


def fastest_between(phases: 'float[:,:]', problem: 'float[:]', axis: 'float[:]') -> int:
    """The optimal forms, one ramp or cruise at the limit; 0 if none is valid."""
    v = problem[Problem.V]
    a = problem[Problem.A]
    w = problem[Problem.W]
    b = problem[Problem.B]
    velocity_limit = axis[Axis.VELOCITY]
    # nothing is faster than one ramp (phase I.1 alone), if it joins the boundary states
    count = append_change(phases, 0, a, b, axis)
    if count > 0:
        duration = phases[0, Phase.DURATION]
        end = v + 0.5 * (a + b) * duration
        # relative to the motion, which can be tiny
        scale = abs(v) + abs(w) + (abs(a) + abs(b)) * duration
        if abs(end - w) <= 1e-13 * min(velocity_limit, scale):
            if valid_duration(phases, count, problem, axis) >= 0.0:
                return count
    # both cannot be valid; that in the direction of the distance is more likely
    first = 0
    if problem[Problem.DISTANCE] < 0.0:
        first = 1
    for i in range(2):
        side = (first + i) % 2
        cruise = velocity_limit * (1 - 2 * side)
        count = with_cruise(phases, cruise, problem, axis)
        if count > 0 and valid_duration(phases, count, problem, axis) >= 0.0:
            return count
    return 0


def shortest_between(
    attempt: int,
    phases: 'float[:,:]',
    problem: 'float[:]',
    axis: 'float[:]',
    work: 'float[:,:]',
) -> int:
    """The shortest candidate between two boundary states, without braking; 0 if none is valid.

    The first attempt (0) tries the optimal forms; the second one tries those that take longer to
    keep the velocity limit. Returns the number of phases.
    """
    trial = work[PlanWork.TRIAL:PlanWork.BEST, :]
    family = work[PlanWork.FAMILY, :]
    if attempt == 0:
        count = fastest_between(phases, problem, axis)
        if count > 0:
            return count
    best = 0
    shortest = 0.0
    found = -1
    for branch in range(6 - attempt):
        # the branches of a pair have the same profile, seen from its start or from its end
        if (branch == 1 or branch == 3) and found == branch - 1 and attempt == 0:
            continue
        # the direct form is never faster
        if branch >= 4 and attempt == 0 and best > 0:
            break
        if branch == 4 and attempt == 1:
            count = slower_cruise(trial, problem, axis)
        elif branch >= 4:
            count = direct_form(trial, branch == 4, problem, axis)
        else:
            set_family(branch, problem, axis, family)
            if attempt == 0:
                count = merged_form(trial, axis[Axis.ACCELERATION], family, axis)
            else:
                count = tempered_form(trial, family, axis)
        if count > 0:
            duration = valid_duration(trial, count, problem, axis)
            if attempt == 0:
                family[Family.FREE] = min(family[Family.FREE], total_duration(trial, count))
            if duration >= 0.0:
                found = branch
            if duration >= 0.0 and (best == 0 or duration < shortest):
                copy_phases(trial, phases, count)
                best = count
                shortest = duration
    return best


def is_done(problem: 'float[:]') -> bool:
    """Whether start and end states are equal."""
    if problem[Problem.DISTANCE] != 0.0 or problem[Problem.V] != problem[Problem.W]:
        return False
    return problem[Problem.A] == problem[Problem.B]


def begin_search(problem: 'float[:]', axis: 'float[:]', work: 'float[:,:]') -> None:
    """Set the boundary problem in the row PROBLEM of `work` (PlanWork); nothing is known of it."""
    boundary_problem(problem, axis, work[PlanWork.PROBLEM, :])
    work[PlanWork.FAMILY, Family.MISSED] = 0.0
    work[PlanWork.FAMILY, Family.FREE] = 1e300
    work[PlanWork.PASSING, Passing.PLAIN] = 0.0


def shortest_ramps(
    problem: 'float[:]', axis: 'float[:]', phases: 'float[:,:]', work: 'float[:,:]'
) -> int:
    """`shortest_profile` of ramps of the acceleration alone, without loops."""
    asked = work[PlanWork.PROBLEM, :]
    begin_search(problem, axis, work)
    if is_done(asked):
        return 0
    count = shortest_between(0, phases, asked, axis, work)
    if count == 0:
        count = braked_ramps(asked, axis, phases, work)
    return count


def shortest_profile(
    problem: 'float[:]', axis: 'float[:]', phases: 'float[:,:]', work: 'float[:,:]'
) -> int:
    """Phases of the shortest profile of a boundary problem (Problem) of one axis (Axis).

    `phases` has the rows of Cell.BELOW, `work` those of `PlanWork`. Returns the number of phases
    (0 when there is nothing to do), or the status START_BRAKING, END_BRAKING or NO_PROFILE
    (PlanStatus).
    """
    begin_search(problem, axis, work)
    return begun_profile(axis, phases, work)


def plain_profile(
    problem: 'float[:]', axis: 'float[:]', phases: 'float[:,:]', work: 'float[:,:]'
) -> int:
    """`shortest_profile` without the ways that are tried last.

    It is for profiles that others cannot be slowed down to, and for searches, where it takes a
    third less time and the result is no worse.
    """
    begin_search(problem, axis, work)
    work[PlanWork.PASSING, Passing.PLAIN] = 1.0
    return begun_profile(axis, phases, work)


def begun_profile(axis: 'float[:]', phases: 'float[:,:]', work: 'float[:,:]') -> int:
    """`shortest_profile` of the problem that is set."""
    asked = work[PlanWork.PROBLEM, :]
    family = work[PlanWork.FAMILY, :]
    work[PlanWork.PASSING, Passing.SETTLED] = 1.0
    if is_done(asked):
        return 0
    count = shortest_between(0, phases, asked, axis, work)
    missed = 2.0 * family[Family.MISSED]
    if count == 0:
        free = family[Family.FREE]
        count = shortest_braked(asked, axis, phases, work)
        if work[PlanWork.PASSING, Passing.SETTLED] < 0.5:
            missed = max(missed, 1.0)
        if count > 0 and misses_little(free, total_duration(phases, count), asked, axis):
            missed = 2.0
    else:
        rest = work[PlanWork.REST, :]
        longest = short_window(total_duration(phases, count), asked, axis, rest)
        if longest > 0.0:
            count = loop_form(LoopArc.FOLD, count, longest, phases, asked, axis, work)
            if total_duration(phases, count) > longest:
                missed = 2.0
        if axis[Axis.ABOVE] > 0.5 and not ramps_suffice(axis):
            count = passing_either_way(count, phases, asked, axis, work)
    linear = axis[Axis.LINEAR_FROM] <= axis[Axis.ACCELERATION]
    if count > 0 and axis[Axis.PLATEAU] < 0.5 and linear:
        # two ramps by way of zero may take no longer than one, over another distance
        trial = work[PlanWork.TRIAL:PlanWork.BEST, :]
        count = shorter_cruise(count, phases, asked, axis, trial)
    # where the snap is not the highest limit, steeper rises are always tried
    if not snap_is_last(axis) and not is_resting(asked, axis):
        missed = 2.0
    family[Family.MISSED] = missed
    return count


def shortest_braked(
    asked: 'float[:]', axis: 'float[:]', phases: 'float[:,:]', work: 'float[:,:]'
) -> int:
    """`shortest_profile` where the optimal forms fail."""
    # nothing is shorter; 1e300 if there is none without the velocity limit either
    free = work[PlanWork.FAMILY, Family.FREE]
    status = braked_ramps(asked, axis, phases, work)
    longest = usual_duration(asked, axis)
    if status > 0:
        settled = False
        if axis[Axis.ABOVE] > 0.5:
            status = passing_either_way(status, phases, asked, axis, work)
            settled = work[PlanWork.PASSING, Passing.SETTLED] > 0.5 and ramps_suffice(axis)
        longest = total_duration(phases, status)
        if settled and longest <= 1.1 * free and early_window(longest, asked, axis) <= 0.0:
            return status
    # from rest to rest the other forms have them all; where braking fails, none may pass zero
    passing = asked[Problem.A] * asked[Problem.B] <= 0.0
    if is_resting(asked, axis) or (passing and status < 0 and status != PlanStatus.NO_PROFILE):
        return status
    last = int(LoopArc.FOLD)
    count = max(status, 0)
    window = short_window(longest, asked, axis, work[PlanWork.REST, :])
    if window > 0.0:
        # the arcs are sampled over the time that is given
        count = loop_form(last, count, window, phases, asked, axis, work)
    elif status > 0 and ramps_suffice(axis):
        last = int(LoopArc.LAST)
    if count == 0 or total_duration(phases, count) >= longest:
        count = loop_form(last, count, longest, phases, asked, axis, work)
    if count == 0:
        return status
    if axis[Axis.ABOVE] > 0.5 and (status < 0 or total_duration(phases, count) < longest):
        return passing_either_way(count, phases, asked, axis, work)
    return count


def misses_little(
    free: float, duration: float, asked: 'float[:]', axis: 'float[:]'
) -> bool:
    """Whether steeper rises may permit a profile that does not brake, or one whose acceleration
    keeps its sign. The profile with the usual rises takes `duration` [s], without the velocity
    limit `free`."""
    if duration > 1.3 * free:
        return True
    if early_window(duration, asked, axis) > 0.0:
        return True
    if nearly_brakes(asked[Problem.V], asked[Problem.A], axis):
        return True
    return nearly_brakes(asked[Problem.W], -asked[Problem.B], axis)


def passing_either_way(
    count: int, phases: 'float[:,:]', asked: 'float[:]', axis: 'float[:]', work: 'float[:,:]'
) -> int:
    """Replace a profile of ramps by the shorter passing one of the motion and of that reversed.

    Returns the new number of phases. Settled, both are the same where the jerk has the levels.
    """
    ramps = work[PlanWork.TRIAL:PlanWork.BEST, :]
    passing = work[PlanWork.PASSING, :]
    passing[Passing.START] = 0.0
    passing[Passing.JERK] = 0.0
    copy_phases(phases, ramps, count)
    longest = total_duration(ramps, count) * (1.0 - 1e-9)
    whole = longest
    forwards = passing_form(whole, longest, count, ramps, phases, asked, axis, work)
    settled = passing[Passing.SETTLED]
    passing[Passing.REVERSED] = 0.0
    result = count
    if forwards > 0:
        if settled > 0.5 and ramps_suffice(axis):
            return forwards
        longest = total_duration(phases, forwards)
        result = forwards
    reverse_problem(asked)
    reverse_phases(ramps, 0, count)
    backwards = passing_form(whole, longest, count, ramps, phases, asked, axis, work)
    reverse_problem(asked)
    if backwards > 0:
        reverse_phases(phases, 0, backwards)
        passing[Passing.REVERSED] = 1.0
        return backwards
    if forwards > 0:
        passing[Passing.SETTLED] = settled
    return result


def braked_ramps(
    problem: 'float[:]', axis: 'float[:]', phases: 'float[:,:]', work: 'float[:,:]'
) -> int:
    """The shortest ramps, with braking or forms that take longer to keep the limit; or a status."""
    trial = work[PlanWork.TRIAL:PlanWork.BEST, :]
    candidate = work[PlanWork.BEST:PlanWork.GAP_ENDS, :]
    rest = work[PlanWork.REST, :]
    best = 0
    shortest = 0.0
    usual = usual_duration(problem, axis)
    for variant in range(1, 8):
        # variants 0 to 3: braking none, the first, the last or both of the accelerations to zero;
        # 4 to 7 the same with the second attempt; the last three are the fallback
        if variant > 4 and best > 0 and shortest <= usual:
            break
        taken, spent = braked(variant % 4, problem, axis, work)
        if taken == Braking.NOT_NEEDED:
            continue
        if taken < 0:
            return taken
        count = shortest_between(variant // 4, candidate, rest, axis, work)
        if count == 0 and variant == 4:
            count = shorter_cruise(0, candidate, rest, axis, trial)
        if count == 0 and not (is_done(rest) and rest[Problem.A] == 0.0):
            continue
        # braking keeps the limit
        duration = valid_duration(candidate, count, rest, axis)
        if duration >= 0.0 and (best == 0 or spent + duration < shortest):
            count = surround(candidate, count, variant % 4, problem, axis, work)
            copy_phases(candidate, phases, count)
            best = count
            shortest = spent + duration
    if best == 0:
        return PlanStatus.NO_PROFILE
    return best
