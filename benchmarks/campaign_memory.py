"""Memory of a long campaign: that of the paper's mission with as many runs as `--problems` says.

`python -m benchmarks --only mem --problems 100000` takes some minutes on two cores. Steps are of
10 ms: what a run leaves does not depend on its rows, which it gives back. Shown is the resident
memory of the process with scheduler and table, and of its workers, at a twentieth of the runs and
at each tenth. The campaign is flat if they stay where they are.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from tempfile import TemporaryDirectory
from time import perf_counter

import psutil

from benchmarks.report import Part, Record, Section, Settings
from benchmarks.worst_cases import with_sampling
from segfmu.validation.campaigns.campaign import Campaign, load_campaign
from segfmu.validation.campaigns.run import run_campaign
from segfmu.validation.files.campaign_tables import SamplingTable

FILE = Path(__file__).parents[1] / "models" / "campaigns" / "paper.toml"
TITLE = "memory of a campaign: the paper's mission, disturbed, three criteria"
STEP = 0.01  # s
MEGABYTE = 1 << 20


def measure(settings: Settings) -> Part:
    """Memory of all processes from the first runs to the last one."""
    count = settings.problems
    looks = [count // 20, *(count * tenth // 10 for tenth in range(1, 11))]
    campaign = with_sampling(
        _coarse(load_campaign(FILE)), SamplingTable(kind="random", runs=count, seed=1)
    )
    records: list[Record] = []
    begin = perf_counter()

    def look(done: int, _: int) -> None:
        while len(records) < len(looks) and done >= looks[len(records)]:
            records.append(_record(done, perf_counter() - begin))

    with TemporaryDirectory() as folder:
        run_campaign(campaign, Path(folder), progress=look)
    return Part(TITLE, [Section(f"{count} runs", records)])


def _coarse(campaign: Campaign) -> Campaign:
    """The campaign with longer steps."""
    scenarios = [
        replace(source, data={**source.data, "step": STEP}) for source in campaign.source.scenarios
    ]
    return replace(campaign, source=replace(campaign.source, scenarios=tuple(scenarios)))


def _record(done: int, seconds: float) -> Record:
    own = psutil.Process()
    others = sum(p.memory_info().rss for p in own.children(recursive=True))
    scheduler = own.memory_info().rss
    return {
        "runs": done, "time s": seconds, "scheduler MB": scheduler / MEGABYTE,
        "workers MB": others / MEGABYTE, "all MB": (scheduler + others) / MEGABYTE,
    }
