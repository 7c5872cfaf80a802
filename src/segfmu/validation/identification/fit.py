"""Least squares of measured minus simulated signals, with intervals, and what no signal shows.

L. Ljung: System Identification: Theory for the User, 2nd edition, 1999, chapters 7 (the
output-error model), 9 (covariance of the estimates) and 14. All unknowns are in units of their
scales, in which one is a large change.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence

import numpy as np
from scipy.optimize import least_squares

from segfmu.arrays import FloatArray
from segfmu.errors import InputError
from segfmu.validation.identification.found import Direction, Fit
from segfmu.validation.identification.log import Log
from segfmu.validation.identification.model import Model
from segfmu.validation.identification.noise import dependence, noise_of, rough_noise
from segfmu.validation.identification.slopes import Slopes
from segfmu.validation.identification.thinned import thinned
from segfmu.validation.identification.unknowns import Unknowns

CONFIDENCE = 0.95
# parts of the logs that are fitted one after the other, from the first share on, each longer by the
# factor: over a long one, a start that is far away has sways whose periods are counted wrongly, or
# a load that falls. A part that the crane cannot do yet is longer by the square root, down to LEAST
FIRST, GROWTH, LEAST = 1.0 / 30.0, 1.8, 1.02
# how far from the crane file unknowns are expected to be: so far that it only counts where the
# signals say nothing, which otherwise has no solution; and the same while parts of logs are fitted
EXPECTED, EXPECTED_EARLY = 10.0, 1.0
# half of an interval from which on a combination of unknowns counts as untold
UNTOLD = 1.0
# a parameter takes part in such a combination with more than this share
PART = 0.1
# noise has settled when it changes by a smaller share, after so many fits
SETTLED, MOST_FITS = 0.02, 5
# of a fit and of those of parts: a change of the sum of squares by this share ends them
TOLERANCE, TOLERANCE_EARLY = 1e-7, 1e-3
# steps of such a fit, at most: where the model lacks what the crane has, small ones go on for long
MOST_STEPS = 60


class Problem:
    """Fits unknowns to logs; all of its work is in units of their scales.

    period: of the pendulum [s]; the search finds its way by logs with no more rows than it needs.
    """

    def __init__(
        self, model: Model, logs: Sequence[Log], unknowns: Unknowns, period: float
    ) -> None:
        self._model, self._logs, self._unknowns = model, logs, unknowns
        self._few = [thinned(log, period) for log in logs]
        self._free = list(range(unknowns.size))
        self._noise = [rough_noise(log) for log in logs]
        self._directions: list[Direction] = []
        self._expected, self._converged = EXPECTED, True
        self._slopes = Slopes(self._of_log, unknowns)

    def fit(
        self, begin: FloatArray | None = None,
        progress: Callable[[float], None] = lambda _: None,
    ) -> Fit:
        """Fit, and hold one unknown after the other until the signals tell those that are left.

        begin: where a second search begins, beside that from fits of parts of the logs; the better
        one counts. Dry friction makes valleys: at other dead times an axis sticks at other turns.

        Raises
        ------
        InputError
            If the crane of the file cannot do what the log has.
        """
        point, kept = self._better(self._grown(progress), begin), set[int]()
        if self._few != self._logs:
            few = self._settled(point, self._few)
            point = few if self._possible(few, 1.0) else point
        point = self._settled(point, self._logs)
        while (direction := self._untold(point, kept)) is not None:
            without = self._without(point, direction)
            if without is None:
                kept.add(direction.held)
            else:
                point = self._settled(without, self._logs)
        return self._result(point)

    def _without(self, point: FloatArray, direction: Direction) -> FloatArray | None:
        """A fit with an unknown held; None if the signals contradict the value that it then has.

        Near the best point they may tell little of what they tell at that value, as of friction
        with which an axis slides where it would stick.
        """
        before, free, slopes = self._cost(point), list(self._free), self._slopes.copy()
        limit = (self._student() * self._depends(point)) ** 2
        self._free.remove(direction.held)
        start = point.copy()
        start[direction.held] = 0.0
        found = self._solved(
            start if self._possible(start, 1.0) else self._grown(), self._logs, TOLERANCE
        )
        if self._cost(found) > before + limit:
            self._free, self._slopes = free, slopes
            return None
        self._directions.append(direction)
        return found

    def _cost(self, point: FloatArray) -> float:
        found = self._residuals(point, self._logs)
        return float(found @ found)

    def _depends(self, point: FloatArray) -> float:
        """The root of the greatest number of samples that count as one."""
        return float(np.sqrt(max(
            self._dependence(point, i, log).max() for i, log in enumerate(self._logs)
        )))

    def _student(self) -> float:
        from scipy.stats import t as student

        return float(student.ppf(0.5 + 0.5 * CONFIDENCE, self._left()))

    def begin(self, progress: Callable[[float], None] = lambda _: None) -> FloatArray:
        """A first fit of all unknowns; raises as `fit`."""
        return self._solved(self._grown(progress), self._few, TOLERANCE)

    def _better(self, one: FloatArray, other: FloatArray | None) -> FloatArray:
        """Of the valleys of two points the deeper one."""
        points = [p for p in (one, other) if p is not None and self._possible(p, 1.0)]
        found = [self._solved(point, self._few, TOLERANCE) for point in points]
        # what few rows lead to may be impossible between them
        return min([*found, *points], key=self._cost)

    def _grown(self, progress: Callable[[float], None] = lambda _: None) -> FloatArray:
        """Fit longer and longer parts of the logs; the point for the longest but the whole."""
        point = np.zeros(self._unknowns.size)
        self._expected, share = EXPECTED_EARLY, FIRST
        if not self._possible(point, share):
            self._refuse(point, share)
        while share < 1.0:
            point = self._solved(point, self._parts(share), TOLERANCE_EARLY)
            progress(share)
            factor = GROWTH
            while not self._possible(point, min(share * factor, 1.0)):
                factor = np.sqrt(factor)
                if factor < LEAST:
                    point, factor = self._anew(point, min(share * GROWTH, 1.0)), GROWTH
            share = min(share * factor, 1.0)
        self._expected = EXPECTED
        return point

    def _anew(self, point: FloatArray, share: float) -> FloatArray:
        """Where the search began, as a short part may lead it astray; raises as `fit`."""
        begin = np.zeros(self._unknowns.size)
        if not self._possible(begin, share):
            self._refuse(point, share)
        return begin

    def _possible(self, point: FloatArray, share: float) -> bool:
        return bool(np.isfinite(self._residuals(point, self._parts(share))).all())

    def _parts(self, share: float) -> Sequence[Log]:
        if share == 1.0:
            return self._logs
        return [log.rows(0, max(3, round(share * log.times.size))) for log in self._few]

    def _settled(self, point: FloatArray, logs: Sequence[Log]) -> FloatArray:
        """Fit with the noise that the residuals themselves have."""
        for _ in range(MOST_FITS):
            point = self._solved(point, logs, TOLERANCE)
            before, self._noise = np.array(self._noise), self._residual_noise(point, logs)
            if np.nanmax(np.abs(np.array(self._noise) / before - 1.0)) < SETTLED:
                break
        return point

    def _residual_noise(self, point: FloatArray, logs: Sequence[Log]) -> list[FloatArray]:
        # each signal bears its share of the unknowns
        left = 1.0 - len(self._free) / _samples(logs)
        return [
            noise_of(log, self._simulated(point, i, log)) / np.sqrt(left)
            for i, log in enumerate(logs)
        ]

    def _solved(self, point: FloatArray, logs: Sequence[Log], tolerance: float) -> FloatArray:
        free = self._free
        low, high = self._unknowns.low[free], self._unknowns.high[free]
        found = point.copy()

        def at(values: FloatArray) -> FloatArray:
            full = point.copy()
            full[free] = values
            return full

        # what noise leaves, so that a search without any does not go on below it
        left, none = np.sqrt(_samples(logs)), np.zeros((1, len(free)))
        solution = least_squares(
            lambda z: np.append(self._residuals(at(z), logs), left),
            np.clip(point[free], low, high),
            lambda z: np.concatenate([self._jacobian(at(z), logs), none]), (low, high),
            ftol=tolerance, xtol=tolerance, gtol=None, max_nfev=MOST_STEPS,
        )
        self._converged = solution.status > 0
        found[free] = solution.x
        return found

    def _simulated(self, point: FloatArray, place: int, log: Log) -> FloatArray:
        own = self._unknowns
        return self._model.run(log, own.changes(point, self._free), own.start(point, place))

    def _of_log(self, point: FloatArray, place: int, log: Log) -> FloatArray:
        """Residuals of a log in units of the noise; infinite for a crane that cannot do this."""
        own, known = self._unknowns, log.known
        found = self._model.attempt(log, own.changes(point, self._free), own.start(point, place))
        if found is None:
            return np.full(log.times.size * len(known), np.inf)
        away = (found - log.measured)[:, known] / self._noise[place][known]
        return away.ravel()

    def _residuals(self, point: FloatArray, logs: Sequence[Log]) -> FloatArray:
        parts = [self._of_log(point, i, log) for i, log in enumerate(logs)]
        return np.concatenate([*parts, point[self._free] / self._expected])

    def _refuse(self, point: FloatArray, share: float) -> None:
        """Tell why the crane cannot do what a log has."""
        for i, log in enumerate(self._parts(share)):
            try:
                self._simulated(point, i, log)
            except Exception as error:
                raise InputError(
                    f"{log.name}: the crane, with what was fitted so far, cannot do what the log "
                    f"has: {error}; check the units of the columns, SI and rad, and name values in "
                    "the crane file that are nearer"
                ) from None

    def _jacobian(self, point: FloatArray, logs: Sequence[Log]) -> FloatArray:
        blocks = self._blocks(point, logs)
        return np.concatenate([*blocks, np.eye(len(self._free)) / self._expected])

    def _blocks(self, point: FloatArray, logs: Sequence[Log]) -> list[FloatArray]:
        # parts of logs are fitted roughly
        rough = self._expected == EXPECTED_EARLY
        return self._slopes.blocks(point, logs, self._free, rough)

    def _untold(self, point: FloatArray, kept: Collection[int]) -> Direction | None:
        """The combination of unknowns that the signals tell least, if they do not tell it.

        Those that are kept are not held instead of others.
        """
        matrix = np.concatenate([
            block / np.sqrt(self._dependence(point, i, log))[:, None]
            for i, (block, log) in enumerate(
                zip(self._blocks(point, self._logs), self._logs, strict=True)
            )
        ])
        _, values, rows = np.linalg.svd(matrix, full_matrices=False)
        for size, weights in zip(values[::-1], rows[::-1], strict=True):
            if self._student() < UNTOLD * size:
                return None
            order = np.argsort(-np.abs(weights), kind="stable")
            parts = [(self._free[i], float(weights[i])) for i in order if abs(weights[i]) > PART]
            # of a parameter and a start that are one, the parameter is what is not told
            owned = [place for place, _ in parts if self._unknowns.of_log(place) is None]
            for held in owned or [parts[0][0]]:
                if held not in kept:
                    return Direction(held, tuple(parts))
        return None

    def _dependence(self, point: FloatArray, place: int, log: Log) -> FloatArray:
        """Of the rows of a log's residuals: how many samples count as one."""
        away = self._simulated(point, place, log) - log.measured
        factors = np.array([dependence(away[:, signal]) for signal in log.known])
        return np.tile(factors, log.times.size)

    def _left(self) -> int:
        return _samples(self._logs) - len(self._free)

    def _result(self, point: FloatArray) -> Fit:
        """Intervals by the covariance of the estimates, with noise whose samples may depend."""
        count = len(self._free)
        told, spread = np.eye(count) / EXPECTED**2, np.zeros((count, count))
        blocks = self._blocks(point, self._logs)
        for i, (block, log) in enumerate(zip(blocks, self._logs, strict=True)):
            told += block.T @ block
            spread += block.T @ (self._dependence(point, i, log)[:, None] * block)
        # signals of very different noise make numbers of very different size
        size = np.sqrt(np.diag(told))
        inverse = np.linalg.inv(told / np.outer(size, size)) / np.outer(size, size)
        deviations = np.sqrt(np.diag(inverse @ spread @ inverse))
        half = np.full(point.size, np.nan)
        half[self._free] = self._student() * deviations
        return Fit(
            point, half, tuple(self._free), tuple(self._directions), self._noise, self._converged
        )


def _samples(logs: Sequence[Log]) -> int:
    """Their number, of all signals."""
    return sum(log.times.size * len(log.known) for log in logs)
