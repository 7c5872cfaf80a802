"""Recordings: CSV files of variables that change during a run, such as an operator's commands.

The column "time" has times [s]; the others are variables. A row is held until the next one.
"""

from __future__ import annotations

import csv
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from math import isfinite
from pathlib import Path

from segfmu.cosim import Change
from segfmu.errors import InputError

TIME = "time"
Cell = float | bool | str


@dataclass(frozen=True)
class Recording:
    """Rows of a recording.

    Attributes
    ----------
    path : Path
        Its file.
    times : tuple of float
        Of the rows, rising [s].
    columns : mapping of str to tuple
        A value for each row, by the name of the variable: a number, true, false, or the name of an
        item.
    """

    path: Path
    times: tuple[float, ...]
    columns: Mapping[str, tuple[Cell, ...]]

    @property
    def end(self) -> float:
        """Time of the last row [s]."""
        return self.times[-1]

    @property
    def commands(self) -> bool:
        """Whether there are commands of an operator."""
        return any(name.startswith("command.") for name in self.columns)

    def changes(self, variables: Mapping[str, Sequence[str]]) -> Iterator[Change]:
        """What changes when; `variables` of each FMU, of which the first that has one gets it.

        Raises
        ------
        InputError
            For a column that no FMU has.
        """
        owners = {name: self._owner(name, variables) for name in self.columns}
        for fmu in variables:
            own = [name for name in self.columns if owners[name] == fmu]
            for i, time in enumerate(self.times):
                values = {
                    name: self.columns[name][i]
                    for name in own
                    if i == 0 or self.columns[name][i] != self.columns[name][i - 1]
                }
                if values:
                    yield Change(time, fmu, values)

    def _owner(self, name: str, variables: Mapping[str, Sequence[str]]) -> str:
        for fmu, names in variables.items():
            if name in names:
                return fmu
        raise InputError(f"{self.path}: column {name} is no variable of {' or '.join(variables)}")


def load_recording(path: Path) -> Recording:
    """Read and check a recording.

    Raises
    ------
    InputError
        One line with the file, the row, and what is wrong.
    """
    try:
        with path.open(newline="", encoding="utf-8-sig") as file:
            header, *rows = [row for row in csv.reader(file) if row]
    except (OSError, UnicodeError, csv.Error, ValueError) as error:
        reason = error.strerror if isinstance(error, OSError) else "no table of commas and rows"
        raise InputError(f"{path}: cannot be read: {reason}") from None
    names = [name.strip() for name in header]
    _require_header(path, names)
    if not rows:
        raise InputError(f"{path}: has no rows below its header")
    for number, row in enumerate(rows, 1):
        if len(row) != len(names):
            raise InputError(f"{path}: row {number} has {len(row)} values, the header {len(names)}")
        for name, text in zip(names, row, strict=True):
            if not text.strip():
                raise InputError(f"{path}: row {number}: {name} is empty; repeat the value before")
    cells = {
        name: tuple(_cell(row[k]) for row in rows) for k, name in enumerate(names) if name != TIME
    }
    return Recording(path, _times(path, [row[names.index(TIME)] for row in rows]), cells)


def _require_header(path: Path, names: Sequence[str]) -> None:
    double = next((n for n in names if names.count(n) > 1), None)
    if double is not None:
        raise InputError(f"{path}: two columns are called {double!r}")
    if TIME not in names:
        raise InputError(f"{path}: has no column {TIME}; the first row names the columns")
    if len(names) == 1:
        raise InputError(f"{path}: has no column beside {TIME}; each is a variable of an FMU")


def _cell(text: str) -> Cell:
    """A number, true, false, or a name."""
    text = text.strip()
    if text.lower() in ("true", "false"):
        return text.lower() == "true"
    try:
        return float(text)
    except ValueError:
        return text


def _times(path: Path, texts: Sequence[str]) -> tuple[float, ...]:
    cells = [_cell(text) for text in texts]
    for number, (cell, text) in enumerate(zip(cells, texts, strict=True), 1):
        if not isinstance(cell, float) or not isfinite(cell) or cell < 0.0:
            raise InputError(f"{path}: row {number}: {TIME} must be a time >= 0 s, got {text!r}")
    times = tuple(float(cell) for cell in cells)
    for number, (first, second) in enumerate(pairwise(times), 2):
        if second <= first:
            raise InputError(
                f"{path}: row {number}: {TIME} must increase, got {second:g} after {first:g}"
            )
    return times
