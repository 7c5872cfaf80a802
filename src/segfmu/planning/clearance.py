"""Obstacles and workspace: checked exactly against the path of the load and its rope.

The load is a box with edges along the axes. It meets an obstacle while, in all three axes at once,
the distance of the centres is below half of both sizes and the margin. The rope is the line from
the trolley, at z = 0, to the load; where the trolley is follows from the load's acceleration.
contacts.py finds the times.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from segfmu.arrays import (
    FloatArray,
    Frozen,
    Range,
    as_flag,
    as_tuple,
    finite_number,
    finite_vector,
    range_bounds,
    shown,
    sized,
)
from segfmu.errors import InfeasibleError, InputError
from segfmu.kernels import backend
from segfmu.kernels.clearance.records import Box, Collision, Part, Ranges, Space
from segfmu.planning.contacts import Path
from segfmu.planning.messages import told_apart
from segfmu.planning.passages import outside, within
from segfmu.planning.trajectory import Trajectory, require_plan

# [m/s2], that of `Crane` by default
GRAVITY = 9.81


@dataclass(frozen=True, eq=False)
class Obstacle(Frozen):
    """A box that the load and its rope must not meet.

    Parameters
    ----------
    name : str
        For messages.
    minimum, maximum : array_like, shape (3,)
        Corners [m].
    margin : float
        Distance that load and rope keep along each axis [m].
    rope : bool
        Whether the rope must keep off it as well; False for a place that the load alone must not
        enter.

    Raises
    ------
    InputError
        For a name that is no text, corners that are not in order and a negative margin.
    """

    name: str
    minimum: FloatArray
    maximum: FloatArray
    margin: float
    rope: bool

    def __init__(
        self, name: str, minimum: ArrayLike, maximum: ArrayLike, margin: float = 0.0,
        rope: bool = True,
    ) -> None:
        if not isinstance(name, str):
            raise InputError(f"the name of an obstacle must be a text, got {shown(name)}")
        low, high = (
            sized(f"obstacle {name}: {n}", v, 3)
            for n, v in (("minimum", minimum), ("maximum", maximum))
        )
        for axis, (a, b) in enumerate(zip(low, high, strict=True)):
            if a >= b:
                raise InputError(
                    f"obstacle {name}: minimum {'xyz'[axis]} {a} m is not below maximum {b} m"
                )
        gap = finite_vector(f"obstacle {name}: margin", margin)
        if gap.size != 1 or gap[0] < 0.0:
            raise InputError(
                f"obstacle {name}: margin must be a distance >= 0 m, got {shown(margin)}"
            )
        rope = as_flag(f"obstacle {name}: rope", rope)
        for key, value in (
            ("name", name), ("minimum", low), ("maximum", high), ("margin", float(gap[0])),
            ("rope", rope),
        ):
            object.__setattr__(self, key, value)


@dataclass(frozen=True, eq=False)
class Clearance(Frozen):
    """Where the load and its rope may be.

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
        size = sized("load_size", load_size, 3)
        if (size < 0.0).any():
            raise InputError(f"load_size must be >= 0 m, got {size.tolist()}")
        for key, value in (
            ("obstacles", boxes), ("minimum", low), ("maximum", high), ("load_size", size),
            ("load_centre", sized("load_centre", load_centre, 3)),
        ):
            object.__setattr__(self, key, value)

    def contact(self, trajectory: Trajectory, obstacle: Obstacle) -> FloatArray:
        """Intervals of time [s] in which the load is too close to an obstacle, (intervals, 2).

        Raises
        ------
        InputError
            For anything but a trajectory of exactly three axes, and an Obstacle.
        """
        return self._times(Part.LOAD, trajectory, obstacle, GRAVITY)

    def rope_contact(
        self, trajectory: Trajectory, obstacle: Obstacle, gravity: float = GRAVITY
    ) -> FloatArray:
        """Intervals of time [s] in which the rope is too close to an obstacle, (intervals, 2).

        Whatever `Obstacle.rope` says. A load at or above the trolley's height, or one that falls
        freely, has no rope.

        Raises
        ------
        InputError
            As `contact`; also for a gravity [m/s2] that is not above 0.
        """
        return self._times(Part.ROPE, trajectory, obstacle, gravity)

    def require(self, trajectory: Trajectory, gravity: float = GRAVITY) -> None:
        """Check that a trajectory of x, y and z keeps to the workspace and off all obstacles.

        Parameters
        ----------
        trajectory : Trajectory
        gravity : float
            Where the crane is [m/s2]; the rope's direction follows from it.

        Raises
        ------
        InputError
            For anything but a trajectory of exactly three axes, and a gravity that is not above 0.
        InfeasibleError
            With the first contact of the load, or of the rope if the load is clear: obstacle or
            axis, place, time, and the way out.
        """
        _require_axes(trajectory)
        path = Path(trajectory, _gravity(gravity))
        self._require_range(trajectory, path)
        part, report = path.first(self._boxes)
        if part != Part.CLEAR:
            raise self._met(trajectory, part, report)

    def _times(
        self, part: int, trajectory: Trajectory, obstacle: Obstacle, gravity: float
    ) -> FloatArray:
        _require_axes(trajectory)
        _require_obstacle(obstacle)
        path = Path(trajectory, _gravity(gravity))
        boxes = self._placed([obstacle])
        backend.shrink_boxes(path.rounding, boxes)
        return path.times(part, boxes[0])

    @cached_property
    def _boxes(self) -> FloatArray:
        """All obstacles as the kernels take them."""
        return self._placed(self.obstacles)

    def _placed(self, obstacles: Sequence[Obstacle]) -> FloatArray:
        """Obstacles as the kernels take them, (obstacles, Box)."""
        boxes = np.empty((len(obstacles), Box.SIZE))
        for box, obstacle in zip(boxes, obstacles, strict=True):
            row = [*obstacle.minimum, *obstacle.maximum, obstacle.margin, obstacle.rope]
            backend.write_box(self._space, np.array(row, dtype=np.float64), box)
        return boxes

    @cached_property
    def _space(self) -> FloatArray:
        """Size of the load, as the kernels take it."""
        space = np.zeros(Space.SIZE)
        space[Space.LOAD_SIZE : Space.LOAD_CENTRE] = self.load_size
        space[Space.LOAD_CENTRE : Space.OBSTACLES] = self.load_centre
        return space

    def _met(self, trajectory: Trajectory, part: int, report: FloatArray) -> InfeasibleError:
        """The error for a contact (Collision) of a part (Part)."""
        obstacle = self.obstacles[int(report[Collision.BOX])]
        begin, end = report[[Collision.BEGIN, Collision.END]].tolist()
        place = report[Collision.X : Collision.Z + 1].tolist()
        first, last = trajectory.interval(begin), trajectory.interval(end)
        height = float(obstacle.maximum[2] + obstacle.margin)
        if part == Part.LOAD:
            height += float(0.5 * self.load_size[2] - self.load_centre[2])
        what = "load" if part == Part.LOAD else "rope"
        way = "lead it past" if part == Part.LOAD else "lead the load past it at more distance"
        # nothing is led above what reaches up to the trolley
        way += f", or above z = {height:.4g} m" if height < 0.0 or part == Part.LOAD else ""
        at = ", ".join(f"{p:.4g}" for p in place)
        return InfeasibleError(
            f"obstacle {obstacle.name}: the {what} meets it from {begin:.3f} s to {end:.3f} s, "
            f"first at ({at}) m, between waypoints {first} and {last + 1}; {way}",
            interval=first, limit=obstacle.name, value=place[2], bound=height, time=begin,
        )

    def _require_range(self, trajectory: Trajectory, path: Path) -> None:
        least, most = path.ranges[Ranges.LOAD_LOW], path.ranges[Ranges.LOAD_HIGH]
        # fast, for most
        if (least >= self.minimum).all() and (most <= self.maximum).all():
            return
        touch = path.rounding
        for axis in range(3):
            low, high = self.minimum[axis], self.maximum[axis]
            if least[axis] >= low - touch and most[axis] <= high + touch:
                continue
            allowed = within(trajectory, axis, low - touch, high + touch)
            beyond = outside(allowed, trajectory.duration)
            # a plan that lasts no time has no interval
            if beyond.size == 0 and trajectory.duration > 0.0:
                continue
            begin = float(beyond[0, 0]) if beyond.size > 0 else 0.0
            reached = [float(values[axis]) for values in trajectory.extrema(0)]
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


def _gravity(value: float) -> float:
    gravity = finite_number("gravity", value)
    if gravity <= 0.0:
        raise InputError(f"gravity must be an acceleration > 0 m/s2, got {shown(value)}")
    return gravity


def _require_obstacle(box: object) -> None:
    if not isinstance(box, Obstacle):
        raise InputError(f"an obstacle must be an Obstacle, got {type(box).__name__}")


def _edges(name: str, value: Range, absent: float) -> FloatArray:
    """One bound for each of x, y and z; `absent` for no bound."""
    bounds = range_bounds(f"workspace: {name}", value, absent)
    if value is not None and bounds.shape != (3,):
        raise InputError(f"workspace: {name} must have 3 values, got {bounds.size}")
    return np.broadcast_to(bounds, (3,))
