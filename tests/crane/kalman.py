"""The observer's design by SciPy: matrix exponentials and its Riccati solver."""

from __future__ import annotations

import numpy as np
from scipy.linalg import expm, solve_discrete_are

from segfmu.arrays import FloatArray
from segfmu.crane.linear import moved_masses
from segfmu.crane.observer import Uncertainty
from segfmu.crane.parameters import Crane

# states of a horizontal axis, and those of them that the hoist has
POSITION, ANGLE, VELOCITY, RATE, INPUT, LOAD = range(6)
HOIST = np.array([POSITION, VELOCITY, INPUT])


def axis_model(
    crane: Crane, axis: int, length: float, driven: bool, lag: float
) -> tuple[FloatArray, FloatArray]:
    """A (6, 6) and B (6, 2) of one axis; the inputs are velocity command and correction.

    The correction is a force on the carriage, or if driven an acceleration; for the hoist it is an
    acceleration in both modes, see kernels/control/tracking.py.
    """
    a, b = np.zeros((6, 6)), np.zeros((6, 2))
    a[POSITION, VELOCITY] = a[ANGLE, RATE] = 1.0
    a[VELOCITY, INPUT] = 1.0
    if not driven and axis < 2:
        mass = moved_masses(crane.masses)[axis]
        b[VELOCITY, 1] = 1.0 / mass
        a[VELOCITY, ANGLE] = crane.payload_mass * crane.gravity / mass
    elif driven and lag > 0.0:
        a[VELOCITY, VELOCITY], b[VELOCITY, 0] = -1.0 / lag, 1.0 / lag
    else:
        b[VELOCITY, 1] = 1.0
    if axis < 2:
        # l angle'' = -g angle - carriage acceleration + acceleration of the load
        a[RATE], b[RATE] = -a[VELOCITY] / length, -b[VELOCITY] / length
        a[RATE, ANGLE] -= crane.gravity / length
        a[RATE, LOAD] = 1.0 / length
    return a, b


def discretised(
    a: FloatArray, b: FloatArray, walks: FloatArray, sample_time: float
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Transition, effect of the inputs, and covariance of the disturbances over a sample.

    The first input is a velocity command that the second one, held, makes a ramp. The covariance
    is C. F. van Loan's integral, IEEE Trans. Automatic Control 23 (1978).
    """
    n = a.shape[0]
    block = np.zeros((n + 2, n + 2))
    block[:n, :n], block[:n, n:] = a, b
    block[n, n + 1] = 1.0
    transition = expm(block * sample_time)
    noise = np.zeros((2 * n, 2 * n))
    noise[:n, :n], noise[:n, n:], noise[n:, n:] = -a, np.diag(walks**2), a.T
    loan = expm(noise * sample_time)
    covariance = loan[n:, n:].T @ loan[:n, n:]
    return transition[:n, :n], transition[:n, n:], 0.5 * (covariance + covariance.T)


def axis_table(
    crane: Crane, axis: int, length: float, observer: tuple[float, bool, float, Uncertainty]
) -> FloatArray:
    """Transition, inputs and filter gain of one axis at one rope length, shape (6, 10)."""
    sample_time, driven, lag, expected = observer
    kept = np.arange(6) if axis < 2 else HOIST
    outputs = kept[kept <= ANGLE]
    a, b = axis_model(crane, axis, length, driven, lag)
    walks = np.zeros(6)
    # walks are those of the pendulum's time; quantisation errors stay for a twentieth of it
    time = np.sqrt(length / crane.gravity)
    walks[[INPUT, LOAD]] = np.array([expected.drift, expected.wind]) * crane.gravity / np.sqrt(time)
    step = expected.position if axis < 2 else expected.length
    ad, bd, covariance = discretised(a[np.ix_(kept, kept)], b[kept], walks[kept], sample_time)
    noise = np.diag(np.array([step, expected.angle])[: outputs.size] ** 2 / 12.0)
    noise *= max(1.0, 0.05 * time / sample_time)
    read = np.eye(kept.size)[: outputs.size]
    spread = solve_discrete_are(ad.T, read.T, covariance, noise)
    filter_gain = np.linalg.solve(read @ spread @ read.T + noise, read @ spread).T
    table = np.zeros((6, 10))
    table[np.ix_(kept, kept)] = ad
    table[kept, 6:8] = bd
    table[np.ix_(kept, 8 + outputs)] = filter_gain
    return table
