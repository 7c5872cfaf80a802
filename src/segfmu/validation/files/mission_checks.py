"""What no single key of a mission shows."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from segfmu.errors import InputError
from segfmu.kernels.crane.rope import least_depth
from segfmu.validation.files.keys import AXES

if TYPE_CHECKING:
    from segfmu.validation.files.mission import Mission
    from segfmu.validation.files.mission_tables import LimitsTable, WaypointEntry


def check_waypoints(mission: Mission) -> None:
    """Check the waypoints against the limits and the crane.

    Raises
    ------
    InputError
        For the first key that does not fit, without the name of the file.
    """
    points = mission.waypoints
    for i, entry in enumerate(points, 1):
        if mission.limits is not None:
            _check_limits(mission.limits, i, entry)
        if entry.position[2] > -least_depth():
            raise InputError(
                f"waypoints.{i}.position: z {entry.position[2]} m must be below the trolley, "
                f"z <= {-least_depth():g}"
            )
        moving = next(_moving(entry), None)
        if entry.dwell > 0.0 and moving:
            raise InputError(f"waypoints.{i}.dwell: only a waypoint at rest can have a dwell")
        if moving and i in (1, len(points)):
            which = "first" if i == 1 else "last"
            raise InputError(
                f"waypoints.{i}.{moving}: the {which} waypoint must be at rest, got "
                f"{getattr(entry, moving)}; add a waypoint or omit the key"
            )
        if not moving:
            _check_travel(mission, i, entry)


def _check_limits(table: LimitsTable, i: int, entry: WaypointEntry) -> None:
    for axis, name in enumerate(AXES):
        limits = getattr(table, name)
        for quantity, unit in (("velocity", "m/s"), ("acceleration", "m/s2")):
            state = getattr(entry, quantity)
            value = 0.0 if state == "free" else state[axis]
            bound, key = getattr(limits, quantity), quantity
            if value < 0.0 and limits.lower(quantity) != -bound:
                bound, key = limits.lower(quantity), f"{quantity}_min"
            if abs(value) > abs(bound):
                raise InputError(
                    f"waypoints.{i}.{quantity}: axis {name}: {value} {unit} exceeds "
                    f"limits.{name}.{key} {bound} {unit}"
                )


def _check_travel(mission: Mission, i: int, entry: WaypointEntry) -> None:
    """A load at rest hangs below its trolley, which the end stops of the crane have to admit."""
    x, y, z = entry.position
    rope = -z - mission.build_crane().tackle[1]
    for axis, name, place in zip(AXES, ("bridge", "trolley", "rope"), (x, y, rope), strict=True):
        stops = getattr(mission.crane.travel, name)
        if stops is not None and not stops[0] <= place <= stops[1]:
            raise InputError(
                f"waypoints.{i}.position, {axis}: {entry.position[AXES.index(axis)]} m takes the "
                f"{name} to {place} m, beyond its end stops at {stops[0]} m and {stops[1]} m "
                f"(travel.{name} of the crane)"
            )


def _moving(entry: WaypointEntry) -> Iterator[str]:
    """The quantities that are given and not zero."""
    for name in ("velocity", "acceleration"):
        state = getattr(entry, name)
        if state != "free" and any(state):
            yield name
