"""A mission as a co-simulation: parameters of both FMUs, and the run."""

from __future__ import annotations

from collections.abc import Callable
from math import radians
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from segfmu.cosim import simulate
from segfmu.validation.mission import AXES, Mission

QUANTITIES = ("position", "velocity", "acceleration")


def feedforward_values(mission: Mission) -> dict[str, float | str]:
    """Parameters of GantryFeedforward for a mission."""
    values = _crane_values(mission)
    for axis in AXES:
        limits = getattr(mission.limits, axis)
        for name in ("velocity", "acceleration", "jerk", "snap"):
            values[f"limits.{axis}.{name}"] = getattr(limits, name) or 0.0
    values["waypoint.count"] = len(mission.waypoints)
    for i, entry in enumerate(mission.waypoints, 1):
        for quantity in QUANTITIES:
            for axis, number in zip(AXES, getattr(entry, quantity), strict=True):
                values[f"waypoint[{i}].{quantity}.{axis}"] = number
        values[f"waypoint[{i}].dwell"] = entry.dwell
    values["planner.smoothness"] = mission.smoothness
    values["planner.shape"] = mission.shape
    values["planner.synchronization"] = mission.synchronization
    values["planner.sample_time"] = mission.sample_time or 0.0
    values["planner.duration"] = mission.duration or 0.0
    return values


def crane_values(mission: Mission) -> dict[str, float | str]:
    """Parameters and start values of GantryCrane: the load hangs at the first waypoint."""
    values = _crane_values(mission)
    x, y, z = mission.waypoints[0].position
    sway_x, sway_y = mission.simulation.initial_sway
    values.update(
        {
            "bridge.position": x,
            "trolley.position": y,
            "rope.length": -z,
            "sway.x.angle": radians(sway_x),
            "sway.y.angle": radians(sway_y),
            "drive.mode": mission.simulation.drive,
            "feedback.enabled": float(mission.simulation.feedback),
        }
    )
    return values


def _crane_values(mission: Mission) -> dict[str, float | str]:
    return {
        f"crane.{name}": 0.0 if value is None else value
        for name, value in mission.crane.model_dump().items()
    }


def run(
    mission: Mission,
    feedforward: Path,
    crane: Path,
    duration: float,
    progress: Callable[[float], None] = lambda _: None,
) -> NDArray[np.void]:
    """Co-simulate a mission; `duration` is the planned one, to which the settling time is added."""
    return simulate(
        feedforward,
        crane,
        stop_time=duration + mission.simulation.settle,
        step=mission.simulation.step,
        source_values=feedforward_values(mission),
        sink_values=crane_values(mission),
        progress=progress,
    )
