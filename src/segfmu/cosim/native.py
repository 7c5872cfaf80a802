"""The step loop in C: lays a schedule out in memory for the module _loop, and tells its errors."""

from __future__ import annotations

import ctypes
import os
from collections.abc import Sequence
from importlib import import_module
from importlib.util import find_spec
from typing import Any

import numpy as np
from numpy.typing import NDArray

from segfmu.cosim.change import Due
from segfmu.cosim.channel import Call, Copy
from segfmu.cosim.layout import (
    FORMS,
    KINDS,
    OUTCOMES,
    TYPES,
    CAssignment,
    CCall,
    CChange,
    CCopy,
    COperation,
    CSequence,
    CSimulation,
    CUnit,
)
from segfmu.cosim.loop import Progress, stalled
from segfmu.cosim.schedule import Gate, Meet, Operation, Operations, Schedule, Step
from segfmu.cosim.table import Column, row_type
from segfmu.cosim.tape import STEP, OffTape, Tape
from segfmu.cosim.unit import INSTANT, MOST_STALLS, Unit
from segfmu.errors import SimulationError

COMPILED = (
    os.environ.get("SEGFMU_INTERPRETED", "0") in ("", "0")
    and find_spec("segfmu.cosim._loop") is not None
)
# functions of events -> words of their errors
EVENTS = {
    "enter": ("enter event mode", "fmi3EnterEventMode"),
    "update": ("meet an event", "fmi3UpdateDiscreteStates"),
    "leave": ("enter step mode", "fmi3EnterStepMode"),
}
# communication points between two reports of progress, where a run can be interrupted
REPORT = 200


class NativeLoop:
    """Performs the operations of a schedule in C, without Python's lock.

    Parameters
    ----------
    units : sequence of Unit
        The first one may end steps early.
    schedule : Schedule
        Operations of the coupling.
    recorded : sequence of Column
        What a row holds.
    tape : Tape
        Of the units that can be left out.
    """

    def __init__(
        self, units: Sequence[Unit], schedule: Schedule, recorded: Sequence[Column], tape: Tape
    ) -> None:
        self._run = import_module("segfmu.cosim._loop").run
        self._units, self._type = units, row_type(recorded)
        self._calls: list[Call] = []
        self._copies: list[Copy] = []
        # what the structures point to
        self._kept: list[Any] = [schedule]
        program = CSimulation(
            instant=INSTANT, most_stalls=MOST_STALLS, row_size=self._type.itemsize,
            event_count=len(schedule.events),
        )
        self._program = program
        for name in ("advance", "refresh", "exchange", "point"):
            setattr(program, name, self._sequence(getattr(schedule, name)))
        self._fixed = [_call(c, tape) for c in self._calls]
        self._states = _packed(CUnit, [_unit(u) for u in units])
        self._lasts = np.zeros(len(units))
        self._tape = tape
        for state, unit in zip(self._states, units, strict=True):
            state.taped = tape.has(unit)
        program.lasts = self._lasts.ctypes.data
        program.units = ctypes.addressof(self._states)
        program.copies = self._array(CCopy, [_copy(c) for c in self._copies])
        fields = _columns(recorded, self._type)
        program.columns, program.column_count = self._array(CCopy, fields), len(fields)
        program.events = self._array(ctypes.c_void_p, [e.ctypes.data for e in schedule.events])

    def run(
        self, times: NDArray[np.float64], changes: Sequence[Due], progress: Progress
    ) -> NDArray[np.void]:
        """Rows at all times; the units have left initialisation."""
        rows: NDArray[np.void] = np.empty(times.size, self._type)
        program = self._program
        program.points, program.rows = times.ctypes.data, rows.ctypes.data
        program.stalls = program.next_change = 0
        self._lasts[:] = times[0]
        for state in self._states:
            state.at_event = 0
        kept = self._changes(changes)
        program.tape = self._tape.lay_out(times.size + len(changes), self._a_step())
        for i in range(0, times.size, REPORT):
            last = min(i + REPORT, times.size) - 1
            if self._run(ctypes.addressof(program), i, last):
                raise self._failure()
            if last < times.size - 1:
                progress(last / (times.size - 1))
        self._tape.take(program.tape)
        del kept
        return rows

    def _a_step(self) -> int:
        """Bytes that a step puts on the tape."""
        own: int = sum(c.taped for c in self._fixed)
        return own + len(self._units) * STEP

    def _sequence(self, operations: Operations) -> CSequence:
        items: list[COperation] = []
        for operation in operations:
            items.append(self._operation(operation))
            if isinstance(operation, Meet):
                items += map(self._operation, operation.calls)
            if isinstance(operation, Gate):
                items += map(self._operation, operation.operations)
        return CSequence(self._array(COperation, items), len(items))

    def _operation(self, operation: Operation) -> COperation:
        if isinstance(operation, Call):
            self._calls.append(operation)
            return COperation(KINDS.index("call"), len(self._calls) - 1, 0)
        if isinstance(operation, Copy):
            self._copies.append(operation)
            return COperation(KINDS.index("copy"), len(self._copies) - 1, 0)
        if isinstance(operation, Step):
            return COperation(KINDS.index("step"), operation.unit, 0)
        if isinstance(operation, Gate):
            return COperation(KINDS.index("gate"), operation.every, len(operation.operations))
        return COperation(KINDS.index("meet"), operation.unit, len(operation.calls))

    def _changes(self, changes: Sequence[Due]) -> list[Any]:
        """Lay out the changes of a run; returns what has to be kept until its end."""
        del self._calls[len(self._fixed):]
        places: dict[int, int] = {}
        sets: list[CAssignment] = []
        entries: list[CChange] = []
        for change in changes:
            entries.append(CChange(change.time, change.unit, len(sets), len(change.assignments)))
            for channel, values in change.assignments:
                place = places.setdefault(id(channel.write), len(self._calls))
                if place == len(self._calls):
                    self._calls.append(channel.write)
                start, _ = values.__array_interface__["data"]
                sets.append(CAssignment(place, start, values.nbytes))
        own = [_call(c, self._tape) for c in self._calls[len(self._fixed):]]
        kept = [_packed(CCall, [*self._fixed, *own]), _packed(CAssignment, sets),
                _packed(CChange, entries)]
        program = self._program
        program.calls, program.assignments, program.changes = map(ctypes.addressof, kept)
        program.change_count = len(entries)
        return kept

    def _array(self, kind: Any, items: Sequence[Any]) -> int:
        self._kept.append(_packed(kind, items))
        return ctypes.addressof(self._kept[-1])

    def _failure(self) -> SimulationError:
        """The error that loop.py raises at the same place."""
        program = self._program
        outcome = OUTCOMES[program.outcome]
        if outcome == "off tape":
            return OffTape("a run is not the one on the tape")
        if outcome == "call":
            call: Call = self._calls[program.item]
            return call.unit.refusal(call.doing, call.function, program.status)
        unit: Unit = self._units[program.item]
        if outcome == "step":
            return unit.refused_step(float(self._lasts[program.item]), program.status)
        if outcome in EVENTS:
            return unit.refusal(*EVENTS[outcome], program.status)
        if outcome == "stalled":
            return stalled(unit, program.time)
        if outcome == "event stalled":
            return unit.restless()
        return unit.ended(program.reached if outcome == "step ended" else None)


