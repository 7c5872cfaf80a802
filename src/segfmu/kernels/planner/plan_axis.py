"""The shortest profiles of one axis in all intervals, and how steep its rises are."""

from math import sqrt

from segfmu.kernels.numerics.numbers import TIE, WORTH
from segfmu.kernels.planner.intervals import set_shortest
from segfmu.kernels.planner.parameters import (
    moderate_share,
    ramp_parameters,
    snap_is_last,
    steepest_share,
    usual_share,
)
from segfmu.kernels.planner.phases import copy_phases, is_passing, total_duration
from segfmu.kernels.planner.records import (
    Axis,
    Cell,
    Effort,
    Family,
    Interval,
    Place,
    PlanStatus,
    PlanWork,
    Problem,
    Refusal,
    Rises,
)
from segfmu.kernels.planner.sides import own_side, side_limit


def note_shortest(time: float, axis: 'float[:]', cell: 'float[:,:]') -> None:
    """Write that the shortest profile of a cell, which it has, takes `time` [s] after its delay."""
    time = time + cell[Cell.PLACE, Place.DELAY]
    cell[Cell.RESULT, Interval.SHORTEST] = time
    cell[Cell.RESULT, Interval.DURATION] = time
    count = int(cell[Cell.RESULT, Interval.BELOW_COUNT])
    passing = is_passing(cell[Cell.BELOW:Cell.ABOVE, :], count, axis)
    cell[Cell.RESULT, Interval.PASSING] = passing


def plan_with_share(
    axis: int, share: float, axes: 'float[:,:]', cells: 'float[:,:,:]', work: 'float[:,:]'
) -> int:
    """`plan_axis` with a given share of the rises (parameters.py)."""
    report = work[PlanWork.REFUSAL, :]
    report[Refusal.AXIS] = axis
    missed = int(Rises.USUAL)
    slow = 0.0
    if not ramp_parameters(share, axes[axis, :], work):
        return PlanStatus.UNBOUNDED_RAMP
    for j in range(axis, cells.shape[0], axes.shape[0]):
        report[Refusal.INTERVAL] = j // axes.shape[0]
        status, time = set_shortest(cells[j, :, :], axes[axis, :], work)
        if status < 0:
            report[Refusal.VALUE] = cells[j, Cell.PROBLEM, Problem.A]
            sign = report[Refusal.VALUE]
            if status == PlanStatus.END_BRAKING:
                report[Refusal.VALUE] = cells[j, Cell.PROBLEM, Problem.B]
                sign = -report[Refusal.VALUE]
            report[Refusal.BOUND] = side_limit(1, sign, axes[axis, :])
            report[Refusal.SIDE] = own_side(1, sign, axes[axis, :])
            return status
        missed = max(missed, int(work[PlanWork.FAMILY, Family.MISSED]))
        slow = max(slow, work[PlanWork.FAMILY, Family.SLOW])
        note_shortest(time, axes[axis, :], cells[j, :, :])
    work[PlanWork.FAMILY, Family.MISSED] = missed
    work[PlanWork.FAMILY, Family.SLOW] = slow
    return PlanStatus.PLANNED


def axis_duration(axis: int, axes: 'float[:,:]', cells: 'float[:,:,:]') -> float:
    """Sum of the shortest durations of an axis [s]."""
    total = 0.0
    for j in range(axis, cells.shape[0], axes.shape[0]):
        total = total + cells[j, Cell.RESULT, Interval.SHORTEST]
    return total


def keep_shortest(axis: int, axes: 'float[:,:]', cells: 'float[:,:,:]') -> None:
    """Keep the shortest profiles of an axis."""
    for j in range(axis, cells.shape[0], axes.shape[0]):
        cell = cells[j, :, :]
        count = int(cell[Cell.RESULT, Interval.BELOW_COUNT])
        copy_phases(cell[Cell.BELOW:Cell.ABOVE, :], cell[Cell.ABOVE:Cell.PROBLEM, :], count)
        cell[Cell.RESULT, Interval.KEPT_COUNT] = count


def restore_shortest(axis: int, axes: 'float[:,:]', cells: 'float[:,:,:]') -> None:
    """Restore the profiles that are kept."""
    for j in range(axis, cells.shape[0], axes.shape[0]):
        cell = cells[j, :, :]
        phases = cell[Cell.BELOW:Cell.ABOVE, :]
        count = int(cell[Cell.RESULT, Interval.KEPT_COUNT])
        copy_phases(cell[Cell.ABOVE:Cell.PROBLEM, :], phases, count)
        cell[Cell.RESULT, Interval.BELOW_COUNT] = count
        note_shortest(total_duration(phases, count), axes[axis, :], cell)


