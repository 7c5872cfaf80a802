"""One FMU in a co-simulation: its archive, its instance, and buffers for its variables."""

from __future__ import annotations

import ctypes
import shutil
import tempfile
import zipfile
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from fmpy import extract, read_model_description
from fmpy.fmi2 import (
    FMU2Slave,
    fmi2CallbackFunctions,
    fmi2CallbackLoggerTYPE,
)
from numpy.typing import NDArray

from segfmu.errors import InputError, SimulationError

# fmi2Status
ERROR, FATAL = 3, 4

GROUPS = {"Real": "Real", "Integer": "Integer", "Enumeration": "Integer", "Boolean": "Boolean"}


class Channel:
    """A fixed list of variables of one type with the buffers to read or write them at once."""

    def __init__(self, fmu: Any, group: str, references: Sequence[int]) -> None:
        size = len(references)
        kind: Any = ctypes.c_double if group == "Real" else ctypes.c_int
        self._references = (ctypes.c_uint * size)(*references)
        self._buffer = (kind * size)()
        self._size = size
        self._read = getattr(fmu, f"fmi2Get{group}")
        self._write = getattr(fmu, f"fmi2Set{group}")
        self._component = fmu.component
        self.values: NDArray[Any] = np.ctypeslib.as_array(self._buffer) if size else np.zeros(0)

    def read(self) -> None:
        """Fetch the variables into `values`."""
        if self._size:
            self._read(self._component, self._references, self._size, self._buffer)

    def write(self) -> None:
        """Set the variables from `values`."""
        if self._size:
            self._write(self._component, self._references, self._size, self._buffer)


class Slopes:
    """First time derivatives of real outputs, or of real inputs, with their buffers."""

    def __init__(self, fmu: Any, references: Sequence[int]) -> None:
        size = len(references)
        orders = (ctypes.c_int * size)(*[1] * size)
        self._arguments = fmu.component, (ctypes.c_uint * size)(*references), size, orders
        self._buffer = (ctypes.c_double * size)()
        self._fmu = fmu
        self.values: NDArray[Any] = np.ctypeslib.as_array(self._buffer)

    def read(self) -> None:
        """Fetch those of outputs into `values`."""
        self._fmu.fmi2GetRealOutputDerivatives(*self._arguments, self._buffer)

    def write(self) -> None:
        """Set those of inputs from `values`."""
        self._fmu.fmi2SetRealInputDerivatives(*self._arguments, self._buffer)


