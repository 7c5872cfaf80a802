"""A plan to be made within the bounds of the drives."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any, Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

from segfmu.crane.contacts import resistance
from segfmu.crane.equipment import Friction
from segfmu.crane.parameters import Crane
from segfmu.crane.rope import require_rope
from segfmu.errors import InfeasibleError
from segfmu.kernels import backend
from segfmu.kernels.limits.records import AxisTask, LimitRow, Unknown
from segfmu.planning.arrays import FloatArray
from segfmu.planning.excursions import excursion, leaves
from segfmu.planning.limits import Limits
from segfmu.planning.planner import plan
from segfmu.planning.trajectory import Trajectory
from segfmu.planning.waypoint import Waypoint

# of the unknowns: the limits of all axes
LIMITS = 3 * LimitRow.SIZE


def with_motion(point: Waypoint, velocity: ArrayLike, acceleration: ArrayLike) -> Waypoint:
    """A waypoint with another velocity and acceleration."""
    return Waypoint(
        point.position, velocity, acceleration, point.jerk, point.snap, point.crackle, point.pop,
        dwell=point.dwell,
    )


class PathCheck(Protocol):
    """What a path keeps to and off, such as a `Clearance`."""

    def require(self, trajectory: Trajectory, gravity: float, /) -> object:
        """Raise InfeasibleError for a path that may not be taken."""


@dataclass(frozen=True, eq=False)
class Task:
    """What is planned: the crane, its bounds and all that `plan` takes.

    Attributes
    ----------
    waypoints : tuple of Waypoint
        With rest in place of free states.
    free : ndarray of bool, shape (waypoints, 2, 3)
        Velocities and accelerations that may be changed; of equal waypoints in a row those of the
        first one.
    first : ndarray of int, shape (waypoints,)
        The first one, from 0, of the equal waypoints that each is among.
    bounds : ndarray, shape (23,)
        The kernels' `DriveBounds`.
    caps : ndarray, shape (3, LimitRow.SIZE)
        Largest limits allowed, 0 where there are none.
    higher : dict
        Limits above the snap, as given.
    options : dict
        Further arguments of `plan`.
    clearance : PathCheck or None
    friction : Friction
    narrow : bool
        Whether the smaller bounds and limits of both directions hold in both.
    """

    crane: Crane
    waypoints: tuple[Waypoint, ...]
    free: NDArray[np.bool_]
    first: NDArray[np.intp]
    bounds: FloatArray
    caps: FloatArray
    higher: dict[str, Any]
    options: dict[str, Any]
    clearance: PathCheck | None
    friction: Friction
    narrow: bool = False

    @cached_property
    def positions(self) -> FloatArray:
        """Of the waypoints, shape (waypoints, 3)."""
        return np.array([p.position for p in self.waypoints])

    @cached_property
    def states(self) -> FloatArray:
        """Velocities and accelerations, shape (waypoints, 2, 3)."""
        return np.array([[p.velocity, p.acceleration] for p in self.waypoints])

    @cached_property
    def resistance(self) -> FloatArray:
        """The kernels' `Resistance`."""
        return resistance(self.crane, self.friction)

    @property
    def record(self) -> FloatArray:
        """The bounds of the search."""
        return self._bounds[0]

    @cached_property
    def _bounds(self) -> tuple[FloatArray, FloatArray]:
        """The record of the bounds, and the largest limits."""
        record, caps = self.bounds.copy(), self.caps.copy()
        if self.narrow:
            backend.narrow_bounds(record, caps)
        return record, caps

    @cached_property
    def axes(self) -> FloatArray:
        """The kernels' `AxisTask` of each axis."""
        rows = np.zeros((3, AxisTask.SIZE))
        velocities, accelerations = np.ascontiguousarray(self.states.swapaxes(0, 1))
        backend.write_axes(
            self.positions, velocities, accelerations, *self._bounds, self.resistance, rows
        )
        higher = np.array([[p.jerk, p.snap] for p in self.waypoints])
        first = AxisTask.FLOOR + LimitRow.JERK
        rows[:, first : first + 2] = np.abs(higher).max(axis=0).T
        return rows

    @cached_property
    def kinds(self) -> FloatArray:
        """The kernels' `Unknown` of every unknown: limits, then states of inner places."""
        states = np.where(self.free[self._inner], Unknown.STATE, Unknown.GIVEN)
        kinds = np.zeros(LIMITS + (states.size if self.free.any() else 0))
        backend.write_kinds(self.axes, kinds)
        kinds[LIMITS:] = states.ravel()[: kinds.size - LIMITS]
        return kinds

    @cached_property
    def places(self) -> FloatArray:
        """Positions that differ from the one before, shape (places, 3)."""
        return np.ascontiguousarray(self.positions[np.unique(self.first)])

    @property
    def _inner(self) -> NDArray[np.intp]:
        """The first waypoint of each place but the first and the last one."""
        return np.unique(self.first)[1:-1]

    @property
    def directed(self) -> NDArray[np.bool_]:
        """Whether velocity and acceleration of an axis have limits by direction, shape (3, 2)."""
        row = slice(AxisTask.DIRECTED, AxisTask.DIRECTED + 2)
        return np.asarray(self.axes[:, row] > 0.0)

    def planned(self, unknowns: FloatArray) -> Trajectory:
        """The plan that unknowns stand for; its rope is taut and in its range.

        Raises
        ------
        InfeasibleError
            If there is none.
        """
        table = np.zeros((3, LimitRow.SIZE))
        backend.write_limits(unknowns, self.axes, table)
        points = self.waypoints
        if self.free.any():
            # shares of the limits of velocity and acceleration
            shares = np.clip(unknowns[LIMITS:].reshape(-1, 2, 3), -1.0, 1.0)
            states = self.states.copy()
            states[self._inner] = np.where(
                self.free[self._inner], shares * table.T[:2], states[self._inner]
            )
            points = tuple(
                with_motion(p, s[0], s[1])
                for p, s in zip(points, states[self.first], strict=True)
            )
        trajectory = plan(points, self._limits(table), **self.options)
        require_rope(self.crane, trajectory)
        return trajectory

    def _limits(self, table: FloatArray) -> Limits:
        velocity, acceleration, jerk, snap, *least = table.T
        backwards = [
            np.where(own, -value, -np.inf)
            for own, value in zip(self.directed.T, least, strict=True)
        ]
        return Limits(
            velocity, acceleration, jerk, snap, **self.higher, velocity_min=backwards[0],
            acceleration_min=backwards[1],
        )

    def require_path(self, trajectory: Trajectory) -> None:
        """Refuse a path that is not clear, or leaves the box of waypoints with free states."""
        if self.clearance is not None:
            self.clearance.require(trajectory, self.crane.gravity)
        for interval, axis in self._led:
            found = excursion(trajectory, interval, axis)
            if found is not None:
                raise InfeasibleError(str(found), axis=found.axis, interval=found.interval)

    def allows(self, trajectory: Trajectory) -> bool:
        """Whether a path may be taken; faster than `require_path`."""
        if any(leaves(trajectory, interval, axis) for interval, axis in self._led):
            return False
        try:
            if self.clearance is not None:
                self.clearance.require(trajectory, self.crane.gravity)
        except InfeasibleError:
            return False
        return True

    @cached_property
    def _led(self) -> list[tuple[int, int]]:
        """Intervals (from 1) and axes with free states at an end."""
        free = np.any(self.free[self.first], axis=1)
        return [(int(i) + 1, int(axis)) for i, axis in np.argwhere(free[:-1] | free[1:])]
