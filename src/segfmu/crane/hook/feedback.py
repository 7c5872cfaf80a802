"""Feedback of a crane with a hook from measured signals: carriages, rope and the hook's angles.

The sling is not measured. An observer for each axis estimates its angle, the rates, and an unknown
acceleration of the carriage or the rope, which is rejected; a sampled LQR corrects the setpoints by
the estimated deviation from the reference. Models, gains and the observer's gains are scheduled by
rope length. Both designs are for the crane made dimensionless with L = l + sling and the frequency
sqrt(g / L), so that one set of weights suits every crane. The observer's expectations of pushes and
errors, and the weights, are those with which the slowest part decays fastest with other loads and
slings than those of the design, and with signals that come a period late, at both sizes, for the
same effort under noise. With a slower observer the fast swing, of hook against load, is not damped.
"""

from __future__ import annotations

from dataclasses import astuple, dataclass

import numpy as np
from numpy.typing import ArrayLike

from segfmu.arrays import FloatArray, sized, table_of
from segfmu.crane.checks import lags_of, require_kind, require_positive, require_weights
from segfmu.crane.hook.parameters import HookCrane
from segfmu.crane.linear import scheduled_lengths
from segfmu.errors import InputError
from segfmu.kernels import backend
from segfmu.kernels.crane.records import Axes, Coordinates, Plant, State
from segfmu.kernels.hook.records import HookAxis, HookDesign, HookLimits, HookTable

# rope lengths of a table
ROWS = 9


@dataclass(frozen=True)
class HookWeights:
    """Weights of the dimensionless designs.

    Attributes
    ----------
    position, angle, velocity, rate, effort : float
        Of carriage, both angles, their rates and effort, as those of `Weights`.
    rope : float
        Of the rope's length.
    push, swing : float
        Accelerations that the observer expects of carriage and load, over gravity.
    drift : float
        Walk of the unknown acceleration in sqrt(L / g), over gravity.
    noise : float
        Errors of the signals, over L, and of the angles [rad].
    """

    position: float = 0.4
    angle: float = 1.0
    velocity: float = 1.0
    rate: float = 0.3
    effort: float = 2.0
    rope: float = 9.0
    push: float = 0.13
    swing: float = 0.27
    drift: float = 0.13
    noise: float = 1e-3

    def __post_init__(self) -> None:
        require_weights(vars(self), ("position", "effort", "rope", "push", "drift", "noise"))


@dataclass(frozen=True, eq=False)
class HookFeedback:
    """Feedback over rope length, as `design_hook` finds it.

    Attributes
    ----------
    sample_time : float
        [s]
    table : ndarray, shape (rows, 34, 9)
        The kernels' `HookTable`, one a rope length.

    Raises
    ------
    InputError
        For a period that is not positive, and a table of another shape.
    """

    sample_time: float
    table: FloatArray

    def __post_init__(self) -> None:
        require_positive("sample_time", self.sample_time)
        table = table_of("table", self.table, None, HookTable.SIZE, HookTable.COLUMNS)
        object.__setattr__(self, "table", table)

    @property
    def lengths(self) -> FloatArray:
        """Rope lengths [m], ascending."""
        found: FloatArray = self.table[:, HookTable.LENGTH, 0]
        return found


def design_hook(
    crane: HookCrane,
    *,
    sample_time: float,
    shortest: float,
    longest: float,
    weights: HookWeights | None = None,
    driven: bool = False,
    lag: ArrayLike = 0.0,
    rows: int = ROWS,
) -> HookFeedback:
    """Design feedback and observer between two rope lengths.

    Parameters
    ----------
    crane : HookCrane
        With the load and the sling that are expected.
    sample_time : float
        [s]
    shortest, longest : float
        Lengths of the rope, from trolley to hook [m].
    weights : HookWeights, optional
    driven : bool
        True: corrections are accelerations; False: forces.
    lag : array_like
        Lags of the velocity drives [s], one or three.
    rows : int

    Raises
    ------
    InputError
        For a period and lengths that are not positive, and negative lags.
    """
    design = HookWeights() if weights is None else weights
    require_kind("crane", crane, HookCrane)
    require_kind("weights", design, HookWeights)
    require_positive("sample_time", sample_time)
    lengths = scheduled_lengths(shortest, longest, rows)
    plant = crane.crane.plant(driven, lags_of("feedback lag", lag))
    plant[Plant.SUSPENSION : Plant.SLING + 1] = crane.suspension, *crane.tackle
    chosen = np.array(astuple(design))
    work = np.zeros((HookDesign.SIZE, 2 * HookAxis.CORRECTION))
    table = np.zeros((lengths.size, HookTable.SIZE, HookTable.COLUMNS))
    for length, block in zip(lengths.tolist(), table, strict=True):
        backend.hook_design(plant, sample_time, length, chosen, work, block)
    if not np.isfinite(table).all():
        raise InputError(
            f"the feedback has no gain between {shortest:g} and {longest:g} m of rope: check "
            "masses, sling, lags and weights"
        )
    return HookFeedback(float(sample_time), table)


class HookController:
    """The feedback as a controller of the plant, see `segfmu.crane.Controller`.

    It takes its corrections as made: while they are switched off, what it estimates is wrong.

    Parameters
    ----------
    feedback : HookFeedback
    lower, upper : array_like, shape (3,), optional
        Least and greatest setpoints that the drives can follow [N] or [m/s2].
    velocity_min, velocity_max : array_like, shape (3,), optional
        Least and greatest velocities of velocity drives [m/s], which corrections keep.

    Attributes
    ----------
    estimates : ndarray, shape (4, 9)
        A `HookAxis` of each axis at the last tick; the last row is work space.
    """

    def __init__(
        self, feedback: HookFeedback, lower: ArrayLike = -1e99, upper: ArrayLike = 1e99,
        velocity_min: ArrayLike = -1e99, velocity_max: ArrayLike = 1e99,
    ) -> None:
        require_kind("feedback", feedback, HookFeedback)
        self.feedback = feedback
        self.estimates = np.zeros((Axes.SIZE + 1, HookAxis.SIZE))
        self._limits = np.zeros(HookLimits.SIZE)
        given = {
            "lower": lower, "upper": upper, "velocity_min": velocity_min,
            "velocity_max": velocity_max,
        }
        rows = [sized(name, value, Axes.SIZE, alike=True) for name, value in given.items()]
        self._limits[: HookLimits.PERIOD] = np.concatenate(rows)
        self._limits[HookLimits.PERIOD] = feedback.sample_time
        self._correction = np.zeros(Axes.SIZE)

    @property
    def sample_time(self) -> float:
        """Period [s]."""
        return self.feedback.sample_time

    def sample(
        self, time: float, measured: FloatArray, reference: FloatArray, feedforward: FloatArray
    ) -> FloatArray:
        """Correction (3,), see `segfmu.crane.Controller`."""
        backend.hook_correction(
            self.feedback.table, self._limits, sized("measured", measured, Coordinates.SIZE),
            sized("reference", reference, State.SIZE), sized("feedforward", feedforward, Axes.SIZE),
            self.estimates, self._correction,
        )
        return self._correction.copy()
