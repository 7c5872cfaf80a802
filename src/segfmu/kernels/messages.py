"""Messages for the statuses and reports of the kernels; each message is stated here only.

A text names fields of the kernel's report in braces: `{VALUE:.6g}` is a number, `{INTERVAL+1}` an
integer counted from 1, `{AXIS}` a word if the table has words for that field. Python formats the
texts itself; for C, `python -m segfmu.codegen` writes c/messages.c from them.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from segfmu.kernels.clearance.records import Excursion, PathStatus, SpaceFault, SpaceStatus
from segfmu.kernels.crane.records import (
    AXES,
    DRIVES,
    BoundFault,
    BoundStatus,
    PlantFault,
    PlantStatus,
    RopeDemand,
    RopeFault,
    State,
)
from segfmu.kernels.limits.records import LimitFault, LimitStatus
from segfmu.kernels.numerics.records import AccessFault, AccessStatus, RangeFault, RangeStatus
from segfmu.kernels.operation.records import OperationStatus, ReadyFault, ReadyStatus
from segfmu.kernels.planner.records import PlanStatus, Refusal
from segfmu.kernels.records import Record
from segfmu.kernels.rig.records import (
    Delay,
    SensorLimits,
    SetupFault,
    SetupStatus,
    StartFault,
    StartStatus,
)

PLACE = re.compile(r"\{([A-Z_]+)(?:\+(\d))?(?::((?:\.\d+)?[fg]))?\}")


@dataclass(frozen=True)
class Messages:
    """Texts by status.

    Attributes
    ----------
    name : str
        Of the function in C.
    report : type of Record
        The texts name its fields.
    texts : dict of int to str
    words : dict of str to tuple of str
        Words in place of the numbers of a field.
    """

    name: str
    report: type[Record]
    texts: Mapping[int, str]
    words: Mapping[str, tuple[str, ...]] = field(default_factory=dict)

    def text(self, status: int, report: Sequence[float], **words: tuple[str, ...]) -> str:
        """The message of a status; `words` override those of the table."""
        named = {**self.words, **words}

        def value(place: re.Match[str]) -> str:
            name, added, form = place.groups()
            number = report[getattr(self.report, name)]
            if name in named:
                return named[name][int(number)]
            return format(number, form) if form else str(int(number) + int(added or 0))

        return PLACE.sub(value, self.texts[status])


_INTERVAL = "axis {AXIS}, waypoints {INTERVAL+1} -> {INTERVAL+2}: "
_BRAKING = (
    " acceleration {VALUE:.6g} m/s2 exceeds the velocity limit {BOUND:.6g} m/s; lower the velocity "
    "or the acceleration of waypoint "
)


def _beyond(name: str, unit: str) -> str:
    return (
        f"axis {{AXIS}}, waypoint {{INTERVAL+1}}: {name} {{VALUE:.6g}} {unit} exceeds the limit "
        f"{{BOUND:.6g}} {unit}; raise limits.{name}{{SIDE}} or lower the waypoint's {name}"
    )


def _limit(name: str) -> str:
    return f"limits.{{AXIS}}.{name} must be greater than 0, got {{VALUE:g}}"


PLAN = Messages(
    "plan", Refusal,
    {
        PlanStatus.START_BRAKING: f"{_INTERVAL}braking the first{_BRAKING}{{INTERVAL+1}} or raise "
        "limits.velocity{SIDE}",
        PlanStatus.END_BRAKING: f"{_INTERVAL}building up the last{_BRAKING}{{INTERVAL+2}} or raise "
        "limits.velocity{SIDE}",
        PlanStatus.NO_PROFILE: f"{_INTERVAL}no profile within the limits was found; raise the "
        "limits or change the velocities of the two waypoints",
        PlanStatus.NO_COMMON_DURATION: "waypoints {INTERVAL+1} -> {INTERVAL+2}: no common duration "
        "of the axes was found; change the velocities of waypoint {INTERVAL+2} or set the "
        "synchronization to none",
        PlanStatus.DURATION_TOO_SHORT: "duration {BOUND:.9g} s is shorter than the shortest plan, "
        "{VALUE:.9g} s; raise duration or the limits",
        PlanStatus.DURATION_IN_GAP: "axis {AXIS}: the motion between moving waypoints cannot be "
        "prolonged to exactly {VALUE:.9g} s; change the duration, let waypoints rest, or set the "
        "synchronization to waypoints",
        PlanStatus.SAMPLE_TIME: "sample_time must be from 1e-9 to 1e6 s, or 0 for none, "
        "got {VALUE:g} s",
        PlanStatus.WAYPOINT_VELOCITY: _beyond("velocity", "m/s"),
        PlanStatus.WAYPOINT_ACCELERATION: _beyond("acceleration", "m/s2"),
        PlanStatus.UNBOUNDED_RAMP: "axis {AXIS}: no limit bounds the duration of an acceleration "
        "ramp; give limits.jerk or a higher one",
        PlanStatus.MOVING_DWELL: "axis {AXIS}, waypoint {INTERVAL+1}: a dwell needs a waypoint at "
        "rest; omit its velocity and acceleration, or the dwell",
        PlanStatus.OUT_OF_RANGE: "the number of waypoints, an option of the planner, or a limit, a "
        "position or a dwell is out of range",
        PlanStatus.CHECK_FAILED: "the plan breaks a limit or misses a waypoint by more than 1e-9 "
        "(relative): the problem is badly scaled; choose limits and distances of similar size",
        PlanStatus.NO_VELOCITY_LIMIT: _limit("velocity"),
        PlanStatus.NO_ACCELERATION_LIMIT: _limit("acceleration"),
    },
    {"AXIS": ("x", "y", "z"), "SIDE": ("", "_min")},
)


def _rope(name: str, unit: str, limit: str, remedy: str) -> str:
    return (
        f"at {{TIME:.3f}} s: {name} passes {limit}, {{BOUND:.6g}} {unit}, and reaches "
        f"{{WORST:.6g}} {unit}; {remedy}"
    )


# what `InfeasibleError.limit` says
ROPE_LIMITS = {
    RopeDemand.BELOW_TROLLEY: "the trolley's height",
    RopeDemand.TAUT: "gravity, where the rope goes slack",
    RopeDemand.NOT_TOO_LONG: "rope_max",
    RopeDemand.NOT_TOO_SHORT: "rope_min",
    RopeDemand.ALL_TAUT: "gravity, where the rope goes slack",
    RopeDemand.END_BELOW_TROLLEY: "the trolley's height",
}
ROPE = Messages(
    "rope", RopeFault,
    {
        status: _rope(name, unit, ROPE_LIMITS[status], remedy)
        for status, name, unit, remedy in (
            (RopeDemand.BELOW_TROLLEY, "load height z", "m", "lower the waypoints"),
            (RopeDemand.TAUT, "downward acceleration of the load", "m/s2",
             "lower limits.z.acceleration"),
            (RopeDemand.NOT_TOO_LONG, "rope length", "m", "raise the waypoints or rope_max"),
            (RopeDemand.NOT_TOO_SHORT, "rope length", "m", "lower the waypoints or rope_min"),
            (RopeDemand.ALL_TAUT, "downward acceleration of all on the rope", "m/s2",
             "lower limits.z.acceleration"),
            (RopeDemand.END_BELOW_TROLLEY, "height z of the rope's end", "m",
             "lower the waypoints"),
        )
    },
)


def _bound(name: str, unit: str, remedy: str) -> str:
    return (
        f"at {{TIME:.3f}} s: the plan needs {{VALUE:.9g}} {unit}, {name} is {{BOUND:.9g}} {unit}; "
        f"lower limits.{{AXIS}}{remedy}, move the waypoints, or raise the bound"
    )


# behind the start of the plan, where it exceeds a bound of the drives
def _slow(name: str, unit: str) -> str:
    return (
        f"axis {{AXIS}}: {{DRIVE}} {name}{{SIDE}} must have a bound of at least 1e-05 {unit}, got "
        f"{{VALUE:g}} {unit}; raise the bound"
    )


LIMIT = Messages(
    "limit", LimitFault,
    {
        LimitStatus.UNBOUNDED: "axis {AXIS}: nothing bounds the acceleration; give a bound of the "
        "{DRIVE}'s acceleration, force or power, or limits of the load",
        LimitStatus.SLOW_VELOCITY: _slow("velocity", "m/s"),
        LimitStatus.SLOW_ACCELERATION: _slow("acceleration", "m/s2"),
    },
    {"AXIS": ("x", "y", "z"), "DRIVE": DRIVES, "SIDE": ("", "_min")},
)
BOUND = Messages(
    "bound", BoundFault,
    {
        status: _bound(f"drive.{{DRIVE}}.{name}_{{SIDE}}", unit, remedy)
        for status, name, unit, remedy in (
            (BoundStatus.FORCE, "force", "N", " or the masses"),
            (BoundStatus.VELOCITY, "velocity", "m/s", ""),
            (BoundStatus.ACCELERATION, "acceleration", "m/s2", ""),
            (BoundStatus.POWER, "power", "W", " or the masses"),
        )
    } | {
        BoundStatus.SWAY: _bound("sway.{AXIS}.angle_max", "rad", ""),
        BoundStatus.TRAVEL: "at {TIME:.3f} s: the plan takes the {STOPPED} to {VALUE:.9g} m, "
        "beyond its end stop travel.{STOPPED}.{SIDE} at {BOUND:.9g} m; move the waypoints, or "
        "lower their velocities and accelerations along {AXIS}",
    },
    {"DRIVE": DRIVES, "AXIS": ("x", "y", "z"), "STOPPED": AXES, "SIDE": ("max", "min")},
)


def _meets(part: str) -> str:
    return (
        f"obstacle {{BOX+1}}: the {part} meets it from {{BEGIN:.3f}} s to {{END:.3f}} s, first at "
        "({X:.4g}, {Y:.4g}, {Z:.4g}) m; lead the waypoints past it at more distance or above it"
    )


_EMPTY = "must be below its maximum {BOUND:.15g} m, got {VALUE:.15g} m"

# behind the start of the plan
PATH = Messages(
    "path", Excursion,
    {
        PathStatus.EXCURSION: "between waypoints {INTERVAL+1} and {INTERVAL+2} the path leaves the "
        "box of both by {DISTANCE:.4g} m along {AXIS}, from {TIME:.3f} s",
    },
    {"AXIS": ("x", "y", "z")},
)
SPACE = Messages(
    "space", SpaceFault,
    {
        SpaceStatus.LOAD: _meets("load"),
        SpaceStatus.ROPE: _meets("rope"),
        SpaceStatus.WORKSPACE: "workspace.{AXIS}: the load leaves its end at {BOUND:.9g} m from "
        "{BEGIN:.3f} s to {END:.3f} s; move the waypoints or give them lower velocities",
        SpaceStatus.EMPTY_WORKSPACE: f"workspace.{{AXIS}}: minimum {_EMPTY}",
        SpaceStatus.SLING: "obstacle[{BOX+1}]: the rope above a sling, and the sling itself, are "
        "not judged; set obstacle[{BOX+1}].rope to false, and let the margin keep them off",
        SpaceStatus.EMPTY_OBSTACLE: f"obstacle[{{BOX+1}}]: minimum.{{AXIS}} {_EMPTY}",
    },
    {"AXIS": ("x", "y", "z")},
)


def _angles(of: str) -> tuple[str, ...]:
    return tuple(f"{of}.{axis}.angle" for axis in "xy")


def _out_of_range(reason: str) -> str:
    return f"at {{TIME:.3f}} s: {reason}; check setpoints, wind, masses and friction"


def _stopped(kind: str) -> str:
    return (
        f"at {{TIME:.3f}} s: {{AXIS}} at {{POSITION:.6g}} m is at its end stop, {kind} position "
        "{STOP:.6g} m; shorten the move, brake earlier or widen the travel limits"
    )


PLANT = Messages(
    "plant", PlantFault,
    {
        PlantStatus.SWAY_ANGLE: "at {TIME:.3f} s: {SWAY} reached {ANGLE:.4g} rad, with "
        "{POSITION:.4g} m of rope; the crane is known up to 90 degrees; check setpoints, feedback, "
        "wind, masses, friction, and where the load begins",
        PlantStatus.ROPE_LENGTH: _out_of_range("the rope length reached zero"),
        PlantStatus.STEP_TOO_SMALL: _out_of_range("the integration steps became too small"),
        PlantStatus.NOT_FINITE: _out_of_range("a value is not finite"),
        PlantStatus.SLACK_ROPE: _out_of_range("the rope went slack"),
        PlantStatus.SLACK_SLING: _out_of_range("the sling went slack"),
        PlantStatus.BELOW_TRAVEL: _stopped("least"),
        PlantStatus.ABOVE_TRAVEL: _stopped("greatest"),
    },
    {"AXIS": AXES, "SWAY": (*_angles("sway"), *_angles("sling"))},
)

# of commands that are followed while it runs
READY = Messages(
    "ready", ReadyFault,
    {
        ReadyStatus.DEAD_TIME: "drive.{DRIVE}.dead_time is {VALUE:g} s: no command can be followed "
        "with a drive that acts late; set it to 0, or command.enabled to false",
        ReadyStatus.FRICTION: "friction.{DRIVE}: no command can be followed with Coulomb or static "
        "friction; set both to 0, or command.enabled to false",
        ReadyStatus.PIECES: "the plan has {VALUE:.0f} polynomial pieces, too many for commands; "
        "use fewer waypoints, or set command.enabled to false",
    },
    {"DRIVE": DRIVES},
)

# of a measured state in which a motion is to begin
TAKEOVER = Messages(
    "takeover", ReadyFault,
    {
        OperationStatus.ROPE: "command.take_over: measured.* with a rope of {VALUE:g} m is no "
        "state of a load below its crane, or the way from there to rest leaves the range of the "
        "rope; give all ten values, or widen crane.rope_min and crane.rope_max",
        OperationStatus.WORKSPACE: "command.take_over: the way from the measured state to rest "
        "leaves the workspace, or is beyond 1e6 m, where targets end; widen workspace.*, move the "
        "origin, or let the swing decay",
        OperationStatus.OBSTACLE: "command.take_over: the way from the measured state to rest "
        "meets an obstacle; move that, or let the swing decay",
        OperationStatus.TRAVEL: "command.take_over: the way from the measured state to rest "
        "passes an end stop; widen travel.*, or let the swing decay",
        OperationStatus.DRIVES: "command.take_over: the drives cannot bring the load to rest from "
        "the measured state; give drive.*.acceleration_max, more of it, or let the swing decay",
    },
)

SETUP = Messages(
    "setup", SetupFault,
    {
        SetupStatus.EMPTY_TRAVEL: "travel.{AXIS}: min {VALUE:.15g} m must be below max "
        "{BOUND:.15g} m",
        SetupStatus.NO_LAG: "in model exchange with drive.mode velocity, drive.{DRIVE}.lag "
        "must be above 0 s (without lag the setpoints do not determine the acceleration); "
        "set a lag, or use co-simulation",
        SetupStatus.SHORT_LAG: "drive.{DRIVE}.lag must be 0 or at least {BOUND:.15g} s, got "
        "{VALUE:.15g} s; 0 is an ideal drive",
        SetupStatus.NOT_SAMPLED: "sensor noise and dead_time need sampled signals: set "
        "sensor.sample_time above 0 s",
        SetupStatus.SHORT_SAMPLE: "sensor.sample_time must be 0 or at least {BOUND:.15g} s, got "
        "{VALUE:.15g} s",
        SetupStatus.LONG_DEAD_TIME: "sensor.dead_time {VALUE:.15g} s is longer than "
        f"{SensorLimits.MOST_SAMPLES} samples of {{BOUND:.15g}} s; lower it or raise "
        "sensor.sample_time",
        SetupStatus.LOW_STATIC: "friction.{DRIVE}.static {VALUE:.15g} N must be 0 or at least "
        "friction.{DRIVE}.coulomb {BOUND:.15g} N",
        SetupStatus.MANY_TURNS: "friction.{DRIVE}: the plan turns the {DRIVE} more often than "
        "there is memory for; drop waypoints, or set the friction to 0",
        SetupStatus.NO_WIND: "wind.turbulence.deviation {VALUE:g} m/s needs a mean speed for its "
        "spectrum: set wind.speed",
        SetupStatus.TWO_CHANGES: "two changes of the load are at {VALUE:.15g} s, and one alone can "
        "count; leave one out, or move it",
        SetupStatus.SLACK_EXCHANGE: "in model exchange rope.slack must be error, got free_fall "
        "(the slack rope has no state there); use co-simulation",
        SetupStatus.SLACK_SLING: "with a sling rope.slack must be error, got free_fall (what is "
        "below the rope has no slack rope); drop slack",
        SetupStatus.LONG_DELAY: "drive.{DRIVE}.dead_time {VALUE:.15g} s is longer than "
        f"{Delay.MOST_TICKS} periods of {{BOUND:.15g}} s; lower it or raise feedback.sample_time",
        SetupStatus.LATE_EXCHANGE: "in model exchange drive.{DRIVE}.dead_time must be 0 s, got "
        "{VALUE:.15g} s (the setpoints of the past are the importer's); delay the setpoints in the "
        "importer, or use co-simulation",
        SetupStatus.ROPE_START: "the start value of rope.length must be above 0 m, got {VALUE:g} m",
        SetupStatus.ROPE_BOUNDS: "rope_min {VALUE:.15g} m must be less than rope_max "
        "{BOUND:.15g} m",
        SetupStatus.LENGTHS: "rope lengths must be positive and ascending, got {VALUE:.15g} to "
        "{BOUND:.15g} m; set the crane's rope_min and rope_max",
        SetupStatus.OBSERVER: "the observer has no finite gains between {VALUE:g} and {BOUND:g} m "
        "of rope; check masses, lags and what it expects",
        SetupStatus.UNSTABLE: "the feedback of the {DRIVE} is unstable at {VALUE:g} m of rope: a "
        "deviation grows {BOUND:g} times in a sample; lower feedback.sample_time, or set "
        "feedback.design to flatness (for drive.{DRIVE}.lag) and feedback.source to measured (for "
        "drive.{DRIVE}.dead_time)",
    },
    {"AXIS": AXES, "DRIVE": DRIVES},
)

# behind the name of a variable
RANGE = Messages(
    "range", RangeFault,
    {
        RangeStatus.BELOW: "must be at least {LEAST:g}, got {VALUE:.15g}",
        RangeStatus.ABOVE: "must be at most {MOST:g}, got {VALUE:.15g}",
        RangeStatus.OUTSIDE: "must be at least {LEAST:g} and at most {MOST:g}, got {VALUE:.15g}",
    },
)

ACCESS = Messages(
    "access", AccessFault,
    {AccessStatus.NO_VARIABLE: "there is no variable with value reference {REFERENCE:.0f}"},
)

_FAR = "{PLACE} started at {VALUE:g}, its reference at {BOUND:g}"
_NEAR = (
    "set start.on_reference to true and connect the reference at initialisation, or start values "
    "that fit the first waypoint"
)

START = Messages(
    "start", StartFault,
    {
        StartStatus.NO_ROPE: "the start value of rope.length must be above 0 m, got {VALUE:g}; its "
        "reference starts at {BOUND:g} m, see start.on_reference",
        StartStatus.SWAY: "{PLACE} must start within 90 degrees, got {VALUE:.15g} rad",
        StartStatus.FAR: f"{_FAR}; {_NEAR}",
        StartStatus.FAILED: f"at {{TIME:.3f}} s: the crane left the range of its equations; "
        f"{_FAR}; {_NEAR}",
        StartStatus.RANGE: "{PLACE} starts at {VALUE:g} m, outside crane.rope_min and "
        "crane.rope_max, here {BOUND:g} m",
    },
    {"PLACE": tuple(v for f in State.FIELDS.values() for v in f.variables)},
)

TABLES = (
    PLAN, ROPE, LIMIT, BOUND, PATH, SPACE, READY, TAKEOVER, PLANT, SETUP, RANGE, ACCESS, START,
)
