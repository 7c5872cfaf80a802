"""A whole plan: waypoints, limits and options -> the phases of every axis in every interval.

`plan_phases` is the entry point; it allocates nothing.
"""

from segfmu.kernels.numerics.numbers import EQUAL, HALVINGS, NEVER, SAME
from segfmu.kernels.planner.intervals import (
    LONGEST_SAMPLE,
    SHORTEST_SAMPLE,
    common_duration,
    set_duration,
)
from segfmu.kernels.planner.parameters import axis_limits
from segfmu.kernels.planner.plan_axis import plan_axis
from segfmu.kernels.planner.records import (
    Cell,
    DelayedState,
    Interval,
    Place,
    PlanOptions,
    PlanStatus,
    PlanWork,
    Problem,
    Refusal,
    Synchronization,
    WaypointState,
)
from segfmu.kernels.planner.sides import own_side, set_lower, side_limit


def check_waypoints(
    states: 'float[:,:,:]', dwells: 'float[:]', axes: 'float[:,:]', report: 'float[:]'
) -> int:
    """PlanStatus of a waypoint that breaks a limit or has a dwell while moving."""
    for j in range(states.shape[0]):
        for i in range(axes.shape[0]):
            velocity = states[j, i, WaypointState.VELOCITY]
            acceleration = states[j, i, WaypointState.ACCELERATION]
            report[Refusal.AXIS] = i
            report[Refusal.INTERVAL] = j
            report[Refusal.VALUE] = velocity
            report[Refusal.BOUND] = side_limit(1, velocity, axes[i, :])
            report[Refusal.SIDE] = own_side(1, velocity, axes[i, :])
            if abs(velocity) > report[Refusal.BOUND] * (1.0 + EQUAL):
                return PlanStatus.WAYPOINT_VELOCITY
            moving = velocity != 0.0 or acceleration != 0.0
            if dwells[j] > 0.0 and moving:
                return PlanStatus.MOVING_DWELL
            report[Refusal.VALUE] = acceleration
            report[Refusal.BOUND] = side_limit(2, acceleration, axes[i, :])
            report[Refusal.SIDE] = own_side(2, acceleration, axes[i, :])
            if abs(acceleration) > report[Refusal.BOUND] * (1.0 + EQUAL):
                return PlanStatus.WAYPOINT_ACCELERATION
    return PlanStatus.PLANNED


def time_left(
    first: int, step: int, target: float, cells: 'float[:,:,:]'
) -> 'tuple[float, float, int]':
    """Target duration [s] minus the intervals of one axis.

    Also returns the sum [s] and the number of the intervals that can be prolonged.
    """
    rest = target
    base, count = 0.0, 0
    for j in range(first, cells.shape[0], step):
        rest = rest - cells[j, Cell.RESULT, Interval.DURATION]
        if cells[j, Cell.PLACE, Place.PROLONGED] != 0.0:
            base = base + cells[j, Cell.RESULT, Interval.DURATION]
            count = count + 1
    return rest, base, count


def distribute(
    first: int, last: int, target: float, axes: 'float[:,:]', cells: 'float[:,:,:]',
    work: 'float[:,:]',
) -> bool:
    """Prolong the intervals of the axes first .. last - 1 to `target` [s] in total.

    All in proportion if their gaps permit, else as few as possible. False if neither succeeds.
    """
    step = axes.shape[0]
    for i in range(cells.shape[0]):
        cells[i, Cell.PLACE, Place.LEAST] = cells[i, Cell.RESULT, Interval.DURATION]
    if prolong_all(first, last, target, axes, cells, work):
        return True
    for quarters in range(4):
        for j in range(first, cells.shape[0], step):
            for i in range(cells.shape[0]):
                cells[i, Cell.RESULT, Interval.DURATION] = cells[i, Cell.PLACE, Place.LEAST]
            share = 1.0 - 0.25 * quarters
            if prolong_from(j, share, first, last, target, axes, cells, work):
                return True
    return False


