"""The unknowns of an identification in units in which all are of one size."""

from __future__ import annotations

from collections.abc import Collection, Sequence

import numpy as np

from segfmu.arrays import FloatArray
from segfmu.kernels.crane.records import Coordinates, State
from segfmu.kernels.rig.records import SIGNALS
from segfmu.validation.identification.log import Log
from segfmu.validation.identification.model import Model
from segfmu.validation.identification.quantities import SMALL, Quantity, Sizes

# of a state, in its order
COMPONENTS = [name for field in State.FIELDS.values() for name in field.variables]
# of the pendulum's time: rows from which the state at the start is guessed
GUESSED = 0.2


class Unknowns:
    """Parameters, then the state at the start of every log, as multiples of their scales.

    Attributes
    ----------
    quantities : tuple of Quantity
    logs : int
        Their number.
    low, high : ndarray, shape (unknowns,)
        Bounds; 0 is where the search begins.
    """

    def __init__(
        self, model: Model, logs: Sequence[Log], quantities: Sequence[Quantity], sizes: Sizes
    ) -> None:
        self.quantities, self.logs = tuple(quantities), len(logs)
        starts = np.concatenate([_guess(model, log, sizes) for log in logs])
        rates = sizes.length / sizes.time, SMALL / sizes.time
        unit = np.empty(State.SIZE)
        unit[State.POSITION : State.ANGLE] = SMALL * sizes.length
        unit[State.ANGLE : State.VELOCITY] = SMALL
        unit[State.VELOCITY : State.RATE] = SMALL * rates[0]
        unit[State.RATE :] = rates[1]
        self._start = np.append([q.start for q in quantities], starts)
        self._scale = np.append([q.scale for q in quantities], np.tile(unit, self.logs))
        free = np.full(starts.size, np.inf)
        low = np.append([q.low for q in quantities], -free)
        high = np.append([q.high for q in quantities], free)
        self.low, self.high = (low - self._start) / self._scale, (high - self._start) / self._scale

    @property
    def size(self) -> int:
        """Number of unknowns."""
        return int(self._start.size)

    @property
    def parameters(self) -> int:
        """Number of those that are parameters."""
        return len(self.quantities)

    def of_log(self, place: int) -> int | None:
        """The log whose start an unknown belongs to; None of a parameter, which acts on all."""
        return None if place < self.parameters else (place - self.parameters) // State.SIZE

    def values(self, point: FloatArray) -> FloatArray:
        """Values of all unknowns."""
        return self._start + self._scale * point

    def changes(self, point: FloatArray, free: Collection[int]) -> dict[str, float]:
        """Parameters of GantryCrane by name, of those that are free; others stay the file's."""
        found = self.values(point)
        return {
            q.variable: float(found[i]) for i, q in enumerate(self.quantities) if i in free
        }

    def start(self, point: FloatArray, log: int) -> FloatArray:
        """The state at the start of a log, shape (10,)."""
        first = self.parameters + log * State.SIZE
        return self.values(point)[first : first + State.SIZE]

    def taken(self, other: Unknowns, point: FloatArray, places: Sequence[int]) -> FloatArray:
        """The point with the parameters of another one, and the starts of those of its logs."""
        starts = [other.start(point, place) for place in places]
        values = np.append(other.values(point)[: self.parameters], np.concatenate(starts))
        found: FloatArray = np.clip((values - self._start) / self._scale, self.low, self.high)
        return found

    def name(self, place: int) -> str:
        """Key of a parameter, or component of a state at the start."""
        if place < self.parameters:
            return self.quantities[place].key
        return f"{COMPONENTS[(place - self.parameters) % State.SIZE]} at the start"


def _guess(model: Model, log: Log, sizes: Sizes) -> FloatArray:
    """The state at the start from a line through the first measured values."""
    state = np.zeros(State.SIZE)
    rows = max(3, int(np.searchsorted(log.times, log.times[0] + GUESSED * sizes.time)))
    times = log.times[:rows] - log.times[0]
    for place, signal in enumerate(SIGNALS):
        if place in log.known:
            rate, value = np.polyfit(times, log.measured[:rows, place], 1)
            state[place] = value - model.value(f"sensor.{signal}.offset")
            state[Coordinates.SIZE + place] = rate
    return state
