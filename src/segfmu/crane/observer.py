"""Observer: velocities, rates and unknown disturbances from measured positions and angles.

A steady-state Kalman filter for each axis of the crane linearised about rest, in deviations from
the reference, scheduled by rope length. Beside the axis' own states it has two random walks: an
acceleration that acts on the carriage or rope (friction, wrong masses), and one that acts on the
load (wind). As many disturbances as measured signals make the control free of offset (U. Maeder,
F. Borrelli, M. Morari, Linear offset-free model predictive control, Automatica 45 (2009)).

The run-time update is kernels/observer.py.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import pi

import numpy as np
from scipy.linalg import expm, solve_discrete_are

from segfmu.crane.checks import require_not_negative, require_positive, sized
from segfmu.crane.linear import ROWS, moved_masses, scheduled_lengths
from segfmu.crane.parameters import Crane
from segfmu.planning.arrays import FloatArray

# states of a horizontal axis, and those of them that the hoist has
POSITION, ANGLE, VELOCITY, RATE, INPUT, LOAD = range(6)
HOIST = np.array([POSITION, VELOCITY, INPUT])


@dataclass(frozen=True)
class Uncertainty:
    """What the observer expects.

    Parameters
    ----------
    position, length, angle : float
        Quantisation steps of the carriages' positions [m], the rope's length [m] and the sway
        angles [rad]; their errors are taken as evenly distributed, hence step^2 / 12.
    drift, wind : float
        Random walks of the disturbances, of carriages and rope, and of the load: standard
        deviation after one second, as a multiple of gravity. More makes the observer faster and
        noisier.
    wake : float
        A controller acts from the first time on at which a signal is further from its reference
        than this many of the steps: less may be rounding, and is left alone. 0: from the start.

    Raises
    ------
    InputError
        For values that are not positive; `wake` may be 0.
    """

    position: float = 1e-4
    length: float = 1e-4
    angle: float = 2.0 * pi / 4096.0
    drift: float = 0.3
    wind: float = 0.1
    wake: float = 1.0

    def __post_init__(self) -> None:
        for name in ("position", "length", "angle", "drift", "wind"):
            require_positive(f"uncertainty {name}", getattr(self, name))
        require_not_negative("uncertainty wake", self.wake)

    @property
    def tolerances(self) -> FloatArray:
        """Deviations that may be rounding: carriages, rope [m], angles [rad]; shape (3,)."""
        return self.wake * np.array([self.position, self.length, self.angle])


@dataclass(frozen=True, eq=False)
class Observer:
    """Table of an observer over rope length.

    Attributes
    ----------
    crane : Crane
        The nominal crane.
    sample_time : float
        [s]
    driven : bool
        Whether corrections are accelerations.
    delayed : bool
        Whether measured signals are one sample old.
    lengths : ndarray, shape (rows,)
        Rope lengths [m], ascending.
    table : ndarray, shape (rows, 18, 10)
        See kernels/observer.py.
    tolerances : ndarray, shape (3,)
        Of `Uncertainty`.
    """

    crane: Crane
    sample_time: float
    driven: bool
    delayed: bool
    lengths: FloatArray
    table: FloatArray
    tolerances: FloatArray


def axis_model(
    crane: Crane, axis: int, length: float, driven: bool, lag: float
) -> tuple[FloatArray, FloatArray]:
    """A (6, 6) and B (6, 2) of one axis; the inputs are velocity command and correction.

    The correction is a force on the carriage, or if driven an acceleration; for the hoist it is an
    acceleration in both modes, see kernels/tracking.py.
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


def _discretised(
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


def _axis_table(
    crane: Crane, axis: int, length: float, observer: tuple[float, bool, float, Uncertainty]
) -> FloatArray:
    """Transition, inputs and filter gain of one axis at one rope length, shape (6, 10)."""
    sample_time, driven, lag, expected = observer
    kept = np.arange(6) if axis < 2 else HOIST
    outputs = kept[kept <= ANGLE]
    a, b = axis_model(crane, axis, length, driven, lag)
    walks = np.zeros(6)
    walks[[INPUT, LOAD]] = expected.drift * crane.gravity, expected.wind * crane.gravity
    step = expected.position if axis < 2 else expected.length
    ad, bd, covariance = _discretised(a[np.ix_(kept, kept)], b[kept], walks[kept], sample_time)
    noise = np.diag(np.array([step, expected.angle])[: outputs.size] ** 2 / 12.0)
    read = np.eye(kept.size)[: outputs.size]
    spread = solve_discrete_are(ad.T, read.T, covariance, noise)
    filter_gain = np.linalg.solve(read @ spread @ read.T + noise, read @ spread).T
    table = np.zeros((6, 10))
    table[np.ix_(kept, kept)] = ad
    table[kept, 6:8] = bd
    table[np.ix_(kept, 8 + outputs)] = filter_gain
    return table


def design_observer(
    crane: Crane,
    *,
    sample_time: float,
    shortest: float,
    longest: float,
    driven: bool = False,
    lag: tuple[float, float, float] = (0.0, 0.0, 0.0),
    delayed: bool = False,
    uncertainty: Uncertainty | None = None,
    rows: int = ROWS,
) -> Observer:
    """Design the observer between two rope lengths.

    Parameters
    ----------
    crane : Crane
        The nominal crane.
    sample_time : float
        [s]
    shortest, longest : float
        Rope lengths [m].
    driven : bool
        Velocity drives: corrections are accelerations, else forces.
    lag : tuple of 3 float
        Lags of the velocity drives [s].
    delayed : bool
        Measured signals are one sample old.
    uncertainty : Uncertainty, optional

    Raises
    ------
    InputError
        For a period or rope lengths that are not positive, and negative lags.
    """
    require_positive("sample_time", sample_time)
    for name, value in zip(("bridge", "trolley", "hoist"), sized("lag", lag, 3), strict=True):
        require_not_negative(f"lag of the {name}", value)
    lengths = scheduled_lengths(shortest, longest, rows)
    expected = uncertainty or Uncertainty()
    table = [
        np.concatenate(
            [
                _axis_table(crane, i, float(x), (sample_time, driven, float(lag[i]), expected))
                for i in range(3)
            ]
        )
        for x in lengths
    ]
    return Observer(
        crane, sample_time, driven, delayed, lengths, np.array(table), expected.tolerances
    )
