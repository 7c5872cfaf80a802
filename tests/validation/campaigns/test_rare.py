"""Probabilities of rare failures against closed forms and brute force."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator, Mapping
from math import nan
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.stats import binom, norm

from segfmu.errors import InputError
from segfmu.validation.campaigns import rare
from segfmu.validation.campaigns.batches import batches, probabilities
from segfmu.validation.campaigns.campaign import load_campaign
from segfmu.validation.campaigns.probability import Probability
from segfmu.validation.campaigns.rare import RareProbability, rare_cases, rare_probability
from segfmu.validation.campaigns.store import read_probabilities, write_probabilities
from segfmu.validation.files.campaign_tables import FactorTable, SamplingTable
from tests.campaign import campaign
from tests.validation.campaigns.files import CAMPAIGN, write
from tests.validation.campaigns.test_search import Kept

FACTORS = [FactorTable(name=n, key="k", range=[-1.0, 1.0]) for n in "abcde"]
RUNS = 5000
Margin = Callable[..., float | None]


class Computed(Mapping[Any, Any]):
    """Margins that are known as soon as they are asked for."""

    def __init__(self, margin: Margin) -> None:
        self.margin, self.asked = margin, 0

    def __contains__(self, _: object) -> bool:
        return True

    def __getitem__(self, case: Any) -> float | None:
        self.asked += 1
        return self.margin(*case)

    def __iter__(self) -> Iterator[Any]:
        raise NotImplementedError

    def __len__(self) -> int:
        raise NotImplementedError


def found(margin: Margin, seed: int = 1, factors: Any = FACTORS, runs: int = RUNS) -> Any:
    sampling = SamplingTable(kind="random", runs=runs, seed=seed)
    return rare_probability(sampling, factors, Computed(margin))


def normals(values: Any) -> Any:
    """Standard normal numbers from even ones between -1 and 1."""
    return norm.ppf(np.clip((np.asarray(values) + 1.0) / 2.0, 1e-16, 1.0 - 1e-16))


def sum_of_normals(probability: float) -> Margin:
    """A margin below 0 with this probability: a sum of normals is normal."""
    bound = -norm.ppf(probability)
    return lambda *values: float(bound - normals(values).sum() / np.sqrt(len(values)))


@campaign(3, 100)
def test_one_in_ten_thousand_is_told_within_a_factor_of_two(count: int) -> None:
    margin = sum_of_normals(1e-4)
    results = [found(margin, seed) for seed in range(count)]
    assert all(isinstance(r, RareProbability) and r.runs <= RUNS for r in results)
    within = [0.5e-4 <= r.probability <= 2e-4 for r in results]
    assert sum(within) >= 0.95 * count
    covered = sum(r.interval[0] <= 1e-4 <= r.interval[1] for r in results)
    # 95 % within what chance allows in one of 1,000 such tests
    assert covered >= binom.ppf(1e-3, count, 0.95)


def test_brute_force_confirms_one_in_a_thousand() -> None:
    """A margin without a closed form: two ways to fail, one of them curved."""

    def margin(values: Any) -> Any:
        z = normals(values)
        return np.minimum(
            4.4 - z[0] - 0.3 * z[1] ** 2 - 0.1 * z[4], 4.3 + (z[2] + z[3]) / np.sqrt(2.0) * 1.35
        )

    random = np.random.default_rng(1).uniform(-1.0, 1.0, (5, 300_000))
    brute = float(np.mean(margin(random) < 0.0))
    assert 0.8e-3 < brute < 4e-3
    result = found(lambda *values: float(margin(np.array(values))), 3)
    assert brute / 2.0 < result.probability < 2.0 * brute
    low, high = result.interval
    assert low < brute < high


@pytest.mark.parametrize(("margin", "draws"), [
    # frequent; never; a margin of two values, from which no step leads on; of runs without verdict
    (lambda a, *_: a + 0.4, 1000), (lambda *_: 1.0, 1000),
    (lambda a, *_: -1.0 if a > 0.99 else 1.0, 1000),
    (lambda a, b, *_: None if b > 0.0 else a + 0.4, None),
    (lambda a, *_: nan if a > 0.5 else 1.0, 1000),
])
def test_what_no_step_leads_to_is_told_by_the_draws(margin: Margin, draws: int | None) -> None:
    result = found(margin)
    assert isinstance(result, Probability)
    points = np.random.default_rng(0).uniform(-1.0, 1.0, (20_000, 5)).tolist()
    margins = [m for m in (margin(*p) for p in points) if m is not None]
    truth = sum(not m >= 0.0 for m in margins) / len(margins)
    low, high = result.interval
    assert low - 0.01 <= truth <= high + 0.01
    assert result.draws == draws if draws else 400 < result.draws < 600


def test_no_verdict_at_all() -> None:
    assert found(lambda *_: None) is None


def test_what_the_steps_do_not_reach_is_below() -> None:
    result = found(sum_of_normals(1e-9))
    assert result.below and result.runs == RUNS
    low, high = result.interval
    assert low == 0.0 and 1e-9 < high < 1e-4
    assert str(result).startswith("below 0.00")
    assert str(RareProbability(1e-4, 0.25, 5000)) == "0.0061 to 0.017 %"


def test_cases_are_asked_for_until_all_margins_are_known_and_the_seed_decides() -> None:
    margin = sum_of_normals(0.01)
    sampling = SamplingTable(kind="random", runs=500, seed=2)
    known: dict[Any, Any] = {}
    state = np.random.default_rng(0)
    while new := rare_cases(sampling, FACTORS, known):
        cases = [tuple(sample.values()) for sample in new]
        assert not set(cases) & known.keys()
        # interrupted anywhere
        for i in state.permutation(len(cases))[: state.integers(1, len(cases) + 1)]:
            known[cases[i]] = margin(*cases[i])
    assert len(known) <= 500
    assert rare_probability(sampling, FACTORS, known) == found(margin, 2, runs=500)


RARE = CAMPAIGN.replace('"latin hypercube"', '"random"').replace("runs = 40", "runs = 500").replace(
    "[sampling]", 'search = "rare"\nsearch_for = ["follows"]\n\n[sampling]'
)


def test_a_campaign_keeps_what_was_found(tmp_path: Path) -> None:
    """Margins are those of a formula: sway times payload, of which one in 50 is above 1.41."""
    task = load_campaign(write(tmp_path, RARE))
    store = Kept()
    for batch in batches(task, store):  # type: ignore[arg-type]
        store.make(batch)
        for row in store.kept:
            row.update(row["sample"])
            row["margin.follows"] = 1.3 - row["sway"] * row["payload"]
    assert task.rare and len(store.kept) <= 500
    random = np.random.default_rng(1)
    truth = np.mean(random.random(10**6) * random.uniform(0.5, 1.5, 10**6) > 1.3)
    store.rows = lambda: _Rows(store.kept)  # type: ignore[method-assign, assignment, return-value]
    results = probabilities(task, store)  # type: ignore[arg-type]
    assert list(results) == ["follows"]
    low, high = results["follows"].interval
    assert low < truth < high
    write_probabilities(tmp_path, results)
    assert read_probabilities(tmp_path) == results
    assert read_probabilities(tmp_path / "none") == {}
    (tmp_path / "probabilities.json").write_text(json.dumps({"c": {"x": 1}}), encoding="utf-8")
    with pytest.raises(InputError, match="no probabilities"):
        read_probabilities(tmp_path)


class _Rows:
    def __init__(self, rows: list[dict[str, Any]]) -> None:
        self._rows = rows

    def to_pylist(self) -> list[dict[str, Any]]:
        return self._rows


@pytest.mark.parametrize(("old", "new", "text"), [
    ('"random"', '"sobol"', "needs sampling.kind random"),
    ('["s.toml"]', '["s.toml", "./s.toml"]', "takes one scenario, got 2"),
    ("runs = 500", "runs = 499", "runs of at least 500, got 499"),
])
def test_a_file_that_does_not_fit_is_refused(
    old: str, new: str, text: str, tmp_path: Path
) -> None:
    with pytest.raises(InputError, match=text):
        load_campaign(write(tmp_path, RARE.replace(old, new)))


def test_without_the_library_the_way_out_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(rare, "find_spec", lambda _: None)
    with pytest.raises(InputError, match=r"pip install 'segfmu\[rare\]'"):
        rare.require_package()
