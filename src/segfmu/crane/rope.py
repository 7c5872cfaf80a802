"""Refusal of trajectories along which the rope goes slack or leaves its range.

kernels/crane/rope.py does the check, with a hook kernels/hook/rope.py.
"""

from __future__ import annotations

from typing import Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

from segfmu.crane.hook import HookCrane
from segfmu.crane.parameters import Crane
from segfmu.errors import InfeasibleError
from segfmu.kernels import backend
from segfmu.kernels.crane.records import RopeDemand, RopeFault, RopeWork
from segfmu.kernels.hook.records import HookPath
from segfmu.kernels.messages import ROPE, ROPE_LIMITS
from segfmu.planning.arrays import FloatArray
from segfmu.planning.messages import text_apart


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
        timing, coefficients, offsets, _bounds(crane), _work(coefficients), report
    )
    _require_met(status, report)


def require_hook(hook: HookCrane, trajectory: LoadTrajectory) -> None:
    """Check the same of the hook, and that the sling stays taut.

    Raises
    ------
    InfeasibleError
        As `require_rope`.
    """
    timing, coefficients, offsets = joined_pieces(trajectory, 4)
    report = np.zeros(RopeFault.SIZE)
    status = backend.check_hook(
        timing, coefficients, offsets, timing[offsets[1:] - 1].sum(axis=1),
        np.array(hook.crane.masses), *hook.hook, _bounds(hook.crane), _work(coefficients),
        np.zeros((HookPath.SIZE, HookPath.COLUMNS)), report,
    )
    _require_met(status, report)


def _bounds(crane: Crane) -> FloatArray:
    return np.array([crane.gravity, crane.rope_min or 0.0, crane.rope_max or 0.0])


def _work(coefficients: FloatArray) -> FloatArray:
    return np.zeros((RopeWork.SIZE, 4 * coefficients.shape[1] - 5))


def _require_met(status: int, report: FloatArray) -> None:
    if status != RopeDemand.MET:
        time, worst, bound = report.tolist()
        raise InfeasibleError(
            text_apart(ROPE, status, (time, worst, bound), ("WORST", "BOUND")),
            limit=ROPE_LIMITS[status], value=worst, bound=bound, time=time,
        )
