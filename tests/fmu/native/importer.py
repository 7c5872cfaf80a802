"""A small importer on fmpy's bindings: both versions of FMI, both interfaces, by names."""

from __future__ import annotations

import atexit
import ctypes
import shutil
import tempfile
from functools import lru_cache
from pathlib import Path
from typing import Any

import numpy as np
from fmpy import extract, read_model_description
from fmpy.fmi2 import FMU2Model, FMU2Slave, fmi2CallbackFunctions, fmi2CallbackLoggerTYPE
from fmpy.fmi3 import FMU3Model, FMU3Slave, fmi3LogMessageCallback

GROUPS = {"Float64": "Float64", "Int32": "Int32", "Boolean": "Boolean", "Enumeration": "Int64"}
# each archive once: nothing changes what was read
described = lru_cache(lambda path, changed: read_model_description(path))


@lru_cache(maxsize=32)
def unpacked(path: Path, changed: int) -> Path:
    """What runs of an archive, without sources and pages; until this process ends."""
    folder = Path(tempfile.mkdtemp())
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    extract(
        str(path), unzipdir=str(folder), include=lambda n: not n.startswith(("sources", "docum"))
    )
    return folder


class Importer:
    """One instance; a context manager that frees it."""

    def __init__(self, path: Path, kind: str = "CoSimulation", **options: Any) -> None:
        changed = path.stat().st_mtime_ns
        self.folder = unpacked(path, changed)
        self.description = described(str(path), changed)
        self.variables = {v.name: v for v in self.description.modelVariables}
        self.three = self.description.fmiVersion.startswith("3")
        self.messages: list[str] = []
        # status and category of every message
        self.categories: list[tuple[int, str]] = []
        self.kind = kind
        exchange = kind == "ModelExchange"
        kinds = (FMU3Slave, FMU3Model) if self.three else (FMU2Slave, FMU2Model)
        self.fmu = kinds[exchange](
            guid=self.description.guid, unzipDirectory=str(self.folder),
            modelIdentifier=self.description.modelName, instanceName="one",
        )
        self._options = options
        self.instantiate()

    def instantiate(self) -> None:
        """Make the instance; the one before must have been freed."""
        if self.three:
            self._log = fmi3LogMessageCallback(lambda _, s, c, m: self._hear(m, s, c))
            self.fmu.instantiate(logMessage=self._log, loggingOn=True, **self._options)
        else:
            callbacks = fmi2CallbackFunctions()
            self._log = fmi2CallbackLoggerTYPE(lambda _, n, s, c, m: self._hear(m, s, c))
            callbacks.logger = self._log
            self.fmu.instantiate(callbacks=callbacks, loggingOn=True)

    def _hear(self, message: bytes, status: int, category: bytes | None) -> None:
        self.messages.append(message.decode())
        self.categories.append((status, (category or b"").decode()))

    def __enter__(self) -> Importer:
        return self

    def __exit__(self, *_: object) -> None:
        self.fmu.freeInstance()

    def set(self, values: dict[str, Any]) -> None:
        """Set variables; enumerations by item; sizes in configuration mode."""
        for name, value in values.items():
            variable = self.variables[name]
            if isinstance(value, str):
                value = [i.name for i in variable.declaredType.items].index(value) + 1
            flat = np.ravel(value).tolist()
            if variable.type == "Boolean":
                flat = [bool(v) for v in flat]
            reference = [variable.valueReference]
            if not self.three:
                group = "Integer" if variable.type == "Enumeration" else variable.type
                getattr(self.fmu, f"set{group}")(reference, flat)
            elif variable.dimensions:
                self._set_array(variable, flat)
            else:
                getattr(self.fmu, f"set{GROUPS[variable.type]}")(reference, flat)

    def _set_array(self, variable: Any, flat: list[Any]) -> None:
        """Its first values; the others stay."""
        size = int(np.prod([int(d.start) for d in variable.dimensions]))
        reference, group = [variable.valueReference], GROUPS[variable.type]
        values = getattr(self.fmu, f"get{group}")(reference, nValues=size)
        getattr(self.fmu, f"set{group}")(reference, [*flat, *values[len(flat):]])

    def set_waypoints(self, table: dict[str, np.ndarray]) -> None:
        """Waypoints as arrays of rows: position, velocity, acceleration, dwell."""
        count = len(table["position"])
        self.set({"waypoint.count": count})
        for name, rows in table.items():
            if self.three:
                self.set({f"waypoint.{name}": rows})
            elif name == "dwell":
                self.set({f"waypoint[{i}].dwell": r for i, r in enumerate(rows, 1)})
            else:
                self.set({
                    f"waypoint[{i}].{name}.{a}": x
                    for i, row in enumerate(rows, 1) for a, x in zip("xyz", row, strict=True)
                })

    def get(self, *names: str) -> np.ndarray:
        """Values of real variables."""
        references = [self.variables[n].valueReference for n in names]
        read = self.fmu.getFloat64 if self.three else self.fmu.getReal
        return np.array(read(references))

    def write(self, names: tuple[str, ...], values: np.ndarray) -> None:
        """Set real variables, fast."""
        references = [self.variables[n].valueReference for n in names]
        (self.fmu.setFloat64 if self.three else self.fmu.setReal)(references, list(values))

    def begin(self, start: float = 0.0, stop: float | None = None) -> None:
        """Initialisation mode."""
        if self.three:
            self.fmu.enterInitializationMode(startTime=start, stopTime=stop)
        else:
            self.fmu.setupExperiment(startTime=start, stopTime=stop)
            self.fmu.enterInitializationMode()

    def initialise(self, start: float = 0.0, stop: float | None = None) -> None:
        """Everything up to the first step or the continuous-time mode."""
        self.begin(start, stop)
        self.fmu.exitInitializationMode()
        if self.kind == "ModelExchange":
            self.event()

    def step(self, time: float, step: float) -> None:
        """One communication step."""
        self.fmu.doStep(currentCommunicationPoint=time, communicationStepSize=step)

    def event(self) -> float:
        """Meet an event and go on in continuous time; returns when the next event is."""
        update = self.fmu.updateDiscreteStates if self.three else self.fmu.newDiscreteStates
        found = update()
        self.fmu.enterContinuousTimeMode()
        return float(found[-1]) if found[-2] else np.inf

    def states_moved(self) -> bool:
        """Whether the continuous states have other values after an event, which this meets."""
        update = self.fmu.updateDiscreteStates if self.three else self.fmu.newDiscreteStates
        return bool(update()[3])

    @property
    def states(self) -> int:
        """Number of continuous states."""
        return int(self.description.numberOfContinuousStates)

    def derivatives(self, time: float, state: np.ndarray) -> np.ndarray:
        """Of the continuous states, in continuous-time mode."""
        found = (ctypes.c_double * self.states)()
        self.fmu.setTime(time)
        self.fmu.setContinuousStates((ctypes.c_double * self.states)(*state), self.states)
        read = self.fmu.getContinuousStateDerivatives if self.three else self.fmu.getDerivatives
        read(found, self.states)
        return np.array(found)

    def state(self) -> np.ndarray:
        """The continuous states."""
        found = (ctypes.c_double * self.states)()
        self.fmu.getContinuousStates(found, self.states)
        return np.array(found)
