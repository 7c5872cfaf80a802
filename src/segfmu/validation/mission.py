"""Mission and crane files (TOML), validated; an error is one line."""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import Annotated, Any, Literal

import numpy as np
from pydantic import (
    AfterValidator,
    BaseModel,
    BeforeValidator,
    ConfigDict,
    Field,
    StrictBool,
    ValidationError,
)

from segfmu.crane import ActuatorBounds, Crane, plan_actuated
from segfmu.errors import InputError
from segfmu.planning import Limits, Trajectory, Waypoint, plan

# that the FMUs can have
MOST_WAYPOINTS = 256
AXES = ("x", "y", "z")


def _number(value: Any) -> Any:
    """Refuse booleans and strings in place of numbers."""
    if isinstance(value, bool | str):
        raise ValueError("must be a number")
    return value


Number = Annotated[float, BeforeValidator(_number)]
Positive = Annotated[Number, Field(gt=0.0)]
# the least is that of the FMUs; the greatest avoids overflow in the design of gains
Quantity = Annotated[Number, Field(ge=1e-9, le=1e9)]
NotNegative = Annotated[Number, Field(ge=0.0)]
Triple = Annotated[list[Number], Field(min_length=3, max_length=3)]
PositiveTriple = Annotated[list[Positive], Field(min_length=3, max_length=3)]
PositivePair = Annotated[list[Positive], Field(min_length=2, max_length=2)]


def _state(value: Any) -> Any:
    """Refuse words other than "free" here, so that the message does not list both types."""
    if isinstance(value, str) and value != "free":
        raise ValueError('must be three numbers or "free"')
    return value


State = Annotated[Triple | Literal["free"], BeforeValidator(_state)]


def _printable(text: str) -> str:
    """Check a title of tables and plots: one line, no control characters."""
    if not text.isprintable():
        raise ValueError("must be one line of printable characters")
    return text


class _Strict(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False)


class CraneFile(_Strict):
    """Masses [kg], gravity [m/s2] and rope range [m]."""

    bridge_mass: Quantity
    trolley_mass: Quantity
    payload_mass: Quantity
    gravity: Quantity = 9.81
    rope_min: Quantity | None = None
    rope_max: Quantity | None = None


class AxisLimits(_Strict):
    """Limits of one axis; from jerk on, an absent limit means unbounded."""

    velocity: Positive
    acceleration: Positive
    jerk: Positive | None = None
    snap: Positive | None = None


class LimitsTable(_Strict):
    """Limits of the three axes."""

    x: AxisLimits
    y: AxisLimits
    z: AxisLimits


class WaypointEntry(_Strict):
    """One waypoint; by default at rest; the planner chooses a "free" velocity or acceleration."""

    position: Triple
    velocity: State = [0.0, 0.0, 0.0]
    acceleration: State = [0.0, 0.0, 0.0]
    dwell: NotNegative = 0.0


class ActuatorEntry(_Strict):
    """Bounds of bridge, trolley and hoist [N], [m/s], [m/s2], and of the sway angles [deg]."""

    force: PositiveTriple | None = None
    velocity: PositiveTriple | None = None
    acceleration: PositiveTriple | None = None
    sway_angle: PositivePair | None = None


class SimulationEntry(_Strict):
    """How `segfmu simulate` runs the mission."""

    step: Annotated[Number, Field(gt=0.0, le=0.1)] = 0.001
    settle: NotNegative = 3.0
    feedback: StrictBool = True
    feedback_source: Literal["state", "measured"] = "state"
    drive: Literal["force", "velocity"] = "force"
    initial_sway: Annotated[
        list[Annotated[Number, Field(ge=-45.0, le=45.0)]], Field(min_length=2, max_length=2)
    ] = [0.0, 0.0]
    tracking_tolerance: Positive = 0.001
    sway_tolerance: Positive = 0.02


