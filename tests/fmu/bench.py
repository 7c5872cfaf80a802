"""Short runs of one FMU, many times over: every run has an instance of its own."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np

from segfmu.errors import SegfmuError
from segfmu.fmu.python.slave import SpecSlave
from segfmu.fmu.standard.spec import Spec
from tests.fmu.native.importer import GROUPS, Importer

Values = dict[str, Any]
Inputs = Callable[[float], Values]
# name -> values at the start and after every step
Rows = dict[str, list[float]]
Ends = Callable[[Rows], bool]


class Bench:
    """Runs of one archive for co-simulation."""

    def __init__(self, importer: Importer, spec: Spec, names: list[str]) -> None:
        self._importer = importer
        self._spec = spec
        self._groups: dict[str, list[str]] = {}
        for name in names:
            kind = importer.variables[name].type
            self._groups.setdefault(GROUPS[kind] if importer.three else kind, []).append(name)

    @property
    def messages(self) -> list[str]:
        """What the instances have said so far."""
        return self._importer.messages

    def run(
        self, values: Values, inputs: Inputs, times: np.ndarray, ends: Ends = lambda rows: False
    ) -> Rows | None:
        """The chosen variables from times[0] to times[-1]; None where the FMU refuses.

        ends : whether the rows so far are enough.
        """
        self._renew()
        self.messages.clear()
        rows: Rows = {}
        try:
            self._importer.set(self._as_arrays(values) if self._importer.three else values)
            self._importer.set(inputs(float(times[0])))
            self._importer.initialise(start=float(times[0]))
            self._read(rows)
            for before, after in pairwise(times):
                if ends(rows):
                    break
                self._importer.set(inputs(float(before)))
                self._importer.step(float(before), float(after - before))
                self._read(rows)
        except Exception:
            # fmpy raises bare exceptions beside its own; every error of the FMU has a message
            if not self.messages:
                raise
            return None
        return rows

    def _as_arrays(self, values: Values) -> Values:
        """With whole arrays in place of their members."""
        starts = {v.name: v.start for v in self._spec.variables} | values
        members = {m for array in self._spec.arrays for m in array.members}
        found = {n: v for n, v in values.items() if n not in members}
        for array in self._spec.arrays:
            if not values.keys().isdisjoint({array.rows, *array.members}):
                found[array.name] = [starts[m] for m in array.members]
        return found

    def _renew(self) -> None:
        fmu = self._importer.fmu
        free = fmu.fmi3FreeInstance if self._importer.three else fmu.fmi2FreeInstance
        free(fmu.component)
        self._importer.instantiate()

    def _read(self, rows: Rows) -> None:
        fmu, variables = self._importer.fmu, self._importer.variables
        for kind, names in self._groups.items():
            found = getattr(fmu, f"get{kind}")([variables[n].valueReference for n in names])
            for name, value in zip(names, found, strict=True):
                rows.setdefault(name, []).append(float(value))


class SlaveBench:
    """The same of a slave of the Python backend, without its archive."""

    def __init__(self, slave: type[SpecSlave], names: list[str]) -> None:
        self._slave = slave
        self._names = names
        self.messages: list[str] = []

    def run(
        self, values: Values, inputs: Inputs, times: np.ndarray, ends: Ends = lambda rows: False
    ) -> Rows | None:
        """As `Bench.run`."""
        slave = self._slave(instance_name="one")
        rows: Rows = {name: [] for name in self._names}
        try:
            self._set(slave, values | inputs(float(times[0])))
            slave.setup_experiment(float(times[0]), None, None)
            slave.enter_initialization_mode()
            slave.exit_initialization_mode()
            self._read(slave, rows)
            for before, after in pairwise(times):
                if ends(rows):
                    break
                self._set(slave, inputs(float(before)))
                slave.advance(float(before), float(after - before))
                self._read(slave, rows)
        except SegfmuError as error:
            self.messages.append(str(error))
            return None
        return rows

    def _set(self, slave: SpecSlave, values: Values) -> None:
        spec = slave.spec
        for name, value in values.items():
            enumeration = spec.variable(name).enumeration
            if enumeration is not None and isinstance(value, str):
                value = enumeration.items.index(value) + 1
            slave.assign((name,), (value,))

    def _read(self, slave: SpecSlave, rows: Rows) -> None:
        for name in self._names:
            rows[name].append(float(slave.value(name)))


@contextmanager
def bench(path: Path, spec: Spec, names: list[str]) -> Iterator[Bench]:
    """A bench on which runs tell the variables of these names."""
    with Importer(path) as importer:
        yield Bench(importer, spec, names)
