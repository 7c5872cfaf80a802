"""Two FMUs that are connected by name, as files for other tools describe them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from segfmu.fmu.standard.fmi2 import text
from segfmu.fmu.standard.fmi3 import starts
from segfmu.fmu.standard.references import Entry, entries
from segfmu.fmu.standard.spec import Spec, Value, Variable

# Shifts the source's outputs by a time [s]. Importers that step both FMUs with the values of the
# step before hand outputs on one step late, which a shift by the step makes up for.
LEAD = "setpoint.lead"


@dataclass(frozen=True)
class System:
    """A source whose outputs are the inputs of a sink that have the same names.

    Attributes
    ----------
    title : str
        What the system is, for its users.
    source, sink : Spec
        Interfaces of the FMUs, whose names are those of the components. Their start values are the
        system's parameters; the source's default experiment is that of the system.
    fmi : int
        Version of FMI of both.
    """

    title: str
    source: Spec
    sink: Spec
    fmi: int = 2

    @property
    def specs(self) -> tuple[Spec, Spec]:
        """Both interfaces, the source first."""
        return self.source, self.sink

    @property
    def connections(self) -> tuple[str, ...]:
        """Names of outputs of the source that are inputs of the sink."""
        sources = {v.name for v in self.source.where("output")}
        return tuple(v.name for v in self.sink.where("input") if v.name in sources)


def archive(spec: Spec) -> str:
    """The name of the file that is an FMU."""
    return f"{spec.name}.fmu"


def values(spec: Spec) -> Iterator[tuple[Variable, Value]]:
    """Parameters and their values, of tables the rows in use.

    Tables that were computed are left out: those in the FMU are the same.
    """
    left_out = _left_out(spec)
    for variable in spec.where("parameter"):
        if variable.name == LEAD:
            yield variable, spec.step_size
        elif variable.name not in left_out and variable.start is not None:
            yield variable, variable.start


def settings(spec: Spec, fmi: int) -> Iterator[tuple[Entry, str]]:
    """The same as a version of FMI has them, values as XML has them; arrays with all rows."""
    given = {v.name: value for v, value in values(spec)}
    for entry in entries(spec, fmi):
        variable = entry.variable
        if entry.array is not None:
            if not variable.computed:
                yield entry, starts(entry.array, spec)
        elif variable.name in given:
            yield entry, text(variable, given[variable.name])


def _left_out(spec: Spec) -> set[str]:
    found: set[str] = set()
    for array in spec.arrays:
        if spec.variable(array.members[0]).computed:
            found |= {array.rows, *array.members}
        else:
            used = int(spec.variable(array.rows).start or 0)
            found |= set(array.members[used * array.columns :])
    return found
