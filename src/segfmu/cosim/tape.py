"""Runs in which some FMUs would do what they have done before, and are left out.

An FMU without connected inputs whose outputs follow from its values and the time alone, as those of
a planner do, tells the same in every run with the same values. The second such run records what it
tells, and those behind it hear it from the tape.
"""

from __future__ import annotations

import ctypes
from collections.abc import Collection, Iterator, Mapping, Sequence
from contextlib import contextmanager
from typing import Any

import numpy as np
from numpy.typing import NDArray

from segfmu.cosim.change import Due
from segfmu.cosim.layout import RECORDS, REPEATS, UNUSED, CTape
from segfmu.cosim.unit import Unit
from segfmu.errors import SimulationError

# bytes of a step on the tape, struct told_step
STEP = 32
# steps that end at events, beside those at communication points
MOST_EVENTS = 1000


class OffTape(SimulationError):
    """A run that is not the one on the tape, which its FMUs have to make."""


class Tape:
    """What units have told in a run.

    Parameters
    ----------
    names : collection of str
        Of the units that can be left out.
    """

    def __init__(self, names: Collection[str]) -> None:
        self._names = frozenset(names)
        self._use, self._key, self._complete = UNUSED, None, False
        self._data: NDArray[np.uint8] = np.empty(0, np.uint8)
        self._size = 0
        self._first: dict[str, list[list[NDArray[Any]]]] = {}

    def has(self, unit: Unit) -> bool:
        """Whether a unit can be left out."""
        return unit.name in self._names

    def forget(self) -> None:
        """Begin anew."""
        self._use, self._key, self._complete = UNUSED, None, False

    def begin(
        self, units: Mapping[str, Unit], values: Mapping[str, Mapping[str, Any]],
        changes: Sequence[Due], span: Any,
    ) -> None:
        """Begin a run, which these units make with values, and changes of them, over a span.

        One in which those that can be left out hear the same as before needs them no more. The
        first one is only remembered, as many runs have no second one.
        """
        key = self._heard(units, values, changes, span)
        if not self._names or key is None or key != self._key:
            self.forget()
            self._key = key
        else:
            self._use = REPEATS if self._complete else RECORDS

    def _heard(
        self, units: Mapping[str, Unit], values: Mapping[str, Mapping[str, Any]],
        changes: Sequence[Due], span: Any,
    ) -> Any:
        """All that the units on the tape hear in a run; None if they hear of changes."""
        every = list(units.values())
        if any(self.has(every[change.unit]) for change in changes):
            return None
        # lists can be compared, arrays cannot
        own = {
            n: {k: np.asarray(v).tolist() for k, v in values.get(n, {}).items()}
            for n, u in units.items() if self.has(u)
        }
        return own, [change.time for change in changes], span

    def silent(self, unit: Unit) -> bool:
        """Whether a unit is left out in this run."""
        return self._use == REPEATS and self.has(unit)

    @contextmanager
    def beginning(self, units: Collection[Unit]) -> Iterator[None]:
        """Keep what units tell in their initialisation, or let them tell it again."""
        own = [u for u in units if self._use != UNUSED and self.has(u)]
        for unit in own:
            if self._use == REPEATS:
                unit.told = iter(self._first[unit.name])
            else:
                unit.heard = self._first[unit.name] = []
        try:
            yield
        finally:
            for unit in own:
                unit.told = unit.heard = None

    def lay_out(self, steps: int, each: int) -> CTape:
        """The tape for the loop: of so many steps, with so many bytes each."""
        if self._use == RECORDS and self._data.size < (steps + MOST_EVENTS) * each:
            self._data = np.empty((steps + MOST_EVENTS) * each, np.uint8)
        size = self._size if self._use == REPEATS else self._data.size
        return CTape(self._use, ctypes.c_void_p(self._data.ctypes.data), size, 0)

    def take(self, found: CTape) -> None:
        """Take what a run that came to its end has put on the tape."""
        if self._use == RECORDS and found.use == RECORDS:
            self._size, self._complete = found.place, True
