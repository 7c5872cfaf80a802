"""Profiles that pass zero jerk with snap, for limits above the snap: see sequence.py.

A sequence starts from the ramps of an ordinary profile. Newton's method finds its levels; where a
derivative then exceeds its limit, it gets a plateau there. If that fails, the whole sequence is
slowed down until it keeps the limits.
"""

from math import sqrt

from segfmu.kernels.planner.excess import measure_excess
from segfmu.kernels.planner.newton import solve_sequence
from segfmu.kernels.planner.parameters import ramps_suffice
from segfmu.kernels.planner.phases import append_hold, total_duration
from segfmu.kernels.planner.plateaus import (
    insert_node,
    keep_sequence,
    meet_limits,
    overlong_plateau,
    restore_sequence,
    solve_rotated,
)
from segfmu.kernels.planner.ramp import inner_rise, ramp_duration
from segfmu.kernels.planner.records import Axis, Node, Passing, Phase, PlanWork, Problem
from segfmu.kernels.planner.sequence import is_square, sequence_duration
from segfmu.kernels.planner.tighten import tighten


def append_level(sign: float, time: float, work: 'float[:,:]') -> None:
    """Append a level to a sequence, or enlarge the last one if that has the same sign."""
    count = int(work[PlanWork.PASSING, Passing.COUNT])
    if count > 0:
        row = PlanWork.NODES + count - 1
        if work[row, Node.KIND] < 0.5 and work[row, Node.SIGN] == sign:
            last = work[row, Node.TIME]
            work[row, Node.TIME] = sqrt(last * last + time * time)
            return
    insert_node(count, 0, sign, time, False, work)


def append_levels(change: float, axis: 'float[:]', work: 'float[:,:]') -> None:
    """Append the levels of a ramp of the acceleration; nothing for no change."""
    if change == 0.0:
        return
    sign = 1.0
    if change < 0.0:
        sign = -1.0
    duration, slope = ramp_duration(abs(change), axis)
    rise = inner_rise(duration, 0, axis)
    hold = max(duration - 2.0 * rise, 0.0)
    if work[PlanWork.PASSING, Passing.ABOVE] < 1.5:
        append_level(sign, rise + hold, work)
        return
    time = rise - inner_rise(rise, 1, axis)
    append_level(sign, time, work)
    if hold > 1e-9 * duration:
        count = int(work[PlanWork.PASSING, Passing.COUNT])
        insert_node(count, 3, sign, hold, False, work)
    append_level(-sign, time, work)


def limit_held(a: float, v: float, axis: 'float[:]') -> 'tuple[int, float]':
    """The derivative that a hold keeps at its limit, 1 or 2, and its sign; 0 if there is none."""
    order = 0
    value = 0.0
    if abs(a) >= axis[Axis.ACCELERATION] * (1.0 - 1e-9):
        order = 2
        value = a
    elif a == 0.0 and abs(v) >= axis[Axis.VELOCITY] * (1.0 - 1e-9):
        order = 1
        value = v
    if value < 0.0:
        return order, -1.0
    return order, 1.0


def copy_levels(
    count: int, phases: 'float[:,:]', v: float, axis: 'float[:]', work: 'float[:,:]'
) -> None:
    """Set the sequence of the levels in the ramps of an ordinary profile from the velocity v."""
    passing = work[PlanWork.PASSING, :]
    passing[Passing.COUNT] = 0.0
    pending = 0.0
    for i in range(count):
        a = phases[i, Phase.ACCELERATION]
        change = phases[i, Phase.CHANGE]
        duration = phases[i, Phase.DURATION]
        if change * pending < 0.0:
            append_levels(pending, axis, work)
            pending = 0.0
        pending = pending + change
        if change == 0.0:
            order, sign = limit_held(a, v, axis)
            if order > 0:
                append_levels(pending, axis, work)
                pending = 0.0
                insert_node(int(passing[Passing.COUNT]), order, sign, duration, False, work)
        v = v + (a + 0.5 * change) * duration
    append_levels(pending, axis, work)


