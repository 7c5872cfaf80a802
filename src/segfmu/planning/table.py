"""Waypoints from a table: a CSV file whose columns have names."""

from __future__ import annotations

import re
from collections.abc import Sequence
from math import isfinite
from pathlib import Path
from typing import Any

from segfmu.arrays import as_tuple, shown
from segfmu.errors import InputError
from segfmu.planning.rows import no_names, number_of, read_rows, require_count, without_units
from segfmu.planning.waypoint import Waypoint

# before an underscore and the name of an axis
STATES = ("velocity", "acceleration")
DWELL = "dwell"
USUAL = ("x", "y", "z")
FREE = "free"
# a number or a unit is none
NAME = re.compile(r"[^\W\d][^()\[\]]*")
UNITS = {
    DWELL: "s", **dict.fromkeys(USUAL, "m"),
    **{f"{state}_{axis}": unit for state, unit in zip(STATES, ("m/s", "m/s2"), strict=True)
       for axis in USUAL},
}


def read_waypoints(path: str | Path, axes: Sequence[str] | None = None) -> list[Waypoint]:
    """Read waypoints from a table in a CSV file, one a row.

    The first line names the columns: the position of each axis by the name of the axis, and, if
    wanted, `velocity_x`, `acceleration_x` and so on, and `dwell`. Units are m, m/s, m/s2 and s;
    they may stand in brackets behind the names. A velocity or acceleration can be `free`. An empty
    one, or one without a column, is 0, as is an empty dwell. Columns are separated by commas,
    semicolons or tabs. Empty lines and those that begin with # are skipped.

    Parameters
    ----------
    path : str or Path
    axes : sequence of str, optional
        Names of the axes in the order of the waypoints' values. By default x, y, z in this order
        where the table has these, else the axes in the order of their columns.

    Returns
    -------
    list of Waypoint

    Raises
    ------
    InputError
        If the file cannot be read, a column is missing, unknown or there twice, or a value is no
        number. The message names file, line, column and value.
    """
    return waypoints_of(path, axes)


def waypoints_of(
    path: str | Path, axes: Sequence[str] | None, most: int | None = None
) -> list[Waypoint]:
    """As `read_waypoints`; InputError where there are more than `most` of them."""
    file = _path(path)
    lines = read_rows(file)
    number, cells = next(lines, (0, []))
    if not cells:
        raise InputError(f"{file}: empty; the first line names the columns, such as x,y,z,dwell")
    where = f"{file}, line {number}"
    names = without_units(cells, UNITS, where)
    if len(cells) == 1 and (hint := no_names(cells)):
        raise InputError(f"{where}: one column, {shown(cells[0])}{hint}")
    found = _axes(where, names) if axes is None else as_tuple("axes", axes)
    _require_columns(where, names, found)
    points: list[Waypoint] = []
    for number, cells in lines:
        place = f"{file}, line {number}"
        if len(points) == most:
            raise InputError(f"{place}: more than {most} waypoints; leave some of them out")
        require_count(place, cells, names)
        points.append(_waypoint(place, dict(zip(names, cells, strict=True)), found))
    return points


def _path(path: str | Path) -> Path:
    if not isinstance(path, str | Path):
        raise InputError(f"a table of waypoints is a file, got {shown(path)}")
    return Path(path)


def _is_state(name: str, names: list[str]) -> bool:
    """Whether a column is a state of an axis, perhaps one that is misspelt."""
    axis = name.rpartition("_")[2]
    return name.startswith(tuple(f"{s}_" for s in STATES)) or (axis != name and axis in names)


def _axes(where: str, names: list[str]) -> tuple[str, ...]:
    """The axes that the columns name."""
    wrong = next((n for n in names if n and not NAME.fullmatch(n)), None)
    if wrong is not None:
        raise InputError(
            f"{where}: {shown(wrong)} is no name of a column; the first line has names, such as "
            "x,y,z,dwell, and units in brackets, such as x [m]"
        )
    found = tuple(n for n in names if n and n != DWELL and not _is_state(n, names))
    if not found:
        raise InputError(f"{where}: no column has a position; name one by its axis, such as x")
    usual = {n.lower() for n in found} >= set(USUAL)
    return USUAL if usual else found


def _require_columns(where: str, names: list[str], axes: tuple[str, ...]) -> None:
    """InputError for columns that are missing, unknown, or there twice."""
    known = [*axes, *(f"{state}_{axis}" for state in STATES for axis in axes), DWELL]
    for number, name in enumerate(names, 1):
        if name not in known:
            called = shown(name) if name else f"{number} has no name"
            raise InputError(f"{where}: column {called}: known are {', '.join(map(str, known))}")
        if names.index(name) != number - 1:
            raise InputError(f"{where}: column {name} is there twice")
    for axis in axes:
        if axis not in names:
            raise InputError(f"{where}: no column {axis}, the position of axis {axis}")


def _waypoint(where: str, row: dict[str, str], axes: tuple[str, ...]) -> Waypoint:
    position = [_number(where, axis, row[axis]) for axis in axes]
    states: list[list[float | None]] = [
        [_state(where, f"{state}_{axis}", row.get(f"{state}_{axis}", "")) for axis in axes]
        for state in STATES
    ]
    dwell = _number(where, DWELL, row.get(DWELL) or "0")
    if dwell < 0.0:
        raise InputError(f"{where}, column dwell: must be a time >= 0 s, got {row[DWELL]}")
    velocity, acceleration = (_free(values) for values in states)
    return Waypoint(position, velocity, acceleration, dwell=dwell)


def _free(values: list[float | None]) -> Any:
    return FREE if all(v is None for v in values) else values


def _state(where: str, column: str, cell: str) -> float | None:
    """A velocity or acceleration; None where free."""
    return None if cell == FREE else _number(where, column, cell or "0", ' or "free"')


def _number(where: str, column: str, cell: str, other: str = "") -> float:
    try:
        value = number_of(cell)
    except ValueError:
        value = float("nan")
    if not isfinite(value):
        comma = "; decimals have a point" if "," in cell else ""
        raise InputError(
            f"{where}, column {column}: must be a finite number{other}, got {shown(cell)}{comma}"
        )
    return value
