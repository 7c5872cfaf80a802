"""FMI 3.0: a unit that may return early from a step at an event."""

from __future__ import annotations

import ctypes
from collections.abc import Iterable, Sequence
from typing import Any, ClassVar

import numpy as np
from fmpy.fmi3 import FMU3Slave
from numpy.typing import NDArray

from segfmu.cosim.channel import Call, Channel, address, named
from segfmu.cosim.messages import WARNING
from segfmu.cosim.unit import INSTANT, MOST_STALLS, Unit
from segfmu.errors import InputError

INTEGERS = {f"{sign}{bits}": np.dtype(f"{sign.lower()}{bits}")
            for sign in ("Int", "UInt") for bits in (8, 16, 32, 64)}
# type -> type in the names of functions, and that of their buffers
FUNCTIONS: dict[str, tuple[str, Any]] = {
    "Float64": ("Float64", np.float64), "Float32": ("Float32", np.float32),
    **{name: (name, kind) for name, kind in INTEGERS.items()},
    "Boolean": ("Boolean", np.bool_), "Enumeration": ("Int64", np.int64),
    "String": ("String", np.uintp),
}


class Unit3(Unit):
    """An FMU of FMI 3.0."""

    version = 3
    TYPES: ClassVar[dict[str, type]] = {
        "Float64": float, "Float32": float, **dict.fromkeys(INTEGERS, int), "Enumeration": int,
        "Boolean": bool, "String": str,
    }
    COLUMNS: ClassVar[dict[str, Any]] = {
        "Float64": np.float64, "Float32": np.float64, **INTEGERS, "Enumeration": np.int32,
        "Boolean": np.bool_,
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
        self.has_events = early and bool(can.hasEventMode)
        self._at_event = False
        self.call(
            "be instantiated", self.fmu.instantiate, loggingOn=True,
            eventModeUsed=self.has_events, earlyReturnAllowed=early,
            logMessage=lambda _environment, *message: self.messages.hear(*message),
        )
        self.instance = ctypes.c_void_p(self.fmu.component)
        self._do_step = self.fmu.dll["fmi3DoStep"]
        self._do_step.argtypes = (
            ctypes.c_void_p, ctypes.c_double, ctypes.c_double, ctypes.c_bool,
            *[ctypes.c_void_p] * 4,
        )
        # eventHandlingNeeded, terminateSimulation, earlyReturn, lastSuccessfulTime
        self._flags, self._reached = (ctypes.c_bool * 3)(), ctypes.c_double()
        flags, reached = ctypes.addressof(self._flags), ctypes.addressof(self._reached)
        self._told = tuple(ctypes.c_void_p(p) for p in (flags, flags + 1, flags + 2, reached))

    def channel(self, names: Sequence[str]) -> Channel:
        variables = [self.variables[n] for n in names]
        function, kind = FUNCTIONS[variables[0].type]
        size = sum(self._elements(v) for v in variables)
        values = np.zeros(size, kind)
        references = (ctypes.c_uint * len(names))(*(v.valueReference for v in variables))
        arguments = (
            self.instance, references, ctypes.c_size_t(len(names)), address(values),
            ctypes.c_size_t(size),
        )
        return Channel(
            values,
            self.prepared(f"give {named(names)}", f"fmi3Get{function}", values, *arguments),
            self.prepared(f"set {named(names)}", f"fmi3Set{function}", values, *arguments),
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
        self._used, self._at_event = True, False
        self.call(
            "enter initialisation", self.fmu.enterInitializationMode, startTime=start,
            stopTime=stop,
        )

    def exit_initialization(self) -> None:
        self.call("be initialised", self.fmu.exitInitializationMode)
        self._initialised = True
        if self.has_events:
            self._update()

    @property
    def entries(self) -> tuple[Any, ...]:
        names = ("fmi3EnterEventMode", "fmi3UpdateDiscreteStates", "fmi3EnterStepMode")
        return self._do_step, *(self.fmu.dll[name] if self.has_events else None for name in names)

    def next_event(self) -> NDArray[np.float64] | None:
        """None: the step itself returns at an event."""
        return None

    def step(self, time: float, end: float) -> float:
        status = self._do_step(self.instance, time, end - time, True, *self._told)
        if status > WARNING:
            raise self.refused_step(time, status)
        event, terminate, early = self._flags
        reached = self._reached.value
        if terminate:
            raise self.ended(reached)
        self._at_event = event and self.has_events
        return reached if early and reached < end - INSTANT else end

    def meet_event(self) -> bool:
        if not self._at_event:
            return False
        self._at_event = False
        self.change(())
        return True

    def change(self, calls: Iterable[Call]) -> None:
        if self.has_events:
            self.call("enter event mode", self.fmu.enterEventMode)
        for call in calls:
            call()
        if self.has_events:
            self._update()

    def _update(self) -> None:
        again, rounds = True, 0
        while again:
            if rounds > MOST_STALLS:
                raise self.restless()
            rounds += 1
            again, terminate = self.call("meet an event", self.fmu.updateDiscreteStates)[:2]
            if terminate:
                raise self.ended()
        self.call("enter step mode", self.fmu.enterStepMode)
