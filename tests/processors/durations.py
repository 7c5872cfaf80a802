"""Durations of problems, in a process of its own: `python durations.py PROBLEMS [KERNELS]`.

KERNELS is a compiled module of the kernels in place of the installed one.
"""

from __future__ import annotations

import json
import sys
from importlib.machinery import ExtensionFileLoader
from importlib.util import module_from_spec, spec_from_loader
from pathlib import Path
from typing import Any

NAME = "segfmu.kernels._compiled"


def use(kernels: str) -> None:
    """Take a compiled module for the kernels."""
    loader = ExtensionFileLoader(NAME, kernels)
    spec = spec_from_loader(NAME, loader)
    assert spec is not None
    module = module_from_spec(spec)
    loader.exec_module(module)
    sys.modules[NAME] = module


def duration(problem: dict[str, Any]) -> float:
    """Duration of the plan [s]; -1 where it is refused, -2 as wrong input."""
    import segfmu

    points = [segfmu.Waypoint(*state) for state in problem["points"]]
    rows = problem["limits"]
    limits = None
    if rows is not None:
        # an order without a limit has a row of zeros
        limits = segfmu.Limits(*(row if any(_flat(row)) else None for row in rows))
    options = {"smoothness": problem["n"], "shape": problem["shape"]}
    try:
        if "drives" not in problem:
            return float(segfmu.plan(points, limits, **options).duration)
        drives = dict(problem["drives"])
        crane = segfmu.Crane(*drives.pop("masses"))
        bounds = segfmu.ActuatorBounds(**drives)
        found = segfmu.plan_actuated(crane, points, limits, bounds, **options)
        return float(found.trajectory.duration)
    except segfmu.InfeasibleError:
        return -1.0
    except segfmu.InputError:
        return -2.0


def _flat(row: Any) -> list[float]:
    return row if isinstance(row, list) else [row]


if __name__ == "__main__":
    if len(sys.argv) > 2:
        use(sys.argv[2])
    given = json.loads(Path(sys.argv[1]).read_text("utf-8"))
    print(json.dumps([duration(problem) for problem in given]))