class Mission(_Strict):
    """A whole mission file."""

    name: Annotated[str, Field(max_length=100), AfterValidator(_printable)] = "mission"
    crane: CraneFile
    limits: LimitsTable
    waypoints: Annotated[list[WaypointEntry], Field(min_length=2, max_length=MOST_WAYPOINTS)]
    smoothness: Annotated[int, Field(ge=4, le=6, strict=True)] = 4
    shape: Literal["plateau", "smoothstep"] = "plateau"
    synchronization: Literal["waypoints", "total", "none"] = "waypoints"
    sample_time: Positive | None = None
    duration: Positive | None = None
    actuators: ActuatorEntry | None = None
    simulation: SimulationEntry = SimulationEntry()

    def build_crane(self) -> Crane:
        """The crane of the mission."""
        return Crane(**self.crane.model_dump())

    def build_limits(self) -> Limits:
        """Limits of the axes x, y, z."""
        axes = [getattr(self.limits, axis) for axis in AXES]
        return Limits(
            *(
                [getattr(axis, name) for axis in axes]
                for name in ("velocity", "acceleration", "jerk", "snap")
            )
        )

    def plan(self) -> Trajectory:
        """Plan the mission's trajectory of x, y and z."""
        points = [Waypoint(**entry.model_dump()) for entry in self.waypoints]
        options: dict[str, Any] = {
            "smoothness": self.smoothness, "shape": self.shape,
            "synchronize": self.synchronization, "sample_time": self.sample_time,
            "duration": self.duration, "axis_names": AXES,
        }
        if self.actuators is None:
            return plan(points, self.build_limits(), **options)
        given = self.actuators.model_dump()
        if given["sway_angle"] is not None:
            given["sway_angle"] = np.deg2rad(given["sway_angle"])
        return plan_actuated(
            self.build_crane(), points, self.build_limits(), ActuatorBounds(**given), **options
        ).trajectory


def load_mission(path: Path) -> Mission:
    """Read and check a mission file.

    Raises
    ------
    InputError
        One line with the file, the key, the value and what is allowed.
    """
    data = _read(path)
    reference = data.get("crane")
    if isinstance(reference, str):
        data["crane"] = _read(path.parent / reference)
    try:
        mission = Mission.model_validate(data)
    except ValidationError as error:
        raise InputError(f"{path}: {_first_problem(error)}") from None
    try:
        mission.build_crane()
        _check_waypoints(mission)
    except InputError as error:
        raise InputError(f"{path}: {error}") from None
    return mission


def _read(path: Path) -> dict[str, Any]:
    try:
        return tomllib.loads(path.read_text(encoding="utf-8"))
    except OSError as error:
        raise InputError(f"{path}: cannot be read: {error.strerror}") from None
    except UnicodeDecodeError:
        raise InputError(f"{path}: not a text file in UTF-8") from None
    except (ValueError, RecursionError) as error:
        # not only TOML errors: numbers with thousands of digits, paths with a null character
        raise InputError(f"{path}: not valid TOML: {error}".splitlines()[0]) from None


def _first_problem(error: ValidationError) -> str:
    """The first finding as `key: what is wrong, got value`."""
    problems = error.errors(include_url=False)
    first = problems[0]
    key = ".".join(str(p + 1) if isinstance(p, int) else str(p) for p in first["loc"])
    text = first["msg"].replace("Value error, ", "")
    more = f" (and {len(problems) - 1} more)" if len(problems) > 1 else ""
    if first["type"] == "missing":
        return f"{key}: this key is missing{more}"
    if first["type"] == "model_type":
        text = "must be a table"
    if first["type"] == "extra_forbidden":
        return f"{key}: unknown key{more}"
    shown = repr(first["input"])
    shown = shown if len(shown) <= 60 else f"{shown[:57]}..."
    return f"{key or 'file'}: {text}, got {shown}{more}".replace("\n", " ")


def _check_waypoints(mission: Mission) -> None:
    """Checks before planning: waypoint states against their limits, repeated waypoints."""
    for i, entry in enumerate(mission.waypoints, 1):
        for axis, name in enumerate(AXES):
            limits = getattr(mission.limits, name)
            for quantity, unit in (("velocity", "m/s"), ("acceleration", "m/s2")):
                state, bound = getattr(entry, quantity), getattr(limits, quantity)
                value = 0.0 if state == "free" else state[axis]
                if abs(value) > bound:
                    raise InputError(
                        f"waypoints.{i}.{quantity}: axis {name}: {value} {unit} exceeds "
                        f"limits.{name}.{quantity} {bound} {unit}"
                    )
        moving = any(s != "free" and any(s) for s in (entry.velocity, entry.acceleration))
        if entry.dwell > 0.0 and moving:
            raise InputError(f"waypoints.{i}.dwell: only a waypoint at rest can have a dwell")
        if entry.position[2] >= 0.0:
            raise InputError(
                f"waypoints.{i}.position: z {entry.position[2]} m must be below the trolley, z < 0"
            )
        if i > 1 and entry.model_dump(exclude={"dwell"}) == mission.waypoints[i - 2].model_dump(
            exclude={"dwell"}
        ):
            raise InputError(f"waypoints.{i}: the same as waypoint {i - 1}; use dwell to wait")
