"""A plan to be made within the bounds of the drives."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from segfmu.crane.equipment import Friction
from segfmu.crane.parameters import Crane
from segfmu.crane.rope import require_rope
from segfmu.errors import InfeasibleError
from segfmu.kernels.crane.records import Demand
from segfmu.planning.arrays import FloatArray
from segfmu.planning.clearance import Clearance
from segfmu.planning.excursions import excursion, leaves
from segfmu.planning.limits import Limits
from segfmu.planning.planner import plan
from segfmu.planning.trajectory import Trajectory
from segfmu.planning.waypoint import Waypoint

# searched: velocity, acceleration, jerk, snap
SEARCHED = 4
# a bound nearer to the weight than this leaves no room that could be measured
WEIGHTLESS = 1e-6


def with_motion(point: Waypoint, velocity: ArrayLike, acceleration: ArrayLike) -> Waypoint:
    """A waypoint with another velocity and acceleration."""
    return Waypoint(
        point.position, velocity, acceleration, point.jerk, point.snap, point.crackle, point.pop,
        dwell=point.dwell,
    )


@dataclass(frozen=True, eq=False)
class Task:
    """What is planned: the crane, its bounds and all that `plan` takes.

    Attributes
    ----------
    waypoints : tuple of Waypoint
        Without free states.
    free : ndarray of bool, shape (waypoints, 2, 3)
        Velocities and accelerations that may be changed; of equal waypoints in a row those of the
        first one.
    first : ndarray of int, shape (waypoints,)
        The first one, from 0, of the equal waypoints that each is among.
    caps : ndarray, shape (3, 4)
        Largest limits allowed, infinite where there are none.
    higher : dict
        Limits above the snap, as given.
    options : dict
        Further arguments of `plan`.
    clearance : Clearance or None
    friction : Friction
    """

    crane: Crane
    waypoints: tuple[Waypoint, ...]
    free: NDArray[np.bool_]
    first: NDArray[np.intp]
    bounds: FloatArray
    caps: FloatArray
    higher: dict[str, Any]
    options: dict[str, Any]
    clearance: Clearance | None
    friction: Friction

    def limits(self, table: FloatArray) -> Limits:
        """Limits of a table (3, 4)."""
        return Limits(*table.T, **self.higher)

    def plan(self, table: FloatArray) -> Trajectory:
        """The plan with a table of limits; its rope is taut and in its range."""
        trajectory = plan(self.waypoints, self.limits(table), **self.options)
        require_rope(self.crane, trajectory)
        return trajectory

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

    @property
    def weight(self) -> float:
        """Of the load [N]."""
        return self.crane.payload_mass * self.crane.gravity

    @cached_property
    def sticking(self) -> FloatArray:
        """Dry friction [N] that axes which move break away from, (3,)."""
        static = np.maximum(self.friction.static, self.friction.coulomb)
        return np.asarray(np.where(np.isin(np.arange(3), self.moving), static, 0.0))

    @cached_property
    def rest(self) -> FloatArray:
        """Demands that no slower plan reduces, (14,): dry friction, and the weight on the hoist."""
        rest = np.zeros(self.bounds.size)
        rest[Demand.FORCE : Demand.VELOCITY] = self.sticking
        rest[Demand.FORCE + 2] += self.weight
        return np.asarray(np.where(self.bounds > rest * (1.0 + WEIGHTLESS), rest, 0.0))

    @cached_property
    def room(self) -> FloatArray:
        """What the bounds leave for motion, (14,)."""
        return self.bounds - self.rest

    @property
    def states(self) -> FloatArray:
        """Velocities and accelerations, shape (waypoints, 2, 3)."""
        return np.array([[p.velocity, p.acceleration] for p in self.waypoints])

    def with_states(self, states: FloatArray) -> Task:
        """The task with other velocities and accelerations where they are free."""
        if not self.free.any():
            return self
        states = np.where(self.free, states, self.states)[self.first]
        points = tuple(
            with_motion(point, state[0], state[1])
            for point, state in zip(self.waypoints, states, strict=True)
        )
        return replace(self, waypoints=points)

    def paced(self, pace: float) -> Task:
        """The task with free states that are faster by a factor."""
        if pace == 1.0 or not self.free.any():
            return self
        return self.with_states(np.array([pace, pace**2])[:, None] * self.states)

    @property
    def floors(self) -> FloatArray:
        """Least limits that admit the states, shape (3, 4)."""
        states = [[p.velocity, p.acceleration, p.jerk, p.snap] for p in self.waypoints]
        return np.asarray(np.abs(states).max(axis=0).T)

    @property
    def moving(self) -> NDArray[np.intp]:
        """Axes that move."""
        positions = np.array([p.position for p in self.waypoints])
        return np.flatnonzero((np.ptp(positions, axis=0) > 0.0) | self.states.any(axis=(0, 1)))
