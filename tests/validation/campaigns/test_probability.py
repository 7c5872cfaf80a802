"""The interval for the probability that a criterion fails."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pyarrow
import pytest
from scipy.stats import binom

from segfmu.validation.campaigns.probability import Probability
from segfmu.validation.campaigns.result import CampaignResult
from segfmu.validation.campaigns.store import about
from segfmu.validation.campaigns.summary_file import write_summary


@pytest.mark.parametrize(("failed", "draws", "told"), [
    (0, 200, "below 1.5 %"), (200, 200, "above 98.5 %"), (3, 200, "0.31 to 4.4 %"),
    (0, 1, "below 95 %"), (100, 200, "42 to 58 %"), (197, 200, "95.6 to 99.69 %"),
])
def test_it_is_told_in_per_cent(failed: int, draws: int, told: str) -> None:
    assert str(Probability(failed, draws)) == told


def test_ends_are_where_the_binomial_distribution_has_its_tails() -> None:
    low, high = Probability(7, 60).interval
    assert binom.sf(6, 60, low) == pytest.approx(0.025)
    assert binom.cdf(7, 60, high) == pytest.approx(0.025)
    assert Probability(0, 60).interval == pytest.approx((0.0, 1.0 - 0.05 ** (1.0 / 60.0)))
    assert Probability(60, 60).interval == pytest.approx((0.05 ** (1.0 / 60.0), 1.0))


def test_it_covers_the_true_probability_as_the_documentation_says() -> None:
    counts = np.arange(201)
    ends = np.array([Probability(int(k), 200).interval for k in counts])
    for true in np.geomspace(1e-3, 0.5, 40):
        inside = (ends[:, 0] <= true) & (true <= ends[:, 1])
        assert binom.pmf(counts, 200, true)[inside].sum() >= 0.925


def _result(folder: Path, draws: int, held: list[bool | None]) -> CampaignResult:
    margins = [None if h is None else 1.0 if h else -1.0 for h in held]
    table = pyarrow.table({
        "run": list(range(len(held))), "passed": [bool(h) for h in held],
        "error": ["no" if h is None else None for h in held],
        "margin.c": pyarrow.array(margins, pyarrow.float64()),
        "holds.c": pyarrow.array(held, pyarrow.bool_()),
    })
    return CampaignResult("n", folder, (), ("c",), table, draws)


def test_a_draw_that_several_scenarios_share_counts_once(tmp_path: Path) -> None:
    held = [True, False, True, None, True, False, False, None]
    (found,) = _result(tmp_path, 4, held).summaries
    # the second fails twice, the third once, the fourth has no verdict
    assert found.fails == Probability(2, 3)


def test_chosen_runs_have_no_probability(tmp_path: Path) -> None:
    (found,) = _result(tmp_path, 0, [True, False]).summaries
    assert found.fails is None


def test_the_summary_has_what_the_table_tells(tmp_path: Path) -> None:
    found = json.loads(write_summary(_result(tmp_path, 200, [True] * 200)).read_text())
    (row,) = found["criteria"]
    assert (row["held"], row["fails"]["told"]) == (200, "below 1.5 %")
    assert row["fails"]["high"] == pytest.approx(1.0 - 0.05 ** (1.0 / 200.0))


def test_a_campaign_of_an_older_version_has_no_draws(tmp_path: Path) -> None:
    (tmp_path / "campaign.json").write_text(
        '{"name": "n", "factors": [], "criteria": ["c"]}', encoding="utf-8"
    )
    assert about(tmp_path)["draws"] == 0
