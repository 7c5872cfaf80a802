"""Motions of prescribed duration that stay near their path: slow ramps, or a wait at a waypoint.

Slower ramps are smoother, and turn farther away: a motion that begins or ends at rest and has to
turn back stays nearest to its path if it goes on as fast as it can.
"""

from segfmu.kernels.numerics.numbers import EQUAL
from segfmu.kernels.planner.cruise import cruise_form
from segfmu.kernels.planner.enclose import (
    clear_nearest,
    nearest_weight,
    surround_nearest,
    usual_cruise,
)
from segfmu.kernels.planner.gentle import solve_gentle, write_gentle
from segfmu.kernels.planner.phases import (
    fit_duration,
    insert_hold,
    measure_phases,
    stretch_phases,
    total_duration,
)
from segfmu.kernels.planner.profile import shortest_profile
from segfmu.kernels.planner.records import Axis, Cell, Gentle, Interval, Nearest, PlanWork, Problem
from segfmu.kernels.planner.sides import is_beyond
from segfmu.kernels.planner.timed_cruise import is_enclosed

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


def has_to_turn(problem: 'float[:]', axis: 'float[:]', work: 'float[:,:]') -> bool:
    """Whether a motion that begins or ends at rest has to turn back, as it goes too far to stop."""
    trial = work[PlanWork.TRIAL:PlanWork.BEST, :]
    count, row, duration, stop = cruise_form(trial, 0.0, problem, axis)
    return count >= 0 and stop * stop > stop * problem[Problem.DISTANCE]


def timed_waiting(axis: 'float[:]', cell: 'float[:,:]', work: 'float[:,:]') -> float:
    """`timed_profile` where one state is at rest: the shortest profile, and a wait there.

    -1: both states move, the motion goes straight on, or that profile is not found again.
    """
    problem, phases = work[PlanWork.PROBLEM, :], cell[Cell.BELOW:Cell.ABOVE, :]
    first = problem[Problem.V] == 0.0 and problem[Problem.A] == 0.0
    last = problem[Problem.W] == 0.0 and problem[Problem.B] == 0.0
    if not first and not last:
        return -1.0
    if not has_to_turn(problem, axis, work):
        return -1.0
    count = shortest_profile(problem, axis, phases, work)
    wait = problem[Problem.DURATION] - total_duration(phases, max(count, 0))
    if count <= 0 or count >= phases.shape[0] or wait < 0.0:
        return -1.0
    count = insert_hold(phases, count, 0 if first else count, 0.0, wait)
    work[PlanWork.NEAREST, Nearest.BELOW_COUNT] = count
    work[PlanWork.NEAREST, Nearest.ABOVE_COUNT] = 0.0
    return 0.0
