"""Tables of a campaign file."""

from __future__ import annotations

from typing import Annotated, Any, Literal, Self

from pydantic import AfterValidator, BeforeValidator, Field, StrictBool, model_validator

from segfmu.validation.files.keys import Key, Number, Seed, Table
from segfmu.validation.files.reading import leaves
from segfmu.validation.files.scenario_tables import (
    CriterionTable,
    Name,
    ScenarioFile,
    scalar,
)

# of one campaign
MOST_RUNS = 1_000_000
# of a search at least: its first runs alone show where to go on
LEAST_SEARCHED = 50
# of one for rare failures: a fifth of them tell a share of a tenth
LEAST_RARE = 500
DRAWN = ("latin hypercube", "random", "sobol")
# columns of the table of runs that are no factors
COLUMNS = ("run", "scenario", "passed", "error", "arrival")

Level = Annotated[Any, BeforeValidator(scalar)]


def _own(name: str) -> str:
    """Refuse names of columns that every table of runs has."""
    if name in COLUMNS or "." in name:
        raise ValueError(f"must have no dot and be none of {', '.join(COLUMNS)}")
    return name


def _parted(key: str) -> str:
    """Refuse keys with empty names, which no table has."""
    if not all(key.split(".")):
        raise ValueError("must be names with a dot between each two")
    return key


FactorName = Annotated[Name, AfterValidator(_own)]


class SamplingTable(Table):
    """How runs are drawn from the factors."""

    kind: Annotated[
        Literal["latin hypercube", "random", "sobol", "corners", "one at a time", "matrix"],
        Key("drawn at random and evenly; at random, each by itself; evenly in all together; "
            "all corners of the ranges; each factor alone; all combinations of levels"),
    ] = "latin hypercube"
    runs: Annotated[
        Annotated[int, Field(ge=1, le=MOST_RUNS, strict=True)] | None,
        Key("number of runs of each scenario", default="required of those at random"),
    ] = None
    seed: Annotated[Seed, Key("of what is drawn at random")] = 0

    @model_validator(mode="after")
    def _fits(self) -> Self:
        drawn = self.kind in DRAWN
        if drawn and self.runs is None:
            raise ValueError(f"runs is missing, which {self.kind} needs")
        if not drawn and self.runs is not None:
            raise ValueError(f"runs is no key of {self.kind}: the levels of the factors count")
        return self


class FactorTable(Table):
    """What differs from run to run."""

    name: Annotated[FactorName, Key("of the factor, a column of the table of runs")]
    key: Annotated[
        Annotated[Name, AfterValidator(_parted)] | None,
        Key("key of the scenario, with dots; of its crane, true_crane, limits, simulation, "
            "controller or plan; parameters.FMU.NAME is any parameter of an FMU",
            default="required, but for variants"),
    ] = None
    range: Annotated[
        Annotated[list[Number], Field(min_length=2, max_length=2)] | None,
        Key("least and greatest number", default="values or variants"),
    ] = None
    values: Annotated[
        Annotated[list[Level], Field(min_length=1, max_length=10_000)] | None,
        Key("all that it takes", default="a range or variants"),
    ] = None
    variants: Annotated[
        Annotated[dict[Name, dict[str, Any]], Field(min_length=1)] | None,
        Key("changes of the scenario by name; each with the keys of a scenario",
            default="a range or values"),
    ] = None
    relative: Annotated[
        StrictBool, Key("whether numbers are multiples of what the files have")
    ] = False
    scale: Annotated[
        Literal["linear", "log"], Key("what is even: differences or ratios")
    ] = "linear"
    integer: Annotated[StrictBool, Key("whether numbers of a range are rounded")] = False
    levels: Annotated[
        Annotated[int, Field(ge=2, le=10_000, strict=True)], Key("of a range in a matrix")
    ] = 3

    @model_validator(mode="after")
    def _fits(self) -> Self:
        given = [n for n in ("range", "values", "variants") if getattr(self, n) is not None]
        if len(given) != 1:
            found = ", ".join(given) or "none of them"
            raise ValueError(f"takes one of range, values and variants, has {found}")
        if (self.key is None) is (self.variants is None):
            raise ValueError("key is for range and values, which need it, not for variants")
        for name in ("scale", "integer", "levels"):
            if name in self.model_fields_set and self.range is None:
                raise ValueError(f"{name} is for a range")
        if self.range is not None and not self.range[0] < self.range[1]:
            raise ValueError(f"range from {self.range[0]:g} to {self.range[1]:g} is empty")
        if self.scale == "log" and self.range is not None and self.range[0] <= 0.0:
            raise ValueError(f"range from {self.range[0]:g} has no logarithm")
        _check_values(self)
        return self


