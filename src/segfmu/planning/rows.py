"""Cells of a CSV file, as spreadsheets of all countries write it."""

from __future__ import annotations

import csv
import re
from collections.abc import Mapping
from pathlib import Path

from segfmu.errors import InputError

# between columns, what the first line has
DELIMITERS = (";", "\t", ",")
LARGEST = 64_000_000
# behind a name, as in "load.position.x [m]" or "alpha (deg)"; without a space "der(x)" and "x[2]"
# are names
UNIT = re.compile(r"(?:\s+[\[(]|\[(?!\d))([^\])]*)[\])]$")


def is_row(line: str) -> bool:
    """Whether a line is neither empty nor begins with #."""
    return bool(line.strip()) and not line.lstrip().startswith("#")


def delimiter_of(line: str) -> str:
    """What is between the columns of a first line."""
    return next((d for d in DELIMITERS if d in line), ",")


def name_and_unit(cell: str) -> tuple[str, str]:
    """Name of a column, and its unit in brackets, which may be missing."""
    found = UNIT.search(cell)
    unit = "" if found is None else found[1].strip().replace("^", "").replace("²", "2")
    return UNIT.sub("", cell), unit


def without_units(cells: list[str], units: Mapping[str, str], where: str) -> list[str]:
    """Names of columns; units in brackets behind them are left out.

    Raises
    ------
    InputError
        For another unit than that of a column in `units`.
    """
    names = []
    for cell in cells:
        name, unit = name_and_unit(cell)
        if unit and unit != units.get(name, unit):
            raise InputError(f"{where}: column {name} is in {unit}; give it in {units[name]}")
        names.append(name)
    return names


def read_rows(file: Path) -> list[tuple[int, list[str]]]:
    """Numbers and cells of the lines that are neither empty nor begin with #.

    Raises
    ------
    InputError
        If the file cannot be read, is too large, or is not text in UTF-8.
    """
    try:
        with file.open("rb") as stream:
            data = stream.read(LARGEST + 1)
        text = "" if len(data) > LARGEST else data.decode("utf-8-sig")
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or "it is not text in UTF-8"
        raise InputError(f"{file}: cannot be read: {reason}") from None
    if len(data) > LARGEST:
        raise InputError(f"{file}: larger than {LARGEST // 1_000_000} MB")
    rows = [
        (number, line) for number, line in enumerate(text.splitlines(), 1) if is_row(line)
    ]
    delimiter = delimiter_of(rows[0][1] if rows else "")
    found = []
    for number, line in rows:
        try:
            reader = csv.reader([line], delimiter=delimiter, strict=True, skipinitialspace=True)
            cells = next(reader)
        except csv.Error as error:
            raise InputError(f"{file}, line {number}: {error}") from None
        found.append((number, [cell.strip() for cell in cells]))
    return found
