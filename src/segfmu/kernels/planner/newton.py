"""The times of a sequence (sequence.py) that meet its conditions, by a damped Newton's method."""

from math import floor, sqrt

from segfmu.kernels.numerics.matrices import matrix_solve
from segfmu.kernels.numerics.numbers import BESIDE, CLOSE, EQUAL, FINE, ROUNDED
from segfmu.kernels.planner.parameters import ramps_suffice
from segfmu.kernels.planner.records import Equations, Node, Passing, PlanWork, Tighten
from segfmu.kernels.planner.sequence import first_row, follow_change, follow_node, run_sequence

# share of a time or pace by which it is changed for slopes: their errors and those of rounding are
# about alike
DIFFERENCE = 1e-5
# a step in times of the whole duration that only a singular matrix gives: slopes have five digits
SINGULAR = 1e4
# of a level's time, what a step takes off or adds at most; of the whole, so that it changes its
# sign; and of the pace
LESS = 0.7
MORE = 1.5
ACROSS = 0.01
SLOWER = 0.3
# steps until it has failed, and halvings of one
STEPS = 30
HALVINGS = 8
# what four steps leave of an error where they get anywhere
HOPEFUL = 0.7
# the grid of steps that are not near a solution
GRID = 1e-10
# what a step has to take off an error, as a share of its length
GAINED = 1e-4


def has_pace(passing: 'float[:]') -> bool:
    """Whether the pace of a sequence is an unknown."""
    return passing[Passing.TARGET] > 0.0 and passing[Passing.FREE] == 0.0


def residual_norm(count: int, residual: 'float[:]') -> float:
    """Root of the sum of squares."""
    total = 0.0
    for i in range(count):
        total = total + residual[Equations.VALUES + i] * residual[Equations.VALUES + i]
    return sqrt(total)


def difference_column(
    column: int, change: float, count: int, problem: 'float[:]', axis: 'float[:]',
    work: 'float[:,:]',
) -> None:
    """Write the derivatives of all residuals with an unknown, from a run with its `change`."""
    residual, nodes = work[PlanWork.RESIDUAL, :], work[PlanWork.NODES:PlanWork.KEPT, :]
    run_sequence(problem, work[PlanWork.PASSING, :], axis, nodes, residual)
    for i in range(count):
        slope = (residual[Equations.VALUES + i] + work[PlanWork.STEP + i, 0]) / change
        work[PlanWork.MATRIX + i, column] = slope


def time_column(
    column: int, count: int, problem: 'float[:]', axis: 'float[:]', work: 'float[:,:]'
) -> None:
    """Write the derivatives of all residuals with the time of a node.

    It changes the ramps to the node and from there; what follows is linear in the state after them.
    """
    passing, nodes = work[PlanWork.PASSING, :], work[PlanWork.NODES:PlanWork.KEPT, :]
    residual, slopes = work[PlanWork.RESIDUAL, :], work[PlanWork.SLOPES, :]
    before, moved = work[PlanWork.BEFORE:PlanWork.CHANGE, :], work[PlanWork.CHANGE, :]
    q = int(passing[Passing.ABOVE]) + 2
    following = column + 2
    base = work[PlanWork.BEFORE + 2, :]
    spent = 0.0
    for j in range(3):
        for i in range(Node.SIZE):
            before[j, i] = nodes[column + j, i]
    for j in range(2):
        spent = spent - nodes[column + j, Node.RAMP] - nodes[column + j, Node.HOLD]
    change = DIFFERENCE * (abs(nodes[column, Node.TIME]) + FINE * passing[Passing.TIME])
    nodes[column, Node.TIME] = nodes[column, Node.TIME] + change
    row = first_row(column, passing, nodes)
    begin = row
    row = follow_node(column, row, problem, passing, axis, nodes, residual)
    row = follow_node(column + 1, row, problem, passing, axis, nodes, residual)
    for i in range(count):
        slopes[Equations.VALUES + i] = 0.0
    for i in range(begin, row):
        slope = residual[Equations.VALUES + i] + work[PlanWork.STEP + i, 0]
        slopes[Equations.VALUES + i] = slope / change
    for j in range(2):
        spent = spent + nodes[column + j, Node.RAMP] + nodes[column + j, Node.HOLD]
    if passing[Passing.TARGET] > 0.0:
        slopes[Equations.VALUES + count - 1] = spent / (change * passing[Passing.TIME])
    if following <= int(passing[Passing.COUNT]):
        for k in range(q):
            difference = nodes[following, Node.STATE + k] - base[Node.STATE + k]
            moved[Node.STATE + k] = difference / change
        follow_change(following, row, passing, axis, nodes, moved, slopes)
    for j in range(3):
        for i in range(Node.SIZE):
            nodes[column + j, i] = before[j, i]
    for i in range(count):
        work[PlanWork.MATRIX + i, column] = slopes[Equations.VALUES + i]


