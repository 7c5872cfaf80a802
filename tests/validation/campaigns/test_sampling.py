"""Samples: the strata of a Latin hypercube, corners, matrices, ranges of all kinds."""

from __future__ import annotations

from itertools import product
from typing import Any

import numpy as np
import pytest
from scipy.stats import qmc

from segfmu.errors import InputError
from segfmu.validation.campaigns.sampling import samples
from segfmu.validation.files.campaign_tables import FactorTable, SamplingTable

A = FactorTable(name="a", key="x", range=[-2.0, 6.0])
B = FactorTable(name="b", key="y", values=["p", "q", "r"])
LOG = FactorTable(name="log", key="z", range=[1e-3, 1e3], scale="log")
WHOLE = FactorTable(name="whole", key="n", range=[1.0, 4.0], integer=True)
VARIANTS = FactorTable(name="v", variants={"calm": {}, "gust": {"true_crane": {}}})


def drawn(kind: str, *factors: FactorTable, **options: Any) -> list[dict[str, Any]]:
    return samples(SamplingTable(kind=kind, **options), factors)


def test_a_latin_hypercube_has_one_run_in_every_stratum_of_every_factor() -> None:
    found = drawn("latin hypercube", A, LOG, runs=50, seed=4)
    places = [(s["a"] + 2.0) / 8.0 for s in found]
    assert sorted(int(50 * p) for p in places) == list(range(50))
    logs = [(np.log10(s["log"]) + 3.0) / 6.0 for s in found]
    assert sorted(int(50 * p) for p in logs) == list(range(50))
    # the factors are not drawn alike
    assert abs(np.corrcoef(places, logs)[0, 1]) < 0.5


@pytest.mark.parametrize("kind", ["latin hypercube", "random", "sobol"])
def test_the_seed_is_all_that_counts(kind: str) -> None:
    first = drawn(kind, A, B, runs=10, seed=1)
    assert first == drawn(kind, A, B, runs=10, seed=1)
    assert first != drawn(kind, A, B, runs=10, seed=2)


def test_random_runs_do_not_know_of_each_other() -> None:
    found = drawn("random", A, runs=400, seed=2)
    places = np.array([(s["a"] + 2.0) / 8.0 for s in found])
    hit = np.unique((400 * places).astype(int)).size / 400.0
    # by chance a stratum stays empty with 1 / e; a Latin hypercube hits all
    assert hit == pytest.approx(1.0 - np.exp(-1.0), abs=0.06)


def test_sobol_is_more_even_than_chance() -> None:
    found = drawn("sobol", A, LOG, runs=256, seed=1)
    points = [[(s["a"] + 2.0) / 8.0, (np.log10(s["log"]) + 3.0) / 6.0] for s in found]
    random = np.random.default_rng(0).random((256, 2))
    assert qmc.discrepancy(points) < 0.2 * qmc.discrepancy(random)


def test_choices_come_equally_often_and_integers_are_whole() -> None:
    found = drawn("latin hypercube", B, WHOLE, VARIANTS, runs=30)
    assert all(sum(s["b"] == name for s in found) == 10 for name in "pqr")
    assert {type(s["whole"]) for s in found} == {int}
    assert {s["whole"] for s in found} == {1, 2, 3, 4}
    assert {s["v"] for s in found} == {"calm", "gust"}


def test_corners_are_the_ends_of_ranges_and_all_values() -> None:
    found = drawn("corners", A, B)
    assert [(s["a"], s["b"]) for s in found] == list(product([-2.0, 6.0], "pqr"))


def test_a_matrix_has_all_levels() -> None:
    grid = FactorTable(name="a", key="x", range=[1.0, 16.0], scale="log", levels=5)
    found = drawn("matrix", grid, VARIANTS)
    assert [s["v"] for s in found] == ["calm", "gust"] * 5
    assert [s["a"] for s in found[::2]] == pytest.approx([1.0, 2.0, 4.0, 8.0, 16.0])
    # ends are exact
    assert (found[0]["a"], found[-1]["a"]) == (1.0, 16.0)


def test_one_at_a_time_begins_with_what_the_files_have() -> None:
    assert drawn("one at a time", A, B) == [
        {}, {"a": -2.0}, {"a": 6.0}, {"b": "p"}, {"b": "q"}, {"b": "r"}
    ]


def test_without_factors_runs_are_equal() -> None:
    assert drawn("matrix") == [{}]
    assert drawn("sobol", runs=3) == [{}, {}, {}]


def test_too_many_combinations_are_refused() -> None:
    wide = [FactorTable(name=f"f{i}", key="x", range=[0.0, 1.0]) for i in range(21)]
    with pytest.raises(InputError, match="more than 1000000 runs"):
        drawn("corners", *wide)
