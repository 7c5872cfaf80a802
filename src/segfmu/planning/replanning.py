"""A new plan from any time of an old one to other waypoints.

The new plan begins in the full state of the old one, all continuous derivatives included. What is
left of the old plan is always a candidate, and is kept unless the new plan is shorter; so plans to
the same target end together, however often they are replanned.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from segfmu.arrays import as_tuple, finite_number, shown
from segfmu.errors import InfeasibleError, InputError
from segfmu.kernels import backend
from segfmu.kernels.planner.records import WaypointState
from segfmu.planning.free import choose_states
from segfmu.planning.limits import Limits
from segfmu.planning.pieces import Pieces
from segfmu.planning.planner import planned
from segfmu.planning.request import Request, checked_request
from segfmu.planning.solver import judged, solve_behind
from segfmu.planning.trajectory import Trajectory, require_plan
from segfmu.planning.verify import TIME_TOLERANCE, time_error, verify
from segfmu.planning.waypoint import Waypoint, waypoint_of

# a new plan to the same target has to be shorter than the rest of the old one by this much, more
# than steeper rises save: a motion that is replanned often would else become steeper and steeper
SHORTER = 0.95


def replan(
    trajectory: Trajectory | Waypoint,
    time: float,
    targets: Waypoint | Sequence[Waypoint],
    limits: Limits | None = None,
    *,
    smoothness: int = 4,
    synchronize: str | None = None,
    axis_names: Sequence[str] | None = None,
) -> Trajectory:
    """Plan from the state of a trajectory at a time, or from a measured one, to other waypoints.

    A state that cannot keep the limits, as with limits that are lowered while an axis moves, is
    brought inside them as soon as possible; `Trajectory.outside` tells how long that takes.

    A trajectory does not remember `sample_time`, `duration`, the range of positions and the
    clearance that it was planned with, nor `overshoot`. So durations are no multiples of a sample
    time, the range is not checked (`Trajectory.extrema` and `Clearance.require` do), and free
    states of targets are chosen with the default `overshoot`.

    Parameters
    ----------
    trajectory : Trajectory or Waypoint
        Trajectory to leave at a time, or the state to begin from, without free parts and dwell.
    time : float
        Time of the trajectory [s], which becomes time 0 of the new one; 0 with a state.
    targets : Waypoint or sequence of Waypoint
        Waypoints to pass.
    limits : Limits, optional
        Those of the trajectory by default; required with a state. With those of the trajectory
        there is always a plan, as the trajectory can be followed to its end first.
    synchronize : str, optional
        As for `plan`; that of the trajectory by default.
    smoothness, axis_names
        As for `plan`; those of the trajectory, if there is one.

    Returns
    -------
    Trajectory
        Its first waypoint is the state at the time. If the targets are the last waypoints of the
        trajectory, and its axes meet as `synchronize` asks, it ends no later. Of a last dwell that
        has begun it keeps what is left, and so does its last waypoint; another dwell begins anew.

    Raises
    ------
    InputError
        For invalid arguments.
    InfeasibleError
        If no plan keeps the limits.
    """
    points = (targets,) if isinstance(targets, Waypoint) else as_tuple("targets", targets)
    if not points:
        raise InputError("targets must have at least one waypoint")
    if isinstance(trajectory, Waypoint):
        request = checked_request(
            (trajectory, *points), state_limits(trajectory, time, limits), smoothness, "plateau",
            synchronize or "waypoints", None, None, axis_names,
        )
        return planned(choose_states(request), brakes=True)
    time, rest, start = left(trajectory, time)
    request = checked_request(
        (start, *points), trajectory.limits if limits is None else limits, trajectory.smoothness,
        trajectory.shape, trajectory.synchronize if synchronize is None else synchronize, None,
        None, trajectory.axis_names,
    )
    kept = _kept(trajectory, time, rest, points, request)
    try:
        found = _planned(request, rest)
    except (InfeasibleError, InputError):
        if kept is None:
            raise
        return kept
    if kept is not None and not found.duration < kept.duration * SHORTER:
        return kept
    return found


def state_limits(start: Waypoint, time: float, limits: Limits | None) -> Limits:
    """The limits of a plan from a state; InputError unless it can begin there at once."""
    if limits is None:
        raise InputError("start must be a trajectory, or a segfmu.Waypoint with limits")
    if start.free:
        raise InputError("start has a free velocity or acceleration; give numbers")
    if finite_number("time", time) != 0.0:
        raise InputError(
            f"time is {shown(time)}, but a state has no times; omit time or start from a trajectory"
        )
    if start.dwell > 0.0:
        raise InputError(
            f"start has a dwell of {start.dwell:.6g} s; the motion begins at once: omit the dwell"
        )
    return limits


def left(trajectory: Trajectory, time: float) -> tuple[float, Pieces, Waypoint]:
    """The time, checked, what is left of a trajectory, and its state there."""
    require_plan(trajectory)
    given = finite_number("time", time)
    if given < 0.0:
        raise InputError(f"time must be a time >= 0 s, got {shown(time)}")
    timing = np.zeros((len(trajectory.timing) + trajectory.offsets.size, 2))
    coefficients = np.zeros((len(timing), trajectory.coefficients.shape[1]))
    offsets = np.zeros(trajectory.offsets.size, dtype=np.int64)
    backend.cut_plan(
        given, trajectory.timing, trajectory.coefficients, trajectory.offsets, timing,
        coefficients, offsets,
    )
    rest = Pieces(timing, coefficients, offsets)
    return given, rest, waypoint_of(rest.starts())


def _same(old: Waypoint, targets: tuple[Waypoint, Waypoint]) -> bool:
    """Whether a waypoint is a target, as it was given or as the request has rounded it."""
    # as lists in half the time
    states = old.planned.tolist()
    equal = (states == target.planned.tolist() for target in targets)
    return old.dwell == targets[0].dwell and any(equal)


def _kept(
    trajectory: Trajectory, time: float, rest: Pieces, targets: Sequence[Waypoint],
    request: Request,
) -> Trajectory | None:
    """What is left of a trajectory, if it passes the targets of the request within its limits."""
    count = len(request.waypoints) - 1
    if count >= len(trajectory.waypoints):
        return None
    old = trajectory.waypoints[-count:]
    # states next to a target by rounding round it, in turn
    if not all(map(_same, old, zip(targets, request.waypoints[1:], strict=True))):
        return None
    arrivals = trajectory.axis_waypoint_times[-count:] - time
    if count > 1 and arrivals.min() < 0.0:
        return None
    dwell = request.waypoints[-1].dwell
    rest = rest.meeting(trajectory.duration, dwell)
    ends = rest.stops()
    if dwell > 0.0 and arrivals.min() < 0.0:
        # some axes are on the last waypoint already: they rest until the last one has done so, or,
        # while that moves, for a whole dwell, which ends before that of the last one
        dwell = float(min(dwell, ends.max()))
        rest = rest.resting(dwell)
        ends = rest.stops()
    arrivals[-1] = ends - dwell
    times = np.vstack([np.zeros(trajectory.axes), arrivals, ends])
    points, last = old[:-1], old[-1]
    target = Waypoint(last.position, last.velocity, last.acceleration, dwell=dwell)
    for pieces in (rest, rest.anchored(target.state(2), request.problem.limits)):
        first = waypoint_of(pieces.starts())
        request = request._replace(waypoints=(first, *points, target))
        states = np.stack([p.state(trajectory.smoothness) for p in request.waypoints])
        kept, proved = judged(request, states, pieces, times)
        # the kernels do not prove that axes meet, which the old plan need not have asked for
        if time_error(kept) <= TIME_TOLERANCE and (proved or verify(kept).passed):
            return kept
    return None


def _planned(request: Request, rest: Pieces) -> Trajectory:
    """The plan of a request; behind all that is left of the old plan if there is no other."""
    try:
        return planned(choose_states(request), rest, brakes=True)
    except InfeasibleError:
        states = rest.ends()
        # with rounding errors in its velocity an axis at rest would count as moving
        size = WaypointState.SIZE
        path = np.stack([rest.starts()[:, :size], states[:, :size], *request.problem.states[1:]])
        backend.settle_states(1, path, request.problem.limits, request.problem.lower)
        states[:, :size] = settled = path[1]
        # rounding errors of a whole motion may be large against what is left of it
        for pieces in (rest, rest.anchored(settled, request.problem.limits)):
            points = (waypoint_of(pieces.starts()), *request.waypoints[1:])
            chosen = choose_states(request._replace(waypoints=points))
            found, proved = solve_behind(chosen, pieces, states)
            if proved or verify(found).passed:
                return found
        raise
