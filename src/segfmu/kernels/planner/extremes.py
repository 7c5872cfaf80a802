"""The least and the largest distance of motions of prescribed duration, and their mean.

Both are sequences (sequence.py) whose levels alternate. All distances between them are possible.
"""

from segfmu.kernels.numerics.numbers import NEVER
from segfmu.kernels.planner.newton import solve_sequence
from segfmu.kernels.planner.passing import write_sequence
from segfmu.kernels.planner.plateaus import keep_sequence, set_alternating
from segfmu.kernels.planner.records import Axis, Cell, Nearest, Node, Passing, PlanWork, Problem
from segfmu.kernels.planner.sides import top_acceleration
from segfmu.kernels.planner.tighten import tighten

# levels of a start, as a share of those that alone fill the duration
ALTERNATING = 0.6


def set_extreme(sign: float, problem: 'float[:]', axis: 'float[:]', work: 'float[:,:]') -> None:
    """Set a sequence of alternating levels over any distance, which Newton's method starts from.

    sign: of the first level; 1 for the largest distance.
    """
    passing = work[PlanWork.PASSING, :]
    duration = problem[Problem.DURATION]
    for i in range(Passing.SIZE):
        passing[i] = 0.0
    passing[Passing.ABOVE] = axis[Axis.ABOVE]
    passing[Passing.PACE] = 1.0
    passing[Passing.TIME] = duration
    acceleration = top_acceleration(axis)
    acceleration = min(acceleration, acceleration * duration / axis[Axis.FULL_RAMP])
    passing[Passing.ACCELERATION] = acceleration
    passing[Passing.TARGET] = duration
    passing[Passing.FREE] = sign
    q = int(axis[Axis.ABOVE]) + 2
    set_alternating(sign, ALTERNATING * duration / q, work)


def extreme_form(
    sign: float, phases: 'float[:,:]', problem: 'float[:]', axis: 'float[:]', work: 'float[:,:]'
) -> 'tuple[int, float]':
    """Write the profile of the problem's duration over the largest (1) or least (-1) distance.

    Returns the number of phases, 0 if none is found, and the distance [m].
    """
    set_extreme(sign, problem, axis, work)
    if not solve_sequence(problem, axis, work):
        return 0, 0.0
    keep_sequence(PlanWork.SOLVED, work)
    if not tighten(NEVER, problem, axis, work):
        return 0, 0.0
    count = write_sequence(phases, problem, axis, work)
    end = PlanWork.NODES + int(work[PlanWork.PASSING, Passing.COUNT]) + 1
    return count, work[end, Node.STATE]


def timed_extremes(axis: 'float[:]', cell: 'float[:,:]', work: 'float[:,:]') -> bool:
    """Write what encloses the distance of the problem in `work` of motions of its duration.

    They go to the cell and to the row NEAREST of `work`. One that is not found has no phases, and
    ramps can take its place (Nearest.KNOWN). False if the distance is not possible, or neither is
    found.
    """
    problem, nearest = work[PlanWork.PROBLEM, :], work[PlanWork.NEAREST, :]
    distance = problem[Problem.DISTANCE]
    known = nearest[Nearest.KNOWN]
    for i in range(2):
        # first that for which there are no ramps
        sign = 2.0 * i - 1.0
        if known < 0.0:
            sign = -sign
        found = Nearest.BELOW_COUNT
        phases = cell[Cell.BELOW:Cell.ABOVE, :]
        if sign > 0.0:
            found = Nearest.ABOVE_COUNT
            phases = cell[Cell.ABOVE:Cell.PROBLEM, :]
        nearest[found] = 0.0
        count, reached = extreme_form(sign, phases, problem, axis, work)
        if count > 0 and sign * reached >= sign * distance:
            nearest[found] = count
            nearest[found + 1] = reached
        elif sign != known or (count > 0 and int(axis[Axis.ABOVE]) < 2):
            # levels of the snap can have several solutions
            return False
    return True
