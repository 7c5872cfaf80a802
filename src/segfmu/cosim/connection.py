"""Connections: outputs of one FMU of a system to inputs of another one."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from segfmu.arrays import as_names, as_tuple, shown
from segfmu.cosim.channel import Call, Copy, gathered
from segfmu.cosim.unit import Unit
from segfmu.errors import InputError, meant


class Connection(NamedTuple):
    """An output of the FMU `source` and the input of the FMU `sink` that gets its values."""

    source: str
    output: str
    sink: str
    input: str


class Link:
    """All connections from one unit to another one.

    Parameters
    ----------
    source, sink : Unit
        The units; the source observes the outputs.
    pairs : sequence of (str, str)
        Outputs and inputs.

    Attributes
    ----------
    transfer : list of Call and Copy
        What passes on the outputs that were read last.
    """

    def __init__(self, source: Unit, sink: Unit, pairs: Sequence[tuple[str, str]]) -> None:
        self.source, self.sink = source, sink
        self._reals = [pair for pair in pairs if source.kind(pair[0]) is float]
        self.transfer: list[Call | Copy] = []
        groups: dict[tuple[str, str], list[tuple[str, str]]] = {}
        for pair in pairs:
            types = source.variables[pair[0]].type, sink.variables[pair[1]].type
            groups.setdefault(types, []).append(pair)
        for group in groups.values():
            taken = sink.channel([name for _, name in group])
            places = [source.place(name) for name, _ in group]
            index = np.array([place for _, place in places], np.int64)
            self.transfer += [gathered(places[0][0], index, taken.values), taken.write]

    def pass_on(self) -> None:
        """Read the source's outputs and set the inputs."""
        self.source.read_outputs()
        for operation in self.transfer:
            operation()

    def slopes(self) -> list[Call]:
        """What passes on the derivatives at the beginning of a step; they hold until its end.

        Raises
        ------
        InputError
            If one of the FMUs has no derivatives.
        """
        if not self._reals:
            return []
        order = max(1, self.source.order)
        outputs, inputs = zip(*self._reals, strict=True)
        given = self.source.output_slopes(outputs, order)
        return [given.read, self.sink.input_slopes(inputs, order, given.values).write]

    @property
    def has_slopes(self) -> bool:
        """Whether both FMUs have what coupling by derivatives needs."""
        return self.source.order > 0 and self.sink.takes_derivatives


def checked(units: Mapping[str, Unit], given: Iterable[Sequence[str]]) -> list[Connection]:
    """Connections between variables that exist, have one kind, and inputs with one source.

    Raises
    ------
    InputError
        For all others, with their names.
    """
    found: list[Connection] = []
    taken: set[tuple[str, str]] = set()
    for words in as_tuple("connections", given):
        if len(as_names("a connection", words)) != 4:
            raise InputError(f"a connection has source, output, sink and input, got {shown(words)}")
        one = Connection(*words)
        for owner, name, causality in ((one.source, one.output, "output"),
                                       (one.sink, one.input, "input")):
            unit = units.get(owner)
            if unit is None:
                raise InputError(f"no FMU {owner} in the system; it has {', '.join(units)}")
            variable = unit.variables.get(name)
            if variable is None or variable.causality != causality:
                known = [n for n, v in unit.variables.items() if v.causality == causality]
                raise InputError(f"{owner} has no {causality} {name}{meant(name, known)}")
            if variable.type not in unit.COLUMNS or variable.dimensions:
                raise InputError(f"{owner}: {name} is no number, only numbers can be connected")
        if units[one.source].kind(one.output) is not units[one.sink].kind(one.input):
            raise InputError(f"{one.output}: types of output and input differ")
        if one.source == one.sink:
            raise InputError(f"{one.source}: {one.output} is connected to an input of its own")
        if (one.sink, one.input) in taken:
            raise InputError(f"{one.sink}: input {one.input} is connected twice")
        taken.add((one.sink, one.input))
        found.append(one)
    return found


def by_name(units: Mapping[str, Unit]) -> list[Connection]:
    """Outputs of every unit to the inputs of the same names of those behind it."""
    names = list(units)
    return [
        Connection(source, output, sink, output)
        for i, source in enumerate(names) for sink in names[i + 1:]
        for output in units[source].outputs()
        if (own := units[sink].variables.get(output)) is not None and own.causality == "input"
    ]
