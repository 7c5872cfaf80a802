"""The planned trajectory: piecewise polynomials, with exact values and extrema."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from segfmu.arrays import FloatArray, as_index, finite_number, finite_times
from segfmu.errors import InputError
from segfmu.kernels import backend
from segfmu.planning.limits import Limits
from segfmu.planning.polynomials import extrema, inside_from
from segfmu.planning.sketch import sketch
from segfmu.planning.waypoint import Waypoint, waypoint_of


@dataclass(frozen=True, eq=False, repr=False, init=False)
class Trajectory:
    """A trajectory y*(t) of several axes, y in C^n with n = `smoothness`.

    Attributes
    ----------
    waypoints, limits, smoothness, shape, synchronize
        Arguments of `plan`.
    timing : ndarray, shape (pieces, 2)
        Start and length of the polynomial pieces, axis after axis [s].
    coefficients : ndarray, shape (pieces, 2 * smoothness)
        Position in the local time of each piece, ascending powers.
    offsets : ndarray of int, shape (axes + 1,)
        First piece of each axis.
    axis_waypoint_times : ndarray, shape (waypoints, axes)
        Arrival of each axis at each waypoint [s].
    axis_durations : ndarray, shape (axes,)
        End of the motion of each axis [s].
    """

    waypoints: tuple[Waypoint, ...]
    limits: Limits
    smoothness: int
    shape: str
    synchronize: str
    axis_names: tuple[str, ...]
    timing: FloatArray
    coefficients: FloatArray
    offsets: NDArray[np.int64]
    axis_waypoint_times: FloatArray
    axis_durations: FloatArray

    def __init__(
        self, waypoints: tuple[Waypoint, ...], limits: Limits, smoothness: int, shape: str,
        synchronize: str, axis_names: tuple[str, ...], timing: FloatArray, coefficients: FloatArray,
        offsets: NDArray[np.int64], axis_waypoint_times: FloatArray, axis_durations: FloatArray,
    ) -> None:
        # all at once: one assignment a field, as frozen classes make them, takes a microsecond
        vars(self).update(
            waypoints=waypoints, limits=limits, smoothness=smoothness, shape=shape,
            synchronize=synchronize, axis_names=axis_names, timing=timing,
            coefficients=coefficients, offsets=offsets, axis_waypoint_times=axis_waypoint_times,
            axis_durations=axis_durations,
        )

    def __repr__(self) -> str:
        outside = float(self.outside.max())
        beyond = f", outside limits for {outside:.6g} s" if outside > 0.0 else ""
        return (
            f"<Trajectory of {', '.join(self.axis_names)}: {len(self.waypoints)} waypoints, "
            f"{self.duration:.6g} s, smoothness {self.smoothness}, {self.shape}{beyond}>"
        )

    def _repr_svg_(self) -> str:
        """The picture that notebooks show."""
        return sketch(self, repr(self).strip("<>"))

    @property
    def axes(self) -> int:
        """Number of axes."""
        return int(self.offsets.size - 1)

    @property
    def duration(self) -> float:
        """Time from the first waypoint to the end of the motion [s]."""
        return float(self.axis_durations.max())

    @property
    def waypoint_times(self) -> FloatArray:
        """Time at which the last axis arrives at each waypoint [s], shape (waypoints,)."""
        times: FloatArray = self.axis_waypoint_times.max(axis=1)
        return times

    @property
    def outside(self) -> FloatArray:
        """Time from which on each axis is inside its limits, to 1e-9 [s], shape (axes,).

        It is 0 but for plans that begin in a state which cannot keep them.
        """
        limits = self.limits.table(self.axes, self.smoothness)
        lower = limits.copy()
        lower[:, :2] = self.limits.lower(self.axes)
        share = 1.0 + 1e-9
        times = np.zeros(self.axes)
        for axis in range(self.axes):
            starts, lengths, coefficients = self.pieces(axis)
            for order, limit in enumerate(limits[axis].tolist(), 1):
                if limit > 0.0:
                    least, most = -share * float(lower[axis, order - 1]), share * limit
                    found = inside_from(starts, lengths, coefficients, order, least, most)
                    times[axis] = max(times[axis], found)
        return times

    def __call__(self, t: ArrayLike, derivative: int = 0) -> FloatArray:
        """Value of a derivative at times t.

        Parameters
        ----------
        t : array_like, shape (...)
            Times [s]. Before its start and after its end an axis stays in its end position.
        derivative : int
            0 position [m], 1 velocity [m/s], ...

        Returns
        -------
        ndarray, shape (..., axes)

        Raises
        ------
        InputError
            For times that are not finite numbers and a derivative below 0.
        """
        times = finite_times(t)
        derivative = as_index("derivative", derivative)
        flat = np.ascontiguousarray(times.reshape(-1))
        values = np.zeros((flat.size, self.axes))
        if derivative < self.coefficients.shape[1]:
            backend.evaluate(
                flat, self.timing, self.coefficients, self.offsets, self.axis_durations,
                derivative, values,
            )
        return values.reshape((*times.shape, self.axes))

    def state(self, t: float) -> Waypoint:
        """Position and all continuous derivatives at a time, as the start of another plan.

        Parameters
        ----------
        t : float
            Time [s]. Before its start and after its end an axis rests in its end position.

        Returns
        -------
        Waypoint
            With vectors of shape (axes,).

        Raises
        ------
        InputError
            If t is not one finite number.
        """
        states = np.zeros((self.smoothness + 1, self.axes))
        backend.evaluate_orders(
            finite_number("t", t), self.timing, self.coefficients, self.offsets,
            self.axis_durations, states,
        )
        return waypoint_of(states.T)

    def pieces(self, axis: int) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Starts (pieces,), lengths (pieces,) and coefficients (pieces, width) of one axis.

        Raises
        ------
        InputError
            If there is no such axis.
        """
        axis = as_index("axis", axis, self.axes - 1)
        rows = slice(int(self.offsets[axis]), int(self.offsets[axis + 1]))
        return self.timing[rows, 0], self.timing[rows, 1], self.coefficients[rows]

    def extrema(self, derivative: int) -> tuple[FloatArray, FloatArray]:
        """Exact minimum and maximum of a derivative, each of shape (axes,).

        Raises
        ------
        InputError
            If the derivative is not an integer from 0.
        """
        derivative = as_index("derivative", derivative)
        bounds = np.empty((self.axes, 2))
        for axis in range(self.axes):
            _, lengths, coefficients = self.pieces(axis)
            bounds[axis] = extrema(coefficients, lengths, derivative)
        return bounds[:, 0], bounds[:, 1]

    @property
    def events(self) -> FloatArray:
        """Times [s], ascending, at which a step of a simulation should end, shape (events,).

        These are the last axis' arrival at each waypoint, the end of the motion, and the ends of
        all polynomial pieces, where a derivative of the crane's forces jumps: at smoothness 4 the
        first one.
        """
        times = [self.next_event(-1.0)]
        while times[-1] < np.inf:
            times.append(self.next_event(times[-1]))
        return np.array(times[:-1])

    def next_event(self, t: float) -> float:
        """First of the `events` after a time t [s]; infinite after the last one.

        Raises
        ------
        InputError
            If t is not one finite number.
        """
        time = backend.next_plan_event(
            finite_number("t", t), 0.0, self.timing, self.offsets, self.axis_durations,
            self.axis_waypoint_times,
        )
        return float(time) if time < 1e300 else np.inf

    def interval(self, t: float) -> int:
        """Waypoint interval, from 1, at a time t [s]; a dwell belongs to the next interval.

        Raises
        ------
        InputError
            If t is not one finite number.
        """
        passed = int(np.searchsorted(self.waypoint_times, finite_number("t", t), side="right"))
        return min(max(passed, 1), len(self.waypoints) - 1)


def require_plan(trajectory: Trajectory) -> None:
    """Raise InputError for anything but a Trajectory."""
    if not isinstance(trajectory, Trajectory):
        raise InputError(f"trajectory must be a plan, got {type(trajectory).__name__}")
