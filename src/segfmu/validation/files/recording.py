"""Recordings: CSV files of variables that change during a run, such as an operator's commands.

The column "time" has times [s]; the others are variables. A row is held until the next one. Columns
are separated by commas, semicolons or tabs. Units in brackets behind names are left out.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from math import isfinite
from pathlib import Path

from segfmu.arrays import shown
from segfmu.cosim import Change
from segfmu.errors import InputError, meant
from segfmu.planning.rows import (
    no_names,
    number_of,
    read_rows,
    repeated,
    require_count,
    without_units,
)
from segfmu.validation.units import signal_units

TIME = "time"
# what the names of an operator's commands begin with
COMMANDS = "command."
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
    lines : tuple of int
        Of the rows in the file, from 1.
    """

    path: Path
    times: tuple[float, ...]
    columns: Mapping[str, tuple[Cell, ...]]
    lines: tuple[int, ...]

    @property
    def end(self) -> float:
        """Time of the last row [s]."""
        return self.times[-1]

    @property
    def commands(self) -> bool:
        """Whether there are commands of an operator."""
        return any(name.startswith(COMMANDS) for name in self.columns)

    def changes(self, variables: Mapping[str, Collection[str]]) -> Iterator[Change]:
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
                    yield Change(time, fmu, values, f"{self.path}, line {self.lines[i]}")

    def _owner(self, name: str, variables: Mapping[str, Collection[str]]) -> str:
        for fmu, names in variables.items():
            if name in names:
                return fmu
        hint = meant(name, [own for names in variables.values() for own in names])
        owners = " or ".join(variables)
        raise InputError(f"{self.path}: column {name} is no variable of {owners}{hint}")


def load_recording(path: Path) -> Recording:
    """Read and check a recording.

    Raises
    ------
    InputError
        One line with the file, the row, and what is wrong.
    """
    rows = read_rows(path)
    _, cells = next(rows, (0, []))
    if not cells:
        raise InputError(f"{path}: empty; the first line names the columns, such as time,wind.x")
    names = without_units(cells, signal_units(), str(path))
    _require_header(path, names)
    columns: dict[str, list[Cell]] = {name: [] for name in names if name != TIME}
    times: list[float] = []
    lines = []
    for number, row in rows:
        lines.append(number)
        where = f"{path}, line {number}"
        require_count(where, row, names)
        for name, text in zip(names, row, strict=True):
            cell = _cell(where, name, text)
            if name == TIME:
                times.append(_time(where, cell, times))
            else:
                columns[name].append(cell)
    if not lines:
        raise InputError(f"{path}: has no rows below its header")
    found = {name: tuple(cells) for name, cells in columns.items()}
    return Recording(path, tuple(times), found, tuple(lines))


def _require_header(path: Path, names: Sequence[str]) -> None:
    if TIME not in names:
        hint = no_names(names) or "; the first row names the columns"
        raise InputError(f"{path}: has no column {TIME}{hint}")
    double = repeated(names)
    if double is not None:
        raise InputError(f"{path}: two columns are called {double!r}")
    if len(names) == 1:
        raise InputError(f"{path}: has no column beside {TIME}; each is a variable of an FMU")


def _cell(where: str, name: str, text: str) -> Cell:
    """A number, true, false, or a name."""
    if not text:
        raise InputError(f"{where}: {name} is empty; repeat the value before")
    if text.lower() in ("true", "false"):
        return text.lower() == "true"
    try:
        number = number_of(text)
    except ValueError:
        if "," in text:
            raise InputError(
                f"{where}: {name}: got {text!r}; numbers have a decimal point"
            ) from None
        return text
    if not isfinite(number):
        raise InputError(f"{where}: {name} must be finite, got {text}")
    return number


def _time(where: str, cell: Cell, before: Sequence[float]) -> float:
    if isinstance(cell, bool | str) or cell < 0.0:
        raise InputError(f"{where}: {TIME} must be a time >= 0 s, got {shown(cell)}")
    if before and cell <= before[-1]:
        raise InputError(f"{where}: {TIME} must increase, got {cell:g} after {before[-1]:g}")
    return cell
