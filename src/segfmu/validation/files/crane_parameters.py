"""What a crane file means to planner and FMUs."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from functools import cache
from math import radians
from pathlib import Path
from typing import Any

import numpy as np

from segfmu.crane import ActuatorBounds, Crane, Friction, Rig
from segfmu.crane.bounds import DIRECTED
from segfmu.crane.kinds import AnyCrane
from segfmu.crane.linear import usual_sample_time
from segfmu.crane.rig import plant_record, require_fitting
from segfmu.crane.variables import Value
from segfmu.errors import InputError
from segfmu.fmu.pair import ModelPair
from segfmu.fmu.standard.spec import start_values
from segfmu.validation.files.crane_file import CraneFile
from segfmu.validation.files.crane_models import FURTHER, model_of, table_of
from segfmu.validation.files.equipment_tables import STOPPED
from segfmu.validation.files.keys import DRIVES, Entry, entries
from segfmu.validation.kept import Right

# parameters of the cranes that no key sets, by the beginning of their names, and why
WITHOUT_KEY = {
    **{start: why for model in FURTHER for start, why in model.without_key.items()},
    "feedback.payload_mass": "the load's mass of the crane that the mission is planned for",
    "feedback.table": "gains of the native FMU, designed from crane and weights at the build",
    "setpoint.lead": "a matter of the importer that couples the FMUs, not of the crane",
    "start.on_reference": "the crane of a mission starts at the first waypoint",
}


# cranes that were found right
_right = Right(64)
# trolley over load; a free trolley swings as the root of it faster than the load alone
LIGHTEST = 1e-3


@cache
def _entries() -> tuple[Entry, ...]:
    return tuple(entries(CraneFile))


@cache
def _feeding() -> tuple[tuple[tuple[str, ...], tuple[Entry, ...]], ...]:
    """Tables by their paths, with the keys that feed variables, but for those of rows."""
    own = [e for e in _entries() if e.feeds and "[" not in e.feeds[0]]
    return tuple(
        (path, tuple(e for e in own if e.path[:-1] == path))
        for path in dict.fromkeys(e.path[:-1] for e in own)
    )


def parameters(crane: CraneFile) -> dict[str, float | str]:
    """Parameters of the crane's FMU that a crane file sets, by name."""
    found: dict[str, float | str] = {}
    for path, own in _feeding():
        table = _at(crane, path)
        for entry in own:
            value = None if table is None else getattr(table, entry.path[-1])
            if value is not None:
                _feed(found, entry, value)
            elif entry.key.none:
                found.update(zip(entry.feeds, entry.key.none, strict=False))
    if crane.controller.sample_time is None and crane.rope_min is not None:
        found["feedback.sample_time"] = usual_sample_time(
            crane.gravity, crane.rope_min, crane.sensors.sample_time or 0.0
        )
    found["feedback.source"] = feedback_source(crane)
    for i, change in enumerate(crane.load.changes, 1):
        found[f"payload[{i}].time"] = change.time
        found[f"payload[{i}].mass"] = change.mass
    return found


def feedback_source(crane: CraneFile) -> str:
    """What the feedback knows."""
    return crane.controller.source or model_of(crane).source


def models(crane: CraneFile) -> ModelPair:
    """The models that plan for a crane and are it."""
    return model_of(crane).pair


def _at(table: Any, path: tuple[str, ...]) -> Any:
    """The value at a path; None below a table that is not there."""
    for name in path:
        table = None if table is None else getattr(table, name)
    return table


def _feed(found: dict[str, float | str], entry: Entry, value: Any) -> None:
    """Set the variables of a key that has a value."""
    if entry.listed:
        found[entry.feeds[0]] = len(value)
    elif isinstance(value, list):
        for name, one in zip(entry.feeds, value, strict=True):
            found[name] = _number(entry, one)
    else:
        found[entry.feeds[0]] = value if isinstance(value, str) else _number(entry, value)


def _number(entry: Entry, value: Any) -> float:
    return radians(value) if entry.key.unit == "deg" else float(value)


@contextmanager
def with_keys(where: str | Path | None = None) -> Iterator[None]:
    """Name keys of crane files in errors, in place of parameters of GantryCrane, behind `where`."""
    try:
        yield
    except InputError as error:
        keys = {name: ".".join(e.path) for e in _entries() for name in e.feeds}
        text = re.sub(
            r"[a-z_]+(\.[a-z_]+)+", lambda found: keys.get(found[0], found[0]), str(error)
        )
        raise InputError(text if where is None else f"{where}: {text}") from None


