"""What any planner can reach with the paper's smoothstep ramps on the reference problems."""

from __future__ import annotations

import json
from typing import Any

import numpy as np

from benchmarks.durations import REFERENCE, share_of_optimum
from benchmarks.optimal_control import Transition
from benchmarks.ramp_bound import RampBound
from benchmarks.report import Part, Record, Section, Settings

# what was asked for: median, 95 %, largest
TARGETS = (1.09, 1.30, 1.60)
SHOWN = 12


def measure(settings: Settings) -> Part:
    """Ours and the certified bounds, each over the optimum: their distribution, the largest."""
    problems = json.loads(REFERENCE.read_text(encoding="utf-8"))
    ours = np.array([share_of_optimum(item, "smoothstep") or np.inf for item in problems])
    slowest = np.argsort(-ours)
    # a problem without a bound counts as 0, which keeps the bounds of the quantiles true
    bounds = np.zeros(ours.size)
    ramps = RampBound()
    for i in slowest[: settings.bounded]:
        bounds[i] = ramps.lower_bound(_transition(problems[i])) / problems[i]["optimal_duration"]
    return Part(
        "What smoothstep ramps can reach",
        (_distribution(ours, bounds), _largest(problems, ours, bounds, slowest)),
        (
            "bound: certified for any number of smoothstep ramps and holds (docs/planner.md)",
            f"sought for the {min(settings.bounded, ours.size)} slowest problems; 0 for the others",
        ),
    )


def _transition(item: dict[str, Any]) -> Transition:
    start, end = ((e[0], e[1], e[2]) for e in (item["start"], item["end"]))
    c = item["limits"]
    return Transition(item["kind"], start, end, (c[0], c[1], c[2], c[3]))


def _distribution(ours: np.ndarray, bounds: np.ndarray) -> Section:
    rows: dict[str, tuple[float, ...]] = {"asked for": TARGETS}
    for name, ratios in (("segfmu", ours), ("no planner is below", bounds)):
        rows[name] = tuple(float(np.quantile(ratios, level)) for level in (0.5, 0.95, 1.0))
    records: list[Record] = [
        {"duration over optimum": name, "median": m, "95 %": high, "largest": most}
        for name, (m, high, most) in rows.items()
    ]
    return Section(f"Smoothstep, n = 4, {ours.size} reference problems", records)


def _largest(
    problems: list[dict[str, Any]], ours: np.ndarray, bounds: np.ndarray, slowest: np.ndarray
) -> Section:
    records: list[Record] = [
        {
            "problem": int(i),
            "kind": problems[i]["kind"],
            "optimum s": problems[i]["optimal_duration"],
            "segfmu": float(ours[i]),
            "bound": float(bounds[i]),
            "segfmu over bound": float(ours[i] / bounds[i]) if bounds[i] > 0.0 else None,
        }
        for i in slowest[:SHOWN]
    ]
    return Section("The slowest of them, duration over optimum", records)
