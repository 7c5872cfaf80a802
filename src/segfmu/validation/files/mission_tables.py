"""Tables of a mission file."""

from __future__ import annotations

from sys import float_info
from typing import Annotated, Any, Literal

from pydantic import BeforeValidator, Field, StrictBool

from segfmu.validation.files.keys import (
    AXES,
    DRIVES,
    NUMBER,
    SWAY,
    BoundTriple,
    Key,
    LowerBoundTriple,
    Place,
    Positive,
    SwayPair,
    Table,
    Time,
    Triple,
)

# of limits, durations between waypoints, and periods
Limit = Annotated[float, Field(ge=1e-6, le=1e6), NUMBER]
# in the negative direction
LowerLimit = Annotated[float, Field(ge=-1e6, le=-1e-6), NUMBER]
# of the higher derivatives
HighLimit = Annotated[float, Field(ge=1e-6, le=1e12), NUMBER]
LARGEST = float_info.max
Angle = Annotated[float, Field(ge=-45.0, le=45.0), NUMBER]


def _state(value: Any) -> Any:
    """Refuse what is neither numbers nor "free" here, so that the message does not list types."""
    if value == "free" and isinstance(value, str):
        return value
    if not isinstance(value, list) or len(value) != len(AXES) or not all(map(_finite, value)):
        raise ValueError('must be three numbers or "free"')
    return value


def _finite(value: Any) -> bool:
    number = isinstance(value, int | float) and not isinstance(value, bool)
    # an integer may be larger than any float
    return number and -LARGEST <= value <= LARGEST


State = Annotated[Triple | Literal["free"], BeforeValidator(_state)]
REST = "at rest"
CHOSEN = (
    '"free": the planner chooses it; at the first and the last waypoint, and at one with a dwell, '
    "it chooses rest"
)
CRANES = "that of the crane file"
SAME = "minus the greatest"


class AxisLimits(Table):
    """Limits of one axis."""

    velocity: Annotated[Limit, Key("greatest velocity of the load", "m/s")]
    acceleration: Annotated[Limit, Key("greatest acceleration of the load", "m/s2")]
    jerk: Annotated[
        HighLimit | None, Key("greatest jerk of the load", "m/s3", default="no limit")
    ] = None
    snap: Annotated[
        HighLimit | None, Key("greatest snap of the load", "m/s4", default="no limit")
    ] = None
    velocity_min: Annotated[
        LowerLimit | None,
        Key("least velocity of the load, below 0", "m/s", default="minus `velocity`"),
    ] = None
    acceleration_min: Annotated[
        LowerLimit | None,
        Key("least acceleration of the load, below 0", "m/s2", default="minus `acceleration`"),
    ] = None

    def lower(self, quantity: str) -> float:
        """Limit of velocity or acceleration in the negative direction, below zero."""
        given = getattr(self, f"{quantity}_min")
        return float(-getattr(self, quantity) if given is None else given)


class LimitsTable(Table):
    """Limits of the three axes."""

    x: Annotated[AxisLimits, Key("limits along x")]
    y: Annotated[AxisLimits, Key("limits along y")]
    z: Annotated[AxisLimits, Key("limits along z")]


class WaypointEntry(Table):
    """One waypoint."""

    position: Annotated[Place, Key("of the load; z is negative, 0 at the trolley", "m", parts=AXES)]
    velocity: Annotated[
        State,
        Key(f'velocity of the load; {CHOSEN}', "m/s", default=REST,
            parts=AXES),
    ] = [0.0, 0.0, 0.0]
    acceleration: Annotated[
        State,
        Key(f'acceleration of the load; {CHOSEN}', "m/s2", default=REST,
            parts=AXES),
    ] = [0.0, 0.0, 0.0]
    dwell: Annotated[Time, Key("time to rest there", "s")] = 0.0


class ActuatorEntry(Table):
    """Bounds of this mission alone, beside those of the crane file."""

    force: Annotated[
        BoundTriple | None,
        Key("greatest of each drive", "N", default=CRANES, parts=DRIVES),
    ] = None
    velocity: Annotated[
        BoundTriple | None,
        Key("greatest of each drive", "m/s", default=CRANES, parts=DRIVES),
    ] = None
    acceleration: Annotated[
        BoundTriple | None,
        Key("greatest of each drive", "m/s2", default=CRANES, parts=DRIVES),
    ] = None
    force_min: Annotated[
        LowerBoundTriple | None,
        Key("least of each drive, below 0", "N", default=SAME, parts=DRIVES),
    ] = None
    velocity_min: Annotated[
        LowerBoundTriple | None,
        Key("least of each drive, below 0", "m/s", default=SAME, parts=DRIVES),
    ] = None
    acceleration_min: Annotated[
        LowerBoundTriple | None,
        Key("least of each drive, below 0", "m/s2", default=SAME, parts=DRIVES),
    ] = None
    power: Annotated[
        BoundTriple | None,
        Key("greatest of each drive, driving or braking", "W", default=CRANES, parts=DRIVES),
    ] = None
    sway_angle: Annotated[
        SwayPair | None, Key("greatest sway angles", "deg", default=CRANES, parts=SWAY)
    ] = None


class SimulationEntry(Table):
    """How `segfmu simulate` runs the mission."""

    step: Annotated[
        Annotated[float, Field(ge=1e-6, le=0.1), NUMBER], Key("communication step", "s")
    ] = 0.001
    output_step: Annotated[
        Annotated[float, Field(ge=1e-6, le=1e6), NUMBER] | None,
        Key("time between the rows of plan.csv and run.csv", "s",
            default="`step`, or as long as makes 20000 rows"),
    ] = None
    settle: Annotated[Time, Key("time behind the end of the plan", "s")] = 3.0
    feedback: Annotated[
        StrictBool | None, Key("whether the feedback acts", default="controller.enabled")
    ] = None
    feedback_source: Annotated[
        Literal["state", "measured"] | None,
        Key("what the feedback knows", default="controller.source"),
    ] = None
    drive: Annotated[
        Literal["force", "velocity"] | None, Key("what the drives follow", default="drive")
    ] = None
    initial_sway: Annotated[
        Annotated[list[Angle], Field(min_length=2, max_length=2)],
        Key("sway angles at the start, of the rope and of a sling", "deg", parts=SWAY),
    ] = [0.0, 0.0]
    tracking_tolerance: Annotated[
        Positive, Key("largest distance of the load from its plan", "m")
    ] = 0.001
    sway_tolerance: Annotated[
        Positive,
        Key("largest sway angle, of the rope and of a sling, after the end of the plan", "deg"),
    ] = 0.02
