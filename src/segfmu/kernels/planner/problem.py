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


def settle_value(value: float, limit: float) -> float:
    """A velocity or acceleration; 0 or its limit where it is within 1e-9 of the limit from it."""
    near = 1e-9 * limit
    if abs(value) <= near:
        return 0.0
    if abs(abs(value) - limit) <= near:
        if value > 0.0:
            return limit
        return -limit
    return value


def settle_states(states: 'float[:,:,:]', limits: 'float[:,:]') -> int:
    """Round velocities and accelerations that nearly are 0, their limit, or those before.

    The ramp from such a state to the limit would last nanoseconds, and its jumps could not be told
    from rounding errors; that between two velocities which differ by rounding can last longer than
    the motion. Arrays as above. Returns the number of states that change.
    """
    changed = 0
    for j in range(states.shape[0]):
        for axis in range(states.shape[1]):
            for i in range(2):
                given = states[j, axis, WaypointState.VELOCITY + i]
                settled = settle_value(given, limits[axis, i])
                if j > 0:
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
