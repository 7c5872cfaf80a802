"""`plan`: waypoints and limits in, a verified trajectory out (section 3 of the paper)."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np
from numpy.typing import ArrayLike

from segfmu.errors import InfeasibleError, InputError
from segfmu.planning.arrays import FloatArray, finite_vector
from segfmu.planning.free import choose_states
from segfmu.planning.limits import Limits
from segfmu.planning.solver import SHAPES, SYNCHRONIZATIONS, Options, solve, states
from segfmu.planning.trajectory import Trajectory
from segfmu.planning.waypoint import Waypoint

SMOOTHNESS = range(2, 7)


def plan(
    waypoints: Sequence[Waypoint],
    limits: Limits,
    *,
    smoothness: int = 4,
    shape: str = "plateau",
    synchronize: str = "waypoints",
    sample_time: float | None = None,
    duration: float | None = None,
    position_min: ArrayLike | None = None,
    position_max: ArrayLike | None = None,
    axis_names: Sequence[str] | None = None,
) -> Trajectory:
    """Plan a trajectory through waypoints within limits.

    Parameters
    ----------
    waypoints : sequence of Waypoint
        At least two, all with the same number of axes.
    limits : Limits
        Bounds on the derivatives; one of those from jerk on has to be given.
    smoothness : int
        n of the paper, 2 to 6: the trajectory is n times continuously differentiable.
    shape : {"plateau", "smoothstep"}
        Shape of the acceleration ramps; "smoothstep" is the paper's (12), "plateau" is faster.
    synchronize : {"waypoints", "total", "none"}
        All axes meet in every waypoint, only in the last one, or not at all.
    sample_time : float, optional
        Round the duration of every waypoint interval up to a multiple of it [s].
    duration : float, optional
        Total duration to take [s], dwells included.
    position_min, position_max : array_like, scalar or shape (axes,), optional
        Range that no axis may leave [m]; checked exactly.
    axis_names : sequence of str, optional
        Names for messages; x, y, z by default.

    Returns
    -------
    Trajectory

    Raises
    ------
    InputError
        For arguments that no plan can be made of.
    InfeasibleError
        When the limits do not admit the plan; names axis, waypoint interval and limit.
    """
    points = _checked_waypoints(waypoints)
    axes = points[0].axes
    names = _names(axis_names, axes)
    if smoothness not in SMOOTHNESS:
        raise InputError(f"smoothness must be an integer from 2 to 6, got {smoothness!r}")
    if not isinstance(limits, Limits):
        raise InputError(f"limits must be a segfmu.Limits, got {type(limits).__name__}")
    options = Options(
        int(smoothness), _choice("shape", shape, SHAPES),
        _choice("synchronize", synchronize, SYNCHRONIZATIONS),
        _time("sample_time", sample_time), _time("duration", duration),
    )
    points = choose_states(points, limits, options)
    _check_different(points)
    trajectory = solve(points, limits, options, names)
    _check_positions(trajectory, position_min, position_max)
    return trajectory


def _check_different(points: tuple[Waypoint, ...]) -> None:
    """Two waypoints that follow each other differ in something that doubles can tell."""
    rows = np.concatenate(states(points), axis=1).tolist()
    for i, (before, state) in enumerate(pairwise(rows), 1):
        if all(abs(b - a) <= 1e-15 * max(abs(b), 1.0) for a, b in zip(before, state, strict=True)):
            raise InputError(
                f"waypoints {i} and {i + 1} are the same; leave one out, or give it a dwell"
            )


def _checked_waypoints(waypoints: Sequence[Waypoint]) -> tuple[Waypoint, ...]:
    try:
        points = tuple(waypoints)
    except TypeError:
        raise InputError(f"waypoints must be a sequence, got {waypoints!r}") from None
    for i, point in enumerate(points, 1):
        if not isinstance(point, Waypoint):
            raise InputError(f"waypoint {i} must be a segfmu.Waypoint, got {type(point).__name__}")
        if point.axes != points[0].axes:
            raise InputError(
                f"waypoint {i} has {point.axes} axes, waypoint 1 has {points[0].axes}"
            )
    if len(points) < 2:
        raise InputError(f"a plan needs at least 2 waypoints, got {len(points)}")
    return points


def _names(axis_names: Sequence[str] | None, axes: int) -> tuple[str, ...]:
    if axis_names is None:
        return ("x", "y", "z")[:axes] if axes <= 3 else tuple(str(i + 1) for i in range(axes))
    try:
        names = tuple(axis_names)
    except TypeError:
        raise InputError(f"axis_names must be a sequence of names, got {axis_names!r}") from None
    if len(names) != axes:
        raise InputError(f"axis_names has {len(names)} names for {axes} axes")
    return names


def _choice(name: str, value: str, choices: tuple[str, ...]) -> str:
    if value not in choices:
        raise InputError(f"{name} must be one of {', '.join(choices)}, got {value!r}")
    return value


def _time(name: str, value: float | None) -> float:
    if value is None:
        return 0.0
    seconds = finite_vector(name, value)
    if seconds.size != 1 or seconds[0] <= 0.0:
        raise InputError(f"{name} must be a time > 0 s, got {value!r}")
    return float(seconds[0])


def _check_positions(
    trajectory: Trajectory, position_min: ArrayLike | None, position_max: ArrayLike | None
) -> None:
    if position_min is None and position_max is None:
        return
    low, high = trajectory.extrema(0)
    for name, given, reached, sign in (
        ("position_min", position_min, low, -1.0),
        ("position_max", position_max, high, 1.0),
    ):
        if given is None:
            continue
        bounds = _position_bounds(name, given, trajectory.axes)
        margin = 1e-12 * np.maximum(np.abs(bounds), 1.0)
        for axis in np.flatnonzero(sign * (reached - bounds) > margin):
            raise InfeasibleError(
                f"axis {trajectory.axis_names[axis]}: position reaches {reached[axis]:.6g} m, "
                f"{name} is {bounds[axis]:.6g} m; move the waypoints or slow them down",
                axis=int(axis), limit=name, value=float(reached[axis]), bound=float(bounds[axis]),
            )


def _position_bounds(name: str, given: ArrayLike, axes: int) -> FloatArray:
    bounds = finite_vector(name, given)
    if bounds.size not in (1, axes):
        raise InputError(f"{name} has {bounds.size} values for {axes} axes")
    return np.broadcast_to(bounds, (axes,))
