"""One FMU in a co-simulation: its archive, its instance, and buffers for its variables."""

from __future__ import annotations

import shutil
from abc import ABC, abstractmethod
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from segfmu.errors import InputError, SimulationError

# fmi2Status, fmi3Status
ERROR, FATAL = 3, 4

# s; times that differ by less are the same
INSTANT = 1e-9


class Channel:
    """A fixed list of variables of one type with the buffer to read or write them at once.

    Parameters
    ----------
    buffer : ctypes array
        Of the variables' type.
    read, write : callable
        Fetch the variables into the buffer, and set them from it.
    """

    def __init__(self, buffer: Any, read: Callable[[], Any], write: Callable[[], Any]) -> None:
        self.values: NDArray[Any] = np.ctypeslib.as_array(buffer)
        self.read = read
        self.write = write


class Unit(ABC):
    """An instantiated co-simulation FMU; a context manager that frees it on every path.

    Parameters
    ----------
    folder : Path
        The unpacked archive, removed at the end.
    description
        Its model description, as fmpy reads it.
    leads : bool
        Whether steps may end at its events.
    """

    # types of the standard -> what values are in Python and in a result
    TYPES: ClassVar[dict[str, type]]
    # functions of fmpy's instance that end a simulation and free it
    fmu: Any

    def __init__(self, folder: Path, description: Any, leads: bool) -> None:
        self.messages: list[str] = []
        self.description = description
        self.name = description.modelName
        self.variables = {v.name: v for v in description.modelVariables}
        self._folder, self._leads = folder, leads
        self._instantiated = self._initialised = False
        self._worst = 0
        self._instantiate()
        self._instantiated = True

    @abstractmethod
    def _instantiate(self) -> None:
        """Make the instance."""

    @abstractmethod
    def channel(self, names: Sequence[str]) -> Channel:
        """A channel for some variables of one type, at least one; arrays one at a time."""

    @abstractmethod
    def output_slopes(self, names: Sequence[str], order: int) -> Channel:
        """Derivatives of some real outputs, from the first to an order.

        Raises
        ------
        InputError
            When the FMU does not tell derivatives.
        """

    @abstractmethod
    def input_slopes(self, names: Sequence[str], order: int) -> Channel:
        """Derivatives of some real inputs, from the first to an order.

        Raises
        ------
        InputError
            When the FMU takes no derivatives.
        """

    @abstractmethod
    def enter_initialization(self, start: float, stop: float) -> None:
        """Set up the experiment and enter initialisation mode."""

    @abstractmethod
    def exit_initialization(self) -> None:
        """Leave initialisation mode."""

    @abstractmethod
    def next_end(self, time: float, end: float) -> float:
        """Where a step to `end` should end: there, or at an event before that is known of."""

    @abstractmethod
    def step(self, time: float, end: float) -> float:
        """Step to `end`, or to an event before; returns the time reached."""

    @abstractmethod
    def meet_event(self) -> None:
        """Handle the event at which the last step ended, if it did."""

    @property
    def order(self) -> int:
        """Highest order of the derivatives that it tells of its outputs."""
        return int(self.description.coSimulation.maxOutputDerivativeOrder or 0)

    @property
    def takes_derivatives(self) -> bool:
        """Whether it takes derivatives of its inputs."""
        return bool(self.description.coSimulation.canInterpolateInputs)

    def hear(self, status: int, message: bytes | None) -> None:
        """Keep a message of the FMU."""
        if status > 0 and message:
            self.messages.append(message.decode("utf-8", "replace").strip())

    def call(self, doing: str, function: Any, *arguments: Any, **named: Any) -> Any:
        """Call the FMU.

        Raises
        ------
        SimulationError
            With what it was doing and its own message, when it reports an error.
        """
        try:
            return function(*arguments, **named)
        except Exception as error:
            # fmpy raises bare exceptions beside its own
            self._worst = max(self._worst, getattr(error, "status", ERROR))
            told = self.messages[0].splitlines()[-1] if self.messages else str(error)
            raise SimulationError(f"{self.name} could not {doing}: {told}") from None

    def set(self, values: dict[str, Any]) -> None:
        """Set variables by name; enumerations also by the name of an item, arrays by their values.
        """
        for name, value in values.items():
            variable = self.variables.get(name)
            if variable is None:
                raise InputError(f"{self.name} has no variable {name}")
            if variable.type not in self.TYPES:
                raise InputError(f"{self.name}: {name} is of type {variable.type}, not supported")
            numbers = [self._number(variable, v) for v in _flat(value)]
            channel = self.channel([name])
            if channel.values.size != len(numbers):
                raise InputError(
                    f"{self.name}: {name} takes {channel.values.size} values, got {len(numbers)}"
                )
            channel.values[:] = numbers
            self._write(variable, channel)

    def _write(self, variable: Any, channel: Channel) -> None:
        self.call(f"set {variable.name}", channel.write)

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
        """What a variable's values are: float, int or bool."""
        return self.TYPES[self.variables[name].type]

    def outputs(self) -> list[str]:
        """Names of the outputs that are no arrays, real ones first."""
        order = (float, int, bool)
        found = [
            v for v in self.variables.values()
            if v.causality == "output" and v.type in self.TYPES and not v.dimensions
        ]
        return [v.name for v in sorted(found, key=lambda v: order.index(self.TYPES[v.type]))]

    def close(self) -> None:
        """Free the instance and remove the unpacked archive; safe to call in any state."""
        if self._instantiated:
            self._instantiated = False
            # before the end of initialisation and after an error only freeing is allowed, after a
            # fatal one nothing at all
            if self._initialised and self._worst < ERROR:
                self.call("terminate", self.fmu.terminate)
            if self._worst < FATAL:
                self.fmu.freeInstance()
        shutil.rmtree(self._folder, ignore_errors=True)

    def __enter__(self) -> Unit:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()


def _flat(value: Any) -> list[Any]:
    return [value] if isinstance(value, str) else list(np.ravel(np.asarray(value, dtype=object)))
