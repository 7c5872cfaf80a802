"""Noise of measured signals: its size, and how far its samples depend on each other."""

from __future__ import annotations

import numpy as np

from segfmu.arrays import FloatArray
from segfmu.validation.identification.log import ANGLES, OUTPUTS, ROPE, Log

# of a signal's range: noise that is smaller is rounding
LEAST = 1e-6
# of the rope's length, or rad: noise of a signal that stands still, and so shows none; it must
# leave room for what others say of its zero
STILL = 1e-3
# of its greatest value: a signal whose range is smaller stands still
ROUNDING = 1e-12
# of independent noise, the deviation of its third differences is this times its own
THIRD = np.sqrt(20.0)
# of the median of the absolute values of normal noise
MEDIAN = 0.6745


def rough_noise(log: Log) -> FloatArray:
    """Standard deviations of the signals of a log before any fit, shape (5,).

    From third differences, which leave of a smooth motion next to nothing.
    """
    rough = np.median(np.abs(np.diff(log.measured, 3, axis=0)), axis=0) / (THIRD * MEDIAN)
    return np.asarray(np.maximum(rough, _least(log)))


def noise_of(log: Log, simulated: FloatArray) -> FloatArray:
    """Standard deviations of measured minus simulated signals, shape (5,)."""
    deviation = np.sqrt(np.mean((log.measured - simulated) ** 2, axis=0))
    return np.asarray(np.maximum(deviation, _least(log)))


def _least(log: Log) -> FloatArray:
    spans = np.ptp(log.measured, axis=0)
    rope = float(np.abs(log.measured[:, OUTPUTS.index(ROPE)]).mean())
    still = [STILL if name in ANGLES else STILL * rope for name in OUTPUTS]
    moves = spans > ROUNDING * np.abs(log.measured).max(axis=0)
    return np.where(moves, LEAST * spans, still)


def dependence(values: FloatArray) -> float:
    """How many samples of a signal count as one independent one; 1 for white noise.

    1 + 2 (r1 + r2 + ...) of the correlations, as long as the sum of two neighbours is positive
    (C. J. Geyer, Practical Markov chain Monte Carlo, Statistical Science 7 (1992) 473-483).
    """
    centred = values - values.mean()
    count = values.size
    spectrum = np.abs(np.fft.rfft(centred, 2 * count)) ** 2
    covariance = np.fft.irfft(spectrum)[:count]
    if covariance[0] <= 0.0:
        return 1.0
    ratios = covariance / covariance[0]
    pairs = ratios[: count // 2 * 2].reshape(-1, 2).sum(axis=1)
    ended = np.flatnonzero(pairs <= 0.0)
    total = float(pairs[: ended[0] if ended.size else pairs.size].sum())
    return max(1.0, 2.0 * total - 1.0)
