"""Profiles that pass zero jerk with snap, for limits above the snap: see sequence.py.

Newton's method finds the levels of a sequence from those in an ordinary profile (starts.py). Where
a derivative then exceeds its limit, it gets a plateau there (plateaus.py). If that fails, the whole
sequence is slowed down until it keeps the limits; levels of the snap have another way (tighten.py).
"""

from segfmu.kernels.numerics.numbers import EQUAL, FINE, SAME, TRIES, WORTH
from segfmu.kernels.planner.active_set import follow
from segfmu.kernels.planner.excess import measure_excess
from segfmu.kernels.planner.newton import solve_sequence
from segfmu.kernels.planner.orientation import reverse_search
from segfmu.kernels.planner.phases import append_phase, is_passing, reverse_phases
from segfmu.kernels.planner.plateaus import (
    keep_sequence,
    meet_limits,
    overlong_plateau,
    restore_sequence,
)
from segfmu.kernels.planner.records import Node, Passing, PlanWork, Problem, Tighten, Touch
from segfmu.kernels.planner.sequence import residual_scale, run_sequence, sequence_duration
from segfmu.kernels.planner.sides import side_limit
from segfmu.kernels.planner.starts import first_solution, is_brief, shorter_solution
from segfmu.kernels.planner.tighten import ALL_LONGER, EACH, tighten

# the pace of a sequence that is slowed down, from the one before
SLOWER = 0.97


def slow_down(longest: float, problem: 'float[:]', axis: 'float[:]', work: 'float[:,:]') -> bool:
    """Slow a solved sequence down, as little as possible, until it keeps the limits.

    False if that takes longer than `longest` [s].
    """
    passing, nodes = work[PlanWork.PASSING, :], work[PlanWork.NODES:PlanWork.KEPT, :]
    fast, slow = 1.0, 0.0
    for i in range(TRIES):
        passing[Passing.PACE] = 0.5 * (slow + fast) if slow > 0.0 else SLOWER * fast
        if not solve_sequence(problem, axis, work):
            break
        if sequence_duration(passing, nodes) >= longest:
            break
        if overlong_plateau(work) < 0 and not measure_excess(axis, work):
            keep_sequence(PlanWork.KEPT, work)
            slow = passing[Passing.PACE]
        else:
            fast = passing[Passing.PACE]
        if slow > 0.0 and fast - slow < FINE:
            break
    if slow > 0.0:
        restore_sequence(PlanWork.KEPT, work)
    return slow > 0.0


def flush_levels(problem: 'float[:]', axis: 'float[:]', work: 'float[:,:]') -> None:
    """Set levels to zero whose ramps are too short for any clock; the states do not feel it."""
    passing, nodes = work[PlanWork.PASSING, :], work[PlanWork.NODES:PlanWork.KEPT, :]
    for i in range(int(passing[Passing.COUNT])):
        short = abs(nodes[i, Node.TIME]) < SAME * passing[Passing.TIME]
        if short and nodes[i, Node.KIND] == 0.0:
            nodes[i, Node.TIME] = 0.0
    run_sequence(problem, passing, axis, nodes, work[PlanWork.RESIDUAL, :])


def idle_time(i: int, axis: 'float[:]', work: 'float[:,:]') -> float:
    """Time [s] of a level between two of zero that changes nothing that matters; 0: it does.

    Its ramps can be too short for the clock of a long plan, and yet reach the limit of the snap.
    """
    passing = work[PlanWork.PASSING, :]
    row = PlanWork.NODES + i
    before = work[row - 1, Node.LEVEL] if i > 0 else passing[Passing.START]
    if before != 0.0 or work[row, Node.LEVEL] == 0.0 or work[row + 1, Node.LEVEL] != 0.0:
        return 0.0
    spent = work[row, Node.RAMP] + work[row, Node.HOLD] + work[row + 1, Node.RAMP]
    scale = residual_scale(int(passing[Passing.ABOVE]) + 1, passing, axis)
    return 0.0 if abs(work[row, Node.LEVEL]) * spent > EQUAL * scale else spent


