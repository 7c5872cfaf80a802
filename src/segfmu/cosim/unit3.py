"""FMI 3.0: a unit that may return early from a step at an event."""

from __future__ import annotations

import ctypes
from collections.abc import Sequence
from typing import Any, ClassVar

import numpy as np
from fmpy.fmi3 import FMU3Slave
from numpy.typing import NDArray

from segfmu.cosim.channel import Channel, named
from segfmu.cosim.messages import WARNING
from segfmu.cosim.unit import INSTANT, Unit
from segfmu.errors import InputError, SimulationError

FUNCTIONS: dict[str, tuple[str, Any]] = {
    "Float64": ("Float64", np.float64), "Int32": ("Int32", np.int32),
    "Boolean": ("Boolean", np.bool_), "Enumeration": ("Int64", np.int64),
    "UInt64": ("UInt64", np.uint64),
}


class Unit3(Unit):
    """An FMU of FMI 3.0."""

    TYPES: ClassVar[dict[str, type]] = {
        "Float64": float, "Int32": int, "Enumeration": int, "UInt64": int, "Boolean": bool
    }

    def _instantiate(self) -> None:
        self.fmu = FMU3Slave(
            guid=self.description.instantiationToken,
            unzipDirectory=str(self._folder),
            modelIdentifier=self.description.coSimulation.modelIdentifier,
            instanceName=self.name,
        )
        can = self.description.coSimulation
        early = self._leads and bool(can.mightReturnEarlyFromDoStep)
        self._has_events = early and bool(can.hasEventMode)
        self._at_event = False
        self.call(
            "be instantiated", self.fmu.instantiate, loggingOn=True,
            eventModeUsed=self._has_events, earlyReturnAllowed=early,
            logMessage=lambda _environment, *message: self.messages.hear(*message),
        )
        self._instance = ctypes.c_void_p(self.fmu.component)
        self._do_step = self.fmu.dll["fmi3DoStep"]
        self._do_step.argtypes = (
            ctypes.c_void_p, ctypes.c_double, ctypes.c_double, ctypes.c_bool,
            *[ctypes.c_void_p] * 4,
        )
        # eventHandlingNeeded, terminateSimulation, earlyReturn, lastSuccessfulTime
        self._flags, self._reached = (ctypes.c_bool * 3)(), ctypes.c_double()
        flags, reached = ctypes.addressof(self._flags), ctypes.addressof(self._reached)
        self._told = tuple(ctypes.c_void_p(p) for p in (flags, flags + 1, flags + 2, reached))

    def channel(self, names: Sequence[str], values: NDArray[Any] | None = None) -> Channel:
        variables = [self.variables[n] for n in names]
        function, kind = FUNCTIONS[variables[0].type]
        size = sum(self._elements(v) for v in variables)
        values, pointer = self.memory(kind, size, values)
        references = (ctypes.c_uint * len(names))(*(v.valueReference for v in variables))
        arguments = (
            self._instance, references, ctypes.c_size_t(len(names)), pointer, ctypes.c_size_t(size)
        )
        return Channel(
            values,
            self.prepared(f"give {named(names)}", f"fmi3Get{function}", *arguments),
            self.prepared(f"set {named(names)}", f"fmi3Set{function}", *arguments),
        )

    def _elements(self, variable: Any) -> int:
        size = 1
        for dimension in variable.dimensions or ():
            if dimension.start is not None:
                size *= int(dimension.start)
            else:
                counted = self.channel([dimension.variable.name])
                counted.read()
                size *= int(counted.values[0])
        return size

    def _write(self, variable: Any, channel: Channel) -> None:
        structural = variable.causality == "structuralParameter"
        if structural:
            self.call("be configured", self.fmu.enterConfigurationMode)
        super()._write(variable, channel)
        if structural:
            self.call("be configured", self.fmu.exitConfigurationMode)

    def output_slopes(self, names: Sequence[str], order: int) -> Channel:
        raise InputError(
            f"{self.name}: FMI 3.0 has no input derivatives; use coupling sequential or parallel"
        )

    def input_slopes(
        self, names: Sequence[str], order: int, values: NDArray[np.float64]
    ) -> Channel:
        return self.output_slopes(names, order)

    def enter_initialization(self, start: float, stop: float) -> None:
        self.call(
            "enter initialisation", self.fmu.enterInitializationMode, startTime=start,
            stopTime=stop,
        )

    def exit_initialization(self) -> None:
        self.call("be initialised", self.fmu.exitInitializationMode)
        self._initialised = True
        if self._has_events:
            self._update()

    def next_end(self, time: float, end: float) -> float:
        """Always `end`: the step itself returns at an event."""
        return end

    def step(self, time: float, end: float) -> float:
        status = self._do_step(self._instance, time, end - time, True, *self._told)
        if status > WARNING:
            raise self.refusal(f"step at {time:.6g} s", "fmi3DoStep", status)
        event, terminate, early = self._flags
        reached = self._reached.value
        if terminate:
            raise SimulationError(f"{self.name} asked to end the simulation at {reached:.6g} s")
        self._at_event = event
        return reached if early and reached < end - INSTANT else end

    def meet_event(self) -> bool:
        if not self._at_event:
            return False
        self._at_event = False
        self.call("enter event mode", self.fmu.enterEventMode)
        self._update()
        return True

    def _update(self) -> None:
        again = True
        while again:
            again, terminate = self.call("meet an event", self.fmu.updateDiscreteStates)[:2]
            if terminate:
                raise SimulationError(f"{self.name} asked to end the simulation at an event")
        self.call("enter step mode", self.fmu.enterStepMode)
