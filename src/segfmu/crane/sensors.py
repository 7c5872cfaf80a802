"""Sensors as on the paper's rig: bridge, trolley, rope length and the two cardan angles."""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass
from math import pi

import numpy as np

from segfmu.crane.checks import require_not_negative, require_positive, require_seed, sized
from segfmu.errors import InputError
from segfmu.kernels import backend
from segfmu.planning.arrays import FloatArray

Five = tuple[float, float, float, float, float]
NONE: Five = (0.0, 0.0, 0.0, 0.0, 0.0)


def resolution(counts: float, travel: float = 2.0 * pi) -> float:
    """Width of a step of an encoder with `counts` a revolution, which moves `travel` [m or rad].

    Raises
    ------
    InputError
        For values that are not positive.
    """
    require_positive("counts", counts)
    require_positive("travel", travel)
    return travel / counts


@dataclass(frozen=True)
class Sensors:
    """What separates the measured signals from the state; five values each, [m] and [rad].

    Parameters
    ----------
    sample_time : float
        Period [s]; 0: continuous.
    dead_time : float
        From sampling to availability [s]; until the first sample is there, it is used early.
    resolution : tuple of 5 float
        Width of a quantisation step; 0: none.
    deviation : tuple of 5 float
        Standard deviation of the noise of every sample.
    offset : tuple of 5 float
        Measured minus true value; the third one makes the rope seem longer than it is.
    seed : int
        Of the noise.

    Raises
    ------
    InputError
        For negative values, and noise or dead time without a sample time.
    """

    sample_time: float = 0.0
    dead_time: float = 0.0
    resolution: Five = NONE
    deviation: Five = NONE
    offset: Five = NONE
    seed: int = 0

    def __post_init__(self) -> None:
        require_not_negative("sensor sample_time", self.sample_time)
        require_not_negative("sensor dead_time", self.dead_time)
        require_seed("sensor seed", self.seed)
        sized("sensor offset", self.offset, 5)
        for name in ("resolution", "deviation"):
            for value in sized(f"sensor {name}", getattr(self, name), 5):
                require_not_negative(f"sensor {name}", value)
        if self.sample_time == 0.0 and (self.dead_time > 0.0 or any(self.deviation)):
            raise InputError(
                "sensor noise and dead_time belong to samples: set sensor sample_time above 0 s"
            )


class Readings:
    """The sensors' signals over time; `sample` is called at every tick, in their order."""

    def __init__(self, sensors: Sensors, state: FloatArray) -> None:
        self._sensors = sensors
        self._values = [
            np.array(v, dtype=np.float64)
            for v in (sensors.offset, sensors.deviation, sensors.resolution)
        ]
        self._numbers = np.zeros(2, dtype=np.int64)
        backend.seed_numbers(sensors.seed, self._numbers)
        self._held: FloatArray | None = None
        self._coming: deque[tuple[float, FloatArray]] = deque()
        self._ticks = 0
        if sensors.sample_time > 0.0:
            self.sample(state)

    @property
    def next_tick(self) -> float:
        """Time of the next sample since the start [s]; infinite for continuous sensors."""
        period = self._sensors.sample_time
        return self._ticks * period if period > 0.0 else np.inf

    def sample(self, state: FloatArray) -> None:
        """Take the sample that is due."""
        self._coming.append((self.next_tick + self._sensors.dead_time, self._read(state)))
        self._ticks += 1

    def at(self, time: float, state: FloatArray) -> FloatArray:
        """Measured signals at a time since the start, shape (5,); times must not decrease."""
        if self._sensors.sample_time == 0.0:
            return self._read(state)
        tolerance = 1e-9 * self._sensors.sample_time
        while self._coming and (self._held is None or self._coming[0][0] <= time + tolerance):
            self._held = self._coming.popleft()[1]
        assert self._held is not None
        return self._held.copy()

    def _read(self, state: FloatArray) -> FloatArray:
        measured = np.zeros(5)
        backend.measure_state(state, *self._values, self._numbers, measured)
        return measured