class Unit:
    """An instantiated FMI 2.0 co-simulation FMU; a context manager that frees it on every path."""

    def __init__(self, path: Path) -> None:
        self.messages: list[str] = []
        self._folder = Path(tempfile.mkdtemp(prefix="segfmu_fmu_"))
        self._instantiated = self._initialised = False
        self._worst = 0
        try:
            self._load(path)
        except BaseException:
            self.close()
            raise

    def _load(self, path: Path) -> None:
        try:
            self.description = read_model_description(str(path))
            extract(str(path), unzipdir=str(self._folder))
        except (OSError, zipfile.BadZipFile) as error:
            raise InputError(f"{path}: not a readable FMU: {error}") from None
        except Exception as error:
            # fmpy raises bare exceptions for descriptions it refuses
            raise InputError(f"{path}: not a valid FMU: {str(error).splitlines()[0]}") from None
        description = self.description
        if description.fmiVersion != "2.0" or description.coSimulation is None:
            raise InputError(
                f"{path}: the master needs FMI 2.0 co-simulation, "
                f"this is FMI {description.fmiVersion}"
            )
        self.name = description.modelName
        self.variables = {v.name: v for v in description.modelVariables}
        self.fmu = FMU2Slave(
            guid=description.guid,
            unzipDirectory=str(self._folder),
            modelIdentifier=description.coSimulation.modelIdentifier,
            instanceName=description.modelName,
        )
        self._callbacks = fmi2CallbackFunctions()
        self._callbacks.logger = fmi2CallbackLoggerTYPE(self._log)
        self._call(
            "be instantiated", self.fmu.instantiate, callbacks=self._callbacks, loggingOn=True
        )
        self._instantiated = True

    def _log(
        self, _environment: Any, _instance: bytes, status: int, _category: bytes, message: bytes
    ) -> None:
        if status > 0 and message:
            self.messages.append(message.decode("utf-8", "replace").strip())

    def _call(self, doing: str, function: Any, *arguments: Any, **named: Any) -> None:
        try:
            function(*arguments, **named)
        except Exception as error:
            # fmpy raises bare exceptions beside its own
            self._worst = max(self._worst, getattr(error, "status", ERROR))
            name = getattr(self, "name", "FMU")
            told = self.messages[0].splitlines()[-1] if self.messages else str(error)
            raise SimulationError(f"{name} could not {doing}: {told}") from None

    def set(self, values: dict[str, Any]) -> None:
        """Set variables by name; enumerations also by the name of an item."""
        for name, value in values.items():
            variable = self.variables.get(name)
            if variable is None:
                raise InputError(f"{self.name} has no variable {name}")
            group = GROUPS.get(variable.type)
            if group is None:
                raise InputError(f"{self.name}: {name} is of type {variable.type}, not supported")
            channel = self.channel([name])[group]
            channel.values[0] = self._number(variable, value)
            self._call(f"set {name}", channel.write)

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
        if variable.type == "Real":
            return number
        if number != int(number):
            raise InputError(f"{self.name}: {variable.name} takes an integer, got {value!r}")
        return int(number)

    def channel(self, names: Sequence[str]) -> dict[str, Channel]:
        """Channels for some variables, by type group; names keep their order within a group."""
        grouped: dict[str, list[int]] = {}
        for name in names:
            variable = self.variables[name]
            grouped.setdefault(GROUPS[variable.type], []).append(variable.valueReference)
        return {g: Channel(self.fmu, g, references) for g, references in grouped.items()}

    def output_slopes(self, names: Sequence[str]) -> Slopes:
        """First derivatives of the real ones among some outputs.

        Raises
        ------
        InputError
            When the FMU does not tell derivatives.
        """
        if int(self.description.coSimulation.maxOutputDerivativeOrder or 0) < 1:
            raise InputError(
                f"{self.name} tells no output derivatives; use coupling sequential or parallel"
            )
        return self._slopes(names)

    def input_slopes(self, names: Sequence[str]) -> Slopes:
        """First derivatives of the real ones among some inputs.

        Raises
        ------
        InputError
            When the FMU takes no derivatives.
        """
        if not self.description.coSimulation.canInterpolateInputs:
            raise InputError(
                f"{self.name} takes no input derivatives; use coupling sequential or parallel"
            )
        return self._slopes(names)

    def _slopes(self, names: Sequence[str]) -> Slopes:
        reals = [n for n in names if self.variables[n].type == "Real"]
        return Slopes(self.fmu, [self.variables[n].valueReference for n in reals])

    def outputs(self) -> list[str]:
        """Names of the outputs, real ones first, as the channels group them."""
        names = [v.name for v in self.description.modelVariables if v.causality == "output"]
        order = ("Real", "Integer", "Boolean")
        return sorted(
            (n for n in names if self.variables[n].type in GROUPS),
            key=lambda n: order.index(GROUPS[self.variables[n].type]),
        )

    def enter_initialization(self, start: float, stop: float) -> None:
        """Set up the experiment and enter initialisation mode."""
        self._call("set up", self.fmu.setupExperiment, startTime=start, stopTime=stop)
        self._call("enter initialisation", self.fmu.enterInitializationMode)

    def exit_initialization(self) -> None:
        """Leave initialisation mode."""
        self._call("be initialised", self.fmu.exitInitializationMode)
        self._initialised = True

    def step(self, time: float, step: float) -> None:
        """One communication step."""
        self._call(
            f"step at {time:.6g} s", self.fmu.doStep, currentCommunicationPoint=time,
            communicationStepSize=step,
        )

    def close(self) -> None:
        """Free the instance and remove the unpacked archive; safe to call in any state."""
        if self._instantiated:
            self._instantiated = False
            # before the end of initialisation and after an error only freeing is allowed, after a
            # fatal one nothing at all
            if self._initialised and self._worst < ERROR:
                self._call("terminate", self.fmu.terminate)
            if self._worst < FATAL:
                self.fmu.freeInstance()
        shutil.rmtree(self._folder, ignore_errors=True)

    def __enter__(self) -> Unit:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()


