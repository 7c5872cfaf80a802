"""How long GantryFeedforward plans in its initialisation, within the bounds of the drives."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import product
from pathlib import Path
from time import process_time

import numpy as np

from benchmarks.report import Part, Record, Section, Settings
from segfmu.cosim.load import load
from segfmu.errors import BuildError, SimulationError
from segfmu.fmu.feedforward.interface import LIMIT_UNITS
from segfmu.fmu.gantry_feedforward import interface
from segfmu.fmu.native.archive import build_all
from segfmu.kernels.crane.records import DRIVES

SEED = 17
POINTS, BOXES = 4, 10
TITLE = "GantryFeedforward: initialisation with 4 waypoints, drive-limited, hoisting"
Values = Mapping[str, float | bool]


@dataclass(frozen=True)
class Size:
    """A crane: masses [kg], bounds of each drive, of the sway [rad], largest way and rope [m]."""

    masses: tuple[float, float, float]
    bounds: Mapping[str, tuple[float, float, float]]
    sway: float
    way: float
    rope: float


SIZES = {
    "lab": Size(
        (2.2, 1.155, 1.0),
        {"force": (6.0, 3.0, 11.0), "velocity": (0.7, 0.7, 0.7), "acceleration": (0.9, 0.9, 0.9),
         "power": (4.0, 2.0, 4.0)}, 0.09, 1.0, 0.8,
    ),
    "ship to shore": Size(
        (7.5e5, 2.5e4, 4e4),
        {"force": (6e5, 8e4, 4.71e5), "velocity": (0.75, 4.0, 1.5),
         "acceleration": (0.3, 0.8, 0.75), "power": (4e5, 3e5, 5.89e5)}, 0.12, 70.0, 30.0,
    ),
}


def changes(count: int, name: str, *, free: bool, boxed: bool) -> Iterator[dict[str, float | bool]]:
    """Random loads, ways and ropes of a crane, as parameters of the FMU.

    free: states of the inner waypoints; boxed: boxes are below the straight way and beside it, as
    stacks of containers are.
    """
    size = SIZES[name]
    for i in range(count):
        random = np.random.default_rng((SEED, i))
        places = size.way * np.cumsum([0.0, *random.uniform(0.05, 0.5, POINTS - 1)])[:, None]
        places = places * [0.3, 1.0, 0.0]
        places[:, 2] = -size.rope * random.uniform(0.6, 1.2, POINTS)
        mass = size.masses[2] * float(random.uniform(0.15, 1.1))
        values: dict[str, float | bool] = {
            "planner.finds_limits": True, "waypoint.count": POINTS, "crane.rope_max": 0.0,
            "crane.rope_min": 0.0, "crane.bridge_mass": size.masses[0],
            "crane.trolley_mass": size.masses[1], "crane.payload_mass": mass,
        }
        values |= {f"sway.{axis}.angle_max": size.sway for axis in "xy"}
        for quantity, row in size.bounds.items():
            values |= {f"drive.{d}.{quantity}_max": v for d, v in zip(DRIVES, row, strict=True)}
        for axis, k in zip("xyz", range(3), strict=True):
            values |= {f"limits.{axis}.{n}": 0.0 for n in LIMIT_UNITS}
            for j, place in enumerate(places, 1):
                inner = free and 1 < j < POINTS
                values[f"waypoint[{j}].position.{axis}"] = float(place[k])
                for state in ("velocity", "acceleration"):
                    values[f"waypoint[{j}].{state}.{axis}"] = 0.0
                    values[f"waypoint[{j}].{state}_free.{axis}"] = inner
        yield values | (_stacks(random, places, size) if boxed else {})


def _stacks(random: np.random.Generator, places: np.ndarray, size: Size) -> dict[str, float | bool]:
    """Boxes below the straight lines between waypoints, a few beside them."""
    edge = 0.02 * size.rope
    values: dict[str, float | bool] = {f"load.size.{axis}": edge for axis in "xyz"}
    values["obstacle.count"] = BOXES
    for i in range(1, BOXES + 1):
        here, there = places[i % (POINTS - 1) :][:2]
        ends = np.sort(random.uniform(0.0, 1.0, 2))[:, None]
        low, high = here + ends * (there - here)
        floor = -2.0 * size.rope
        corners = np.array([np.minimum(low, high), np.maximum(low, high)])
        top = corners[0, 2] - edge - size.rope * random.uniform(0.02, 0.2)
        corners += [[-0.1 * size.way, 0.0, 0.0], [0.1 * size.way, 0.0, 0.0]]
        corners[:, 2] = floor, top
        if i > 7:
            corners[:, 0] += 0.6 * size.way
            corners[1, 2] = 0.0
        for end, corner in zip(("minimum", "maximum"), corners, strict=True):
            name = f"obstacle[{i}].{end}"
            values |= {f"{name}.{a}": float(v) for a, v in zip("xyz", corner, strict=True)}
    return values


def initialised(archive: Path, values: Values) -> tuple[float, float]:
    """Processor time of the initialisation, and duration of the plan [s]; NaN: refused."""
    with load(archive) as unit:
        unit.set(values)
        unit.enter_initialization(0.0, 1.0)
        begun = process_time()
        try:
            unit.exit_initialization()
        except SimulationError:
            return process_time() - begun, np.nan
        taken = process_time() - begun
        channel = unit.channel(["plan.duration"])
        channel.read()
        return taken, float(channel.values[0])


def measure(settings: Settings) -> Part:
    """Milliseconds, with and without free states and boxes."""
    try:
        (archive,) = build_all((interface.native_spec(),), settings.folder)
    except BuildError as problem:
        return Part(TITLE, (), (f"not measured: {problem}",))
    count = 20 if settings.samples <= 100 else 200
    sections = []
    for name in SIZES:
        records: list[Record] = []
        for free, boxed in product((False, True), repeat=2):
            given = changes(count, name, free=free, boxed=boxed)
            times, durations = np.array([initialised(archive, values) for values in given]).T
            records.append({
                "states": "free" if free else "rest", "boxes": BOXES if boxed else 0,
                "missions": count, "refused": int(np.isnan(durations).sum()),
                "median ms": 1e3 * float(np.median(times)),
                "90 %": 1e3 * float(np.quantile(times, 0.9)), "largest": 1e3 * float(times.max()),
            })
        sections.append(Section(name, records))
    return Part(TITLE, sections)
