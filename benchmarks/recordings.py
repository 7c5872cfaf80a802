"""Recorded commands: replayed by the operator, and by both FMUs with wind and a load that changes.

models/commands has the recordings: a row is held until the next one; columns are variables of
GantryFeedforward, and wind.* of GantryCrane.
"""

from __future__ import annotations

import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from benchmarks.operated import SITES, Site, parameters
from benchmarks.report import Part, Record, Section, Settings
from segfmu.cosim import Change, System
from segfmu.fmu.build import build_all
from segfmu.fmu.choice import Choice
from segfmu.fmu.gantry_crane import interface as gantry_crane
from segfmu.fmu.gantry_feedforward import interface as gantry_feedforward
from segfmu.fmu.standard.spec import started
from segfmu.kernels.crane.records import DRIVES
from segfmu.validation.files.recording import load_recording

FloatArray = NDArray[np.float64]
FOLDER = Path(__file__).parents[1] / "models" / "commands"
# what is replayed: the file, and the share of its load that the crane has after a while
RECORDINGS = {
    "inching": ("inching", 1.0), "microspeed": ("microspeed", 1.0), "released": ("released", 1.0),
    "retargeted": ("retarget", 1.0), "wind": ("wind", 1.0), "wind, half the load": ("wind", 0.5),
    "emergency stop": ("emergency", 1.0),
}
# what the load does behind the last row, in its swings
LEFT = 6.0
# way of a push, in steps at the greatest velocity
PUSH = 2.0
# communication steps in a step of the site
FINE = 10
LOAD = [f"reference.load.position.{a}" for a in "xyz"]
FEEDFORWARD, CRANE = "GantryFeedforward", "GantryCrane"


@dataclass(frozen=True)
class Row:
    """What holds from a time on [s], by variable."""

    time: float
    values: dict[str, float | str]

    def of(self, name: str) -> list[float]:
        """A triple of numbers."""
        return [float(self.values[f"{name}.{a}"]) for a in "xyz"]

    def command(self) -> dict[str, Any]:
        """For `Operator.command`."""
        return {
            "mode": self.values["command.mode"], "velocity": self.of("command.velocity"),
            "target": self.of("command.target"), "scale": self.values["limits.scale"],
        }


def read(path: Path) -> list[Row]:
    """The rows of a recording."""
    found = load_recording(path)
    return [
        Row(time, {name: column[i] for name, column in found.columns.items()})
        for i, time in enumerate(found.times)
    ]


def swing_of(site: Site) -> float:
    """Time of a swing where the load starts [s]."""
    return float(2.0 * np.pi * np.sqrt(-site.start[2] / site.crane.gravity))


def push_of(site: Site) -> float:
    """Way of a push [m]."""
    return PUSH * site.step * float(site.limits.velocity[1])


def step_of(site: Site) -> float:
    """Communication step [s]."""
    return site.step / FINE


def steps_of(site: Site, rows: list[Row]) -> int:
    """Steps of a run."""
    return round((rows[-1].time + LEFT * swing_of(site)) / step_of(site))


def replayed(site: Site, rows: list[Row], **options: Any) -> tuple[FloatArray, list[str]]:
    """Positions of the load (steps + 1, 3) of an operator, and what became of each row."""
    operator = site.operator(**options)
    places, statuses = [operator.load[0]], []
    starts = {round(row.time / step_of(site)): row for row in rows}
    for i in range(steps_of(site, rows)):
        row = starts.get(i)
        if row is not None:
            operator.command(**row.command(), distance=push_of(site))
        places.append(operator.step(step_of(site))[0])
        if row is not None:
            statuses.append(operator.status)
    return np.array(places), statuses


def archives(site: Site, folder: Path) -> list[Path]:
    """Both FMUs of a site; commands are inputs."""
    plant = dict(site.crane.values()) | {"drive.mode": "velocity"}
    # a drive does not jump to another velocity
    plant |= {
        f"drive.{d}.acceleration_max": a
        for d, a in zip(DRIVES, np.asarray(site.bounds.acceleration).tolist(), strict=True)
    }
    planner = {f"command.distance.{a}": push_of(site) for a in "xyz"}
    specs = [
        started(gantry_feedforward.spec(2), parameters(site) | planner),
        started(gantry_crane.spec(), plant),
    ]
    return build_all(folder, Choice(True, 2, connected=True), specs)


def simulated(
    site: Site, fmus: list[Path], rows: list[Row], payload: float = 1.0
) -> NDArray[np.void]:
    """Both FMUs under a recording; after a third of it the load has a share of its mass."""
    end = steps_of(site, rows) * step_of(site)
    changes = [
        Change(row.time, fmu, {n: v for n, v in row.values.items() if n.startswith("wind") is wind})
        for row in rows for fmu, wind in ((FEEDFORWARD, False), (CRANE, True))
    ]
    values = {CRANE: {
        "payload.count": 1, "payload[1].time": rows[-1].time / 3.0,
        "payload[1].mass": payload * site.crane.payload_mass,
    }} if payload < 1.0 else {}
    with System(dict(zip((FEEDFORWARD, CRANE), fmus, strict=True)), step=step_of(site)) as system:
        return system.run(values, stop_time=end, changes=changes)


def measure(settings: Settings) -> Part:
    """A table a crane."""
    return Part("Recorded commands", tuple(
        Section(f"{name}: recordings of models/commands/{name}", rows_of(name, site))
        for name, site in SITES.items()
    ), (
        "FMUs: GantryFeedforward, built with --commands inputs, and GantryCrane with velocities of "
        "the drives and the feedback of its default design",
        "wind: 2 % of the load's weight; half of it is lost after a third of the recording; rest: "
        f"the last of {LEFT:g} swings behind the last row",
    ))


def rows_of(name: str, site: Site) -> list[Record]:
    """A record for each recording."""
    found = []
    with tempfile.TemporaryDirectory() as folder:
        fmus = archives(site, Path(folder))
        for title, (file, payload) in RECORDINGS.items():
            rows = read(FOLDER / name / f"{file}.csv")
            places, statuses = replayed(site, rows)
            found.append({
                "recording": title, "rows": len(rows),
                "taken": sum(s in ("taken", "reduced", "pending") for s in statuses),
                **judged(site, simulated(site, fmus, rows, payload), places),
            })
    return found


def judged(site: Site, run: NDArray[np.void], places: FloatArray) -> Record:
    """What the crane does, and how far the FMU's reference is from the operator's."""
    planned = np.column_stack([run[n] for n in LOAD])
    sway = np.degrees(np.hypot(run["sway.x.angle"], run["sway.y.angle"]))
    last = run["time"] > run["time"][-1] - swing_of(site)
    return {
        "largest sway [deg]": float(sway.max()), "sway at rest [deg]": float(sway[last].max()),
        "largest error [m]": float(run["error.load.norm"].max()),
        "error at rest [m]": float(run["error.load.norm"][last].max()),
        "FMU from operator [m]": float(np.abs(planned - places).max()),
    }
