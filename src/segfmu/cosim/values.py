"""Values of Python for the variables of an FMU."""

from __future__ import annotations

import ctypes
from collections.abc import Mapping, Sequence
from math import prod
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from segfmu.arrays import shown
from segfmu.cosim.channel import Channel
from segfmu.cosim.domain import Domain, domain
from segfmu.errors import InputError, meant

if TYPE_CHECKING:
    from segfmu.cosim.unit import Unit

# lists of variables whose channels are kept
MOST_GROUPS = 256


class Setter:
    """Fills the buffers from which single variables are set; a buffer is made once.

    Parameters
    ----------
    unit : Unit
        The FMU.
    """

    def __init__(self, unit: Unit) -> None:
        self._unit = unit
        self._channels: dict[str, Channel] = {}
        self._domains: dict[str, Domain] = {}
        self._texts: dict[str, Any] = {}
        self._groups: dict[tuple[str, ...], list[tuple[tuple[str, ...], Channel]]] = {}

    def fill(self, name: str, value: Any) -> Channel:
        """The channel of a variable, its buffer filled with a value."""
        unit = self._unit
        variable = unit.variables.get(name)
        if variable is None:
            hint = meant(name, unit.variables)
            raise InputError(f"{unit.name} has no variable {name}{hint}")
        if variable.type not in unit.TYPES:
            raise InputError(f"{unit.name}: {name} is of type {variable.type}, not supported")
        channel = self._channels.get(name) or self._made(name, variable)
        if not variable.dimensions:
            self._store(channel, name, [self._real(name, value)])
            return channel
        numbers = [self._number(variable, v) for v in _flat(value)]
        size = channel.values.size
        row = prod(int(d.start) for d in variable.dimensions[1:])
        if len(numbers) > size or len(numbers) % row != 0:
            raise InputError(
                f"{unit.name}: {name} takes up to {size} values in rows of {row}, got "
                f"{len(numbers)}"
            )
        if len(numbers) < size:
            channel.read()
        self._store(channel, name, numbers)
        return channel

    def assignments(
        self, values: Mapping[str, Any]
    ) -> list[tuple[Channel, NDArray[Any]]]:
        """Channels that set variables, and what their buffers have to hold.

        Numbers that are real are set at once, all others one by one.
        """
        names = tuple(values)
        if names not in self._groups:
            if len(self._groups) >= MOST_GROUPS:
                self._groups.clear()
            self._groups[names] = self._grouped(names)
        groups = self._groups[names]
        found = []
        for group, channel in groups:
            own = [values[name] for name in group]
            if any(type(value) is not float for value in own):
                own = [self._real(name, values[name]) for name in group]
            found.append((channel, np.array(own, channel.values.dtype)))
        grouped = {name for group, _ in groups for name in group}
        for name in names:
            if name not in grouped:
                channel = self.fill(name, values[name])
                found.append((channel, channel.values.copy()))
        return found

    def _grouped(self, names: Sequence[str]) -> list[tuple[tuple[str, ...], Channel]]:
        """Scalar real variables, those of a type together."""
        unit = self._unit
        types: dict[str, list[str]] = {}
        for name in names:
            variable = unit.variables[name]
            if unit.TYPES.get(variable.type) is float and not variable.dimensions:
                types.setdefault(variable.type, []).append(name)
        return [(tuple(own), unit.channel(own)) for own in types.values()]

    def _real(self, name: str, value: Any) -> float | int:
        if not isinstance(value, (float, int, str)):
            value = self._single(name, value)
        return self._number(self._unit.variables[name], value)

    def require_within(self, values: Mapping[str, Any]) -> None:
        """Refuse numbers outside of the ranges of their variables; what else is wrong `fill` tells.

        Raises
        ------
        InputError
            For the first one.
        """
        unit = self._unit
        for name, value in values.items():
            variable = unit.variables.get(name)
            if variable is None or unit.TYPES.get(variable.type) in (None, str):
                continue
            own = self._domain(variable)
            if own.bounded:
                told = f"{unit.name}: {name}"
                for number in _flat(value):
                    own.require_within(told, own.number(told, number))

    def forget(self) -> None:
        """Free the texts of a run."""
        self._texts.clear()

    def _store(self, channel: Channel, name: str, numbers: list[float | int]) -> None:
        try:
            channel.values[: len(numbers)] = numbers
        except OverflowError:
            raise InputError(
                f"{self._unit.name}: {name} takes integers of {8 * channel.values.itemsize} bits, "
                f"got {numbers[0]}"
            ) from None

    def _made(self, name: str, variable: Any) -> Channel:
        channel = self._unit.channel([name])
        # the size of an array may follow from a structural parameter
        if not variable.dimensions:
            self._channels[name] = channel
        return channel

    def _single(self, name: str, value: Any) -> Any:
        flat = _flat(value)
        if len(flat) != 1:
            raise InputError(f"{self._unit.name}: {name} takes one value, got {len(flat)}")
        return flat[0]

    def _number(self, variable: Any, value: Any) -> float | int:
        """A number of the variable's kind; for a string the address of its bytes."""
        owner, kind = self._unit.name, self._unit.TYPES[variable.type]
        if kind is str:
            return self._text(variable, value)
        return self._domain(variable).number(f"{owner}: {variable.name}", value)

    def _domain(self, variable: Any) -> Domain:
        found = self._domains.get(variable.name)
        if found is None:
            found = domain(variable, self._unit.TYPES[variable.type])
            self._domains[variable.name] = found
        return found

    def _text(self, variable: Any, value: Any) -> int:
        if not isinstance(value, str):
            raise InputError(f"{self._unit.name}: {variable.name} takes a text, got {shown(value)}")
        if "\0" in value:
            raise InputError(f"{self._unit.name}: {variable.name} takes no text with a zero byte")
        # texts of a change are needed until its time, by their addresses
        memory = self._texts.get(value)
        if memory is None:
            memory = self._texts[value] = ctypes.create_string_buffer(value.encode("utf-8"))
        return ctypes.addressof(memory)


def _flat(value: Any) -> list[Any]:
    return [value] if isinstance(value, str) else list(np.ravel(np.asarray(value, dtype=object)))
