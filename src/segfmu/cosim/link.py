"""Connections by name: outputs of one unit to inputs of the other."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from numpy.typing import NDArray

from segfmu.cosim.unit import Unit, alike
from segfmu.errors import InputError


class Link:
    """Passes outputs of one unit to the inputs of another with the same names.

    The other unit sets its inputs from the buffer into which the outputs are read: nothing is
    copied if both have the same type of value.

    Parameters
    ----------
    first, second : Unit
        Source and sink.
    order : int
        Highest derivative of real outputs that is passed on; 0: none.

    Raises
    ------
    InputError
        If the types of output and input differ.
    """

    def __init__(self, first: Unit, second: Unit, *, order: int) -> None:
        inputs = {n: v for n, v in second.variables.items() if v.causality == "input"}
        names = [n for n in first.outputs() if n in inputs]
        for name in names:
            if first.kind(name) is not second.kind(name):
                raise InputError(f"{name}: types of output and input differ")
        groups = alike(names, first, second)
        first.observe([n for group in groups for n in group])
        second.observe()
        self._read = first.read_outputs
        self._conversions: list[tuple[NDArray[Any], NDArray[Any]]] = []
        self._writes: list[Callable[[], None]] = []
        for group in groups:
            given = first.observed_values(group)
            sink = second.channel(group, given)
            self._writes.append(sink.write)
            if sink.values is not given:
                self._conversions.append((sink.values, given))
        reals = [n for n in names if first.kind(n) is float]
        self._slopes: list[Callable[[], None]] = []
        if order and reals:
            slopes = first.output_slopes(reals, order)
            self._slopes = [slopes.read, second.input_slopes(reals, order, slopes.values).write]

    def transfer_slopes(self) -> None:
        """Pass on the derivatives at the beginning of a step; they hold until its end."""
        for call in self._slopes:
            call()

    def transfer(self) -> None:
        """Read all outputs of the first unit and pass them on."""
        self._read()
        for taken, given in self._conversions:
            taken[:] = given
        for write in self._writes:
            write()
