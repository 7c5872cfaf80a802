"""Errors for refused plans."""

from __future__ import annotations

from segfmu.errors import InfeasibleError, InputError, SegfmuError
from segfmu.kernels.messages import PLAN
from segfmu.kernels.planner.records import PlanStatus, Refusal
from segfmu.planning.arrays import FloatArray

# attributes of `InfeasibleError` for a status: the limit, and which of these are set
AXIS, INTERVAL, WAYPOINT, VALUE, BOUND = "axis", "interval", "waypoint", "value", "bound"
DETAILS: dict[int, tuple[str | None, tuple[str, ...]]] = {
    PlanStatus.START_BRAKING: ("velocity", (AXIS, INTERVAL, BOUND)),
    PlanStatus.END_BRAKING: ("velocity", (AXIS, INTERVAL, BOUND)),
    PlanStatus.NO_PROFILE: (None, (AXIS, INTERVAL)),
    PlanStatus.NO_COMMON_DURATION: ("duration", (INTERVAL,)),
    PlanStatus.DURATION_TOO_SHORT: ("duration", (VALUE, BOUND)),
    PlanStatus.DURATION_IN_GAP: ("duration", (AXIS,)),
    PlanStatus.WAYPOINT_VELOCITY: ("velocity", (AXIS, WAYPOINT, VALUE, BOUND)),
    PlanStatus.WAYPOINT_ACCELERATION: ("acceleration", (AXIS, WAYPOINT, VALUE, BOUND)),
    PlanStatus.UNBOUNDED_RAMP: ("jerk", (AXIS,)),
    PlanStatus.MOVING_DWELL: ("dwell", (AXIS, WAYPOINT)),
}


def refusal(status: int, report: FloatArray, names: tuple[str, ...]) -> SegfmuError:
    """Return the error for a status and report (Refusal); `names` are those of the axes."""
    if status in (PlanStatus.SAMPLE_TIME, PlanStatus.SAME_WAYPOINTS):
        return InputError(PLAN.text(status, report.tolist()))
    limit, shown = DETAILS[status]
    place = int(report[Refusal.INTERVAL])
    # a waypoint belongs to the interval that ends there
    interval = place + 1 if INTERVAL in shown else max(place, 1) if WAYPOINT in shown else None
    return InfeasibleError(
        PLAN.text(status, report.tolist(), AXIS=names),
        axis=int(report[Refusal.AXIS]) if AXIS in shown else None,
        interval=interval,
        limit=limit,
        value=float(report[Refusal.VALUE]) if VALUE in shown else None,
        bound=float(report[Refusal.BOUND]) if BOUND in shown else None,
    )
