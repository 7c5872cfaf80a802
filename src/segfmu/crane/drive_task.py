"""A plan to be made within the bounds of the drives."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from segfmu.arrays import FloatArray
from segfmu.crane.contacts import resistance
from segfmu.crane.equipment import Friction
from segfmu.crane.flat_models import model_of
from segfmu.crane.kinds import AnyCrane
from segfmu.errors import InfeasibleError
from segfmu.kernels import backend
from segfmu.kernels.limits.records import AxisTask, Heading, LimitRow
from segfmu.planning.demands import require_positions
from segfmu.planning.excursions import first_excursion
from segfmu.planning.limits import Limits
from segfmu.planning.planner import plan
from segfmu.planning.request import with_states
from segfmu.planning.trajectory import Trajectory
from segfmu.planning.waypoint import Waypoint

# of the unknowns: the limits of all axes, and the states of a place
LIMITS, STATES = 3 * LimitRow.SIZE, 6


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
    bounds : ndarray, shape (29,)
        The kernels' `DriveBounds`.
    caps : ndarray, shape (3, LimitRow.SIZE)
        Largest limits allowed, 0 where there are none.
    higher : dict
        Limits above the snap, as given.
    options : dict
        Further arguments of `plan`.
    clearance : PathCheck or None
    friction : Friction
    lag : ndarray, shape (3,)
        Of the velocity loops [s].
    narrow : bool
        Whether the smaller bounds and limits of both directions hold in both.
    rests : bool
        Whether the load rests where states are free.
    allowed : ndarray, shape (3, 2), optional
        Range of the positions [m], which the profiles keep, without splines.
    """

    crane: AnyCrane
    waypoints: tuple[Waypoint, ...]
    bounds: FloatArray
    caps: FloatArray
    higher: dict[str, Any]
    options: dict[str, Any]
    clearance: PathCheck | None
    friction: Friction
    lag: FloatArray
    narrow: bool = False
    rests: bool = False
    allowed: FloatArray | None = None

    @cached_property
    def positions(self) -> FloatArray:
        """Of the waypoints, shape (waypoints, 3)."""
        return np.array([p.position for p in self.waypoints])

    @cached_property
    def _route(self) -> tuple[FloatArray, ...]:
        """States with rest where they are free, places, unknown states, `led`, `heading`."""
        states, place = np.array([p.planned for p in self.waypoints]), np.zeros(len(self.waypoints))
        backend.unite_waypoints(states, place)
        kinds = np.zeros(LIMITS + STATES * max(int(place[-1]) - 1, 0))
        led = np.zeros((len(place), 3))
        heading = np.zeros(Heading.SIZE)
        backend.write_heading(self._first_of(place), heading)
        backend.write_free(states, place, self._dwells, heading, kinds, led)
        return states, place, kinds, led, heading

    @cached_property
    def _dwells(self) -> FloatArray:
        return np.array([p.dwell for p in self.waypoints])

    @property
    def states(self) -> FloatArray:
        """Positions, velocities and accelerations, shape (waypoints, 3, 3); 0 where free."""
        return self._route[0]

    @property
    def place(self) -> FloatArray:
        """The place of each waypoint, from 0."""
        return self._route[1]

    @property
    def heading(self) -> FloatArray:
        """The kernels' `Heading`."""
        return self._route[4]

    @property
    def led(self) -> FloatArray:
        """1 where a velocity or acceleration is searched for, shape (waypoints, 3)."""
        return np.zeros_like(self._route[3]) if self.rests else self._route[3]

    @property
    def chooses(self) -> bool:
        """Whether states are searched for."""
        return bool(self.led.any())

    @cached_property
    def resting(self) -> tuple[Waypoint, ...]:
        """The waypoints with rest in place of free states."""
        return with_states(self.waypoints, self.states, self._dwells)

    @cached_property
    def resistance(self) -> FloatArray:
        """The kernels' `Resistance`."""
        return resistance(self.crane, self.friction, self.lag)

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
        velocities, accelerations = np.ascontiguousarray(np.moveaxis(self.states, 2, 0)[1:])
        backend.write_axes(
            self.narrow, self.positions, velocities, accelerations, *self._bounds, self.resistance,
            rows,
        )
        higher = np.array([[p.jerk, p.snap] for p in self.waypoints])
        first = AxisTask.FLOOR + LimitRow.JERK
        rows[:, first : first + 2] = np.abs(higher).max(axis=0).T
        return rows

    @cached_property
    def kinds(self) -> FloatArray:
        """The kernels' `Unknown` of every unknown: limits, then states of inner places."""
        kinds = self._route[2].copy() if self.chooses else np.zeros(LIMITS)
        backend.write_kinds(self.axes, kinds)
        return kinds

    @cached_property
    def places(self) -> FloatArray:
        """Positions of the places, shape (places, 3)."""
        return self._first_of(self.place)

    def _first_of(self, place: FloatArray) -> FloatArray:
        return np.ascontiguousarray(self.positions[np.unique(place, return_index=True)[1]])

    @property
    def directed(self) -> NDArray[np.bool_]:
        """Whether velocity and acceleration of an axis have limits by direction, shape (3, 2)."""
        row = slice(AxisTask.DIRECTED, AxisTask.DIRECTED + 2)
        return np.asarray(self.axes[:, row] > 0.0)

    def planned(self, unknowns: FloatArray) -> Trajectory:
        """The plan that unknowns stand for.

        Raises
        ------
        InfeasibleError
            If there is none.
        """
        table = np.zeros((3, LimitRow.SIZE))
        backend.write_limits(unknowns, self.axes, table)
        points = self.resting
        if self.chooses:
            states = self.states.copy()
            backend.write_states(unknowns, self.kinds, table, self.place, self.heading, states)
            points = with_states(self.waypoints, states, self._dwells)
        found = plan(points, self._limits(table), **self.options)
        if self.allowed is not None:
            require_positions(found, self.allowed)
        return found

    def require_taut(self, trajectory: Trajectory) -> None:
        """Refuse a plan whose rope goes slack or leaves its range."""
        model_of(self.crane).require_taut(self.crane, trajectory)

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
        found = first_excursion(trajectory, self.led) if self.chooses else None
        if found is not None:
            raise InfeasibleError(str(found), axis=found.axis, interval=found.interval)

    def allows(self, trajectory: Trajectory) -> bool:
        """Whether a path may be taken."""
        try:
            self.require_path(trajectory)
        except InfeasibleError:
            return False
        return True
