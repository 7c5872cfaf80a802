"""Durations of plans, compared with another version: who takes longer, and what is refused anew.

`python -m tests.property.plan_durations --against OTHER` plans the shared problems and the random
ones of the benchmarks with the package of this checkout and with that of OTHER, another checkout
whose extension is compiled, and prints ratios of the durations. It calls the public face of segfmu
alone, so that older versions run it as well.
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np

import segfmu

ROOT = Path(__file__).parents[2]
# kind, smoothness, shape, limits, and waypoints of positions, velocities and accelerations
Problem = dict[str, Any]


def shared_problems() -> list[Problem]:
    """The problems of `tests/data`, at every smoothness and shape that bounds their ramps."""
    table = json.loads((ROOT / "tests" / "data" / "planner-problems.json").read_text("utf-8"))
    found = []
    for shape, least in (("plateau", 2), ("smoothstep", 3)):
        for n in range(least, 7):
            found += [
                {
                    "kind": f"shared, {shape}", "n": n, "shape": shape,
                    "limits": item["limits"][: 3 if n == 2 else 4],
                    "points": [item["start"], item["end"]],
                }
                for item in table
            ]
    return found


def random_problems(count: int) -> list[Problem]:
    """Single axes of the kinds in the benchmarks of completeness and durations."""
    from benchmarks.completeness import constructed, random_limits, random_problem

    found = []
    for n in range(2, 7):
        for kind in ("rest", "moving", "short", "ties", "braked"):
            random = np.random.default_rng((7, n, len(kind)))
            for _ in range(count):
                limits, state = random_problem(random, max(n, 3), kind)
                v, a, w, b, y = state.tolist()
                found.append({
                    "kind": kind, "n": n, "shape": "plateau", "limits": limits[:-1].tolist(),
                    "points": [[0.0, v, a], [y, w, b]],
                })
        random = np.random.default_rng((8, n))
        for _ in range(count):
            motion = constructed(random, n, 0.3) if n > 2 else None
            if motion is not None:
                v, a, w, b, y = motion.state.tolist()
                found.append({
                    "kind": "constructed", "n": n, "shape": "plateau",
                    "limits": motion.limits[:n].tolist(), "points": [[0.0, v, a], [y, w, b]],
                })
        random = np.random.default_rng((9, n))
        for _ in range(count):
            limits = random_limits(random, n)
            share = random.uniform(-1.0, 1.0, (2, 2))
            share[random.random((2, 2)) < 0.3] = 0.0
            states = share * limits[:2]
            found.append({
                "kind": "mixed", "n": n, "shape": "plateau", "limits": limits[: max(n, 3)].tolist(),
                "points": [
                    [0.0, *states[0]], [2.0 * random.uniform(-1.0, 1.0) * limits[0], *states[1]]
                ],
            })
    return found


def several_axes(count: int) -> list[Problem]:
    """Plans of several axes and intervals, which have to meet."""
    from tests.property.plan_numbers import request

    random = np.random.default_rng(10)
    found = []
    for _ in range(count):
        points, limits, n, shape = request(random)
        table = np.array(limits.table(len(points[0].position), n))[:, : max(n, 3)]
        found.append({
            "kind": f"several axes, {shape}", "n": n, "shape": shape,
            "limits": [row.tolist() for row in table.T],
            "points": [
                [np.asarray(values).tolist() for values in (p.position, p.velocity, p.acceleration)]
                for p in points
            ],
        })
    return found


def duration(problem: Problem) -> float:
    """Duration of the plan [s]; -1 where it is refused, 0 with nothing to do."""
    points = [segfmu.Waypoint(*state) for state in problem["points"]]
    limits = [None if np.all(np.equal(c, 0.0)) else c for c in problem["limits"]]
    try:
        return segfmu.plan(
            points, segfmu.Limits(*limits), smoothness=problem["n"], shape=problem["shape"]
        ).duration
    except segfmu.InfeasibleError:
        return -1.0
    except segfmu.InputError:
        return 0.0


def durations(root: Path, problems: Path) -> np.ndarray:
    """Durations with the package of a checkout."""
    done = subprocess.run(
        [sys.executable, __file__, "--problems", str(problems)], stdout=subprocess.PIPE, text=True,
        check=True, env=os.environ | {"PYTHONPATH": str(root / "src")}, cwd=root,
    )
    return np.array(json.loads(done.stdout))


def compare(problems: list[Problem], old: np.ndarray, new: np.ndarray) -> int:
    """Print a line for each kind; how many plans are refused anew."""
    groups: dict[tuple[str, int], list[int]] = {}
    for i, problem in enumerate(problems):
        groups.setdefault((problem["kind"], problem["n"]), []).append(i)
    print(f"{'kind':26} n  plans  refused anew  found anew   95 %    largest   shortest  over 1 %")
    refused = 0
    for (kind, n), rows in sorted(groups.items()):
        a, b = old[rows], new[rows]
        anew = int(((a >= 0.0) & (b < 0.0)).sum())
        refused += anew
        both = (a > 0.0) & (b > 0.0)
        if not both.any():
            continue
        ratio = b[both] / a[both]
        print(
            f"{kind:26} {n} {both.sum():6} {anew:13} {int(((a < 0.0) & (b >= 0.0)).sum()):11}"
            f" {np.quantile(ratio, 0.95):8.4f} {ratio.max():9.4f} {ratio.min():9.4f}"
            f" {int((ratio > 1.01).sum()):6}"
        )
        worst = np.array(rows)[both][np.argsort(-ratio)[:2]]
        for i in worst:
            if new[i] > 1.1 * old[i]:
                print(f"    {old[i]:.6g} s, now {new[i]:.6g} s: {json.dumps(problems[i])}")
    for i in np.flatnonzero((old >= 0.0) & (new < 0.0))[:10]:
        print(f"    refused anew, was {old[i]:.6g} s: {json.dumps(problems[i])}")
    return refused


def main() -> int:
    parser = argparse.ArgumentParser(description="Durations of random plans, of two versions.")
    parser.add_argument("--count", type=int, default=200, help="random problems of each kind and n")
    parser.add_argument("--against", type=Path, help="the other checkout")
    parser.add_argument("--problems", type=Path, help="plan these problems and print durations")
    given = parser.parse_args()
    if given.problems is not None:
        problems = json.loads(given.problems.read_text("utf-8"))
        print(json.dumps([duration(problem) for problem in problems]))
        return 0
    problems = shared_problems() + random_problems(given.count) + several_axes(4 * given.count)
    file = ROOT / "out" / "plan-problems.json"
    file.parent.mkdir(exist_ok=True)
    file.write_text(json.dumps(problems), "utf-8")
    old, new = (durations(root, file) for root in (given.against.resolve(), ROOT))
    return compare(problems, old, new)


if __name__ == "__main__":
    sys.exit(main() > 0)
