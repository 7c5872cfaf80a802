"""Mission files: the crane, the limits, the waypoints, and how the mission is run."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any, Literal

from pydantic import AfterValidator, BeforeValidator, Field, StrictBool, model_validator

from segfmu.crane import ActuatorBounds, Crane, plan_actuated
from segfmu.errors import InputError
from segfmu.planning import Limits, Trajectory, Waypoint, plan
from segfmu.validation import crane_parameters
from segfmu.validation.crane_file import CraneFile
from segfmu.validation.keys import (
    Key,
    NotNegative,
    Number,
    Positive,
    PositivePair,
    PositiveTriple,
    Table,
    Triple,
    printable,
)
from segfmu.validation.reading import checked, merged, read

# that the FMUs can have
MOST_WAYPOINTS = 256
AXES = ("x", "y", "z")

# keys that only the other kind of file has
OF_CRANES = ("bridge_mass", "trolley_mass", "payload_mass")
OF_MISSIONS = ("waypoints", "limits", "simulation")


def _state(value: Any) -> Any:
    """Refuse words other than "free" here, so that the message does not list both types."""
    if isinstance(value, str) and value != "free":
        raise ValueError('must be three numbers or "free"')
    return value


State = Annotated[Triple | Literal["free"], BeforeValidator(_state)]
REST = "at rest"


class AxisLimits(Table):
    """Limits of one axis."""

    velocity: Annotated[Positive, Key("greatest velocity of the load", "m/s")]
    acceleration: Annotated[Positive, Key("greatest acceleration of the load", "m/s2")]
    jerk: Annotated[
        Positive | None, Key("greatest jerk of the load", "m/s3", default="no limit")
    ] = None
    snap: Annotated[
        Positive | None, Key("greatest snap of the load", "m/s4", default="no limit")
    ] = None


class LimitsTable(Table):
    """Limits of the three axes."""

    x: Annotated[AxisLimits, Key("limits along x")]
    y: Annotated[AxisLimits, Key("limits along y")]
    z: Annotated[AxisLimits, Key("limits along z")]


class WaypointEntry(Table):
    """One waypoint."""

    position: Annotated[Triple, Key("x, y, z of the load; z is negative, 0 at the trolley", "m")]
    velocity: Annotated[
        State, Key('velocity of the load; "free": the planner chooses it', "m/s", default=REST)
    ] = [0.0, 0.0, 0.0]
    acceleration: Annotated[
        State,
        Key('acceleration of the load; "free": the planner chooses it', "m/s2", default=REST),
    ] = [0.0, 0.0, 0.0]
    dwell: Annotated[NotNegative, Key("time to rest there", "s")] = 0.0


class ActuatorEntry(Table):
    """Bounds of this mission alone, beside those of the crane file."""

    force: Annotated[
        PositiveTriple | None, Key("of bridge, trolley and hoist", "N", default="the crane's")
    ] = None
    velocity: Annotated[
        PositiveTriple | None, Key("of bridge, trolley and hoist", "m/s", default="the crane's")
    ] = None
    acceleration: Annotated[
        PositiveTriple | None, Key("of bridge, trolley and hoist", "m/s2", default="the crane's")
    ] = None
    sway_angle: Annotated[
        PositivePair | None, Key("of both sway angles", "deg", default="the crane's")
    ] = None


class SimulationEntry(Table):
    """How `segfmu simulate` runs the mission."""

    step: Annotated[
        Annotated[Number, Field(gt=0.0, le=0.1)], Key("communication step", "s")
    ] = 0.001
    settle: Annotated[NotNegative, Key("time behind the end of the plan", "s")] = 3.0
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
        Annotated[
            list[Annotated[Number, Field(ge=-45.0, le=45.0)]], Field(min_length=2, max_length=2)
        ],
        Key("sway angles phi_x and phi_y at the start", "deg"),
    ] = [0.0, 0.0]
    tracking_tolerance: Annotated[
        Positive, Key("largest distance of the load from its plan", "m")
    ] = 0.001
    sway_tolerance: Annotated[
        Positive, Key("largest sway angle after the end of the plan", "deg")
    ] = 0.02


class Mission(Table):
    """A whole mission file."""

    name: Annotated[
        Annotated[str, Field(max_length=100), AfterValidator(printable)],
        Key("title of tables and plots"),
    ] = "mission"
    crane: Annotated[
        CraneFile, Key("the crane that is planned for: the name of a crane file, or its keys")
    ]
    true_crane: Annotated[
        CraneFile | None,
        Key("what differs from `crane` in the crane that is simulated", default="nothing"),
    ] = None
    limits: Annotated[LimitsTable, Key("limits of the load")]
    waypoints: Annotated[
        list[WaypointEntry],
        Key("waypoints of the load"),
        Field(min_length=2, max_length=MOST_WAYPOINTS),
    ]
    smoothness: Annotated[
        Annotated[int, Field(ge=4, le=6, strict=True)],
        Key("the load's position is so many times continuously differentiable"),
    ] = 4
    shape: Annotated[
        Literal["plateau", "smoothstep"], Key("shape of the acceleration ramps")
    ] = "plateau"
    synchronization: Annotated[
        Literal["waypoints", "total", "none"], Key("where the axes meet in time")
    ] = "waypoints"
    sample_time: Annotated[
        Positive | None,
        Key("durations between waypoints are multiples of it", "s", default="any duration"),
    ] = None
    duration: Annotated[
        Positive | None, Key("duration of the plan", "s", default="the shortest")
    ] = None
    actuators: Annotated[
        ActuatorEntry, Key("bounds of the drives in this mission")
    ] = ActuatorEntry()
    simulation: Annotated[
        SimulationEntry, Key("how the mission is run")
    ] = SimulationEntry()

    @model_validator(mode="before")
    @classmethod
    def _complete(cls, data: Any) -> Any:
        """Take from the nominal crane what the true one does not state."""
        if isinstance(data, dict):
            crane, true = data.get("crane"), data.get("true_crane")
            if isinstance(crane, dict) and isinstance(true, dict):
                return {**data, "true_crane": merged(crane, true)}
        return data

    @property
    def simulated(self) -> CraneFile:
        """The crane that is simulated."""
        return self.true_crane or self.crane

    def build_crane(self) -> Crane:
        """The crane that is planned for."""
        return crane_parameters.nominal(self.crane)

    def build_limits(self) -> Limits:
        """Limits of the axes x, y, z."""
        axes = [getattr(self.limits, axis) for axis in AXES]
        return Limits(
            *(
                [getattr(axis, name) for axis in axes]
                for name in ("velocity", "acceleration", "jerk", "snap")
            )
        )

    def build_bounds(self) -> ActuatorBounds | None:
        """Bounds of crane file and mission; None if there are none."""
        own = crane_parameters.bounds(self.crane)
        return crane_parameters.tighter(own, self.actuators.model_dump())

    def plan(self) -> Trajectory:
        """Plan the mission's trajectory of x, y and z."""
        points = [Waypoint(**entry.model_dump()) for entry in self.waypoints]
        options: dict[str, Any] = {
            "smoothness": self.smoothness, "shape": self.shape,
            "synchronize": self.synchronization, "sample_time": self.sample_time,
            "duration": self.duration, "axis_names": AXES,
        }
        bounds = self.build_bounds()
        if bounds is None:
            return plan(points, self.build_limits(), **options)
        return plan_actuated(
            self.build_crane(), points, self.build_limits(), bounds, **options
        ).trajectory


