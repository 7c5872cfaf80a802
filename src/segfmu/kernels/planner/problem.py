"""Checks of waypoints and limits before planning."""

from segfmu.kernels.planner.records import PlanStatus, Refusal, WaypointState


def check_problem(states: 'float[:,:,:]', limits: 'float[:,:]', report: 'float[:]') -> int:
    """PLANNED, or the error (PlanStatus), with a report (Refusal).

    m waypoints, k axes: states (m, k, WaypointState or more), limits (k, 2 or more) from velocity
    on, 0 where absent. Consecutive waypoints must differ within double precision.
    """
    status = check_limits(limits, report)
    if status == PlanStatus.PLANNED:
        status = check_numbers(states, limits, report)
    if status < 0:
        return status
    for j in range(1, states.shape[0]):
        different = 0
        for axis in range(states.shape[1]):
            for i in range(states.shape[2]):
                if differ(states[j - 1, axis, i], states[j, axis, i]):
                    different = different + 1
        if different == 0:
            report[Refusal.INTERVAL] = j - 1
            return PlanStatus.SAME_WAYPOINTS
    return PlanStatus.PLANNED


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


def check_numbers(states: 'float[:,:,:]', limits: 'float[:,:]', report: 'float[:]') -> int:
    """PlanStatus of a state that is not finite: it would keep every limit that it is tested for."""
    for j in range(states.shape[0]):
        report[Refusal.INTERVAL] = j
        for axis in range(states.shape[1]):
            report[Refusal.AXIS] = axis
            for i in range(WaypointState.SIZE):
                value = states[j, axis, i]
                # the largest double
                if abs(value) <= 1.7976931348623157e308:
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


def axis_scale(
    axis: int, states: 'float[:,:,:]', limits: 'float[:]'
) -> 'tuple[float, float]':
    """About the largest velocity [m/s] and acceleration [m/s2] of an axis, at most its limits.

    A limit that is meant as none can be far beyond what the waypoints and the other limits permit.
    Arrays as in `check_problem`, but for the limits of this axis alone.
    """
    distance = 0.0
    velocity = 0.0
    acceleration = 0.0
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
    value: float, order: int, axis: int, states: 'float[:,:,:]', limits: 'float[:,:]'
) -> float:
    """A velocity (order 0) or acceleration (1) of an axis; 0 or its limit where it nearly is that.

    Nearly is within 1e-9 of the limit and, next to 0, of `motion_scale`.
    """
    limit = limits[axis, order]
    if abs(value) <= 1e-9 * limit and abs(value) <= 1e-9 * motion_scale(order, states, limits):
        return 0.0
    if abs(abs(value) - limit) <= 1e-9 * limit:
        if value > 0.0:
            return limit
        return -limit
    return value


def settle_states(first: int, states: 'float[:,:,:]', limits: 'float[:,:]') -> int:
    """Round velocities and accelerations that nearly are 0, their limit, or those before.

    From the waypoint `first` on; those before only tell the scale of the motion. The ramp from such
    a state to the limit would last nanoseconds, and its jumps could not be told from rounding
    errors; that between two velocities which differ by rounding can last longer than the motion.
    Arrays as above. Returns the number of states that change.
    """
    changed = 0
    for j in range(first, states.shape[0]):
        for axis in range(states.shape[1]):
            for i in range(2):
                given = states[j, axis, WaypointState.VELOCITY + i]
                settled = given
                if given != 0.0:
                    settled = settle_value(given, i, axis, states, limits)
                if j > first:
                    before = states[j - 1, axis, WaypointState.VELOCITY + i]
                    if abs(settled - before) <= 1e-15 * abs(before):
                        settled = before
                if abs(settled - given) > 0.0:
                    states[j, axis, WaypointState.VELOCITY + i] = settled
                    changed = changed + 1
    return changed


def differ(before: float, value: float) -> bool:
    """Whether two numbers differ by more than rounding, relative to their size or to 1."""
    return not abs(value - before) <= 1e-15 * max(abs(value), 1.0)
