"""Status codes of the planning kernels -> errors that say what, where and what to do."""

from __future__ import annotations

from segfmu.errors import InfeasibleError
from segfmu.kernels.planner.records import PlanStatus, Refusal
from segfmu.planning.arrays import FloatArray
from segfmu.planning.waypoint import Waypoint


def infeasible(
    status: int,
    report: FloatArray,
    points: tuple[Waypoint, ...],
    table: FloatArray,
    names: tuple[str, ...],
) -> InfeasibleError:
    """Return the error that belongs to a status (PlanStatus) and its report (Refusal)."""
    axis, interval = int(report[Refusal.AXIS]), int(report[Refusal.INTERVAL])
    value, bound = float(report[Refusal.VALUE]), float(report[Refusal.BOUND])
    velocity = float(table[axis, 0])
    where = f"axis {names[axis]}, waypoints {interval + 1} -> {interval + 2}"
    if status in (PlanStatus.START_BRAKING, PlanStatus.END_BRAKING):
        first = status == PlanStatus.START_BRAKING
        point = interval if first else interval + 1
        doing = "braking the first" if first else "building up the last"
        return InfeasibleError(
            f"{where}: {doing} acceleration {points[point].acceleration[axis]:.6g} m/s2 passes the "
            f"velocity limit {velocity:.6g} m/s; lower the velocity or the acceleration of "
            f"waypoint {point + 1} or raise limits.velocity",
            axis=axis, interval=interval + 1, limit="velocity", bound=velocity,
        )
    if status == PlanStatus.NO_COMMON_DURATION:
        return InfeasibleError(
            f"waypoints {interval + 1} -> {interval + 2}: no common duration of the axes found; "
            f"change the velocities of waypoint {interval + 2} or use synchronize='none'",
            interval=interval + 1, limit="duration",
        )
    if status == PlanStatus.DURATION_TOO_SHORT:
        return InfeasibleError(
            f"duration {bound:.9g} s is shorter than the shortest plan, {value:.9g} s; "
            "raise duration or the limits",
            limit="duration", value=value, bound=bound,
        )
    if status == PlanStatus.DURATION_IN_GAP:
        return InfeasibleError(
            f"axis {names[axis]}: between its moving waypoints it cannot be prolonged to exactly "
            f"{value:.9g} s; change the duration, let waypoints rest, or use "
            "synchronize='waypoints'",
            axis=axis, limit="duration",
        )
    if status in (PlanStatus.WAYPOINT_VELOCITY, PlanStatus.WAYPOINT_ACCELERATION):
        name, unit = "acceleration", "m/s2"
        if status == PlanStatus.WAYPOINT_VELOCITY:
            name, unit = "velocity", "m/s"
        return InfeasibleError(
            f"axis {names[axis]}, waypoint {interval + 1}: {name} {value:.6g} {unit} exceeds the "
            f"limit {bound:.6g} {unit}; raise limits.{name} or lower the waypoint's {name}",
            axis=axis, interval=max(interval, 1), limit=name, value=value, bound=bound,
        )
    if status == PlanStatus.UNBOUNDED_RAMP:
        return InfeasibleError(
            f"axis {names[axis]}: no limit bounds the duration of an acceleration ramp; "
            "give limits.jerk or a higher one",
            axis=axis, limit="jerk",
        )
    if status == PlanStatus.MOVING_DWELL:
        return InfeasibleError(
            f"axis {names[axis]}, waypoint {interval + 1}: a dwell needs a waypoint at rest; "
            "leave out its velocity and acceleration, or the dwell",
            axis=axis, interval=max(interval, 1), limit="dwell",
        )
    return InfeasibleError(
        f"{where}: no profile within the limits was found; raise the limits or change the "
        "velocities of the two waypoints",
        axis=axis, interval=interval + 1,
    )