def set_sequence(
    attempt: int, count: int, phases: 'float[:,:]', problem: 'float[:]', axis: 'float[:]',
    work: 'float[:,:]',
) -> bool:
    """Set what Newton's method starts from in an attempt; False if it is that of another one."""
    passing = work[PlanWork.PASSING, :]
    q = int(axis[Axis.ABOVE]) + 2
    passing[Passing.ABOVE] = axis[Axis.ABOVE]
    passing[Passing.PACE] = 1.0
    passing[Passing.TARGET] = 0.0
    passing[Passing.INSTANTS] = 0.0
    passing[Passing.TIME] = total_duration(phases, count)
    passing[Passing.ACCELERATION] = 0.0
    for i in range(count):
        a = abs(phases[i, Phase.ACCELERATION] + phases[i, Phase.CHANGE])
        passing[Passing.ACCELERATION] = max(passing[Passing.ACCELERATION], a)
        a = abs(phases[i, Phase.ACCELERATION])
        passing[Passing.ACCELERATION] = max(passing[Passing.ACCELERATION], a)
    copy_levels(count, phases, problem[Problem.V], axis, work)
    if not is_square(passing, work[PlanWork.NODES:PlanWork.KEPT, :]):
        passing[Passing.COUNT] = 0.0
        for i in range(q):
            time = 0.7 * passing[Passing.TIME] / q
            insert_node(i, 0, 1.0 - 2.0 * (i % 2), time, False, work)
    # the levels of ordinary profiles are lower, as they meet at zero
    factor = 1.0
    if q == 4:
        factor = 1.25
    if attempt % 3 == 1:
        factor = 1.3 * factor
    elif attempt % 3 == 2:
        factor = 0.8 * factor
    for i in range(int(passing[Passing.COUNT])):
        row = PlanWork.NODES + i
        if work[row, Node.KIND] < 0.5:
            work[row, Node.TIME] = factor * work[row, Node.TIME]
            if attempt >= 3:
                work[row, Node.SIGN] = -work[row, Node.SIGN]
        elif attempt >= 3:
            return False
    return True


def slow_down(longest: float, problem: 'float[:]', axis: 'float[:]', work: 'float[:,:]') -> bool:
    """Slow a solved sequence down, as little as possible, until it keeps the limits.

    False if that takes longer than `longest` [s].
    """
    passing = work[PlanWork.PASSING, :]
    nodes = work[PlanWork.NODES:PlanWork.KEPT, :]
    fast = 1.0
    slow = 0.0
    for i in range(24):
        passing[Passing.PACE] = 0.97 * fast
        if slow > 0.0:
            passing[Passing.PACE] = 0.5 * (slow + fast)
        if not solve_sequence(problem, axis, work):
            break
        if sequence_duration(passing, nodes) >= longest:
            break
        if overlong_plateau(work) < 0 and not measure_excess(axis, work):
            keep_sequence(PlanWork.KEPT, work)
            slow = passing[Passing.PACE]
        else:
            fast = passing[Passing.PACE]
        if slow > 0.0 and fast - slow < 1e-4:
            break
    if slow > 0.0:
        restore_sequence(PlanWork.KEPT, work)
    return slow > 0.0


def write_sequence(phases: 'float[:,:]', axis: 'float[:]', work: 'float[:,:]') -> int:
    """Write a sequence as phases; their number."""
    above = work[PlanWork.PASSING, Passing.ABOVE]
    level = work[PlanWork.PASSING, Passing.START]
    used = 0
    for i in range(int(work[PlanWork.PASSING, Passing.COUNT]) + 1):
        row = PlanWork.NODES + i
        if work[row, Node.RAMP] > 0.0:
            phases[used, Phase.DURATION] = work[row, Node.RAMP]
            phases[used, Phase.BASIS] = work[row, Node.RAMP] * work[PlanWork.PASSING, Passing.PACE]
            phases[used, Phase.ACCELERATION] = level
            phases[used, Phase.CHANGE] = work[row, Node.LEVEL] - level
            phases[used, Phase.ABOVE] = above
            used = used + 1
        level = work[row, Node.LEVEL]
        if work[row, Node.HOLD] > 0.0 and work[row, Node.TOUCH] < 0.5:
            held = level
            order = above
            if work[row, Node.KIND] > 0.5 and level == 0.0:
                # this derivative is held, without the rounding errors of the ramps before
                order = max(work[row, Node.KIND] - 2.0, 0.0)
                held = 0.0
                if work[row, Node.KIND] > 1.5:
                    kind = int(work[row, Node.KIND])
                    held = work[row, Node.SIGN] * axis[Axis.VELOCITY + kind - 1]
            used = append_hold(phases, used, held, work[row, Node.HOLD])
            phases[used - 1, Phase.ABOVE] = order
    return used


