"""One axis, one pair of boundary states -> the phases of the shortest profile.

The paper's profile (Fig. 3) is a ramp to a first acceleration level, a hold (I.1, I.c), a ramp
to zero, a cruise, a ramp to a second level, a hold and a ramp to the end (I.2, c, II.1, II.c,
II.2). Phases of zero length vanish. docs/planner.md lists the candidates: one ramp alone, a cruise
at the velocity limit, the merged form without cruise (levels.py), tempered where the velocity
exceeds its limit, and the paper's form with a lower cruise velocity; beside these, arcs of two
levels next to a single ramp (arcs.py) and profiles that pass zero jerk with snap (passing.py).
"""

from segfmu.kernels.numerics.numbers import NEVER
from segfmu.kernels.planner.arcs import loop_form
from segfmu.kernels.planner.braking import nearly_brakes
from segfmu.kernels.planner.cruise import shorter_cruise
from segfmu.kernels.planner.dipped import shorter_dipped
from segfmu.kernels.planner.forms import (
    braked_ramps,
    is_done,
    passing_either_way,
    shortest_between,
    usual_duration,
)
from segfmu.kernels.planner.orientation import as_asked, orient
from segfmu.kernels.planner.parameters import ramps_suffice, snap_is_last
from segfmu.kernels.planner.phases import (
    boundary_problem,
    is_passing,
    is_resting,
    total_duration,
)
from segfmu.kernels.planner.records import (
    Axis,
    Effort,
    Family,
    LoopArc,
    Passing,
    PlanStatus,
    PlanWork,
    Problem,
    Rises,
)
from segfmu.kernels.planner.repeats import keep_search
from segfmu.kernels.planner.sides import slowest_velocity
from segfmu.kernels.planner.touching import touching_form
from segfmu.kernels.planner.window import early_window, short_window

# durations over those without the velocity limit: nothing is shorter. Of 16,000 random problems
# dips shorten none below 1.09, and longer ones are searched for thoroughly; with levels of the jerk
# most others are found by all ways from the usual starts, in half the time
NEARLY_FREE = 1.05
NEARLY_FREE_JERK = 1.1
FAR_FROM_FREE = 2.0
# where the usual rises cost more than this, steeper ones may permit another profile
MISSED = 1.3


def begin_search(problem: 'float[:]', axis: 'float[:]', work: 'float[:,:]') -> None:
    """Set the boundary problem in the row PROBLEM of `work` (PlanWork); nothing is known of it."""
    boundary_problem(problem, axis, work[PlanWork.PROBLEM, :])
    work[PlanWork.FAMILY, Family.MISSED] = Rises.USUAL
    work[PlanWork.FAMILY, Family.SLOW] = 0.0
    work[PlanWork.FAMILY, Family.FREE] = NEVER
    work[PlanWork.PASSING, Passing.PLAIN] = 0.0


def shortest_ramps(
    problem: 'float[:]', axis: 'float[:]', phases: 'float[:,:]', work: 'float[:,:]'
) -> int:
    """`shortest_profile` of ramps of the acceleration alone, without loops."""
    asked = work[PlanWork.PROBLEM, :]
    begin_search(problem, axis, work)
    if is_done(asked):
        return 0
    mirrored, turned = orient(asked, axis)
    count = shortest_between(0, phases, asked, axis, work)
    if count == 0:
        count = braked_ramps(0, asked, axis, phases, work)
    return as_asked(mirrored, turned, count, phases, asked, axis, work[PlanWork.PASSING, :])


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
    asked, plain = work[PlanWork.PROBLEM, :], work[PlanWork.PASSING, Passing.PLAIN]
    mirrored, turned = orient(asked, axis)
    count = oriented_profile(axis, phases, work)
    if axis[Axis.ABOVE] != 0.0:
        keep_search(plain, is_passing(phases, count, axis), asked, axis, work)
    return as_asked(mirrored, turned, count, phases, asked, axis, work[PlanWork.PASSING, :])


def may_last_longer(problem: 'float[:]', axis: 'float[:]') -> bool:
    """Whether profiles that brake may be shorter than one that does not have to.

    Two smoothsteps by way of zero cover a better distance than one, in about the same time. And
    between states beyond the lower one of two velocity limits, a cruise at that one is a detour.
    """
    fastest = max(abs(problem[Problem.V]), abs(problem[Problem.W]))
    return axis[Axis.PLATEAU] == 0.0 or fastest > slowest_velocity(axis)


