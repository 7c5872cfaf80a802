"""Minimisation by evolution of samples with an adapted covariance (CMA-ES).

N. Hansen, The CMA Evolution Strategy: A Tutorial, arXiv:1604.00772. Only the order of the values
counts, so values may be of any kind that can be compared, and kinks and plateaus do no harm. Places
without a value are sampled again. The random numbers are seeded: the same problem has the same
result, also where linear algebra rounds in another way.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from segfmu.planning.arrays import FloatArray

SMALLEST_STEP = 1e-4
# samples of a generation over its size, at most; and the step's factor where too few have a value
SAMPLES = 3
NARROWER = 0.7
# decimals of moves in standard deviations: rounding errors of processors must not decide
DIGITS = 6


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
        self.size = 4 + int(3.0 * np.log(n))
        half = self.size // 2
        weights = np.log(half + 0.5) - np.log(np.arange(1, half + 1))
        self.weights = weights / weights.sum()
        self.mass = 1.0 / float((self.weights**2).sum())
        self.covariance = np.eye(n)
        self.paths = np.zeros((2, n))
        self.generation = 0
        self.random = np.random.default_rng(2)
        mass = self.mass
        self.fade = (4.0 + mass / n) / (n + 4.0 + 2.0 * mass / n)
        self.step_fade = (mass + 2.0) / (n + mass + 5.0)
        self.damping = 1.0 + 2.0 * max(0.0, ((mass - 1.0) / (n + 1.0)) ** 0.5 - 1.0)
        self.damping += self.step_fade
        self.rank_one = 2.0 / ((n + 1.3) ** 2 + mass)
        rank = 2.0 * (mass - 2.0 + 1.0 / mass) / ((n + 2.0) ** 2 + mass)
        self.rank = min(1.0 - self.rank_one, rank)
        self.length = n**0.5 * (1.0 - 0.25 / n + 1.0 / (21.0 * n * n))

    def advance(self, value: Callable[[FloatArray], Any]) -> None:
        """Sample one generation, judge it by `value`, and adapt mean, step and covariance.

        Where less than half a generation has a value other than None, the step shrinks instead.
        """
        n = self.mean.size
        spread, axes = np.linalg.eigh(self.covariance)
        spread = np.sqrt(np.maximum(spread, 1e-20))
        # unlike its eigenvectors, the root of the covariance is unique
        root = (axes * spread) @ axes.T
        moves, values = [], []
        for _ in range(SAMPLES * self.size):
            move = np.round(root @ self.random.standard_normal(n), DIGITS)
            found = value(self.mean + self.step * move)
            if found is not None:
                moves.append(move)
                values.append(found)
            if len(values) == self.size:
                break
        if len(values) < self.weights.size:
            self.step *= NARROWER
            return
        order = sorted(range(len(values)), key=values.__getitem__)
        chosen = np.array(moves)[order[: self.weights.size]]
        shift = self.weights @ chosen
        self.mean = self.mean + self.step * shift
        self._adapt(chosen, shift, axes @ ((axes.T @ shift) / spread))

    def _adapt(self, chosen: FloatArray, shift: FloatArray, whitened: FloatArray) -> None:
        n = self.mean.size
        self.generation += 1
        straight, path = self.paths
        keep = self.step_fade
        straight = (1.0 - keep) * straight + (keep * (2.0 - keep) * self.mass) ** 0.5 * whitened
        length = float(np.linalg.norm(straight))
        settled = length / (1.0 - (1.0 - keep) ** (2 * self.generation)) ** 0.5
        calm = float(settled < (1.4 + 2.0 / (n + 1.0)) * self.length)
        path = (1.0 - self.fade) * path
        path = path + calm * (self.fade * (2.0 - self.fade) * self.mass) ** 0.5 * shift
        self.paths = np.array([straight, path])
        lost = self.rank_one * (1.0 - calm) * self.fade * (2.0 - self.fade)
        self.covariance = (
            (1.0 - self.rank_one - self.rank + lost) * self.covariance
            + self.rank_one * np.outer(path, path)
            + self.rank * (chosen.T * self.weights) @ chosen
        )
        self.step *= float(np.exp(keep / self.damping * (length / self.length - 1.0)))

    @property
    def settled(self) -> bool:
        """Whether the samples hardly differ any more."""
        largest = float(self.covariance.diagonal().max()) ** 0.5
        return bool(self.step * largest < SMALLEST_STEP)
