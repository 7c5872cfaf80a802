"""To a velocity or to rest, as soon as possible, wherever that is: from a plan or from a state."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from segfmu.arrays import FloatArray, finite_vector
from segfmu.errors import InfeasibleError, InputError
from segfmu.kernels.planner.records import DelayedState, WaypointState
from segfmu.planning.demands import require
from segfmu.planning.lead import Leads, find_leads, following
from segfmu.planning.limits import Limits
from segfmu.planning.messages import told_apart
from segfmu.planning.pieces import Pieces
from segfmu.planning.replanning import left, state_limits
from segfmu.planning.request import Request, checked_request
from segfmu.planning.solver import judged, no_lead
from segfmu.planning.trajectory import Trajectory
from segfmu.planning.verify import verify
from segfmu.planning.waypoint import Waypoint, waypoint_of


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

    A state that cannot keep the limits, as with limits that are lowered while an axis moves, is
    brought inside them first; `Trajectory.outside` tells how long that takes.

    Parameters
    ----------
    start : Trajectory or Waypoint
        Trajectory to leave at a time, or the state to begin from, without free parts and dwell.
    velocity : array_like, shape (axes,)
        Velocity at the end [m/s]; the acceleration is zero there. An axis that has it before the
        others keeps it.
    time : float
        Time of the trajectory [s], which becomes time 0 of the new one; 0 with a state.
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
        If the velocity exceeds the limits.
    """
    if isinstance(start, Trajectory):
        _, rest, state = left(start, time)
        limits = start.limits if limits is None else limits
        smoothness, shape, axis_names = start.smoothness, start.shape, start.axis_names
    elif isinstance(start, Waypoint):
        limits = state_limits(start, time, limits)
        rest, state, shape = None, start, "plateau"
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
    none = Pieces.none(state.axes, request.problem.options.smoothness)
    if rest is not None:
        try:
            return _reached(request, shape, rest)
        except InfeasibleError:
            # what is left of the old plan need not keep the new limits
            pass
    return _reached(request, shape, none)


def _reached(request: Request, shape: str, rest: Pieces) -> Trajectory:
    """To the velocity of the last waypoint, perhaps by way of what is left of the old plan."""
    problem = request.problem
    leads = find_leads(
        problem.states[1, :, WaypointState.VELOCITY], request.start, problem.limits, problem.lower,
        shape, rest,
    )
    if leads.failed >= 0:
        raise no_lead(request, leads.failed)
    return _held(request, leads, rest)


def _require_velocity(request: Request, wanted: FloatArray) -> None:
    velocity = request.problem.states[1, :, 1]
    bounds = np.where(velocity < 0.0, request.problem.lower[:, 0], request.problem.limits[:, 0])
    over = np.flatnonzero(np.abs(velocity) > bounds)
    if over.size:
        axis = int(over[0])
        value, bound = float(wanted[axis]), float(bounds[axis])
        digits = told_apart(value, bound, 6)
        limit = request.limits.named("velocity", axis, value)
        raise InfeasibleError(
            f"axis {request.axis_names[axis]}: velocity {value:.{digits}g} m/s exceeds the limit "
            f"{bound:.{digits}g} m/s; raise limits.{limit} or ask for less",
            axis=axis, limit=limit, value=value, bound=bound,
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
    request = request._replace(waypoints=(waypoint_of(start), end))
    states = np.stack([p.state(request.problem.options.smoothness) for p in request.waypoints])
    times = np.vstack([np.zeros(axes), np.full((2, axes), duration)])
    return judged(request, states, pieces, times)
