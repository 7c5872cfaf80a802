"""Independent verification of a trajectory: exact extrema, waypoints, continuity and times.

It reads only the polynomial pieces, nothing from the planner. Outside the limits may be only the
first moments of a plan whose first state cannot keep them: no longer and no farther than the brake
of that state (kernels/settling/brake.py).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from segfmu.arrays import FloatArray
from segfmu.kernels.planner.records import Lower
from segfmu.kernels.trajectory.records import Brake
from segfmu.planning.brake import find_brakes
from segfmu.planning.polynomials import derivative_pieces, extrema, split
from segfmu.planning.trajectory import Trajectory, require_plan
from segfmu.planning.whole import require_whole

TOLERANCE = 1e-9
# of times, which nothing but rounding changes
TIME_TOLERANCE = 1e-12
# relative error of a position by rounding
ROUNDING = 1e-14


@dataclass(frozen=True, eq=False)
class Verification:
    """What `verify` measured.

    Attributes
    ----------
    peaks : ndarray, shape (smoothness + 1, axes)
        Largest magnitude of the derivatives 1 .. smoothness + 1, from `outside` on, in the
        direction that uses more of its limit.
    outside : ndarray, shape (axes,)
        Time in which a first state that cannot keep the limits is brought inside [s], else 0. It
        follows from that state alone, not from the trajectory.
    excess : ndarray, shape (smoothness + 1, axes)
        Largest magnitude of the derivatives until then, as a multiple of what bringing the state
        inside as soon as possible needs, or of the limit if that is larger; in the direction with
        the larger multiple.
    limits : ndarray, shape (smoothness + 1, axes)
        Magnitudes of their limits in that direction, infinite where absent.
    waypoint_errors : ndarray, shape (waypoints, axes)
        Largest deviation from a waypoint's state on arrival and during its dwell. Units are the
        distance covered (position) and the limits, or the peaks where there is no limit or it
        cannot be reached in time. A peak counts as at least 1e-5 of its limit, or of what other
        limits imply.
    jumps : ndarray, shape (smoothness + 1, axes)
        Largest jump of the derivatives 0 .. smoothness at a switching time, in units of the
        distance covered (position) and of the peak, counted in the same way.
    time_error : float
        Largest error of the times in units of the duration: gaps and overlaps between pieces,
        starts other than 0, ends other than `axis_durations`, dwells that are left early, and axes
        that do not meet where `synchronize` asks for it.
    """

    peaks: FloatArray
    outside: FloatArray
    excess: FloatArray
    limits: FloatArray
    waypoint_errors: FloatArray
    jumps: FloatArray
    time_error: float

    @property
    def usage(self) -> FloatArray:
        """Peaks over limits, shape (smoothness + 1, axes)."""
        with np.errstate(all="ignore"):
            usage: FloatArray = self.peaks / self.limits
        return usage

    @property
    def waypoint_error(self) -> float:
        """Largest of the `waypoint_errors`."""
        return float(np.max(self.waypoint_errors))

    @property
    def passed(self) -> bool:
        """Whether limits, waypoints and smoothness hold to 1e-9, times to 1e-12."""
        return bool(
            (self.usage <= 1.0 + TOLERANCE).all()
            and (self.excess <= 1.0 + TOLERANCE).all()
            and self.waypoint_error <= TOLERANCE
            and (self.jumps <= TOLERANCE).all()
            and self.time_error <= TIME_TOLERANCE
        )


def verify(trajectory: Trajectory) -> Verification:
    """Measure a trajectory against its limits, its waypoints, its smoothness and its times.

    The extrema are exact: those of every polynomial piece. Nothing is planned again.

    Parameters
    ----------
    trajectory : Trajectory
        Of `plan`, or changed since.

    Returns
    -------
    Verification
        With `passed` and everything measured.

    Raises
    ------
    InputError
        If it is not a Trajectory, or one whose attributes are of other types or do not belong
        together.
    """
    require_plan(trajectory)
    require_whole(trajectory)
    # overflow gives inf or nan, and nan does not pass
    with np.errstate(all="ignore"):
        return _measured(trajectory)


def _measured(trajectory: Trajectory) -> Verification:
    order = trajectory.smoothness
    table = trajectory.limits.table(trajectory.axes, order).T
    upper = np.where(table > 0.0, table, np.inf)
    lower = upper.copy()
    lower[:2] = trajectory.limits.lower(trajectory.axes).T
    extremes = [trajectory.extrema(d) for d in range(1, order + 2)]
    lows, highs = (np.array([pair[end] for pair in extremes]) for end in (0, 1))
    peaks, limits = _fuller(lows, highs, lower, upper)
    outside, excess = np.zeros(trajectory.axes), np.zeros_like(peaks)
    counted = peaks
    if not (peaks <= limits * (1.0 + TOLERANCE)).all():
        outside, excess = _braked(trajectory, lows, highs)
        peaks, limits = _fuller(lows, highs, lower, upper)
    low, high = trajectory.extrema(0)
    # where the position is large, its rounding is a part of the distance that counts
    rounding = ROUNDING / TOLERANCE * np.maximum(np.abs(low), np.abs(high))
    distance = np.maximum.reduce([high - low, rounding, _least_distance(limits)])
    counted = np.maximum(counted, ROUNDING / TOLERANCE * _implied(limits))
    scales = np.vstack([distance, np.minimum(limits, counted)])
    return Verification(
        peaks, outside, excess, limits, _waypoint_errors(trajectory, limits, scales),
        _jumps(trajectory, scales),
        time_error(trajectory),
    )


def _fuller(
    lows: FloatArray, highs: FloatArray, lower: FloatArray, upper: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """Peaks and their limits (Verification) from the extrema and the limits in both directions."""
    absent = ~np.isfinite(upper)
    below = -lows * np.where(absent, 1.0, upper) > highs * np.where(absent, 1.0, lower)
    peaks: FloatArray = np.where(np.isnan(lows), lows, np.where(below, -lows, highs))
    return peaks, np.where(below, lower, upper)


def _braked(
    trajectory: Trajectory, lows: FloatArray, highs: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """Times outside and excess (Verification) of a first state outside its limits.

    The extrema of the derivatives, each (smoothness + 1, axes), become those from then on.
    """
    table = trajectory.limits.table(trajectory.axes, trajectory.smoothness)
    lower = trajectory.limits.lower(trajectory.axes)
    states = trajectory.waypoints[0].state(trajectory.smoothness)
    brakes = find_brakes(states, table, lower)
    outside, excess = brakes[:, Brake.UNTIL], np.zeros_like(lows)
    for axis in np.flatnonzero(outside > 0.0).tolist():
        first, rest = split(*trajectory.pieces(axis), float(outside[axis]))
        for order, limit in enumerate(table[axis].tolist(), 1):
            below = float(lower[axis, order - 1]) if order <= Lower.SIZE else limit
            least = min(-below, float(brakes[axis, Brake.LOWEST + order]))
            most = max(limit, float(brakes[axis, Brake.HIGHEST + order]))
            low, high = _range(first, order)
            lows[order - 1, axis], highs[order - 1, axis] = _range(rest, order)
            if limit > 0.0:
                excess[order - 1, axis] = max(low / least, high / most)
    return outside, excess


def _range(pieces: tuple[FloatArray, FloatArray], order: int) -> tuple[float, float]:
    """Minimum and maximum of a derivative in some pieces, 0 without a piece."""
    lengths, coefficients = pieces
    return extrema(coefficients, lengths, order) if lengths.size > 0 else (0.0, 0.0)


def _least_distance(limits: FloatArray) -> FloatArray:
    """The least distance that counts: a billionth of that from full speed to rest.

    A velocity limit far beyond what ramps of the acceleration reach is none.
    """
    ramp = np.zeros(limits.shape[1])
    for i, bound in enumerate(limits[2:4]):
        time = (limits[1] / bound) ** (1.0 / (i + 1))
        ramp = np.maximum(ramp, limits[1] * time**2)
    scale = limits[0] ** 2 / limits[1]
    least: FloatArray = TOLERANCE * np.where(ramp > 0.0, np.minimum(scale, 1e3 * ramp), scale)
    return least


def _implied(limits: FloatArray) -> FloatArray:
    """The limits; an absent one lets the derivative below change as fast as the one below that."""
    implied = limits.copy()
    for i in range(2, len(limits)):
        absent = ~np.isfinite(limits[i])
        implied[i, absent] = implied[i - 1, absent] ** 2 / implied[i - 2, absent]
    return implied


def _reached(limits: FloatArray, durations: FloatArray) -> FloatArray:
    """The limits, or what those above them permit to reach within the durations, if that is less.

    A limit that is meant as none can be far beyond that.
    """
    reached = limits.copy()
    for i in range(len(limits) - 1, 0, -1):
        reached[i - 1] = np.fmin(limits[i - 1], reached[i] * durations)
    return reached


def piece_ends(trajectory: Trajectory, axis: int, count: int) -> tuple[FloatArray, FloatArray]:
    """Derivatives 0 .. count - 1 at both ends of every piece, each (count, pieces)."""
    _, lengths, coefficients = trajectory.pieces(axis)
    left = np.empty((count, lengths.size))
    right = np.empty((count, lengths.size))
    for d in range(count):
        piece = derivative_pieces(coefficients, d)
        left[d] = piece[:, 0]
        right[d] = np.sum(piece * lengths[:, None] ** np.arange(piece.shape[1]), axis=1)
    return left, right


def _relative(error: FloatArray, scale: FloatArray) -> FloatArray:
    """error / scale, 0 without an error; a scale of 0 admits none."""
    with np.errstate(all="ignore"):
        relative: FloatArray = np.where(error == 0.0, 0.0, error / scale)
    return relative


def _jumps(trajectory: Trajectory, scales: FloatArray) -> FloatArray:
    order = trajectory.smoothness
    jumps = np.zeros((order + 1, trajectory.axes))
    for axis in range(trajectory.axes):
        left, right = piece_ends(trajectory, axis, order + 1)
        if left.shape[1] > 1:
            found = np.abs(left[:, 1:] - right[:, :-1]).max(axis=1)
            jumps[:, axis] = _relative(found, scales[: order + 1, axis])
    return jumps


def _waypoint_errors(trajectory: Trajectory, limits: FloatArray, scales: FloatArray) -> FloatArray:
    errors = np.zeros((len(trajectory.waypoints), trajectory.axes))
    reached = _reached(limits, trajectory.axis_durations)
    for axis in range(trajectory.axes):
        left, right = piece_ends(trajectory, axis, trajectory.smoothness + 1)
        bounds = np.where(
            np.isfinite(limits[:-1, axis]),
            np.maximum(scales[1:-1, axis], reached[:-1, axis]), scales[1:-1, axis],
        )
        scale = np.concatenate([scales[:1, axis], bounds])
        for j, waypoint in enumerate(trajectory.waypoints):
            time = float(trajectory.axis_waypoint_times[j, axis])
            asked = waypoint.state(trajectory.smoothness)[axis]
            found = []
            for first, last in _touched(trajectory, axis, time, waypoint.dwell):
                # from where it arrives to where it leaves: both sides, and all pieces between
                sides = np.hstack([right[:, max(first - 1, 0) : last], left[:, first : last + 1]])
                error = _largest(_relative(np.abs(sides - asked[:, None]), scale[:, None]))
                if last > first:
                    moved = _moved(trajectory, axis, slice(first, last)) / scales[0, axis]
                    error = max(error, moved)
                found.append(error)
            errors[j, axis] = min(found)
    return errors


def _touched(trajectory: Trajectory, axis: int, time: float, dwell: float) -> list[tuple[int, int]]:
    """The piece of an axis that starts at `time`, and the one that starts after the dwell.

    There are several where the clock is too coarse to tell short pieces apart.
    """
    starts, lengths, _ = trajectory.pieces(axis)
    switches = np.append(starts, starts[-1] + lengths[-1])
    arrival, leaving = (np.abs(switches - t) for t in (time, time + dwell))
    same = 4.0 * np.finfo(float).eps * abs(time)
    if dwell > 0.0 or np.isnan(arrival).any():
        return [(int(np.argmin(arrival)), int(np.argmin(leaving)))]
    return [(int(i), int(i)) for i in np.flatnonzero(arrival <= arrival.min() + same)]


def _moved(trajectory: Trajectory, axis: int, rows: slice) -> float:
    """Range of the position in some pieces of an axis."""
    _, lengths, coefficients = trajectory.pieces(axis)
    low, high = extrema(coefficients[rows], lengths[rows], 0)
    return high - low


def _largest(values: list[float] | FloatArray) -> float:
    """The largest value; NaN if one is."""
    return float(np.max(values))


def time_error(trajectory: Trajectory) -> float:
    """Largest error of the times (Verification), in units of the duration."""
    arrivals, ends = trajectory.axis_waypoint_times, trajectory.axis_durations
    dwells = np.array([waypoint.dwell for waypoint in trajectory.waypoints])
    errors = [float(np.max(np.abs(arrivals[0])))]
    for axis in range(trajectory.axes):
        starts, lengths, _ = trajectory.pieces(axis)
        stops = starts + lengths
        errors += [abs(float(starts[0])), abs(float(stops[-1] - ends[axis]))]
        errors += [float(np.max(np.abs(starts[1:] - stops[:-1]), initial=0.0))]
        errors += [float(np.max(-lengths, initial=0.0))]
        switches = np.append(starts, stops[-1])
        leaving = arrivals[:, axis] + dwells
        errors += [float(np.min(np.abs(switches - t))) for t in (*arrivals[:, axis], *leaving)]
        errors += [abs(float(leaving[-1] - ends[axis]))]
        errors += np.maximum(leaving[:-1] - arrivals[1:, axis], 0.0).tolist()
    if trajectory.synchronize == "waypoints":
        errors += np.ptp(arrivals, axis=1).tolist()
    if trajectory.synchronize != "none":
        errors.append(float(np.ptp(ends)))
    largest = np.array(_largest(errors))
    return float(_relative(largest, np.array(trajectory.duration)))
