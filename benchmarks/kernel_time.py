"""Time of one plan without Python: segfmu's compiled kernels beside Ruckig in C++."""

from __future__ import annotations

from collections.abc import Sequence
from ctypes import CDLL
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from benchmarks.drivers import Driver, DriverError, ruckig_library, segfmu_library
from benchmarks.problems import Problems, random_problems
from benchmarks.report import Part, Record, Section, Settings
from benchmarks.timing import ratios

FloatArray = NDArray[np.float64]
SEED = 23
BLOCK = 100
PLATEAU = 1
TITLE = "Planning time in C and C++, -O3"


@dataclass(frozen=True)
class Contestant:
    """A function of a driver."""

    name: str
    library: str
    function: str
    smoothness: int


RUCKIG = Contestant("Ruckig in C++", "ruckig", "run_ruckig", 2)
ONE_AXIS = (
    RUCKIG,
    Contestant("segfmu profile, n = 2", "segfmu", "run_profile", 2),
    Contestant("segfmu profile, n = 4", "segfmu", "run_profile", 4),
    Contestant("segfmu_plan, n = 2", "segfmu", "run_plan", 2),
    Contestant("segfmu_plan, n = 4", "segfmu", "run_plan", 4),
)
THREE_AXES = (RUCKIG, *ONE_AXIS[3:])


def measure(settings: Settings) -> Part:
    """Times of 1 and 3 axes, rest to rest and moving; one line where nothing can be compiled."""
    try:
        libraries = {
            "segfmu": segfmu_library(settings.folder), "ruckig": ruckig_library(settings.folder)
        }
    except DriverError as problem:
        return Part(TITLE, (), (f"not measured: {problem}",))
    sections, notes = [], []
    for axes, contestants in ((1, ONE_AXIS), (3, THREE_AXES)):
        for kind in ("rest to rest", "moving"):
            problems = random_problems(kind, axes, 4 * settings.samples, SEED)
            section, difference = _section(kind, problems, contestants, libraries, settings)
            sections.append(section)
            notes.append(f"{section.title}: n = 2 within {difference:.1e} s of Ruckig's durations")
    return Part(
        TITLE,
        sections,
        (
            f"mean and ratio of means: {settings.repetitions} passes in interleaved blocks of "
            f"{BLOCK} problems, the clock read once a block; median, 99 % and largest: it is read "
            "at every call, which adds up to 0.05 us; for the last two a problem counts with its "
            "least time of all passes",
            "profile: phases of the shortest profile, what Ruckig computes; segfmu_plan: "
            "synchronised, expanded to polynomials and checked against every limit",
            *notes,
        ),
    )


def _section(
    kind: str,
    problems: Problems,
    contestants: Sequence[Contestant],
    libraries: dict[str, CDLL],
    settings: Settings,
) -> tuple[Section, float]:
    """The table, and the largest difference of durations at n = 2 from Ruckig's [s]."""
    def drivers(some: Problems) -> list[Driver]:
        return [
            Driver(libraries[c.library], c.function, some, c.smoothness, PLATEAU)
            for c in contestants
        ]

    tried = drivers(problems)
    for driver in tried:
        driver()
    durations = np.array([driver.durations for driver in tried])
    both = np.isfinite(durations).all(axis=0)
    solved = problems.pick(both)
    like = [c.smoothness == RUCKIG.smoothness for c in contestants]
    difference = float(np.abs(durations[like] - durations[0])[:, both].max())
    blocks = [
        drivers(solved.pick(np.arange(solved.count) // BLOCK == b))
        for b in range(-(-solved.count // BLOCK))
    ]
    times = _block_times(blocks, settings.repetitions)
    means = times.sum(axis=1) / solved.count
    records: list[Record] = []
    for row, (contestant, driver) in enumerate(zip(contestants, drivers(solved), strict=True)):
        single = np.zeros((settings.repetitions, solved.count))
        for times_once in single:
            driver(times_once)
        least = single.min(axis=0)
        records.append({
            "planner": contestant.name,
            "mean us": float(np.median(times[row], axis=1).sum() / solved.count),
            "median us": float(np.median(single)),
            "99 % us": float(np.quantile(least, 0.99)),
            "largest us": float(least.max()),
            **ratios(means[row], means[0]),
        })
    plural = "axis" if problems.axes == 1 else "axes"
    title = f"{problems.axes} {plural}, {kind}, {solved.count} problems"
    return Section(title, records), difference


def _block_times(blocks: list[list[Driver]], repetitions: int) -> FloatArray:
    """Time of every block [us], shape (contestants, blocks, repetitions), after one warm-up."""
    times = np.zeros((len(blocks[0]), len(blocks), repetitions))
    for repetition in range(-1, repetitions):
        for turn, block in enumerate(blocks):
            for i in range(len(block)):
                row = (i + turn) % len(block)
                times[row, turn, repetition] = block[row]()
    return times
