"""Scenario files: a mission, what disturbs it, and the criteria it is judged by."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from segfmu.arrays import shown
from segfmu.errors import InputError
from segfmu.validation.files.crane_models import require_gantry
from segfmu.validation.files.kinds import require_kind
from segfmu.validation.files.mission import Mission
from segfmu.validation.files.mission_file import build_mission, read_mission
from segfmu.validation.files.mission_file import files_of as mission_files
from segfmu.validation.files.reading import checked, merged, of_named, read
from segfmu.validation.files.recording import Recording, load_recording
from segfmu.validation.files.scenario_tables import CRANE, ScenarioFile
from segfmu.validation.units import run_units, signal_units, unlike

# keys whose lists are merged by the names of their tables
NAMED = ("criteria", "fmus")
# lists of tables that name files, and the key of a file's name; a reference may be a signal
NAMING = (("fmus", "path"), ("criteria", "reference"), ("profiles", "file"))
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
from segfmu.validation.units import run_units, signal_units, unlike
        With what it inherits.
    mission : Mission
        With the scenario's changes.
    recordings : tuple of Recording or None
        By profile; None for one without a file.
    units : mapping
        Of the variables of its runs.
    """

    path: Path
    file: ScenarioFile
    mission: Mission
    recordings: tuple[Recording | None, ...] = ()
    units: Mapping[str, str] = field(default_factory=signal_units)


@dataclass(frozen=True, eq=False)
class Source:
    """A scenario and its missions as files have them, not yet checked.

    Attributes
    ----------
    path : Path
        Of the scenario file.
    data : mapping
        Its content with what it inherits; names of files are paths.
    missions : dict
        Content of mission files by path; those that are missing are read.
    """

    path: Path
    data: Mapping[str, Any]
    missions: dict[str, dict[str, Any]] = field(default_factory=dict)

    def mission(self, name: str) -> dict[str, Any]:
        """The content of a mission file.

        Raises
        ------
        InputError
            If it cannot be read.
        """
        if name not in self.missions:
            try:
                self.missions[name] = read_mission(Path(name))
            except InputError as error:
                raise of_named(self.path, "mission", Path(name), error) from None
        return self.missions[name]


def load_scenario(path: Path) -> Scenario:
    """Read and check a scenario file, the files it inherits from, and its mission.

    Raises
    ------
    InputError
        One line with the file, the key, the value and what is allowed.
    """
    return build_scenario(read_source(path))


def read_source(path: Path) -> Source:
    """Read a scenario file and the files it inherits from.

    Raises
    ------
    InputError
        If one cannot be read.
    """
    return Source(path, _inherited(path, ()))


def files_of(source: Source) -> list[Path]:
    """The file of a checked scenario, those that it inherits from or names, and those they name.

    Among them are names of signals, which references may be.
    """
    found = [*_bases(source.path), *mission_files(Path(source.data["mission"]))]
    for kind, key in NAMING:
        found += [Path(entry[key]) for entry in source.data.get(kind, ()) if key in entry]
    return found


def _bases(path: Path) -> list[Path]:
    """A scenario file and those that it inherits from, which can be read."""
    base = read(path).get("base")
    return [path] if base is None else [path, *_bases(path.parent / base)]


def build_scenario(source: Source, changes: Mapping[str, Any] | None = None) -> Scenario:
    """Check a scenario that was read, with changes of its content.

    Raises
    ------
    InputError
        As `load_scenario` does.
    """
    path = source.path
    file = checked(ScenarioFile, inherit(source.data, changes or {}), str(path))
    data = source.mission(file.mission)
    try:
        mission = build_mission(Path(file.mission), merged(data, _changes(file)))
    except InputError as error:
        raise InputError(f"{path}: mission: {error}") from None
    for unit in file.fmus:
        if not Path(unit.path).is_file():
            raise InputError(f"{path}: fmus: {unit.path} of {unit.name} is no file")
    units = run_units({unit.name: Path(unit.path) for unit in file.fmus})
    for i, criterion in enumerate(file.criteria, 1):
        if different := unlike(criterion.compared, units):
            raise InputError(
                f"{path}: criteria.{i}: signals of different units are not compared: {different}"
            )
    recordings = _recordings(path, file)
    if any(r is not None and r.commands for r in recordings):
        require_gantry(mission.build_crane(), "commands")
    return Scenario(path, file, mission, recordings, units)


