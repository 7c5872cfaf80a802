"""The page: a mission's crane in a browser, under a joystick."""

from __future__ import annotations

from math import ceil, pi, sqrt
from pathlib import Path
from typing import Any

import numpy as np

from segfmu.arrays import FloatArray, require_callable
from segfmu.cosim.result import replacing
from segfmu.planning import Trajectory
from segfmu.validation.files.crane_models import require_gantry
from segfmu.validation.files.crane_parameters import with_keys
from segfmu.validation.files.mission import Mission
from segfmu.validation.files.mission_file import Source, load_mission
from segfmu.validation.live.space import limits, space, speeds
from segfmu.validation.live.system import interfaces, system
from segfmu.validation.output import about, file_path, require_file
from segfmu.validation.planned import planned
from segfmu.validation.progress import Progress, quiet
from segfmu.validation.report.scene import surroundings
from segfmu.validation.report.web import as_json, filled
from segfmu.validation.scenario import limit_values
from segfmu.validation.units import scale

PARTS = ("page.css", "live.css", "view.html")
SCRIPTS = (
    "view.js", "wasi.js", "fmu.js", "system.js", "plain.js", "driver.js", "inputs.js", "traces.js",
    "live.js",
)
SAMPLES = 200
# share of the load's weight that the strongest wind pushes with, and of its mass that can be set
WIND = 0.05
LIGHTEST, HEAVIEST = 0.1, 1.2
# swings of the load that traces show
SWINGS = 6


def live(
    mission: Source, path: str | Path = "live.html", *, progress: Progress = quiet
) -> Path:
    """Write the page on which a mission's crane is driven in a browser.

    It is one file with both FMUs, which opens without a network. It appears when it is complete.

    Parameters
    ----------
    mission : path, mapping or Mission
        As of `load_mission`.
    path : path
        Of the page.
    progress : callable
        Called with what is being done and the share of it that is done.

    Returns
    -------
    Path
        Of the page.

    Raises
    ------
    InputError
        For a mission that is not possible, or for which no command can be followed, and where the
        file cannot be written.
    InfeasibleError
        If the mission cannot be planned.
    BuildError
        Where neither packaged WebAssembly nor a compiler for it is there.
    """
    require_callable("progress", progress)
    target = file_path(path)
    require_file(target)
    task = load_mission(mission)
    with about(task.file):
        require_gantry(task.build_crane(), "page")
        trajectory = planned(task, progress)
        progress("compiling", 0.0)
        with with_keys():
            content = contents(task, trajectory)
    text = filled(
        "live.html", (*PARTS, *SCRIPTS), "segfmu.validation.live", scripts=SCRIPTS,
        name=task.name, data=as_json(content),
        window=content["window"], lightest=LIGHTEST, heaviest=HEAVIEST,
    )
    with replacing(target) as temporary:
        temporary.write_text(text, encoding="utf-8")
    return target


def contents(mission: Mission, trajectory: Trajectory) -> dict[str, Any]:
    """All that the scripts know of a mission."""
    room = space(mission, trajectory)
    own = limits(mission, trajectory, room)
    velocity, acceleration = speeds(mission, trajectory, own)
    crane = mission.crane
    weight = crane.payload_mass * crane.gravity
    start = list(mission.waypoints[0].position)
    swing = 2.0 * pi * sqrt(-start[2] / crane.gravity)
    return {
        **system(*interfaces(mission, trajectory, room, own), mission.simulation.step),
        # for the mission's own motion, in place of those under a joystick
        "limits": limit_values(trajectory.limits),
        "waypoints": len(mission.waypoints),
        "start": start,
        "window": ceil(SWINGS * swing),
        "room": room.tolist(),
        "speeds": velocity.tolist(),
        "accelerations": acceleration.tolist(),
        "mass": crane.payload_mass,
        "wind": WIND * weight,
        "units": {"force": scale(WIND * weight, "N"), "mass": scale(crane.payload_mass, "kg")},
        "scene": _scene(mission, trajectory, room),
    }


def _scene(mission: Mission, trajectory: Trajectory, room: FloatArray) -> dict[str, Any]:
    times = np.union1d(np.linspace(0.0, trajectory.duration, SAMPLES), trajectory.events)
    path = trajectory(times[times <= trajectory.duration])
    found = surroundings(mission, path)
    # all that the load can reach
    found["travel"] = room[:2].tolist()
    found["room"] = room.tolist()
    return found
