"""Cells of a CSV file, as spreadsheets of all countries write it."""

from __future__ import annotations

import csv
import re
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path

from segfmu.errors import InputError

# between columns, what the first line has
DELIMITERS = (";", "\t", ",")
LARGEST = 64_000_000
# behind a name, as in "load.position.x [m]" or "alpha (deg)"; without a space "der(x)" and "x[2]"
# are names
UNIT = re.compile(r"(?:\s+[\[(]|\[(?!\d))([^\])]*)[\])]$")


# between words, what separates columns elsewhere
APART = re.compile(r"\S[\s|:]+\S")
NUMBER = re.compile(r"[-+]?(\d+([.,]\d*)?|[.,]\d+)([eE][-+]?\d+)?")


def is_row(line: str) -> bool:
    """Whether a line is neither empty nor begins with #."""
    return bool(line.strip()) and not line.lstrip().startswith("#")


def delimiter_of(line: str) -> str:
    """What is between the columns of a first line."""
    return next((d for d in DELIMITERS if d in line), ",")


def repeated(names: Iterable[str]) -> str | None:
    """The first name that is there twice."""
    return next((name for name, count in Counter(names).items() if count > 1), None)


def require_count(where: str, cells: Sequence[str], names: Sequence[str]) -> None:
    """Refuse a row that has not as many cells as there are columns.

    Raises
    ------
    InputError
        For another number of cells.
    """
    count, most = len(cells), len(names)
    if count != most:
        hint = count_hint(count, most)
        raise InputError(f"{where}: {count} values for {most} columns{hint}")


def count_hint(count: int, most: int) -> str:
    """The end of a message on a row of so many values for so many columns; empty without a hint."""
    if count > most:
        return "; decimals have a point"
    return "; values are separated as the names in the first line are" if count == 1 else ""


def no_names(cells: Sequence[str]) -> str:
    """The end of a message on a first line that lacks a name: what it may be instead, or empty."""
    if len(cells) == 1 and APART.search(cells[0]):
        return "; columns are separated by commas, semicolons or tabs"
    if cells and all(map(NUMBER.fullmatch, cells)):
        return "; the first line has to name the columns"
    return ""


def number_of(cell: str) -> float:
    """The number that a cell is.

    Raises
    ------
    ValueError
        For a text, also for what is a number in Python alone, such as 1_000.
    """
    if "_" in cell or not cell.isascii():
        raise ValueError(f"no number: {cell}")
    return float(cell)


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


def read_rows(file: Path) -> Iterator[tuple[int, list[str]]]:
    """Numbers and cells of the lines that are neither empty nor begin with #, one by one.

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
    delimiter = ""
    for number, line in enumerate(text.splitlines(), 1):
        if not is_row(line):
            continue
        delimiter = delimiter or delimiter_of(line)
        try:
            reader = csv.reader([line], delimiter=delimiter, strict=True, skipinitialspace=True)
            cells = next(reader)
        except csv.Error as error:
            raise InputError(f"{file}, line {number}: {error}") from None
        yield number, [cell.strip() for cell in cells]
