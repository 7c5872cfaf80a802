"""Obstacles and workspace: checked exactly against the load's path.

The load is a box with edges along the axes. It meets an obstacle while, in all three axes at once,
the distance of the centres is below half of both sizes and the margin; so the times of contact are
intersections of the intervals that passages.py finds for each axis.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import reduce

import numpy as np
from numpy.typing import ArrayLike

from segfmu.errors import InfeasibleError, InputError
from segfmu.planning.arrays import (
    FloatArray,
    Frozen,
    Range,
    as_tuple,
    finite_vector,
    range_bounds,
    shown,
)
from segfmu.planning.messages import told_apart
from segfmu.planning.passages import both, outside, rounding, within
from segfmu.planning.trajectory import Trajectory, require_plan


@dataclass(frozen=True, eq=False)
class Obstacle(Frozen):
    """A box that the load must not meet.

    Parameters
    ----------
    name : str
        For messages.
    minimum, maximum : array_like, shape (3,)
        Corners [m].
    margin : float
        Distance that the load keeps along each axis [m].

    Raises
    ------
    InputError
        For a name that is no text, corners that are not in order and a negative margin.
    """

    name: str
    minimum: FloatArray
    maximum: FloatArray
    margin: float

    def __init__(
        self, name: str, minimum: ArrayLike, maximum: ArrayLike, margin: float = 0.0
    ) -> None:
        if not isinstance(name, str):
            raise InputError(f"the name of an obstacle must be a text, got {shown(name)}")
        low, high = (
            _triple(f"obstacle {name}: {n}", v)
            for n, v in (("minimum", minimum), ("maximum", maximum))
        )
        for axis, (a, b) in enumerate(zip(low, high, strict=True)):
            if a >= b:
                raise InputError(
                    f"obstacle {name}: minimum {'xyz'[axis]} {a} m is not below maximum {b} m"
                )
        gap = finite_vector(f"obstacle {name}: margin", margin)
        if gap.size != 1 or gap[0] < 0.0:
            raise InputError(f"obstacle {name}: margin must be a distance >= 0 m, got {margin!r}")
        for key, value in (
            ("name", name), ("minimum", low), ("maximum", high), ("margin", float(gap[0]))
        ):
            object.__setattr__(self, key, value)


@dataclass(frozen=True, eq=False)
class Clearance(Frozen):
    """Where the load may be.

    Parameters
    ----------
    obstacles : sequence of Obstacle
    minimum, maximum : array_like, shape (3,), optional
        Range of the load's position in each axis [m]; None or infinity where there is none.
    load_size : array_like, shape (3,)
        Edges of the load's box [m]; 0 for a point. The box does not tilt with the sway.
    load_centre : array_like, shape (3,)
        Centre of the box from the load's position, the rope's end [m].

    Raises
    ------
    InputError
        For wrong shapes, negative sizes and an empty range.
    """

    obstacles: tuple[Obstacle, ...]
    minimum: FloatArray
    maximum: FloatArray
    load_size: FloatArray
    load_centre: FloatArray

    def __init__(
        self,
        obstacles: Sequence[Obstacle] = (),
        minimum: Range = None,
        maximum: Range = None,
        load_size: ArrayLike = (0.0, 0.0, 0.0),
        load_centre: ArrayLike = (0.0, 0.0, 0.0),
    ) -> None:
        boxes = as_tuple("obstacles", obstacles)
        for box in boxes:
            _require_obstacle(box)
        low, high = _edges("minimum", minimum, -np.inf), _edges("maximum", maximum, np.inf)
        for axis in np.flatnonzero(low >= high):
            raise InputError(
                f"workspace: minimum {'xyz'[axis]} {low[axis]} m is not below maximum "
                f"{high[axis]} m"
            )
        size = _triple("load_size", load_size)
        if (size < 0.0).any():
            raise InputError(f"load_size must be >= 0 m, got {size.tolist()}")
        for key, value in (
            ("obstacles", boxes), ("minimum", low), ("maximum", high), ("load_size", size),
            ("load_centre", _triple("load_centre", load_centre)),
        ):
            object.__setattr__(self, key, value)

    def contact(self, trajectory: Trajectory, obstacle: Obstacle) -> FloatArray:
        """Intervals of time [s] in which the load is too close to an obstacle, (intervals, 2).

        Raises
        ------
        InputError
            For anything but a trajectory of exactly three axes, and an Obstacle.
        """
        _require_axes(trajectory)
        _require_obstacle(obstacle)
        low, high = self._kept(obstacle)
        # the load may touch
        low, high = low + rounding(trajectory), high - rounding(trajectory)
        times = (within(trajectory, axis, low[axis], high[axis]) for axis in range(3))
        return reduce(both, times)

    def require(self, trajectory: Trajectory) -> None:
        """Check that a trajectory of x, y and z keeps to the workspace and off all obstacles.

        Raises
        ------
        InputError
            For anything but a trajectory of exactly three axes.
        InfeasibleError
            With the first contact: obstacle or axis, place, time, and the way out.
        """
        _require_axes(trajectory)
        self._require_range(trajectory)
        met = [(self.contact(trajectory, box), box) for box in self.obstacles]
        first = min(
            ((times[0, 0], times[0, 1], box) for times, box in met if times.size),
            key=lambda one: one[0], default=None,
        )
        if first is not None:
            raise self._met(trajectory, *first)

    def _kept(self, obstacle: Obstacle) -> tuple[FloatArray, FloatArray]:
        """Corners of the box that the load's position must keep out of."""
        reach = 0.5 * self.load_size + obstacle.margin
        return (
            obstacle.minimum - reach - self.load_centre,
            obstacle.maximum + reach - self.load_centre,
        )

    def _met(
        self, trajectory: Trajectory, begin: float, end: float, obstacle: Obstacle
    ) -> InfeasibleError:
        place = trajectory(begin)
        first, last = trajectory.interval(begin), trajectory.interval(end)
        height = self._kept(obstacle)[1][2]
        at = ", ".join(f"{p:.4g}" for p in place)
        return InfeasibleError(
            f"obstacle {obstacle.name}: the load meets it from {begin:.3f} s to {end:.3f} s, first "
            f"at ({at}) m, between waypoints {first} and {last + 1}; lead it past, or above "
            f"z = {height:.4g} m",
            interval=first, limit=obstacle.name, value=float(place[2]), bound=float(height),
            time=float(begin),
        )

    def _require_range(self, trajectory: Trajectory) -> None:
        for axis in range(3):
            low, high = self.minimum[axis], self.maximum[axis]
            touch = rounding(trajectory)
            allowed = within(trajectory, axis, low - touch, high + touch)
            beyond = outside(allowed, trajectory.duration)
            if beyond.size == 0:
                continue
            begin = float(beyond[0, 0])
            reached = [float(edge[axis]) for edge in trajectory.extrema(0)]
            value, bound = (reached[0], low) if reached[0] < low else (reached[1], high)
            n = told_apart(value, float(bound), 6)
            raise InfeasibleError(
                f"workspace: axis {trajectory.axis_names[axis]} leaves its range {low:.{n}g} to "
                f"{high:.{n}g} m at {begin:.3f} s, between waypoints {trajectory.interval(begin)} "
                f"and {trajectory.interval(begin) + 1}; it moves from {reached[0]:.{n}g} to "
                f"{reached[1]:.{n}g} m; move the waypoints or give them lower velocities",
                axis=axis, interval=trajectory.interval(begin), limit="workspace",
                value=value, bound=float(bound), time=begin,
            )


def _require_axes(trajectory: Trajectory) -> None:
    require_plan(trajectory)
    if trajectory.axes != 3:
        raise InputError(f"clearance needs axes x, y, z; got {trajectory.axes} axes")


def _require_obstacle(box: object) -> None:
    if not isinstance(box, Obstacle):
        raise InputError(f"an obstacle must be an Obstacle, got {type(box).__name__}")


def _triple(name: str, value: ArrayLike) -> FloatArray:
    vector = finite_vector(name, value)
    if vector.size != 3:
        raise InputError(f"{name} must have 3 values, got {vector.size}")
    return vector


def _edges(name: str, value: Range, absent: float) -> FloatArray:
    """One bound for each of x, y and z; `absent` for no bound."""
    bounds = range_bounds(f"workspace: {name}", value, absent)
    if value is not None and bounds.shape != (3,):
        raise InputError(f"workspace: {name} must have 3 values, got {bounds.size}")
    return np.broadcast_to(bounds, (3,))
