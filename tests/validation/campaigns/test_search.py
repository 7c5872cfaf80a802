"""Searches for worst cases: against formulas, and the same however often they are interrupted."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable
from math import exp, nan
from pathlib import Path
from typing import Any

import numpy as np
import pyarrow
import pytest

from segfmu.errors import InputError
from segfmu.validation.campaigns.batches import batches
from segfmu.validation.campaigns.campaign import Campaign, Run, load_campaign
from segfmu.validation.campaigns.replay import find_run
from segfmu.validation.campaigns.search import next_cases
from segfmu.validation.files.campaign_tables import FactorTable, SamplingTable
from segfmu.validation.files.scenario_file import load_scenario
from tests.validation.campaigns.files import SEARCH, completed, write

RANGES = [FactorTable(name=n, key="k", range=[-1.0, 1.0]) for n in "abc"]
CHOICES = [FactorTable(name=n, key="k", values=[*range(k)]) for n, k in (("p", 4), ("q", 5))]
Margin = Callable[..., float | None]


def searched(factors: list[FactorTable], runs: int, margin: Margin) -> dict[Any, float | None]:
    """All cases of a search."""
    sampling = SamplingTable(runs=runs, seed=2)
    found: dict[Any, float | None] = {}
    while new := next_cases(sampling, factors, found):
        assert not {tuple(s.values()) for s in new} & found.keys()
        found |= {tuple(s.values()): margin(*s.values()) for s in new}
    return found


def valley(a: float, b: float, c: float) -> float:
    """A narrow worst case within the ranges, beside a wide one that is not as bad."""
    near = 5.0 * ((a - 0.31) ** 2 + (b + 0.57) ** 2 + (c - 0.12) ** 2)
    far = (a + 0.5) ** 2 + (b - 0.5) ** 2 + c * c
    return 1.0 - 2.0 * exp(-near) - exp(-far)


def edge(a: float, b: float, c: float) -> float:
    """A worst case at the end of one range, within the others."""
    return 1.0 - a + (b - 0.3) ** 2 + abs(c + 0.2)


@pytest.mark.parametrize("margin", [valley, edge])
def test_it_finds_what_many_random_runs_do_not_beat(margin: Margin) -> None:
    found = searched(RANGES, 500, margin)
    random = np.random.default_rng(5).uniform(-1.0, 1.0, (20_000, 3)).tolist()
    least = min(margin(*point) for point in random)
    assert len(found) <= 500
    assert min(found.values()) <= least + 0.02 * abs(least)


def test_all_choices_are_tried_and_the_runs_are_not_exceeded() -> None:
    found = searched(CHOICES, 100, lambda p, q: p + q)
    assert set(found) == {(p, q) for p in range(4) for q in range(5)}
    assert len(searched(RANGES, 50, edge)) == 50


def test_a_margin_that_is_no_number_is_the_worst_and_a_run_without_one_the_best() -> None:
    found = searched(RANGES, 200, lambda a, b, c: nan if a > 0.5 else None if b > 0.5 else a)
    share = np.mean([margin is not None and np.isnan(margin) for margin in found.values()])
    assert share > 0.5


class Kept:
    """The part of a store that batches need, in memory."""

    def __init__(self, rows: Iterable[dict[str, Any]] = ()) -> None:
        self.kept = list(rows)

    def rows(self) -> pyarrow.Table:
        names = ("run", "margin.follows", "margin.rests")
        return pyarrow.table({n: [row[n] for row in self.kept] for n in names})

    def make(self, made: Iterable[Run]) -> None:
        for r in made:
            sway, payload = r.sample["sway"], r.sample["payload"]
            self.kept.append({
                "run": r.number, "sample": r.sample, "margin.follows": sway * payload,
                "margin.rests": -sway,
            })


def test_where_a_search_was_interrupted_does_not_count(tmp_path: Path) -> None:
    text = SEARCH.replace('search_for = ["follows"]\n', "")
    campaign: Campaign = load_campaign(write(tmp_path, text))
    whole = Kept()
    for batch in batches(campaign, whole):  # type: ignore[arg-type]
        whole.make(batch)
    assert [row["run"] for row in whole.kept] == list(range(len(whole.kept)))
    # the second search takes what the first one has made
    assert 50 < len(whole.kept) < campaign.most == 100
    draw = np.random.default_rng(1)
    parts = Kept()
    for left in range(8):
        for number, batch in enumerate(batches(campaign, parts)):  # type: ignore[arg-type]
            if number == left:
                # killed when some of a batch are there, in any order
                parts.make(draw.permutation(batch)[:draw.integers(1, len(batch) + 1)])
                break
            parts.make(batch)
    for batch in batches(campaign, parts):  # type: ignore[arg-type]
        parts.make(batch)
    assert sorted(parts.kept, key=lambda row: row["run"]) == whole.kept


def test_a_search_as_a_command(
    tmp_path_factory: pytest.TempPathFactory, tmp_path: Path
) -> None:
    result = completed(tmp_path_factory, "search", SEARCH)
    out, campaign = result.folder, load_campaign(result.folder.parent / "c.toml")
    with pytest.raises(InputError, match="run the campaign first"):
        find_run(tmp_path, campaign, 0)
    assert 40 < result.table.num_rows <= 50 and result.searched == ("follows",)
    assert all(row.fails is None for row in result.summaries) and not result.sensitivities
    told = json.loads((out / "results.json").read_text())["criteria"][0]
    # the sway at the start is what counts: its end is the worst case
    assert told["criterion"] == "follows" and told["worst_case"]["sway"] == 1.0
    assert told["worst_margin"] == min(result.column("margin.follows"))
    file = out / f"run_{told['worst_run']}.toml"
    assert told["replay"] == f"segfmu validate {file}"
    assert load_scenario(file).mission.simulation.initial_sway[0] == 1.0
    assert find_run(out, campaign, 7).sample == result.values(7)
    with pytest.raises(InputError, match="no run 50; they are 0 to"):
        find_run(out, campaign, 50)
