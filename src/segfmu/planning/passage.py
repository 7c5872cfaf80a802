"""Passages: waypoints with free states between two whose states are given.

Each is planned on its own. Axes that do not meet in the waypoints have passages of their own.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from segfmu.kernels.planner.records import WaypointState
from segfmu.planning.arrays import FloatArray
from segfmu.planning.polynomials import extrema
from segfmu.planning.problem import Phases, Problem, expand_phases, plan_phases

# rounding errors of positions, in units of the range of all of them
MARGIN = 1e-9


@dataclass(frozen=True, eq=False)
class Passage:
    """Waypoints in a row; the states of the first and the last one are given.

    Attributes
    ----------
    waypoints, axes : slice
        Which ones of the request.
    problem : Problem
        These alone, all axes on common durations, at rest where the states are free.
    free : ndarray of bool, shape (waypoints, axes, 2)
        Which velocities and accelerations are free.
    box : ndarray, shape (intervals, axes, 2)
        Range of the positions in each interval; infinite where there is none.
    ramps : ndarray, shape (axes, Axis)
        Parameters of the ramps at rest. Some states can be braked with steeper ramps only, which
        the whole axis would take then; these states are not considered.
    """

    waypoints: slice
    axes: slice
    problem: Problem
    free: NDArray[np.bool_]
    box: FloatArray
    ramps: FloatArray

    def with_states(self, states: FloatArray) -> Problem:
        """The problem with velocities and accelerations, shape (waypoints, axes, 2)."""
        positions = self.problem.states[:, :, :WaypointState.VELOCITY]
        return self.problem._replace(states=np.concatenate([positions, states], axis=2))

    def least_durations(self, states: FloatArray) -> FloatArray:
        """Shortest duration of every interval of every axis on its own [s]; infinite: none."""
        options = replace(self.problem.options, synchronize="none")
        return self._durations(self.with_states(states)._replace(options=options))

    def durations(self, states: FloatArray) -> FloatArray:
        """Duration of every interval [s]; infinite: none."""
        return np.asarray(self._durations(self.with_states(states)).max(axis=1))

    def quick_total(self, states: FloatArray, bound: float) -> float:
        """Sum of the durations [s]; infinite where an axis on its own takes more than `bound`.

        The search for a common duration is the expensive part.
        """
        if not self.least_durations(states).max(axis=1).sum() < bound:
            return float(np.inf)
        return float(self.durations(states).sum())

    def around(self, point: int) -> Passage:
        """The passage from the waypoint before to the one after a waypoint."""
        rows, intervals = slice(point - 1, point + 2), slice(point - 1, point + 1)
        problem = self.problem._replace(states=self.problem.states[rows], dwells=np.zeros(3))
        return replace(self, problem=problem, free=self.free[rows], box=self.box[intervals])

    def _durations(self, problem: Problem) -> FloatArray:
        phases = plan_phases(problem)
        if self._usual(phases):
            return phases.durations
        found = np.full((len(problem.states) - 1, problem.states.shape[1]), np.inf)
        for i in range(len(found)):
            phases = plan_phases(
                problem._replace(states=problem.states[i:i + 2], dwells=np.zeros(2))
            )
            if self._usual(phases):
                found[i] = phases.durations
        return found

    def _usual(self, phases: Phases) -> bool:
        return phases.feasible and np.array_equal(phases.axes, self.ramps)

    def beyond(self, states: FloatArray) -> NDArray[np.bool_]:
        """Intervals (intervals,) in which the plan leaves the range of the positions."""
        if not np.isfinite(self.box).any():
            return np.zeros(len(self.box), dtype=np.bool_)
        problem = self.with_states(states)
        phases = plan_phases(problem)
        if not phases.feasible:
            return np.ones(len(self.box), dtype=np.bool_)
        ranges = _ranges(problem, phases)
        margin = MARGIN * np.ptp(self.box[np.isfinite(self.box)])
        low, high = self.box[..., 0] - margin, self.box[..., 1] + margin
        return np.asarray(((ranges[..., 0] < low) | (ranges[..., 1] > high)).any(axis=1))


def passages(
    problem: Problem, free: NDArray[np.bool_], overshoot: float, allowed: FloatArray
) -> Iterator[Passage]:
    """The passages of a problem whose free states, shape (waypoints, axes, 2), are at rest.

    allowed : ndarray, shape (axes, 2)
        Range of the positions [m].
    """
    count = problem.states.shape[1]
    meeting = problem.options.synchronize == "waypoints"
    groups = [slice(0, count)] if meeting else [slice(axis, axis + 1) for axis in range(count)]
    options = replace(
        problem.options, synchronize="waypoints", sample_time=0.0, duration=0.0
    )
    for axes in groups:
        positions = problem.states[:, axes, WaypointState.POSITION]
        chosen = free[:, axes].copy()
        # nothing moves between two waypoints at the same place
        staying = np.flatnonzero((np.diff(positions, axis=0) == 0.0).all(axis=1))
        chosen[staying] = chosen[staying + 1] = False
        box = _within(_neighbourhoods(positions, overshoot), allowed[axes], positions)
        given = np.flatnonzero(~chosen.any(axis=(1, 2)))
        for first, last in pairwise(given):
            if last == first + 1:
                continue
            rows = slice(int(first), int(last) + 1)
            states = problem.states[rows, axes].copy()
            part = Problem(
                states, np.zeros(len(states)), problem.limits[axes], problem.lower[axes], options
            )
            inside = box[first:last]
            yield Passage(rows, axes, part, _admitted(chosen[rows], inside, positions[rows]),
                          _widened(inside, part), plan_phases(part).axes)


def _neighbourhoods(positions: FloatArray, overshoot: float) -> FloatArray:
    """Range (intervals, axes, 2) of two waypoints, the one before and the one after them.

    On both sides a share of the range is added.
    """
    if overshoot == np.inf:
        everywhere = np.array([-np.inf, np.inf])
        return np.broadcast_to(everywhere, (len(positions) - 1, positions.shape[1], 2))
    padded = np.concatenate([positions[:1], positions, positions[-1:]])
    stacked = np.stack([padded[k:len(padded) - 3 + k] for k in range(4)])
    low, high = stacked.min(axis=0), stacked.max(axis=0)
    beyond = overshoot * (high - low)
    return np.stack([low - beyond, high + beyond], axis=2)


def _within(box: FloatArray, allowed: FloatArray, positions: FloatArray) -> FloatArray:
    """The part of the box that is allowed (axes, 2), its waypoints included."""
    ends = np.stack([positions[:-1], positions[1:]])
    # plans may leave the box by the margin
    inwards = 2.0 * MARGIN * np.ptp(positions, axis=0)
    low = np.minimum(np.maximum(box[..., 0], allowed[:, 0] + inwards), ends.min(axis=0))
    high = np.maximum(np.minimum(box[..., 1], allowed[:, 1] - inwards), ends.max(axis=0))
    return np.stack([low, high], axis=2)


def _admitted(
    free: NDArray[np.bool_], box: FloatArray, positions: FloatArray
) -> NDArray[np.bool_]:
    """Without velocities where a motion would leave the range, and axes that may not move."""
    inner = positions[1:-1, :, None]
    turning = (inner == box[:-1]).any(axis=2) | (inner == box[1:]).any(axis=2)
    fixed = (box[:-1, :, 0] == box[:-1, :, 1]) | (box[1:, :, 0] == box[1:, :, 1])
    free = free.copy()
    free[1:-1, :, 0] &= ~turning
    free[1:-1, :, 1] &= ~fixed
    return free


def _widened(box: FloatArray, problem: Problem) -> FloatArray:
    """The range, with what given states need: that of the plan that rests at the free ones."""
    if not np.isfinite(box).any():
        return box
    given = problem.states[[0, -1], :, WaypointState.VELOCITY:]
    inner = problem.states[1:-1, :, WaypointState.VELOCITY:]
    if not given.any() and not inner.any():
        return box
    phases = plan_phases(problem)
    if not phases.feasible:
        return np.broadcast_to([-np.inf, np.inf], box.shape)
    ranges = _ranges(problem, phases)
    return np.stack([
        np.minimum(box[..., 0], ranges[..., 0]), np.maximum(box[..., 1], ranges[..., 1])
    ], axis=2)


def _ranges(problem: Problem, phases: Phases) -> FloatArray:
    """Range (intervals, axes, 2) of the positions of a plan."""
    timing, coefficients, offsets, times = expand_phases(problem, phases)
    intervals, axes = phases.durations.shape
    positions = problem.states[:, :, WaypointState.POSITION]
    ends = np.stack([positions[:-1], positions[1:]], axis=2)
    ranges = np.stack([ends.min(axis=2), ends.max(axis=2)], axis=2)
    for axis in range(axes):
        rows = slice(int(offsets[axis]), int(offsets[axis + 1]))
        starts, lengths = timing[rows].T
        # a piece belongs to the interval that its middle is in
        place = np.searchsorted(times[1:-2, axis], starts + 0.5 * lengths)
        for i in range(intervals):
            chosen = place == i
            # an interval of no duration has no pieces
            if chosen.any():
                ranges[i, axis] = extrema(coefficients[rows][chosen], lengths[chosen], 0)
    return ranges
