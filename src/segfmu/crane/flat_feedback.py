"""Feedback with closed-form gains: poles of the flat output's error by bandwidth and damping.

About rest the load's position is a chain of four integrators behind each horizontal drive, and the
rope's length one of two behind the hoist. `feedback_gains` of kernels/feedback.py gives each error
the poles chosen here; no Riccati equation is solved, so the same table can be made anywhere.

The design is in continuous time. A sample and hold delays by half a period, which leaves the poles
in place as long as bandwidth * sample_time is small: the bandwidth is a ratio to the pendulum's
frequency sqrt(g / l), and held below LARGEST radians a sample where the rope is short.
"""

from __future__ import annotations

import numpy as np

from segfmu.crane.checks import require_positive
from segfmu.crane.feedback import SwayFeedback
from segfmu.crane.linear import ROWS, scheduled_lengths
from segfmu.crane.parameters import Crane
from segfmu.kernels import backend
from segfmu.planning.arrays import FloatArray

RATIO = 1.0
DAMPING = 0.8

# radians a sample
LARGEST = 0.25


def flat_gain(
    crane: Crane, length: float, bandwidth: float, damping: float, driven: bool
) -> FloatArray:
    """Gains (3, 10) at a rope length [m] for a bandwidth [rad/s] and a damping."""
    gains = np.zeros((3, 10))
    backend.feedback_gains(driven, length, *crane.masses, bandwidth, damping, gains)
    return gains


def design_flat(
    crane: Crane,
    *,
    sample_time: float,
    shortest: float,
    longest: float,
    ratio: float = RATIO,
    damping: float = DAMPING,
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
    damping : float
        Of all poles.
    driven : bool
        Corrections are accelerations, else forces.

    Raises
    ------
    InputError
        For values that are not positive.
    """
    require_positive("sample_time", sample_time)
    require_positive("feedback ratio", ratio)
    require_positive("feedback damping", damping)
    lengths = scheduled_lengths(shortest, longest, rows)
    table = [
        flat_gain(
            crane, float(x),
            backend.feedback_bandwidth(ratio, float(x), crane.gravity, sample_time, LARGEST),
            damping, driven,
        )
        for x in lengths
    ]
    return SwayFeedback(sample_time, lengths, np.array(table), crane.payload_mass)
