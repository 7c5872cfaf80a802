"""Checks of waypoints and limits before planning."""

from segfmu.kernels.numerics.numbers import NEARLY, ROUNDED
from segfmu.kernels.planner.intervals import LONGEST_SAMPLE, SHORTEST_SAMPLE, round_up
from segfmu.kernels.planner.records import PlanStatus, Refusal, WaypointState


def check_problem(states: 'float[:,:,:]', limits: 'float[:,:]', report: 'float[:]') -> int:
    """PLANNED, or the error (PlanStatus), with a report (Refusal).

    m waypoints, k axes: states (m, k, WaypointState or more), limits (k, 2 or more) from velocity
    on, 0 where absent.
    """
    status = check_limits(limits, report)
    if status == PlanStatus.PLANNED:
        status = check_numbers(states, limits, report)
    return status


def check_limits(limits: 'float[:,:]', report: 'float[:]') -> int:
    """PlanStatus of a limit that is missing, and OUT_OF_RANGE of one that is none."""
    for axis in range(limits.shape[0]):
        report[Refusal.AXIS] = axis
        for order in range(limits.shape[1]):
            report[Refusal.VALUE] = limits[axis, order]
            if order < 2 and not limits[axis, order] > 0.0:
                return PlanStatus.NO_VELOCITY_LIMIT - order
            # a kernel would take it for absent
            if not limits[axis, order] >= 0.0:
                return PlanStatus.OUT_OF_RANGE
    return PlanStatus.PLANNED


def is_real(value: float) -> bool:
    """Whether a number is neither infinite nor not a number."""
    return value - value == 0.0


def check_numbers(states: 'float[:,:,:]', limits: 'float[:,:]', report: 'float[:]') -> int:
    """PlanStatus of a state that is not finite: it would keep every limit that it is tested for."""
    for j in range(states.shape[0]):
        report[Refusal.INTERVAL] = j
        for axis in range(states.shape[1]):
            report[Refusal.AXIS] = axis
            for i in range(WaypointState.SIZE):
                value = states[j, axis, i]
                if is_real(value):
                    continue
                report[Refusal.VALUE] = value
                if i == WaypointState.POSITION:
                    return PlanStatus.OUT_OF_RANGE
                report[Refusal.BOUND] = limits[axis, i - 1]
                return PlanStatus.WAYPOINT_VELOCITY + 1 - i
    return PlanStatus.PLANNED


def change_time(size: float, derivative: int, limits: 'float[:]') -> float:
    """About how long a change of a derivative of the position by `size` takes [s], at least."""
    longest = 0.0
    for i in range(derivative, limits.shape[0]):
        if limits[i] > 0.0:
            longest = max(longest, (size / limits[i]) ** (1.0 / (i - derivative + 1)))
    return longest


def axis_scale(axis: int, states: 'float[:,:,:]', limits: 'float[:]') -> 'tuple[float, float]':
    """About the largest velocity [m/s] and acceleration [m/s2] of an axis, at most its limits.

    A limit that is meant as none can be far beyond what the waypoints and the other limits permit.
    Arrays as in `check_problem`, but for the limits of this axis alone.
    """
    distance, velocity, acceleration = 0.0, 0.0, 0.0
    for j in range(states.shape[0]):
        if j > 0:
            position = states[j, axis, WaypointState.POSITION]
            before = states[j - 1, axis, WaypointState.POSITION]
            distance = max(distance, abs(position - before))
        # a free one is NaN
        value = abs(states[j, axis, WaypointState.VELOCITY])
        if value > velocity:
            velocity = value
        value = abs(states[j, axis, WaypointState.ACCELERATION])
        if value > acceleration:
            acceleration = value
    velocity = max(velocity, acceleration * change_time(acceleration, 2, limits))
    if distance > 0.0:
        velocity = max(velocity, distance / change_time(distance, 0, limits))
    velocity = min(velocity, limits[0])
    if velocity > 0.0:
        acceleration = max(acceleration, velocity / change_time(velocity, 1, limits))
    return velocity, min(acceleration, limits[1])


