"""Mission files: the crane, the limits, the waypoints, and how the mission is run."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any, Literal

from pydantic import AfterValidator, Field, model_validator

from segfmu.crane import ActuatorBounds, Crane, plan_actuated
from segfmu.errors import InputError
from segfmu.planning import Limits, Trajectory, Waypoint, plan
from segfmu.validation import crane_parameters
from segfmu.validation.crane_file import CraneFile
from segfmu.validation.keys import AXES, Key, Table, printable
from segfmu.validation.mission_checks import check_waypoints
from segfmu.validation.mission_tables import (
    ActuatorEntry,
    Limit,
    LimitsTable,
    SimulationEntry,
    WaypointEntry,
)
from segfmu.validation.reading import checked, merged, read

# that the FMUs can have
MOST_WAYPOINTS = 256

# keys that only the other kind of file has
OF_CRANES = ("bridge_mass", "trolley_mass", "payload_mass")
OF_MISSIONS = ("waypoints", "limits", "simulation")


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
        Limit | None,
        Key("durations between waypoints are multiples of it", "s", default="any duration"),
    ] = None
    duration: Annotated[
        Limit | None, Key("duration of the plan", "s", default="the shortest")
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
        check_waypoints(mission)
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
