"""Passing profiles (passing.py) whose velocity touches its limit near an end.

Where braking exceeds the velocity limit, the shortest motions can be in windows of feasible
durations. Other starts of Newton's method often do not lead there.
"""

from segfmu.kernels.numerics.numbers import SMALL, WORTH
from segfmu.kernels.planner.instant import add_instant
from segfmu.kernels.planner.orientation import reverse_search
from segfmu.kernels.planner.parameters import ramps_suffice
from segfmu.kernels.planner.passing import shortest_way, usual_ways
from segfmu.kernels.planner.phases import (
    copy_phases,
    reverse_phases,
    steepest_acceleration,
    total_duration,
)
from segfmu.kernels.planner.plateaus import (
    insert_node,
    keep_sequence,
    set_alternating,
    solve_rotated,
)
from segfmu.kernels.planner.ramp import ramp_duration
from segfmu.kernels.planner.records import Passing, PlanWork, Problem
from segfmu.kernels.planner.sequence import sequence_duration
from segfmu.kernels.planner.sides import side_limit
from segfmu.kernels.planner.starts import begin_sequence

# two levels of the snap make one of the jerk, in this time
TWO_LEVELS = 0.7
# variants whose velocity touches its limit at one end at most: attempts of short searches
ONE_END = 6


def sign_of(value: float) -> float:
    """-1 below zero, else 1."""
    return -1.0 if value < 0.0 else 1.0


def may_touch(v: float, a: float, axis: 'float[:]') -> bool:
    """Whether the ramp from the acceleration a to zero comes near the velocity limit."""
    duration, slope = ramp_duration(abs(a), axis)
    sign = sign_of(a)
    return sign * v + 0.5 * abs(a) * duration > (1.0 - SMALL) * side_limit(1, sign, axis)


def set_touching(variant: int, duration: float, problem: 'float[:]', work: 'float[:,:]') -> None:
    """Set levels that alternate, with a velocity that touches its limit where braking exceeds it.

    There is one level more than the conditions at the end need for each place where it touches: at
    the first level (variants 0 and 1), the second one (2 and 3), the last one (4 and 5), or at both
    ends (6 and 7). The first level is above (0, 2, 4, 6) or below zero. duration: about what the
    sequence takes [s].
    """
    passing = work[PlanWork.PASSING, :]
    q = int(passing[Passing.ABOVE]) + 2
    sign = -1.0 if variant % 2 == 1 else 1.0
    time = duration / (q + 2)
    if q == 4:
        # two levels of the snap make one of the jerk
        time = TWO_LEVELS * time
    set_alternating(sign, time, work)
    last = sign * (1.0 - 2.0 * (q % 2))
    insert_node(q, 0, last, time, False, work)
    if variant < 4:
        add_instant(1, sign_of(problem[Problem.A]), 1 + variant // 2, passing)
    else:
        add_instant(1, sign_of(-problem[Problem.B]), q - 1, passing)
    if variant >= ONE_END:
        insert_node(q + 1, 0, -last, time, False, work)
        add_instant(1, sign_of(problem[Problem.A]), 1, passing)


def touching_guess(attempt: int) -> 'tuple[int, float]':
    """Variant of `set_touching`, and what it takes over the duration of a longer profile.

    Of 34 attempts the first six are most likely to succeed; the last four are those whose velocity
    touches its limit at both ends.
    """
    both = attempt - 5 * ONE_END
    if both >= 0:
        return ONE_END + both % 2, 0.5 + 0.15 * (both // 2)
    time = attempt // ONE_END
    share = 0.65
    if time == 1:
        share = 0.5
    elif time == 2:
        share = 0.75
    elif time == 3:
        share = 1.0
    elif time == 4:
        share = 0.35
    return attempt % ONE_END, share


def touching_starts(
    count: int, longest: float, ramps: 'float[:,:]', phases: 'float[:,:]', problem: 'float[:]',
    axis: 'float[:]', work: 'float[:,:]',
) -> 'tuple[int, float]':
    """As `shortest_way`, from sequences in which the velocity touches its limit at an end.

    ramps: `count` phases of a profile that takes longer.
    """
    passing = work[PlanWork.PASSING, :]
    whole = total_duration(ramps, count)
    acceleration = steepest_acceleration(whole, problem, axis)
    first = may_touch(problem[Problem.V], problem[Problem.A], axis)
    last = may_touch(problem[Problem.W], -problem[Problem.B], axis)
    used, before = 0, 0.0
    attempts = 5 * ONE_END + 4
    ways = usual_ways(axis, work)
    if ramps_suffice(axis):
        # of 2,576 problems with barely braked states others would shorten two, in more time
        attempts, ways = ONE_END, 1
    for attempt in range(attempts):
        variant, share = touching_guess(attempt)
        if (variant < 4 or variant > 5) and not first:
            continue
        if variant > 3 and not last:
            continue
        begin_sequence(whole, acceleration, axis, passing)
        set_touching(variant, share * whole, problem, work)
        if not solve_rotated(problem, axis, work):
            continue
        duration = sequence_duration(passing, work[PlanWork.NODES:PlanWork.KEPT, :])
        if duration < longest and abs(duration - before) > WORTH * duration:
            before = duration
            keep_sequence(PlanWork.SOLVED, work)
            found, longest = shortest_way(ways, longest, longest, phases, problem, axis, work)
            if found > 0:
                used = found
    return used, longest


def touching_form(
    count: int, phases: 'float[:,:]', problem: 'float[:]', axis: 'float[:]', work: 'float[:,:]'
) -> int:
    """Replace a profile of `count` phases by a shorter passing one; its number of phases.

    Newton's method starts from the motion and from that reversed. Unlike `passing_either_way`, the
    reversed one is always tried, as the level at which the velocity touches is another one there.
    """
    passing, ramps = work[PlanWork.PASSING, :], work[PlanWork.TRIAL:PlanWork.BEST, :]
    copy_phases(phases, ramps, count)
    passing[Passing.START] = 0.0
    passing[Passing.JERK] = 0.0
    longest = total_duration(ramps, count) * (1.0 - WORTH)
    result, longest = touching_starts(count, longest, ramps, phases, problem, axis, work)
    reverse_search(problem, axis)
    backwards, longest = touching_starts(count, longest, ramps, phases, problem, axis, work)
    reverse_search(problem, axis)
    if backwards > 0:
        reverse_phases(phases, 0, backwards)
        passing[Passing.REVERSED] = 1.0
        return backwards
    if result > 0:
        passing[Passing.REVERSED] = 0.0
        return result
    return count
