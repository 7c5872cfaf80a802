"""Mission files: the crane, the limits, the waypoints, and how the mission is run."""

from __future__ import annotations

from collections.abc import Callable
from math import inf
from pathlib import Path
from typing import Annotated, Any, Literal

from pydantic import AfterValidator, Field, PrivateAttr, ValidationError, model_validator

from segfmu.arrays import require_callable
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
)
from segfmu.validation.files import crane_parameters
from segfmu.validation.files.clearance_tables import ObstacleEntry, WorkspaceTable
from segfmu.validation.files.crane_file import CraneFile
from segfmu.validation.files.crane_models import (
    FURTHER,
    noted,
    require_gantry,
    usual,
)
from segfmu.validation.files.keys import AXES, Key, NotNegativeTriple, Place, Table, printable
from segfmu.validation.files.mission_tables import (
    ActuatorEntry,
    Limit,
    LimitsTable,
    SimulationEntry,
    WaypointEntry,
)
from segfmu.validation.files.reading import merged, problem

# that the FMUs can have
MOST_WAYPOINTS = 256
# keys that planner and nominal crane do not know
DISTURBED = {"name", "true_crane", "simulation"}


class Mission(Table):
    """A whole mission file; `load_mission` makes one. Its keys are attributes: `crane`, `limits`.

    Attributes
    ----------
    crane : CraneFile
        What is known of the crane; `build_crane` makes a `Crane` of it, or one of another model.
    """

    _file: Path | None = PrivateAttr(default=None)
    _changed: bool = PrivateAttr(default=False)

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

    def __init__(self, /, **keys: Any) -> None:
        try:
            super().__init__(**keys)
        except ValidationError as error:
            raise InputError(problem(type(self), keys, error)) from None

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
    def changed(self) -> bool:
        """Whether it has values in place of those of its file."""
        return self._changed

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
        require_callable("progress", progress)
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
