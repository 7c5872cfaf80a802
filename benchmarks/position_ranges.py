"""Plans of two moving axes within a range of positions, against linear programs.

The axis that is ready first has time, in which it must not swing past its waypoints. The oracle is
a spline of degree n + 1 whose control points keep the limits, and whose samples the range: what it
finds is feasible, and what it does not find is decided by neither.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.interpolate import BSpline
from scipy.optimize import linprog

from benchmarks.problems import FloatArray
from benchmarks.report import Part, Record, Section, Settings
from segfmu import InfeasibleError, Limits, Waypoint, plan
from segfmu.planning.limits import NAMES

SEED = 45
CELLS, SAMPLES = 60, 4
# of the distance between the waypoints
ROOM = 0.05
# of the duration without a range
DURATIONS = (1.0005, 1.01, 1.05, 1.2, 1.5, 2.0, 3.0)


@dataclass(frozen=True)
class TwoAxes:
    """Two waypoints: positions, velocities, accelerations (2, axes), limits (axes, n + 1)."""

    positions: FloatArray
    velocities: FloatArray
    accelerations: FloatArray
    limits: FloatArray

    @property
    def allowed(self) -> FloatArray:
        """Range of the positions [m], shape (2, axes)."""
        room = ROOM * np.abs(np.diff(self.positions, axis=0)[0])
        return np.array([self.positions.min(axis=0) - room, self.positions.max(axis=0) + room])

    def duration(self, *ranges: FloatArray) -> float | None:
        """Duration of the plan [s], within a lowest and a highest position; None if refused."""
        points = [Waypoint(*row) for row in zip(
            self.positions, self.velocities, self.accelerations, strict=True
        )]
        names = NAMES[: self.limits.shape[1]]
        limits = Limits(**dict(zip(names, self.limits.T, strict=True)))
        low, high = ranges or (None, None)
        try:
            return plan(
                points, limits, smoothness=self.limits.shape[1] - 1,
                position_min=low, position_max=high,
            ).duration
        except InfeasibleError:
            return None

    def is_feasible(self, duration: float) -> bool:
        """Whether splines of a duration [s] within the range are found for all axes."""
        return all(self._fits(axis, duration) for axis in range(self.limits.shape[0]))

    def _fits(self, axis: int, duration: float) -> bool:
        limits, (low, high) = self.limits[axis], self.allowed[:, axis]
        degree = limits.size
        knots = np.concatenate([np.zeros(degree), np.linspace(0, 1, CELLS + 1), np.ones(degree)])
        orders = [_derivative(order, knots, degree) for order in range(degree + 1)]
        samples = BSpline.design_matrix(
            np.linspace(0.0, 1.0, SAMPLES * CELLS + 1), knots, degree
        ).toarray()
        scales = [high - low, *limits]
        bounded = [m / duration**i / scales[i] for i, m in enumerate(orders)]
        rows = np.vstack([
            *(sign * m for m in bounded[1:] for sign in (1.0, -1.0)),
            samples / scales[0], -samples / scales[0],
        ])
        count = len(rows) - 2 * len(samples)
        bounds = np.concatenate([
            np.ones(count), np.full(len(samples), high / scales[0]),
            np.full(len(samples), -low / scales[0]),
        ])
        given = (self.positions, self.velocities, self.accelerations)
        ends = [(end, i) for end in (0, -1) for i in range(degree)]
        states = [given[i][end, axis] / scales[i] if i < len(given) else 0.0 for end, i in ends]
        found = linprog(
            np.zeros(orders[0].shape[1]), rows, bounds,
            np.array([bounded[i][end] for end, i in ends]), np.array(states), (None, None),
        )
        return bool(found.success)


def _derivative(order: int, knots: FloatArray, degree: int) -> FloatArray:
    """Control points of a derivative from those of the spline."""
    matrix = np.eye(len(knots) - degree - 1)
    for k in range(order):
        width = degree - k
        inner = knots[k + 1 : len(knots) - k - 1]
        spans = inner[width:] - inner[:-width]
        matrix = np.diff(matrix, axis=0) * (width / spans)[:, None]
    return matrix


def random_problem(n: int, random: np.random.Generator) -> TwoAxes:
    """States with velocities up to their limits, accelerations in half of the problems."""
    scale = 10.0 ** random.uniform(-1.0, 1.0)
    steps = np.concatenate([[0.0], np.cumsum(random.uniform(0.0, 0.8, n))])
    limits = scale * 10.0 ** (steps + random.uniform(-0.2, 0.2, (2, n + 1)))
    positions = random.uniform(-1.0, 1.0, (2, 2)) * scale * 10.0 ** random.uniform(-1.0, 1.0)
    states = 0.4 * random.uniform(-1.0, 1.0, (2, 2, 2)) * limits[:, :2].T[:, None]
    states[1] *= random.uniform() < 0.5
    states[:, 1] *= random.uniform() < 0.5
    return TwoAxes(positions, states[0], states[1], limits)


def measure(settings: Settings) -> Part:
    """One table: refused of those that are feasible without a range."""
    records: list[Record] = []
    for n in (2, 3, 4):
        random = np.random.default_rng((SEED, n))
        kept, refused, feasible, longer = 0, 0, 0, 0
        for _ in range(settings.samples):
            problem = random_problem(n, random)
            free = problem.duration()
            if free is None:
                continue
            within = problem.duration(*problem.allowed)
            if within is not None:
                kept += 1
                longer += within > free * (1.0 + 1e-9)
                continue
            refused += 1
            feasible += any(problem.is_feasible(share * free) for share in DURATIONS)
        records.append({
            "n": n, "planned": kept, "longer than without": longer, "refused": refused,
            "of these feasible": feasible,
        })
    return Part("Ranges of positions", (Section("Two moving axes", records),), (
        f"range: waypoints, widened by {ROOM:.0%} of their distance",
        f"feasible: splines of {CELLS} cells at {DURATIONS[0]:g} to {DURATIONS[-1]:g} of the "
        "duration without a range",
    ))
