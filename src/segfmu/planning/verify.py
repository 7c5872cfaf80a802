"""Independent verification of a trajectory: exact extrema, waypoints and continuity.

It reads only the polynomial pieces, nothing from the planner.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from segfmu.errors import InfeasibleError, InputError
from segfmu.planning.arrays import FloatArray
from segfmu.planning.limits import NAMES, UNITS
from segfmu.planning.polynomials import derivative_pieces
from segfmu.planning.trajectory import Trajectory

TOLERANCE = 1e-9


@dataclass(frozen=True, eq=False)
class Verification:
    """What `verify` measured.

    Attributes
    ----------
    peaks : ndarray, shape (smoothness + 1, axes)
        Largest magnitude of the derivatives 1 .. smoothness + 1.
    limits : ndarray, shape (smoothness + 1, axes)
        Their limits, infinite where absent.
    waypoint_error : float
        Largest deviation from a waypoint's position, velocity and acceleration, each in units of
        the distance covered (at least 1 m), the velocity and the acceleration limit.
    jumps : ndarray, shape (smoothness + 1, axes)
        Largest jump of the derivatives 0 .. smoothness at a switching time, in units of the limit
        or, where there is none, of the peak.
    """

    peaks: FloatArray
    limits: FloatArray
    waypoint_error: float
    jumps: FloatArray

    @property
    def usage(self) -> FloatArray:
        """Peaks over limits, shape (smoothness + 1, axes)."""
        with np.errstate(all="ignore"):
            usage: FloatArray = self.peaks / self.limits
        return usage

    @property
    def passed(self) -> bool:
        """Whether limits, waypoints and smoothness hold to 1e-9."""
        return bool(
            (self.usage <= 1.0 + TOLERANCE).all()
            and self.waypoint_error <= TOLERANCE
            and (self.jumps <= TOLERANCE).all()
        )


def verify(trajectory: Trajectory) -> Verification:
    """Measure a trajectory against its limits, its waypoints and its smoothness."""
    if not isinstance(trajectory, Trajectory):
        raise InputError(f"trajectory must be a plan, got {type(trajectory).__name__}")
    # overflow gives inf or nan, and nan does not pass
    with np.errstate(all="ignore"):
        return _measured(trajectory)


def _measured(trajectory: Trajectory) -> Verification:
    order = trajectory.smoothness
    table = trajectory.limits.table(trajectory.axes, order).T
    limits = np.where(table > 0.0, table, np.inf)
    peaks = np.array([_magnitude(trajectory, d) for d in range(1, order + 2)])
    return Verification(
        peaks, limits, _waypoint_error(trajectory, limits), _jumps(trajectory, limits, peaks)
    )


def _magnitude(trajectory: Trajectory, derivative: int) -> FloatArray:
    low, high = trajectory.extrema(derivative)
    magnitude: FloatArray = np.maximum(-low, high)
    return magnitude


def _states(trajectory: Trajectory, axis: int, count: int) -> tuple[FloatArray, FloatArray]:
    """Derivatives 0 .. count - 1 at both ends of every piece, each (count, pieces)."""
    _, lengths, coefficients = trajectory.pieces(axis)
    left = np.empty((count, lengths.size))
    right = np.empty((count, lengths.size))
    for d in range(count):
        piece = derivative_pieces(coefficients, d)
        left[d] = piece[:, 0]
        right[d] = np.sum(piece * lengths[:, None] ** np.arange(piece.shape[1]), axis=1)
    return left, right


def _jumps(trajectory: Trajectory, limits: FloatArray, peaks: FloatArray) -> FloatArray:
    order = trajectory.smoothness
    jumps = np.zeros((order + 1, trajectory.axes))
    low, high = trajectory.extrema(0)
    scales = np.vstack([np.maximum(high - low, 1.0), np.minimum(limits, peaks)[:order]])
    for axis in range(trajectory.axes):
        left, right = _states(trajectory, axis, order + 1)
        if left.shape[1] > 1:
            found = np.abs(left[:, 1:] - right[:, :-1]).max(axis=1)
            scale = scales[:, axis]
            jumps[:, axis] = np.where(found > 0.0, found / np.where(scale > 0.0, scale, 1.0), 0.0)
    return jumps


def _waypoint_error(trajectory: Trajectory, limits: FloatArray) -> float:
    worst = 0.0
    for axis in range(trajectory.axes):
        starts = trajectory.pieces(axis)[0]
        left, right = _states(trajectory, axis, 3)
        low, high = trajectory.extrema(0)
        scale = np.array([max(high[axis] - low[axis], 1.0), limits[0, axis], limits[1, axis]])
        for j, waypoint in enumerate(trajectory.waypoints):
            time = trajectory.axis_waypoint_times[j, axis]
            row = int(np.searchsorted(starts, time, side="left"))
            asked = np.array(
                [waypoint.position[axis], waypoint.velocity[axis], waypoint.acceleration[axis]]
            )
            sides = [left[:, row]] if row < starts.size else []
            sides += [right[:, row - 1]] if row > 0 else []
            worst = max([worst, *(float(np.max(np.abs(s - asked) / scale)) for s in sides)])
    return worst


def require(trajectory: Trajectory) -> None:
    """Raise InfeasibleError when a trajectory breaks a limit or misses a waypoint by over 1e-9."""
    found = verify(trajectory)
    if found.passed:
        return
    over = np.argwhere(found.usage > 1.0 + TOLERANCE)
    if over.size:
        order, axis = (int(i) for i in over[0])
        name, unit = NAMES[order], UNITS[order]
        value, bound = float(found.peaks[order, axis]), float(found.limits[order, axis])
        raise InfeasibleError(
            f"axis {trajectory.axis_names[axis]}: the plan reaches {name} "
            f"{value:.9g} {unit}, limit {bound:.9g} {unit}; raise limits.{name}",
            axis=axis, limit=name, value=value, bound=bound,
        )
    raise InfeasibleError(
        f"the plan misses a waypoint by {found.waypoint_error:.3g} or jumps by "
        f"{float(found.jumps.max()):.3g} (relative): the problem is badly scaled; "
        "choose limits and distances of similar size"
    )
