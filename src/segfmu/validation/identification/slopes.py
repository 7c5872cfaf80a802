"""Derivatives of residuals by differences whose steps are as long as the noise asks for."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from segfmu.arrays import FloatArray
from segfmu.validation.identification.log import Log
from segfmu.validation.identification.unknowns import Unknowns

# of differences: the first ones, and the longest. Others move the residuals by MOVED, about as much
# as noise makes of the unknown: the integration of dry friction has a noise of its own, about 1e-3
# of this, which short differences take for a slope
STEP, LONGEST_STEP = 1e-4, 0.1
MOVED, MOVED_LEAST, MOVED_MOST = 1.0, 0.3, 3.0
# of a point, by the place of a log: the log's residuals
OfLog = Callable[[FloatArray, int, Log], FloatArray]


class Slopes:
    """Differences of the residuals of logs, with steps that are learnt.

    Parameters
    ----------
    of_log : callable
        The residuals of a log in units of the noise; infinite for a crane that cannot do this.
    unknowns : Unknowns
    """

    def __init__(self, of_log: OfLog, unknowns: Unknowns) -> None:
        self._of_log, self._unknowns = of_log, unknowns
        # by logs and unknowns
        self._steps = np.full((unknowns.logs, unknowns.size), STEP)

    def copy(self) -> Slopes:
        """The same with the steps of now."""
        other = Slopes(self._of_log, self._unknowns)
        other._steps = self._steps.copy()
        return other

    def blocks(
        self, point: FloatArray, logs: Sequence[Log], free: Sequence[int], rough: bool
    ) -> list[FloatArray]:
        """Derivatives of the residuals of every log, shape (rows * signals, free unknowns).

        rough: steps are as they are.
        """
        blocks = []
        for i, log in enumerate(logs):
            base = self._of_log(point, i, log)
            block = np.zeros((base.size, len(free)))
            for column, place in enumerate(free):
                if self._unknowns.of_log(place) in (None, i):
                    block[:, column] = self._slope(point, i, log, place, base, rough)
            blocks.append(block)
        return blocks

    def _slope(
        self, point: FloatArray, log_place: int, log: Log, place: int, base: FloatArray,
        rough: bool,
    ) -> FloatArray:
        """Difference with a step that moves the residuals enough; 0 where the crane cannot go."""
        found, moved = self._difference(point, log_place, log, place, base)
        if rough or MOVED_LEAST <= moved <= MOVED_MOST:
            return found
        before = self._steps[log_place, place]
        step = before * MOVED / moved if moved > 0.0 else LONGEST_STEP
        self._steps[log_place, place] = min(step, LONGEST_STEP)
        if self._steps[log_place, place] == before:
            return found
        return self._difference(point, log_place, log, place, base)[0]

    def _difference(
        self, point: FloatArray, log_place: int, log: Log, place: int, base: FloatArray
    ) -> tuple[FloatArray, float]:
        """Slope away from the nearer bound, else to the other side, and how far this moves."""
        size = self._steps[log_place, place]
        first = size if self._unknowns.high[place] - point[place] > size else -size
        for step in (first, -first):
            moved = point.copy()
            moved[place] += step
            change = self._of_log(moved, log_place, log) - base
            if np.isfinite(change).all():
                return change / step, float(np.linalg.norm(change))
        return np.zeros_like(base), MOVED