def _check_values(factor: FactorTable) -> None:
    """Refuse values that are not alike, and multiples that are no numbers."""
    values = factor.values or []
    kinds = {"number" if type(v) in (int, float) else type(v).__name__ for v in values}
    if len(kinds) > 1:
        raise ValueError("values: must be all numbers, all text, or all true and false")
    if factor.relative and (factor.variants or kinds - {"number"}):
        raise ValueError("relative is for numbers")


def _keys(factor: FactorTable) -> set[str]:
    """Keys of the scenario that a factor sets."""
    if factor.key is not None:
        return {factor.key}
    return {key for own in (factor.variants or {}).values() for key, _ in leaves(own)}


class ChangesTable(ScenarioFile):
    """Changes of a scenario: its keys, none of which is required."""

    name: Annotated[Name, Key("title of the scenario")] = "changes"
    mission: Annotated[Name, Key("mission file")] = "mission"
    criteria: Annotated[list[CriterionTable], Key("what has to hold")] = []

    @model_validator(mode="after")
    def _fits(self) -> Self:
        """What has to fit together is seen when a scenario has the changes."""
        return self


class Changed(Table):
    """The changes of a campaign, which have the names of its keys in messages."""

    changes: Annotated[ChangesTable, Key("of all scenarios")]


class CampaignFile(Table):
    """A whole campaign file."""

    name: Annotated[Name, Key("title of the campaign")]
    scenarios: Annotated[
        list[Name], Key("scenario files; every one has all runs"), Field(min_length=1)
    ]
    changes: Annotated[dict[str, Any], Key("changes of all scenarios, with their keys")] = {}
    sampling: Annotated[SamplingTable, Key("how runs are drawn")]
    timeout: Annotated[
        Annotated[Number, Field(ge=1.0, le=1e6)] | None,
        Key("longest time of a run, the building of its FMUs included; one that takes longer is a "
            "row with an error", "s", default="no limit"),
    ] = None
    search: Annotated[
        Literal["worst", "rare"] | None,
        Key("worst: runs go to where the margin of a criterion is least; rare: step by step to "
            "where it fails, for the probability of rare failures. Sampling draws the first ones, "
            "and its runs are those of each scenario and criterion",
            default="sampling draws all runs"),
    ] = None
    search_for: Annotated[
        Annotated[list[Name], Field(min_length=1)] | None,
        Key("names of the criteria that are searched", default="all"),
    ] = None
    factors: Annotated[list[FactorTable], Key("what differs from run to run")] = []

    @model_validator(mode="after")
    def _searches(self) -> Self:
        if self.search is None:
            if self.search_for is not None:
                raise ValueError("search_for is for a search")
            return self
        if not self.factors:
            raise ValueError("search needs factors, in which it looks for the worst case")
        if self.sampling.kind not in DRAWN:
            raise ValueError(
                f"search needs sampling.kind {', '.join(DRAWN[:-1])} or {DRAWN[-1]}, which draws "
                f"its first runs, got {self.sampling.kind}"
            )
        if self.search == "rare":
            self._is_rare()
        elif (self.sampling.runs or 0) < LEAST_SEARCHED:
            raise ValueError(
                f"search needs sampling.runs of at least {LEAST_SEARCHED}, got "
                f"{self.sampling.runs}; 500 are usual"
            )
        return self

    def _is_rare(self) -> None:
        if self.sampling.kind != "random":
            raise ValueError(
                'search = "rare" needs sampling.kind random, which draws each run by itself, got '
                f"{self.sampling.kind}"
            )
        if len(self.scenarios) > 1:
            raise ValueError(f'search = "rare" takes one scenario, got {len(self.scenarios)}')
        if (self.sampling.runs or 0) < LEAST_RARE:
            raise ValueError(
                f'search = "rare" needs sampling.runs of at least {LEAST_RARE}, got '
                f"{self.sampling.runs}; 5000 tell 1e-4 within a factor of 2"
            )

    @model_validator(mode="after")
    def _unique(self) -> Self:
        for kind, names in (
            ("factors", [f.name for f in self.factors]), ("scenarios", self.scenarios),
            ("search_for", self.search_for or []),
        ):
            double = next((n for n in names if names.count(n) > 1), None)
            if double is not None:
                raise ValueError(f"{kind}: two of them are called {double}")
        owners: dict[str, str] = {}
        for factor in self.factors:
            for key in _keys(factor):
                if key in owners:
                    raise ValueError(
                        f"factors: {owners[key]} and {factor.name} both set {key}, of which only "
                        "one could act; leave one out, or make variants of them"
                    )
                owners[key] = factor.name
        return self
