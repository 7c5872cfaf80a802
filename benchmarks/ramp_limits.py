"""What any planner can reach with ramps and holds on the reference problems, n = 4."""

from __future__ import annotations

import json
from typing import Any

import numpy as np
from numpy.typing import NDArray

from benchmarks.durations import REFERENCE, share_of_optimum
from benchmarks.optimal_control import Transition
from benchmarks.ramp_bound import RampBound
from benchmarks.ramp_shapes import Ramps, Smoothstep, SymmetricRamps
from benchmarks.report import Part, Record, Section, Settings

FloatArray = NDArray[np.float64]
# what was asked for, or aimed at: median, 95 %, largest
SMOOTHSTEP = (1.09, 1.30, 1.60)
PLATEAU = (1.015, 1.05, 1.12)
SHOWN = 12
# of the plateau the largest ratio is in question alone
SYMMETRIC = 3


def measure(settings: Settings) -> Part:
    """Ours and the certified bounds, each over the optimum: their distribution, the largest."""
    problems = json.loads(REFERENCE.read_text(encoding="utf-8"))
    sections = []
    for shape, ramps, targets, count in (
        ("smoothstep", Smoothstep(), SMOOTHSTEP, settings.bounded),
        ("plateau", SymmetricRamps(), PLATEAU, min(SYMMETRIC, settings.bounded)),
    ):
        ours = np.array([share_of_optimum(item, shape) or np.inf for item in problems])
        slowest = np.argsort(-ours)[:count]
        bounds = _bounds(problems, ramps, slowest)
        sections.append(_distribution(shape, targets, ours, bounds, slowest.size))
        sections.append(_largest(problems, ours, bounds, slowest[:SHOWN]))
    return Part(
        "What ramps can reach",
        sections,
        (
            "no planner is below: certified for any number of ramps and holds, docs/planner.md",
            "it counts 0 for a problem without a bound; for plateau it admits all symmetric ramps",
        ),
    )


def _bounds(problems: list[dict[str, Any]], ramps: Ramps, chosen: NDArray[np.intp]) -> FloatArray:
    """Bounds over the optimum, 0 where none is sought: the bounds of the quantiles stay true."""
    found = np.zeros(len(problems))
    search = RampBound(ramps)
    for i in chosen:
        bound = search.lower_bound(_transition(problems[i]))
        found[i] = bound / problems[i]["optimal_duration"]
    return found


def _transition(item: dict[str, Any]) -> Transition:
    start, end = ((e[0], e[1], e[2]) for e in (item["start"], item["end"]))
    c = item["limits"]
    return Transition(item["kind"], start, end, (c[0], c[1], c[2], c[3]))


def _distribution(
    shape: str, targets: tuple[float, ...], ours: FloatArray, bounds: FloatArray, count: int
) -> Section:
    rows = {"wanted": targets}
    for name, ratios in (("segfmu", ours), ("no planner is below", bounds)):
        rows[name] = tuple(float(np.quantile(ratios, level)) for level in (0.5, 0.95, 1.0))
    records: list[Record] = [
        {f"{shape}, duration over optimum": name, "median": m, "95 %": high, "largest": most}
        for name, (m, high, most) in rows.items()
    ]
    return Section(f"{ours.size} reference problems, the {count} slowest bounded", records)


def _largest(
    problems: list[dict[str, Any]], ours: FloatArray, bounds: FloatArray, shown: NDArray[np.intp]
) -> Section:
    records: list[Record] = [
        {
            "problem": int(i),
            "kind": problems[i]["kind"],
            "optimum s": problems[i]["optimal_duration"],
            "segfmu": float(ours[i]),
            "bound": float(bounds[i]),
            "segfmu over bound": float(ours[i] / bounds[i]),
        }
        for i in shown
    ]
    return Section("The slowest, duration over optimum", records)
