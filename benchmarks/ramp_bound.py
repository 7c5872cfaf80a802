"""Certified lower bounds on the duration of one axis whose acceleration is ramps and holds, n = 4.

They hold for every profile that is a finite sequence of ramps of a class and holds, however many,
however slow. The argument is in docs/planner.md ("What ramps can reach").

Units are those of `ramp_shapes.py`. A profile is its slopes u over its ramps. The multipliers, in
this order, belong to: acceleration, velocity and position at the end; upper and lower acceleration
limit, upper and lower velocity limit at the `checks` times.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import linprog

from benchmarks.optimal_control import Transition
from benchmarks.ramp_shapes import AHEAD, LEAD_CURVATURE, Ramps, ScaledTransition, scaled

FloatArray = NDArray[np.float64]
# certificates have to show more than rounding can
MARGIN = 1e-9


def effects(times: FloatArray, checks: FloatArray) -> FloatArray:
    """Integrals from 0 to the times of what a slope does there to the constrained quantities.

    Shape (times, multipliers), with straight ramps. The velocity at time c is v + a c plus the
    integral of u (c - t) over t < c, the acceleration a plus that of u.
    """
    t = times[:, None]
    before = np.minimum(t, checks)
    rates = (checks**2 - np.maximum(checks - t, 0.0) ** 2) / 2.0
    ends = [t, t - t**2 / 2.0, (1.0 - (1.0 - t) ** 3) / 6.0]
    return np.hstack([*ends, -before, before, -rates, rates])


def leads(ramps: Ramps, start: FloatArray, end: FloatArray, check: FloatArray) -> FloatArray:
    """Velocity at the time `check` that a straight ramp of slope 1 is ahead of the curved one."""
    duration = end - start
    share = np.clip((check - start) / np.maximum(duration, 1e-300), 0.0, 1.0)
    return np.asarray(duration**2 * ramps.lead(share), dtype=np.float64)


def offsets(problem: ScaledTransition, checks: FloatArray, early: float) -> FloatArray:
    """What each multiplier is multiplied by where no slope acts; shape (multipliers,).

    For profiles that end `early` and then hold their last acceleration until 1.
    """
    p = problem
    coast = p.v + p.a * checks
    acceleration = np.ones_like(checks)
    ends = [
        p.a - p.b,
        p.v + p.a - p.w - p.b * early,
        p.v + p.a / 2.0 - p.distance - (p.w + p.b * early / 2.0) * early,
    ]
    return np.concatenate([
        ends, acceleration * (p.acceleration - p.a), acceleration * (p.acceleration + p.a),
        p.velocity - coast, p.velocity + coast,
    ])


class RampBound:
    """Excludes durations: linear programs propose multipliers, a finer grid certifies."""

    def __init__(self, ramps: Ramps, intervals: int = 32, refinement: int = 12) -> None:
        """Multipliers at the inner nodes of `intervals`; certified on `refinement` times more."""
        self._ramps = ramps
        self._nodes = np.arange(intervals + 1) / intervals
        self._checks = self._nodes[1:-1]
        self._first, self._last = np.triu_indices(intervals + 1, 1)
        self._fine = np.arange(intervals * refinement + 1) / (intervals * refinement)
        self._rows = self._edge_rows()

    def lower_bound(self, transition: Transition, tolerance: float = 1e-3) -> float:
        """A duration [s] below which no profile of the class exists.

        Durations are excluded from 0 on, interval by interval, until an interval of `tolerance`
        times the duration is not.
        """
        low, step = 0.0, transition.slow / 64.0
        least, most = tolerance**2 * transition.slow, 64.0 * transition.slow
        growth = 2.0
        while step > max(tolerance * low, least) and low < most:
            if self.excludes(transition, low, low + step):
                low, step = low + step, growth * step
            else:
                step, growth = step / 2.0, 1.0
        return low

    def excludes(self, transition: Transition, low: float, high: float) -> bool:
        """Whether it is certain that no profile of the class has a duration in [low, high] [s]."""
        problem, early = scaled(transition, high), (high - low) / high
        multipliers = self._propose(problem, early)
        terms = np.abs(offsets(problem, self._checks, 0.0)) @ np.abs(multipliers)
        return self.certified(problem, multipliers, early) < -MARGIN * (1.0 + float(terms))

    def certified(
        self, problem: ScaledTransition, multipliers: FloatArray, early: float
    ) -> float:
        """Upper bound of the weighted sum of constraints over all profiles of the class.

        For any multipliers of limits >= 0 and any profile that meets the boundary and the limits
        and ends within the last share `early`, the sum is >= 0. A bound < 0 excludes them all.
        """
        v_from = 3 + 2 * self._checks.size
        # the hold after an early end is not bounded by the velocity limit
        late = np.tile(self._checks > 1.0 - early, 2)
        weights = multipliers.copy()
        weights[3:] = np.maximum(weights[3:], 0.0)
        weights[v_from:][late] = 0.0
        return self._free(problem, weights, early) + self.gain(problem, weights)

    def _free(self, problem: ScaledTransition, weights: FloatArray, early: float) -> float:
        """Largest sum of the offsets, a parabola in the early end, over all early ends."""
        ends = [0.0, early]
        bend = -problem.b * weights[2]
        slope = -problem.b * weights[1] - problem.w * weights[2]
        if bend < 0.0:
            ends.append(min(max(-slope / bend, 0.0), early))
        sums = [offsets(problem, self._checks, end) @ weights for end in ends]
        return float(max(sums))

    def gain(self, problem: ScaledTransition, weights: FloatArray) -> float:
        """Upper bound of what the slopes of a profile add to the sum: the rise of a potential.

        The potential is linear between the fine nodes and rises over any ramp, with ends anywhere,
        by at least what this ramp adds.
        """
        fine = self._fine
        h = fine[1]
        sums = effects(fine, self._checks) @ weights
        rates = self._rates(weights)
        # within two cells: a ramp adds at most its slope times the integral of |rate|
        near = self._ramps.slopes(problem, np.zeros(1), np.full(1, 2.0 * h))[0]
        least = h * near * (rates + abs(weights[2]) * AHEAD * (2.0 * h) ** 2)
        bend = self._bend(weights) * h**2 / 8.0
        potential = np.zeros_like(fine)
        for last in range(1, fine.size):
            start = fine[:last]
            duration = fine[last] - start
            slopes = self._ramps.slopes(
                problem, duration - 2.0 * h * (1.0 + 1e-9), duration + 2.0 * h
            )
            up, down = self._rising(sums[last] - sums[:last], start, fine[last], weights)
            gains = np.maximum(
                self._ramps.best(problem, up, weights[2], duration, slopes),
                self._ramps.best(problem, down, -weights[2], duration, slopes),
            ) + slopes * bend
            potential[last] = max(
                float(np.max(potential[:last] + gains)), potential[last - 1] + least[last - 1]
            )
        return float(potential[-1])

    def _rising(
        self, straight: FloatArray, start: FloatArray, end: float, weights: FloatArray
    ) -> tuple[FloatArray, FloatArray]:
        """What straight ramps of slope 1 and -1 add, with the velocity where the limits hold."""
        up, down = straight, -straight
        count = self._checks.size
        upper, lower = weights[3 + 2 * count : 3 + 3 * count], weights[3 + 3 * count :]
        for k in np.flatnonzero(upper + lower):
            # the larger of straight and curved velocity keeps the upper limit
            lead = leads(self._ramps, start, np.asarray(end), self._checks[k])
            up, down = up - lower[k] * lead, down - upper[k] * lead
        return up, down

    def _rates(self, weights: FloatArray) -> FloatArray:
        """Largest |rate| at which straight slopes add, within each cell of the fine grid."""
        left, right, inner = self._fine[:-1], self._fine[1:], self._fine[:-1, None] < self._checks
        acceleration, velocity = self._net(weights)
        extremes = []
        a, v, y = weights[:3]
        held = inner @ acceleration
        for t in (left, right):
            ramp = np.where(inner, self._checks - t[:, None], 0.0) @ velocity
            extremes.append(np.abs(a + v * (1.0 - t) + y * (1.0 - t) ** 2 / 2.0 - held - ramp))
        # a parabola leaves its chord by less than this
        return np.asarray(np.maximum(*extremes) + abs(y) * self._fine[1] ** 2 / 8.0)

    def _bend(self, weights: FloatArray) -> float:
        """Largest sum of the second derivatives of what a ramp adds, with its start and its end."""
        inner = self._fine[:-1, None] < self._checks
        limited = inner @ self._net(weights)[1]
        slope = max(
            float(np.abs(limited - weights[1] - weights[2] * (1.0 - t)).max())
            for t in (self._fine[:-1], self._fine[1:])
        )
        velocity = float(weights[3 + 2 * self._checks.size :].sum())
        return 2.0 * (slope + 6.0 * AHEAD * abs(float(weights[2])) + LEAD_CURVATURE * velocity)

    def _net(self, weights: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Multipliers of the upper less those of the lower limits: acceleration, velocity."""
        pairs = weights[3:].reshape(2, 2, -1)
        return pairs[0, 0] - pairs[0, 1], pairs[1, 0] - pairs[1, 1]

    def _edge_rows(self) -> tuple[FloatArray, FloatArray, FloatArray]:
        """What straight ramps of slope 1, and -1, from node to node add; the potentials."""
        table = effects(self._nodes, self._checks)
        straight = table[self._last] - table[self._first]
        start, end = self._nodes[self._first], self._nodes[self._last]
        lead = leads(self._ramps, start[:, None], end[:, None], self._checks)
        none = np.zeros((start.size, 3 + 2 * self._checks.size))
        up = straight - np.hstack([none, 0.0 * lead, lead])
        down = -straight - np.hstack([none, lead, 0.0 * lead])
        identity = np.eye(self._nodes.size)
        return up, down, identity[self._last] - identity[self._first]

    def _propose(self, problem: ScaledTransition, early: float) -> FloatArray:
        """Multipliers with the smallest sum if ramps ended at the nodes alone."""
        up, down, rises = self._rows
        duration = self._nodes[self._last] - self._nodes[self._first]
        count, nodes = self._checks.size, self._nodes.size
        free = np.zeros((rises.shape[0], 1))
        rows = []
        for slopes, ahead in self._ramps.samples(problem, duration):
            for side, sign in ((up, 1.0), (down, -1.0)):
                curved = side.copy()
                curved[:, 2] -= sign * ahead
                rows.append(np.hstack([slopes[:, None] * curved, free, -rises]))
        for end in (0.0, early):
            sums = offsets(problem, self._checks, end)
            rows.append(np.concatenate([sums, [-1.0], np.zeros(nodes)])[None, :])
        table = np.vstack(rows)
        cost = np.zeros(table.shape[1])
        cost[3 + 4 * count], cost[-1] = 1.0, 1.0
        late = [0.0 if check > 1.0 - early else 10.0 for check in self._checks]
        limits = [(0.0, 10.0)] * (2 * count) + [(0.0, most) for most in late + late]
        sums_and_potentials = [(None, None), (0.0, 0.0)] + [(0.0, None)] * (nodes - 1)
        bounds = [(-1.0, 1.0)] * 3 + limits + sums_and_potentials
        found = linprog(cost, A_ub=table, b_ub=np.zeros(len(table)), bounds=bounds, method="highs")
        if found.x is None:
            return np.zeros(3 + 4 * count)
        return np.asarray(found.x[: 3 + 4 * count], dtype=np.float64)
