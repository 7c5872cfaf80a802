"""Tables of a scenario file."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from itertools import pairwise
from math import nan
from sys import float_info
from typing import Annotated, Any, Literal, Self

from pydantic import AfterValidator, BeforeValidator, Field, StrictBool, model_validator

from segfmu.errors import InputError
from segfmu.validation.files.keys import Key, NotNegative, Number, Positive, Table, printable

INSTANT = re.compile(r"(start|arrival|end)(?:\s*([+-])\s*(\d+\.?\d*(?:[eE][+-]?\d+)?))?")
CRANE = "GantryCrane"


def _instant(value: Any) -> Any:
    """Refuse what is neither a time nor words for one."""
    if isinstance(value, str):
        fits = INSTANT.fullmatch(value.strip()) is not None
    else:
        number = isinstance(value, int | float) and not isinstance(value, bool)
        # neither NaN nor an integer that is too large for a float
        fits = number and abs(value) <= float_info.max
    if not fits:
        raise ValueError('must be a time, or "start", "arrival" or "end" plus or minus a time')
    return value.strip() if isinstance(value, str) else value


def moment(value: float | str, known: Mapping[str, float]) -> float:
    """The time that an instant of a file means [s]; `known` are start, arrival and end."""
    if not isinstance(value, str):
        return value
    found = INSTANT.fullmatch(value)
    assert found is not None
    word, sign, amount = found.groups()
    return known[word] + float(f"{sign or '+'}{amount or 0}")


def moments(values: Sequence[float | str], known: Mapping[str, float]) -> list[float]:
    """The times that instants of samples mean [s]; NaN for one that is not `known` yet.

    Raises
    ------
    InputError
        For times that do not increase.
    """
    found = [moment(value, known) for value in values]
    for i, (first, second) in enumerate(pairwise(found), 1):
        if second <= first:
            raise InputError(
                f"times must increase, got {values[i]!r} after {values[i - 1]!r}; sort the samples "
                "and give one for each time"
            )
    return found


def scalar(value: Any) -> Any:
    """Refuse what is no value of a variable."""
    if not isinstance(value, bool | int | float | str):
        raise ValueError("must be a number, true, false, or the name of an item")
    # neither NaN nor an integer that is too large for a float
    if isinstance(value, int | float) and not abs(value) <= float_info.max:
        raise ValueError("must be finite")
    return value


def _names(value: Any) -> Any:
    """Refuse other types here, so that the message does not list both."""
    if not all(isinstance(v, str) for v in (value if isinstance(value, list) else [value])):
        raise ValueError("must be the name of a variable, or a list of names")
    return value


Name = Annotated[str, Field(min_length=1, max_length=100), AfterValidator(printable)]
Instant = Annotated[float | str, BeforeValidator(_instant)]
Values = dict[str, Annotated[Any, BeforeValidator(scalar)]]


class EventTable(Table):
    """New values of variables from a time on."""

    time: Annotated[Instant, Key("when", "s")]
    fmu: Annotated[Name, Key("whose variables")] = CRANE
    values: Annotated[
        Values, Key("inputs that are not connected, and tunable parameters"), Field(min_length=1)
    ]


class ProfileTable(Table):
    """Samples that variables follow, each held until the next one."""

    fmu: Annotated[
        Name | None,
        Key("whose variables", default="GantryCrane; of a file the FMU that has the variable"),
    ] = None
    variable: Annotated[
        Name | None,
        Key("an input that is not connected, or a tunable parameter",
            default="required without a file"),
    ] = None
    times: Annotated[
        list[Instant], Key("of the samples", "s", default="required without a file")
    ] = []
    values: Annotated[
        list[Annotated[Any, BeforeValidator(scalar)]],
        Key("samples", default="required without a file"),
    ] = []
    file: Annotated[
        Name | None,
        Key("a CSV file in place of these: a column time in s, the others are variables; with "
            "commands of an operator these are followed, and arrival is not before its last row",
            default="none"),
    ] = None

    @model_validator(mode="after")
    def _fits(self) -> Self:
        own = self.variable is not None, bool(self.times), bool(self.values)
        if self.file is not None:
            if any(own):
                raise ValueError("has a file, and variable, times or values beside it")
            return self
        if not all(own):
            raise ValueError("needs variable, times and values, or a file")
        if len(self.times) != len(self.values):
            raise ValueError(f"has {len(self.times)} times but {len(self.values)} values")
        moments(self.times, {"start": 0.0, "arrival": nan, "end": nan})
        return self


class UnitTable(Table):
    """A further FMU, which steps between GantryFeedforward and GantryCrane."""

    name: Annotated[Name, Key("in connections, events and the names of variables")]
    path: Annotated[Name, Key("file of the FMU")]
    values: Annotated[Values, Key("parameters and start values")] = {}
    step: Annotated[
        Positive | None,
        Key("its own step, a multiple of the communication step; its outputs are held meanwhile",
            "s", default="the communication step"),
    ] = None
    connections: Annotated[
        list[Annotated[list[Name], Field(min_length=4, max_length=4)]],
        Key(
            "each FMU, output, FMU, input; an input of GantryCrane that is named here leaves "
            "GantryFeedforward"
        ),
    ] = []


class CriterionTable(Table):
    """What has to hold of a run."""

    name: Annotated[Name, Key("of the criterion")]
    requirement: Annotated[
        Name | None,
        Key("name of the requirement that it is evidence for", default="of none"),
    ] = None
    text: Annotated[
        Annotated[str, Field(min_length=1, max_length=500), AfterValidator(printable)] | None,
        Key("what it shows, for the table of requirements", default="its name"),
    ] = None
    kind: Annotated[
        Literal["always", "eventually", "at", "settled", "tube", "drives"],
        Key("when it has to hold"),
    ] = "always"
    signal: Annotated[
        Annotated[Name | list[Name], BeforeValidator(_names)] | None,
        Key("variable of the run, or several, whose Euclidean norm is meant",
            default="required, but of drives"),
    ] = None
    sense: Annotated[
        Literal["within", "at most", "at least"],
        Key("whether the bound is one of the absolute value, or from above or below"),
    ] = "within"
    bound: Annotated[
        Number | None,
        Key("in the unit of the signal; of drives their share", default="1, of drives"),
    ] = None
    against: Annotated[
        Literal["without feedback", "undisturbed"] | None,
        Key("a second run; the bound is a share of the signal's greatest absolute value there",
            default="the bound is absolute"),
    ] = None
    window: Annotated[
        Annotated[list[Instant], Field(min_length=2, max_length=2)],
        Key("from when to when", "s"),
    ] = ["start", "end"]
    at: Annotated[Instant | None, Key("when, of the kind at", "s", default="required there")] = None
    delay: Annotated[
        NotNegative, Key("of the kind settled: from the arrival on", "s")
    ] = 0.0
    reference: Annotated[
        Name | None,
        Key("of the kind tube: a variable of the run, or a CSV file that has the signal",
            default="required there"),
    ] = None

    @model_validator(mode="after")
    def _complete(self) -> Self:
        for name, kinds in OWN.items():
            given = name in self.model_fields_set
            if given and self.kind not in kinds:
                raise ValueError(f"{name} is no key of the kind {self.kind}")
        for name, kinds in NEEDED.items():
            if self.kind in kinds and getattr(self, name) is None:
                raise ValueError(f"{name} is missing, which the kind {self.kind} needs")
        if self.bound is not None and self.bound < 0.0 and self.sense == "within":
            raise ValueError(f"bound {self.bound:g} is below 0, which nothing is within")
        if isinstance(self.signal, list) and len(self.signal) < 2:
            raise ValueError("signal: a norm is one of at least two variables")
        return self

    @property
    def compared(self) -> list[str]:
        """What is compared: the variables of the signal, and the reference."""
        names = [self.signal] if isinstance(self.signal, str) else [*(self.signal or ())]
        return [*names, *([self.reference] if self.reference else [])]


SIGNALS = ("always", "eventually", "at", "settled", "tube")
# key -> kinds that have it; and kinds that need it
OWN = {
    "window": ("always", "eventually", "tube", "drives"), "at": ("at",), "delay": ("settled",),
    "reference": ("tube",), "signal": SIGNALS, "sense": SIGNALS, "against": SIGNALS,
}
NEEDED = {"signal": SIGNALS, "bound": SIGNALS, "at": ("at",), "reference": ("tube",)}


class ScenarioFile(Table):
    """A whole scenario file."""

    name: Annotated[Name, Key("title of the scenario")]
    mission: Annotated[Name, Key("mission file")]
    expect: Annotated[
        Literal["pass", "fail"], Key("whether all criteria have to hold, or one must not")
    ] = "pass"
    method: Annotated[
        Literal["feedforward", "trapezoid", "pd", "zv", "zvd", "zv_both", "zvd_both", "one_load"],
        Key("where setpoints come from: the planner's FMU, or in its place trapezoidal velocities "
            "from waypoint to waypoint, plain, with control of the carriages' positions alone in "
            "place of the feedback, or through an input shaper, of two swings for the slow one or "
            "for both; or the gantry crane's feedforward, for which all on the rope is one load"),
    ] = "feedforward"
    step: Annotated[
        Annotated[Number, Field(ge=1e-6, le=0.1)] | None,
        Key("communication step", "s", default="simulation.step of the mission"),
    ] = None
    fmi: Annotated[Literal[2, 3], Key("version of FMI of both FMUs")] = 2
    coupling: Annotated[
        Literal["derivatives", "sequential", "parallel"] | None,
        Key("how the FMUs are coupled", default="derivatives where all FMUs have them"),
    ] = None
    lead: Annotated[
        StrictBool, Key("setpoints are ahead by the step, for parallel coupling")
    ] = False
    crane: Annotated[dict[str, Any], Key("changes of the mission's crane, planned for")] = {}
    true_crane: Annotated[dict[str, Any], Key("what differs in the crane that is simulated")] = {}
    controller: Annotated[
        dict[str, Any], Key("changes of the controller; of the crane that is planned for")
    ] = {}
    limits: Annotated[dict[str, Any], Key("changes of the mission's limits")] = {}
    plan: Annotated[
        dict[str, Any], Key("changes of the mission's other keys, such as waypoints")
    ] = {}
    simulation: Annotated[dict[str, Any], Key("changes of the mission's simulation")] = {}
    parameters: Annotated[
        dict[str, Values], Key("parameters and start values of FMUs, by the name of the FMU")
    ] = {}
    events: Annotated[list[EventTable], Key("new values during the run")] = []
    profiles: Annotated[list[ProfileTable], Key("variables that follow samples")] = []
    fmus: Annotated[list[UnitTable], Key("further FMUs that take part")] = []
    requirements: Annotated[
        list[Name],
        Key("names of requirements; one that no criterion names is shown as without evidence"),
    ] = []
    criteria: Annotated[
        list[CriterionTable], Key("what has to hold"), Field(min_length=1)
    ]

    @model_validator(mode="after")
    def _fits(self) -> Self:
        for kind, entries in (("criteria", self.criteria), ("fmus", self.fmus)):
            names = [entry.name for entry in entries]
            double = next((n for n in names if names.count(n) > 1), None)
            if double is not None:
                raise ValueError(f"{kind}: two of them are called {double}")
        set_before: set[tuple[float | str, str, str]] = set()
        for event in self.events:
            for name in event.values:
                if (event.time, event.fmu, name) in set_before:
                    raise ValueError(
                        f"events: two of them set {name} at {event.time}, of which only one could "
                        "act; leave one out, or move it"
                    )
                set_before.add((event.time, event.fmu, name))
        if self.lead and self.coupling != "parallel":
            raise ValueError('lead is for coupling = "parallel"')
        return self