def smoothness_share(usual: float, share: float) -> float:
    """Least duration with rises of `share` over that with `usual` ones, where both fit.

    A motion of the snap lasts as the square root of 1 - share, and so does a change of the velocity
    with the jerk alone.
    """
    return sqrt((1.0 - usual) / (1.0 - share)) / TIE


def shorter_with(
    share: float, kept: float, factor: float, axis: int, axes: 'float[:,:]', cells: 'float[:,:,:]',
    work: 'float[:,:]',
) -> bool:
    """Plan an axis again with another share of the rises; the plan stays if it is shorter.

    It has to last less than `factor` of the present one, whose rises have the share `kept`.
    """
    longest = factor * axis_duration(axis, axes, cells)
    keep_shortest(axis, axes, cells)
    status = plan_with_share(axis, share, axes, cells, work)
    if status == PlanStatus.PLANNED and axis_duration(axis, axes, cells) < longest:
        return True
    ramp_parameters(kept, axes[axis, :], work)
    restore_shortest(axis, axes, cells)
    return False


def plan_steeper(
    missed: int, axis: int, axes: 'float[:,:]', cells: 'float[:,:,:]', work: 'float[:,:]'
) -> float:
    """Plan an axis again with steeper rises, if the usual ones cost more than smoothness does.

    missed: the rises (Rises) that may leave room for a shorter profile. The limits can leave none
    for the usual ones: the profile then is another one, which can take much longer. Moderate rises
    are tried first where the snap is the highest limit: forces are held from sample to sample, and
    nothing else bounds their errors. Returns the share of the rises that the plan has.
    """
    share = usual_share(axes[axis, :])
    if snap_is_last(axes[axis, :]):
        factor = smoothness_share(share, moderate_share())
        if shorter_with(moderate_share(), share, factor, axis, axes, cells, work):
            share = moderate_share()
        missed = min(missed, int(work[PlanWork.FAMILY, Family.MISSED]))
    if missed == Rises.STEEPEST:
        factor = smoothness_share(share, steepest_share())
        if shorter_with(steepest_share(), share, factor, axis, axes, cells, work):
            share = steepest_share()
    return share


def plan_thoroughly(
    share: float, axis: int, axes: 'float[:,:]', cells: 'float[:,:,:]', work: 'float[:,:]'
) -> None:
    """Plan an axis again with more starts of passing profiles, and more ways to meet limits.

    share: that of the rises of the present plan. It stays, so that all durations which that plan
    could last are feasible still (`slower_passing`).
    """
    axes[axis, Axis.EFFORT] = Effort.THOROUGH
    if not shorter_with(share, share, 1.0 - WORTH, axis, axes, cells, work):
        axes[axis, Axis.EFFORT] = Effort.USUAL


def plan_refused(
    axis: int, axes: 'float[:,:]', cells: 'float[:,:,:]', work: 'float[:,:]'
) -> 'tuple[int, float]':
    """Plan an axis for which braking with the usual rises fails.

    Where it fails by little, the steepest ramps decide whether it is feasible. Returns the status,
    as in `plan_phases`, and the share of the rises.
    """
    share = moderate_share()
    status = plan_with_share(axis, share, axes, cells, work)
    if status != PlanStatus.PLANNED:
        return plan_with_share(axis, steepest_share(), axes, cells, work), steepest_share()
    factor = smoothness_share(share, steepest_share())
    if shorter_with(steepest_share(), share, factor, axis, axes, cells, work):
        share = steepest_share()
    return status, share


def plan_axis(axis: int, axes: 'float[:,:]', cells: 'float[:,:,:]', work: 'float[:,:]') -> int:
    """Ramp parameters and shortest profiles of one axis; status as in `plan_phases`.

    The rises are the usual ones, or steeper where these fail.
    """
    share = usual_share(axes[axis, :])
    status = plan_with_share(axis, share, axes, cells, work)
    missed = int(work[PlanWork.FAMILY, Family.MISSED])
    if axes[axis, Axis.PLATEAU] == 0.0:
        return status
    if status == PlanStatus.START_BRAKING or status == PlanStatus.END_BRAKING:
        status, share = plan_refused(axis, axes, cells, work)
    elif status == PlanStatus.PLANNED and missed > Rises.USUAL:
        share = plan_steeper(missed, axis, axes, cells, work)
    if status == PlanStatus.PLANNED and work[PlanWork.FAMILY, Family.SLOW] != 0.0:
        plan_thoroughly(share, axis, axes, cells, work)
    return status
