"""A campaign with all of its runs, checked before the first one."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from importlib.metadata import version
from pathlib import Path
from typing import Any

from segfmu.errors import InputError
from segfmu.validation.campaigns.factors import changes, nominal, told
from segfmu.validation.campaigns.sampling import Sample, levels, samples
from segfmu.validation.files.campaign_file import CampaignSource, read_campaign
from segfmu.validation.files.campaign_tables import MOST_RUNS, FactorTable
from segfmu.validation.files.scenario_file import Scenario, Source, build_scenario
from segfmu.validation.monitor import measure
from segfmu.validation.requirements import words
from segfmu.validation.texts import require_utf8

# kinds of sampling from which a probability follows
AT_RANDOM = ("random", "latin hypercube")


@dataclass(frozen=True)
class Run:
    """One run of a campaign.

    Attributes
    ----------
    number : int
        From 0 on.
    scenario : int
        Place of its scenario.
    sample : dict
        Values of factors by name.
    """

    number: int
    scenario: int
    sample: Sample


@dataclass(frozen=True)
class Campaign:
    """A campaign, read and checked.

    Attributes
    ----------
    source : CampaignSource
    runs : tuple of Run
        All; none of a search, which chooses its runs from the margins of those before.
    criteria : tuple of str
        Names of all criteria.
    requirements : tuple of str
        Names of those that the scenarios list.
    evidence : tuple of (str, str, str)
        Requirement, criterion and its text, of all criteria that name a requirement.
    units : mapping of str to str
        Of the criteria's margins, as of `measure`.
    """

    source: CampaignSource
    runs: tuple[Run, ...]
    criteria: tuple[str, ...]
    requirements: tuple[str, ...] = ()
    evidence: tuple[tuple[str, str, str], ...] = ()
    units: Mapping[str, str] = field(default_factory=dict)

    @property
    def factors(self) -> list[FactorTable]:
        """All factors."""
        return self.source.file.factors

    @property
    def draws(self) -> int:
        """Draws of the factors at random that each scenario has; 0 if they are chosen."""
        sampling = self.source.file.sampling
        if self.searched or sampling.kind not in AT_RANDOM or not self.factors:
            return 0
        return sampling.runs or 0

    @property
    def searched(self) -> tuple[str, ...]:
        """Names of the criteria that are searched; none without a search."""
        file = self.source.file
        return () if file.search is None else tuple(file.search_for or self.criteria)

    @property
    def rare(self) -> bool:
        """Whether the search is for the probability of rare failures, not for worst cases."""
        return self.source.file.search == "rare"

    @property
    def most(self) -> int:
        """The number of runs, or of a search the greatest that it can have."""
        each = len(self.searched) * (self.source.file.sampling.runs or 0)
        return len(self.runs) or each * len(self.source.scenarios)

    def changes(self, run: Run) -> dict[str, Any]:
        """What a run changes in its scenario."""
        return changes(self.source.scenarios[run.scenario], self.factors, run.sample)

    def values(self, run: Run) -> dict[str, Any]:
        """Values of all factors of a run; those it leaves are the files', None if unknown."""
        source = self.source.scenarios[run.scenario]
        return {
            f.name: run.sample[f.name] if f.name in run.sample
            else 1.0 if f.relative else nominal(source, f)
            for f in self.factors
        }

    def fingerprint(self) -> str:
        """A hash of all that the numbers of the runs follow from."""
        content = {
            "version": version("segfmu"),
            "factors": [f.model_dump() for f in self.factors],
            "sampling": self.source.file.sampling.model_dump(), "searched": self.searched,
            "search": self.source.file.search,
            "scenarios": [(dict(s.data), s.missions) for s in self.source.scenarios],
            "files": {name: _hash(Path(name)) for name in sorted(self._files())},
        }
        text = json.dumps(content, sort_keys=True, default=str)
        return hashlib.sha256(text.encode()).hexdigest()

    def _files(self) -> set[str]:
        """Paths of FMUs and tables that take part."""
        found = set()
        for source in self.source.scenarios:
            found |= {str(u["path"]) for u in source.data.get("fmus", ()) if "path" in u}
            names = (str(c.get("reference", "")) for c in source.data.get("criteria", ()))
            found |= {name for name in names if name.endswith(".csv")}
        return found


def load_campaign(path: Path) -> Campaign:
    """Read a campaign file; check its scenarios at the ends of every factor.

    Raises
    ------
    InputError
        One line with the file, the key, the value and what is allowed.
    """
    source = read_campaign(path)
    for place in (path, *(own.path for own in source.scenarios)):
        require_utf8(place)
    try:
        ends = [s for own in source.scenarios for s in _ends(own, source.file.factors)]
        _require_effects(source)
        files = [scenario.file for scenario in ends]
        criteria = [criterion for file in files for criterion in file.criteria]
        names = tuple(dict.fromkeys(c.name for c in criteria))
        campaign = Campaign(
            source, known_runs(source), names,
            tuple(dict.fromkeys(name for file in files for name in file.requirements)),
            tuple(dict.fromkeys(
                (c.requirement, c.name, words(c)) for c in criteria if c.requirement is not None
            )),
            _units(ends),
        )
        if campaign.most > MOST_RUNS:
            raise InputError(f"sampling: more than {MOST_RUNS} runs")
        for name in campaign.searched:
            if name not in names:
                raise InputError(
                    f"search_for: no criterion {name!r}; they are {', '.join(names)}"
                )
    except InputError as error:
        raise InputError(f"{path}: {error}") from None
    return campaign


def _require_effects(source: CampaignSource) -> None:
    """Refuse multiples of what is zero in all scenarios."""
    for factor in source.file.factors:
        if factor.relative and all(nominal(own, factor) == 0 for own in source.scenarios):
            raise InputError(
                f"factor {factor.name}: relative: {factor.key} is 0 in the files, as all its "
                "multiples are; leave out relative, and give values"
            )


def _units(scenarios: Iterable[Scenario]) -> dict[str, str]:
    """Of margins by the names of criteria; none where scenarios have several."""
    found: dict[str, set[str]] = {}
    for scenario in scenarios:
        for criterion in scenario.file.criteria:
            found.setdefault(criterion.name, set()).add(measure(criterion, scenario.units))
    return {name: units.pop() if len(units) == 1 else "" for name, units in found.items()}


def known_runs(source: CampaignSource) -> tuple[Run, ...]:
    """All runs that are known before the first one; none of a search."""
    if source.file.search is not None:
        return ()
    drawn = samples(source.file.sampling, source.file.factors)
    return tuple(
        Run(i * len(drawn) + j, i, sample)
        for i in range(len(source.scenarios)) for j, sample in enumerate(drawn)
    )


def _ends(source: Source, factors: list[FactorTable]) -> Iterator[Scenario]:
    """The scenario as its file has it, and with each factor alone."""
    yield build_scenario(source)
    for factor in factors:
        for value in levels(factor, 2):
            try:
                yield build_scenario(source, changes(source, [factor], {factor.name: value}))
            except InputError as error:
                raise InputError(f"{told(factor, value)}: {error}") from None


def _hash(path: Path) -> str:
    try:
        return hashlib.sha256(path.read_bytes()).hexdigest()
    except OSError as error:
        raise InputError(f"{path}: cannot be read: {error.strerror}") from None
