"""What a campaign found."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from math import isnan
from numbers import Integral
from pathlib import Path
from shlex import quote
from typing import TYPE_CHECKING, Any

from segfmu.arrays import shown
from segfmu.errors import InputError, meant
from segfmu.validation.campaigns.comparison import Comparison, compared
from segfmu.validation.campaigns.probability import Probability
from segfmu.validation.campaigns.rare import Found
from segfmu.validation.campaigns.replay import run_name
from segfmu.validation.campaigns.sensitivity import Sensitivity, sensitivities
from segfmu.validation.campaigns.store import TABLE, about, read_probabilities, read_table
from segfmu.validation.campaigns.summary import Summary, WorstCase
from segfmu.validation.frames import frame
from segfmu.validation.output import folder_path
from segfmu.validation.requirements import Evidence, Requirement, gathered

if TYPE_CHECKING:
    import pandas
    import pyarrow
    from matplotlib.figure import Figure

    from segfmu.validation.suites import Suite


@dataclass(frozen=True, eq=False, repr=False)
class CampaignResult:
    """The table of a campaign that is complete.

    Attributes
    ----------
    name : str
    folder : Path
        Where `runs.parquet` is.
    factors, criteria : tuple of str
        Names.
    table : pyarrow.Table
        A row for every run, in the order of their numbers: "run", "scenario", one column for each
        factor (its value; of a relative one the multiple), "passed", "error" (null without),
        "arrival" [s], and for every criterion "margin.NAME", "bound.NAME" and "holds.NAME", null
        in runs that have no such criterion or an error.
    draws : int
        Draws of the factors at random that each scenario has; 0 if they were chosen otherwise.
    searched : tuple of str
        Criteria that were searched; none without a search.
    named : tuple of str
        Requirements that the scenarios list.
    evidence : tuple of (str, str, str)
        Requirement, criterion and its text, of all criteria that name a requirement.
    rare : mapping
        What a search for rare failures found, by the names of its criteria.
    units : mapping of str to str
        Of margins and bounds, by the names of criteria; "of the bounds" for the share of drives,
        empty where it is not known.
    """

    name: str
    folder: Path
    factors: tuple[str, ...]
    criteria: tuple[str, ...]
    table: pyarrow.Table
    draws: int = 0
    searched: tuple[str, ...] = ()
    named: tuple[str, ...] = ()
    evidence: tuple[tuple[str, str, str], ...] = ()
    rare: Mapping[str, Found] = field(default_factory=dict)
    units: Mapping[str, str] = field(default_factory=dict)

    def column(self, name: str) -> list[Any]:
        """The values of a column, None where there is none.

        Raises
        ------
        InputError
            For a column that the table does not have.
        """
        known = self.table.column_names
        if not isinstance(name, str) or name not in known:
            raise InputError(f"no column {shown(name)} in the runs{meant(name, known)}")
        values: list[Any] = self.table[name].to_pylist()
        return values

    @property
    def passed(self) -> bool:
        """Whether every run passed."""
        return all(self.column("passed"))

    @property
    def errors(self) -> list[tuple[int, str]]:
        """Numbers and errors of the runs that have no verdict."""
        pairs = zip(self.column("run"), self.column("error"), strict=True)
        return [(run, error) for run, error in pairs if error is not None]

    @property
    def summaries(self) -> tuple[Summary, ...]:
        """All criteria, each over all runs; a margin that is no number is the worst."""
        return tuple(self._summary(name) for name in self.criteria)

    @cached_property
    def sensitivities(self) -> tuple[Sensitivity, ...]:
        """Effects of the factors, and of the scenario if there are several, on the margins.

        None of a search: chance has no part in where its runs are.
        """
        if self.searched:
            return ()
        scenarios = self.column("scenario")
        names = ["scenario"] if len(set(scenarios)) > 1 else []
        factors = {n: self.column(n) for n in [*names, *self.factors]}
        margins = {n: self.column(f"margin.{n}") for n in self.criteria}
        return tuple(sensitivities(factors, margins))

    @property
    def requirements(self) -> tuple[Requirement, ...]:
        """All requirements with what the runs say of their criteria."""
        rows = {row.criterion: row for row in self.summaries}
        return gathered(self.named, (
            (name, _evidence(rows[criterion], text, len(self.errors)))
            for name, criterion, text in self.evidence
        ))

    @property
    def worst_runs(self) -> list[int]:
        """Numbers of the runs with the worst margin of each criterion, each once."""
        runs = [s.run for s in self.summaries if s.run is not None]
        return list(dict.fromkeys(runs))

    def worst(self, criterion: str) -> WorstCase:
        """The worst case of a criterion.

        Raises
        ------
        InputError
            If there is no such criterion, or no run came to a verdict.
        """
        if not isinstance(criterion, str) or criterion not in self.criteria:
            known = ", ".join(self.criteria)
            raise InputError(f"no criterion {shown(criterion)}; they are {known}")
        row = self._summary(criterion)
        if row.run is None or row.worst is None:
            raise InputError(f"{criterion}: no run came to a verdict")
        return WorstCase(row.run, row.worst, self.values(row.run), self.command(row.run), row.unit)

    def to_pandas(self) -> pandas.DataFrame:
        """The table of runs, by their numbers.

        Raises
        ------
        InputError
            If pandas is not installed.
        """
        return frame({n: self.column(n) for n in self.table.column_names}, "run")

    def plot(self) -> Figure:
        """Margins of all criteria and what they depend on most, as a figure of Matplotlib."""
        from segfmu.validation.plots.campaign import plot_campaign

        return plot_campaign(self)

    def against(self, other: CampaignResult) -> Comparison:
        """Differences of the margins from those of another campaign with the same draws.

        Raises
        ------
        InputError
            If it is no such result, runs do not have the same draws, or no criterion is of both.
        """
        if not isinstance(other, CampaignResult):
            raise InputError(f"other must be a CampaignResult, got {shown(other)}")
        return compared(self, other)

    def __repr__(self) -> str:
        passed = sum(map(bool, self.column("passed")))
        return f"<CampaignResult {self.name!r}: {passed} of {self.table.num_rows} runs passed>"

    def values(self, run: int) -> dict[str, Any]:
        """Values of all factors of a run; an `InputError` if there is none of this number."""
        runs = self.column("run")
        if not isinstance(run, Integral) or run not in runs:
            count = len(runs)
            raise InputError(f"no run {shown(run)}; runs are numbered from 0, there are {count}")
        row = self.table.slice(runs.index(run), 1)
        return {name: row[name][0].as_py() for name in self.factors}

    def command(self, run: int) -> str:
        """The command that makes one of the `worst_runs` again, or one that was written.

        Raises
        ------
        InputError
            If there is no such run, or its scenario was not written.
        """
        self.values(run)
        file = self.folder / run_name(run)
        if not file.exists() and run not in self.worst_runs:
            raise InputError(
                f"run {run} is the worst of no criterion and not written; segfmu campaign with "
                f"--replay {run} writes it"
            )
        return f"segfmu validate {quote(str(file))}"

    def report(self, path: str | Path, worst: Suite | None = None) -> Path:
        """Write one HTML file that opens without a network; `worst` are runs it shows in full."""
        from segfmu.validation.report import campaign_page, write
        from segfmu.validation.suites import Suite

        if not isinstance(worst, Suite | None):
            raise InputError(f"worst must be a Suite, as of segfmu.validate, got {shown(worst)}")
        return write(path, campaign_page(self, worst))

    def _summary(self, name: str) -> Summary:
        margins, held = self.column(f"margin.{name}"), self.column(f"holds.{name}")
        runs, unit = self.column("run"), self.units.get(name, "")
        judged = [i for i, verdict in enumerate(held) if verdict is not None]
        if not judged:
            return Summary(name, 0, 0, None, None, unit=unit)
        place = min(judged, key=lambda i: -float("inf") if isnan(margins[i]) else margins[i])
        count = sum(held[i] for i in judged)
        fails = self.rare.get(name) or self._fails({runs[i]: held[i] for i in judged})
        return Summary(name, len(judged), count, margins[place], runs[place], fails, unit)

    def _fails(self, held: dict[int, bool]) -> Probability | None:
        """Scenarios share their draws, so that one counts once: as failed if it fails in any."""
        if not self.draws:
            return None
        draws: dict[int, bool] = {}
        for run, verdict in held.items():
            draw = run % self.draws
            draws[draw] = draws.get(draw, True) and verdict
        return Probability(sum(not h for h in draws.values()), len(draws))


def _evidence(row: Summary, text: str, errors: int) -> Evidence:
    """Runs with an error might fail: with them a criterion is not known to hold."""
    lost = f", {errors} runs without a verdict" if errors else ""
    if row.worst is None:
        return Evidence(text, f"no verdict{lost}", None)
    found = f"{row.held} of {row.judged} runs hold it, least margin {row.least}{lost}"
    if row.held < row.judged:
        return Evidence(text, found, False)
    return Evidence(text, found, None if errors else True)


def load_result(folder: str | Path) -> CampaignResult:
    """The result of a campaign that was completed in a folder.

    Parameters
    ----------
    folder : path
        The `output` of the campaign.

    Raises
    ------
    InputError
        If there is none.
    """
    folder = folder_path(folder)
    found = about(folder)
    if not (folder / TABLE).exists():
        raise InputError(f"{folder}: the campaign is not complete; the same command goes on")
    return CampaignResult(
        folder=folder, table=read_table(folder / TABLE), rare=read_probabilities(folder), **found
    )