def write_sequence(
    phases: 'float[:,:]', problem: 'float[:]', axis: 'float[:]', work: 'float[:,:]'
) -> int:
    """Write a solved sequence as phases; their number."""
    flush_levels(problem, axis, work)
    above, level = work[PlanWork.PASSING, Passing.ABOVE], work[PlanWork.PASSING, Passing.START]
    used, idle = 0, 0.0
    for i in range(int(work[PlanWork.PASSING, Passing.COUNT]) + 1):
        row = PlanWork.NODES + i
        after = idle
        idle = idle_time(i, axis, work)
        if idle > 0.0:
            # the derivative below the levels is held as long, with the ramp that follows
            state = Node.STATE + int(above) + 1
            used = append_phase(phases, used, idle, 0.0, work[row, state], 0.0, above - 1.0)
            level = 0.0
            continue
        if after == 0.0:
            ramp = work[row, Node.RAMP]
            basis = ramp * work[PlanWork.PASSING, Passing.PACE]
            change = work[row, Node.LEVEL] - level
            used = append_phase(phases, used, ramp, basis, level, change, above)
        level = work[row, Node.LEVEL]
        if work[row, Node.HOLD] > 0.0 and int(work[row, Node.TOUCH]) == Touch.HOLDS:
            held = level
            order = above
            if work[row, Node.KIND] != 0.0 and level == 0.0:
                # this derivative is held, without the rounding errors of the ramps before
                order = max(work[row, Node.KIND] - 2.0, 0.0)
                held = 0.0
                kind = int(work[row, Node.KIND])
                if kind > 1:
                    sign = work[row, Node.SIGN]
                    held = sign * side_limit(kind, sign, axis)
            used = append_phase(phases, used, work[row, Node.HOLD], 0.0, held, 0.0, order)
    return used


def stays_below(work: 'float[:,:]') -> bool:
    """Whether a derivative of a sequence stays below its limit where it could reach it."""
    for i in range(int(work[PlanWork.PASSING, Passing.COUNT])):
        if int(work[PlanWork.NODES + i, Node.TOUCH]) == Touch.BELOW:
            return True
    return False


def passing_duration(
    way: int, longest: float, problem: 'float[:]', axis: 'float[:]', work: 'float[:,:]'
) -> float:
    """Duration of the solved sequence after it meets the limits in one of several ways.

    Plateaus (0), a slower pace (1), or limits that come down in steps (2). -1: there is none.
    """
    restore_sequence(PlanWork.SOLVED, work)
    if way == 2:
        found = tighten(longest, problem, axis, work)
    elif way == 1:
        found = slow_down(longest, problem, axis, work)
    else:
        found = meet_limits(longest, problem, axis, work)
    if not found:
        return -1.0
    return sequence_duration(work[PlanWork.PASSING, :], work[PlanWork.NODES:PlanWork.KEPT, :])


def usual_ways(axis: 'float[:]', work: 'float[:,:]') -> int:
    """In how many ways sequences meet the limits (`passing_duration`)."""
    if is_brief(axis):
        return 1
    return 3 if work[PlanWork.PASSING, Passing.PLAIN] == 0.0 else 2


def shortest_way(
    ways: int, shortest: float, longest: float, phases: 'float[:,:]', problem: 'float[:]',
    axis: 'float[:]', work: 'float[:,:]',
) -> 'tuple[int, float]':
    """Write the profile in which a solved sequence meets the limits soonest, as `passing_form`.

    Returns its phases, 0 if there is none, and the duration that the next one has to be below.
    """
    used = 0
    for way in range(ways):
        found = passing_duration(way, shortest, problem, axis, work)
        if found > 0.0 and found < (1.0 - WORTH) * shortest:
            shortest = found
            if found < longest:
                used = write_sequence(phases, problem, axis, work)
                keep_sequence(PlanWork.FOUND, work)
            if way == 2 or (way == 0 and not stays_below(work)):
                work[PlanWork.PASSING, Passing.SETTLED] = 1.0
                break
    return used, shortest


