"""Two campaigns with the same draws: by how much margins differ, run by run.

Differences of the same draw do not have what the draws have in common, so that a small change of
the controller is seen beside a large effect of the factors.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator
from dataclasses import dataclass
from math import isfinite
from typing import TYPE_CHECKING, Any

import numpy as np

from segfmu.errors import InputError
from segfmu.validation.campaigns.probability import CONFIDENCE
from segfmu.validation.frames import frame
from segfmu.validation.units import pretty, with_unit

if TYPE_CHECKING:
    import pandas

    from segfmu.validation.campaigns.result import CampaignResult

# values of a factor that differ by a smaller share are the same draw
SAME = 1e-9


@dataclass(frozen=True)
class Difference:
    """A criterion in two campaigns.

    Attributes
    ----------
    criterion : str
    pairs : int
        Runs that have a margin in both.
    mean : float
        Of the differences of the margins, this campaign minus the other one; positive where this
        one is better.
    low, high : float or None
        Interval at 95 % for the mean over all draws, by Student's t; None of runs that were not
        drawn at random, of which there are no others.
    better, worse : int
        Pairs with a larger, and a smaller margin.
    repaired, broken : int
        Pairs in which only this one holds the criterion, and only the other one.
    unit : str
        Of `mean`, `low` and `high`; "of the bounds" for the share of drives, empty where it is not
        known.
    """

    criterion: str
    pairs: int
    mean: float
    low: float | None
    high: float | None
    better: int
    worse: int
    repaired: int
    broken: int
    unit: str = ""

    @property
    def verdict(self) -> str:
        """Whether the mean margin got better, as far as the runs tell."""
        if self.low is None or self.high is None:
            return "not drawn at random"
        if self.low > 0.0:
            return "better"
        return "worse" if self.high < 0.0 else "no difference told"

    def __str__(self) -> str:
        mean = pretty(self.mean)
        if self.low is not None and self.high is not None:
            mean += f" ({pretty(self.low)} to {pretty(self.high)})"
        return (
            f"{self.criterion}: margin {with_unit(mean, self.unit)}, {self.verdict}; better in "
            f"{self.better}, worse in {self.worse} of {self.pairs} runs; {self.repaired} repaired, "
            f"{self.broken} broken"
        )


@dataclass(frozen=True, repr=False)
class Comparison:
    """A campaign against another one with the same draws; iterates over its differences.

    Attributes
    ----------
    name, other : str
        Of the two campaigns.
    differences : tuple of Difference
        Of the criteria that both have.
    """

    name: str
    other: str
    differences: tuple[Difference, ...]

    def __iter__(self) -> Iterator[Difference]:
        return iter(self.differences)

    def __getitem__(self, criterion: str) -> Difference:
        for one in self.differences:
            if one.criterion == criterion:
                return one
        raise KeyError(criterion)

    def __repr__(self) -> str:
        lines = "\n".join(f"  {one}" for one in self.differences)
        return f"<Comparison: {self.name} against {self.other}\n{lines}>"

    def to_pandas(self) -> pandas.DataFrame:
        """A row for every criterion.

        Raises
        ------
        InputError
            If pandas is not installed.
        """
        names = ("criterion", "pairs", "mean", "low", "high", "unit", "better", "worse",
                 "repaired", "broken", "verdict")
        return frame({n: [getattr(one, n) for one in self.differences] for n in names})


def compared(own: CampaignResult, other: CampaignResult) -> Comparison:
    """Compare campaigns run by run.

    Raises
    ------
    InputError
        If their runs do not have the same draws, one is a search, no criterion is of both, or one
        has margins in different units.
    """
    _require_same_draws(own, other)
    names = [name for name in own.criteria if name in other.criteria]
    if not names:
        raise InputError(f"{own.name} and {other.name} have no criterion of the same name")
    for name in names:
        units = [result.units.get(name, "") for result in (own, other)]
        if all(units) and units[0] != units[1]:
            raise InputError(
                f"{name}: margins are in {units[0]} in {own.name} and in {units[1]} in "
                f"{other.name}; give criteria of different signals different names"
            )
    return Comparison(
        own.name, other.name, tuple(_difference(own, other, name) for name in names)
    )


def _require_same_draws(own: CampaignResult, other: CampaignResult) -> None:
    for result in (own, other):
        if result.searched:
            raise InputError(f"{result.name} is a search, which chooses its own runs")
    names = [name for name in own.factors if name in other.factors]
    if own.column("run") != other.column("run") or own.draws != other.draws:
        raise InputError(
            f"{own.name} has {own.table.num_rows} runs, {other.name} {other.table.num_rows}; runs "
            "are compared one by one, with the same sampling"
        )
    if not names and own.factors:
        raise InputError(f"{own.name} and {other.name} have no factor of the same name")
    for name in names:
        pairs = zip(own.column(name), other.column(name), strict=True)
        for run, (one, two) in enumerate(pairs):
            if not _same(one, two):
                raise InputError(
                    f"run {run} has {name} {one} in {own.name} and {two} in {other.name}; runs are "
                    "compared one by one, with the same factors, sampling and seed"
                )


def _same(one: Any, two: Any) -> bool:
    if isinstance(one, float) and isinstance(two, float):
        return abs(one - two) <= SAME * max(abs(one), abs(two))
    return bool(one == two)


def _difference(own: CampaignResult, other: CampaignResult, name: str) -> Difference:
    runs = own.column("run")
    margins = zip(own.column(f"margin.{name}"), other.column(f"margin.{name}"), strict=True)
    found = {
        run: one - two for run, (one, two) in zip(runs, margins, strict=True)
        if one is not None and two is not None and isfinite(one) and isfinite(two)
    }
    if not found:
        raise InputError(f"{name}: no run has a margin in both campaigns")
    held = zip(own.column(f"holds.{name}"), other.column(f"holds.{name}"), strict=True)
    verdicts = [pair for pair in held if None not in pair]
    values = list(found.values())
    low, high = _interval(found, own.draws)
    return Difference(
        name, len(values), float(np.mean(values)), low, high, sum(v > 0.0 for v in values),
        sum(v < 0.0 for v in values), verdicts.count((True, False)),
        verdicts.count((False, True)), own.units.get(name, "") or other.units.get(name, ""),
    )


def _interval(found: dict[int, float], draws: int) -> tuple[float | None, float | None]:
    """Of the mean over all draws; scenarios share their draws, so that one counts once."""
    from scipy.stats import t as student

    if not draws:
        return None, None
    shared: defaultdict[int, list[float]] = defaultdict(list)
    for run, value in found.items():
        shared[run % draws].append(value)
    means = np.array([np.mean(values) for values in shared.values()])
    if means.size < 2:
        return None, None
    half = student.ppf(0.5 + 0.5 * CONFIDENCE, means.size - 1) * means.std(ddof=1)
    half /= np.sqrt(means.size)
    return float(means.mean() - half), float(means.mean() + half)
