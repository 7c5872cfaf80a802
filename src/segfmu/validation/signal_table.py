"""Tables of signals over time, read from CSV.

Columns are separated as in the first line: by commas, semicolons or tabs.
"""

from __future__ import annotations

import csv
import warnings
from array import array
from collections.abc import Collection, Iterable, Mapping, Sequence
from pathlib import Path
from typing import TextIO

import numpy as np

from segfmu.arrays import FloatArray, shown
from segfmu.errors import InputError
from segfmu.planning.rows import (
    LARGEST,
    count_hint,
    delimiter_of,
    is_row,
    name_and_unit,
    no_names,
    number_of,
    read_rows,
    repeated,
    require_count,
    without_units,
)
from segfmu.validation.units import signal_units


def read_table(
    path: Path, used: Collection[str] | None = None, columns: Mapping[str, str] | None = None
) -> dict[str, FloatArray]:
    """Columns of a CSV file by name: "time", which increases, and signals.

    Units in brackets behind the names are left out; signals of the FMUs must have theirs.

    Parameters
    ----------
    path : Path
    used : collection of str, optional
        Names of the columns that are read; others may hold anything. Unless given, all are read.
    columns : mapping of str to str, optional
        Of time and signals that have another name in the file: that name, as which they are read.

    Raises
    ------
    InputError
        If it cannot be read or is no such table.
    """
    other = columns or {}
    time = other.get("time", "time")
    delimiter, cells = _header(path)
    names = bare_names(cells, other, str(path))
    _require_names(path, names, time, names if used is None else used)
    read = [i for i, name in enumerate(names) if used is None or name in used]
    try:
        with path.open(encoding="utf-8-sig", newline=None) as file:
            _skip_header(file)
            data = _rows(file, delimiter)
    except (ValueError, csv.Error):
        # what else the file has may be no numbers
        data = _cells(path, names, read, names.index(time))
    if data.size == 0:
        raise InputError(f"{path}: there is no row of numbers")
    if (count := data.shape[1]) != len(names):
        hint = count_hint(count, len(names))
        raise InputError(f"{path}: {len(names)} names but rows of {count} numbers{hint}")
    table: dict[str, FloatArray] = {names[i]: data[:, i] for i in read}
    require_increasing(table[time], str(path))
    return table


def bare_names(cells: Iterable[str], columns: Mapping[str, str], where: str) -> list[str]:
    """Names of columns without units; of signals, those of `columns` too, these must be theirs.

    Raises
    ------
    InputError
        For another unit.
    """
    own = signal_units()
    units = own | {name: own[signal] for signal, name in columns.items() if signal in own}
    return without_units(list(cells), units, where)


def require_increasing(times: FloatArray, where: str) -> None:
    """Raise InputError unless times increase from row to row."""
    rows = np.flatnonzero(~(np.diff(times) > 0.0))
    if rows.size:
        first, second = times[rows[0] : rows[0] + 2].tolist()
        raise _no_increase(first, second, int(rows[0]) + 2, where)


def _no_increase(first: float, second: float, row: int, where: str) -> InputError:
    return InputError(
        f"{where}: time does not increase: {second!r} s behind {first!r} s in row {row} of the "
        "numbers; leave out what is double, or begin another table"
    )


def column_names(path: Path) -> list[str]:
    """Names of the columns of a CSV file, without units."""
    return [name_and_unit(cell)[0] for cell in _header(path)[1]]


def column_units(path: Path) -> dict[str, str]:
    """Units in brackets behind the names of the columns of a CSV file, of those that have one."""
    found = dict(name_and_unit(cell) for cell in _header(path)[1])
    return {name: unit for name, unit in found.items() if unit}


def _header(path: Path) -> tuple[str, list[str]]:
    try:
        with path.open(encoding="utf-8-sig", newline=None) as file:
            line = _skip_header(file)
    except OSError as error:
        raise InputError(f"{path}: cannot be read: {error.strerror}") from None
    except ValueError:
        raise InputError(f"{path}: cannot be read: it is not text in UTF-8") from None
    if not line.strip():
        raise InputError(f"{path}: empty; the first line names the columns, such as time,wind.x")
    delimiter = delimiter_of(line)
    try:
        cells = next(csv.reader([line], delimiter=delimiter, skipinitialspace=True), [])
    except csv.Error as error:
        raise InputError(f"{path}: the first line is no names of columns: {error}") from None
    return delimiter, [cell.strip() for cell in cells]


def _skip_header(file: TextIO) -> str:
    """The first line that is neither empty nor begins with #; what follows is left to be read."""
    return next((line for line in iter(file.readline, "") if is_row(line)), "")


def _rows(file: TextIO, delimiter: str) -> FloatArray:
    with warnings.catch_warnings():
        # an empty table is refused later
        warnings.filterwarnings("ignore", "loadtxt: input contained no data")
        return np.loadtxt(file, delimiter=delimiter, ndmin=2)


def _cells(path: Path, names: Sequence[str], read: Sequence[int], time: int) -> FloatArray:
    """The numbers of some columns of a file that has other things as well.

    A time that does not increase ends it: the rest of a large file takes long.
    """
    if path.stat().st_size > LARGEST:
        raise InputError(f"{path}: no table of numbers")
    rows = read_rows(path)
    next(rows)
    columns = {i: array("d") for i in read}
    times = columns[time]
    for number, cells in rows:
        where = f"{path}, line {number}"
        require_count(where, cells, names)
        for i, column in columns.items():
            column.append(_number(where, names[i], cells[i]))
        if len(times) > 1 and not times[-1] > times[-2]:
            raise _no_increase(times[-2], times[-1], len(times), str(path))
    data = np.full((len(times), len(names)), np.nan)
    for i, column in columns.items():
        data[:, i] = column
    return data


def _number(where: str, name: str, cell: str) -> float:
    try:
        return number_of(cell)
    except ValueError:
        hint = "; numbers have a decimal point" if "," in cell else ""
        hint = hint if cell else "; leave out the rows that lack one"
        raise InputError(f"{where}: {name} must be a number, got {shown(cell)}{hint}") from None


def _require_names(path: Path, names: Sequence[str], time: str, used: Collection[str]) -> None:
    if time not in names:
        found = ", ".join(names)
        hint = no_names(names)
        raise InputError(f"{path}: no column {time}; the first line has {shown(found)}{hint}")
    wanted = set(used)
    double = repeated(name for name in names if name in wanted)
    if double is not None:
        raise InputError(f"{path}: two columns have one name, {shown(double)}")
