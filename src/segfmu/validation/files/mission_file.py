"""Mission files are read, checked, and become missions."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from segfmu.arrays import shown
from segfmu.errors import InputError
from segfmu.planning.table import waypoints_of
from segfmu.validation.files import crane_parameters
from segfmu.validation.files.crane_file import CraneFile
from segfmu.validation.files.crane_models import check_models
from segfmu.validation.files.keys import AXES
from segfmu.validation.files.kinds import require_kind
from segfmu.validation.files.mission import DISTURBED, MOST_WAYPOINTS, Mission
from segfmu.validation.files.mission_checks import check_waypoints
from segfmu.validation.files.objects import plain
from segfmu.validation.files.reading import checked, merged, of_named, read
from segfmu.validation.kept import Right

# missions that were found right, but for the keys of DISTURBED
_right = Right(64)
# in messages, a mission that is no file
UNNAMED = Path("mission")
# keys whose value may be the name of a file
NAMED = (
    ("crane", dict, "the name of a crane file, or a table"),
    ("waypoints", list, "the name of a CSV file, or tables [[waypoints]]"),
)
Source = str | Path | Mapping[str, Any] | Mission


def load_mission(source: Source, changes: Mapping[str, Any] | None = None) -> Mission:
    """Read a mission file and the files that it names, or make a mission of Python objects.

    Parameters
    ----------
    source : path, mapping or Mission
        A mission file (TOML); or what it would say, as a dict. In a dict the crane may be a
        `Crane`, the limits `Limits`, waypoints `Waypoint` and obstacles `Obstacle`. A crane or
        waypoints that are a string name a file, which is relative to the mission file or to the
        current folder.
    changes : mapping, optional
        Keys that replace those of the source; tables are merged.

    Returns
    -------
    Mission

    Raises
    ------
    InputError
        One line with the file, the key, the value and what is allowed.

    Examples
    --------
    >>> import segfmu
    >>> mission = segfmu.load_mission({
    ...     "name": "across",
    ...     "crane": segfmu.Crane(bridge_mass=2.2, trolley_mass=1.155, payload_mass=1.0),
    ...     "limits": segfmu.Limits(velocity=1.0, acceleration=1.0, jerk=2.0, snap=20.0),
    ...     "waypoints": [segfmu.Waypoint([0, 0, -0.5]), segfmu.Waypoint([1.0, 0.5, -0.4])],
    ... })
    >>> mission
    <Mission 'across': 2 waypoints, payload 1 kg>
    >>> mission.plan()
    <Trajectory of x, y, z: 2 waypoints, 2.66682 s, smoothness 4, plateau>
    >>> segfmu.load_mission(mission, {"crane": {"payload_mass": 2.0}}).crane.payload_mass
    2.0
    """
    if changes is not None and not isinstance(changes, Mapping):
        raise InputError(f"changes of a mission are a dict, got {type(changes).__name__}")
    if isinstance(source, Mission) and not changes:
        return source
    if isinstance(source, str | Path):
        file: Path | None = Path(source)
        data = read_mission(Path(source))
    elif isinstance(source, Mapping | Mission):
        file = source.file if isinstance(source, Mission) else None
        data = _with_files(None, plain(source))
    else:
        raise InputError(f"a mission is a file or a dict, got {type(source).__name__}")
    mission = build_mission(file, merged(data, plain(changes or {})))
    mission._changed = bool(changes) or (isinstance(source, Mission) and source.changed)
    return mission


def read_mission(path: Path) -> dict[str, Any]:
    """The content of a mission file, with that of the files that it names.

    Raises
    ------
    InputError
        For files that cannot be read, and a crane file or a table that is wrong.
    """
    return _with_files(path, read(path))


def build_mission(path: Path | None, data: Mapping[str, Any]) -> Mission:
    """Check the content of a mission; `path` names its file, if it has one.

    Raises
    ------
    InputError
        As `load_mission` does.
    """
    where = str(path or "mission")
    mission = checked(Mission, data, where)
    mission._file = path
    try:
        true = "crane" if mission.true_crane is None else "true_crane"
        for name, crane in (("crane", mission.crane), (true, mission.driven)):
            crane_parameters.check(crane, name)
        check_models(mission)
        _check_nominal(mission)
    except InputError as error:
        raise InputError(f"{where}: {error}") from None
    return mission


def _check_nominal(mission: Mission) -> None:
    """What has to fit in a mission whatever the crane is in truth, and however it is run."""
    text = mission.model_dump_json(exclude=DISTURBED)
    if text not in _right:
        check_waypoints(mission)
        mission.build_clearance()
        _right.add(text)


def _with_files(path: Path | None, data: dict[str, Any]) -> dict[str, Any]:
    """The content of a mission with that of the files that it names."""
    require_kind("mission", data, path or "mission")
    found = dict(data)
    for key, kind, what in NAMED:
        value = data.get(key, "")
        if path is not None and not isinstance(value, (kind, str)):
            raise InputError(f"{path}: {key}: must be {what}, got {shown(value)}")
    if isinstance(data.get("crane"), str):
        found["crane"] = _crane_data(path, data["crane"])
    if isinstance(data.get("waypoints"), str):
        found["waypoints"] = _waypoint_data(path, data["waypoints"])
    return found


def files_of(mission: Path) -> list[Path]:
    """The file of a mission and those that it names, if it can be read."""
    try:
        data = read(mission)
    except InputError:
        return [mission]
    named = (data.get("crane"), data.get("waypoints"))
    return [mission, *(mission.parent / name for name in named if isinstance(name, str))]


def _named(mission: Path | None, key: str, name: str) -> Path:
    """A file that a mission names."""
    if not name.strip():
        raise InputError(f"{mission or 'mission'}: {key}: no file is named, got {shown(name)}")
    return Path(name) if mission is None else mission.parent / name


def _waypoint_data(mission: Path | None, name: str) -> list[Any]:
    """The waypoints of the table that a mission names."""
    path = _named(mission, "waypoints", name)
    try:
        return [plain(point) for point in waypoints_of(path, AXES, MOST_WAYPOINTS)]
    except InputError as error:
        raise of_named(mission or UNNAMED, "waypoints", path, error) from None


def _crane_data(mission: Path | None, name: str) -> dict[str, Any]:
    """The content of the crane file that a mission names, checked."""
    path = _named(mission, "crane", name)
    try:
        data = read(path)
        require_kind("crane", data, path)
        crane_parameters.check(checked(CraneFile, data, str(path)), str(path))
    except InputError as error:
        raise of_named(mission or UNNAMED, "crane", path, error) from None
    return data