def nominal(crane: CraneFile) -> AnyCrane:
    """Masses, gravity, rope range, and what its model has besides.

    Raises
    ------
    InputError
        For an empty rope range.
    """
    names = ("bridge_mass", "trolley_mass", "payload_mass", "gravity", "rope_min", "rope_max")
    own = Crane(**{name: getattr(crane, name) for name in names})
    model = model_of(crane)
    return model.build(own, table_of(model, crane))


def bounds(crane: CraneFile) -> ActuatorBounds:
    """Bounds of the drives and of the sway, and end stops; infinite where there are none; lags."""
    drives = [getattr(crane, name) for name in DRIVES]
    given: dict[str, Any] = {
        name: [getattr(drive, f"{name}_max") or np.inf for drive in drives]
        for name in ("force", "velocity", "acceleration", "power")
    }
    given |= {f"{name}_min": [getattr(d, f"{name}_min") for d in drives] for name in DIRECTED}
    sway = None if crane.sway_max is None else np.deg2rad(crane.sway_max)
    lag = [drive.lag or 0.0 for drive in drives]
    stops = [getattr(crane.travel, axis) or (None, None) for axis in STOPPED]
    least, greatest = zip(*stops, strict=True)
    return ActuatorBounds(
        **given, sway_angle=sway, travel=greatest, travel_min=least, lag=lag
    )


def brakes(crane: CraneFile) -> dict[str, float]:
    """Decelerations of brakes [m/s2] by the planner's parameters; 0: as strong as the drive."""
    given = {drive: getattr(crane, drive).brake_deceleration or 0.0 for drive in DRIVES}
    return {f"drive.{drive}.brake_deceleration": value for drive, value in given.items()}


def friction(crane: CraneFile) -> Friction:
    """Friction of the axes; that of the sway is no matter of the drives."""
    table = crane.friction
    axes = [getattr(table, name) for name in DRIVES]
    given: dict[str, Any] = {
        name: tuple(getattr(axis, name) or 0.0 for axis in axes)
        for name in ("viscous", "coulomb", "static", "drag")
    }
    for name in ("width", "presliding"):
        if getattr(table, name) is not None:
            given[name] = getattr(table, name)
    return Friction(**given)


def tighter(own: ActuatorBounds, more: Mapping[str, Any]) -> ActuatorBounds | None:
    """The smaller of a crane's bounds and others, sway angles in deg; None if there are none."""
    given = dict(more)
    if given["sway_angle"] is not None:
        given["sway_angle"] = np.deg2rad(given["sway_angle"])
    found = own.tightened(ActuatorBounds(**given))
    return found if found.known else None


def _require_heavy(crane: CraneFile) -> None:
    """Refuse a trolley that the load moves as it likes; with velocity drives no mass matters."""
    least = LIGHTEST * crane.payload_mass
    if crane.drive == "force" and crane.trolley_mass < least:
        raise InputError(
            f"trolley_mass: {crane.trolley_mass:g} kg swings against a load of "
            f"{crane.payload_mass:g} kg too fast to be followed; give it {least:g} kg or more, or "
            'choose drive = "velocity"'
        )


def check(crane: CraneFile, where: str) -> None:
    """What no single key shows; `where` names the file or the table.

    Raises
    ------
    InputError
        For values that do not fit together.
    """
    text = crane.model_dump_json()
    if text in _right:
        return
    with with_keys(where):
        own = nominal(crane)
        model_of(crane).check_crane(crane)
        value: Value = start_values(models(crane).plant(), parameters(crane)).__getitem__
        Rig.of(value)
        require_fitting(plant_record(own, value), value("feedback.sample_time"))
        _require_heavy(crane)
    allowed = crane.load.mass_range
    if allowed is not None:
        if allowed[0] > allowed[1]:
            raise InputError(f"{where}: load.mass_range: {allowed} kg is empty")
        if not allowed[0] <= crane.payload_mass <= allowed[1]:
            raise InputError(
                f"{where}: payload_mass: {crane.payload_mass} kg is outside load.mass_range "
                f"{allowed[0]} to {allowed[1]} kg"
            )
    _right.add(text)
