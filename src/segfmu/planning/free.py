"""Choice of free waypoint velocities and accelerations, by the kernels of `passage`."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from segfmu.arrays import FloatArray
from segfmu.kernels import backend
from segfmu.kernels.passage.records import Block, Link, Path, Spot, Stretch, Tools, Track
from segfmu.kernels.planner.records import Cell, WaypointState
from segfmu.kernels.trajectory.records import MotionWork, Spare, Timing
from segfmu.planning.problem import Problem
from segfmu.planning.repeats import united
from segfmu.planning.request import Request, with_states

Progress = Callable[[int, int], None]

# share of the range of its neighbours by which an axis may leave it
OVERSHOOT = backend.usual_room()
# the kernels' word for no bound
EVERYWHERE = 1e307


def choose_states(
    request: Request, overshoot: float = OVERSHOOT, progress: Progress | None = None,
    allowed: FloatArray | None = None,
) -> Request:
    """A request with numbers for its free velocities and accelerations (NaN).

    Free states of the first and the last waypoint, and of those with a dwell, become rest.

    allowed : ndarray, shape (axes, 2), optional
        Range of the positions [m].
    """
    if not request.free:
        return request
    problem = request.problem
    count = problem.states.shape[1]
    if allowed is None:
        allowed = np.tile([-np.inf, np.inf], (count, 1))
    # axes that do not meet in the waypoints choose on their own
    meeting = problem.options.synchronize == "waypoints"
    groups = [slice(0, count)] if meeting else [slice(i, i + 1) for i in range(count)]
    choices = [_Choice(problem, axes, overshoot, allowed) for axes in groups]
    total, done = sum(choice.passages for choice in choices), 0
    states = problem.states.copy()
    for axes, choice in zip(groups, choices, strict=True):
        while choice.choose_next():
            done += 1
            if progress is not None:
                progress(done, total)
        states[:, axes] = choice.states
    return _with_states(request, states)


class _Choice:
    """The choice of the states of axes that meet in the waypoints.

    Attributes
    ----------
    states : ndarray, shape (waypoints, axes, WaypointState)
        Numbers for the free ones once all passages are chosen.
    """

    def __init__(
        self, problem: Problem, axes: slice, overshoot: float, allowed: FloatArray
    ) -> None:
        self.states = np.ascontiguousarray(problem.states[:, axes])
        points, count = self.states.shape[:2]
        width = 2 * problem.options.smoothness
        self._place = np.zeros(points)
        self._tools = np.zeros((Tools.SIZE, Tools.COLUMNS))
        self._tools[Tools.PATH, Path.SHARE] = min(overshoot, EVERYWHERE)
        self._choice = np.zeros((Block.COUNT * points, count, WaypointState.SIZE))
        self._axes = np.zeros((count, Track.SIZE))
        self._spots = np.zeros((points * count, Spot.SIZE, Spot.COLUMNS))
        self._work = np.zeros((MotionWork.SIZE, MotionWork.COLUMNS))
        options = replace(problem.options, synchronize="waypoints", sample_time=0.0, duration=0.0)
        self._work[MotionWork.OPTIONS, : len(options.vector)] = options.vector
        self._bounded = backend.begin_choice(
            self.states, problem.dwells, problem.limits[axes].copy(), problem.lower[axes].copy(),
            np.clip(allowed[axes], -EVERYWHERE, EVERYWHERE), self._choice, self._place,
            self._tools, self._axes, self._spots, self._work,
        )
        self._room = (
            np.zeros(((points - 1) * count, Link.SIZE, Link.COLUMNS)),
            np.zeros((points, Stretch.SIZE)), np.zeros((2 * points * count, 4 * count + 1)),
            np.zeros(((points - 1) * count, Cell.SIZE, Cell.COLUMNS)),
            np.zeros((2 * Spare.ROWS, Timing.SIZE)), np.zeros((2 * Spare.ROWS, width)),
        )

    @property
    def passages(self) -> int:
        """How many passages there are."""
        tools, found = self._tools.copy(), 0
        while backend.next_passage(tools, self._spots):
            found += 1
        return found

    def choose_next(self) -> bool:
        """Choose the states of the next passage; False if there is none."""
        if self._bounded and backend.next_passage(self._tools, self._spots):
            backend.choose_passage(
                self._choice, self._tools, self._axes, self._spots, *self._room, self._work
            )
            return True
        backend.end_choice(self.states, self._place, self._choice, self._tools, self._axes)
        return False


def at_rest(request: Request) -> Request:
    """A request whose free velocities and accelerations are zero."""
    _, states = united(request.problem.states)
    return _with_states(request, np.where(np.isnan(states), 0.0, states))


def _with_states(request: Request, states: FloatArray) -> Request:
    problem = request.problem._replace(states=states)
    return request._replace(
        waypoints=with_states(request.waypoints, states, problem.dwells), problem=problem
    )
