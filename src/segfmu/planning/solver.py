"""From a request without free states to its trajectory."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from segfmu.arrays import FloatArray
from segfmu.errors import InfeasibleError, SegfmuError
from segfmu.kernels.planner.records import PlanStatus, Refusal, WaypointState
from segfmu.planning.limits import NAMES, UNITS
from segfmu.planning.messages import SCALE, refusal, told_apart
from segfmu.planning.motion import Motion, plan_motion
from segfmu.planning.onward import judge_pieces, plan_behind, plan_onward
from segfmu.planning.pieces import Pieces
from segfmu.planning.request import Request
from segfmu.planning.trajectory import Trajectory
from segfmu.planning.verify import TOLERANCE

# refusals of a first state
STARTS = (
    PlanStatus.START_BRAKING, PlanStatus.WAYPOINT_VELOCITY, PlanStatus.WAYPOINT_ACCELERATION,
    PlanStatus.NO_PROFILE,
)
# s, from which on the rounding of a plan's times is longer than any motion
LONGEST = 1e100


def solve(
    request: Request, follow: Pieces | None = None, *, brakes: bool = False
) -> tuple[Trajectory, bool]:
    """Plan and expand a trajectory; True if the kernels prove that it keeps the tolerance.

    follow: a plan that begins in the state of the first waypoint, and that leads may follow.
    brakes: a first state that cannot keep the limits is brought inside; else it is refused.

    Raises
    ------
    InfeasibleError
        If no plan keeps the limits.
    """
    if request.waypoints[0].settled:
        motion = plan_motion(request.problem)
        report = motion.refusal
        if report is None or not brakes or motion.status not in STARTS or report[Refusal.INTERVAL]:
            return _finished(request, motion)
    problem = request.problem
    if follow is None:
        follow = Pieces.none(problem.states.shape[1], problem.options.smoothness)
    motion, failed = plan_onward(problem, request.start, follow, brakes=brakes)
    if failed >= 0:
        # from rest the target may be refused for itself
        states = problem.states.copy()
        states[0, :, WaypointState.VELOCITY :] = 0.0
        status, report, *_ = plan_motion(problem._replace(states=states))
        if report is not None:
            raise _refused(request, status, report)
        raise no_lead(request, failed)
    return _finished(request, motion)


def solve_behind(request: Request, leads: Pieces, ends: FloatArray) -> tuple[Trajectory, bool]:
    """`solve` behind given leads, which end in states (axes, DelayedState)."""
    return _finished(request, plan_behind(request.problem, request.start, leads, ends))


def _finished(request: Request, motion: Motion) -> tuple[Trajectory, bool]:
    status, report, timing, coefficients, offsets, times = motion
    if report is not None:
        raise _refused(request, status, report)
    found = _trajectory(request, timing, coefficients, offsets, times)
    return found, status == PlanStatus.PLANNED


def no_lead(request: Request, axis: int) -> InfeasibleError:
    """The error for an axis that cannot settle within its limits; what its state exceeds, if so."""
    start, where = request.waypoints[0], f"axis {request.axis_names[axis]}, waypoint 1: "
    for name, unit in zip(NAMES, UNITS, strict=True):
        given = float(getattr(start, name)[axis])
        value, bound = abs(given), request.limits.bound(name, axis, given)
        limit = request.limits.named(name, axis, given)
        # not by rounding alone, as states of other plans can have it
        if bound * (1.0 + TOLERANCE) < value:
            digits = told_apart(value, bound, 6)
            return InfeasibleError(
                f"{where}{name} {value:.{digits}g} {unit} exceeds the limit {bound:.{digits}g} "
                f"{unit}; raise limits.{limit}, or begin where it is lower",
                axis=axis, interval=1, limit=limit, value=value, bound=bound,
            )
    return InfeasibleError(
        f"{where}no motion from its velocity, acceleration and higher derivatives keeps the "
        "limits; raise the limits or lower the derivatives",
        axis=axis, interval=1,
    )


def _refused(request: Request, status: int, report: FloatArray) -> SegfmuError:
    """The error for a refused plan; times beyond all scales are told as such.

    The planner takes them for none, and finds nothing that axes have in common.
    """
    if status == PlanStatus.NO_COMMON_DURATION:
        first = int(report[Refusal.INTERVAL])
        ways = request.waypoints[first + 1].position - request.waypoints[first].position
        for axis, way in enumerate(ways.tolist()):
            limit = request.limits.bound("velocity", axis, way)
            time = abs(way) / limit
            if time >= LONGEST:
                return InfeasibleError(
                    f"axis {request.axis_names[axis]}, waypoints {first + 1} -> {first + 2}: "
                    f"{abs(way):.6g} m take {time:.6g} s with limits.velocity {limit:.6g} m/s: "
                    f"{SCALE}",
                    axis=axis, interval=first + 1,
                )
    return refusal(status, report, request.axis_names)


def judged(
    request: Request, states: FloatArray, pieces: Pieces, times: FloatArray
) -> tuple[Trajectory, bool]:
    """The trajectory of some pieces, and whether the kernels prove that it keeps the tolerance.

    states (waypoints, axes, 3 or more) are those that it has to reach at the times.
    """
    proved = judge_pieces(request.problem, states, pieces, times)
    timing, coefficients = pieces.timing[: pieces.used], pieces.coefficients[: pieces.used]
    return _trajectory(request, timing, coefficients, pieces.offsets, times), proved


def _trajectory(
    request: Request, timing: FloatArray, coefficients: FloatArray,
    offsets: NDArray[np.int64], times: FloatArray,
) -> Trajectory:
    options = request.problem.options
    for array in (timing, coefficients, offsets, times):
        array.setflags(write=False)
    return Trajectory(
        request.waypoints, request.limits, options.smoothness, options.shape, options.synchronize,
        request.axis_names, timing, coefficients, offsets, times[:-1], times[-1],
    )
