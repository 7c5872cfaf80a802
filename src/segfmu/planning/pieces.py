"""Polynomial pieces of all axes: parts of a motion before they are a trajectory."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from segfmu.arrays import FloatArray
from segfmu.kernels import backend
from segfmu.kernels.planner.records import DelayedState
from segfmu.kernels.trajectory.records import Timing


@dataclass(frozen=True, eq=False)
class Pieces:
    """Polynomial pieces of all axes, as in `Trajectory`.

    Attributes
    ----------
    timing : ndarray, shape (rows, 2)
    coefficients : ndarray, shape (rows, 2 * smoothness)
    offsets : ndarray of int, shape (axes + 1,)
    """

    timing: FloatArray
    coefficients: FloatArray
    offsets: NDArray[np.int64]

    @staticmethod
    def none(axes: int, smoothness: int) -> Pieces:
        """No pieces at all."""
        return Pieces(
            np.zeros((1, Timing.SIZE)), np.zeros((1, 2 * smoothness)),
            np.zeros(axes + 1, dtype=np.int64),
        )

    @staticmethod
    def one(timing: FloatArray, coefficients: FloatArray, count: int) -> Pieces:
        """The first `count` pieces as those of one axis."""
        offsets = np.array([0, count], dtype=np.int64)
        return Pieces(timing[:count].copy(), coefficients[:count].copy(), offsets)

    @staticmethod
    def together(parts: list[Pieces], width: int) -> Pieces:
        """Pieces of single axes as those of several."""
        offsets = np.cumsum([0, *(part.used for part in parts)], dtype=np.int64)
        if offsets[-1] == 0:
            return Pieces.none(len(parts), width // 2)
        return Pieces(
            np.concatenate([part.timing for part in parts]),
            np.concatenate([part.coefficients for part in parts]), offsets,
        )

    def axis(self, axis: int) -> Pieces:
        """The pieces of one axis."""
        first, last = self.offsets[axis], self.offsets[axis + 1]
        return Pieces.one(self.timing[first:], self.coefficients[first:], int(last - first))

    def ends(self) -> FloatArray:
        """Where the last piece of every axis ends, and when, shape (axes, DelayedState)."""
        ends = np.zeros((self.offsets.size - 1, DelayedState.SIZE))
        backend.plan_ends(self.timing, self.coefficients, self.offsets, ends)
        return ends

    def stops(self) -> FloatArray:
        """When the last piece of each axis ends [s], shape (axes,)."""
        stops: FloatArray = self.timing[self.offsets[1:] - 1].sum(axis=1)
        return stops

    def resting(self, dwell: float) -> Pieces:
        """The same; each axis rests at its end, in its last piece, for at least `dwell` [s]."""
        timing = self.timing.copy()
        last = self.offsets[1:] - 1
        timing[last, 1] = np.maximum(timing[last, 1], dwell)
        return replace(self, timing=timing)

    def meeting(self, clock: float, dwell: float) -> Pieces:
        """The same; axes that end together up to the rounding of a clock [s] do so without.

        dwell: of the last waypoint [s].
        """
        timing = self.timing.copy()
        backend.meet_ends(clock, dwell, timing, self.offsets)
        return replace(self, timing=timing)

    def anchored(self, ends: FloatArray, limits: FloatArray) -> Pieces:
        """The same, changed by rounding errors: each axis ends exactly in `ends` (axes, ..)."""
        coefficients = self.coefficients.copy()
        backend.anchor_plan(ends, limits, self.timing, coefficients, self.offsets)
        return replace(self, coefficients=coefficients)

    def starts(self) -> FloatArray:
        """Position and the derivatives 1 .. n of every axis at its start, shape (axes, n + 1)."""
        # in a third of the time of an index
        first = self.coefficients.take(self.offsets[:-1], axis=0)
        width = first.shape[1] // 2 + 1
        return first[:, :width] * _factorials(width)

    @property
    def used(self) -> int:
        """Number of the pieces; there may be more rows."""
        return int(self.offsets[-1])

    def after(self, first: Pieces) -> Pieces:
        """These pieces behind those of `first`, axis by axis; times stay as they are."""
        rows = max(self.used, first.used)
        timing = np.empty((2 * rows, Timing.SIZE))
        coefficients = np.empty((2 * rows, self.coefficients.shape[1]))
        offsets = np.zeros_like(self.offsets)
        used = backend.join_plans(
            *first._padded(rows), *self._padded(rows), timing, coefficients, offsets
        )
        return Pieces(timing[:used], coefficients[:used], offsets)

    def _padded(self, rows: int) -> tuple[FloatArray, FloatArray, NDArray[np.int64]]:
        if len(self.timing) >= rows:
            return self.timing[:rows], self.coefficients[:rows], self.offsets
        timing = np.zeros((rows, Timing.SIZE))
        coefficients = np.zeros((rows, self.coefficients.shape[1]))
        timing[: self.used] = self.timing[: self.used]
        coefficients[: self.used] = self.coefficients[: self.used]
        return timing, coefficients, self.offsets


@lru_cache(maxsize=8)
def _factorials(count: int) -> FloatArray:
    """0! .. (count - 1)!, shape (count,)."""
    return np.cumprod([1.0, *range(1, count)])
