"""Missions with free states: total time over the optimum by ipopt, refusals, and planning time."""

from __future__ import annotations

from collections.abc import Callable
from time import perf_counter

import numpy as np

from benchmarks.free_missions import Mission, missions
from benchmarks.mission_program import MissionProgram
from benchmarks.report import Part, Record, Section, Settings
from segfmu import SegfmuError, Trajectory, plan

COMPARED = (4, 8)
PLANNED = (4, 30)
SEEDS = (1, 7)
MANY = 1000
WAYS: dict[str, Callable[[Mission], Trajectory]] = {
    "stopping": lambda m: plan(m.waypoints(None, None), m.bounds),
    "velocity free": lambda m: plan(m.waypoints("free", None), m.bounds),
    "both free": lambda m: plan(m.waypoints("free", "free"), m.bounds),
    "both free, no bound of the position": lambda m: plan(
        m.waypoints("free", "free"), m.bounds, overshoot=np.inf
    ),
    "both free, within the waypoints": lambda m: plan(
        m.waypoints("free", "free"), m.bounds, overshoot=0.0
    ),
}


def measure(settings: Settings) -> Part:
    """All tables."""
    quick = settings.samples < 500
    return Part(
        "Free states",
        (
            _over_ipopt(20 if quick else 100), _over_free_jerk(20 if quick else 100),
            _refusals(50 if quick else MANY),
        ),
        ("ipopt bounds velocity, acceleration and jerk at the nodes of 20 cells an interval only, "
         "and positions not at all",),
    )


def _over_ipopt(count: int) -> Section:
    given = list(missions(count, COMPARED, SEEDS[0]))
    programs = {p: MissionProgram(p) for p in range(COMPARED[0], COMPARED[1] + 1)}
    best = np.array([programs[len(m.positions)].solve(m) for m in given])
    records: list[Record] = []
    for name, way in WAYS.items():
        ratios = np.array([way(m).duration for m in given]) / best
        ratios = ratios[np.isfinite(best)]
        records.append({
            "total time over ipopt": name, "missions": ratios.size,
            "median": float(np.median(ratios)), "90 %": float(np.quantile(ratios, 0.9)),
            "largest": float(ratios.max()),
        })
    return Section(f"{count} missions of 4 to 8 waypoints, 3 axes, n = 4", records)


def _over_free_jerk(count: int) -> Section:
    """Dense missions, whose ramps of the acceleration are longer than their intervals, and arcs.

    `plan` has zero jerk at the waypoints, and so has the best of these.
    """
    sizes = range(COMPARED[0], COMPARED[1] + 1)
    free = {p: MissionProgram(p, free_jerk=True) for p in sizes}
    zero = {p: MissionProgram(p) for p in sizes}
    found: dict[str, list[tuple[float, float]]] = {"arc": [], "dense": []}
    for mission in missions(count, COMPARED, SEEDS[0]):
        if mission.kind in found:
            points = len(mission.positions)
            best = free[points].solve(mission)
            ratios = WAYS["both free"](mission).duration / best, zero[points].solve(mission) / best
            if np.all(np.isfinite(ratios)):
                found[mission.kind].append(ratios)
    records: list[Record] = []
    for kind, pairs in found.items():
        for name, values in zip(
            ("plan", "ipopt, zero jerk"), np.array(pairs).reshape(-1, 2).T, strict=True
        ):
            records.append({
                "total time over ipopt with free jerk": f"{kind}: {name}",
                "missions": values.size, "median": float(np.median(values)),
                "90 %": float(np.quantile(values, 0.9)), "largest": float(values.max()),
            })
    return Section(f"arcs and dense ones of {count} missions of 4 to 8 waypoints", records)


def _refusals(count: int) -> Section:
    found: dict[str, list[float]] = {"4 to 12": [], "13 to 21": [], "22 to 30": []}
    refused = dict.fromkeys(found, 0)
    for mission in missions(count, PLANNED, SEEDS[1]):
        size = list(found)[(len(mission.positions) - 4) // 9]
        begun = perf_counter()
        try:
            WAYS["both free"](mission)
        except SegfmuError:
            refused[size] += 1
        found[size].append(perf_counter() - begun)
    records: list[Record] = [
        {"waypoints": size, "missions": len(times), "refused": refused[size],
         "median s": float(np.median(times)), "largest s": max(times)}
        for size, times in found.items()
    ]
    return Section(f"{count} missions of 4 to 30 waypoints, 3 axes, n = 4", records)
