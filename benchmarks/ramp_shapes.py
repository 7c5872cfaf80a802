"""Acceleration ramps, n = 4, as far as lower bounds on durations need them (`ramp_bound.py`).

Units: the duration of a profile is 1, and so is the smaller of jerk and snap limit. A ramp of
duration tau is compared with the straight one of the same ends, whose slope is u. Both gain the
same velocity where the ramp is point-symmetric; the position of the straight one ends ahead.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.polynomial import Polynomial
from numpy.typing import NDArray

from benchmarks.optimal_control import Transition

FloatArray = NDArray[np.float64]
RAMP = Polynomial([0.0, 0.0, 0.0, 10.0, -15.0, 6.0])
STRAIGHT = Polynomial([0.0, 1.0])
# peaks of the first two derivatives (errata E3)
SLOPE = float(RAMP.deriv()(0.5))
CURVATURE = float(np.abs(RAMP.deriv(2)(RAMP.deriv(3).roots())).max())
# velocity that a straight ramp of height and duration 1 gains ahead of the smoothstep
LEAD = (STRAIGHT - RAMP).integ()
# and the position it ends ahead: 1/42
AHEAD = float(LEAD.integ()(1.0))
# above |d^2/ds^2| and |d^2/de^2| of (e - s)^2 LEAD((t - s) / (e - s))
LEAD_CURVATURE = 1.5
# slopes that linear programs choose from where the best one is inside
STEPS = 4


@dataclass(frozen=True)
class ScaledTransition:
    """Boundary problem in the units of this module.

    Attributes
    ----------
    v, a, w, b : float
        Velocity and acceleration at start and end.
    distance, velocity, acceleration, jerk, snap : float
        Distance and limits.
    """

    v: float
    a: float
    w: float
    b: float
    distance: float
    velocity: float
    acceleration: float
    jerk: float
    snap: float

    def widest(self, shortest: FloatArray) -> FloatArray:
        """Largest |slope| from one acceleration limit to the other for ramps no shorter."""
        wide = np.full_like(shortest, np.inf)
        np.divide(2.0 * self.acceleration, shortest, out=wide, where=shortest > 0.0)
        return wide


def scaled(transition: Transition, duration: float) -> ScaledTransition:
    """The transition in units of the duration and of the smaller of jerk and snap limit."""
    velocity, acceleration, jerk, snap = transition.limits
    unit = min(jerk, snap * duration)
    a = unit * duration
    v, y = a * duration, a * duration**2
    start, end = transition.start, transition.end
    return ScaledTransition(
        start[1] / v, start[2] / a, end[1] / v, end[2] / a, (end[0] - start[0]) / y,
        velocity / v, acceleration / a, jerk / unit, snap * duration / unit,
    )


class Ramps(Protocol):
    """A class of ramps; its straight ramps end ahead by at most u tau^3 / 42."""

    def slopes(
        self, problem: ScaledTransition, shortest: FloatArray, longest: FloatArray
    ) -> FloatArray:
        """Largest |slope| of ramps whose durations lie in these ranges."""

    def lead(self, share: FloatArray) -> FloatArray:
        """Least velocity, per height and duration, of a straight ramp ahead of the curved one."""

    def best(
        self, problem: ScaledTransition, rate: FloatArray, weight: float, duration: FloatArray,
        slopes: FloatArray,
    ) -> FloatArray:
        """Largest of u rate - weight (position ahead) over 0 <= u <= slopes."""

    def samples(
        self, problem: ScaledTransition, duration: FloatArray
    ) -> list[tuple[FloatArray, FloatArray]]:
        """Some slopes, and how far they end ahead per slope, for linear programs."""


class Smoothstep:
    """The paper's ramps (12), k = 2, as fast as the limits admit or slower."""

    def slopes(
        self, problem: ScaledTransition, shortest: FloatArray, longest: FloatArray
    ) -> FloatArray:
        """Largest |slope| of ramps whose durations lie in these ranges."""
        ramps = np.minimum(problem.jerk / SLOPE, problem.snap / CURVATURE * longest)
        return np.asarray(np.minimum(ramps, problem.widest(shortest)), dtype=np.float64)

    def lead(self, share: FloatArray) -> FloatArray:
        """Velocity, per height and duration, of a straight ramp ahead of the curved one."""
        return np.asarray(LEAD(share), dtype=np.float64)

    def best(
        self, problem: ScaledTransition, rate: FloatArray, weight: float, duration: FloatArray,
        slopes: FloatArray,
    ) -> FloatArray:
        """Largest of u rate - weight (position ahead) over 0 <= u <= slopes."""
        return slopes * np.maximum(rate - weight * AHEAD * duration**3, 0.0)

    def samples(
        self, problem: ScaledTransition, duration: FloatArray
    ) -> list[tuple[FloatArray, FloatArray]]:
        """The steepest slopes, and how far they end ahead per slope."""
        return [(self.slopes(problem, duration, duration), AHEAD * duration**3)]


class SymmetricRamps:
    """All ramps whose jerk is symmetric, rises once and falls once, and keeps both limits.

    Its variance over the ramp is no less than the smoothstep's; `plateau` is among them, whatever
    share of a rise the snap needs. None is steeper than a trapezoid of jerk with the snap limit on
    its flanks. Of all ramps of one slope, the trapezoid with the steepest flanks has the jerk
    farthest from the middle, and the straight ramp ends least ahead of it: by u^2 tau^2 / (12 c_4).
    """

    def slopes(
        self, problem: ScaledTransition, shortest: FloatArray, longest: FloatArray
    ) -> FloatArray:
        """Largest |slope| of ramps whose durations lie in these ranges."""
        rise = np.minimum(problem.jerk / problem.snap, longest / 2.0)
        ramps = problem.snap * rise * (longest - rise) / longest
        return np.asarray(np.minimum(ramps, problem.widest(shortest)), dtype=np.float64)

    def lead(self, share: FloatArray) -> FloatArray:
        """No lead is certain."""
        return np.zeros_like(share)

    def best(
        self, problem: ScaledTransition, rate: FloatArray, weight: float, duration: FloatArray,
        slopes: FloatArray,
    ) -> FloatArray:
        """Largest of u rate - weight (position ahead) over 0 <= u <= slopes."""
        if weight <= 0.0:
            return slopes * np.maximum(rate - weight * AHEAD * duration**3, 0.0)
        bend = weight * duration**2 / (12.0 * problem.snap)
        slope = np.clip(rate / (2.0 * bend), 0.0, slopes)
        return slope * (rate - bend * slope)

    def samples(
        self, problem: ScaledTransition, duration: FloatArray
    ) -> list[tuple[FloatArray, FloatArray]]:
        """The steepest slopes most ahead, and some slopes least ahead."""
        steepest = self.slopes(problem, duration, duration)
        chosen = [(steepest, AHEAD * duration**3)]
        for k in range(1, STEPS + 1):
            slope = steepest * k / STEPS
            chosen.append((slope, slope * duration**2 / (12.0 * problem.snap)))
        return chosen
