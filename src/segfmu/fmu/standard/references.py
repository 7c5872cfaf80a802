"""The value references of both versions of the standard."""

from __future__ import annotations

from dataclasses import dataclass

from segfmu.fmu.standard.spec import Array, Spec, Variable


@dataclass(frozen=True)
class Entry:
    """One value reference: a scalar, or an array of FMI 3.0 with its first member."""

    name: str
    variable: Variable
    array: Array | None = None

    @property
    def description(self) -> str:
        """What it is."""
        return self.variable.description if self.array is None else self.array.description

    @property
    def shape(self) -> tuple[int, ...]:
        """Sizes of an array; none of a scalar."""
        if self.array is None:
            return ()
        rows, columns = len(self.array.members) // self.array.columns, self.array.columns
        return (rows, columns) if columns > 1 else (rows,)


def entries(spec: Spec, version: int) -> list[Entry]:
    """The value references of one version of FMI, in their order.

    FMI 2.0 need not name time, and OpenModelica makes it a variable that hides its own time.
    """
    if version == 2:
        return [Entry(v.name, v) for v in spec.variables if v.causality != "independent"]
    variables = {v.name: v for v in spec.variables}
    first = {a.members[0]: a for a in spec.arrays}
    members = {m for a in spec.arrays for m in a.members}
    rows = []
    for v in spec.variables:
        if v.name in first:
            array = first[v.name]
            rows.append(Entry(array.name, variables[v.name], array))
        elif v.name not in members:
            rows.append(Entry(v.name, v))
    return rows
