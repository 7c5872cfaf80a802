"""One FMU in a co-simulation: its archive, its instance, and buffers for its variables."""

from __future__ import annotations

import ctypes
import os
from abc import ABC, abstractmethod
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from threading import Lock
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from segfmu.cosim.channel import Call, Channel
from segfmu.cosim.messages import ERROR, FATAL, OK, Messages
from segfmu.cosim.values import Setter
from segfmu.errors import InputError, SegfmuError, SimulationError, first_line
from segfmu.folders import remove_folder

# s; times that differ by less are equal
INSTANT = 1e-9
# steps in a row that end where they began, or rounds of one event, before a run is ended
MOST_STALLS = 100
# output with the time of the next event, if an FMU of FMI 2.0 has it
NEXT_EVENT = "plan.next_event"
# held while a library is loaded: the working folder is the process's
LOADING = Lock()


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
    name : str, optional
        Its name in the system and in messages; by default the model's.

    Attributes
    ----------
    observed : list of (list of str, Channel)
        Names and values of the variables of `observe`, by type.
    heard : list or None
        If it is one, what `read_outputs` reads is kept in it.
    told : iterator or None
        If there is one, `read_outputs` takes what was kept from it, without the FMU.
    """

    # types of the standard -> types in Python
    TYPES: ClassVar[dict[str, type]]
    # types of the standard -> those of a result's columns
    COLUMNS: ClassVar[dict[str, Any]]
    # number of the standard's version
    version: ClassVar[int]
    # functions of fmpy's instance that end a simulation and free it
    fmu: Any
    # the instance, for functions of the library
    instance: ctypes.c_void_p
    # whether it has event mode
    has_events: bool

    def __init__(
        self, folder: Path, description: Any, leads: bool, name: str | None = None
    ) -> None:
        self.description = description
        self.name = name or description.modelName
        self.messages = Messages(self.name)
        self.variables = {v.name: v for v in description.modelVariables}
        self._folder, self._leads = folder, leads
        self._instantiated = self._initialised = self._used = False
        self._worst = OK
        self.observed: list[tuple[list[str], Channel]] = []
        self._setter = Setter(self)
        self.heard: list[list[NDArray[Any]]] | None = None
        self.told: Iterator[list[NDArray[Any]]] | None = None
        self._load()
        self._instantiated = True

    def _load(self) -> None:
        try:
            # fmpy goes to the library's folder, and stays there after an error
            with LOADING:
                try:
                    here = Path.cwd()
                except FileNotFoundError:
                    raise InputError("the working folder was removed; go to another one") from None
                try:
                    self._instantiate()
                finally:
                    os.chdir(here)
        except SegfmuError:
            raise
        except Exception as problem:
            # fmpy raises bare exceptions
            words = first_line(problem).replace(f"{self._folder}{os.sep}", "")
            raise InputError(f"{self.name} cannot be loaded: {words}") from None

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
            If the FMU does not provide derivatives.
        """

    @abstractmethod
    def input_slopes(
        self, names: Sequence[str], order: int, values: NDArray[np.float64]
    ) -> Channel:
        """Derivatives of some real inputs, from the first to an order, in the buffer `values`.

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

    @property
    @abstractmethod
    def entries(self) -> tuple[Any, ...]:
        """Functions of the library: of a step; of event mode to enter, update, leave, or None."""

    @abstractmethod
    def next_event(self) -> NDArray[np.float64] | None:
        """The place in the buffers of `observed` where its next event is read, if it tells one."""

    @abstractmethod
    def step(self, time: float, end: float) -> float:
        """Step to `end`, or to an earlier event; returns the time reached."""

    @abstractmethod
    def meet_event(self) -> bool:
        """Handle the event at which the last step ended; returns whether there was one."""

    @abstractmethod
    def change(self, calls: Iterable[Call]) -> None:
        """Set variables between two steps."""

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

    def refused_step(self, time: float, status: int) -> SimulationError:
        """The error of a step that failed."""
        return self.refusal(f"step at {time:.6g} s", f"fmi{self.version}DoStep", status)

    def ended(self, time: float | None = None) -> SimulationError:
        """The error of an FMU that asks for an end, in a step or at an event."""
        place = "an event" if time is None else f"{time:.6g} s"
        return SimulationError(f"{self.name} asked to end the simulation at {place}")

    def restless(self) -> SimulationError:
        """The error of an FMU whose event does not end."""
        return SimulationError(f"{self.name} asked for more than {MOST_STALLS} rounds of an event")

    def prepared(
        self, doing: str, name: str, values: NDArray[Any], *arguments: Any
    ) -> Call:
        """A call of the FMU's function `name` with fixed ctypes arguments, one of them `values`."""
        return Call(self, doing, name, self.fmu.dll[name], arguments, values)

    def set(self, values: Mapping[str, Any]) -> None:
        """Set variables by name; enumerations also by the name of an item.

        An array takes all its values, or those of its first rows: the others stay.

        Raises
        ------
        InputError
            For a variable that it does not have, or a value that the variable does not take.
        SimulationError
            If the FMU refuses a value.
        """
        self._used = True
        for name, value in values.items():
            channel = self._setter.fill(name, value)
            self._write(self.variables[name], channel)

    def require_within(self, values: Mapping[str, Any]) -> None:
        """Refuse values outside of the ranges that the description gives.

        Raises
        ------
        InputError
            For the first one.
        """
        self._setter.require_within(values)

    def assignments(self, values: Mapping[str, Any]) -> list[tuple[Channel, NDArray[Any]]]:
        """The channels that set variables, and what their buffers have to hold."""
        return self._setter.assignments(values)

    def _write(self, variable: Any, channel: Channel) -> None:
        channel.write()

    def kind(self, name: str) -> type:
        """Type of a variable's values: float, int or bool."""
        return self.TYPES[self.variables[name].type]

    def outputs(self) -> list[str]:
        """Names of the scalar outputs, real ones first."""
        order = (float, int, bool)
        found = [
            v for v in self.variables.values()
            if v.causality == "output" and v.type in self.COLUMNS and not v.dimensions
        ]
        return [v.name for v in sorted(found, key=lambda v: order.index(self.TYPES[v.type]))]

    def observe(self, names: Sequence[str]) -> None:
        """Prepare to read variables, one channel per type."""
        self.observed = [(group, self.channel(group)) for group in alike(names, self)]

    def read_outputs(self) -> None:
        """Read the variables of `observe` into its channels, or take them from `told`."""
        if self.told is not None:
            for (_, channel), values in zip(self.observed, next(self.told), strict=True):
                channel.values[:] = values
            return
        for _, channel in self.observed:
            channel.read()
        if self.heard is not None:
            self.heard.append([channel.values.copy() for _, channel in self.observed])

    def place(self, name: str) -> tuple[NDArray[Any], int]:
        """Buffer of a variable of `observe`, and its index there."""
        own, channel = next(o for o in self.observed if name in o[0])
        return channel.values, own.index(name)

    def reset(self) -> bool:
        """Put the instance back to where it was made; False if another one has to be made."""
        if not self._instantiated or self._worst >= FATAL:
            return False
        if self._used:
            try:
                self.call("be reset", self.fmu.reset)
            except SimulationError:
                return False
        self._used = self._initialised = False
        self._worst = OK
        self._setter.forget()
        return True

    def finish(self) -> None:
        """End a run: terminate the instance where that is allowed, and tell counts of messages."""
        ends = self._initialised and self._worst < ERROR
        self._initialised = False
        try:
            if ends:
                self.call("terminate", self.fmu.terminate)
        finally:
            self.messages.close()

    def close(self) -> None:
        """Free the instance and remove the unpacked archive; safe to call in any state."""
        if self._instantiated:
            self._instantiated = False
            try:
                # before the end of initialisation and after an error only freeing is allowed,
                # after a fatal one nothing at all
                self.finish()
            finally:
                if self._worst < FATAL:
                    self.fmu.freeInstance()
                remove_folder(self._folder)

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

