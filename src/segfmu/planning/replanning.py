"""A new plan from any time of an old one: to other waypoints, to a velocity, or to rest.

The new plan begins in the full state of the old one, all continuous derivatives included. What is
left of the old plan is always a candidate, and is kept unless the new plan is shorter; so plans to
the same target end together, however often they are replanned.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from segfmu.errors import InfeasibleError, InputError
from segfmu.kernels import backend
from segfmu.kernels.planner.records import DelayedState, WaypointState
from segfmu.planning.arrays import FloatArray, finite_vector
from segfmu.planning.free import choose_states
from segfmu.planning.lead import TO_VELOCITY, Leads, Pieces, find_leads, following
from segfmu.planning.limits import Limits
from segfmu.planning.planner import planned
from segfmu.planning.request import Request, checked_request
from segfmu.planning.solver import judged, no_lead, solve_after
from segfmu.planning.trajectory import Trajectory
from segfmu.planning.verify import TOLERANCE, require, verify
from segfmu.planning.waypoint import Waypoint

# a new plan to the same target has to be shorter than the rest of the old one by this much: a
# motion that is replanned often would else become steeper and steeper
SHORTER = 0.99


def replan(
    trajectory: Trajectory,
    time: float,
    targets: Waypoint | Sequence[Waypoint],
    limits: Limits | None = None,
    *,
    synchronize: str | None = None,
) -> Trajectory:
    """Plan from the state of a trajectory at a time to other waypoints.

    Parameters
    ----------
    trajectory : Trajectory
    time : float
        Time of the trajectory [s], which becomes time 0 of the new one.
    targets : Waypoint or sequence of Waypoint
        Waypoints to pass.
    limits : Limits, optional
        Those of the trajectory by default. With them there is always a plan, as the trajectory can
        be followed to its end first.
    synchronize : str, optional
        As for `plan`; that of the trajectory by default.

    Returns
    -------
    Trajectory
        Its first waypoint is the state at the time. If the targets are the last waypoints of the
        trajectory, it ends no later.

    Raises
    ------
    InputError
        For invalid arguments.
    InfeasibleError
        If no plan keeps the limits: other limits that the state breaks, or cannot keep.
    """
    rest, start = _left(trajectory, time)
    points = (targets,) if isinstance(targets, Waypoint) else tuple(targets)
    request = checked_request(
        (start, *points), trajectory.limits if limits is None else limits, trajectory.smoothness,
        trajectory.shape, synchronize or trajectory.synchronize, None, None, trajectory.axis_names,
    )
    kept = _kept(trajectory, float(time), rest, request)
    try:
        found = _planned(request, rest)
    except (InfeasibleError, InputError):
        if kept is None:
            raise
        return kept
    if kept is not None and not found.duration < kept.duration * SHORTER:
        return kept
    return found


def _left(trajectory: Trajectory, time: float) -> tuple[Pieces, Waypoint]:
    """What is left of a trajectory, and its state at the time."""
    if not isinstance(trajectory, Trajectory):
        raise InputError(f"trajectory must be a plan, got {type(trajectory).__name__}")
    given = finite_vector("time", time)
    if given.size != 1 or given[0] < 0.0:
        raise InputError(f"time must be a time >= 0 s, got {time!r}")
    timing = np.zeros((len(trajectory.timing) + trajectory.offsets.size, 2))
    coefficients = np.zeros((len(timing), trajectory.coefficients.shape[1]))
    offsets = np.zeros_like(trajectory.offsets)
    backend.cut_plan(
        float(given[0]), trajectory.timing, trajectory.coefficients, trajectory.offsets, timing,
        coefficients, offsets,
    )
    rest = Pieces(timing, coefficients, offsets)
    return rest, Waypoint(*rest.starts().T)


def _kept(
    trajectory: Trajectory, time: float, rest: Pieces, request: Request
) -> Trajectory | None:
    """What is left of a trajectory, if it passes the waypoints of the request within its limits."""
    count = len(request.waypoints) - 1
    old = trajectory.waypoints[-count:]
    if count >= len(trajectory.waypoints) or any(
        not np.array_equal(a.state(2), b.state(2)) or a.dwell != b.dwell
        for a, b in zip(old, request.waypoints[1:], strict=True)
    ):
        return None
    arrivals = trajectory.axis_waypoint_times[-count:] - time
    if count > 1 and arrivals.min() < 0.0:
        return None
    dwell = request.waypoints[-1].dwell
    rest = rest.meeting(trajectory.duration)
    ends = rest.stops()
    if arrivals.min() < 0.0:
        # on its last waypoint already; of its dwell that is left which all axes have left
        dwell = float(min(dwell, ends.min()))
    arrivals[-1] = ends - dwell
    times = np.vstack([np.zeros(trajectory.axes), arrivals, ends])
    points, last = request.waypoints[1:-1], request.waypoints[-1]
    target = Waypoint(last.position, last.velocity, last.acceleration, dwell=dwell)
    for pieces in (rest, rest.anchored(target.state(2), request.problem.limits)):
        first = Waypoint(*pieces.starts().T)
        request = request._replace(waypoints=(first, *points, target))
        states = np.stack([p.state(trajectory.smoothness) for p in request.waypoints])
        kept, proved = judged(request, states, pieces, times, TOLERANCE)
        if proved or verify(kept).passed:
            return kept
    return None


def _planned(request: Request, rest: Pieces) -> Trajectory:
    """The plan of a request; behind all that is left of the old plan if there is no other."""
    try:
        return planned(request, rest)
    except InfeasibleError:
        states = rest.all_ends()
        # with rounding errors in its velocity an axis at rest would count as moving
        settled = states[None, :, : WaypointState.SIZE].copy()
        backend.settle_states(settled, request.problem.limits)
        states[:, : WaypointState.SIZE] = settled[0]
        chosen = choose_states(request)
        found, proved = solve_after(chosen, Leads(rest, states), TOLERANCE)
        if not proved:
            require(found)
        return found


def stop(
    start: Trajectory | Waypoint,
    time: float = 0.0,
    limits: Limits | None = None,
    *,
    smoothness: int = 4,
    axis_names: Sequence[str] | None = None,
) -> Trajectory:
    """Come to rest as soon as possible, wherever that is.

    Parameters
    ----------
    start, time, limits, smoothness, axis_names
        As for `reach_velocity`, which this calls with a velocity of zero.

    Returns
    -------
    Trajectory

    Raises
    ------
    InputError, InfeasibleError
        As `reach_velocity`.
    """
    axes = start.axes if isinstance(start, Trajectory | Waypoint) else 1
    return reach_velocity(
        start, np.zeros(axes), time, limits, smoothness=smoothness, axis_names=axis_names
    )


def reach_velocity(
    start: Trajectory | Waypoint,
    velocity: ArrayLike,
    time: float = 0.0,
    limits: Limits | None = None,
    *,
    smoothness: int = 4,
    axis_names: Sequence[str] | None = None,
) -> Trajectory:
    """Reach a velocity as soon as possible, wherever that is.

    Parameters
    ----------
    start : Trajectory or Waypoint
        Trajectory to leave at a time, or the state to begin from.
    velocity : array_like, shape (axes,)
        Velocity at the end [m/s]; the acceleration is zero there. An axis that has it before the
        others keeps it.
    time : float
        Time of the trajectory [s], which becomes time 0 of the new one.
    limits : Limits, optional
        Those of the trajectory by default; required with a state.
    smoothness, axis_names
        As for `plan`; those of the trajectory, if there is one.

    Returns
    -------
    Trajectory
        Its last waypoint is where the axes are when the last one has its velocity.

    Raises
    ------
    InputError
        For invalid arguments.
    InfeasibleError
        If the state cannot keep the limits.
    """
    if isinstance(start, Trajectory):
        rest, state = _left(start, time)
        limits = start.limits if limits is None else limits
        smoothness, shape, axis_names = start.smoothness, start.shape, start.axis_names
    elif isinstance(start, Waypoint) and limits is not None:
        rest, state, shape = Pieces.none(start.axes, smoothness), start, "plateau"
    else:
        raise InputError("start must be a trajectory, or a segfmu.Waypoint with limits")
    wanted = finite_vector("velocity", velocity)
    if wanted.size not in (1, state.axes):
        raise InputError(f"velocity has {wanted.size} values for {state.axes} axes")
    wanted = np.broadcast_to(wanted, state.position.shape)
    request = checked_request(
        (state, Waypoint(state.position, wanted)), limits, smoothness, shape, "waypoints", None,
        None, axis_names,
    )
    _require_velocity(request, wanted)
    leads = find_leads(
        TO_VELOCITY, request.start, request.problem.states[1], request.problem.limits, shape, rest
    )
    if leads.failed >= 0:
        raise no_lead(request.axis_names[leads.failed], leads.failed)
    return _held(request, leads, rest)


def _require_velocity(request: Request, wanted: FloatArray) -> None:
    bounds = request.problem.limits[:, 0]
    over = np.flatnonzero(np.abs(request.problem.states[1, :, 1]) > bounds)
    if over.size:
        axis = int(over[0])
        raise InfeasibleError(
            f"axis {request.axis_names[axis]}: velocity {wanted[axis]:.6g} m/s exceeds the limit "
            f"{bounds[axis]:.6g} m/s; raise limits.velocity or ask for less",
            axis=axis, limit="velocity", value=float(wanted[axis]), bound=float(bounds[axis]),
        )


def _held(request: Request, leads: Leads, rest: Pieces) -> Trajectory:
    """The trajectory of leads to a velocity; each axis keeps it until the last one is there."""
    velocity = request.problem.states[1, :, 1]
    found, proved = _joined(request, leads)
    if proved or verify(found).passed:
        return found
    # rounding errors of the whole old plan against its last bit; then leads that are shorter than
    # the clock resolves
    limits = request.problem.limits
    for other in (leads, following(rest, velocity, limits)):
        if other is not None:
            found, proved = _joined(request, other.anchored(velocity, limits))
            if proved or verify(found).passed:
                return found
    require(found)
    return found


def _joined(request: Request, leads: Leads) -> tuple[Trajectory, bool]:
    """The trajectory of the pieces of leads, and what each axis holds; whether it is proved."""
    axes = len(leads.states)
    velocity = request.problem.states[1, :, 1]
    delays = leads.states[:, DelayedState.DELAY]
    duration = float(delays.max())
    holds = np.zeros((axes, leads.pieces.coefficients.shape[1]))
    holds[:, 0], holds[:, 1] = leads.states[:, 0], velocity
    pieces = Pieces(
        np.column_stack([delays, duration - delays]), holds, np.arange(axes + 1, dtype=np.int64)
    ).after(leads.pieces)
    start = np.where(leads.following[:, None], pieces.starts(), request.start)
    end = Waypoint(leads.states[:, 0] + velocity * (duration - delays), velocity)
    request = request._replace(waypoints=(Waypoint(*start.T), end))
    states = np.stack([p.state(request.problem.options.smoothness) for p in request.waypoints])
    times = np.vstack([np.zeros(axes), np.full((2, axes), duration)])
    return judged(request, states, pieces, times, TOLERANCE)
