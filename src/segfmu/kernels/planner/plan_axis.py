"""The shortest profiles of one axis in all intervals, and how steep its rises are."""

from segfmu.kernels.planner.intervals import set_shortest
from segfmu.kernels.planner.parameters import ramp_parameters, steepest_share, usual_share
from segfmu.kernels.planner.records import (
    Axis,
    Cell,
    Interval,
    Passing,
    PlanStatus,
    PlanWork,
    Problem,
    Refusal,
)


def plan_with_share(
    axis: int, share: float, axes: 'float[:,:]', cells: 'float[:,:,:]', work: 'float[:,:]'
) -> int:
    """`plan_axis` with a given share of the rises (parameters.py)."""
    report = work[PlanWork.REFUSAL, :]
    report[Refusal.AXIS] = axis
    settled = 1.0
    if not ramp_parameters(share, axes[axis, :], work):
        return PlanStatus.UNBOUNDED_RAMP
    for j in range(axis, cells.shape[0], axes.shape[0]):
        report[Refusal.INTERVAL] = j // axes.shape[0]
        status, time = set_shortest(cells[j, :, :], axes[axis, :], work)
        if status < 0:
            report[Refusal.VALUE] = cells[j, Cell.PROBLEM, Problem.A]
            if status == PlanStatus.END_BRAKING:
                report[Refusal.VALUE] = cells[j, Cell.PROBLEM, Problem.B]
            report[Refusal.BOUND] = axes[axis, Axis.VELOCITY]
            return status
        settled = min(settled, work[PlanWork.PASSING, Passing.SETTLED])
        time = time + cells[j, Cell.RESULT, Interval.DELAY]
        cells[j, Cell.RESULT, Interval.SHORTEST] = time
        cells[j, Cell.RESULT, Interval.DURATION] = time
    work[PlanWork.PASSING, Passing.SETTLED] = settled
    return PlanStatus.PLANNED


def axis_duration(axis: int, axes: 'float[:,:]', cells: 'float[:,:,:]') -> float:
    """Sum of the shortest durations of an axis [s]."""
    total = 0.0
    for j in range(axis, cells.shape[0], axes.shape[0]):
        total = total + cells[j, Cell.RESULT, Interval.SHORTEST]
    return total


def plan_steeper(
    axis: int, axes: 'float[:,:]', cells: 'float[:,:,:]', work: 'float[:,:]'
) -> int:
    """Plan an axis again with steeper rises, if the usual ones cost more than smoothness does.

    The limits can leave no room for the usual rises: the profile then is another one, which can
    take much longer.
    """
    usual = axis_duration(axis, axes, cells)
    status = plan_with_share(axis, 0.2 * usual_share(), axes, cells, work)
    if status == PlanStatus.PLANNED and axis_duration(axis, axes, cells) < 0.94 * usual:
        return status
    return plan_with_share(axis, usual_share(), axes, cells, work)


def plan_axis(axis: int, axes: 'float[:,:]', cells: 'float[:,:,:]', work: 'float[:,:]') -> int:
    """Ramp parameters and shortest profiles of one axis; status as in `plan_phases`.

    The rises are the usual ones, or steeper where these fail.
    """
    status = plan_with_share(axis, usual_share(), axes, cells, work)
    if status == PlanStatus.START_BRAKING or status == PlanStatus.END_BRAKING:
        # braking fails by little: the steepest ramps decide whether it is feasible
        return plan_with_share(axis, steepest_share(), axes, cells, work)
    if status == PlanStatus.PLANNED and work[PlanWork.PASSING, Passing.SETTLED] < 0.5:
        return plan_steeper(axis, axes, cells, work)
    return status
