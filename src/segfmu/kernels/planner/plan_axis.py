"""The shortest profiles of one axis in all intervals, and how steep its rises are."""

from segfmu.kernels.planner.intervals import set_duration, set_shortest
from segfmu.kernels.planner.parameters import (
    moderate_share,
    ramp_parameters,
    ramps_suffice,
    snap_is_last,
    steepest_share,
    usual_share,
)
from segfmu.kernels.planner.phases import copy_phases, is_passing, total_duration
from segfmu.kernels.planner.records import (
    Axis,
    Cell,
    Family,
    Interval,
    Place,
    PlanStatus,
    PlanWork,
    Problem,
    Refusal,
)


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
    missed = 0.0
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
        missed = max(missed, work[PlanWork.FAMILY, Family.MISSED])
        note_shortest(time, axes[axis, :], cells[j, :, :])
        cells[j, Cell.RESULT, Interval.FREE] = work[PlanWork.FAMILY, Family.FREE]
        cells[j, Cell.RESULT, Interval.HELD] = 0.0
    work[PlanWork.FAMILY, Family.MISSED] = missed
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
        cell[Cell.RESULT, Interval.KEPT_FREE] = cell[Cell.RESULT, Interval.FREE]


def restore_shortest(axis: int, axes: 'float[:,:]', cells: 'float[:,:,:]') -> None:
    """Restore the profiles that are kept."""
    for j in range(axis, cells.shape[0], axes.shape[0]):
        cell = cells[j, :, :]
        phases = cell[Cell.BELOW:Cell.ABOVE, :]
        count = int(cell[Cell.RESULT, Interval.KEPT_COUNT])
        copy_phases(cell[Cell.ABOVE:Cell.PROBLEM, :], phases, count)
        cell[Cell.RESULT, Interval.BELOW_COUNT] = count
        note_shortest(total_duration(phases, count), axes[axis, :], cell)
        cell[Cell.RESULT, Interval.FREE] = cell[Cell.RESULT, Interval.KEPT_FREE]


def smoothness_share(usual: float, share: float, axis: 'float[:]') -> float:
    """Least duration with rises of `share` over that with `usual` ones, where both fit.

    A motion of the jerk alone lasts as the cube root of 1 - share, one of the snap as the square
    root, since ramps do not become shorter by more. Of whole plans it differs by half a per cent,
    which counts where they are held back (`hold_back`).
    """
    power = 0.5
    margin = 1e-3
    if ramps_suffice(axis):
        margin = 5e-3
    if axis[Axis.SHARES] > 0.0:
        power = 1.0 / 3.0
    return ((1.0 - usual) / (1.0 - share)) ** power * (1.0 - margin)


def shorter_with(
    share: float, kept: float, factor: float, axis: int, axes: 'float[:,:]',
    cells: 'float[:,:,:]', work: 'float[:,:]',
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
    missed: float, axis: int, axes: 'float[:,:]', cells: 'float[:,:,:]', work: 'float[:,:]'
) -> 'tuple[float, float]':
    """Plan an axis again with steeper rises, if the usual ones cost more than smoothness does.

    Returns the share of the rises, and what is missed with it.

    The limits can leave no room for the usual rises: the profile then is another one, which can
    take much longer. missed as in Family. Moderate rises are tried first where the snap is the
    highest limit: forces are held from sample to sample, and nothing else bounds their errors.
    """
    share = usual_share(axes[axis, :])
    if snap_is_last(axes[axis, :]):
        factor = smoothness_share(share, moderate_share(), axes[axis, :])
        if shorter_with(moderate_share(), share, factor, axis, axes, cells, work):
            share = moderate_share()
        missed = min(missed, work[PlanWork.FAMILY, Family.MISSED])
    if missed > 1.5:
        factor = smoothness_share(share, steepest_share(), axes[axis, :])
        if shorter_with(steepest_share(), share, factor, axis, axes, cells, work):
            return steepest_share(), work[PlanWork.FAMILY, Family.MISSED]
    return share, missed


def plan_thoroughly(
    share: float, axis: int, axes: 'float[:,:]', cells: 'float[:,:,:]', work: 'float[:,:]'
) -> None:
    """Plan an axis again with more starts of passing profiles, and more ways to meet limits.

    share: that of the rises of the present plan. It stays, so that all durations which that plan
    could last are feasible still (`slower_passing`).
    """
    axes[axis, Axis.THOROUGH] = 1.0
    if not shorter_with(share, share, 1.0 - 1e-9, axis, axes, cells, work):
        axes[axis, Axis.THOROUGH] = 0.0


