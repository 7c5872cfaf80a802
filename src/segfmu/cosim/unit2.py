"""FMI 2.0: a unit with input derivatives and an output for the time of its next event."""

from __future__ import annotations

import ctypes
from collections.abc import Iterable, Sequence
from typing import Any, ClassVar

import numpy as np
from fmpy.fmi2 import (
    FMU2Slave,
    defaultCallbacks,
    fmi2CallbackFunctions,
    fmi2CallbackLoggerTYPE,
    fmi2True,
)
from numpy.typing import NDArray

from segfmu.cosim.channel import Call, Channel, address, named
from segfmu.cosim.messages import WARNING
from segfmu.cosim.unit import NEXT_EVENT, Unit
from segfmu.errors import InputError


class Unit2(Unit):
    """An FMU of FMI 2.0."""

    version = 2
    has_events = False
    TYPES: ClassVar[dict[str, type]] = {
        "Real": float, "Integer": int, "Enumeration": int, "Boolean": bool, "String": str
    }
    COLUMNS: ClassVar[dict[str, Any]] = {
        "Real": np.float64, "Integer": np.int32, "Enumeration": np.int32, "Boolean": np.bool_
    }
    # types of the buffers of the functions, by the type in their names
    BUFFERS: ClassVar[dict[str, Any]] = {
        "Real": np.float64, "Integer": np.intc, "Boolean": np.intc, "String": np.uintp
    }

    def _instantiate(self) -> None:
        self.fmu = FMU2Slave(
            guid=self.description.guid,
            unzipDirectory=str(self._folder),
            modelIdentifier=self.description.coSimulation.modelIdentifier,
            instanceName=self.name,
        )
        self._callbacks = fmi2CallbackFunctions(
            fmi2CallbackLoggerTYPE(self._hear), defaultCallbacks.allocateMemory,
            defaultCallbacks.freeMemory,
        )
        self.call(
            "be instantiated", self.fmu.instantiate, callbacks=self._callbacks, loggingOn=True
        )
        self.instance = ctypes.c_void_p(self.fmu.component)
        self._do_step = self.fmu.dll["fmi2DoStep"]
        self._do_step.argtypes = ctypes.c_void_p, ctypes.c_double, ctypes.c_double, ctypes.c_int

    def _hear(
        self, _environment: int, _instance: bytes, status: int, category: bytes, message: bytes
    ) -> None:
        # it is a format of printf, whose other arguments Python does not get
        self.messages.hear(status, category, message and message.replace(b"%%", b"%"))

    def channel(self, names: Sequence[str]) -> Channel:
        kind = self.variables[names[0]].type
        group = "Integer" if kind == "Enumeration" else kind
        values = np.zeros(len(names), self.BUFFERS[group])
        arguments = (
            self.instance, self._references(names), ctypes.c_size_t(len(names)), address(values)
        )
        return Channel(
            values,
            self.prepared(f"give {named(names)}", f"fmi2Get{group}", values, *arguments),
            self.prepared(f"set {named(names)}", f"fmi2Set{group}", values, *arguments),
        )

    @property
    def entries(self) -> tuple[Any, ...]:
        return self._do_step, None, None, None

    def next_event(self) -> NDArray[np.float64] | None:
        observed = any(NEXT_EVENT in names for names, _ in self.observed)
        if not observed or self.kind(NEXT_EVENT) is not float:
            return None
        values, place = self.place(NEXT_EVENT)
        return values[place:place + 1]

    def output_slopes(self, names: Sequence[str], order: int) -> Channel:
        if self.order < 1:
            raise InputError(
                f"{self.name} tells no output derivatives; use coupling sequential or parallel"
            )
        return self._slopes(names, order)

    def input_slopes(
        self, names: Sequence[str], order: int, values: NDArray[np.float64]
    ) -> Channel:
        if not self.takes_derivatives:
            raise InputError(
                f"{self.name} takes no input derivatives; use coupling sequential or parallel"
            )
        return self._slopes(names, order, values)

    def _slopes(
        self, names: Sequence[str], order: int, values: NDArray[np.float64] | None = None
    ) -> Channel:
        size = len(names) * order
        if values is None:
            values = np.zeros(size)
        orders = (ctypes.c_int * size)(*(k for k in range(1, order + 1) for _ in names))
        arguments = (
            self.instance, self._references([*names] * order), ctypes.c_size_t(size), orders,
            address(values),
        )
        return Channel(
            values,
            self.prepared(
                f"give output derivatives up to order {order}", "fmi2GetRealOutputDerivatives",
                values, *arguments,
            ),
            self.prepared(
                f"take input derivatives up to order {order}", "fmi2SetRealInputDerivatives",
                values, *arguments,
            ),
        )

    def _references(self, names: Sequence[str]) -> Any:
        return (ctypes.c_uint * len(names))(*(self.variables[n].valueReference for n in names))

    def enter_initialization(self, start: float, stop: float) -> None:
        self._used = True
        self.call("set up", self.fmu.setupExperiment, startTime=start, stopTime=stop)
        self.call("enter initialisation", self.fmu.enterInitializationMode)

    def exit_initialization(self) -> None:
        self.call("be initialised", self.fmu.exitInitializationMode)
        self._initialised = True

    def step(self, time: float, end: float) -> float:
        status = self._do_step(self.instance, time, end - time, fmi2True)
        if status > WARNING:
            raise self.refused_step(time, status)
        return end

    def meet_event(self) -> bool:
        """FMI 2.0 co-simulation handles events within steps."""
        return False

    def change(self, calls: Iterable[Call]) -> None:
        for call in calls:
            call()