def newton_step(count: int, problem: 'float[:]', axis: 'float[:]', work: 'float[:,:]') -> None:
    """Write the step of all unknowns to the rows STEP of `work`; derivatives are differences."""
    passing, nodes = work[PlanWork.PASSING, :], work[PlanWork.NODES:PlanWork.KEPT, :]
    residual = work[PlanWork.RESIDUAL, :]
    for i in range(count):
        work[PlanWork.STEP + i, 0] = -residual[Equations.VALUES + i]
    if has_pace(passing):
        passing[Passing.PACE] = passing[Passing.PACE] + DIFFERENCE
        difference_column(count - 1, DIFFERENCE, count, problem, axis, work)
        passing[Passing.PACE] = passing[Passing.PACE] - DIFFERENCE
        # the states are those of the present pace again
        run_sequence(problem, passing, axis, nodes, residual)
    for j in range(int(passing[Passing.COUNT])):
        if passing[Passing.INSTANTS] != 0.0 or passing[Passing.FREE] != 0.0:
            # a peak may be anywhere around the node: the whole sequence is run
            time = nodes[j, Node.TIME]
            change = DIFFERENCE * (abs(time) + FINE * passing[Passing.TIME])
            nodes[j, Node.TIME] = time + change
            difference_column(j, change, count, problem, axis, work)
            nodes[j, Node.TIME] = time
        else:
            time_column(j, count, problem, axis, work)
    for j in range(count):
        largest = 0.0
        for i in range(count):
            largest = max(largest, abs(work[PlanWork.MATRIX + i, j]))
        # far from singular to rounding errors; the step changes by as little, mirrored or not
        added = 1.0 if largest == 0.0 else EQUAL * largest
        diagonal = work[PlanWork.MATRIX + j, j]
        if diagonal < 0.0:
            added = -added
        work[PlanWork.MATRIX + j, j] = diagonal + added
    matrix = work[PlanWork.MATRIX:PlanWork.STEP, :]
    matrix_solve(count, 1, matrix, work[PlanWork.STEP:PlanWork.SLOPES, :])


def longest_step(work: 'float[:,:]') -> float:
    """The share of a step that keeps the signs of most levels and changes no unknown too much."""
    passing, nodes = work[PlanWork.PASSING, :], work[PlanWork.NODES:PlanWork.KEPT, :]
    share = 1.0
    count = int(passing[Passing.COUNT])
    for i in range(count):
        change = work[PlanWork.STEP + i, 0]
        time = nodes[i, Node.TIME]
        if not abs(change) < SINGULAR * passing[Passing.TIME]:
            return 0.0
        most = 0.5 * passing[Passing.TIME]
        if nodes[i, Node.KIND] == 0.0:
            most = MORE * abs(time) if change * time >= 0.0 else LESS * abs(time)
            # a small level can change its sign
            most = most + ACROSS * passing[Passing.TIME]
        if abs(change) * share > most:
            share = most / abs(change)
    if has_pace(passing):
        change = abs(work[PlanWork.STEP + count, 0])
        if change * share > SLOWER * passing[Passing.PACE]:
            share = SLOWER * passing[Passing.PACE] / change
    return share


def nearest_multiple(value: float, grid: float) -> float:
    """The nearest multiple of `grid`; the value itself if that is 0."""
    if grid == 0.0:
        return value
    if value < 0.0:
        return -grid * floor(0.5 - value / grid)
    return grid * floor(0.5 + value / grid)


def take_step(share: float, grid: float, work: 'float[:,:]') -> None:
    """Add a share of the step to all unknowns, in multiples of `grid`, in units of each."""
    count = int(work[PlanWork.PASSING, Passing.COUNT])
    time = work[PlanWork.PASSING, Passing.TIME]
    for i in range(count):
        row = PlanWork.NODES + i
        step = nearest_multiple(share * work[PlanWork.STEP + i, 0], grid * time)
        work[row, Node.TIME] = work[row, Node.TIME] + step
    if has_pace(work[PlanWork.PASSING, :]):
        step = nearest_multiple(share * work[PlanWork.STEP + count, 0], grid)
        work[PlanWork.PASSING, Passing.PACE] = work[PlanWork.PASSING, Passing.PACE] + step


def solve_sequence(problem: 'float[:]', axis: 'float[:]', work: 'float[:,:]') -> bool:
    """Change the times of the sequence in `work` (PlanWork) until it meets its conditions.

    If it has a TARGET, its pace is changed too, until it lasts that long.
    """
    passing, nodes = work[PlanWork.PASSING, :], work[PlanWork.NODES:PlanWork.KEPT, :]
    residual = work[PlanWork.RESIDUAL, :]
    count = int(passing[Passing.COUNT])
    if has_pace(passing):
        count = count + 1
    run_sequence(problem, passing, axis, nodes, residual)
    error = residual_norm(count, residual)
    quick = ramps_suffice(axis) or passing[Passing.QUICK] != 0.0
    earlier = error
    # all steps beyond CLOSE count as one: rounding decides how many they are
    spent = work[PlanWork.TIGHTEN, Tighten.STEPS] + 1.0
    for i in range(STEPS):
        # what is left are rounding errors
        if error <= ROUNDED:
            break
        # levels of the jerk are found soon, or hardly ever: two of 1,400 take longer
        if quick and i > 0 and i % 4 == 0:
            if error > HOPEFUL * earlier:
                break
            earlier = error
        newton_step(count, problem, axis, work)
        share = longest_step(work)
        # far from the root the method can be chaotic: rounding errors, which differ by processor,
        # must not decide where it goes
        grid = 0.0
        if error > CLOSE:
            grid = GRID
            spent = spent + 1.0
        reached = error
        for j in range(HALVINGS):
            # at the root only rounding errors are left
            if share == 0.0 or (j > 0 and error <= BESIDE):
                break
            take_step(share, grid, work)
            run_sequence(problem, passing, axis, nodes, residual)
            reached = residual_norm(count, residual)
            if reached < error * (1.0 - GAINED * share):
                break
            take_step(-share, grid, work)
            share = 0.5 * share
        if not reached < error * (1.0 - GAINED * share):
            # the states are those of a step that was taken back
            run_sequence(problem, passing, axis, nodes, residual)
            break
        error = reached
    work[PlanWork.TIGHTEN, Tighten.STEPS] = spent
    return error <= EQUAL
