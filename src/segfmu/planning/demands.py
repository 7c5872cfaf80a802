"""What every plan has to keep: its limits, waypoints and range; errors say where it does not."""

from __future__ import annotations

import numpy as np

from segfmu.arrays import FloatArray
from segfmu.errors import InfeasibleError
from segfmu.planning.limits import NAMES, UNITS
from segfmu.planning.messages import SCALE, told_apart
from segfmu.planning.polynomials import derivative_pieces, piece_turns
from segfmu.planning.trajectory import Trajectory
from segfmu.planning.verify import TOLERANCE, Verification, piece_ends, verify


def require(trajectory: Trajectory) -> None:
    """Raise InfeasibleError when a trajectory breaks a limit or misses a waypoint by over 1e-9."""
    found = verify(trajectory)
    if found.passed:
        return
    over = np.argwhere(found.usage > 1.0 + TOLERANCE)
    if over.size == 0:
        raise _missed(trajectory, found)
    order, axis = (int(i) for i in over[0])
    name, unit = NAMES[order], UNITS[order]
    value, bound = float(found.peaks[order, axis]), float(found.limits[order, axis])
    # the peak is that of the direction that uses more
    sign = 1.0 if trajectory.extrema(order + 1)[1][axis] == value else -1.0
    time = _reached(trajectory, axis, order + 1, sign)
    name = trajectory.limits.named(name, axis, sign)
    digits = told_apart(value, bound, 9)
    text = (
        f"the plan reaches {name} {value:.{digits}g} {unit} at {time:.3f} s, limit "
        f"{bound:.{digits}g} {unit}; raise limits.{name}"
    )
    raise _beyond(trajectory, axis, name, value, bound, time, text)


def require_positions(trajectory: Trajectory, allowed: FloatArray) -> None:
    """Raise InfeasibleError when an axis leaves its range, (axes, 2), infinite for no bound."""
    low, high = trajectory.extrema(0)
    for name, bounds, reached, sign in (
        ("position_min", allowed[:, 0], low, -1.0), ("position_max", allowed[:, 1], high, 1.0),
    ):
        margin = position_margin(bounds)
        for axis in np.flatnonzero(sign * (reached - bounds) > margin).tolist():
            time = _reached(trajectory, axis, 0, sign)
            value, bound = float(reached[axis]), float(bounds[axis])
            digits = told_apart(value, bound, 9)
            text = (
                f"position reaches {value:.{digits}g} m at {time:.3f} s, {name} is "
                f"{bound:.{digits}g} m; move the waypoints or slow them down"
            )
            raise _beyond(trajectory, axis, name, value, bound, time, text)


def position_margin(bounds: FloatArray) -> FloatArray:
    """By how much rounding may exceed bounds of a position [m], any shape."""
    known = np.where(np.isfinite(bounds), np.abs(bounds), 0.0)
    margin: FloatArray = 1e-12 * np.maximum(known, 1.0)
    return margin


def _beyond(
    trajectory: Trajectory, axis: int, limit: str, value: float, bound: float, time: float,
    text: str,
) -> InfeasibleError:
    interval = _interval(trajectory, axis, time)
    return InfeasibleError(
        f"axis {trajectory.axis_names[axis]}, waypoints {interval} -> {interval + 1}: {text}",
        axis=axis, interval=interval, limit=limit, value=value, bound=bound, time=time,
    )


def _missed(trajectory: Trajectory, found: Verification) -> InfeasibleError:
    """The error for a plan that keeps its limits and nevertheless fails."""
    missed, jumps = ~(found.waypoint_errors <= TOLERANCE), ~(found.jumps <= TOLERANCE)
    if missed.any():
        point, axis = (int(i) for i in np.argwhere(missed)[0])
        # a waypoint belongs to the interval that ends there
        interval, time = max(point, 1), float(trajectory.axis_waypoint_times[point, axis])
        place = f"waypoint {point + 1}"
        fault = f"misses the waypoint by {found.waypoint_errors[point, axis]:.3g}"
    elif jumps.any():
        order, axis = (int(i) for i in np.argwhere(jumps)[0])
        left, right = piece_ends(trajectory, axis, order + 1)
        row = int(np.argmax(np.abs(left[order, 1:] - right[order, :-1]))) + 1
        time = float(trajectory.pieces(axis)[0][row])
        interval = _interval(trajectory, axis, time)
        place = f"waypoints {interval} -> {interval + 1}"
        fault = f"jumps by {found.jumps[order, axis]:.3g} in {('position', *NAMES)[order]}"
    else:
        return InfeasibleError(f"times err by {found.time_error:.3g} of the duration: {SCALE}")
    return InfeasibleError(
        f"axis {trajectory.axis_names[axis]}, {place}: the plan {fault} (relative) at "
        f"{time:.6g} s: {SCALE}",
        axis=axis, interval=interval, time=time,
    )


def _reached(trajectory: Trajectory, axis: int, derivative: int, sign: float) -> float:
    """First time of the largest value of a derivative, or with sign -1 of the smallest one."""
    starts, lengths, coefficients = trajectory.pieces(axis)
    best, time = -np.inf, 0.0
    pieces = derivative_pieces(coefficients, derivative)
    for piece, start, length in zip(pieces, starts.tolist(), lengths.tolist(), strict=True):
        shares, values = piece_turns(piece, length)
        row = int(np.argmax(sign * values))
        if sign * values[row] > best:
            best, time = sign * values[row], start + length * float(shares[row])
    return time


def _interval(trajectory: Trajectory, axis: int, time: float) -> int:
    """Waypoint interval of an axis, from 1; a waypoint belongs to the one that ends there."""
    passed = int(np.searchsorted(trajectory.axis_waypoint_times[:, axis], time))
    return min(max(passed, 1), len(trajectory.waypoints) - 1)