def stays_below(work: 'float[:,:]') -> bool:
    """Whether a derivative of a sequence stays below its limit where it could reach it."""
    for i in range(int(work[PlanWork.PASSING, Passing.COUNT])):
        if work[PlanWork.NODES + i, Node.TOUCH] > 1.5:
            return True
    return False


def passing_duration(
    way: int, longest: float, problem: 'float[:]', axis: 'float[:]', work: 'float[:,:]'
) -> float:
    """Duration of the solved sequence after it meets the limits in one of several ways.

    Plateaus of derivatives of high order first (0), of low order first (1), a slower pace (2), or
    limits that come down in steps (3). -1: there is none.
    """
    restore_sequence(PlanWork.SOLVED, work)
    if way == 3:
        found = tighten(longest, problem, axis, work)
    elif way == 2:
        found = slow_down(longest, problem, axis, work)
    else:
        found = meet_limits(way == 1, longest, problem, axis, work)
    if not found:
        return -1.0
    return sequence_duration(work[PlanWork.PASSING, :], work[PlanWork.NODES:PlanWork.KEPT, :])


def first_solution(
    count: int, ramps: 'float[:,:]', problem: 'float[:]', axis: 'float[:]', work: 'float[:,:]'
) -> bool:
    """Keep the first sequence, of several starts, that has a solution; False if none has."""
    for attempt in range(6):
        if not set_sequence(attempt, count, ramps, problem, axis, work):
            return False
        if solve_rotated(problem, axis, work):
            keep_sequence(PlanWork.SOLVED, work)
            return True
    return False


def passing_form(
    shortest: float, longest: float, count: int, ramps: 'float[:,:]', phases: 'float[:,:]',
    problem: 'float[:]', axis: 'float[:]', work: 'float[:,:]',
) -> int:
    """Write a passing profile that takes less than `longest` [s]; 0: none, else its phases.

    shortest >= longest: duration of the profile of `count` ramps of the acceleration to start from.
    The sequence is kept in the rows FOUND of `work`; it starts at the level START.
    """
    used = 0
    work[PlanWork.PASSING, Passing.SETTLED] = 0.0
    if not first_solution(count, ramps, problem, axis, work):
        return 0
    # where levels of the jerk fail at first, other ways hardly help: 0.5 % in one of 2,000 plans
    few = ramps_suffice(axis)
    # and those of crackle limits gain less than 2 % by the last one
    ways = 3
    if work[PlanWork.PASSING, Passing.ABOVE] > 1.5:
        ways = 4
    for way in range(ways):
        if few and (way > 1 or (way == 1 and used == 0)):
            break
        found = passing_duration(way, shortest, problem, axis, work)
        if found > 0.0 and found < shortest:
            shortest = found
            if found < longest:
                used = write_sequence(phases, axis, work)
                keep_sequence(PlanWork.FOUND, work)
            if way == 3 or (way < 2 and not stays_below(work)):
                work[PlanWork.PASSING, Passing.SETTLED] = 1.0
                break
    return used


def pace_down(
    steps: int, shortest: float, problem: 'float[:]', axis: 'float[:]', work: 'float[:,:]'
) -> bool:
    """Slow the sequence that was found down in steps from `shortest` to the problem's duration [s].

    False if that breaks a limit or fails.
    """
    restore_sequence(PlanWork.FOUND, work)
    passing = work[PlanWork.PASSING, :]
    longer = problem[Problem.DURATION] / shortest - 1.0
    for i in range(steps):
        passing[Passing.TARGET] = shortest * (1.0 + longer * (i + 1) / steps)
        if not solve_rotated(problem, axis, work):
            return False
        if not meet_limits(False, 1e300, problem, axis, work) or passing[Passing.PACE] > 1.0:
            return False
    return True


def timed_passing(
    phases: 'float[:,:]', problem: 'float[:]', axis: 'float[:]', work: 'float[:,:]'
) -> int:
    """Slow the passing profile that was found down so that it lasts the problem's duration.

    Returns the number of its phases; 0 if that breaks a limit.
    """
    restore_sequence(PlanWork.FOUND, work)
    shortest = sequence_duration(
        work[PlanWork.PASSING, :], work[PlanWork.NODES:PlanWork.KEPT, :]
    )
    # by little each time, as plateaus begin and end; but steps can be too small where levels meet
    steps = min(int(20.0 * (problem[Problem.DURATION] / shortest - 1.0)) + 1, 10)
    for i in range(3):
        if pace_down(steps, shortest, problem, axis, work):
            return write_sequence(phases, axis, work)
        steps = 4 * steps
    return 0