def load_mission(path: Path) -> Mission:
    """Read and check a mission file and the crane file that it names.

    Raises
    ------
    InputError
        One line with the file, the key, the value and what is allowed.
    """
    data = read(path)
    if not data.keys() & set(OF_MISSIONS) and data.keys() & set(OF_CRANES):
        raise InputError(
            f"{path}: this is a crane file; give a mission, which names it: "
            f'crane = "{path.name}"'
        )
    if isinstance(data.get("crane"), str):
        data["crane"] = _crane_data(path, data["crane"])
    mission = checked(Mission, data, str(path))
    try:
        for name, crane in (("crane", mission.crane), ("true_crane", mission.simulated)):
            crane_parameters.check(crane, name)
        _check_waypoints(mission)
    except InputError as error:
        raise InputError(f"{path}: {error}") from None
    return mission


def _crane_data(mission: Path, name: str) -> dict[str, Any]:
    """The content of the crane file that a mission names, checked."""
    path = mission.parent / name
    try:
        data = read(path)
        if data.keys() & set(OF_MISSIONS):
            raise InputError(f"{path}: this is a mission, not a crane file")
        crane_parameters.check(checked(CraneFile, data, str(path)), str(path))
    except InputError as error:
        raise InputError(f"{mission}: crane: {error}") from None
    return data


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
