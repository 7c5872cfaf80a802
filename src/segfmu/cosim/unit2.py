"""FMI 2.0: a unit whose inputs may have derivatives, and whose next event is one of its outputs."""

from __future__ import annotations

import ctypes
from collections.abc import Sequence
from typing import Any, ClassVar

from fmpy.fmi2 import FMU2Slave, fmi2CallbackFunctions, fmi2CallbackLoggerTYPE

from segfmu.cosim.unit import INSTANT, Channel, Unit
from segfmu.errors import InputError

# the output that tells the time of the next event, where an FMU has it
NEXT_EVENT = "plan.next_event"


class Unit2(Unit):
    """An FMU of FMI 2.0."""

    TYPES: ClassVar[dict[str, type]] = {
        "Real": float, "Integer": int, "Enumeration": int, "Boolean": bool
    }

    def _instantiate(self) -> None:
        self.fmu = FMU2Slave(
            guid=self.description.guid,
            unzipDirectory=str(self._folder),
            modelIdentifier=self.description.coSimulation.modelIdentifier,
            instanceName=self.name,
        )
        self._callbacks = fmi2CallbackFunctions()
        self._callbacks.logger = fmi2CallbackLoggerTYPE(
            lambda _environment, _instance, status, _category, message: self.hear(status, message)
        )
        self.call(
            "be instantiated", self.fmu.instantiate, callbacks=self._callbacks, loggingOn=True
        )
        named = self._leads and NEXT_EVENT in self.variables
        self._next_event = self.channel([NEXT_EVENT]) if named else None

    def channel(self, names: Sequence[str]) -> Channel:
        variables = [self.variables[n] for n in names]
        kind = variables[0].type
        group = "Integer" if kind == "Enumeration" else kind
        buffer = ((ctypes.c_double if kind == "Real" else ctypes.c_int) * len(names))()
        references = (ctypes.c_uint * len(names))(*(v.valueReference for v in variables))
        arguments = self.fmu.component, references, len(names), buffer
        read, write = (getattr(self.fmu, f"fmi2{way}{group}") for way in ("Get", "Set"))
        return Channel(buffer, lambda: read(*arguments), lambda: write(*arguments))

    def output_slopes(self, names: Sequence[str], order: int) -> Channel:
        if self.order < 1:
            raise InputError(
                f"{self.name} tells no output derivatives; use coupling sequential or parallel"
            )
        return self._slopes(names, order)

    def input_slopes(self, names: Sequence[str], order: int) -> Channel:
        if not self.takes_derivatives:
            raise InputError(
                f"{self.name} takes no input derivatives; use coupling sequential or parallel"
            )
        return self._slopes(names, order)

    def _slopes(self, names: Sequence[str], order: int) -> Channel:
        size = len(names) * order
        own = [self.variables[n].valueReference for n in names]
        buffer = (ctypes.c_double * size)()
        arguments: tuple[Any, ...] = (
            self.fmu.component, (ctypes.c_uint * size)(*own * order), size,
            (ctypes.c_int * size)(*(k for k in range(1, order + 1) for _ in own)), buffer,
        )
        return Channel(
            buffer,
            lambda: self.fmu.fmi2GetRealOutputDerivatives(*arguments),
            lambda: self.call(
                f"take input derivatives up to order {order}",
                self.fmu.fmi2SetRealInputDerivatives, *arguments,
            ),
        )

    def enter_initialization(self, start: float, stop: float) -> None:
        self.call("set up", self.fmu.setupExperiment, startTime=start, stopTime=stop)
        self.call("enter initialisation", self.fmu.enterInitializationMode)

    def exit_initialization(self) -> None:
        self.call("be initialised", self.fmu.exitInitializationMode)
        self._initialised = True

    def next_end(self, time: float, end: float) -> float:
        if self._next_event is None:
            return end
        self._next_event.read()
        event = float(self._next_event.values[0])
        return event if time + 1e-3 * INSTANT < event < end - INSTANT else end

    def step(self, time: float, end: float) -> float:
        self.call(
            f"step at {time:.6g} s", self.fmu.doStep, currentCommunicationPoint=time,
            communicationStepSize=end - time,
        )
        return end

    def meet_event(self) -> None:
        """Events are met within steps."""
