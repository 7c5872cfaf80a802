"""What all documents have in common, and the one of a command that was refused."""

from __future__ import annotations

import json
from importlib.metadata import version
from typing import Annotated, Literal

from pydantic import BaseModel, BeforeValidator, ConfigDict, Field

from segfmu.errors import (
    BuildError,
    InfeasibleError,
    InputError,
    SegfmuError,
    SimulationError,
)
from segfmu.validation.files.keys import Key
from segfmu.validation.texts import encodable

Kind = Literal["input", "infeasible", "build", "simulation", "system"]
KINDS: dict[type[SegfmuError], Kind] = {
    InputError: "input", InfeasibleError: "infeasible", BuildError: "build",
    SimulationError: "simulation",
}
# null where there is no number: JSON has neither NaN nor infinity
Value = Annotated[float | None, Field(allow_inf_nan=True)]


def _encodable(value: object) -> object:
    return encodable(value) if isinstance(value, str) else value


Text = Annotated[str, BeforeValidator(_encodable)]


class Part(BaseModel):
    """A table of a document."""

    model_config = ConfigDict(
        extra="forbid", frozen=True, json_schema_serialization_defaults_required=True
    )


class Document(Part):
    """A whole document."""

    segfmu: Annotated[str, Key("version of segfmu that wrote it")] = version("segfmu")


class Refusal(Part):
    """Why a command was refused; numbers are those of `InfeasibleError`."""

    kind: Annotated[Kind, Key(
        "input: a value or an option; infeasible: a plan that breaks a limit; build: an FMU that "
        "cannot be built; simulation: a run that an FMU stopped; system: a file or a folder"
    )]
    message: Annotated[Text, Key("one line: what is wrong, where, and the way out")]
    axis: Annotated[int | None, Key("index of the axis, from 0")] = None
    interval: Annotated[int | None, Key("between waypoints 1 and 2 it is 1")] = None
    limit: Annotated[str | None, Key("name of the limit")] = None
    value: Annotated[Value, Key("required value, SI units")] = None
    bound: Annotated[Value, Key("allowed value, SI units")] = None
    time_s: Annotated[Value, Key("time of the violation", "s")] = None


class RefusalDocument(Document):
    """What a command prints in place of its result."""

    error: Annotated[Refusal, Key("why there is no result")]


class ResultDocument(Document):
    """What a command prints that was not refused."""

    error: Annotated[None, Key("null: the command was not refused")] = None


def refusal(error: Exception, message: str) -> RefusalDocument:
    """The document of an error, with the line that is printed of it."""
    kind = next((k for t, k in KINDS.items() if isinstance(error, t)), None)
    if kind is None:
        kind = "system" if isinstance(error, OSError) else "input"
    if not isinstance(error, InfeasibleError):
        return RefusalDocument(error=Refusal(kind=kind, message=message))
    return RefusalDocument(error=Refusal(
        kind=kind, message=message, axis=error.axis, interval=error.interval, limit=error.limit,
        value=error.value, bound=error.bound, time_s=error.time,
    ))


def text(document: Document) -> str:
    """The document as it is printed and written: ASCII, whatever the encoding of the terminal."""
    return json.dumps(json.loads(document.model_dump_json()), indent=2) + "\n"
