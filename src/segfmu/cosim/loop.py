"""The step loop in Python: the reference, and the engine where no C compiler was."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from segfmu.cosim.change import Due
from segfmu.cosim.schedule import Gate, Meet, Operation, Operations, Schedule, Step
from segfmu.cosim.table import Column, Table
from segfmu.cosim.unit import INSTANT, MOST_STALLS, Unit
from segfmu.errors import SimulationError

# communication points between two reports of progress
REPORT = 100

Progress = Callable[[float], None]


class Loop:
    """Performs the operations of a schedule.

    Parameters
    ----------
    units : sequence of Unit
        The first one may end steps early.
    schedule : Schedule
        Operations of the coupling.
    recorded : sequence of Column
        What a row holds.
    """

    def __init__(
        self, units: Sequence[Unit], schedule: Schedule, recorded: Sequence[Column]
    ) -> None:
        self._units, self._recorded, self._events = units, recorded, schedule.events
        self._advance, self._refresh, self._exchange, self._point = map(
            self._bound,
            (schedule.advance, schedule.refresh, schedule.exchange, schedule.point),
        )
        self._time = self._reached = self._point_time = 0.0
        self._stalls = self._row = 0
        # the time that each unit has reached
        self._lasts = [0.0] * len(units)

    def run(
        self, times: NDArray[np.float64], changes: Sequence[Due], progress: Progress
    ) -> NDArray[np.void]:
        """Rows at all times; the units have left initialisation."""
        table = Table(times, self._recorded)
        pending = deque(changes)
        points = times.tolist()
        self._time, self._stalls = points[0], 0
        self._reached, self._lasts = points[0], [points[0]] * len(self._units)
        self._row, self._point_time = 0, points[0]
        if self._change(pending):
            _perform(self._exchange)
        for i, end in enumerate(points):
            self._row, self._point_time = i, end
            if i > 0:
                self._time = points[i - 1]
            while self._time < end:
                self._step(end, pending)
            _perform(self._point)
            table.record(i)
            if i % REPORT == 0 and i > 0:
                progress(i / (times.size - 1))
        return table.rows

    def _bound(self, operations: Operations) -> list[Callable[[], Any]]:
        return [self._callable(operation) for operation in operations]

    def _callable(self, operation: Operation) -> Callable[[], Any]:
        if isinstance(operation, Step):
            unit = self._units[operation.unit]
            return lambda: self._advance_unit(operation.unit, unit)
        if isinstance(operation, Gate):
            behind = self._bound(operation.operations)
            return lambda: _perform(behind if self._is_open(operation.every) else ())
        if isinstance(operation, Meet):
            leader, calls = self._units[operation.unit], operation.calls
            return lambda: _perform(calls if leader.meet_event() else ())
        return operation

    def _advance_unit(self, place: int, unit: Unit) -> None:
        """A step to the time reached, from where the unit is; the first one may end it earlier."""
        reached = unit.step(self._lasts[place], self._reached)
        if place == 0:
            self._reached = reached
        self._lasts[place] = self._reached

    def _is_open(self, every: int) -> bool:
        return self._row % every == 0 and self._reached >= self._point_time

    def _step(self, end: float, pending: deque[Due]) -> None:
        """A step of all units towards `end`, or to an earlier event or change."""
        for place in self._events:
            end = self._earlier(place.item(), end)
        if pending:
            end = self._earlier(pending[0].time, end)
        self._reached = end
        _perform(self._advance)
        self._stalls = 0 if self._reached > self._time else self._stalls + 1
        if self._stalls > MOST_STALLS:
            raise stalled(self._units[0], self._time)
        self._time = self._reached
        self._change(pending)
        _perform(self._exchange)

    def _earlier(self, event: float, end: float) -> float:
        return event if self._time + 1e-3 * INSTANT < event < end - INSTANT else end

    def _change(self, pending: deque[Due]) -> bool:
        """Make the changes that are due; returns whether there was one."""
        made = False
        while pending and pending[0].time <= self._time + INSTANT:
            change = pending.popleft()
            self._units[change.unit].change(change.calls())
            made = True
        if made:
            _perform(self._refresh)
        return made


def stalled(unit: Unit, time: float) -> SimulationError:
    """The error of a unit that ends its steps where they began."""
    return SimulationError(
        f"{unit.name} ended more than {MOST_STALLS} steps in a row at {time:.6g} s without going on"
    )


def _perform(operations: Sequence[Callable[[], Any]]) -> None:
    for operation in operations:
        operation()
