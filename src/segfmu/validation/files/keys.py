"""Keys of the files: what every key says of itself, and the types of their values.

A table of a file is a `Table`, a key of it an annotated field with a `Key`. The reference page, the
JSON schema and the parameters of the FMUs follow from these.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from types import NoneType, UnionType
from typing import Annotated, Any, Union, get_args, get_origin

from pydantic import BaseModel, BeforeValidator, ConfigDict, Field, GetJsonSchemaHandler
from pydantic.fields import FieldInfo
from pydantic_core import CoreSchema

from segfmu.crane.checks import HIGHEST_FREQUENCY, LARGEST_SEED
from segfmu.errors import InputError
from segfmu.kernels.numerics.numbers import FARTHEST_PLACE


@dataclass(frozen=True)
class Key:
    """What a key says of itself.

    Attributes
    ----------
    meaning : str
        One sentence without a full stop.
    unit : str
        Of its numbers; angles are in deg.
    feeds : tuple of str
        Parameters of GantryCrane that take the numbers; "{}" stands for the table's `slot`.
    default : str
        What holds without the key, if its default value does not say it.
    slot : str
        Of a table: what stands for "{}" in it; by default the table's own name.
    parts : tuple of str
        What the numbers of a list belong to.
    none : tuple of float
        What the parameters take without a value; empty if they keep the FMU's start values.
    """

    meaning: str
    unit: str = ""
    feeds: tuple[str, ...] = ()
    default: str = ""
    slot: str = ""
    parts: tuple[str, ...] = ()
    none: tuple[float, ...] = ()

    def __get_pydantic_json_schema__(
        self, core: CoreSchema, handler: GetJsonSchemaHandler
    ) -> dict[str, Any]:
        schema = handler(core)
        unit = f" [{self.unit}]" if self.unit else ""
        return {**schema, "description": f"{self.meaning}{unit}"}


class Table(BaseModel):
    """A table of a file: unknown keys, infinity and NaN are refused."""

    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False)

    def __setattr__(self, name: str, value: Any) -> None:
        if name.startswith("_"):
            super().__setattr__(name, value)
            return
        raise InputError(
            f"{name} cannot be set: what was read does not change; "
            "segfmu.load_mission(mission, changes) makes another mission"
        )


@dataclass(frozen=True)
class Entry:
    """A key at its place in a file.

    Attributes
    ----------
    path : tuple of str
        Names of its tables and its own.
    key : Key
    field : FieldInfo
    feeds : tuple of str
        With the slots filled in.
    kind : type of Table or None
        If the value is a table, or a list of tables.
    listed : bool
        Whether it is a list of tables.
    """

    path: tuple[str, ...]
    key: Key
    field: FieldInfo
    feeds: tuple[str, ...]
    kind: type[Table] | None
    listed: bool


def entries(
    kind: type[Table], path: tuple[str, ...] = (), slot: str = ""
) -> Iterator[Entry]:
    """All keys of a table and of the tables in it, in their order."""
    for name, field in kind.model_fields.items():
        key = next(m for m in field.metadata if isinstance(m, Key))
        found, listed = _table_in(field.annotation)
        feeds = tuple(f.replace("{}", slot) for f in key.feeds)
        yield Entry((*path, name), key, field, feeds, found, listed)
        if found is not None:
            yield from entries(found, (*path, name), key.slot or name)


def _table_in(annotation: Any) -> tuple[type[Table] | None, bool]:
    """The kind of table that a value is, and whether it is a list of them."""
    origin = get_origin(annotation)
    if origin in (Union, UnionType):
        (inner, *_) = [a for a in get_args(annotation) if a is not NoneType]
        return _table_in(inner)
    if origin is Annotated:
        return _table_in(get_args(annotation)[0])
    if origin is list:
        kind, _ = _table_in(get_args(annotation)[0])
        return kind, kind is not None
    is_table = isinstance(annotation, type) and issubclass(annotation, Table)
    return (annotation if is_table else None), False


def _number(value: Any) -> Any:
    """Refuse booleans and strings in place of numbers."""
    if isinstance(value, bool | str):
        raise ValueError("must be a number")
    return value


# behind the constraints, so that these are in the schema
NUMBER = BeforeValidator(_number)
Number = Annotated[float, NUMBER]
Positive = Annotated[float, Field(gt=0.0), NUMBER]
NotNegative = Annotated[float, Field(ge=0.0), NUMBER]
Share = Annotated[float, Field(ge=0.0, le=1.0), NUMBER]
Pair = Annotated[list[Number], Field(min_length=2, max_length=2)]
PositivePair = Annotated[list[Positive], Field(min_length=2, max_length=2)]
Triple = Annotated[list[Number], Field(min_length=3, max_length=3)]
NotNegativeTriple = Annotated[list[NotNegative], Field(min_length=3, max_length=3)]
# ranges that every crane is far within, so that a slip of the pen is told by its key
Length = Annotated[float, Field(ge=-FARTHEST_PLACE, le=FARTHEST_PLACE), NUMBER]
Time = Annotated[float, Field(ge=0.0, le=1e6), NUMBER]
Place = Annotated[list[Length], Field(min_length=3, max_length=3)]
# the least is that of the FMUs; the greatest avoids overflow in the design of gains
Quantity = Annotated[float, Field(ge=1e-9, le=1e9), NUMBER]
Frequency = Annotated[float, Field(ge=1e-9, le=HIGHEST_FREQUENCY), NUMBER]
# deg
SwayPair = Annotated[
    list[Annotated[float, Field(ge=1e-3, le=89.0), NUMBER]], Field(min_length=2, max_length=2)
]
# of drives; the least is that with which plans are made
Bound = Annotated[float, Field(ge=1e-5, le=1e12), NUMBER]
# in the negative direction
LowerBound = Annotated[float, Field(ge=-1e12, le=-1e-5), NUMBER]
LowerBoundTriple = Annotated[list[LowerBound], Field(min_length=3, max_length=3)]
BoundTriple = Annotated[list[Bound], Field(min_length=3, max_length=3)]
Seed = Annotated[int, Field(ge=0, le=LARGEST_SEED, strict=True)]

AXES = ("x", "y", "z")
DRIVES = ("bridge", "trolley", "hoist")
RANGE = ("least", "greatest")
SWAY = ("phi_x", "phi_y")
# of a key without a value
NO_BOUND = "no bound is known"


def printable(text: str) -> str:
    """Check a title of tables and plots: one line, no control characters."""
    if not text.strip():
        raise ValueError("must not be empty")
    if not text.isprintable():
        raise ValueError("must be one line of printable characters")
    return text
