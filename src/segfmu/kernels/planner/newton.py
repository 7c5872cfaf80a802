"""The times of a sequence (sequence.py) that meet its conditions, by a damped Newton's method."""

from math import sqrt

from segfmu.kernels.numerics.matrices import matrix_solve
from segfmu.kernels.planner.records import Equations, Node, Passing, PlanWork
from segfmu.kernels.planner.sequence import run_sequence


def residual_norm(count: int, residual: 'float[:]') -> float:
    """Root of the sum of squares."""
    total = 0.0
    for i in range(count):
        total = total + residual[Equations.VALUES + i] * residual[Equations.VALUES + i]
    return sqrt(total)


def perturbed_column(
    column: int, count: int, problem: 'float[:]', axis: 'float[:]', work: 'float[:,:]'
) -> None:
    """Write the derivatives of all residuals with one unknown: a node's time, or last the pace.

    A change of a time changes the sequence from its node on; the residuals are in the rows STEP.
    """
    passing = work[PlanWork.PASSING, :]
    nodes = work[PlanWork.NODES:PlanWork.KEPT, :]
    residual = work[PlanWork.RESIDUAL, :]
    for i in range(count):
        residual[Equations.VALUES + i] = -work[PlanWork.STEP + i, 0]
    if column == int(passing[Passing.COUNT]):
        kept = passing[Passing.PACE]
        change = 1e-7
        passing[Passing.PACE] = kept + change
        run_sequence(0, problem, passing, axis, nodes, residual)
        passing[Passing.PACE] = kept
    else:
        kept = nodes[column, Node.TIME]
        change = 1e-7 * (abs(kept) + 1e-3 * passing[Passing.TIME])
        nodes[column, Node.TIME] = kept + change
        run_sequence(column, problem, passing, axis, nodes, residual)
        nodes[column, Node.TIME] = kept
    largest = 0.0
    for i in range(count):
        slope = (residual[Equations.VALUES + i] + work[PlanWork.STEP + i, 0]) / change
        work[PlanWork.MATRIX + i, column] = slope
        largest = max(largest, abs(slope))
    # far from singular to rounding errors; the step changes by as little
    diagonal = work[PlanWork.MATRIX + column, column]
    work[PlanWork.MATRIX + column, column] = diagonal + 1e-12 * max(largest, 1e-300)


def newton_step(
    count: int, problem: 'float[:]', axis: 'float[:]', work: 'float[:,:]'
) -> None:
    """Write the step of all unknowns to the rows STEP of `work`; derivatives are differences."""
    passing = work[PlanWork.PASSING, :]
    nodes = work[PlanWork.NODES:PlanWork.KEPT, :]
    residual = work[PlanWork.RESIDUAL, :]
    for i in range(count):
        work[PlanWork.STEP + i, 0] = -residual[Equations.VALUES + i]
    if passing[Passing.TARGET] > 0.0:
        perturbed_column(count - 1, count, problem, axis, work)
        # the states before each node are those of the present pace again
        run_sequence(0, problem, passing, axis, nodes, residual)
    for j in range(int(passing[Passing.COUNT])):
        # from the last node on, so that the states before the others are those of the sequence
        perturbed_column(int(passing[Passing.COUNT]) - 1 - j, count, problem, axis, work)
    matrix = work[PlanWork.MATRIX:PlanWork.STEP, :]
    matrix_solve(count, 1, matrix, work[PlanWork.STEP:PlanWork.SIZE, :])


def longest_step(work: 'float[:,:]') -> float:
    """The share of a step that keeps the signs of most levels and changes no unknown too much."""
    passing = work[PlanWork.PASSING, :]
    nodes = work[PlanWork.NODES:PlanWork.KEPT, :]
    share = 1.0
    count = int(passing[Passing.COUNT])
    for i in range(count):
        change = work[PlanWork.STEP + i, 0]
        time = nodes[i, Node.TIME]
        if not abs(change) < 1e12 * passing[Passing.TIME]:
            return 0.0
        most = 0.5 * passing[Passing.TIME]
        if nodes[i, Node.KIND] < 0.5:
            most = 0.7 * abs(time)
            if change * time >= 0.0:
                most = 1.5 * abs(time)
            # a small level can change its sign
            most = most + 0.01 * passing[Passing.TIME]
        if abs(change) * share > most:
            share = most / abs(change)
    if passing[Passing.TARGET] > 0.0:
        change = abs(work[PlanWork.STEP + count, 0])
        if change * share > 0.3 * passing[Passing.PACE]:
            share = 0.3 * passing[Passing.PACE] / change
    return share


def take_step(share: float, work: 'float[:,:]') -> None:
    """Add a share of the step to all unknowns."""
    count = int(work[PlanWork.PASSING, Passing.COUNT])
    for i in range(count):
        row = PlanWork.NODES + i
        work[row, Node.TIME] = work[row, Node.TIME] + share * work[PlanWork.STEP + i, 0]
    if work[PlanWork.PASSING, Passing.TARGET] > 0.0:
        pace = work[PlanWork.PASSING, Passing.PACE] + share * work[PlanWork.STEP + count, 0]
        work[PlanWork.PASSING, Passing.PACE] = pace


def solve_sequence(problem: 'float[:]', axis: 'float[:]', work: 'float[:,:]') -> bool:
    """Change the times of the sequence in `work` (PlanWork) until it meets its conditions.

    If it has a TARGET, its pace is changed too, until it lasts that long.
    """
    passing = work[PlanWork.PASSING, :]
    nodes = work[PlanWork.NODES:PlanWork.KEPT, :]
    residual = work[PlanWork.RESIDUAL, :]
    count = int(passing[Passing.COUNT])
    if passing[Passing.TARGET] > 0.0:
        count = count + 1
    run_sequence(0, problem, passing, axis, nodes, residual)
    error = residual_norm(count, residual)
    for i in range(30):
        newton_step(count, problem, axis, work)
        share = longest_step(work)
        reached = error
        for j in range(8):
            # at the root only rounding errors are left
            if share == 0.0 or (j > 0 and error <= 1e-11):
                break
            take_step(share, work)
            run_sequence(0, problem, passing, axis, nodes, residual)
            reached = residual_norm(count, residual)
            if reached < error * (1.0 - 1e-4 * share):
                break
            take_step(-share, work)
            share = 0.5 * share
        if not reached < error * (1.0 - 1e-4 * share):
            # the states are those of a step that was taken back
            run_sequence(0, problem, passing, axis, nodes, residual)
            break
        error = reached
    return error <= 1e-12
