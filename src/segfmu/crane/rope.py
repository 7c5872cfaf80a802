"""Refusal of trajectories along which the rope goes slack or leaves its range.

kernels/crane/rope.py does the check.
"""

from __future__ import annotations

from typing import Protocol, runtime_checkable

import numpy as np
from numpy.typing import ArrayLike, NDArray

from segfmu.arrays import FloatArray
from segfmu.crane.parameters import Crane
from segfmu.errors import InfeasibleError
from segfmu.kernels import backend
from segfmu.kernels.crane.records import RopeDemand, RopeFault, RopeWork
from segfmu.kernels.messages import ROPE, ROPE_LIMITS
from segfmu.planning.messages import text_apart


@runtime_checkable
class LoadTrajectory(Protocol):
    """The interface of a load trajectory that the inverse needs."""

    @property
    def axes(self) -> int:
        """Number of axes."""

    @property
    def duration(self) -> float:
        """Its end [s]."""

    @property
    def smoothness(self) -> int:
        """n: the trajectory is n times continuously differentiable."""

    def __call__(self, t: ArrayLike, derivative: int = 0) -> FloatArray:
        """Value of a derivative, shape (..., axes)."""

    def pieces(self, axis: int) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Starts (pieces,), lengths (pieces,) and ascending coefficients (pieces, width)."""


def joined_pieces(
    trajectory: LoadTrajectory, width: int = 0
) -> tuple[FloatArray, FloatArray, NDArray[np.int64]]:
    """Pieces of the three axes below each other, as kernels take them.

    Starts and lengths (pieces, 2) [s], ascending coefficients (pieces, at least `width`), and the
    row at which each axis begins, with the number of rows behind the last one, (4,).
    """
    pieces = [trajectory.pieces(axis) for axis in range(3)]
    offsets = np.cumsum([0, *(starts.size for starts, _, _ in pieces)], dtype=np.int64)
    # filled in place, as searches look at thousands of plans
    timing = np.empty((offsets[-1], 2))
    coefficients = np.zeros((offsets[-1], max(width, *(own.shape[1] for _, _, own in pieces))))
    for first, (starts, lengths, own) in zip(offsets, pieces, strict=False):
        rows = slice(first, first + starts.size)
        timing[rows, 0], timing[rows, 1] = starts, lengths
        coefficients[rows, : own.shape[1]] = own
    return timing, coefficients, offsets


def require_rope(crane: Crane, trajectory: LoadTrajectory) -> None:
    """Check that the load stays below the trolley, the rope taut and its length in range.

    Raises
    ------
    InfeasibleError
        With the first time of a violation, and the worst value after it.
    """
    timing, coefficients, offsets = joined_pieces(trajectory, 4)
    report = np.zeros(RopeFault.SIZE)
    status = backend.check_rope(
        timing, coefficients, offsets, rope_bounds(crane), rope_work(coefficients), report
    )
    require_met(status, report)


def rope_bounds(crane: Crane) -> FloatArray:
    """The kernels' `RopeBounds`."""
    return np.array([crane.gravity, crane.rope_min or 0.0, crane.rope_max or 0.0])


def rope_work(coefficients: FloatArray) -> FloatArray:
    """The kernels' `RopeWork` for pieces with these coefficients."""
    return np.zeros((RopeWork.SIZE, 4 * coefficients.shape[1] - 5))


def require_met(status: int, report: FloatArray) -> None:
    """Raise InfeasibleError for a `RopeDemand` that is not met, with its `RopeFault`."""
    if status != RopeDemand.MET:
        time, worst, bound = report.tolist()
        raise InfeasibleError(
            text_apart(ROPE, status, (time, worst, bound), ("WORST", "BOUND")),
            limit=ROPE_LIMITS[status], value=worst, bound=bound, time=time,
        )
