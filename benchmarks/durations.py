"""How close durations are to the optimum, and at smoothness 2 to Ruckig's."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.optimal_control import Transition, earliest
from benchmarks.problems import Problems, random_problems
from benchmarks.report import Part, Record, Section, Settings
from segfmu import InfeasibleError, Limits, Waypoint, plan

# 150 single-axis problems, n = 4; their optima, by linear programming, are known to about 0.5 %,
# but for one: what a plan exceeds by more than SUSPECT is computed again
SUSPECT = 1.15
REFERENCE = Path(__file__).parents[1] / "tests" / "data" / "planner-problems.json"
SEED = 5
EQUAL = 1e-6
SLOWER = 0.01
OUTCOMES = (
    "equal within 1e-6",
    "shorter",
    "longer by up to 1 %",
    "longer by more than 1 %",
    "start passes the velocity limit: segfmu refuses, Ruckig plans beyond it",
    "target needs more than the velocity limit: both refuse",
    "refused by segfmu alone, other reasons",
    "refused by Ruckig alone, other reasons",
    "refused by both, other reasons",
)


def measure(settings: Settings) -> Part:
    """Both tables."""
    problems = random_problems("mixed", 1, settings.problems, SEED)
    return Part(
        "Durations",
        (_against_optimum(), _against_ruckig(problems)),
        (
            f"equal: within {EQUAL:g} s, relative above 1 s",
            "start passes the limit: even full jerk towards zero acceleration passes the velocity "
            "limit after the start; target: it did so before the target",
            "smoothness 3: the snap may jump, as that of the optimum does",
            f"over optimum: where a plateau plan takes over {SUSPECT:g} of it, that of a linear "
            "program over 100 cells",
        ),
    )


def _against_optimum() -> Section:
    problems = [checked(item) for item in json.loads(REFERENCE.read_text(encoding="utf-8"))]
    records: list[Record] = []
    for shape, smoothness in (("plateau", 3), ("plateau", 4), ("smoothstep", 4)):
        found = [share_of_optimum(item, shape, smoothness) for item in problems]
        ratios = np.array([ratio for ratio in found if ratio is not None])
        records.append({
            "ramps": shape,
            "smoothness": smoothness,
            "median": float(np.median(ratios)),
            "95 %": float(np.quantile(ratios, 0.95)),
            "largest": float(ratios.max()),
            "failures": len(found) - ratios.size,
        })
    return Section(f"Duration over optimum, snap limited, {len(problems)} problems", records)


def checked(item: dict[str, Any]) -> dict[str, Any]:
    """A reference problem; its optimum that of a linear program where a plan is far from it."""
    ratio = share_of_optimum(item, "plateau")
    if ratio is None or ratio < SUSPECT:
        return item
    transition = Transition("", tuple(item["start"]), tuple(item["end"]), tuple(item["limits"]))
    known = ratio * item["optimal_duration"]
    return item | {"optimal_duration": earliest(transition, known, 100, 1e-3)}


def share_of_optimum(item: dict[str, Any], shape: str, smoothness: int = 4) -> float | None:
    """Duration of the plan for a reference problem over its optimum; None where it is refused."""
    points = [Waypoint(*item[end]) for end in ("start", "end")]
    try:
        trajectory = plan(points, Limits(*item["limits"]), shape=shape, smoothness=smoothness)
    except InfeasibleError:
        return None
    return float(trajectory.duration / item["optimal_duration"])


def _against_ruckig(problems: Problems) -> Section:
    ours, theirs = _segfmu_durations(problems), _ruckig_durations(problems)
    groups: dict[str, list[float]] = {name: [] for name in OUTCOMES}
    for i, (a, b) in enumerate(zip(ours, theirs, strict=True)):
        difference = abs(a - b) if a is not None and b is not None else 0.0
        groups[_outcome(problems, i, a, b)].append(difference)
    both = sum(len(groups[name]) for name in OUTCOMES[:4])
    records: list[Record] = []
    for i, (name, differences) in enumerate(groups.items()):
        planned = i < 4 and both > 0
        records.append({
            "n = 2, limits up to jerk": name,
            "problems": len(differences),
            "of both planned": f"{len(differences) / both:.3%}" if planned else None,
            "largest difference s": max(differences, default=0.0) if planned else None,
        })
    return Section(f"{problems.count} random problems, 1 axis, against Ruckig", records)


def _segfmu_durations(problems: Problems) -> list[float | None]:
    found: list[float | None] = []
    for i in range(problems.count):
        try:
            trajectory = plan(problems.waypoints(i), problems.bounds(i, 2), smoothness=2)
            found.append(trajectory.duration)
        except InfeasibleError:
            found.append(None)
    return found


def _ruckig_durations(problems: Problems) -> list[float | None]:
    from ruckig import Ruckig, RuckigError, Trajectory

    ruckig, trajectory = Ruckig(1), Trajectory(1)
    found: list[float | None] = []
    for i in range(problems.count):
        try:
            ruckig.calculate(problems.ruckig_input(i), trajectory)
            found.append(float(trajectory.duration))
        except RuckigError:
            found.append(None)
    return found


def _outcome(problems: Problems, i: int, ours: float | None, theirs: float | None) -> str:
    if ours is not None and theirs is not None:
        longer = ours - theirs
        if abs(longer) <= EQUAL * max(theirs, 1.0):
            return OUTCOMES[0]
        if longer < 0.0:
            return OUTCOMES[1]
        return OUTCOMES[2] if longer <= SLOWER * theirs else OUTCOMES[3]
    start, target = _excess(problems, i, 0, 1.0), _excess(problems, i, 1, -1.0)
    if ours is None and theirs is None:
        return OUTCOMES[5] if target else OUTCOMES[8]
    if ours is None:
        return OUTCOMES[4] if start else OUTCOMES[6]
    return OUTCOMES[7]


def _excess(problems: Problems, i: int, end: int, direction: float) -> bool:
    """Whether full jerk towards zero acceleration, forwards or backwards, passes the limit."""
    velocity, _, jerk, _ = problems.limits[i, 0]
    v, a = problems.velocities[i, end, 0], problems.accelerations[i, end, 0]
    return bool(abs(v + direction * a * abs(a) / (2.0 * jerk)) > velocity)
