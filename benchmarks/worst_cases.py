"""Worst cases that a search finds within 500 runs, beside those of 20,000 random runs.

Every shipped campaign is searched (`search = "worst"`) for each of its criteria, with its own
factors. Campaigns without ranges have few cases: all of them take the place of the random runs.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from tempfile import TemporaryDirectory

from benchmarks.report import Part, Record, Section, Settings
from segfmu.validation.campaigns.campaign import Campaign, known_runs, load_campaign
from segfmu.validation.campaigns.result import CampaignResult
from segfmu.validation.campaigns.run import run_campaign
from segfmu.validation.files.campaign_tables import SamplingTable

FOLDER = Path(__file__).parents[1] / "models" / "campaigns"
TITLE = "worst cases: a search of 500 runs, and random runs"
RUNS, RANDOM = 500, 20_000
# in place of a margin of zero, so that any other one is behind by far
SMALLEST = 1e-300
MATRIX = SamplingTable(kind="matrix")


def measure(settings: Settings) -> Part:
    """Least margins of all criteria of the shipped campaigns."""
    count = RANDOM * settings.samples // 500
    sections = [
        Section(path.stem, _records(load_campaign(path), count))
        for path in sorted(FOLDER.glob("[!_]*.toml"))
    ]
    return Part(TITLE, sections, (
        "beaten by: how much worse the worst random case is, as a share of the margin found; "
        "negative where the search is ahead",
    ))


def _records(campaign: Campaign, count: int) -> list[Record]:
    ranges = any(f.range is not None for f in campaign.factors)
    drawn = SamplingTable(kind="random", runs=count, seed=7) if ranges else MATRIX
    brute = with_sampling(campaign, drawn)
    table = _result(brute)
    found = _result(with_sampling(campaign, SamplingTable(runs=RUNS, seed=1), "worst"))
    return [_record(name, found, table) for name in campaign.criteria]


def _record(criterion: str, found: CampaignResult, brute: CampaignResult) -> Record:
    least = [_least(result, criterion) for result in (found, brute)]
    behind = least[0] - least[1]
    if behind != 0.0:
        behind /= abs(least[0]) or SMALLEST
    return {
        "criterion": criterion, "runs of all searches": found.table.num_rows,
        "least margin found": least[0], "other runs": brute.table.num_rows,
        "least margin of these": least[1],
        "beaten by %": 100.0 * behind,
    }


def _least(result: CampaignResult, criterion: str) -> float:
    (row,) = [s for s in result.summaries if s.criterion == criterion]
    assert row.worst is not None
    return row.worst


def with_sampling(
    campaign: Campaign, sampling: SamplingTable, search: str | None = None
) -> Campaign:
    """The campaign with another sampling, or as a search."""
    file = campaign.source.file.model_copy(update={"sampling": sampling, "search": search})
    source = replace(campaign.source, file=file)
    return Campaign(source, known_runs(source), campaign.criteria)


def _result(campaign: Campaign) -> CampaignResult:
    with TemporaryDirectory() as folder:
        return run_campaign(campaign, Path(folder))
