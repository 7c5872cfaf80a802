"""Tables of a mission about where the load may be."""

from __future__ import annotations

from typing import Annotated

from pydantic import AfterValidator, Field, StrictBool

from segfmu.validation.files.keys import (
    AXES,
    RANGE,
    Key,
    NotNegative,
    Pair,
    Place,
    Table,
    printable,
)


class WorkspaceTable(Table):
    """Range of the load's position in each axis."""

    x: Annotated[Pair | None, Key("along x", "m", default="any", parts=RANGE)] = None
    y: Annotated[Pair | None, Key("along y", "m", default="any", parts=RANGE)] = None
    z: Annotated[
        Pair | None, Key("upwards; 0 at the trolley", "m", default="any", parts=RANGE)
    ] = None


class ObstacleEntry(Table):
    """A box that load and rope must not meet."""

    name: Annotated[
        Annotated[str, Field(min_length=1, max_length=100), AfterValidator(printable)],
        Key("for messages"),
    ]
    minimum: Annotated[Place, Key("least coordinates", "m", parts=AXES)]
    maximum: Annotated[Place, Key("greatest coordinates", "m", parts=AXES)]
    margin: Annotated[
        NotNegative, Key("distance that load and rope keep along each axis", "m")
    ] = 0.0
    rope: Annotated[
        StrictBool, Key("false: the load alone must not meet it, the rope may")
    ] = True
