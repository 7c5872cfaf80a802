"""Where a path leaves the box of the waypoints that it joins."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from segfmu.arrays import FloatArray
from segfmu.kernels import backend
from segfmu.kernels.clearance.records import Excursion as Row
from segfmu.kernels.clearance.records import PathStatus
from segfmu.kernels.crane.records import RopeWork
from segfmu.kernels.messages import PATH
from segfmu.planning.trajectory import Trajectory, require_plan


@dataclass(frozen=True)
class Excursion:
    """A part of the path outside the box of its two waypoints, along one axis.

    Attributes
    ----------
    interval : int
        Waypoint interval, from 1.
    axis : int
    distance : float
        Farthest from the box [m].
    time : float
        When the path leaves the box [s].
    name : str
        Of the axis.
    """

    interval: int
    axis: int
    distance: float
    time: float
    name: str

    def __str__(self) -> str:
        row = np.zeros(Row.SIZE)
        row[Row.INTERVAL] = self.interval - 1
        row[Row.DISTANCE], row[Row.TIME] = self.distance, self.time
        return str(PATH.text(PathStatus.EXCURSION, row.tolist(), AXIS=(self.name,)))


def excursions(trajectory: Trajectory) -> tuple[Excursion, ...]:
    """All excursions of a path, interval after interval; none is usual from rest to rest.

    Parameters
    ----------
    trajectory : Trajectory

    Returns
    -------
    tuple of Excursion
        One for each interval and axis that leaves the box.

    Raises
    ------
    InputError
        If it is not a Trajectory.
    """
    require_plan(trajectory)
    found = []
    for interval in range(1, len(trajectory.waypoints)):
        for axis in range(trajectory.axes):
            one = excursion(trajectory, interval, axis)
            if one is not None:
                found.append(one)
    return tuple(found)


def excursion(trajectory: Trajectory, interval: int, axis: int) -> Excursion | None:
    """The excursion of one axis between waypoints `interval` and `interval + 1`, if any."""
    begin, end = trajectory.axis_waypoint_times[interval - 1 : interval + 1, axis].tolist()
    ends = [float(w.position[axis]) for w in trajectory.waypoints[interval - 1 : interval + 1]]
    found = np.zeros(Row.SIZE)
    leaves = backend.leaves_range(
        axis, begin, end, min(ends), max(ends), *_pieces(trajectory), found
    )
    return _named(trajectory, interval, axis, found) if leaves else None


def first_excursion(trajectory: Trajectory, led: FloatArray) -> Excursion | None:
    """The first one beside the waypoints and axes in `led`, shape (waypoints, axes), above 0."""
    positions = np.array([w.position for w in trajectory.waypoints])
    found = np.zeros(Row.SIZE)
    status = backend.path_excursion(
        led, positions, trajectory.axis_waypoint_times, *_pieces(trajectory), found
    )
    if status == PathStatus.INSIDE:
        return None
    return _named(trajectory, 1 + int(found[Row.INTERVAL]), int(found[Row.AXIS]), found)


def _pieces(trajectory: Trajectory) -> tuple[FloatArray, FloatArray, NDArray[np.int64], FloatArray]:
    """Pieces as the kernels take them, and work space."""
    work = np.zeros((RopeWork.SIZE, 4 * trajectory.coefficients.shape[1] - 5))
    return trajectory.timing, trajectory.coefficients, trajectory.offsets, work


def _named(trajectory: Trajectory, interval: int, axis: int, found: FloatArray) -> Excursion:
    return Excursion(
        interval, axis, float(found[Row.DISTANCE]), float(found[Row.TIME]),
        trajectory.axis_names[axis],
    )