def passing_form(
    shortest: float, longest: float, count: int, ramps: 'float[:,:]', phases: 'float[:,:]',
    problem: 'float[:]', axis: 'float[:]', work: 'float[:,:]',
) -> int:
    """Write a passing profile that takes less than `longest` [s]; 0: none, else its phases.

    shortest >= longest: duration of the profile of `count` ramps of the acceleration to start from.
    The sequence is kept in the rows FOUND of `work`; it starts at the level START.
    """
    passing = work[PlanWork.PASSING, :]
    passing[Passing.SETTLED] = 0.0
    ways = usual_ways(axis, work)
    if not first_solution(count, ramps, problem, axis, work):
        return 0
    used = 0
    if passing[Passing.PLAIN] == 0.0 and shorter_solution(problem, axis, work):
        used, shortest = shortest_way(ways, shortest, longest, phases, problem, axis, work)
        if passing[Passing.SETTLED] != 0.0:
            return used
        first_solution(count, ramps, problem, axis, work)
    others, shortest = shortest_way(ways, shortest, longest, phases, problem, axis, work)
    return others if others > 0 else used


def pace_down(
    moving: int, shortest: float, problem: 'float[:]', axis: 'float[:]', work: 'float[:,:]'
) -> bool:
    """Slow the sequence that was found down from `shortest` to the problem's duration [s].

    In steps, as few as possible. moving: 1: instants at limits may move. False if that breaks a
    limit or fails.
    """
    restore_sequence(PlanWork.FOUND, work)
    passing, taken = work[PlanWork.PASSING, :], work[PlanWork.TIGHTEN, :]
    target = problem[Problem.DURATION]
    keep_sequence(PlanWork.SOLVED, work)
    taken[Tighten.STEPS] = 0.0
    taken[Tighten.MOVING] = moving
    reached = shortest
    step = target - shortest
    least = FINE * step
    while reached < target:
        taken[Tighten.MOST] = taken[Tighten.STEPS] + EACH
        duration = min(reached + step, target)
        if follow(duration, problem, axis, work) and passing[Passing.PACE] <= 1.0:
            keep_sequence(PlanWork.SOLVED, work)
            reached = duration
        else:
            step = 0.5 * step
        if step < least or taken[Tighten.STEPS] > ALL_LONGER:
            return False
    return True


def timed_passing(
    phases: 'float[:,:]', problem: 'float[:]', axis: 'float[:]', work: 'float[:,:]'
) -> int:
    """Slow the passing profile that was found down so that it lasts the problem's duration.

    Returns the number of its phases; 0 if that breaks a limit, or if it takes longer already.
    """
    restore_sequence(PlanWork.FOUND, work)
    shortest = sequence_duration(work[PlanWork.PASSING, :], work[PlanWork.NODES:PlanWork.KEPT, :])
    if problem[Problem.DURATION] < shortest:
        return 0
    # moving first would refuse more durations; without an instant it costs time and finds no more
    ways = 2 if work[PlanWork.PASSING, Passing.INSTANTS] != 0.0 else 1
    for moving in range(ways):
        if pace_down(moving, shortest, problem, axis, work):
            return write_sequence(phases, problem, axis, work)
    return 0


def slower_form(
    count: int, phases: 'float[:,:]', problem: 'float[:]', axis: 'float[:]', work: 'float[:,:]'
) -> int:
    """Slow a profile of `count` phases down; their new number, 0 if that fails.

    It may have been found reversed, but not mirrored: what is slowed down goes forwards (`orient`).
    """
    if not is_passing(phases, count, axis):
        return 0
    return slowed_sequence(phases, problem, axis, work)


def slowed_sequence(
    phases: 'float[:,:]', problem: 'float[:]', axis: 'float[:]', work: 'float[:,:]'
) -> int:
    """`slower_form` of the passing profile that was found."""
    backwards = work[PlanWork.PASSING, Passing.REVERSED] != 0.0
    if backwards:
        reverse_search(problem, axis)
    count = timed_passing(phases, problem, axis, work)
    if backwards:
        reverse_search(problem, axis)
        reverse_phases(phases, 0, count)
    return count
