"""Requirements and their evidence: the criteria that name them, and what runs say of these."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from segfmu.validation.files.scenario_tables import CriterionTable
from segfmu.validation.scenario_result import Result
from segfmu.validation.units import pretty, with_unit

NONE = "no evidence"


@dataclass(frozen=True)
class Evidence:
    """What runs say of a criterion that names a requirement.

    Attributes
    ----------
    criterion : str
        Its text, or its name without one.
    found : str
        What was found, in words.
    holds : bool or None
        None if no run came to a verdict.
    """

    criterion: str
    found: str
    holds: bool | None


@dataclass(frozen=True)
class Requirement:
    """A requirement with all of its evidence.

    Attributes
    ----------
    name : str
    evidence : tuple of Evidence
    """

    name: str
    evidence: tuple[Evidence, ...]

    @property
    def holds(self) -> bool | None:
        """Whether all evidence holds; None if there is none, or a part of it without a verdict."""
        verdicts = [e.holds for e in self.evidence]
        if False in verdicts:
            return False
        return None if None in verdicts or not verdicts else True

    @property
    def verdict(self) -> str:
        """The same in words."""
        return {True: "holds", False: "fails", None: NONE}[self.holds]


def words(criterion: CriterionTable) -> str:
    """The text of a criterion, or its name."""
    return criterion.text or criterion.name


def gathered(
    names: Iterable[str], found: Iterable[tuple[str, Evidence]]
) -> tuple[Requirement, ...]:
    """All requirements in their order, those that are only named too."""
    every: dict[str, list[Evidence]] = {name: [] for name in names}
    for name, evidence in found:
        every.setdefault(name, []).append(evidence)
    return tuple(Requirement(name, tuple(own)) for name, own in every.items())


def of_results(results: Sequence[Result]) -> tuple[Requirement, ...]:
    """The requirements of scenarios that were run."""
    names = dict.fromkeys(n for r in results for n in r.scenario.file.requirements)
    found = [
        (criterion.requirement, _evidence(result, criterion))
        for result in results for criterion in result.scenario.file.criteria
        if criterion.requirement is not None
    ]
    return gathered(names, found)


def _evidence(result: Result, criterion: CriterionTable) -> Evidence:
    finding = next((f for f in result.findings if f.name == criterion.name), None)
    where = result.scenario.file.name
    if finding is None:
        return Evidence(words(criterion), f"{where}: {result.error}", None)
    margin, bound = (
        with_unit(pretty(value), finding.unit) for value in (finding.margin, finding.bound)
    )
    found = f"{where}: margin {margin}, bound {bound}"
    return Evidence(words(criterion), found, finding.passed)
