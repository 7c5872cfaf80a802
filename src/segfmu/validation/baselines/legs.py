"""The motion of one axis from waypoint to waypoint: trapezoids through a shaper."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
from numpy.typing import ArrayLike

from segfmu.arrays import FloatArray, finite_times
from segfmu.crane.shaping import Shaper, Trapezoid

# of a trapezoid without a shaper
PLAIN = Shaper(np.zeros(1), np.ones(1))


class Legs:
    """Consecutive trapezoids of one axis, shaped.

    Parameters
    ----------
    positions : ndarray, shape (n,)
        [m]
    lengths : ndarray, shape (n - 1,)
        Time from each position to the next one [s].
    velocity, acceleration : float
        Limits [m/s], [m/s2].
    shaper : Shaper
    """

    def __init__(
        self, positions: FloatArray, lengths: FloatArray, velocity: float, acceleration: float,
        shaper: Shaper = PLAIN,
    ) -> None:
        self.duration = float(np.sum(lengths) + shaper.times[-1])
        self._start, self._shaper = float(positions[0]), shaper
        starts = np.concatenate([[0.0], np.cumsum(lengths)[:-1]])
        legs = [Trapezoid(float(b - a), velocity, acceleration) for a, b in pairwise(positions)]
        self._legs = list(zip(starts.tolist(), legs, strict=True))

    def __call__(self, t: ArrayLike, derivative: int = 0) -> FloatArray:
        """Position, velocity or acceleration at times t, the shape of t."""
        times = finite_times(t)
        value = np.full(times.shape, self._start if derivative == 0 else 0.0)
        for start, leg in self._legs:
            for delay, share in zip(self._shaper.times, self._shaper.shares, strict=True):
                value += share * leg(times - start - delay, derivative)
        return value

    def swing(self, t: ArrayLike, frequency: float) -> tuple[FloatArray, FloatArray]:
        """Deviation of a linear pendulum [rad/s] below the axis from it [m], its rate [m/s]."""
        times = finite_times(t)
        value, rate = np.zeros(times.shape), np.zeros(times.shape)
        for start, leg in self._legs:
            for delay, share in zip(self._shaper.times, self._shaper.shares, strict=True):
                for edge, step in leg.edges:
                    since = frequency * np.clip(times - start - delay - edge, 0.0, None)
                    value -= share * step / frequency**2 * (1.0 - np.cos(since))
                    rate -= share * step / frequency * np.sin(since)
        return value, rate
