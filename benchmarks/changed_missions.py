"""A container mission, built once and changed in the importing tool: bounds kept, or refused."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from benchmarks.drive_oracle import largest_use
from benchmarks.report import Part, Record, Section, Settings
from segfmu import Crane, InfeasibleError, Mission, build, load_mission
from segfmu.cosim.load import load
from segfmu.cosim.unit import Unit
from segfmu.errors import SimulationError

FloatArray = NDArray[np.float64]
SEED = 23
SAMPLES = 2001
TITLE = "Missions built once and changed in the importing tool"
QUANTITIES = ("position", "velocity", "acceleration", "jerk", "snap")
# what a refusal has to name
PLACE = re.compile(
    r"obstacle \d|workspace\.[xyz]|waypoints? \d|axis [xyz]|rope_(min|max)|(drive|sway|travel)\.\w+"
)

# free states within bounds of the drives and limits of the load, over a stack below a workspace
SHIP_TO_SHORE: dict[str, Any] = {
    "name": "container",
    "shape": "smoothstep",
    "crane": {
        "bridge_mass": 3e5,
        "trolley_mass": 1.5e4,
        "payload_mass": 4e4,
        "drive": "velocity",
        "rope_min": 8.0,
        "rope_max": 45.0,
        "bridge": {"velocity_max": 0.75, "acceleration_max": 0.125},
        "trolley": {"velocity_max": 4.0, "acceleration_max": 0.8},
        "travel": {"trolley": [-0.1, 70.0], "rope": [9.9, 38.1]},
        "hoist": {
            "velocity_max": 1.5,
            "acceleration_max": 0.75,
            "force_max": 7.1e5,
            "power_max": 8.9e5,
        },
    },
    "limits": {
        axis: {"velocity": 3.8, "acceleration": 0.7, "jerk": 1.0, "snap": 3.0} for axis in "xyz"
    },
    "load_size": [12.2, 2.44, 2.6],
    "load_centre": [0.0, 0.0, -1.3],
    "waypoints": [
        {"position": [0.0, 0.0, -30.0]},
        {"position": [0.0, 8.0, -18.0], "velocity": "free", "acceleration": "free"},
        {"position": [0.0, 37.0, -18.0], "velocity": "free", "acceleration": "free"},
        {"position": [0.0, 45.0, -30.0]},
    ],
    "workspace": {"y": [-10.0, 68.0], "z": [-40.0, -8.0]},
    "obstacles": [
        {
            "name": "stack",
            "minimum": [-20.0, 10.0, -40.0],
            "maximum": [20.0, 35.0, -21.6],
            "margin": 0.5,
        }
    ],
}
LAB: dict[str, Any] = {
    "name": "box",
    "shape": "smoothstep",
    "crane": {
        "bridge_mass": 2.2,
        "trolley_mass": 1.155,
        "payload_mass": 1.0,
        "drive": "velocity",
        "rope_min": 0.16,
        "rope_max": 1.5,
        "bridge": {"velocity_max": 0.7, "acceleration_max": 0.9},
        "trolley": {"velocity_max": 0.7, "acceleration_max": 0.9, "force_max": 3.0},
        "travel": {"trolley": [-0.01, 2.3], "rope": [0.3, 1.28]},
        "hoist": {
            "velocity_max": 0.3,
            "acceleration_max": 0.6,
            "force_max": 18.0,
            "power_max": 5.0,
        },
    },
    "limits": {
        axis: {"velocity": 0.65, "acceleration": 0.7, "jerk": 5.0, "snap": 60.0} for axis in "xyz"
    },
    "load_size": [0.2, 0.05, 0.06],
    "load_centre": [0.0, 0.0, -0.03],
    "waypoints": [
        {"position": [0.0, 0.0, -1.0]},
        {"position": [0.0, 0.25, -0.6], "velocity": "free", "acceleration": "free"},
        {"position": [0.0, 1.2, -0.6], "velocity": "free", "acceleration": "free"},
        {"position": [0.0, 1.5, -1.0]},
    ],
    "workspace": {"y": [-0.3, 2.2], "z": [-1.35, -0.2]},
    "obstacles": [
        {
            "name": "stack",
            "minimum": [-0.6, 0.35, -1.5],
            "maximum": [0.6, 1.1, -0.72],
            "margin": 0.01,
        }
    ],
}


@dataclass(frozen=True)
class Site:
    """A mission, and how far it is changed.

    Attributes
    ----------
    mission : dict
        As `load_mission` takes it.
    last : tuple of float
        Where the last waypoint may be along y [m].
    load : tuple of float
        Mass of the load [kg].
    rope : float
        By how much the rope at each waypoint may differ [m].
    gap : float
        What is between stack and load at most, where the load passes it lowest [m].
    """

    mission: dict[str, Any]
    last: tuple[float, float]
    load: tuple[float, float]
    rope: float
    gap: float


SITES = {
    "lab": Site(LAB, (0.17, 2.3), (0.15, 1.5), 0.27, 0.1),
    "ship to shore": Site(SHIP_TO_SHORE, (5.0, 70.0), (5e3, 6e4), 8.0, 4.0),
}


@dataclass(frozen=True)
class Flown:
    """What the FMU tells of the load's motion, at equidistant samples.

    Attributes
    ----------
    duration : float
        [s]
    values : ndarray, shape (5, samples, 3)
        Position to snap.
    """

    duration: float
    values: FloatArray

    def __call__(self, t: FloatArray, derivative: int = 0) -> FloatArray:
        """A derivative at all samples, which are those of t [s]."""
        assert t.size == self.values.shape[1]
        return np.asarray(self.values[derivative])


def changes(site: Site, count: int) -> Iterator[tuple[Mission, dict[str, float]]]:
    """Changed missions, and the parameters that say the same in the importing tool."""
    for i in range(count):
        random = np.random.default_rng((SEED, i))
        points = [dict(point) for point in site.mission["waypoints"]]
        mass, values = float(random.uniform(*site.load)), {}
        for number, point in enumerate(points, 1):
            x, y, z = point["position"]
            z += float(random.uniform(-site.rope, site.rope))
            if number == len(points):
                y = float(random.uniform(*site.last))
                values[f"waypoint[{number}].position.y"] = y
            point["position"] = [x, y, z]
            values[f"waypoint[{number}].position.z"] = z
        stack = dict(site.mission["obstacles"][0])
        lowest = min(point["position"][2] for point in points[1:-1])
        gap = stack["margin"] + float(random.uniform(0.0, site.gap))
        top = lowest - site.mission["load_size"][2] - gap
        stack["maximum"] = [*stack["maximum"][:2], top]
        values |= {"crane.payload_mass": mass, "obstacle[1].maximum.z": top}
        changed = {"waypoints": points, "crane": {"payload_mass": mass}, "obstacles": [stack]}
        yield load_mission(site.mission, changed), values


def flown(archive: Path, values: Mapping[str, float]) -> Flown | str:
    """The motion that the FMU plans, or why it is refused."""
    with load(archive) as unit:
        try:
            unit.set(values)
            unit.enter_initialization(0.0, 1e4)
            unit.exit_initialization()
        except SimulationError as error:
            return str(error)
        return _sampled(unit)


def _sampled(unit: Unit) -> Flown:
    told = unit.channel(["plan.duration"])
    told.read()
    duration = float(told.values[0])
    load_motion = unit.channel([f"reference.load.{q}.{a}" for q in QUANTITIES for a in "xyz"])
    rows, time = [], 0.0
    for end in np.linspace(0.0, duration, SAMPLES):
        if end > time:
            time = unit.step(time, float(end))
        load_motion.read()
        rows.append(load_motion.values.copy())
    return Flown(duration, np.array(rows).reshape(SAMPLES, 5, 3).transpose(1, 0, 2))


def compared(
    archive: Path, mission: Mission, values: Mapping[str, float]
) -> tuple[str, float, float]:
    """How it went, the largest use, and the relative difference of the durations."""
    found = flown(archive, values)
    try:
        own = mission.plan().duration
    except InfeasibleError:
        own = np.nan
    if isinstance(found, str):
        kind = "refused" if PLACE.search(found) else "refused without a name"
        return (kind if np.isnan(own) else "refused by the FMU alone"), np.nan, np.nan
    if np.isnan(own):
        return "refused by the package alone", np.nan, np.nan
    return "planned", _use(mission, found), abs(found.duration / own - 1.0)


def _use(mission: Mission, motion: Flown) -> float:
    """The largest use of a bound of the drives, or of a limit of the load."""
    bounds, limits = mission.build_bounds(), mission.limits
    crane = mission.build_crane()
    assert bounds is not None and limits is not None and isinstance(crane, Crane)
    used = largest_use(crane, motion, bounds, SAMPLES)
    for k, axis in enumerate("xyz"):
        for order, quantity in enumerate(QUANTITIES[1:], 1):
            limit = getattr(getattr(limits, axis), quantity)
            used = max(used, float(np.abs(motion.values[order, :, k]).max()) / limit)
    return used


def measure(settings: Settings) -> Part:
    """500 random changes at each size."""
    count = 20 if settings.samples <= 100 else 500
    records: list[Record] = []
    for name, site in SITES.items():
        archive = build(load_mission(site.mission), settings.folder / name).feedforward
        rows = [compared(archive, *change) for change in changes(site, count)]
        kinds = [kind for kind, _, _ in rows]
        used, apart = np.array([row[1:] for row in rows if row[0] == "planned"]).T
        others = len(kinds) - kinds.count("planned") - kinds.count("refused")
        records.append({
            "crane": name, "changes": count, "planned": kinds.count("planned"),
            "refused by name": kinds.count("refused"), "otherwise": others,
            "largest use": float(used.max()), "durations apart": float(apart.max()),
        })
    notes = (
        "largest use: of bounds of the drives, by Taylor series in NumPy of the motion that the "
        "FMU tells, and of limits of the load",
        "durations apart: of FMU and `segfmu plan` of the same change, relative",
        "otherwise: refused by one of both alone, or without a name",
    )
    title = "last waypoint, ropes, load and stack changed"
    return Part(TITLE, [Section(title, records)], notes)
