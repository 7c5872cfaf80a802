"""From a request without free states to its trajectory."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from segfmu.arrays import FloatArray
from segfmu.errors import InfeasibleError, SegfmuError
from segfmu.kernels import backend
from segfmu.kernels.planner.records import DelayedState, PlanStatus, Refusal, WaypointState
from segfmu.kernels.trajectory.records import Check
from segfmu.planning.brake import find_brakes
from segfmu.planning.lead import TO_PLAN, Leads, Pieces, find_leads
from segfmu.planning.limits import NAMES, UNITS
from segfmu.planning.messages import SCALE, refusal, told_apart
from segfmu.planning.motion import plan_motion
from segfmu.planning.problem import Phases, Problem, expand_phases, plan_phases
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
        status, report, timing, coefficients, offsets, times = plan_motion(request.problem)
        if report is None:
            found = _trajectory(request, timing, coefficients, offsets, times)
            return found, status == PlanStatus.PLANNED
        if not (brakes and status in STARTS and report[Refusal.INTERVAL] == 0.0):
            raise _refused(request, status, report)
    return solve_after(request, _leads(request, follow, brakes))


def solve_after(request: Request, leads: Leads) -> tuple[Trajectory, bool]:
    """`solve` behind given leads."""
    problem = request.problem
    points, axes = problem.states.shape[:2]
    delayed = np.zeros((points, axes, DelayedState.SIZE))
    delayed[:, :, : WaypointState.SIZE] = problem.states
    delayed[0] = leads.states
    problem = problem._replace(states=delayed)
    pieces, times = _expand(problem, _phases(request, problem))
    # those above the acceleration are zero behind the first waypoint
    full = np.zeros((points, axes, problem.options.smoothness + 1))
    full[1:, :, : WaypointState.SIZE] = delayed[1:, :, : WaypointState.SIZE]
    full[0] = request.start
    return judged(request, full, pieces.after(leads.pieces), times)


def _leads(request: Request, follow: Pieces | None, brakes: bool) -> Leads:
    problem = request.problem
    options = problem.options
    axes = problem.states.shape[1]
    apart = options.synchronize == "none" and not options.duration
    leads = find_leads(
        TO_PLAN, request.start, problem.states[1], problem.limits, problem.lower, options.shape,
        follow or Pieces.none(axes, options.smoothness),
        None if apart else options.duration or 0.0, brakes=brakes,
    )
    if leads.failed >= 0:
        # from rest the target may be refused for itself
        states = problem.states.copy()
        states[0, :, WaypointState.VELOCITY :] = 0.0
        _phases(request, problem._replace(states=states))
        raise no_lead(request, leads.failed)
    return leads


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


def _phases(request: Request, problem: Problem) -> Phases:
    phases = plan_phases(problem)
    if not phases.feasible:
        raise _refused(request, phases.status, phases.refusal)
    return phases


def _expand(problem: Problem, phases: Phases) -> tuple[Pieces, FloatArray]:
    """The pieces, and the arrivals (waypoints, axes) with the ends as their last row [s]."""
    timing, coefficients, offsets, times = expand_phases(problem, phases)
    return Pieces(timing, coefficients, offsets), times


def judged(
    request: Request, states: FloatArray, pieces: Pieces, times: FloatArray
) -> tuple[Trajectory, bool]:
    """The trajectory of some pieces, and whether the kernels prove that it keeps the tolerance.

    states (waypoints, axes, 3 or more) are those that it has to reach at the times.
    """
    limits, lower = request.problem.limits, request.problem.lower
    work = np.empty((Check.SIZE, Check.COLUMNS))
    found = states, times, pieces.timing, pieces.coefficients, pieces.offsets, limits, lower
    wrong = backend.check_plan(*found, TOLERANCE, 0.5 * TOLERANCE, work)
    if wrong > 0:
        brakes = find_brakes(np.ascontiguousarray(states[0]), limits, lower)
        if brakes.any():
            wrong = backend.check_braked_plan(*found, brakes, TOLERANCE, 0.5 * TOLERANCE, work)
    timing, coefficients = pieces.timing[: pieces.used], pieces.coefficients[: pieces.used]
    return _trajectory(request, timing, coefficients, pieces.offsets, times), wrong == 0


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