def prolong_from(
    begin: int, share: float, first: int, last: int, target: float, axes: 'float[:,:]',
    cells: 'float[:,:,:]', work: 'float[:,:]',
) -> bool:
    """Prolong the interval of cell `begin` by a share of the time that is left, then the next ones.

    The others take as much as they can, one after the other. True if no time is left.
    """
    step = axes.shape[0]
    intervals = cells.shape[0] // step
    for k in range(intervals):
        rest, base, count = time_left(first, step, target, cells)
        j = first + (begin - first + k * step) % (intervals * step)
        present = cells[j, Cell.RESULT, Interval.DURATION]
        reached = common_duration(
            present + share * rest, NEVER, 0.0, j, j + last - first, axes, cells, work
        )
        if reached >= 0.0 and reached - present <= rest * (1.0 + SAME):
            for i in range(j, j + last - first):
                cells[i, Cell.RESULT, Interval.DURATION] = reached
        share = 1.0
    rest, base, count = time_left(first, step, target, cells)
    return rest <= SAME * target


def prolong_all(
    first: int, last: int, target: float, axes: 'float[:,:]', cells: 'float[:,:,:]',
    work: 'float[:,:]',
) -> bool:
    """Prolong the intervals of the axes first .. last - 1, in proportion, to `target` [s] in total.

    Intervals of zero duration share it equally. If the new duration of an interval lies in a gap,
    it goes to the end of the gap if time permits, else it keeps its duration. False if no interval
    can take the remaining time.
    """
    step = axes.shape[0]
    for j in range(first, cells.shape[0], step):
        cells[j, Cell.PLACE, Place.PROLONGED] = 1.0
    for sweep in range(HALVINGS):
        rest, base, count = time_left(first, step, target, cells)
        if rest <= SAME * target:
            return True
        if count == 0:
            return False
        factor = 1.0
        extra = rest / count
        if base > 0.0:
            factor = 1.0 + rest / base
            extra = 0.0
        for j in range(first, cells.shape[0], step):
            if cells[j, Cell.PLACE, Place.PROLONGED] != 0.0:
                present = cells[j, Cell.RESULT, Interval.DURATION]
                end = j + last - first
                reached = common_duration(
                    present * factor + extra, NEVER, 0.0, j, end, axes, cells, work
                )
                if reached < 0.0 or reached - present > rest * (1.0 + SAME):
                    cells[j, Cell.PLACE, Place.PROLONGED] = 0.0
                else:
                    rest = rest - (reached - present)
                    for i in range(j, end):
                        cells[i, Cell.RESULT, Interval.DURATION] = reached
    return False


def rewrite_intervals(
    first: int, last: int, axes: 'float[:,:]', cells: 'float[:,:,:]', work: 'float[:,:]'
) -> bool:
    """Write the profiles of the final durations; False if one is infeasible."""
    for j in range(0, cells.shape[0], axes.shape[0]):
        for i in range(first, last):
            duration = cells[j + i, Cell.RESULT, Interval.DURATION]
            if not set_duration(duration, cells[j + i, :, :], axes[i, :], work):
                return False
    return True


def set_problems(states: 'float[:,:,:]', cells: 'float[:,:,:]') -> None:
    """Write the boundary problems of all axes in all intervals."""
    axes = states.shape[1]
    for j in range(states.shape[0] - 1):
        for i in range(axes):
            cell = cells[j * axes + i, :, :]
            cell[Cell.PROBLEM, Problem.V] = states[j, i, WaypointState.VELOCITY]
            cell[Cell.PROBLEM, Problem.A] = states[j, i, WaypointState.ACCELERATION]
            cell[Cell.PROBLEM, Problem.W] = states[j + 1, i, WaypointState.VELOCITY]
            cell[Cell.PROBLEM, Problem.B] = states[j + 1, i, WaypointState.ACCELERATION]
            cell[Cell.PROBLEM, Problem.DISTANCE] = (
                states[j + 1, i, WaypointState.POSITION] - states[j, i, WaypointState.POSITION]
            )
            cell[Cell.PROBLEM, Problem.DURATION] = 0.0
            cell[Cell.PLACE, Place.DELAY] = 0.0
            if j == 0 and states.shape[2] > DelayedState.DELAY:
                cell[Cell.PLACE, Place.DELAY] = states[j, i, DelayedState.DELAY]


