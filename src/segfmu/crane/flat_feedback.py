"""Feedback with closed-form gains: poles of the flat output's error by bandwidth and damping.

About rest the load's position is a chain of four integrators behind each horizontal drive, and the
rope's length a chain of two behind the hoist. `feedback_gains` places the poles of each error. No
Riccati equation is solved, so every platform computes the same table.

The design is in continuous time. Sampling and dead time delay the loop, but the poles stay in place
if bandwidth times delay is small. So the bandwidth is a ratio to the pendulum's frequency
sqrt(g / l), and its product with the sum of period, dead times and a quarter of the lag is at most
LARGEST. Gains for drives with lag also compensate it: a + T a' in place of an acceleration a.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from segfmu.arrays import FloatArray
from segfmu.crane.checks import lags_of, require_kind, require_not_negative, require_positive
from segfmu.crane.feedback import SwayFeedback
from segfmu.crane.linear import ROWS, scheduled_lengths
from segfmu.crane.parameters import Crane
from segfmu.kernels import backend
from segfmu.kernels.control.design import largest_angle, largest_hoist_angle
from segfmu.kernels.control.records import Gains

RATIO = 1.0
HOIST_RATIO = 3.0
DAMPING = 1.0

# bandwidth times the time that it acts late [rad]
LARGEST, HOIST_LARGEST = largest_angle(), largest_hoist_angle()


def flat_gain(
    crane: Crane,
    length: float,
    bandwidth: float,
    damping: float,
    driven: bool,
    hoist_bandwidth: float | None = None,
    lag: ArrayLike = 0.0,
) -> FloatArray:
    """Gains (3, 11) at a rope length [m] for bandwidths [rad/s] and a damping.

    The hoist has the same bandwidth as the others unless its own is given.
    """
    hoist = bandwidth if hoist_bandwidth is None else hoist_bandwidth
    gains = np.zeros((Gains.SIZE, Gains.COLUMNS))
    plant = crane.plant(driven, lags_of("feedback lag", lag))
    backend.feedback_gains(plant, length, bandwidth, bandwidth, hoist, damping, gains)
    return gains[Gains.AXES :]


def design_flat(
    crane: Crane,
    *,
    sample_time: float,
    shortest: float,
    longest: float,
    ratio: float = RATIO,
    hoist_ratio: float = HOIST_RATIO,
    damping: float = DAMPING,
    lag: ArrayLike = 0.0,
    dead_time: float = 0.0,
    driven: bool = False,
    rows: int = ROWS,
) -> SwayFeedback:
    """Tabulate the gains between two rope lengths.

    Parameters
    ----------
    crane : Crane
        Its payload is the nominal one.
    sample_time : float
        [s]
    shortest, longest : float
        Rope lengths [m].
    ratio : float
        Bandwidth over the pendulum's frequency sqrt(g / l).
    hoist_ratio : float
        The same for the hoist, which the pendulum does not limit.
    damping : float
        Of all poles.
    lag : array_like
        Lags of the velocity drives [s], one or three.
    dead_time : float
        Age of the signals and dead time of the drives [s]; it limits the bandwidths.
    driven : bool
        True: corrections are accelerations; False: forces.

    Raises
    ------
    InputError
        For values that are not positive and for a negative lag.
    """
    require_kind("crane", crane, Crane)
    require_positive("sample_time", sample_time)
    require_positive("feedback ratio", ratio)
    require_positive("feedback hoist_ratio", hoist_ratio)
    require_positive("feedback damping", damping)
    require_not_negative("feedback dead_time", dead_time)
    lags = lags_of("feedback lag", lag)
    lengths = scheduled_lengths(shortest, longest, rows)
    design = np.array([sample_time, ratio, hoist_ratio, damping, dead_time])
    table = np.zeros((lengths.size, Gains.SIZE, Gains.COLUMNS))
    backend.flat_table(crane.plant(driven, lags), design, lengths.size, lengths, table)
    return SwayFeedback(sample_time, lengths, table[:, Gains.AXES :].copy(), crane.payload_mass)
