"""Where a path leaves the box of the waypoints that it joins."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from segfmu.planning.passages import ROUNDING, both, outside, rounding, turns, within
from segfmu.planning.polynomials import hulls
from segfmu.planning.trajectory import Trajectory, require_plan

# of the distance between the waypoints: less is not worth a warning
SMALL = 1e-6


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
        return (
            f"between waypoints {self.interval} and {self.interval + 1} the path leaves the box of "
            f"both by {self.distance:.4g} m along {self.name}, from {self.time:.3f} s"
        )


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
    begin, end = trajectory.axis_waypoint_times[interval - 1 : interval + 1, axis]
    low, high = _box(trajectory, interval, axis)
    if _stays(trajectory, interval, axis):
        return None
    small = max(SMALL * (high - low), rounding(trajectory))
    away = both(
        outside(within(trajectory, axis, low - small, high + small), trajectory.duration),
        np.array([[begin, end]]),
    )
    away = away[away[:, 1] - away[:, 0] > ROUNDING * trajectory.duration]
    if away.size == 0:
        return None
    farthest = max(_farthest(trajectory, axis, one, two, low, high) for one, two in away)
    return Excursion(
        interval, axis, farthest, float(away[0, 0]), trajectory.axis_names[axis]
    )


def leaves(trajectory: Trajectory, interval: int, axis: int) -> bool:
    """Whether there is an excursion; faster than to find it."""
    low, high = _box(trajectory, interval, axis)
    begin, end = trajectory.axis_waypoint_times[interval - 1 : interval + 1, axis]
    starts, _, coefficients = trajectory.pieces(axis)
    places = coefficients[(starts > begin) & (starts < end), 0]
    small = 2.0 * SMALL * (high - low + np.abs(places).max(initial=0.0))
    if ((places < low - small) | (places > high + small)).any():
        return True
    return excursion(trajectory, interval, axis) is not None


def _box(trajectory: Trajectory, interval: int, axis: int) -> tuple[float, float]:
    ends = [float(w.position[axis]) for w in trajectory.waypoints[interval - 1 : interval + 1]]
    return min(ends), max(ends)


def _stays(trajectory: Trajectory, interval: int, axis: int) -> bool:
    """Whether the Bernstein hulls of the pieces already show that there is no excursion."""
    low, high = _box(trajectory, interval, axis)
    begin, end = trajectory.axis_waypoint_times[interval - 1 : interval + 1, axis]
    starts, lengths, coefficients = trajectory.pieces(axis)
    here = (starts < end) & (starts + lengths > begin)
    hull = hulls(coefficients[here], lengths[here])
    small = SMALL * (high - low)
    return bool((hull >= low - small).all() and (hull <= high + small).all())


def _farthest(
    trajectory: Trajectory, axis: int, begin: float, end: float, low: float, high: float
) -> float:
    """Largest distance from the box in an interval of time."""
    inner = turns(trajectory, axis)
    times = np.concatenate([[begin, end], inner[(inner > begin) & (inner < end)]])
    values = trajectory(times)[:, axis]
    return float(np.maximum(low - values, values - high).max())