def note_held(share: float, axis: int, axes: 'float[:,:]', cells: 'float[:,:,:]') -> None:
    """Write how long the plan of an axis would last within looser limits, which must not be longer.

    Steeper rises save more than smoothness costs only where the usual ones do not fit, as they may
    within looser limits. Passing profiles are looked for only where the merged form exceeds the
    velocity limit, and save some thousandths of its duration.
    """
    # beside limits above the snap each trial takes long
    if not ramps_suffice(axes[axis, :]):
        return
    usual = usual_share(axes[axis, :])
    factor = 1.0
    if share < usual:
        factor = smoothness_share(usual, share, axes[axis, :])
    for j in range(axis, cells.shape[0], axes.shape[0]):
        cell = cells[j, :, :]
        delay = cell[Cell.PLACE, Place.DELAY]
        least = cell[Cell.RESULT, Interval.SHORTEST] - delay
        free = cell[Cell.RESULT, Interval.FREE]
        if snap_is_last(axes[axis, :]) and free > least and free < 1.01 * least:
            least = free
        cell[Cell.RESULT, Interval.HELD] = delay + least / factor


def hold_back(
    meeting: bool, axes: 'float[:,:]', cells: 'float[:,:,:]', work: 'float[:,:]'
) -> None:
    """Let plans last as long as they would within looser limits (`note_held`), where they can.

    meeting: not where another axis takes as long in that interval.
    """
    for j in range(cells.shape[0]):
        cell = cells[j, :, :]
        row = j % axes.shape[0]
        held = cell[Cell.RESULT, Interval.HELD]
        shortest = cell[Cell.RESULT, Interval.SHORTEST]
        if meeting:
            for i in range(j - row, j - row + axes.shape[0]):
                shortest = max(shortest, cells[i, Cell.RESULT, Interval.SHORTEST])
        # the same up to rounding is not longer
        if held <= shortest * (1.0 + 1e-13):
            continue
        if set_duration(held, cell, axes[row, :], work):
            cell[Cell.RESULT, Interval.DURATION] = held
        else:
            set_duration(cell[Cell.RESULT, Interval.SHORTEST], cell, axes[row, :], work)


def plan_refused(
    axis: int, axes: 'float[:,:]', cells: 'float[:,:,:]', work: 'float[:,:]'
) -> 'tuple[int, float, float]':
    """Plan an axis for which braking with the usual rises fails.

    Where it fails by little, the steepest ramps decide whether it is feasible. Returns the status,
    as in `plan_phases`, the share of the rises, and what is missed with it.
    """
    share = moderate_share()
    status = plan_with_share(axis, share, axes, cells, work)
    missed = work[PlanWork.FAMILY, Family.MISSED]
    if status != PlanStatus.PLANNED:
        status = plan_with_share(axis, steepest_share(), axes, cells, work)
        return status, steepest_share(), work[PlanWork.FAMILY, Family.MISSED]
    factor = 1.0
    if ramps_suffice(axes[axis, :]):
        factor = smoothness_share(share, steepest_share(), axes[axis, :])
    if shorter_with(steepest_share(), share, factor, axis, axes, cells, work):
        return status, steepest_share(), work[PlanWork.FAMILY, Family.MISSED]
    return status, share, missed


def plan_axis(axis: int, axes: 'float[:,:]', cells: 'float[:,:,:]', work: 'float[:,:]') -> int:
    """Ramp parameters and shortest profiles of one axis; status as in `plan_phases`.

    The rises are the usual ones, or steeper where these fail.
    """
    usual = usual_share(axes[axis, :])
    share = usual
    status = plan_with_share(axis, usual, axes, cells, work)
    missed = work[PlanWork.FAMILY, Family.MISSED]
    if axes[axis, Axis.PLATEAU] < 0.5:
        return status
    if status == PlanStatus.START_BRAKING or status == PlanStatus.END_BRAKING:
        status, share, missed = plan_refused(axis, axes, cells, work)
    elif status == PlanStatus.PLANNED and missed > 0.5:
        share, missed = plan_steeper(missed, axis, axes, cells, work)
    if status == PlanStatus.PLANNED and missed > 2.5:
        plan_thoroughly(share, axis, axes, cells, work)
    if status == PlanStatus.PLANNED:
        note_held(share, axis, axes, cells)
    return status
