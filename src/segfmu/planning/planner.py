"""`plan`: waypoints and limits in, a verified trajectory out (section 3 of the paper).

request.py checks the arguments; free.py chooses the free states; problem.py and solver.py plan the
phases and expand them to polynomials; verify.py checks the trajectory; within.py keeps it in a
range of positions.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import inf

import numpy as np

from segfmu.arrays import FloatArray, Range, finite_number, require_callable, shown
from segfmu.errors import InfeasibleError, InputError
from segfmu.planning.demands import require, require_positions
from segfmu.planning.free import OVERSHOOT, Progress, at_rest, choose_states
from segfmu.planning.limits import Limits
from segfmu.planning.pieces import Pieces
from segfmu.planning.request import Request, checked_request, position_range
from segfmu.planning.solver import solve
from segfmu.planning.trajectory import Trajectory
from segfmu.planning.waypoint import Waypoint
from segfmu.planning.within import kept_within


def plan(
    waypoints: Sequence[Waypoint],
    limits: Limits,
    *,
    smoothness: int = 4,
    shape: str = "plateau",
    synchronize: str = "waypoints",
    sample_time: float | None = None,
    duration: float | None = None,
    position_min: Range = None,
    position_max: Range = None,
    axis_names: Sequence[str] | None = None,
    overshoot: float = OVERSHOOT,
    progress: Progress | None = None,
) -> Trajectory:
    """Plan a trajectory through waypoints within limits.

    Parameters
    ----------
    waypoints : sequence of Waypoint
        At least two, all with the same number of axes. What is free at the first and the last one,
        and at one with a dwell, becomes zero. Equal ones in a row, free states included, are one
        waypoint: no time passes between them, and their dwells add up.
    limits : Limits
        Limits of the derivatives; at least one from jerk on is required. A velocity or acceleration
        of a waypoint is its limit where it is within 1e-9 of that, and zero where it is within 1e-9
        of the limit and of about the largest one of the motion.
    smoothness : int
        n of the paper, 2 to 6: the trajectory is n times continuously differentiable.
    shape : {"plateau", "smoothstep"}
        Shape of the acceleration ramps; "smoothstep" is the paper's (12), "plateau" is faster.
    synchronize : {"waypoints", "total", "none"}
        All axes meet in every waypoint, only in the last one, or not at all.
    sample_time : float, optional
        Round the duration of every waypoint interval and of every dwell up to a multiple of it [s].
        What `duration` or "total" prolong after that are no multiples.
    duration : float, optional
        Requested total duration [s], dwells included. With `synchronize="none"` every axis has to
        last it, also where the longest one does already.
    position_min, position_max : array_like, scalar or shape (axes,), optional
        Range that no axis may leave [m]; None or infinity for no bound of an axis. Checked exactly.
        An interval may take longer to stay inside, unless `duration` is given.
    axis_names : sequence of str, optional
        Names for messages; x, y, z by default.
    overshoot : float
        How far free states may lead beyond the neighbouring waypoints. Between two waypoints, an
        axis stays in the range of these two, the one before and the one after them, widened on
        both sides by this share of the range; 0 for none, infinite for no such bound. Where
        moving waypoints lead farther in any case, the range is wider by that, and this share of it.
    progress : callable, optional
        Called with the number of passages whose free states are chosen, and of all of them.

    Returns
    -------
    Trajectory

    Raises
    ------
    InputError
        For invalid arguments.
    InfeasibleError
        If no plan keeps the limits; names axis, waypoint interval and limit.
    """
    if progress is not None:
        require_callable("progress", progress)
    request = checked_request(
        waypoints, limits, smoothness, shape, synchronize, sample_time, duration, axis_names
    )
    allowed = position_range(position_min, position_max, len(request.axis_names))
    chosen = choose_states(request, _share("overshoot", overshoot), progress, allowed)
    trajectory = planned(chosen)
    if allowed is None:
        return trajectory
    # at the ends of all scales numbers overflow, and nothing is found
    with np.errstate(all="ignore"):
        return _within(allowed, trajectory, chosen, request)


def _within(
    allowed: FloatArray, trajectory: Trajectory, chosen: Request, request: Request
) -> Trajectory:
    """The trajectory if it keeps the range of the positions, else one with splines that does.

    Where that fails, too, the one with rest at waypoints that are free.
    """
    found = trajectory
    for tried in (chosen, *([at_rest(request)] if request.free else [])):
        if tried is not chosen:
            found = planned(tried)
        try:
            require_positions(found, allowed)
        except InfeasibleError as error:
            inside = kept_within(found, tried, allowed)
            refused = error
        else:
            inside = found
        if inside is not None:
            return inside
    raise refused


def planned(request: Request, follow: Pieces | None = None, *, brakes: bool = False) -> Trajectory:
    """The verified trajectory of a request without free states.

    follow, brakes: as for `solve`.
    """
    trajectory, proved = solve(request, follow, brakes=brakes)
    if not proved:
        require(trajectory)
    return trajectory


def _share(name: str, value: float) -> float:
    """A number >= 0; infinity is one."""
    share = inf if isinstance(value, float) and value == inf else finite_number(name, value)
    if share < 0.0:
        raise InputError(f"{name} must be a number >= 0, got {shown(value)}")
    return share
