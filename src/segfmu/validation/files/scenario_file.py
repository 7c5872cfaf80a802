"""Scenario files: a mission, what disturbs it, and the criteria it is judged by."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from segfmu.errors import InputError
from segfmu.validation.files.mission import Mission, load_mission
from segfmu.validation.files.reading import checked, merged, read
from segfmu.validation.files.scenario_tables import ScenarioFile

# keys whose lists are merged by the names of their tables
NAMED = ("criteria", "fmus")
# keys of a scenario that change the mission
CHANGES = ("crane", "true_crane", "limits", "simulation")


@dataclass(frozen=True)
class Scenario:
    """A scenario, read and checked.

    Attributes
    ----------
    path : Path
        Its file.
    file : ScenarioFile
        With what it inherits.
    mission : Mission
        With the scenario's changes.
    """

    path: Path
    file: ScenarioFile
    mission: Mission


def load_scenario(path: Path) -> Scenario:
    """Read and check a scenario file, the files it inherits from, and its mission.

    Raises
    ------
    InputError
        One line with the file, the key, the value and what is allowed.
    """
    file = checked(ScenarioFile, _inherited(path, ()), str(path))
    try:
        mission = load_mission(Path(file.mission), _changes(file))
    except InputError as error:
        raise InputError(f"{path}: mission: {error}") from None
    for unit in file.fmus:
        if not Path(unit.path).is_file():
            raise InputError(f"{path}: fmus: {unit.path} of {unit.name} is no file")
    return Scenario(path, file, mission)


def find(paths: Iterable[Path]) -> list[Path]:
    """Scenario files, and those of folders in the order of their names.

    Files of folders whose names begin with an underscore are only inherited from.

    Raises
    ------
    InputError
        For a folder without scenarios.
    """
    found: list[Path] = []
    for path in paths:
        if not path.is_dir():
            found.append(path)
            continue
        inside = sorted(p for p in path.glob("*.toml") if not p.name.startswith("_"))
        if not inside:
            raise InputError(f"{path}: no scenario files (*.toml) in this folder")
        found += inside
    return list(dict.fromkeys(found))


def _inherited(path: Path, below: tuple[Path, ...]) -> dict[str, Any]:
    """The content of a file merged into that of its base."""
    place = path.resolve()
    if place in below:
        raise InputError(f"{path} inherits from itself")
    data = _located(path, read(path))
    base = data.pop("base", None)
    if base is None:
        return data
    if not isinstance(base, str):
        raise InputError(f"{path}: base: must be the name of a file, got {base!r}")
    try:
        old = _inherited(path.parent / base, (*below, place))
    except InputError as error:
        # the message of a base of a base names the file that asked first
        raise error if below else InputError(f"{path}: base: {error}") from None
    lists = {n: _by_name(old.get(n), data.get(n)) for n in NAMED if n in old and n in data}
    return merged(old, data | lists)


def _by_name(old: Any, new: Any) -> Any:
    """Tables of a list that replace those of the same names, or stand behind them."""
    both = [*old, *new] if isinstance(old, list) and isinstance(new, list) else None
    if both is None or not all(isinstance(t, dict) and "name" in t for t in both):
        return new
    return list({str(t["name"]): t for t in both}.values())


def _located(path: Path, data: dict[str, Any]) -> dict[str, Any]:
    """Names of files, which are relative to the file that has them, as paths."""
    def place(table: Any, key: str, ending: str = "") -> Any:
        name = table.get(key) if isinstance(table, dict) else None
        if not (isinstance(name, str) and name.endswith(ending)):
            return table
        return {**table, key: str(path.parent / name)}

    found = place(data, "mission")
    for kind, key, ending in (("fmus", "path", ""), ("criteria", "reference", ".csv")):
        if isinstance(found.get(kind), list):
            found = {**found, kind: [place(entry, key, ending) for entry in found[kind]]}
    return dict(found)


def _changes(file: ScenarioFile) -> dict[str, Any]:
    """What a scenario changes in the mission's file."""
    found: dict[str, Any] = {n: getattr(file, n) for n in CHANGES if getattr(file, n)}
    if file.controller:
        found["crane"] = merged(found.get("crane", {}), {"controller": file.controller})
    if file.step is not None:
        found["simulation"] = merged(found.get("simulation", {}), {"step": file.step})
    return found


