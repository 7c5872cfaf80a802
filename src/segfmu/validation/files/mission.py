"""Mission files: the crane, the limits, the waypoints, and how the mission is run."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from math import inf
from pathlib import Path
from typing import Annotated, Any, Literal

from pydantic import AfterValidator, Field, PrivateAttr, model_validator

from segfmu.crane import (
    ActuatorBounds,
    Friction,
    Operator,
    plan_actuated,
)
from segfmu.crane.kinds import AnyCrane
from segfmu.errors import InputError
from segfmu.planning import (
    Clearance,
    Limits,
    Obstacle,
    Trajectory,
    Waypoint,
    plan,
    read_waypoints,
)
from segfmu.validation.files import crane_parameters
from segfmu.validation.files.clearance_tables import ObstacleEntry, WorkspaceTable
from segfmu.validation.files.crane_file import CraneFile
from segfmu.validation.files.crane_models import (
    FURTHER,
    check_models,
    noted,
    require_gantry,
    usual,
)
from segfmu.validation.files.keys import AXES, Key, NotNegativeTriple, Place, Table, printable
from segfmu.validation.files.kinds import require_kind
from segfmu.validation.files.mission_checks import check_waypoints
from segfmu.validation.files.mission_tables import (
    ActuatorEntry,
    Limit,
    LimitsTable,
    SimulationEntry,
    WaypointEntry,
)
from segfmu.validation.files.objects import plain
from segfmu.validation.files.reading import checked, merged, read
from segfmu.validation.kept import Right

# that the FMUs can have
MOST_WAYPOINTS = 256
# keys that planner and nominal crane do not know
DISTURBED = {"name", "true_crane", "simulation"}
# missions that were found right, but for these keys
_right = Right(64)


class Mission(Table):
    """A whole mission file; `load_mission` makes one. Its keys are attributes: `crane`, `limits`.

    Attributes
    ----------
    crane : CraneFile
        What is known of the crane; `build_crane` makes a `Crane` of it, or one of another model.
    """

    _file: Path | None = PrivateAttr(default=None)

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
    limits: Annotated[
        LimitsTable | None,
        Key("limits of the load", default="those that follow from the bounds of the drives"),
    ] = None
    waypoints: Annotated[
        list[WaypointEntry],
        Key("waypoints of the load; or the name of a table in a CSV file (`read_waypoints`)"),
        Field(min_length=2, max_length=MOST_WAYPOINTS),
    ]
    smoothness: Annotated[
        Annotated[int, Field(ge=4, le=6, strict=True)],
        Key(noted("the load's position is so many times continuously differentiable", "smoothness"),
            default=usual(4, "smoothness")),
    ] = 4
    shape: Annotated[
        Literal["plateau", "smoothstep"],
        Key("shape of the acceleration ramps", default=usual("plateau", "shape")),
    ] = "plateau"
    synchronization: Annotated[
        Literal["waypoints", "total", "none"], Key("where the axes meet in time")
    ] = "waypoints"
    sample_time: Annotated[
        Limit | None,
        Key("the shortest durations between waypoints, and dwells, are rounded up to multiples of "
            "it", "s",
            default="any duration"),
    ] = None
    duration: Annotated[
        Limit | None, Key("duration of the plan", "s", default="the shortest")
    ] = None
    actuators: Annotated[
        ActuatorEntry, Key("bounds of the drives in this mission")
    ] = ActuatorEntry()
    workspace: Annotated[
        WorkspaceTable, Key("range of the load's position")
    ] = WorkspaceTable()
    obstacles: Annotated[
        list[ObstacleEntry], Key("boxes that load and rope must not meet"), Field(max_length=1000)
    ] = []
    load_size: Annotated[
        NotNegativeTriple,
        Key("edges of the load's box, for obstacles; it does not tilt", "m", parts=AXES),
    ] = [0.0, 0.0, 0.0]
    load_centre: Annotated[
        Place, Key("centre of the load's box from the rope's end", "m", parts=AXES)
    ] = [0.0, 0.0, 0.0]
    simulation: Annotated[
        SimulationEntry, Key("how the mission is run")
    ] = SimulationEntry()

    @model_validator(mode="before")
    @classmethod
    def _complete(cls, data: Any) -> Any:
        """Take from the nominal crane what the true one does not state; defaults of its model."""
        if isinstance(data, dict):
            crane, true = data.get("crane"), data.get("true_crane")
            if isinstance(crane, dict):
                model = next((m for m in FURTHER if crane.get(m.key) is not None), None)
                defaults = {} if model is None else model.defaults
                own = {"true_crane": merged(crane, true)} if isinstance(true, dict) else {}
                return {**defaults, **data, **own}
        return data

    def __repr__(self) -> str:
        return (
            f"<Mission {self.name!r}: {len(self.waypoints)} waypoints, "
            f"payload {self.crane.payload_mass:g} kg>"
        )

    __str__ = __repr__

    def __eq__(self, other: object) -> bool:
        """Whether all keys agree, wherever they come from."""
        return isinstance(other, Mission) and self.model_dump() == other.model_dump()

    __hash__ = None  # type: ignore[assignment]

    @property
    def file(self) -> Path | None:
        """The file that it was read from."""
        return self._file

    @property
    def simulated(self) -> CraneFile:
        """The crane that is simulated."""
        return self.true_crane or self.crane

    @property
    def driven(self) -> CraneFile:
        """The crane that is simulated, with the drives that the run has."""
        drive = self.simulation.drive
        return self.simulated if drive is None else self.simulated.model_copy(
            update={"drive": drive}
        )

    def build_crane(self) -> AnyCrane:
        """The crane that is planned for."""
        return crane_parameters.nominal(self.crane)

    def build_limits(self) -> Limits | None:
        """Limits of the axes x, y, z; None if the mission leaves them to the drives."""
        if self.limits is None:
            return None
        axes = [getattr(self.limits, axis) for axis in AXES]
        lower = {
            name: [-inf if (given := getattr(axis, name)) is None else given for axis in axes]
            for name in ("velocity_min", "acceleration_min")
        }
        return Limits(
            *(
                [getattr(axis, name) for axis in axes]
                for name in ("velocity", "acceleration", "jerk", "snap")
            ),
            **lower,
        )

    def build_bounds(self) -> ActuatorBounds | None:
        """Bounds of crane file and mission; None if there are none."""
        own = crane_parameters.bounds(self.crane)
        return crane_parameters.tighter(own, self.actuators.model_dump())

    def build_friction(self) -> Friction:
        """Friction of the axes of the crane that is planned for."""
        return crane_parameters.friction(self.crane)

    def build_clearance(self) -> Clearance:
        """Workspace and obstacles."""
        ranges = [getattr(self.workspace, axis) or (None, None) for axis in AXES]
        return Clearance(
            [Obstacle(**entry.model_dump()) for entry in self.obstacles],
            [r[0] for r in ranges], [r[1] for r in ranges], self.load_size, self.load_centre,
        )

    def build_waypoints(self) -> list[Waypoint]:
        """The waypoints for `plan`."""
        return [Waypoint(**entry.model_dump()) for entry in self.waypoints]

    def plan(self, progress: Callable[[float], None] = lambda _: None) -> Trajectory:
        """Plan the mission's trajectory of x, y and z.

        `progress` is called with the share of a search for limits that is done, from 0 to 1.
        """
        points = self.build_waypoints()
        options: dict[str, Any] = {
            "smoothness": self.smoothness, "shape": self.shape,
            "synchronize": self.synchronization, "sample_time": self.sample_time,
            "duration": self.duration, "axis_names": AXES,
        }
        bounds, limits, clearance = self.build_bounds(), self.build_limits(), self.build_clearance()
        if bounds is not None:
            return plan_actuated(
                self.build_crane(), points, limits, bounds, clearance=clearance,
                friction=self.build_friction(), progress=progress, **options,
            ).trajectory
        if limits is None:
            raise InputError(
                "limits: neither limits of the load nor bounds of the drives are known; add "
                "[limits] to the mission, or bounds such as bridge.velocity_max to the crane file"
            )
        trajectory = plan(points, limits, **options)
        clearance.require(trajectory, self.crane.gravity)
        return trajectory

    def operator(self) -> Operator:
        """The mission's crane under an operator's hand; at first it follows the mission's plan.

        Raises
        ------
        InputError
            For a crane of another model, and as `plan`.
        InfeasibleError
            As `plan`.
        """
        crane = require_gantry(self.build_crane(), "operator")
        trajectory = self.plan()
        return Operator(
            crane, trajectory.limits, trajectory,
            bounds=self.build_bounds() or ActuatorBounds(), clearance=self.build_clearance(),
            shape=self.shape, synchronize=self.synchronization, friction=self.build_friction(),
            brakes=list(crane_parameters.brakes(self.crane).values()),
        )


# what a mission is made of
Source = str | Path | Mapping[str, Any] | Mission


def load_mission(source: Source, changes: Mapping[str, Any] | None = None) -> Mission:
    """Read a mission file and the files that it names, or make a mission of Python objects.

    Parameters
    ----------
    source : path, mapping or Mission
        A mission file (TOML); or what it would say, as a dict. In a dict the crane may be a
        `Crane`, the limits `Limits`, waypoints `Waypoint` and obstacles `Obstacle`. A crane or
        waypoints that are a string name a file, which is relative to the mission file or to the
        current folder.
    changes : mapping, optional
        Keys that replace those of the source; tables are merged.

    Returns
    -------
    Mission

    Raises
    ------
    InputError
        One line with the file, the key, the value and what is allowed.

    Examples
    --------
    >>> import segfmu
    >>> mission = segfmu.load_mission({
    ...     "name": "across",
    ...     "crane": segfmu.Crane(bridge_mass=2.2, trolley_mass=1.155, payload_mass=1.0),
    ...     "limits": segfmu.Limits(velocity=1.0, acceleration=1.0, jerk=2.0, snap=20.0),
    ...     "waypoints": [segfmu.Waypoint([0, 0, -0.5]), segfmu.Waypoint([1.0, 0.5, -0.4])],
    ... })
    >>> mission
    <Mission 'across': 2 waypoints, payload 1 kg>
    >>> mission.plan()
    <Trajectory of x, y, z: 2 waypoints, 2.66682 s, smoothness 4, plateau>
    >>> segfmu.load_mission(mission, {"crane": {"payload_mass": 2.0}}).crane.payload_mass
    2.0
    """
    if changes is not None and not isinstance(changes, Mapping):
        raise InputError(f"changes of a mission are a dict, got {type(changes).__name__}")
    if isinstance(source, Mission) and not changes:
        return source
    if isinstance(source, str | Path):
        file: Path | None = Path(source)
        data = read_mission(Path(source))
    elif isinstance(source, Mapping | Mission):
        file = source.file if isinstance(source, Mission) else None
        data = _with_files(None, plain(source))
    else:
        raise InputError(f"a mission is a file or a dict, got {type(source).__name__}")
    return build_mission(file, merged(data, plain(changes or {})))


def read_mission(path: Path) -> dict[str, Any]:
    """The content of a mission file, with that of the files that it names.

    Raises
    ------
    InputError
        For files that cannot be read, and a crane file or a table that is wrong.
    """
    return _with_files(path, read(path))


def build_mission(path: Path | None, data: Mapping[str, Any]) -> Mission:
    """Check the content of a mission; `path` names its file, if it has one.

    Raises
    ------
    InputError
        As `load_mission` does.
    """
    where = str(path or "mission")
    mission = checked(Mission, data, where)
    mission._file = path
    try:
        true = "crane" if mission.true_crane is None else "true_crane"
        for name, crane in (("crane", mission.crane), (true, mission.driven)):
            crane_parameters.check(crane, name)
        check_models(mission)
        _check_nominal(mission)
    except InputError as error:
        raise InputError(f"{where}: {error}") from None
    return mission


def _check_nominal(mission: Mission) -> None:
    """What has to fit in a mission whatever the crane is in truth, and however it is run."""
    text = mission.model_dump_json(exclude=DISTURBED)
    if text not in _right:
        check_waypoints(mission)
        mission.build_clearance()
        _right.add(text)


def _with_files(path: Path | None, data: dict[str, Any]) -> dict[str, Any]:
    """The content of a mission with that of the files that it names."""
    require_kind("mission", data, path or "mission")
    found = dict(data)
    if isinstance(data.get("crane"), str):
        found["crane"] = _crane_data(path, data["crane"])
    if isinstance(data.get("waypoints"), str):
        found["waypoints"] = _waypoint_data(path, data["waypoints"])
    return found


def _named(mission: Path | None, key: str, name: str) -> Path:
    """A file that a mission names."""
    if not name.strip():
        raise InputError(f"{mission or 'mission'}: {key}: no file is named, got {name!r}")
    return Path(name) if mission is None else mission.parent / name


def _waypoint_data(mission: Path | None, name: str) -> list[Any]:
    """The waypoints of the table that a mission names."""
    path = _named(mission, "waypoints", name)
    try:
        return [plain(point) for point in read_waypoints(path, AXES)]
    except InputError as error:
        raise InputError(f"{mission or 'mission'}: waypoints: {error}") from None


def _crane_data(mission: Path | None, name: str) -> dict[str, Any]:
    """The content of the crane file that a mission names, checked."""
    path = _named(mission, "crane", name)
    try:
        data = read(path)
        require_kind("crane", data, path)
        crane_parameters.check(checked(CraneFile, data, str(path)), str(path))
    except InputError as error:
        raise InputError(f"{mission or 'mission'}: crane: {error}") from None
    return data
