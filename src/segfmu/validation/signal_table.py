"""Tables of signals over time, read from CSV.

Columns are separated as in the first line: by commas, semicolons or tabs.
"""

from __future__ import annotations

import csv
import warnings
from collections.abc import Sequence
from pathlib import Path
from typing import TextIO

import numpy as np

from segfmu.arrays import FloatArray, shown
from segfmu.errors import InputError
from segfmu.planning.rows import LARGEST, delimiter_of, read_rows, without_units
from segfmu.validation.units import signal_units


def read_table(path: Path) -> dict[str, FloatArray]:
    """Columns of a CSV file by name: "time", which increases, and signals.

    Units in brackets behind the names are left out; signals of the FMUs must have theirs.

    Raises
    ------
    InputError
        If it cannot be read or is no such table.
    """
    try:
        with path.open(encoding="utf-8-sig", newline=None) as file:
            delimiter, cells = _header(file)
            data = _rows(file, delimiter)
    except OSError as error:
        raise InputError(f"{path}: cannot be read: {error.strerror}") from None
    except (ValueError, csv.Error):
        raise InputError(_wrong(path)) from None
    names = without_units(cells, signal_units(), str(path))
    _require_names(path, names)
    if data.shape[0] == 0:
        raise InputError(f"{path}: there is no row of numbers")
    if data.shape[1] != len(names):
        raise InputError(f"{path}: {len(names)} names but rows of {data.shape[1]} numbers")
    table: dict[str, FloatArray] = dict(zip(names, data.T, strict=True))
    require_increasing(table["time"], str(path))
    return table


def require_increasing(times: FloatArray, where: str) -> None:
    """Raise InputError unless times increase from row to row."""
    rows = np.flatnonzero(~(np.diff(times) > 0.0))
    if rows.size:
        first, second = times[rows[0] : rows[0] + 2].tolist()
        raise InputError(
            f"{where}: time does not increase: {second!r} s behind {first!r} s in row "
            f"{rows[0] + 2} of the numbers; leave out what is double, or begin another table"
        )


def _header(file: TextIO) -> tuple[str, list[str]]:
    line = file.readline()
    delimiter = delimiter_of(line)
    cells = next(csv.reader([line], delimiter=delimiter, skipinitialspace=True), [])
    return delimiter, [cell.strip() for cell in cells]


def _rows(file: TextIO, delimiter: str) -> FloatArray:
    with warnings.catch_warnings():
        # an empty table is refused later
        warnings.filterwarnings("ignore", "loadtxt: input contained no data")
        return np.loadtxt(file, delimiter=delimiter, ndmin=2)


def _require_names(path: Path, names: Sequence[str]) -> None:
    if "time" not in names:
        found = ", ".join(names)
        raise InputError(f"{path}: no column time; the first line has {shown(found)}")
    double = next((name for name in names if names.count(name) > 1), None)
    if double is not None:
        raise InputError(f"{path}: two columns have one name, {shown(double)}")


def _wrong(path: Path) -> str:
    """The first line that has something else than numbers."""
    if path.stat().st_size > LARGEST:
        return f"{path}: no table of numbers"
    rows = read_rows(path)
    for number, cells in rows[1:]:
        where = f"{path}, line {number}"
        if len(cells) != len(rows[0][1]):
            return f"{where}: {len(cells)} values for {len(rows[0][1])} columns"
        for name, cell in zip(rows[0][1], cells, strict=True):
            try:
                float(cell)
            except ValueError:
                comma = "; numbers have a decimal point" if "," in cell else ""
                return f"{where}: {name} must be a number, got {shown(cell)}{comma}"
    return f"{path}: no table of numbers"