def _packed(kind: Any, items: Sequence[Any]) -> Any:
    return (kind * len(items))(*items)


def _word(argument: Any) -> int:
    if isinstance(argument, ctypes.Array):
        return ctypes.addressof(argument)
    return int(argument.value or 0)


def _entry(function: Any) -> int:
    return int(ctypes.cast(function, ctypes.c_void_p).value or 0)


def _call(call: Call, tape: Tape) -> CCall:
    instance, references, count, *rest = map(_word, call.arguments)
    form = "slopes" if "Derivatives" in call.function else f"access{call.function[3]}"
    found = CCall(
        FORMS.index(form), _entry(call.entry), instance, references, count
    )
    if form == "slopes":
        found.orders, found.values = rest
    else:
        found.values, found.size = (*rest, 0)[:2]
    found.taped = call.values.nbytes if tape.has(call.unit) else 0
    return found


def _copy(copy: Copy) -> CCopy:
    index = None if copy.index is None else copy.index.ctypes.data
    return CCopy(
        TYPES[copy.source.dtype], TYPES[copy.target.dtype], copy.target.size,
        copy.source.ctypes.data, index, copy.target.ctypes.data, 0,
    )


def _columns(recorded: Sequence[Column], rows: np.dtype[np.void]) -> list[CCopy]:
    """Copies to a row, of all values at once that follow each other in their buffer."""
    found: list[CCopy] = []
    before: Column | None = None
    for column in recorded:
        follows = (
            before is not None and before.values is column.values and before.kind == column.kind
            and before.place + 1 == column.place
        )
        if follows:
            found[-1].count += 1
        else:
            place = column.values.ctypes.data + column.place * column.values.itemsize
            assert rows.fields is not None
            found.append(CCopy(
                TYPES[column.values.dtype], TYPES[np.dtype(column.kind)], 1, place, None, None,
                rows.fields[column.field][1],
            ))
        before = column
    return found


def _unit(unit: Unit) -> CUnit:
    return CUnit(unit.version, unit.instance, *map(_entry, unit.entries), unit.has_events, 0, 0)
