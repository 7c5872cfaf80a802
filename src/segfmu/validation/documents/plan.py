"""What `segfmu plan --json` prints."""

from __future__ import annotations

from collections.abc import Sequence
from math import isfinite
from typing import Annotated

from segfmu.crane.bounds import BoundUse
from segfmu.planning import Trajectory
from segfmu.planning.limits import NAMES, UNITS
from segfmu.planning.verify import Verification
from segfmu.validation.documents.document import Part, ResultDocument, Text
from segfmu.validation.files.keys import Key


class Waypoint(Part):
    """A waypoint as it is planned, with the state that was chosen where it is free."""

    time_s: Annotated[float, Key("arrival of the last axis", "s")]
    dwell_s: Annotated[float, Key("time at rest there", "s")]
    position_m: Annotated[list[float], Key("of the load, in the order of `axes`", "m")]
    velocity_m_s: Annotated[list[float], Key("the same of its velocity", "m/s")]
    acceleration_m_s2: Annotated[list[float], Key("the same of its acceleration", "m/s2")]


class Peak(Part):
    """The exact extremum of a derivative of the load's position."""

    axis: Annotated[str, Key("name of the axis")]
    quantity: Annotated[str, Key("velocity, acceleration, jerk and so on")]
    unit: Annotated[str, Key("of peak and limit")]
    peak: Annotated[float, Key("largest magnitude, in the direction that uses more of its limit")]
    limit: Annotated[float | None, Key("magnitude of the limit in that direction; null: none")]


class Use(Part):
    """A known bound of the drives, and what is used of it."""

    name: Annotated[str, Key("such as `trolley force`; `_min` is the negative direction")]
    unit: Annotated[str, Key("of peak and bound")]
    peak: Annotated[float, Key("largest magnitude")]
    bound: Annotated[float, Key("magnitude of the bound")]
    use: Annotated[float, Key("peak over bound")]
    time_s: Annotated[float, Key("when the peak is reached", "s")]


class PlanDocument(ResultDocument):
    """A mission's plan."""

    mission: Annotated[Text, Key("name of the mission")]
    duration_s: Annotated[float, Key("duration of the plan", "s")]
    smoothness: Annotated[int, Key("continuous derivatives of the load's position")]
    shape: Annotated[str, Key("shape of the acceleration ramps")]
    axes: Annotated[list[str], Key("names of the axes")]
    waypoints: Annotated[list[Waypoint], Key("all waypoints in their order")]
    limits_found: Annotated[bool, Key("whether the limits follow from the bounds of the drives")]
    peaks: Annotated[list[Peak], Key("of every derivative and axis")]
    drives: Annotated[list[Use], Key("use of the known bounds of the drives; empty: none is known")]
    notes: Annotated[list[str], Key("what to know of the plan, a sentence each")]
    files: Annotated[list[Text], Key("that were written")]


def plan_document(
    name: str, trajectory: Trajectory, found: Verification, uses: Sequence[BoundUse], *,
    limits_found: bool, notes: Sequence[str], files: Sequence[str],
) -> PlanDocument:
    """The document of a plan."""
    return PlanDocument(
        mission=name, duration_s=trajectory.duration, smoothness=trajectory.smoothness,
        shape=trajectory.shape, axes=list(trajectory.axis_names),
        waypoints=[
            Waypoint(
                time_s=float(time), dwell_s=point.dwell, position_m=point.position.tolist(),
                velocity_m_s=point.velocity.tolist(),
                acceleration_m_s2=point.acceleration.tolist(),
            )
            for time, point in zip(trajectory.waypoint_times, trajectory.waypoints, strict=True)
        ],
        limits_found=limits_found,
        peaks=[
            Peak(
                axis=axis, quantity=NAMES[order], unit=UNITS[order],
                peak=float(found.peaks[order, i]), limit=_finite(found.limits[order, i]),
            )
            for order in range(trajectory.smoothness)
            for i, axis in enumerate(trajectory.axis_names)
        ],
        drives=bound_uses(uses), notes=list(notes), files=list(files),
    )


def bound_uses(uses: Sequence[BoundUse]) -> list[Use]:
    """Those of known bounds."""
    return [
        Use(name=one.name, unit=one.unit, peak=one.peak, bound=one.bound, use=one.use,
            time_s=one.time)
        for one in uses if isfinite(one.bound)
    ]


def _finite(value: float) -> float | None:
    return float(value) if isfinite(value) else None
