"""Rows of a co-simulation's result, collected in blocks, one per buffer."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from segfmu.arrays import as_names, require_mapping
from segfmu.cosim.unit import Unit
from segfmu.errors import InputError, meant, no_variable

# rows in a block before it is copied to the result's columns
BLOCK = 256


@dataclass(frozen=True, eq=False)
class Column:
    """A field of the rows, its type, and where its values are read."""

    field: str
    kind: Any
    values: NDArray[Any]
    place: int


def columns(units: Mapping[str, Unit], recorded: Mapping[str, Mapping[str, str]]) -> list[Column]:
    """Columns of variables that units observe, whose fields are those of `fields`."""
    found = []
    for owner, unit in units.items():
        own = recorded.get(owner, {})
        for group, channel in unit.observed:
            kind = unit.COLUMNS[unit.variables[group[0]].type]
            found += [
                Column(own[name], kind, channel.values, place)
                for place, name in enumerate(group) if name in own
            ]
    return found


def fields(
    recorded: Mapping[str, Sequence[str]], kept: Collection[str] | None = None
) -> dict[str, dict[str, str]]:
    """Fields of the rows by unit and variable: "unit.name" where two units have one name.

    Raises
    ------
    InputError
        For a field among those to keep that there is not.
    """
    names = ["time", *(name for own in recorded.values() for name in own)]
    found = {
        owner: {n: n if names.count(n) == 1 else f"{owner}.{n}" for n in own}
        for owner, own in recorded.items()
    }
    if kept is None:
        return found
    known = [field for own in found.values() for field in own.values()]
    for field in kept:
        if field not in known:
            raise no_variable(field, known)
    return {
        owner: {n: field for n, field in own.items() if field in kept}
        for owner, own in found.items()
    }


def chosen(
    units: Mapping[str, Unit], record: Mapping[str, Sequence[str] | None] | None
) -> dict[str, list[str]]:
    """Names of the variables to record, by unit; by default all scalar outputs.

    Raises
    ------
    InputError
        For units and variables that there are not, and for those that are no single number.
    """
    if record is None:
        return {owner: unit.outputs() for owner, unit in units.items()}
    require_mapping("record", record)
    found: dict[str, list[str]] = {owner: [] for owner in units}
    for owner, names in record.items():
        if owner not in units:
            raise InputError(f"no FMU {owner} in the system; it has {', '.join(units)}")
        if names is None:
            found[owner] = units[owner].outputs()
            continue
        found[owner] = list(dict.fromkeys(as_names(f"record of {owner}", names)))
        for name in found[owner]:
            variable = units[owner].variables.get(name)
            if variable is None:
                hint = meant(name, units[owner].variables)
                raise InputError(f"{owner} has no variable {name}{hint}")
            if variable.type not in units[owner].COLUMNS or variable.dimensions:
                raise InputError(f"{owner}: {name} is no number, only numbers can be recorded")
    return found


def row_type(found: Sequence[Column]) -> np.dtype[np.void]:
    """The type of rows: "time" and the columns."""
    return np.dtype([("time", np.float64), *((c.field, c.kind) for c in found)])


class Table:
    """Time and columns at every communication point.

    Parameters
    ----------
    times : ndarray, shape (n,)
        Communication points [s].
    found : sequence of Column
        What is recorded.
    """

    def __init__(self, times: NDArray[np.float64], found: Sequence[Column]) -> None:
        self.rows: NDArray[np.void] = np.zeros(times.size, row_type(found))
        self.rows["time"] = times
        buffers = {id(c.values): c.values for c in found}
        blocks = {k: np.zeros((BLOCK, v.size), v.dtype) for k, v in buffers.items()}
        self._blocks = [(blocks[k], v) for k, v in buffers.items()]
        self._columns = [(self.rows[c.field], blocks[id(c.values)][:, c.place]) for c in found]

    def record(self, i: int) -> None:
        """Store the values that were read last as row `i`; rows must be consecutive."""
        place = i % BLOCK
        for block, values in self._blocks:
            block[place] = values
        if place == BLOCK - 1 or i == self.rows.size - 1:
            for column, gathered in self._columns:
                column[i - place:i + 1] = gathered[:place + 1]