def _recordings(path: Path, file: ScenarioFile) -> tuple[Recording | None, ...]:
    """The files of profiles; InputError where two profiles have a variable."""
    found: list[Recording | None] = []
    owners: list[tuple[str, str | None]] = []
    for profile in file.profiles:
        try:
            recording = None if profile.file is None else load_recording(Path(profile.file))
        except InputError as error:
            raise of_named(path, "profiles", Path(str(profile.file)), error) from None
        names = [str(profile.variable)] if recording is None else list(recording.columns)
        fmu = profile.fmu or (CRANE if recording is None else None)
        for name in names:
            if any(name == n and (None in (fmu, f) or fmu == f) for n, f in owners):
                raise InputError(f"{path}: profiles: two of them have {name}; join their samples")
        owners += [(name, fmu) for name in names]
        found.append(recording)
    return tuple(found)


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
        every = (p for p in path.glob("*.toml") if not p.is_dir())
        inside = sorted(p for p in every if not p.name.startswith("_"))
        if not inside:
            raise InputError(f"{path}: no scenario files (*.toml) in this folder")
        found += inside
    return list(dict.fromkeys(found))


def _inherited(path: Path, below: tuple[Path, ...]) -> dict[str, Any]:
    """The content of a file merged into that of its base."""
    data = read(path)
    place = path.resolve()
    if place in below:
        raise InputError(f"{path} inherits from itself")
    require_kind("scenario", data, path)
    data = located(path, data)
    base = data.pop("base", None)
    if base is None:
        return data
    if not isinstance(base, str):
        raise InputError(f"{path}: base: must be the name of a file, got {shown(base)}")
    try:
        old = _inherited(path.parent / base, (*below, place))
    except InputError as error:
        # the message of a base of a base names the file that asked first
        raise error if below else of_named(path, "base", path.parent / base, error) from None
    return inherit(old, data)


def inherit(old: Mapping[str, Any], new: Mapping[str, Any]) -> dict[str, Any]:
    """The content of a scenario file merged into that of its base."""
    lists = {n: _by_name(old[n], new[n]) for n in NAMED if n in old and n in new}
    return merged(old, {**new, **lists})


def _by_name(old: Any, new: Any) -> Any:
    """Tables of a list that replace those of the same names, or stand behind them.

    Names that stand twice in one list stay there, to be refused.
    """
    both = [*old, *new] if isinstance(old, list) and isinstance(new, list) else None
    if both is None or not all(isinstance(t, dict) and "name" in t for t in both):
        return new
    given = {str(t["name"]): t for t in new}
    if len(given) < len(new):
        return new
    kept = [str(t["name"]) for t in old]
    replaced = [given.get(name, t) for name, t in zip(kept, old, strict=True)]
    return replaced + [t for name, t in given.items() if name not in kept]


def located(path: Path, data: Mapping[str, Any]) -> dict[str, Any]:
    """Names of files, which are relative to the file that has them, as paths."""
    def place(table: Any, key: str, ending: str = "") -> Any:
        name = table.get(key) if isinstance(table, dict) else None
        if not (isinstance(name, str) and name.endswith(ending)):
            return table
        return {**table, key: str(path.parent / name)}

    found: dict[str, Any] = place(dict(data), "mission")
    for kind, key in NAMING:
        ending = ".csv" if key == "reference" else ""
        if isinstance(found.get(kind), list):
            found = {**found, kind: [place(entry, key, ending) for entry in found[kind]]}
    return found


def located_value(path: Path, key: str, value: Any) -> Any:
    """The value of a key that is written with dots, as `located` has it."""
    first, *rest = key.split(".")
    if not rest:
        return located(path, {first: value})[first]
    if len(rest) == 2:
        (entry,) = located(path, {first: [{rest[1]: value}]})[first]
        return entry[rest[1]]
    return value


def _changes(file: ScenarioFile) -> dict[str, Any]:
    """What a scenario changes in the mission's file."""
    found = {n: getattr(file, n) for n in CHANGES if getattr(file, n)}
    found = merged(file.plan, found)
    if file.controller:
        found["crane"] = merged(found.get("crane", {}), {"controller": file.controller})
    if file.step is not None:
        found["simulation"] = merged(found.get("simulation", {}), {"step": file.step})
    return found
