"""The shortest profile, and a wait at a waypoint.

A motion that begins or ends at rest and has to turn back stays nearest to its path if it goes on as
fast as it can: slower ramps turn farther away.
"""

from segfmu.kernels.planner.cruise import cruise_form
from segfmu.kernels.planner.phases import insert_hold, total_duration
from segfmu.kernels.planner.profile import shortest_profile
from segfmu.kernels.planner.records import Cell, Nearest, PlanWork, Problem


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
