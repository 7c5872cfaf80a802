"""Choice of free waypoint velocities and accelerations.

First guess: where both chords have the same direction, pass along it at a speed that the shorter
chord admits; where they reverse, rest. A compass search over one waypoint at a time then shortens
the two adjacent intervals. A second search starts from rest at every free waypoint, so the result
is never slower than resting there.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from segfmu.kernels.planner.records import WaypointState
from segfmu.planning.arrays import FloatArray
from segfmu.planning.problem import Problem, plan_phases, total_duration
from segfmu.planning.request import Request
from segfmu.planning.waypoint import Waypoint

SWEEPS = 4
# in units of the limit; every sweep omits one more of the first
STEPS = (0.3, 0.1, 0.03, 0.01, 0.003, 0.001)


def choose_states(request: Request) -> Request:
    """A request with numbers for its free velocities and accelerations (NaN).

    Free states of the first and the last waypoint, and of those with a dwell, become rest.
    """
    problem = request.problem
    free = np.isnan(problem.states)
    if not free.any():
        return request
    states = np.where(free, 0.0, problem.states)
    free[[0, -1]] = False
    free[problem.dwells > 0.0] = False
    if free.any():
        states = _fastest(replace(problem, states=states), free)
    waypoints = tuple(
        Waypoint(state[:, WaypointState.POSITION], state[:, WaypointState.VELOCITY],
                 state[:, WaypointState.ACCELERATION], dwell=point.dwell)
        for point, state in zip(request.waypoints, states, strict=True)
    )
    return replace(request, waypoints=waypoints, problem=replace(problem, states=states))


def _fastest(resting: Problem, free: FloatArray) -> FloatArray:
    """The states of the fastest plan found; the search starts at `resting` as well."""
    search = _Search(free, resting)
    candidates = [resting.states, search.improve(_guess(resting, free))]
    if np.isfinite(search.total(resting.states)):
        candidates.append(search.improve(resting.states))
    return min(candidates, key=lambda states: _duration(replace(resting, states=states)))


def _duration(problem: Problem) -> float:
    """Duration of the plan exactly as requested, infinite if there is none."""
    phases = plan_phases(problem)
    return float(phases.durations.sum(axis=0).max()) if phases.feasible else float("inf")


def _guess(resting: Problem, free: FloatArray) -> FloatArray:
    """Velocities along the chords, limited by braking within half of the shorter chord."""
    guess = resting.states.copy()
    velocity_limit, acceleration_limit = resting.limits[:, 0], resting.limits[:, 1]
    chords = np.diff(guess[:, :, WaypointState.POSITION], axis=0)
    for i in range(1, len(guess) - 1):
        before, after = chords[i - 1], chords[i]
        shorter = np.minimum(np.abs(before), np.abs(after))
        speed = np.minimum(0.9 * velocity_limit, np.sqrt(acceleration_limit * shorter))
        # all axes take the time of the slowest one, so their speeds are proportional
        slowest = float(np.max(shorter / np.maximum(speed, 1e-12)))
        share = shorter / max(slowest, 1e-12)
        passing = before * after > 0.0
        chosen = np.where(passing, np.sign(after) * np.minimum(speed, share), 0.0)
        velocity = guess[i, :, WaypointState.VELOCITY]
        velocity[:] = np.where(free[i, :, WaypointState.VELOCITY], chosen, velocity)
    return guess


class _Search:
    """Compass search over the free states of one waypoint after the other."""

    def __init__(self, free: FloatArray, problem: Problem) -> None:
        self.free = free
        self.dwells = problem.dwells
        self.limits = problem.limits
        meeting = problem.options.synchronize == "waypoints"
        self.options = replace(
            problem.options, synchronize="waypoints" if meeting else "none", sample_time=0.0,
            duration=0.0,
        )
        self.apart = replace(self.options, synchronize="none")

    def total(self, states: FloatArray) -> float:
        """Duration of all intervals."""
        return total_duration(Problem(states, self.dwells, self.limits, self.options))

    def improve(self, states: FloatArray) -> FloatArray:
        """Sweep until nothing gets shorter; infeasible guesses are first moved towards rest."""
        states = states.copy()
        for _ in range(8):
            if np.isfinite(self.total(states)):
                break
            states[self.free] *= 0.5
        for sweep in range(SWEEPS):
            before = self.total(states)
            for point in range(1, len(states) - 1):
                for field, axis in np.argwhere(self.free[point].T):
                    self._line(states, point, int(axis), int(field), STEPS[sweep:])
            if not self.total(states) < before * (1.0 - 1e-4):
                break
        return states

    def _line(
        self, states: FloatArray, point: int, axis: int, field: int, steps: tuple[float, ...]
    ) -> None:
        """Move one state up or down, in place, while the two intervals next to it get shorter."""
        rows = slice(point - 1, point + 2)
        window = states[rows].copy()
        dwells = self.dwells[rows].copy()
        bound = float(self.limits[axis, field - WaypointState.VELOCITY])
        best = self._window(window, dwells, float("inf"))
        for step in steps:
            for sign in (1.0, -1.0):
                while True:
                    kept = window[1, axis, field]
                    moved = min(max(kept + sign * step * bound, -bound), bound)
                    window[1, axis, field] = moved
                    reached = self._window(window, dwells, best)
                    if not reached < best * (1.0 - 1e-9):
                        window[1, axis, field] = kept
                        break
                    best = reached
        states[point, axis, field] = window[1, axis, field]

    def _window(self, window: FloatArray, dwells: FloatArray, best: float) -> float:
        """Duration of two intervals, infinite if a single axis already takes `best`.

        This avoids the search for a common duration, which is expensive beyond a gap.
        """
        phases = plan_phases(Problem(window, dwells, self.limits, self.apart))
        if not phases.feasible:
            return float("inf")
        if self.options.synchronize == "none":
            return float(phases.durations.sum())
        if not phases.durations.max(axis=1).sum() < best * (1.0 - 1e-9):
            return float("inf")
        return total_duration(Problem(window, dwells, self.limits, self.options))