def oriented_profile(axis: 'float[:]', phases: 'float[:,:]', work: 'float[:,:]') -> int:
    """`shortest_profile` of the problem that is set, in the direction that it has (`orient`)."""
    asked, family = work[PlanWork.PROBLEM, :], work[PlanWork.FAMILY, :]
    work[PlanWork.PASSING, Passing.SETTLED] = 1.0
    if is_done(asked):
        return 0
    count = shortest_between(0, phases, asked, axis, work)
    missed = int(family[Family.MISSED])
    if count == 0:
        free = family[Family.FREE]
        count = shortest_braked(asked, axis, phases, work)
        if work[PlanWork.PASSING, Passing.SETTLED] == 0.0:
            missed = max(missed, int(Rises.MODERATE))
        if count > 0 and misses_little(free, total_duration(phases, count), asked, axis):
            missed = int(Rises.STEEPEST)
    else:
        rest = work[PlanWork.REST, :]
        longest = short_window(total_duration(phases, count), asked, axis, rest)
        if longest > 0.0:
            count = loop_form(LoopArc.FOLD, count, longest, phases, asked, axis, work)
            if total_duration(phases, count) > longest:
                missed = int(Rises.STEEPEST)
        if axis[Axis.ABOVE] != 0.0 and not ramps_suffice(axis):
            count = passing_either_way(count, phases, asked, axis, work)
    if count > 0 and axis[Axis.PLATEAU] == 0.0:
        # a state of another profile may be followed by its rest, whose cruise vanishes
        count = shorter_cruise(count, phases, asked, axis, work[PlanWork.TRIAL:PlanWork.BEST, :])
    if count > 0 and may_last_longer(asked, axis):
        count = braked_ramps(count, asked, axis, phases, work)
    # where the snap is not the highest limit, steeper rises are always tried
    if not snap_is_last(axis) and not is_resting(asked, axis):
        missed = int(Rises.STEEPEST)
    family[Family.MISSED] = missed
    return count


def shortest_braked(
    asked: 'float[:]', axis: 'float[:]', phases: 'float[:,:]', work: 'float[:,:]'
) -> int:
    """`shortest_profile` where the optimal forms fail, with dips where they shorten it."""
    free = work[PlanWork.FAMILY, Family.FREE]
    status = usual_braked(asked, axis, phases, work)
    if status <= 0 or axis[Axis.ABOVE] == 0.0:
        return status
    most = NEARLY_FREE * free
    far = most
    if ramps_suffice(axis):
        most = NEARLY_FREE_JERK * free
        far = FAR_FROM_FREE * free
    elif total_duration(phases, status) > most:
        status = shorter_dipped(status, phases, asked, axis, work)
    if axis[Axis.EFFORT] == Effort.THOROUGH and total_duration(phases, status) > far:
        status = touching_form(status, phases, asked, axis, work)
    work[PlanWork.FAMILY, Family.SLOW] = total_duration(phases, status) > most
    return status


def usual_braked(
    asked: 'float[:]', axis: 'float[:]', phases: 'float[:,:]', work: 'float[:,:]'
) -> int:
    """`shortest_profile` where the optimal forms fail, without dips: ramps, loops, windows."""
    # nothing is shorter; NEVER if there is none without the velocity limit either
    free = work[PlanWork.FAMILY, Family.FREE]
    status = braked_ramps(0, asked, axis, phases, work)
    longest = usual_duration(asked, axis)
    if status > 0:
        settled = False
        if axis[Axis.ABOVE] != 0.0:
            status = passing_either_way(status, phases, asked, axis, work)
            settled = work[PlanWork.PASSING, Passing.SETTLED] != 0.0 and ramps_suffice(axis)
        longest = total_duration(phases, status)
        settled = settled and longest <= NEARLY_FREE_JERK * free
        if settled and early_window(longest, asked, axis) <= 0.0:
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
    if axis[Axis.ABOVE] != 0.0 and (status < 0 or total_duration(phases, count) < longest):
        return passing_either_way(count, phases, asked, axis, work)
    return count


def misses_little(free: float, duration: float, asked: 'float[:]', axis: 'float[:]') -> bool:
    """Whether steeper rises may permit a profile that does not brake, or one whose acceleration
    keeps its sign. The profile with the usual rises takes `duration` [s], without the velocity
    limit `free`."""
    if duration > MISSED * free:
        return True
    if early_window(duration, asked, axis) > 0.0:
        return True
    if nearly_brakes(asked[Problem.V], asked[Problem.A], axis):
        return True
    return nearly_brakes(asked[Problem.W], -asked[Problem.B], axis)
