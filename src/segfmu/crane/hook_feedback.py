"""Feedback of a crane with a hook from measured signals: carriages, rope and the hook's angles.

The sling is not measured. An observer for each axis estimates its angle, the rates, and an unknown
acceleration of the carriage or the rope, which is rejected; a sampled LQR corrects the setpoints by
the estimated deviation from the reference. Models, gains and the observer's gains are scheduled by
rope length. Both designs are for the crane made dimensionless with L = l + sling and the frequency
sqrt(g / L), so that one set of weights suits every crane. The observer's expectations of pushes and
errors are chosen so that the fast swing, of hook against load, stays damped with other loads and
slings than those of the design; with a slower observer it does not.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike
from scipy.linalg import block_diag, solve_discrete_are

from segfmu.crane.checks import require_positive
from segfmu.crane.feedback import EFFORT
from segfmu.crane.hook import HookCrane
from segfmu.crane.hook_linear import PLACES, VELOCITY, axis_model
from segfmu.crane.linear import SIGNS, lags_of, moved_masses, sampled, scheduled_lengths
from segfmu.kernels.crane.records import Axes
from segfmu.planning.arrays import FloatArray

# what is measured of an axis: position, and of a carriage the hook's angle
MEASURED = ((0, 1), (0, 1), (0,))


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

    position: float = 1.0
    angle: float = 1.0
    velocity: float = 1.0
    rate: float = 1.0
    effort: float = 1.0
    rope: float = 9.0
    push: float = 3e-2
    swing: float = 0.1
    drift: float = 1e-2
    noise: float = 1e-3


@dataclass(frozen=True, eq=False)
class AxisDesign:
    """Sampled model and gains of an axis at one rope length.

    Attributes
    ----------
    transition : ndarray, shape (n, n)
        Over a period; states are those of `axis_model`, the unknown acceleration [m/s2], and of a
        drive with lag the velocity command.
    effect : ndarray, shape (n, 1)
        Of the correction over a period.
    gains : ndarray, shape (n,)
        From states to minus the correction.
    correction : ndarray, shape (n, m)
        From what signals differ by to the estimate.
    """

    transition: FloatArray
    effect: FloatArray
    gains: FloatArray
    correction: FloatArray

    def between(self, other: AxisDesign, share: float) -> AxisDesign:
        """The design a share of the way to another."""
        return AxisDesign(*(
            (1.0 - share) * a + share * b
            for a, b in zip(vars(self).values(), vars(other).values(), strict=True)
        ))


@dataclass(frozen=True, eq=False)
class HookFeedback:
    """Designs of the three axes over rope length, as `design_hook` finds them.

    Attributes
    ----------
    crane : HookCrane
    sample_time : float
        [s]
    lengths : ndarray, shape (rows,)
        Rope lengths [m], ascending.
    axes : tuple of 3 tuple of AxisDesign
        Of bridge, trolley and hoist, one a rope length.
    units : ndarray, shape (3,)
        Effort over the acceleration of the unloaded drive: masses [kg], or 1 for accelerations.
    """

    crane: HookCrane
    sample_time: float
    lengths: FloatArray
    axes: tuple[tuple[AxisDesign, ...], ...]
    units: FloatArray

    def at(self, axis: int, length: float) -> AxisDesign:
        """The design of an axis at a rope length, linear between the rows, constant outside."""
        last = len(self.lengths) - 1
        place = float(np.interp(length, self.lengths, np.arange(last + 1.0)))
        row = min(int(place), max(last - 1, 0))
        designs = self.axes[axis]
        return designs[row].between(designs[min(row + 1, last)], place - row)


def design_hook(
    crane: HookCrane,
    *,
    sample_time: float,
    shortest: float,
    longest: float,
    weights: HookWeights | None = None,
    driven: bool = False,
    lag: ArrayLike = 0.0,
    rows: int = 9,
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
    require_positive("sample_time", sample_time)
    lags = lags_of("feedback lag", lag) if driven else np.zeros(Axes.SIZE)
    lengths = scheduled_lengths(shortest, longest, rows)
    chosen = weights or HookWeights()
    units = np.ones(Axes.SIZE)
    if not driven:
        units = moved_masses(crane.crane.masses)
        units[Axes.ROPE] += crane.hook_mass
    axes = tuple(
        tuple(
            _designed(crane, float(x), axis, sample_time, chosen, driven, lags[axis], units[axis])
            for x in lengths
        )
        for axis in range(Axes.SIZE)
    )
    return HookFeedback(crane, sample_time, lengths, axes, units)


def _extended(
    crane: HookCrane, length: float, axis: int, driven: bool, lag: float, unit: float
) -> tuple[FloatArray, FloatArray]:
    """`axis_model` with the unknown acceleration and, with lag, the velocity command as states."""
    a, b = axis_model(crane, length, axis, driven)
    velocity = VELOCITY[axis]
    full, inputs = block_diag(a, np.zeros((1, 1))), np.vstack([b, np.zeros((1, 1))])
    full[:-1, -1] = unit * b[:, 0]
    if lag == 0.0:
        return full, inputs
    # the drive's acceleration (command - v) / lag takes the place of the input
    full[:, velocity] -= inputs[:, 0] / lag
    full = np.block([[full, inputs / lag], [np.zeros((1, full.shape[0] + 1))]])
    return full, np.vstack([np.zeros_like(inputs), np.ones((1, 1))])


def _designed(
    crane: HookCrane, length: float, axis: int, sample_time: float, w: HookWeights, driven: bool,
    lag: float, unit: float,
) -> AxisDesign:
    gravity, whole = crane.crane.gravity, length + crane.sling
    frequency = float(np.sqrt(gravity / whole))
    a, b = _extended(crane, length, axis, driven, lag, unit)
    own = PLACES[axis].size
    ad, bd = sampled(a, b, sample_time)
    scale = np.array([1.0 / whole, 1.0, 1.0])
    values = np.array([w.position, w.angle, w.angle, w.velocity, w.rate, w.rate])
    if axis == Axes.ROPE:
        scale, values = scale[:1], np.array([w.rope, w.velocity])
    scale = np.concatenate([scale, scale / frequency])
    # the unknown acceleration is not controlled but rejected
    kept = [*range(own), *range(own + 1, len(a))]
    cost = np.diag(np.append(scale**2 * values, np.zeros(len(kept) - own)))
    effort = np.array([[w.effort / (EFFORT * unit * gravity) ** 2]])
    gains = np.zeros(len(a))
    gains[kept] = _regulator(ad[np.ix_(kept, kept)], bd[kept], cost, effort)
    if lag == 0.0:
        gains[own] = unit
    correction = _observer(crane, length, axis, ad, sample_time, w)
    return AxisDesign(ad, bd, gains, correction)


def _regulator(a: FloatArray, b: FloatArray, cost: FloatArray, effort: FloatArray) -> FloatArray:
    riccati = solve_discrete_are(a, b, cost, effort)
    gains: FloatArray = np.linalg.solve(effort + b.T @ riccati @ b, b.T @ riccati @ a)[0]
    return gains


def _observer(
    crane: HookCrane, length: float, axis: int, a: FloatArray, sample_time: float, w: HookWeights
) -> FloatArray:
    """Steady Kalman gain, shape (n, m)."""
    gravity, whole = crane.crane.gravity, length + crane.sling
    time = float(np.sqrt(whole / gravity))
    model, push = axis_model(crane, length, axis, True)
    own, known = len(model), len(MEASURED[axis])
    # accelerations of carriage, and of the load across the sling
    noise = np.zeros((len(a), len(a)))
    given = w.push * gravity * push[:, 0]
    noise[:own, :own] = np.outer(given, given)
    if axis != Axes.ROPE:
        swing = np.zeros(own)
        swing[-1] = w.swing * gravity / crane.sling
        noise[:own, :own] += np.outer(swing, swing)
    noise[own, own] = (w.drift * gravity) ** 2 / time**2
    noise *= sample_time * time
    seen = np.eye(known, len(a))
    errors = np.diag(np.array([w.noise * whole, w.noise][:known]) ** 2) * time / sample_time
    kept = list(range(own + 1))
    riccati = solve_discrete_are(
        a[np.ix_(kept, kept)].T, seen[:, kept].T, noise[np.ix_(kept, kept)], errors
    )
    found = np.zeros((len(a), known))
    found[kept] = np.linalg.solve(
        seen[:, kept] @ riccati @ seen[:, kept].T + errors, seen[:, kept] @ riccati
    ).T
    return found


class HookController:
    """The feedback as a controller of the plant, see `segfmu.crane.Controller`.

    Parameters
    ----------
    feedback : HookFeedback
    lower, upper : array_like, shape (3,), optional
        Least and greatest setpoints that the drives can follow [N] or [m/s2].

    Attributes
    ----------
    estimates : list of 3 ndarray
        Deviations of each axis before the next tick.
    """

    def __init__(
        self, feedback: HookFeedback, lower: ArrayLike = -np.inf, upper: ArrayLike = np.inf
    ) -> None:
        self.feedback = feedback
        self._lower = np.broadcast_to(np.asarray(lower, dtype=np.float64), Axes.SIZE)
        self._upper = np.broadcast_to(np.asarray(upper, dtype=np.float64), Axes.SIZE)
        self.estimates = [np.zeros(len(designs[0].gains)) for designs in feedback.axes]

    @property
    def sample_time(self) -> float:
        """Period [s]."""
        return self.feedback.sample_time

    def sample(
        self, time: float, measured: FloatArray, reference: FloatArray, feedforward: FloatArray
    ) -> FloatArray:
        """Correction (3,), see `segfmu.crane.Controller`."""
        apart = measured - reference[: measured.size]
        correction = np.zeros(Axes.SIZE)
        for axis in range(Axes.SIZE):
            design = self.feedback.at(axis, float(measured[Axes.ROPE]))
            seen = apart[[axis]]
            if axis != Axes.ROPE:
                seen = np.array([apart[axis], SIGNS[axis] * apart[Axes.SIZE + axis]])
            estimate = self.estimates[axis]
            estimate = estimate + design.correction @ (seen - estimate[: seen.size])
            wanted = feedforward[axis] - design.gains @ estimate
            value = np.clip(wanted, self._lower[axis], self._upper[axis]) - feedforward[axis]
            self.estimates[axis] = design.transition @ estimate + design.effect[:, 0] * value
            correction[axis] = value
        return correction
