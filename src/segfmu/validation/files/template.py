"""The files that `segfmu init` writes: every key with its meaning, those of an example in use."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import ExitStack
from pathlib import Path
from typing import Any, Literal, get_args, get_origin

from segfmu.cosim.result import replacing
from segfmu.errors import InputError
from segfmu.validation.files.crane_file import CraneFile
from segfmu.validation.files.keys import Entry, Table, entries
from segfmu.validation.files.mission import Mission
from segfmu.validation.files.reference import default

HEAD = """# {title}
# Every key that there is; those behind # have the default that is named. A line is: key = value,
# then the unit, the meaning and where the value is from. Check it with: segfmu plan mission.toml
"""
# column of the comments
PLACE = 32
ASSUMED = "assumed; see the data sheet"

# by key: the value, and where it is from
CRANE: dict[str, tuple[Any, str]] = {
    "name": ("5 t workshop crane", ""),
    "bridge_mass": (6000.0, ASSUMED),
    "trolley_mass": (1500.0, ASSUMED),
    "payload_mass": (5000.0, "rated load"),
    "rope_min": (2.0, ASSUMED),
    "rope_max": (9.0, "height of the hall"),
    "drive": ("velocity", "frequency converters"),
    "sway_max": ([8.0, 8.0], "clearance beside the load"),
    "bridge.velocity_max": (0.67, "40 m/min"),
    "bridge.acceleration_max": (0.3, ASSUMED),
    "trolley.velocity_max": (0.33, "20 m/min"),
    "trolley.acceleration_max": (0.3, ASSUMED),
    "hoist.velocity_max": (0.13, "8 m/min"),
    "hoist.acceleration_max": (0.2, ASSUMED),
    "load.mass_range": ([100.0, 5000.0], "empty hook to rated load"),
    "controller.sample_time": (0.01, "cycle of the controller"),
}
MISSION: dict[str, tuple[Any, str]] = {
    "name": ("across the hall", ""),
    "crane": ("crane.toml", ""),
    "simulation.settle": (5.0, ""),
}
for axis, (speed, rate, jerk, snap) in {
    "x": (0.6, 0.25, 0.5, 2.0), "y": (0.3, 0.25, 0.5, 2.0), "z": (0.12, 0.15, 0.5, 2.0),
}.items():
    for quantity, limit in (
        ("velocity", speed), ("acceleration", rate), ("jerk", jerk), ("snap", snap),
    ):
        MISSION[f"limits.{axis}.{quantity}"] = (limit, "")
WAYPOINTS = """
# Waypoints in their order, at least two; the first and the last one at rest. Of each: position [m]
# of the load, z is negative and 0 at the trolley; velocity [m/s] and acceleration [m/s2], at rest
# by default, three numbers or "free"; dwell [s], a rest there.
[[waypoints]]
position = [0.0, 0.0, -7.0]

[[waypoints]]
position = [4.0, 1.0, -5.0]
velocity = "free"
acceleration = "free"

[[waypoints]]
position = [10.0, 3.0, -7.0]

# What differs in the crane that is simulated, with the keys of the crane file:
# [true_crane]
# payload_mass = 4500.0
"""


def crane_text() -> str:
    """The crane file."""
    return HEAD.format(title="A crane") + "\n".join(_lines(CraneFile, CRANE)) + "\n"


def mission_text() -> str:
    """The mission file."""
    skip = ("waypoints", "true_crane")
    lines = "\n".join(_lines(Mission, MISSION, skip))
    return f"{HEAD.format(title='A mission')}{lines}\n{WAYPOINTS}"


def write(folder: Path) -> tuple[Path, Path]:
    """Write crane.toml and mission.toml.

    Raises
    ------
    InputError
        If one of them is there already, or cannot be written; then none is written.
    """
    paths = folder / "crane.toml", folder / "mission.toml"
    for path in paths:
        if path.exists():
            raise InputError(f"{path}: is there already; remove it, or name another folder")
    with ExitStack() as stack:
        for path, text in zip(paths, (crane_text(), mission_text()), strict=True):
            stack.enter_context(replacing(path)).write_text(text, encoding="utf-8")
    return paths


def _lines(
    kind: type[Table], used: Mapping[str, tuple[Any, str]], skip: tuple[str, ...] = ()
) -> Iterator[str]:
    every = [
        e for e in entries(kind)
        if e.path[0] not in skip and (len(e.path) == 1 or e.path[0] != "crane")
    ]
    yield from (_line(e, used) for e in every if len(e.path) == 1 and _is_value(e))
    for table in every:
        if _is_value(table):
            continue
        name = ".".join(table.path)
        inside = [e for e in every if e.path[:-1] == table.path and _is_value(e)]
        if not inside:
            continue
        mark = "" if any(".".join(e.path) in used for e in inside) else "# "
        title = f"[[{name}]]" if table.listed else f"[{name}]"
        yield ""
        yield f"{mark}{title}".ljust(PLACE) + f"# {table.key.meaning}"
        yield from (_line(e, used) for e in inside)


def _is_value(entry: Entry) -> bool:
    return entry.kind is None or entry.path == ("crane",)


def _line(entry: Entry, used: Mapping[str, tuple[Any, str]]) -> str:
    value, source = used.get(".".join(entry.path), (None, ""))
    key = entry.path[-1]
    unit = f"{entry.key.unit}, " if entry.key.unit else ""
    parts = f" ({', '.join(entry.key.parts)})" if entry.key.parts else ""
    choices = " or ".join(map(_toml, _choices(entry.field.annotation)))
    meaning = f"{unit}{entry.key.meaning}{parts}{f'; {choices}' if choices else ''}"
    if value is None:
        without = default(entry).replace("`", "")
        return f"# {key} =".ljust(PLACE) + f"# {meaning}; default: {without}"
    shown = f"{key} = {_toml(value)}".ljust(PLACE)
    return f"{shown}# {meaning}{f'; {source}' if source else ''}"


def _choices(annotation: Any) -> list[str]:
    """Texts that a key may have, if it has one of some."""
    if get_origin(annotation) is Literal:
        return [value for value in get_args(annotation) if isinstance(value, str)]
    return [value for part in get_args(annotation) for value in _choices(part)]


def _toml(value: Any) -> str:
    return f'"{value}"' if isinstance(value, str) else str(value)
