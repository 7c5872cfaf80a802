"""Two campaigns run by run: intervals that cover the true difference, and what is refused."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pyarrow
import pytest
from scipy.stats import binom, ttest_rel

from segfmu.errors import InputError
from segfmu.validation.campaigns.result import CampaignResult

WIDE, GAIN = 5.0, 0.1


def result(
    name: str, factor: Any, margins: Any, draws: int | None = None, **more: Any
) -> CampaignResult:
    margins = [None if m is None else float(m) for m in margins]
    table = pyarrow.table({
        "run": list(range(len(margins))), "f": [float(v) for v in factor],
        "passed": [m is not None and m >= 0.0 for m in margins],
        "margin.c": pyarrow.array(margins, pyarrow.float64()),
        "holds.c": pyarrow.array([None if m is None else m >= 0.0 for m in margins]),
    })
    count = len(margins) if draws is None else draws
    return CampaignResult(name, Path(), ("f",), ("c",), table, count, **more)


def pair(seed: int, count: int = 40) -> tuple[CampaignResult, CampaignResult]:
    """Margins that depend far more on the factor than on which campaign it is."""
    draw = np.random.default_rng(seed)
    factor = draw.uniform(-1.0, 1.0, count)
    old = WIDE * factor + draw.normal(0.0, 0.2, count)
    new = WIDE * factor + GAIN + draw.normal(0.0, 0.2, count)
    return result("new", factor, new), result("old", factor, old)


def test_intervals_cover_the_true_difference_and_are_those_of_a_paired_test() -> None:
    covered = 0
    for seed in range(400):
        new, old = pair(seed)
        found = new.against(old)["c"]
        assert found.low is not None and found.high is not None
        covered += found.low <= GAIN <= found.high
    # 95 % within what chance allows in one of 10,000 such tests
    assert binom.ppf(5e-5, 400, 0.95) <= covered <= binom.ppf(1.0 - 5e-5, 400, 0.95)
    interval = ttest_rel(new.column("margin.c"), old.column("margin.c")).confidence_interval()
    assert (found.low, found.high) == pytest.approx(tuple(interval))


def test_counts_and_words() -> None:
    new = result("new", [1, 2, 3, 4, 5], [0.1, -0.2, 0.5, None, 0.4])
    old = result("old", [1, 2, 3, 4, 5], [-0.1, 0.1, 0.1, 0.3, -0.1])
    found = new.against(old)["c"]
    assert (found.pairs, found.better, found.worse) == (4, 3, 1)
    assert (found.repaired, found.broken) == (2, 1)
    assert found.mean == pytest.approx((0.2 - 0.3 + 0.4 + 0.5) / 4.0)
    assert found.verdict == "no difference told"
    assert str(found).endswith(
        "better in 3, worse in 1 of 4 runs; 2 repaired, 1 broken"
    )
    table = new.against(old).to_pandas()
    assert table.loc[0, "verdict"] == found.verdict and table.loc[0, "pairs"] == 4
    with pytest.raises(KeyError):
        new.against(old)["d"]


@pytest.mark.parametrize(("gain", "verdict"), [(1.0, "better"), (-1.0, "worse")])
def test_a_clear_difference_has_a_direction(gain: float, verdict: str) -> None:
    noise = np.random.default_rng(1).normal(0.0, 0.1, 20)
    assert result("new", range(20), gain + noise).against(
        result("old", range(20), np.zeros(20))
    )["c"].verdict == verdict


def test_scenarios_share_their_draws_and_chosen_runs_have_no_interval() -> None:
    zeros, ones = np.zeros(8), np.array([1.0, 2.0, 1.5, 1.0] * 2)
    factor = [1, 2, 3, 4] * 2
    found = result("n", factor, ones, 4).against(result("o", factor, zeros, 4))["c"]
    half = result("n", factor[:4], ones[:4]).against(result("o", factor[:4], zeros[:4]))["c"]
    assert (found.low, found.high) == (half.low, half.high) and found.pairs == 8
    chosen = result("n", factor, ones, 0).against(result("o", factor, zeros, 0))["c"]
    assert (chosen.low, chosen.verdict) == (None, "not drawn at random")


def test_what_cannot_be_compared_is_refused() -> None:
    one = result("one", [1, 2], [0.1, 0.2])
    with pytest.raises(InputError, match=r"run 1 has f 2\.0 in one and 3\.0 in two"):
        one.against(result("two", [1, 3], [0.1, 0.2]))
    with pytest.raises(InputError, match="one has 2 runs, two 3"):
        one.against(result("two", [1, 2, 3], [0.1, 0.2, 0.3]))
    folder: Any = "out/old"
    with pytest.raises(InputError, match="other must be a CampaignResult, got 'out/old'"):
        one.against(folder)
    with pytest.raises(InputError, match="two is a search"):
        one.against(result("two", [1, 2], [0.1, 0.2], searched=("c",)))
    with pytest.raises(InputError, match="c: margins are in m in one and in rad in two; give crit"):
        result("one", [1, 2], [0.1, 0.2], units={"c": "m"}).against(
            result("two", [1, 2], [0.1, 0.2], units={"c": "rad"})
        )
    with pytest.raises(InputError, match="no run has a margin in both"):
        one.against(result("two", [1, 2], [None, None]))
