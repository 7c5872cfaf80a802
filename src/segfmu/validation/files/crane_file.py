"""The crane file: everything that is known of a crane, in the user's units.

The first tables are what planner, FMUs and controller design need of every crane. All others
describe what is real about it; without them it is ideal. A `Key` names the parameters of
GantryCrane that take its value.
"""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import AfterValidator, Field

from segfmu.kernels.rig.records import Disturbance
from segfmu.validation.files.controller_tables import ControllerTable
from segfmu.validation.files.crane_models import ModelTables
from segfmu.validation.files.equipment_tables import (
    DriveTable,
    FrictionTable,
    SensorTable,
    TravelTable,
)
from segfmu.validation.files.keys import (
    NO_BOUND,
    NUMBER,
    RANGE,
    SWAY,
    Key,
    NotNegative,
    Number,
    PositivePair,
    Quantity,
    SwayPair,
    Table,
    printable,
)
from segfmu.validation.files.wind_tables import WindTable


class LoadChange(Table):
    """A change of the load's mass during a run."""

    time: Annotated[Number, Key("time of the change", "s", ("payload[{}].time",))]
    mass: Annotated[Quantity, Key("mass from then on", "kg", ("payload[{}].mass",))]


class LoadTable(Table):
    """The load beside its mass."""

    mass_range: Annotated[
        PositivePair | None,
        Key("least and greatest mass of the load; `payload_mass` has to be within", "kg", (),
            "any", parts=RANGE),
    ] = None
    drag_area: Annotated[
        NotNegative | None,
        Key("drag coefficient times area, on which the air's speed acts", "m2",
            ("load.drag_area",), "none"),
    ] = None
    changes: Annotated[
        list[LoadChange],
        Key("changes of the mass during a run", "", ("payload.count",), slot="{}"),
        Field(max_length=Disturbance.MOST_CHANGES),
    ] = []


class CraneKeys(Table):
    """What every crane has."""

    name: Annotated[
        Annotated[str, Field(max_length=100), AfterValidator(printable)],
        Key("title of the crane"),
    ] = "crane"
    bridge_mass: Annotated[
        Quantity,
        Key("mass of the bridge, which moves in x together with the trolley", "kg",
            ("crane.bridge_mass",)),
    ]
    trolley_mass: Annotated[
        Quantity,
        Key("mass of the trolley, which moves in y on the bridge", "kg", ("crane.trolley_mass",)),
    ]
    payload_mass: Annotated[Quantity, Key("mass of the load", "kg", ("crane.payload_mass",))]
    gravity: Annotated[
        Annotated[float, Field(ge=1e-3, le=1e3), NUMBER],
        Key("acceleration of gravity", "m/s2", ("crane.gravity",)),
    ] = 9.81
    rope_min: Annotated[
        Quantity | None,
        Key("shortest rope of a plan, from the trolley to what hangs on it", "m",
            ("crane.rope_min",), "no bound", none=(0.0,)),
    ] = None
    rope_max: Annotated[
        Quantity | None,
        Key("longest rope of a plan", "m", ("crane.rope_max",), "no bound", none=(0.0,)),
    ] = None
    drive: Annotated[
        Literal["force", "velocity"],
        Key("what all drives follow: force setpoints or velocity setpoints", "", ("drive.mode",)),
    ] = "force"
    sway_max: Annotated[
        SwayPair | None,
        Key("greatest sway angles of a plan", "deg", (), NO_BOUND, parts=SWAY),
    ] = None
    bridge: Annotated[DriveTable, Key("drive of the bridge")] = DriveTable()
    trolley: Annotated[DriveTable, Key("drive of the trolley")] = DriveTable()
    hoist: Annotated[DriveTable, Key("drive of the hoist")] = DriveTable()
    travel: Annotated[TravelTable, Key("end stops")] = TravelTable()
    friction: Annotated[FrictionTable, Key("friction")] = FrictionTable()
    sensors: Annotated[SensorTable, Key("sensors")] = SensorTable()
    load: Annotated[LoadTable, Key("the load")] = LoadTable()
    controller: Annotated[ControllerTable, Key("the sway feedback")] = ControllerTable()
    wind: Annotated[WindTable, Key("wind on the load")] = WindTable()


class CraneFile(ModelTables, CraneKeys):
    """A crane."""
