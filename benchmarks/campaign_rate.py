"""Runs a second of a campaign: the paper's mission at 1 ms, disturbed, with three criteria.

A thousand runs (two hundred with `--quick`) on one worker and on two, by what `segfmu campaign`
calls. The rate is that from a tenth of the runs to the last one, without the start of the workers.
That of a processor has the time of all processes in it, also of the scheduler: it says what a core
makes that does nothing else.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory
from time import perf_counter

import psutil

from benchmarks.report import Part, Record, Section, Settings
from segfmu.validation.campaigns.campaign import Campaign, load_campaign
from segfmu.validation.campaigns.run import run_campaign

FILE = Path(__file__).parents[1] / "models" / "campaigns" / "paper.toml"
TITLE = "campaign: the paper's mission at 1 ms, disturbed, three criteria"


@dataclass(frozen=True)
class Look:
    """What this process and its workers have used so far."""

    runs: int
    clock: float
    processor: float
    memory: int


def measure(settings: Settings) -> Part:
    """Rates and memory on one worker and on two."""
    whole = load_campaign(FILE)
    campaign = Campaign(whole.source, whole.runs[:2 * settings.samples], whole.criteria)
    records = [_record(campaign, jobs) for jobs in (1, 2)]
    wall, core = (
        float(records[1][name] or 0.0) / float(records[0][name] or 1.0)
        for name in ("runs/s", "runs/s of processor")
    )
    return Part(TITLE, [Section(f"{len(campaign.runs)} runs", records)], (
        f"two workers over one: {wall / 2.0:.2f} of twice the rate; {core:.2f} of the rate of a "
        "processor, which other work on the machine does not change as much",
        "more memory: of workers and this process, from a tenth of the runs to the last one",
    ))


def _record(campaign: Campaign, jobs: int) -> Record:
    looks: list[Look] = []
    count = len(campaign.runs)

    def look(done: int, _: int) -> None:
        if (not looks and done >= count // 10) or done == count:
            looks.append(_look(done))

    begin = perf_counter()
    with TemporaryDirectory() as folder:
        run_campaign(campaign, Path(folder), jobs=jobs, progress=look)
    whole = perf_counter() - begin
    first, last = looks[0], looks[-1]
    runs = last.runs - first.runs
    return {
        "workers": jobs, "runs": count, "with start s": whole,
        "runs/s": runs / (last.clock - first.clock),
        "runs/s of processor": runs / (last.processor - first.processor),
        "more memory kB": (last.memory - first.memory) // 1024,
    }


def _look(done: int) -> Look:
    own = psutil.Process()
    every = [own, *own.children(recursive=True)]
    times = [p.cpu_times() for p in every]
    return Look(
        done, perf_counter(), sum(t.user + t.system for t in times),
        sum(p.memory_info().rss for p in every),
    )
