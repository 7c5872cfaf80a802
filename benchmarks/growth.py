"""How the time of a plan grows with the number of axes and of waypoints."""

from __future__ import annotations

from ctypes import CDLL
from time import perf_counter_ns

import numpy as np
from numpy.typing import NDArray

from benchmarks.drivers import DriverError, mission_time, segfmu_library
from benchmarks.report import Part, Record, Section, Settings
from segfmu import Limits, Waypoint, plan

FloatArray = NDArray[np.float64]
AXES = (1, 2, 3, 4, 6, 8, 10, 12)
WAYPOINTS = (2, 5, 10, 20, 50, 100, 200, 500, 1000)
LIMITS = (1.0, 1.0, 2.0, 20.0)
SEED = 31
DRAWS = 40
ROOM = 200


def measure(settings: Settings) -> Part:
    """Times of n = 4 over 1 to 12 axes, and over 2 to 1,000 waypoints of 3 axes."""
    notes = [
        f"median over up to {DRAWS} random missions a row, each at its least time of "
        f"{settings.repetitions}; inner waypoints move",
        "exponent: slope of log time over log size, fitted over the larger half of the sizes",
    ]
    library = None
    try:
        library = segfmu_library(settings.folder)
    except DriverError as problem:
        notes.append(f"segfmu_plan in C not measured: {problem}")
    # few draws of the long missions, whose intervals average by themselves
    by_axes = [_row(library, 5, axes, DRAWS, settings) for axes in AXES]
    by_waypoints = [
        _row(library, points, 3, max(3, min(DRAWS, ROOM // points)), settings)
        for points in WAYPOINTS
    ]
    return Part(
        "Growth",
        (_section("5 waypoints", "axes", AXES, by_axes),
         _section("3 axes", "waypoints", WAYPOINTS, by_waypoints)),
        tuple(notes),
    )


def _section(
    title: str, name: str, sizes: tuple[int, ...], rows: list[tuple[float, float]]
) -> Section:
    half = len(sizes) // 2
    taken = np.array(rows)
    slopes = np.polyfit(np.log(sizes[half:]), np.log(taken[half:]), 1)[0]
    lines = [*zip(map(str, sizes), taken, strict=True), ("exponent", slopes)]
    records: list[Record] = [
        {name: label, "segfmu.plan ms": float(python), "segfmu_plan in C ms": _known(native)}
        for label, (python, native) in lines
    ]
    return Section(f"{title}, n = 4, times over the number of {name}", records)


def _known(value: float) -> float | None:
    return None if np.isnan(value) else float(value)


def _row(
    library: CDLL | None, points: int, axes: int, draws: int, settings: Settings
) -> tuple[float, float]:
    """Median times [ms] of segfmu.plan and of segfmu_plan in C (NaN without a library)."""
    random = np.random.default_rng((SEED, points, axes))
    found = [_times(library, _mission(random, points, axes), settings) for _ in range(draws)]
    python, native = np.median(found, axis=0)
    return float(python), float(native)


def _mission(random: np.random.Generator, points: int, axes: int) -> FloatArray:
    """States (3, points, axes): steps of 0.5 to 1.5 m, inner points move on at up to 0.4 m/s."""
    steps = random.uniform(0.5, 1.5, (points, axes)) * random.choice([-1.0, 1.0], (1, axes))
    states = np.zeros((3, points, axes))
    states[0] = np.cumsum(steps, axis=0)
    inner = (points - 2, axes)
    states[1, 1:-1] = random.uniform(0.0, 0.4, inner) * np.sign(steps[1:-1])
    states[2, 1:-1] = random.uniform(-0.2, 0.2, inner)
    return states


def _times(library: CDLL | None, states: FloatArray, settings: Settings) -> tuple[float, float]:
    points = [Waypoint(*state) for state in states.transpose(1, 0, 2)]
    limits = Limits(*LIMITS)
    table = limits.table(states.shape[2], 4)
    python, native = [], []
    for _ in range(settings.repetitions):
        begun = perf_counter_ns()
        plan(points, limits)
        python.append((perf_counter_ns() - begun) * 1e-6)
        native.append(np.nan if library is None else 1e-3 * mission_time(library, states, table))
    return min(python), min(native)
