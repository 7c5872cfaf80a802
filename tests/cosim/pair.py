"""What the tests of foreign importers share: the pair of FMUs, missions, comparison."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from segfmu.cosim import simulate
from segfmu.fmu.pair import ModelPair
from segfmu.fmu.pairs import GANTRY, HOOK, native
from segfmu.fmu.standard.spec import Spec

STEP, STOP = 0.005, 4.5


def natives(models: ModelPair) -> dict[str, Spec]:
    """Native interfaces of a planner and of its crane by their names."""
    return dict(zip(models.names, native((models.planner(16), models.plant())), strict=True))


def signals(specs: dict[str, Spec]) -> list[str]:
    """What the second one takes of the first one."""
    source, sink = specs.values()
    given = {v.name for v in source.where("output")}
    return [v.name for v in sink.where("input") if v.name in given]


SPECS, HOOKS = natives(GANTRY), natives(HOOK)
SIGNALS = signals(SPECS)
# importers give outputs as they were before the inputs at the end of the step were handed on
FEEDTHROUGH = ("error.load.",)


def place(number: int, position: list[float]) -> dict[str, float]:
    """Parameters of a waypoint at rest."""
    states = {"position": position, "velocity": [0.0] * 3, "acceleration": [0.0] * 3}
    return {
        f"waypoint[{number}].{name}.{axis}": value
        for name, values in states.items() for axis, value in zip("xyz", values, strict=True)
    }


def box(number: int, minimum: list[float], maximum: list[float]) -> dict[str, float]:
    """Parameters of an obstacle."""
    return {
        f"obstacle[{number}].{corner}.{axis}": value
        for corner, values in (("minimum", minimum), ("maximum", maximum))
        for axis, value in zip("xyz", values, strict=True)
    }


# limits of the load are found from the bounds of the drives, and what the load does at the inner
# waypoints, so that it comes up steeply behind the first box
FREE: dict[str, Any] = {
    "planner.finds_limits": True, "waypoint.count": 4, **place(1, [0.0, 0.0, -0.6]),
    **place(2, [0.2, 0.15, -0.45]), **place(3, [0.5, 0.4, -0.45]), **place(4, [0.7, 0.6, -0.6]),
    **{f"limits.{a}.{n}": 0.0 for a in "xyz" for n in ("velocity", "acceleration", "jerk", "snap")},
    **{f"drive.{d}.velocity_max": v
       for d, v in (("bridge", 0.6), ("trolley", 0.5), ("hoist", 0.3))},
    **{f"drive.{d}.acceleration_max": v
       for d, v in (("bridge", 0.7), ("trolley", 0.6), ("hoist", 0.5))},
    **{f"waypoint[{i}].{n}_free.{a}": True
       for i in (2, 3) for n in ("velocity", "acceleration") for a in "xyz"},
    "obstacle.count": 2, **box(1, [0.12, 0.09, -1.0], [0.45, 0.4, -0.49]),
    **box(2, [0.8, -1.0, -1.0], [0.9, 2.0, 0.0]), "obstacle[2].rope": False,
    **{f"load.size.{a}": 0.04 for a in "xyz"},
}
# of the pair with a hook: its feedback of measured signals brings a deviation to rest in the wind
HOOKED: tuple[dict[str, Any], dict[str, Any]] = (
    {"limits.x.velocity": 0.4, "hook.sling": 0.28},
    {"hook.sling": 0.28, "sling.x.angle": 0.03, "feedback.enabled": True,
     "wind.gust.start": 1.0, "wind.gust.duration": 0.5, "wind.gust.force.x": 0.4},
)
MISSIONS: dict[str, tuple[dict[str, Any], dict[str, Any]]] = {
    "paper": ({}, {}),
    "short move in the wind": (
        {"waypoint.count": 2, "waypoint[2].position.x": 0.4, "waypoint[2].position.y": 0.3,
         **{f"waypoint[2].{q}.{a}": 0.0 for q in ("velocity", "acceleration") for a in "xyz"},
         "planner.smoothness": 5, "limits.x.velocity": 0.3},
        {"sway.x.angle": 0.03, "feedback.enabled": False, "wind.gust.start": 1.0,
         "wind.gust.duration": 0.5, "wind.gust.force.x": 0.4},
    ),
    "equal waypoints": (
        {"waypoint.count": 4, **place(1, [0.0, 0.0, -0.5]), **place(2, [0.0, 0.0, -0.5]),
         **place(3, [0.2, 0.1, -0.5]), **place(4, [0.2, 0.1, -0.5]), "waypoint[3].dwell": 0.5,
         "waypoint[4].dwell": 0.3},
        {},
    ),
    "free states and boxes": (FREE, {}),
    "where it is": (
        {"waypoint.count": 2, **place(1, [0.1, 0.0, -0.5]), **place(2, [0.1, 0.0, -0.5])}, {},
    ),
}


def compare(
    found: dict[str, np.ndarray], paths: tuple[Path, Path], values: tuple[dict[str, Any], ...],
    most: float = 1e-9,
) -> None:
    """An importer's outputs at every communication point after the first, and our master's."""
    expected = simulate(
        *paths, stop_time=STOP, step=STEP, source_values=values[0], sink_values=values[1],
        coupling="parallel", events=False,
    )[1:]
    compared = [n for n in found if not n.startswith(FEEDTHROUGH)]
    assert len(compared) > 60 and len(SIGNALS) > 15
    for name in compared:
        scale = max(1.0, np.abs(expected[name]).max())
        assert np.abs(found[name] - expected[name]).max() <= most * scale, name