def plan_phases(
    states: 'float[:,:,:]', dwells: 'float[:]', limits: 'float[:,:]', lower: 'float[:,:]',
    options: 'float[:]', axes: 'float[:,:]', cells: 'float[:,:,:]', work: 'float[:,:]',
) -> int:
    """Plan all intervals. Returns PLANNED or the reason of a refusal (PlanStatus).

    m waypoints, k axes: states (m, k, WaypointState or DelayedState), dwells (m,) [s], limits
    (k, smoothness + 1) with 0 for absent, lower (k, Lower), options (PlanOptions,). Written: axes
    (k, Axis), and cells ((m - 1) k, Cell rows, Cell columns), all axes of the first interval, then
    of the next; after a refusal also the row REFUSAL of `work` (PlanWork rows, PlanWork columns).
    """
    report = work[PlanWork.REFUSAL, :]
    report[Refusal.VALUE] = options[PlanOptions.SAMPLE_TIME]
    # counts of samples must be whole numbers, and durations have digits behind a sample
    sample_time = report[Refusal.VALUE]
    if sample_time > 0.0 and not SHORTEST_SAMPLE <= sample_time <= LONGEST_SAMPLE:
        return PlanStatus.SAMPLE_TIME
    smoothness = int(options[PlanOptions.SMOOTHNESS])
    shape = int(options[PlanOptions.SHAPE])
    for axis in range(axes.shape[0]):
        axis_limits(smoothness, shape, limits[axis, :], axes[axis, :])
        set_lower(lower[axis, :], axes[axis, :])
    status = check_waypoints(states, dwells, axes, report)
    if status < 0:
        return status
    set_problems(states, cells)
    for axis in range(axes.shape[0]):
        status = plan_axis(axis, axes, cells, work)
        if status < 0:
            return status
    return synchronize_plan(dwells, options, axes, cells, work)


def meet_intervals(
    first: int, last: int, options: 'float[:]', axes: 'float[:,:]', cells: 'float[:,:,:]',
    work: 'float[:,:]',
) -> float:
    """Give the axes first .. last - 1 common durations in every interval, if requested.

    Returns the sum of all intervals' durations [s]; -1 if there is no common duration.
    """
    sample_time = options[PlanOptions.SAMPLE_TIME]
    meeting = int(options[PlanOptions.SYNCHRONIZATION]) == Synchronization.WAYPOINTS
    total = 0.0
    for j in range(first, cells.shape[0], axes.shape[0]):
        if meeting or sample_time > 0.0:
            end = j + last - first
            longest = 0.0
            for i in range(j, end):
                longest = max(longest, cells[i, Cell.RESULT, Interval.DURATION])
            time = common_duration(longest, NEVER, sample_time, j, end, axes, cells, work)
            work[PlanWork.REFUSAL, Refusal.AXIS] = first
            work[PlanWork.REFUSAL, Refusal.INTERVAL] = j // axes.shape[0]
            if time < 0.0:
                return -1.0
            for i in range(j, end):
                cells[i, Cell.RESULT, Interval.DURATION] = time
        total = total + cells[j, Cell.RESULT, Interval.DURATION]
    return total


def synchronize_plan(
    dwells: 'float[:]', options: 'float[:]', axes: 'float[:,:]', cells: 'float[:,:,:]',
    work: 'float[:,:]',
) -> int:
    """Give the shortest profiles common durations; status as in `plan_phases`."""
    report = work[PlanWork.REFUSAL, :]
    synchronization = int(options[PlanOptions.SYNCHRONIZATION])
    duration = options[PlanOptions.DURATION]
    group = axes.shape[0] if synchronization == Synchronization.WAYPOINTS else 1
    resting = 0.0
    for j in range(dwells.shape[0]):
        resting = resting + dwells[j]
    longest = 0.0
    for axis in range(0, axes.shape[0], group):
        total = meet_intervals(axis, axis + group, options, axes, cells, work)
        if total < 0.0:
            return PlanStatus.NO_COMMON_DURATION
        longest = max(longest, total)
    report[Refusal.VALUE] = longest + resting
    report[Refusal.BOUND] = duration
    target = longest
    if duration > 0.0:
        if duration < (longest + resting) * (1.0 - SAME):
            return PlanStatus.DURATION_TOO_SHORT
        # beside long dwells the difference has their rounding errors
        target = max(duration - resting, longest)
    if synchronization != Synchronization.TOTAL and duration <= 0.0:
        return PlanStatus.PLANNED
    report[Refusal.VALUE] = target + resting
    for axis in range(0, axes.shape[0], group):
        report[Refusal.AXIS] = axis
        if not distribute(axis, axis + group, target, axes, cells, work):
            return PlanStatus.DURATION_IN_GAP
        if not rewrite_intervals(axis, axis + group, axes, cells, work):
            return PlanStatus.DURATION_IN_GAP
    return PlanStatus.PLANNED
