"""Motions of one axis within limits and a range of positions, as splines (kernels/spline)."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from segfmu.arrays import FloatArray
from segfmu.kernels import backend
from segfmu.kernels.planner.records import Axis, Lower
from segfmu.kernels.spline.records import Derivatives, Mesh, SplineWork
from segfmu.kernels.trajectory.records import PieceState, Timing


class AxisBounds(NamedTuple):
    """What one axis keeps.

    Attributes
    ----------
    limits : ndarray, shape (n + 1,)
        Of the derivatives 1 .. n + 1, 0 where absent.
    lower : ndarray, shape (2,)
        Magnitudes of those of velocity and acceleration in the negative direction.
    allowed : ndarray, shape (2,)
        Range of the positions [m], infinite for no bound.
    """

    limits: FloatArray
    lower: FloatArray
    allowed: FloatArray


def spline_motion(
    first: FloatArray, last: FloatArray, bounds: AxisBounds, duration: float
) -> FloatArray | None:
    """The motion between two states that uses least of its highest limit; None if none is found.

    Parameters
    ----------
    first, last : ndarray, shape (n + 1,)
        Position and the derivatives 1 .. n [m, m/s, ...].
    bounds : AxisBounds
    duration : float
        Of the motion [s].

    Returns
    -------
    ndarray, shape (Mesh.CELLS, 2 n)
        Position in the local time of equally long pieces, ascending powers.
    """
    share, *found = _least_share(first, last, bounds, duration, highest=True)
    if share > 1.0:
        return None
    pieces = np.zeros((Mesh.CELLS, 2 * first.size - 2))
    begin, end, work = found
    timing, state = np.zeros((Mesh.CELLS, Timing.SIZE)), np.zeros(PieceState.SIZE)
    state[: first.size] = first
    backend.append_spline(duration, begin, end, timing, pieces, 0, state, work)
    return pieces


def spline_use(
    first: FloatArray, last: FloatArray, bounds: AxisBounds, duration: float
) -> float:
    """The least share of all limits and of the range that a motion needs; above 1 there is none.

    Arguments as for `spline_motion`. It is continuous in the duration.
    """
    return _least_share(first, last, bounds, duration, highest=False)[0]


def _least_share(
    first: FloatArray, last: FloatArray, bounds: AxisBounds, duration: float, *, highest: bool
) -> tuple[float, FloatArray, FloatArray, FloatArray]:
    """The kernel's least share, its states at the ends and its work space."""
    n = first.size - 1
    axis = np.zeros(Axis.SIZE)
    axis[Axis.SMOOTHNESS] = n
    axis[Axis.VELOCITY : Axis.VELOCITY + n + 1] = bounds.limits
    axis[Axis.LOWER : Axis.LOWER + Lower.SIZE] = bounds.lower
    begin, end = np.zeros((2, Derivatives.SIZE))
    begin[: n + 1], end[: n + 1] = first, last
    work = np.zeros((SplineWork.SIZE, SplineWork.COLUMNS))
    share = backend.spline_share(highest, duration, begin, end, bounds.allowed, axis, work)
    return share, begin, end, work
