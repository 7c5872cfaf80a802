"""What the view in three dimensions moves: crane, load, path, waypoints, obstacles."""

from __future__ import annotations

from math import ceil, log10
from typing import Any

import numpy as np
from numpy.typing import NDArray

from segfmu.arrays import FloatArray
from segfmu.validation.files.crane_models import model_of
from segfmu.validation.files.keys import AXES
from segfmu.validation.files.mission import Mission
from segfmu.validation.report.curves import thinned

FRAMES = 300
SIGNALS = (
    "bridge.position", "trolley.position", "load.position.x", "load.position.y",
    "load.position.z", "sway.x.angle", "sway.y.angle",
)


def scene(
    mission: Mission, rows: NDArray[np.void], name: str, frames: int = FRAMES
) -> dict[str, Any]:
    """Positions [m] and angles [deg] over time and what stands around, for scene.js."""
    times = np.linspace(0.0, float(rows["time"][-1]), frames)
    model = model_of(mission.simulated)
    signals = (*SIGNALS, *model.shown)
    columns = [np.interp(times, rows["time"], rows[name].astype(float)) for name in signals]
    path = np.column_stack([rows[f"reference.load.position.{axis}"] for axis in AXES])
    places = decimals(path)
    return {
        "name": name, "bodies": model.bodies, "links": model.links,
        **surroundings(mission, path),
        "times": _rounded(times, 3 + max(0, ceil(-log10(times[-1])))),
        "frames": [
            _rounded(np.degrees(column), 3) if signal.endswith(".angle")
            else _rounded(column, places)
            for signal, column in zip(signals, columns, strict=True)
        ],
    }


def decimals(path: FloatArray) -> int:
    """Decimals [m] that a drawing of a path (n, 3) shows."""
    extent = max(float(np.ptp(path, axis=0).max()), float(-path[:, 2].min()))
    return max(0, ceil(-log10(2e-4 * extent)))


def surroundings(mission: Mission, path: FloatArray) -> dict[str, Any]:
    """Path (n, 3) of the load, waypoints, obstacles and rails [m], for view.js."""
    places = decimals(path)
    return {
        "path": [_rounded(point, places) for point in _bends(path)],
        "waypoints": [_rounded(np.array(p.position), places) for p in mission.waypoints],
        "load": {"size": list(mission.load_size), "centre": list(mission.load_centre)},
        "obstacles": [
            {"name": box.name, "minimum": list(box.minimum), "maximum": list(box.maximum)}
            for box in mission.obstacles
        ],
        "travel": [_travel(mission, path, axis) for axis in range(2)],
    }


def _travel(mission: Mission, path: FloatArray, axis: int) -> list[float]:
    """From where to where the rails of the bridge, or the girder of the trolley, are drawn."""
    low, high = float(path[:, axis].min()), float(path[:, axis].max())
    stops = getattr(mission.crane.travel, ("bridge", "trolley")[axis])
    # short moves on a long rope are not drawn as a point
    beyond = max(0.12 * float(np.ptp(path, axis=0).max()), 0.1 * float(-path[:, 2].min()))
    if stops is None:
        return [low - beyond, high + beyond]
    # far end stops would make the motion small
    return [max(float(stops[0]), low - 3.0 * beyond), min(float(stops[1]), high + 3.0 * beyond)]


def _bends(path: FloatArray) -> FloatArray:
    """The points of a path (n, 3) that are needed to show it."""
    share = np.linspace(0.0, 1.0, len(path))
    height = max(float(np.ptp(path, axis=0).max()), 1e-9)
    shares = [thinned(share, column, height)[0] for column in path.T]
    kept = np.searchsorted(share, np.unique(np.concatenate(shares)))
    return path[kept]


def _rounded(values: FloatArray, places: int) -> list[float]:
    return [round(float(value), places) for value in values]
