"""Velocities and accelerations of waypoints that leave them free.

The start is a sound guess: pass in the direction of the chords where they agree, at a speed that
the shorter of them admits, and rest where they turn. Then sweeps of a compass search over one
waypoint at a time shorten the two intervals next to it. What comes out is never slower than resting
at every free waypoint, as that plan is compared last.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from segfmu.planning.arrays import FloatArray
from segfmu.planning.limits import Limits
from segfmu.planning.solver import Options, plan_phases, states, total_duration
from segfmu.planning.waypoint import Waypoint

SWEEPS = 4
# in units of the limit; every sweep leaves out one more of the first
STEPS = (0.3, 0.1, 0.03, 0.01, 0.003, 0.001)


def choose_states(
    points: tuple[Waypoint, ...], limits: Limits, options: Options
) -> tuple[Waypoint, ...]:
    """Waypoints whose free velocities and accelerations (NaN) have become numbers.

    The first and the last waypoint, and those with a dwell, rest where they are free.
    """
    state = states(points)
    free = np.isnan(state)
    if not free.any():
        return points
    state[free] = 0.0
    resting = [0, len(points) - 1, *(i for i, p in enumerate(points) if p.dwell > 0.0)]
    free[:, resting] = False
    if not free.any():
        return _with_states(points, state)
    table = limits.table(state.shape[2], options.smoothness)
    dwells = np.array([p.dwell for p in points])
    meet = options.synchronize == "waypoints"
    local = replace(
        options, synchronize="waypoints" if meet else "none", sample_time=0.0, duration=0.0
    )
    search = _Search(free, dwells, table, local)
    candidates = [state, search.improve(_guess(state, free, table))]
    if np.isfinite(search.total(state)):
        candidates.append(search.improve(state))
    return _with_states(points, min(candidates, key=lambda s: _duration(s, dwells, table, options)))


def _with_states(points: tuple[Waypoint, ...], state: FloatArray) -> tuple[Waypoint, ...]:
    return tuple(
        Waypoint(p.position, state[1, i], state[2, i], p.dwell) for i, p in enumerate(points)
    )


def _duration(state: FloatArray, dwells: FloatArray, table: FloatArray, options: Options) -> float:
    """Duration of the plan exactly as asked for, infinite where there is none."""
    found = plan_phases(state, dwells, table, options)
    return float("inf") if found.status < 0 else float(found.durations.sum(axis=0).max())


def _guess(state: FloatArray, free: FloatArray, table: FloatArray) -> FloatArray:
    """Velocities along the chords, at most what half of the shorter chord admits."""
    guess = state.copy()
    chords = np.diff(state[0], axis=0)
    for i in range(1, state.shape[1] - 1):
        before, after = chords[i - 1], chords[i]
        shorter = np.minimum(np.abs(before), np.abs(after))
        speed = np.minimum(0.9 * table[:, 0], np.sqrt(table[:, 1] * shorter))
        # the axes share the time of the slowest one, so their speeds are in proportion
        slowest = float(np.max(shorter / np.maximum(speed, 1e-12)))
        share = shorter / max(slowest, 1e-12)
        passing = before * after > 0.0
        chosen = np.where(passing, np.sign(after) * np.minimum(speed, share), 0.0)
        guess[1, i] = np.where(free[1, i], chosen, state[1, i])
    return guess


class _Search:
    """Compass search over the free states of one waypoint after the other."""

    def __init__(
        self, free: FloatArray, dwells: FloatArray, table: FloatArray, options: Options
    ) -> None:
        self.free = free
        self.dwells = dwells
        self.table = table
        self.options = options

    def total(self, state: FloatArray) -> float:
        """Duration of all intervals."""
        return total_duration(state, self.dwells, self.table, self.options)

    def improve(self, state: FloatArray) -> FloatArray:
        """Sweep until nothing gets shorter; infeasible guesses are drawn towards rest first."""
        state = state.copy()
        for _ in range(8):
            if np.isfinite(self.total(state)):
                break
            state[1:][self.free[1:]] *= 0.5
        for sweep in range(SWEEPS):
            before = self.total(state)
            for point in range(1, state.shape[1] - 1):
                for order, axis in np.argwhere(self.free[:, point]):
                    self._line(state, int(order), point, int(axis), STEPS[sweep:])
            if not self.total(state) < before * (1.0 - 1e-4):
                break
        return state

    def _line(
        self, state: FloatArray, order: int, point: int, axis: int, steps: tuple[float, ...]
    ) -> None:
        """Move one state up or down, in place, while the two intervals next to it get shorter."""
        rows = slice(point - 1, point + 2)
        window = np.ascontiguousarray(state[:, rows])
        dwells = self.dwells[rows].copy()
        bound = float(self.table[axis, order - 1])
        best = self._window(window, dwells, float("inf"))
        for step in steps:
            for sign in (1.0, -1.0):
                while True:
                    kept = window[order, 1, axis]
                    moved = min(max(kept + sign * step * bound, -bound), bound)
                    window[order, 1, axis] = moved
                    found = self._window(window, dwells, best)
                    if not found < best * (1.0 - 1e-9):
                        window[order, 1, axis] = kept
                        break
                    best = found
        state[order, point, axis] = window[order, 1, axis]

    def _window(self, window: FloatArray, dwells: FloatArray, best: float) -> float:
        """Duration of two intervals, infinite where the axes apart already take `best`.

        A common duration can lie beyond a gap, which is far more work to find.
        """
        apart = replace(self.options, synchronize="none")
        found = plan_phases(window, dwells, self.table, apart)
        if found.status < 0 or self.options.synchronize == "none":
            return float("inf") if found.status < 0 else float(found.durations.sum())
        if not found.durations.max(axis=1).sum() < best * (1.0 - 1e-9):
            return float("inf")
        return total_duration(window, dwells, self.table, self.options)
