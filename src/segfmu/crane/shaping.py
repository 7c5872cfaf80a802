"""Baselines to compare with: the trapezoidal velocity profile, and input shaping.

An input shaper replaces a motion by a weighted sum of delayed copies, such that a pendulum of known
frequency and damping is at rest after the last one: ZV (N. C. Singer, W. P. Seering, Preshaping
command inputs to reduce system vibration, J. Dyn. Sys. Meas. Control 112 (1990)). For ZVD the
residual's derivative with respect to the frequency is zero too.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import exp, pi, sqrt
from typing import Protocol

import numpy as np
from numpy.typing import ArrayLike

from segfmu.arrays import FloatArray, as_index, finite_times, finite_vector, shown
from segfmu.crane.checks import require_finite, require_kind, require_positive
from segfmu.errors import InputError


class Motion(Protocol):
    """A motion of a carriage along one axis."""

    @property
    def duration(self) -> float:
        """Time [s] at which it comes to rest."""

    def __call__(self, t: ArrayLike, derivative: int = 0) -> FloatArray:
        """Position, velocity or acceleration at times t, the shape of t."""


class Trapezoid:
    """Rest to rest with bounded velocity and acceleration, in the least time.

    Parameters
    ----------
    distance : float
        [m], of either sign.
    velocity, acceleration : float
        Limits [m/s], [m/s2].
    start : float
        Position at the start [m].

    Attributes
    ----------
    ramp, cruise : float
        Durations of either ramp and of the constant velocity between them [s].

    Raises
    ------
    InputError
        For limits that are not positive.
    """

    def __init__(
        self, distance: float, velocity: float, acceleration: float, start: float = 0.0
    ) -> None:
        require_finite("distance", distance)
        require_finite("start", start)
        require_positive("velocity", velocity)
        require_positive("acceleration", acceleration)
        peak = min(velocity, sqrt(abs(distance) * acceleration))
        self.ramp = peak / acceleration
        self.cruise = max(abs(distance) / peak - self.ramp, 0.0) if peak > 0.0 else 0.0
        self._start = start
        self._acceleration = acceleration if distance >= 0.0 else -acceleration

    @property
    def duration(self) -> float:
        """[s]"""
        return 2.0 * self.ramp + self.cruise

    @property
    def edges(self) -> tuple[tuple[float, float], ...]:
        """Times at which the acceleration jumps [s], and by how much [m/s2]."""
        times = (0.0, self.ramp, self.ramp + self.cruise, self.duration)
        signs = (1.0, -1.0, -1.0, 1.0)
        return tuple((t, s * self._acceleration) for t, s in zip(times, signs, strict=True))

    def __call__(self, t: ArrayLike, derivative: int = 0) -> FloatArray:
        """Position, velocity or acceleration (right-continuous) at times t, the shape of t."""
        _require_derivative(derivative)
        # each edge of the acceleration starts a parabola
        times = finite_times(t)
        value = np.full(times.shape, self._start if derivative == 0 else 0.0)
        for edge, step in self.edges:
            since = np.clip(times - edge, 0.0, None)
            if derivative == 0:
                # no rounding error may remain after the end
                since = np.minimum(since, self.duration - edge)
                value += step * since**2 / 2.0
            elif derivative == 1:
                since = np.minimum(since, self.duration - edge)
                value += step * since
            else:
                value += step * (times >= edge)
        return value

# by which the sum of shares may differ from 1, as rounded shares do
SUM = 1e-6


@dataclass(frozen=True, eq=False)
class Shaper:
    """Impulses of an input shaper.

    Attributes
    ----------
    times : ndarray, shape (impulses,)
        [s], ascending from 0.
    shares : ndarray, shape (impulses,)
        Their sum is 1.

    Raises
    ------
    InputError
        For other times and shares.
    """

    times: FloatArray
    shares: FloatArray

    def __post_init__(self) -> None:
        for name in ("times", "shares"):
            values = finite_vector(f"{name} of a shaper", getattr(self, name))
            object.__setattr__(self, name, values)
        if self.times[0] != 0.0 or np.any(np.diff(self.times) < 0.0):
            raise InputError(f"times of a shaper ascend from 0, got {shown(self.times.tolist())}")
        if self.shares.size != self.times.size or abs(self.shares.sum() - 1.0) > SUM:
            raise InputError(
                "shares of a shaper are as many as its times, and their sum is 1, got "
                f"{shown(self.shares.tolist())}"
            )

    def then(self, other: Shaper) -> Shaper:
        """Both shapers one after the other: for two frequencies, in the sum of both durations."""
        require_kind("other", other, Shaper)
        times = np.add.outer(self.times, other.times).ravel()
        order = np.argsort(times, kind="stable")
        return Shaper(times[order], np.multiply.outer(self.shares, other.shares).ravel()[order])

    def residual(self, frequency: float, damping: float = 0.0) -> float:
        """Residual oscillation of a pendulum [rad/s], relative to that without shaper."""
        _require_damped(frequency, damping)
        decay = damping * frequency
        damped = frequency * sqrt(1.0 - damping**2)
        phases = self.shares * np.exp((decay + 1j * damped) * (self.times - self.times[-1]))
        return float(abs(phases.sum()))


def zv(frequency: float, damping: float = 0.0) -> Shaper:
    """Zero-vibration shaper for a frequency [rad/s] and a damping ratio: two impulses.

    Raises
    ------
    InputError
        For a frequency that is not positive and for a damping outside 0 <= damping < 1.
    """
    ratio, half = _decay(frequency, damping)
    return Shaper(np.array([0.0, half]), np.array([1.0, ratio]) / (1.0 + ratio))


def zvd(frequency: float, damping: float = 0.0) -> Shaper:
    """Zero-vibration-and-derivative shaper: three impulses; see `zv`."""
    ratio, half = _decay(frequency, damping)
    shares = np.array([1.0, 2.0 * ratio, ratio**2]) / (1.0 + ratio) ** 2
    return Shaper(np.array([0.0, half, 2.0 * half]), shares)


def _decay(frequency: float, damping: float) -> tuple[float, float]:
    """Decay over half an oscillation, and its duration [s]."""
    _require_damped(frequency, damping)
    root = sqrt(1.0 - damping**2)
    return exp(-damping * pi / root), pi / (frequency * root)


def _require_damped(frequency: float, damping: float) -> None:
    require_positive("frequency", frequency)
    require_finite("damping", damping)
    if not 0.0 <= damping < 1.0:
        raise InputError(f"damping must be a ratio from 0 to below 1, got {shown(damping)}")


class Shaped:
    """A shaped motion.

    Parameters
    ----------
    motion : Motion
        It must start at rest at time 0.
    shaper : Shaper
    """

    def __init__(self, motion: Motion, shaper: Shaper) -> None:
        if not callable(motion) or not hasattr(motion, "duration"):
            raise InputError(f"motion must be a motion such as Trapezoid, got {shown(motion)}")
        require_kind("shaper", shaper, Shaper)
        self._motion = motion
        self._shaper = shaper

    @property
    def duration(self) -> float:
        """[s]"""
        return self._motion.duration + float(self._shaper.times[-1])

    def __call__(self, t: ArrayLike, derivative: int = 0) -> FloatArray:
        """Position, velocity or acceleration at times t, the shape of t."""
        times = finite_times(t)
        value = np.zeros(times.shape)
        for delay, share in zip(self._shaper.times, self._shaper.shares, strict=True):
            value += share * self._motion(times - delay, derivative)
        return value


def _require_derivative(derivative: int) -> None:
    as_index("derivative", derivative, 2)
