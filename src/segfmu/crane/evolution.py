"""Minimisation by evolution of samples with an adapted covariance (CMA-ES).

N. Hansen, The CMA Evolution Strategy: A Tutorial, arXiv:1604.00772. Only the order of the values
counts, so kinks and plateaus do no harm. Places without a value are sampled again.

The random numbers are seeded, and the same problem has the same result on every processor: values
are ordered with a tolerance, and all else is sums, products and roots in a fixed order, which every
processor rounds alike, or is rounded to few digits.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import pairwise
from math import exp, log, sqrt

import numpy as np

from segfmu.planning.arrays import FloatArray

SMALLEST_STEP = 1e-4
# samples of a generation over its size, at most; and the step's factor where too few have a value
SAMPLES = 3
NARROWER = 0.7
# decimals of moves in standard deviations, and of logarithms and exponentials
DIGITS, EXACT_DIGITS = 6, 9
# values that differ by a smaller share are equal
EQUAL = 1e-9
# the root of a covariance: its least eigenvalue over the trace, steps, and the last one's size
SHARE, STEPS, LAST = 1e-14, 80, 1e-8

Value = tuple[bool, float]


def precedes(one: Value, other: Value) -> bool:
    """Whether a value comes before another one by more than rounding."""
    return one[0] < other[0] or (one[0] == other[0] and other[1] - one[1] > EQUAL * abs(other[1]))


def ranked(values: Sequence[Value]) -> list[int]:
    """Indices in ascending order of the values, equal ones in the given order."""
    order = sorted(range(len(values)), key=values.__getitem__)
    found, equal = [], order[:1]
    for last, index in pairwise(order):
        if precedes(values[last], values[index]):
            found += sorted(equal)
            equal = []
        equal.append(index)
    return found + sorted(equal)


class Evolution:
    """State of the strategy.

    Parameters
    ----------
    start : ndarray, shape (n,)
        First mean.
    step : float
        First standard deviation of every coordinate.
    """

    def __init__(self, start: FloatArray, step: float) -> None:
        n = start.size
        self.mean, self.step = start.copy(), step
        self.size = 4 + int(3.0 * log(n))
        half = self.size // 2
        logarithms = [log(half + 0.5) - log(i) for i in range(1, half + 1)]
        weights = np.round(logarithms, EXACT_DIGITS)
        self.weights = weights / weights.sum()
        self.mass = 1.0 / float((self.weights**2).sum())
        self.covariance = np.eye(n)
        self.straight, self.path = np.zeros(n), np.zeros(n)
        self.generation = 0
        self.random = np.random.default_rng(2)
        mass = self.mass
        self.fade = (4.0 + mass / n) / (n + 4.0 + 2.0 * mass / n)
        self.step_fade = (mass + 2.0) / (n + mass + 5.0)
        self.damping = 1.0 + 2.0 * max(0.0, sqrt((mass - 1.0) / (n + 1.0)) - 1.0)
        self.damping += self.step_fade
        self.rank_one = 2.0 / ((n + 1.3) ** 2 + mass)
        rank = 2.0 * (mass - 2.0 + 1.0 / mass) / ((n + 2.0) ** 2 + mass)
        self.rank = min(1.0 - self.rank_one, rank)
        self.length = sqrt(n) * (1.0 - 0.25 / n + 1.0 / (21.0 * n * n))

    def advance(self, value: Callable[[FloatArray], Value | None]) -> None:
        """Sample one generation, judge it by `value`, and adapt mean, step and covariance.

        Where less than half a generation has a value other than None, the step shrinks instead.
        """
        root, inverse = roots(self.covariance)
        moves, values = [], []
        for _ in range(SAMPLES * self.size):
            normal = self.random.standard_normal(self.mean.size)
            move = (root * normal).sum(axis=1).round(DIGITS)
            found = value(self.mean + self.step * move)
            if found is not None:
                moves.append(move)
                values.append(found)
            if len(values) == self.size:
                break
        half = self.weights.size
        if len(values) < half:
            self.step *= NARROWER
            return
        chosen = np.array(moves)[ranked(values)[:half]]
        shift = (self.weights[:, None] * chosen).sum(axis=0)
        self.mean = self.mean + self.step * shift
        self._adapt(chosen, shift, (inverse * shift).sum(axis=1))

    def _adapt(self, chosen: FloatArray, shift: FloatArray, whitened: FloatArray) -> None:
        n = self.mean.size
        self.generation += 1
        keep, gain = self.step_fade, self.fade * (2.0 - self.fade)
        self.straight = (1.0 - keep) * self.straight
        self.straight += sqrt(keep * (2.0 - keep) * self.mass) * whitened
        length = sqrt(float((self.straight**2).sum()))
        settled = length / sqrt(1.0 - (1.0 - keep) ** (2 * self.generation))
        calm = float(settled < (1.4 + 2.0 / (n + 1.0)) * self.length)
        self.path = (1.0 - self.fade) * self.path + calm * sqrt(gain * self.mass) * shift
        kept = 1.0 - self.rank_one - self.rank + self.rank_one * (1.0 - calm) * gain
        squares = self.weights[:, None, None] * chosen[:, :, None] * chosen[:, None, :]
        self.covariance = (
            kept * self.covariance + self.rank_one * (self.path[:, None] * self.path)
            + self.rank * squares.sum(axis=0)
        )
        growth = exp(keep / self.damping * (length / self.length - 1.0))
        self.step *= round(growth, EXACT_DIGITS)

    @property
    def settled(self) -> bool:
        """Whether the samples hardly differ any more."""
        largest = float(self.covariance.diagonal().max())
        return self.step * sqrt(largest) < SMALLEST_STEP


def roots(matrix: FloatArray) -> tuple[FloatArray, FloatArray]:
    """The symmetric root of a positive definite matrix (n, n) and its inverse.

    Newton's method without inverses (N. Higham, Functions of Matrices, 2008, eq. 6.35).
    """
    one = np.eye(len(matrix))
    scale = float(matrix.trace())
    root, inverse = matrix / scale + SHARE * one, one
    for _ in range(STEPS):
        step = 1.5 * one - 0.5 * _product(inverse, root)
        root, inverse = _product(root, step), _product(step, inverse)
        if float(np.abs(step - one).max()) < LAST:
            break
    return sqrt(scale) * root, inverse / sqrt(scale)


def _product(one: FloatArray, other: FloatArray) -> FloatArray:
    """Of two matrices, in an order of sums that no library chooses."""
    product: FloatArray = (one[:, :, None] * other).sum(axis=1)
    return product
