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

# searched: velocity, acceleration, jerk, snap; behind them velocity and acceleration backwards
SEARCHED, DIRECTED = 4, 2
COLUMNS = SEARCHED + DIRECTED
HOIST = 2
# a bound nearer to the weight than this leaves no room that could be measured
WEIGHTLESS = 1e-6


def first_senses(waypoints: tuple[Waypoint, ...]) -> FloatArray:
    """Where each axis goes first, -1 or 1, (3,); by its states where it stays in one place."""
    places = np.diff([p.position for p in waypoints], axis=0)
    states = [[p.velocity, p.acceleration] for p in waypoints]
    moves = np.vstack([places, np.reshape(states, (-1, 3))])
    first = (moves != 0.0).argmax(axis=0)
    return np.where(moves[first, np.arange(3)] < 0.0, -1.0, 1.0)


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
    bounds : ndarray, shape (2, 14)
        Of the drives, as in `ActuatorBounds.table`.
    caps : ndarray, shape (3, 6)
        Largest limits allowed, infinite where there are none.
    senses : ndarray, shape (3,)
        Where an axis goes first, -1 or 1: ahead. A mirrored task is searched alike.
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
    senses: FloatArray
    higher: dict[str, Any]
    options: dict[str, Any]
    clearance: Clearance | None
    friction: Friction

    @cached_property
    def directed(self) -> NDArray[np.bool_]:
        """Whether velocity and acceleration of an axis have limits by direction, shape (3, 2).

        A velocity backwards does not tell where an axis does not turn, nor the force of a hoist,
        which pulls, whichever way the load is accelerated.
        """
        differ = (self.bounds[0] != self.bounds[1])[: Demand.POWER].reshape(-1, 3)
        force, velocity, acceleration = differ
        turns = self.goes.all(axis=0)
        found = np.column_stack([
            velocity & turns, acceleration | (force & (np.arange(3) != HOIST)),
        ])
        return np.asarray(found | (self.caps[:, :DIRECTED] != self.caps[:, SEARCHED:]))

    @property
    def narrow(self) -> Task:
        """The task with the smaller of the bounds and limits of both directions in both."""
        least = np.minimum(self.caps[:, :DIRECTED], self.caps[:, SEARCHED:])
        caps = np.hstack([least, self.caps[:, DIRECTED:SEARCHED], least])
        bounds = np.broadcast_to(self.bounds.min(axis=0), self.bounds.shape).copy()
        # what the rope carries has no other direction
        bounds[:, Demand.FORCE + HOIST] = self.bounds[:, Demand.FORCE + HOIST]
        return replace(self, bounds=bounds, caps=caps)

    def limits(self, table: FloatArray) -> Limits:
        """Limits of a table (3, 6): ahead and, of velocity and acceleration, backwards."""
        ahead, back = table[:, :DIRECTED], table[:, SEARCHED:]
        turned = self.senses[:, None] < 0.0
        upper, lower = np.where(turned, back, ahead), np.where(turned, ahead, back)
        least = np.where(self.directed, -lower, -np.inf)
        return Limits(
            *upper.T, *table[:, DIRECTED:SEARCHED].T, **self.higher,
            velocity_min=least[:, 0], acceleration_min=least[:, 1],
        )

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
        """Demands that no slower plan reduces, (2, 14): dry friction, and the load's weight."""
        rest = np.zeros(self.bounds.shape)
        rest[:, Demand.FORCE : Demand.VELOCITY] = self.sticking
        rest[:, Demand.FORCE + HOIST] += [-self.weight, self.weight]
        rest = np.maximum(rest, 0.0)
        return np.asarray(np.where(self.bounds > rest * (1.0 + WEIGHTLESS), rest, 0.0))

    @cached_property
    def room(self) -> FloatArray:
        """What the bounds leave for motion, (2, 14)."""
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
        """Least limits that admit the states, shape (3, 6)."""
        states = np.array([[p.velocity, p.acceleration, p.jerk, p.snap] for p in self.waypoints])
        found = np.abs(states).max(axis=0).T
        found = np.hstack([found, found[:, :DIRECTED]])
        if self.directed.any():
            ahead = (self.senses * states[:, :DIRECTED]).max(axis=0).T
            back = -(self.senses * states[:, :DIRECTED]).min(axis=0).T
            for columns, own in ((slice(DIRECTED), ahead), (slice(SEARCHED, None), back)):
                found[:, columns] = np.where(
                    self.directed, np.maximum(own, 0.0), found[:, columns]
                )
        return np.asarray(found)

    @property
    def goes(self) -> NDArray[np.bool_]:
        """Whether a drive moves in the positive and in the negative direction, shape (2, 3).

        A hoist goes the other way than the load.
        """
        ways = np.vstack([
            np.diff([p.position for p in self.waypoints], axis=0), self.states[:, 0]
        ])
        found = np.array([(ways > 0.0).any(axis=0), (ways < 0.0).any(axis=0)])
        # it swings back and forth, if it is only accelerated
        found |= ~found.any(axis=0) & np.isin(np.arange(3), self.moving)
        found[:, HOIST] = found[::-1, HOIST]
        return np.asarray(found)

    @property
    def moving(self) -> NDArray[np.intp]:
        """Axes that move."""
        positions = np.array([p.position for p in self.waypoints])
        return np.flatnonzero((np.ptp(positions, axis=0) > 0.0) | self.states.any(axis=(0, 1)))