def motion_scale(order: int, states: 'float[:,:,:]', limits: 'float[:,:]') -> float:
    """About the largest velocity [m/s] (order 0) or acceleration [m/s2] (1) of all axes.

    Arrays as in `check_problem`; velocities and accelerations that are NaN do not count.
    """
    largest = 0.0
    for axis in range(states.shape[1]):
        velocity, acceleration = axis_scale(axis, states, limits[axis, :])
        if order == 1:
            velocity = acceleration
        largest = max(largest, velocity)
    return largest


def settle_value(
    value: float, order: int, axis: int, states: 'float[:,:,:]', limits: 'float[:,:]',
    lower: 'float[:,:]',
) -> float:
    """A velocity (order 0) or acceleration (1) of an axis; 0 or its limit where it nearly is that.

    Nearly is within 1e-9 of the limit and, next to 0, of `motion_scale`.
    """
    limit = lower[axis, order] if value < 0.0 and lower[axis, order] > 0.0 else limits[axis, order]
    if abs(value) <= NEARLY * limit and abs(value) <= NEARLY * motion_scale(order, states, limits):
        return 0.0
    if abs(abs(value) - limit) <= NEARLY * limit:
        return limit if value > 0.0 else -limit
    return value


def settle_states(
    first: int, states: 'float[:,:,:]', limits: 'float[:,:]', lower: 'float[:,:]'
) -> int:
    """Round velocities and accelerations that nearly are 0, their limit, or those before.

    From the waypoint `first` on; those before only tell the scale of the motion. The ramp from such
    a state to the limit would last nanoseconds, and its jumps could not be told from rounding
    errors; that between two velocities which differ by rounding can last longer than the motion.
    A waypoint that is the one before but for rounding becomes that one, which takes no time.
    Arrays as above, and lower (k, Lower). Returns the number of states that change.
    """
    changed = 0
    for j in range(first, states.shape[0]):
        for axis in range(states.shape[1]):
            for i in range(2):
                given = states[j, axis, WaypointState.VELOCITY + i]
                settled = given
                if given != 0.0:
                    settled = settle_value(given, i, axis, states, limits, lower)
                if j > first:
                    before = states[j - 1, axis, WaypointState.VELOCITY + i]
                    if abs(settled - before) <= ROUNDED * abs(before):
                        settled = before
                if abs(settled - given) > 0.0:
                    states[j, axis, WaypointState.VELOCITY + i] = settled
                    changed = changed + 1
        if j > first and is_same(states[j - 1, :, :], states[j, :, :]):
            for axis in range(states.shape[1]):
                before = states[j - 1, axis, WaypointState.POSITION]
                if abs(states[j, axis, WaypointState.POSITION] - before) > 0.0:
                    states[j, axis, WaypointState.POSITION] = before
                    changed = changed + 1
    return changed


def settle_dwells(sample_time: float, dwells: 'float[:]') -> int:
    """Round dwells up to multiples of a sample time [s], 0: any; returns how many change."""
    changed = 0
    # others are refused
    if SHORTEST_SAMPLE <= sample_time <= LONGEST_SAMPLE:
        for j in range(dwells.shape[0]):
            rounded = round_up(dwells[j], sample_time)
            if abs(rounded - dwells[j]) > 0.0:
                dwells[j] = rounded
                changed = changed + 1
    return changed


def is_same(before: 'float[:,:]', state: 'float[:,:]') -> bool:
    """Whether all that is known of two waypoints is the same but for rounding."""
    for axis in range(state.shape[0]):
        for i in range(state.shape[1]):
            if differ(before[axis, i], state[axis, i]):
                return False
    return True


def differ(before: float, value: float) -> bool:
    """Whether two numbers differ by more than rounding, relative to their size or to 1."""
    return not (is_real(value) and abs(value - before) <= ROUNDED * max(abs(value), 1.0))
