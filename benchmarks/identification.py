"""How often intervals of identified parameters cover the truth, and how unseen logs are followed.

Logs are those of random cranes (`synthetic_logs`), the search begins at their nominal masses with
ideal drives, without friction. An interval at 95 % is right in 90 to 99 of 100 logs.
"""

from __future__ import annotations

from collections import defaultdict
from concurrent.futures import ProcessPoolExecutor
from itertools import product
from os import cpu_count
from time import perf_counter

import numpy as np

from benchmarks.report import Part, Record, Section, Settings
from benchmarks.synthetic_logs import synthetic
from segfmu.validation.identification.identify import identify
from segfmu.validation.identification.result import Identification

TITLE = "identification: how often intervals at 95 % cover the truth, and unseen logs"
# crane, drives
Kind = tuple[str, str]
KINDS: tuple[Kind, ...] = tuple(product(("lab", "quay"), ("velocity", "force")))


def measure(settings: Settings) -> Part:
    """Coverage and fit of 100 logs of each kind."""
    count = settings.samples // 5
    return Part(
        TITLE, [section for kind in KINDS for section in _sections(kind, count)],
        ("load: fit index of the load's path in another log of the same crane",),
    )


def identified(kind: Kind, seed: int) -> tuple[Identification, dict[str, float]]:
    """A log of a random crane identified, with the true values."""
    log, other = (synthetic(*kind, seed, unseen=unseen) for unseen in (False, True))
    return identify(log.columns, log.crane, validation=other.columns, held_out=0.0), log.truth


def _one(task: tuple[Kind, int]) -> tuple[dict[str, bool], float, float]:
    """Which true values are covered, the fit of the unseen log's load, and the time it took."""
    before = perf_counter()
    found, truth = identified(*task)
    covered = {e.key: bool(e.low <= truth[e.key] <= e.high) for e in found.estimates}
    (unseen,) = found.predicted
    assert unseen.load is not None
    return covered, unseen.load, perf_counter() - before


def _sections(kind: Kind, count: int) -> list[Section]:
    with ProcessPoolExecutor(cpu_count()) as pool:
        results = list(pool.map(_one, [(kind, seed) for seed in range(count)]))
    covered: dict[str, list[bool]] = defaultdict(list)
    for parameters, _, _ in results:
        for key, right in parameters.items():
            covered[key].append(right)
    title = f"{', '.join(kind)} drives"
    intervals: list[Record] = [
        {"parameter": key, "told in": len(right), "covered in": sum(right)}
        for key, right in covered.items()
    ]
    loads = [load for _, load, _ in results]
    times = [time for *_, time in results]
    followed: Record = {
        "logs": count, "load, least": min(loads), "load, median": float(np.median(loads)),
        "time of one, median [s]": float(np.median(times)),
    }
    return [Section(title, intervals), Section(f"{title}: another log", [followed])]
