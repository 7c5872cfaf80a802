"""One FMU in a co-simulation: its archive, its instance, and buffers for its variables."""

from __future__ import annotations

import ctypes
import shutil
from abc import ABC, abstractmethod
from collections.abc import Callable, Sequence
from math import prod
from pathlib import Path
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from segfmu.cosim.channel import Channel
from segfmu.cosim.messages import ERROR, FATAL, OK, WARNING, Messages
from segfmu.errors import InputError, SimulationError

# s; times that differ by less are equal
INSTANT = 1e-9


class Unit(ABC):
    """An instantiated co-simulation FMU; a context manager that always frees it.

    Parameters
    ----------
    folder : Path
        The unpacked archive, removed at the end.
    description
        Its model description, as fmpy reads it.
    leads : bool
        Whether steps may end at its events.

    Attributes
    ----------
    observed : list of (list of str, Channel)
        Names and values of all outputs after `observe`, by type.
    """

    # types of the standard -> types in Python and in a result
    TYPES: ClassVar[dict[str, type]]
    # functions of fmpy's instance that end a simulation and free it
    fmu: Any

    def __init__(self, folder: Path, description: Any, leads: bool) -> None:
        self.description = description
        self.name = description.modelName
        self.messages = Messages(self.name)
        self.variables = {v.name: v for v in description.modelVariables}
        self._folder, self._leads = folder, leads
        self._instantiated = self._initialised = False
        self._worst = OK
        self.observed: list[tuple[list[str], Channel]] = []
        self._instantiate()
        self._instantiated = True

    @abstractmethod
    def _instantiate(self) -> None:
        """Make the instance."""

    @abstractmethod
    def channel(self, names: Sequence[str], values: NDArray[Any] | None = None) -> Channel:
        """A channel for some variables of one type, at least one; arrays one at a time.

        It uses `values` as its buffer if they are of the FMU's type.

        Raises
        ------
        InputError
            If the number of `values` is not that of the variables.
        """

    @abstractmethod
    def output_slopes(self, names: Sequence[str], order: int) -> Channel:
        """Derivatives of some real outputs, from the first to an order.

        Raises
        ------
        InputError
            If the FMU does not provide derivatives.
        """

    @abstractmethod
    def input_slopes(
        self, names: Sequence[str], order: int, values: NDArray[np.float64]
    ) -> Channel:
        """Derivatives of some real inputs, from the first to an order, with `values` as buffer.

        Raises
        ------
        InputError
            If the FMU takes no derivatives.
        """

    @abstractmethod
    def enter_initialization(self, start: float, stop: float) -> None:
        """Set up the experiment and enter initialisation mode."""

    @abstractmethod
    def exit_initialization(self) -> None:
        """Leave initialisation mode."""

    @abstractmethod
    def next_end(self, time: float, end: float) -> float:
        """Where a step to `end` should end: there, or at an earlier known event."""

    @abstractmethod
    def step(self, time: float, end: float) -> float:
        """Step to `end`, or to an earlier event; returns the time reached."""

    @abstractmethod
    def meet_event(self) -> bool:
        """Handle the event at which the last step ended; returns whether there was one."""

    @property
    def order(self) -> int:
        """Highest order of its output derivatives."""
        return int(self.description.coSimulation.maxOutputDerivativeOrder or 0)

    @property
    def takes_derivatives(self) -> bool:
        """Whether it takes derivatives of its inputs."""
        return bool(self.description.coSimulation.canInterpolateInputs)

    def call(self, doing: str, function: Any, *arguments: Any, **named: Any) -> Any:
        """Call a function of fmpy's instance.

        Raises
        ------
        SimulationError
            If it reports an error, with the action and its own message.
        """
        try:
            return function(*arguments, **named)
        except Exception as error:
            # fmpy raises bare exceptions too
            raise self.failure(doing, error) from None

    def failure(self, doing: str, error: Exception) -> SimulationError:
        """The error of a failed call, with the FMU's own message if there is one."""
        self._worst = max(self._worst, getattr(error, "status", ERROR))
        return SimulationError(
            f"{self.name} could not {doing}: {self.messages.reason() or error}"
        )

    def refusal(self, doing: str, function: str, status: int) -> SimulationError:
        """The error of an FMU function whose status is worse than a warning."""
        from fmpy.fmi1 import FMICallException

        return self.failure(doing, FMICallException(function, status))

    def prepared(self, doing: str, name: str, *arguments: Any) -> Callable[[], None]:
        """A call of the FMU's function `name` with fixed ctypes arguments."""
        # a call through fmpy takes as long as the FMU itself
        function = self.fmu.dll[name]

        def call() -> None:
            status = function(*arguments)
            if status > WARNING:
                raise self.refusal(doing, name, status)

        return call

    def memory(
        self, kind: Any, size: int, values: NDArray[Any] | None
    ) -> tuple[NDArray[Any], ctypes.c_void_p]:
        """`values` if they are of the type `kind`, else new ones, and their pointer."""
        if values is not None and values.size != size:
            raise InputError(f"{self.name}: {size} values are connected to {values.size}")
        if values is None or values.dtype != kind:
            values = np.zeros(size, kind)
        # the pointer keeps the memory alive
        return values, values.ctypes.data_as(ctypes.c_void_p)

    def set(self, values: dict[str, Any]) -> None:
        """Set variables by name; enumerations also by the name of an item.

        An array takes all its values, or those of its first rows: the others stay.
        """
        for name, value in values.items():
            variable = self.variables.get(name)
            if variable is None:
                raise InputError(f"{self.name} has no variable {name}")
            if variable.type not in self.TYPES:
                raise InputError(f"{self.name}: {name} is of type {variable.type}, not supported")
            numbers = [self._number(variable, v) for v in _flat(value)]
            channel = self.channel([name])
            size = channel.values.size
            row = prod(int(d.start) for d in variable.dimensions[1:])
            if len(numbers) > size or len(numbers) % row != 0:
                raise InputError(
                    f"{self.name}: {name} takes up to {size} values in rows of {row}, got "
                    f"{len(numbers)}"
                )
            if len(numbers) < size:
                channel.read()
            channel.values[: len(numbers)] = numbers
            self._write(variable, channel)

    def _write(self, variable: Any, channel: Channel) -> None:
        channel.write()

    def _number(self, variable: Any, value: Any) -> float | int:
        if isinstance(value, str):
            items = {i.name: int(i.value) for i in getattr(variable.declaredType, "items", [])}
            if value not in items:
                allowed = ", ".join(items) or "a number"
                raise InputError(
                    f"{self.name}: {variable.name} takes {allowed}, got {value!r}"
                )
            return items[value]
        try:
            number = float(value)
        except (TypeError, ValueError):
            raise InputError(
                f"{self.name}: {variable.name} takes a number, got {value!r}"
            ) from None
        if self.TYPES[variable.type] is float:
            return number
        if number != int(number):
            raise InputError(f"{self.name}: {variable.name} takes an integer, got {value!r}")
        return int(number)

    def kind(self, name: str) -> type:
        """Type of a variable's values: float, int or bool."""
        return self.TYPES[self.variables[name].type]

    def outputs(self) -> list[str]:
        """Names of the scalar outputs, real ones first."""
        order = (float, int, bool)
        found = [
            v for v in self.variables.values()
            if v.causality == "output" and v.type in self.TYPES and not v.dimensions
        ]
        return [v.name for v in sorted(found, key=lambda v: order.index(self.TYPES[v.type]))]

    def observe(self, leading: Sequence[str] = ()) -> None:
        """Prepare to read all outputs, one channel per type, with `leading` ones first."""
        places = {name: i for i, name in enumerate(leading)}
        for names in alike(self.outputs(), self):
            ordered = sorted(names, key=lambda n: places.get(n, len(places)))
            self.observed.append((ordered, self.channel(ordered)))

    def read_outputs(self) -> None:
        """Read all outputs into the channels of `observed`."""
        for _, channel in self.observed:
            channel.read()

    def observed_values(self, names: Sequence[str]) -> NDArray[Any]:
        """The part of the buffers in `observed` that holds consecutive outputs."""
        own, channel = next(o for o in self.observed if names[0] in o[0])
        place = own.index(names[0])
        return channel.values[place:place + len(names)]

    def close(self) -> None:
        """Free the instance and remove the unpacked archive; safe to call in any state."""
        if self._instantiated:
            self._instantiated = False
            try:
                # before the end of initialisation and after an error only freeing is allowed,
                # after a fatal one nothing at all
                if self._initialised and self._worst < ERROR:
                    self.call("terminate", self.fmu.terminate)
            finally:
                if self._worst < FATAL:
                    self.fmu.freeInstance()
                self.messages.close()
                shutil.rmtree(self._folder, ignore_errors=True)

    def __enter__(self) -> Unit:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()


def alike(names: Sequence[str], *units: Unit) -> list[list[str]]:
    """Names in groups of equal types in every unit."""
    groups: dict[tuple[str, ...], list[str]] = {}
    for name in names:
        groups.setdefault(tuple(u.variables[name].type for u in units), []).append(name)
    return list(groups.values())


def _flat(value: Any) -> list[Any]:
    return [value] if isinstance(value, str) else list(np.ravel(np.asarray(value, dtype=object)))
