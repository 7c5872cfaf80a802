"""The runs of a campaign in batches: each can follow from what the ones before have found."""

from __future__ import annotations

from collections.abc import Iterator

from segfmu.validation.campaigns.campaign import Campaign, Run
from segfmu.validation.campaigns.rare import Found, rare_cases, rare_probability
from segfmu.validation.campaigns.sampling import known_value
from segfmu.validation.campaigns.search import Case, next_cases
from segfmu.validation.campaigns.store import Store


def batches(campaign: Campaign, store: Store) -> Iterator[list[Run]]:
    """Runs that are to be made; all of a batch are in the store when the next one is asked for."""
    if campaign.searched:
        yield from _searched(campaign, store)
        return
    done = set(store.rows()["run"].to_pylist())
    missing = [run for run in campaign.runs if run.number not in done]
    if missing:
        yield missing


def _searched(campaign: Campaign, store: Store) -> Iterator[list[Run]]:
    """Search on search, of which each knows the runs that those before it have made.

    A run is known when its batch comes, also if an earlier command has made it: so numbers and
    cases do not depend on where a campaign was interrupted.
    """
    following = rare_cases if campaign.rare else next_cases
    known: dict[tuple[int, Case], int] = {}
    margins = {name: _margins(store, name) for name in campaign.searched}
    for scenario in range(len(campaign.source.scenarios)):
        for criterion in campaign.searched:
            while True:
                found = margins[criterion]
                own = {c: found[run] for (s, c), run in known.items() if s == scenario}
                sampling = campaign.source.file.sampling
                samples = following(sampling, campaign.factors, own)
                if not samples:
                    break
                batch = [Run(len(known) + i, scenario, s) for i, s in enumerate(samples)]
                missing = [run for run in batch if run.number not in found]
                if missing:
                    yield missing
                    margins = {name: _margins(store, name) for name in campaign.searched}
                known |= {(scenario, tuple(r.sample.values())): r.number for r in batch}


def probabilities(campaign: Campaign, store: Store) -> dict[str, Found]:
    """What a search for rare failures that is complete says of each of its criteria."""
    rows = store.rows().to_pylist()
    sampling, factors = campaign.source.file.sampling, campaign.factors
    cases = [tuple(known_value(f, row[f.name]) for f in factors) for row in rows]
    found = {}
    for name in campaign.searched:
        margins = {c: row[f"margin.{name}"] for c, row in zip(cases, rows, strict=True)}
        probability = rare_probability(sampling, factors, margins)
        if probability is not None:
            found[name] = probability
    return found


def _margins(store: Store, criterion: str) -> dict[int, float | None]:
    """Margins by the numbers of runs; None of a run that has no verdict."""
    table = store.rows().select(["run", f"margin.{criterion}"])
    return dict(zip(*(column.to_pylist() for column in table.columns), strict=True))
