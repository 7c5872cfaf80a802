"""The arguments of `plan`, checked."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from segfmu.arrays import FloatArray, Range, as_tuple, finite_number, range_bounds, shown
from segfmu.errors import InputError
from segfmu.kernels import backend
from segfmu.kernels.planner.records import WaypointState
from segfmu.planning.limits import Limits
from segfmu.planning.problem import SHAPES, SYNCHRONIZATIONS, Problem, options
from segfmu.planning.waypoint import DERIVATIVES, FREE, Waypoint

SMOOTHNESS = range(2, 7)
NUMBERS = (int, float, np.integer, np.floating)


class Request(NamedTuple):
    """A request to the planner.

    Attributes
    ----------
    waypoints, limits, axis_names
        As given to `plan`.
    problem : Problem
        The same as arrays.
    """

    waypoints: tuple[Waypoint, ...]
    limits: Limits
    axis_names: tuple[str, ...]
    problem: Problem

    @property
    def free(self) -> bool:
        """Whether a velocity or acceleration is free."""
        # in half the time of `any`
        return True in [point.free for point in self.waypoints]

    @property
    def start(self) -> FloatArray:
        """Position and the derivatives 1 .. n at the first waypoint, shape (axes, n + 1)."""
        return self.waypoints[0].state(self.problem.options.smoothness)


def checked_smoothness(value: int) -> int:
    """A smoothness; InputError unless it is one."""
    if not isinstance(value, NUMBERS) or value not in SMOOTHNESS:
        raise InputError(f"smoothness must be an integer from 2 to 6, got {shown(value)}")
    return int(value)


def checked_request(
    waypoints: Sequence[Waypoint],
    limits: Limits,
    smoothness: int,
    shape: str,
    synchronize: str,
    sample_time: float | None,
    duration: float | None,
    axis_names: Sequence[str] | None,
) -> Request:
    """Return the request for the arguments of `plan`; raises InputError as documented there."""
    checked_smoothness(smoothness)
    points = _checked_waypoints(waypoints, smoothness)
    axes = points[0].axes
    names = _names(axis_names, axes)
    if not isinstance(limits, Limits):
        raise InputError(f"limits must be a segfmu.Limits, got {type(limits).__name__}")
    chosen = options(
        int(smoothness), _choice("shape", shape, SHAPES),
        _choice("synchronize", synchronize, SYNCHRONIZATIONS),
        _time("sample_time", sample_time), _time("duration", duration),
    )
    states = np.array([point.planned for point in points])
    dwells = np.array([point.dwell for point in points])
    table = limits.table(axes, chosen.smoothness)
    # a start on another plan stays as it is
    lower = limits.lower(axes)
    changed = backend.settle_states(0 if points[0].settled else 1, states, table, lower)
    if changed + backend.settle_dwells(chosen.sample_time, dwells) > 0:
        points = with_states(points, states, dwells)
    return Request(points, limits, names, Problem(states, dwells, table, lower, chosen))


def with_states(
    points: tuple[Waypoint, ...], states: FloatArray, dwells: FloatArray
) -> tuple[Waypoint, ...]:
    """The waypoints with other states, shape (waypoints, axes, WaypointState), and dwells [s].

    NaN: free.
    """
    known = [[[None if v != v else v for v in row] for row in state.T.tolist()] for state in states]
    return tuple(
        Waypoint(point.position, row[WaypointState.VELOCITY], row[WaypointState.ACCELERATION],
                 point.jerk, point.snap, point.crackle, point.pop, dwell)
        for point, row, dwell in zip(points, known, dwells.tolist(), strict=True)
    )


def position_range(position_min: Range, position_max: Range, axes: int) -> FloatArray | None:
    """Range of the positions [m], shape (axes, 2), infinite for no bound; None for no range."""
    if position_min is None and position_max is None:
        return None
    return np.stack([
        _position_bounds("position_min", position_min, axes, -np.inf),
        _position_bounds("position_max", position_max, axes, np.inf),
    ], axis=1)


def _position_bounds(name: str, given: Range, axes: int, absent: float) -> FloatArray:
    """Bounds of the position [m], one per axis; `absent`, -inf or inf, for no bound."""
    bounds = range_bounds(name, given, absent)
    if bounds.ndim == 1 and bounds.size not in (1, axes):
        raise InputError(f"{name} has {bounds.size} values for {axes} axes")
    return np.broadcast_to(bounds, (axes,))


def _checked_waypoints(waypoints: Sequence[Waypoint], smoothness: float) -> tuple[Waypoint, ...]:
    points = as_tuple("waypoints", waypoints)
    for i, point in enumerate(points, 1):
        if not isinstance(point, Waypoint):
            raise InputError(f"waypoint {i} must be a segfmu.Waypoint, got {type(point).__name__}")
        if point.axes != points[0].axes:
            raise InputError(f"waypoint {i} has {point.axes} axes, waypoint 1 has {points[0].axes}")
        if not point.settled:
            _require_start(i, point, smoothness)
    if len(points) < 2:
        raise InputError(f"a plan needs at least 2 waypoints, got {len(points)}")
    return points


def _require_start(number: int, point: Waypoint, smoothness: float) -> None:
    """InputError for derivatives above the acceleration where a waypoint cannot have them."""
    # the first one may have those that the plan has continuous
    first = FREE if number > 1 else int(smoothness)
    for order, name in enumerate(DERIVATIVES[first:], first + 1):
        given = getattr(point, name)
        # in a tenth of the time of `given.any()`
        if not np.count_nonzero(given):
            continue
        if number > 1:
            raise InputError(
                f"waypoint {number}: {name} is {given.tolist()}; only the first waypoint has one"
            )
        raise InputError(
            f"waypoint {number}: {name} is {given.tolist()}; with smoothness {smoothness:g} "
            f"it may jump anywhere; omit it or raise smoothness to {order}"
        )
    if point.dwell > 0.0:
        raise InputError(f"waypoint {number}: a dwell needs a point at rest")


def _names(axis_names: Sequence[str] | None, axes: int) -> tuple[str, ...]:
    if axis_names is None:
        return ("x", "y", "z")[:axes] if axes <= 3 else tuple(str(i + 1) for i in range(axes))
    names = as_tuple("axis_names", axis_names)
    if len(names) != axes:
        raise InputError(f"axis_names has {len(names)} names for {axes} axes")
    if not all(isinstance(name, str) for name in names):
        raise InputError(f"axis_names must be strings, got {shown(axis_names)}")
    return names


def _choice(name: str, value: str, choices: tuple[str, ...]) -> str:
    if not isinstance(value, str) or value not in choices:
        raise InputError(f"{name} must be one of {', '.join(choices)}, got {shown(value)}")
    return value


def _time(name: str, value: float | None) -> float:
    if value is None:
        return 0.0
    seconds = finite_number(name, value)
    if seconds <= 0.0:
        raise InputError(f"{name} must be a time > 0 s, got {shown(value)}")
    return seconds
