"""Where the load of a page may go, and how fast."""

from __future__ import annotations

from collections.abc import Sequence
from math import isfinite

import numpy as np

from segfmu.arrays import FloatArray
from segfmu.crane import ActuatorBounds, plan_actuated
from segfmu.planning import Limits, Trajectory, Waypoint
from segfmu.planning.limits import LOWER
from segfmu.validation.files.keys import AXES
from segfmu.validation.files.mission import Mission
from segfmu.validation.files.objects import LIMITS

# of the greatest extent of the mission's path: room beside it where nothing else bounds the load
ROOM = 0.5
# of a range: what stays free before an end stop, for what wind and feedback add
STOP = 0.02
# of the longest rope: what stays free, for a load that swings is higher than the rope is long
SWUNG = 0.03
# of a drive's velocity: what the load may have, for the carriage is faster than the load at times
SHARE = 0.95
# of the room: the ends of the move whose limits the load has where the mission has none
FIRST, LAST = 0.2, 0.8
# s; from standstill to the speed, and over the path, where neither limits nor drives tell more
RISE, ACROSS = 2.0, 5.0


def space(mission: Mission, trajectory: Trajectory) -> FloatArray:
    """Least and greatest positions of the load [m], shape (3, 2).

    They are the mission's workspace, within the end stops and the rope; where these leave an axis
    open, the surroundings of the mission's path.
    """
    low, high = trajectory.extrema(0)
    room = ROOM * max(float((high - low).max()), float(-low[2]))
    found = np.column_stack([low - room, high + room])
    # the load hangs below the trolley
    found[2, 1] = min(found[2, 1], 0.5 * high[2])
    travel, crane = mission.crane.travel, mission.crane
    for axis, stops in enumerate((travel.bridge, travel.trolley)):
        if stops is not None:
            margin = STOP * (stops[1] - stops[0])
            found[axis] = _inside(found[axis], stops[0] + margin, stops[1] - margin)
    shortest, longest = travel.rope or (0.0, np.inf)
    longest = min(longest, crane.rope_max or np.inf)
    shortest = max(shortest, crane.rope_min or 0.0)
    if isfinite(longest):
        found[2, 0] = -(1.0 - SWUNG) * longest
    if shortest > 0.0:
        found[2, 1] = -shortest * (1.0 + SWUNG)
    for axis, name in enumerate(AXES):
        own = getattr(mission.workspace, name)
        if own is not None:
            found[axis] = _tightened(found[axis], own)
    # the mission's own path is always in it
    return np.column_stack([np.minimum(found[:, 0], low), np.maximum(found[:, 1], high)])


def _inside(given: FloatArray, low: float, high: float) -> FloatArray:
    return np.array([max(given[0], low), min(given[1], high)])


def _tightened(given: FloatArray, own: Sequence[float | None]) -> FloatArray:
    """The mission's range takes the place of one that only follows from the path."""
    return np.array([given[i] if end is None else end for i, end in enumerate(own)])


def limits(mission: Mission, trajectory: Trajectory, room: FloatArray) -> Limits:
    """Limits of the load under a joystick: the mission's.

    Where it leaves them to the drives, those of its plan say nothing of an axis that rests. So they
    are those of the fastest moves across the room, of each axis alone and of all at once.
    """
    bounds = mission.build_bounds()
    if mission.limits is not None or bounds is None:
        return trajectory.limits
    low, high = (room[:, 0] + share * (room[:, 1] - room[:, 0]) for share in (FIRST, LAST))
    alone = [_found(mission, bounds, low, np.where(np.arange(len(AXES)) == axis, high, low))[axis]
             for axis in range(len(AXES))]
    found = np.minimum(alone, _found(mission, bounds, low, high))
    found[:, 0] = np.minimum(found[:, 0], SHARE * np.broadcast_to(bounds.velocity, len(AXES)))
    return Limits(*found.T)


def _found(
    mission: Mission, bounds: ActuatorBounds, first: FloatArray, last: FloatArray
) -> FloatArray:
    """Limits of velocity to snap, of both directions, of the fastest move; shape (3, 4)."""
    found = plan_actuated(
        mission.build_crane(), [Waypoint(first), Waypoint(last)], None, bounds,
        smoothness=mission.smoothness, shape=mission.shape, synchronize=mission.synchronization,
        friction=mission.build_friction(),
    ).trajectory.limits
    table = found.table(len(AXES), mission.smoothness)[:, : len(LIMITS)]
    rows = np.where(table > 0.0, table, np.inf)
    rows[:, : len(LOWER)] = np.minimum(rows[:, : len(LOWER)], found.lower(len(AXES)))
    return rows


def speeds(mission: Mission, trajectory: Trajectory, own: Limits) -> FloatArray:
    """Velocity [m/s] that a joystick at its end commands, and the acceleration [m/s2] of the plain
    ramp to it, of each axis; shape (2, 3). `own` are the limits under a joystick.

    The velocity is the load's limit, below that of the drive; the ramp has the drive's
    acceleration, where it is known.
    """
    bounds = mission.build_bounds() or ActuatorBounds()
    table = own.table(len(AXES), mission.smoothness)
    low, high = trajectory.extrema(0)
    extent = max(float((high - low).max()), 1e-3 * float(-low[2]))
    found = np.empty((2, len(AXES)))
    for axis in range(len(AXES)):
        velocity = min(table[axis, 0] or np.inf, SHARE * float(bounds.velocity[axis]))
        found[0, axis] = velocity if isfinite(velocity) else extent / ACROSS
        rate, limit = float(bounds.acceleration[axis]), table[axis, 1]
        rate = rate if isfinite(rate) else limit
        found[1, axis] = rate if isfinite(rate) and rate > 0.0 else found[0, axis] / RISE
    return found
