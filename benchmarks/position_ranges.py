"""Two moving axes with and without a range of positions, against linear programs.

The axis that is ready first has time, in which it must not swing past its waypoints, nor farther
than its own shortest profile does. The oracle is a spline of degree n + 1 whose control points keep
the limits, and whose samples the range: what it finds is feasible, and what it does not find is
decided by neither.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from scipy.interpolate import BSpline
from scipy.optimize import linprog

from benchmarks.problems import FloatArray
from benchmarks.report import Part, Record, Section, Settings
from segfmu import InfeasibleError, Limits, Trajectory, Waypoint, plan
from segfmu.planning.limits import NAMES

SEED = 45
CELLS, SAMPLES = 60, 4
# of the distance between the waypoints
ROOM = 0.05
# of the path of the shortest profile, by which an axis that has time may go farther
FARTHER = 0.01
# of the duration without a range
DURATIONS = (1.0005, 1.01, 1.05, 1.2, 1.5, 2.0, 3.0)


@dataclass(frozen=True)
class Moving:
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

    def alone(self, axis: int) -> Moving:
        """One of the axes."""
        return Moving(
            self.positions[:, [axis]], self.velocities[:, [axis]], self.accelerations[:, [axis]],
            self.limits[[axis]],
        )

    def planned(self, *ranges: FloatArray) -> Trajectory | None:
        """The plan, within a lowest and a highest position; None if it is refused."""
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
            )
        except InfeasibleError:
            return None

    def is_feasible(self, duration: float, allowed: FloatArray) -> bool:
        """Whether splines of a duration [s] within a range (2, axes) are found for all axes."""
        return all(
            self._fits(axis, duration, *allowed[:, axis]) for axis in range(self.limits.shape[0])
        )

    def _fits(self, axis: int, duration: float, low: float, high: float) -> bool:
        limits = self.limits[axis]
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


def random_problem(n: int, random: np.random.Generator) -> Moving:
    """States with velocities up to their limits, accelerations in half of the problems."""
    scale = 10.0 ** random.uniform(-1.0, 1.0)
    steps = np.concatenate([[0.0], np.cumsum(random.uniform(0.0, 0.8, n))])
    limits = scale * 10.0 ** (steps + random.uniform(-0.2, 0.2, (2, n + 1)))
    positions = random.uniform(-1.0, 1.0, (2, 2)) * scale * 10.0 ** random.uniform(-1.0, 1.0)
    states = 0.4 * random.uniform(-1.0, 1.0, (2, 2, 2)) * limits[:, :2].T[:, None]
    states[1] *= random.uniform() < 0.5
    states[:, 1] *= random.uniform() < 0.5
    return Moving(positions, states[0], states[1], limits)


def refusals(n: int, count: int) -> Record:
    """How many problems with a range are refused, and how many of these are feasible."""
    random = np.random.default_rng((SEED, n))
    kept, refused, feasible, longer = 0, 0, 0, 0
    for _ in range(count):
        problem = random_problem(n, random)
        free = problem.planned()
        if free is None:
            continue
        within = problem.planned(*problem.allowed)
        if within is not None:
            kept += 1
            longer += within.duration > free.duration * (1.0 + 1e-9)
            continue
        refused += 1
        durations = (share * free.duration for share in DURATIONS)
        feasible += any(problem.is_feasible(time, problem.allowed) for time in durations)
    return {
        "n": n, "planned": kept, "longer than without": longer, "refused": refused,
        "of these feasible": feasible,
    }


def paths(problem: Moving) -> Iterator[tuple[Moving, float, FloatArray, FloatArray]]:
    """Axes that have time: each alone, the duration [s], and how far it goes then and at most.

    Both ranges [m] have the shape (2, 1); the second one is that of the shortest profile.
    """
    both = problem.planned()
    if both is None:
        return
    for axis in range(problem.limits.shape[0]):
        alone = problem.alone(axis)
        shortest = alone.planned()
        if shortest is not None and shortest.duration < both.duration * (1.0 - 1e-9):
            own = np.array(shortest.extrema(0))
            yield alone, both.duration, np.array(both.extrema(0))[:, [axis]], own


def excursions(n: int, count: int) -> Record:
    """How many axes that have time go farther than their shortest profile."""
    random = np.random.default_rng((SEED, n))
    shares, feasible = [], 0
    for _ in range(count):
        for alone, duration, found, own in paths(random_problem(n, random)):
            length = own[1, 0] - own[0, 0]
            share = float(max(own[0, 0] - found[0, 0], found[1, 0] - own[1, 0]) / length)
            shares.append(share)
            if share > FARTHER:
                room = np.array([[-FARTHER], [FARTHER]]) * length
                feasible += alone.is_feasible(duration, own + room)
    return {
        "n": n, "axes that have time": len(shares),
        f"farther by more than {FARTHER:.0%}": sum(share > FARTHER for share in shares),
        "of these avoidable": feasible, "farthest": f"{max(shares):.1%}",
    }


def measure(settings: Settings) -> Part:
    """Two tables: refused of those that are feasible without a range, and paths without one."""
    orders, count = (2, 3, 4), settings.samples
    return Part("Ranges of positions", (
        Section("Two moving axes within a range", [refusals(n, count) for n in orders]),
        Section("Two moving axes without one", [excursions(n, count) for n in orders]),
    ), (
        f"range: waypoints, widened by {ROOM:.0%} of their distance",
        f"feasible: splines of {CELLS} cells at {DURATIONS[0]:g} to {DURATIONS[-1]:g} of the "
        "duration without a range",
        "farther: than the shortest profile of the axis alone, in shares of that one's path; "
        "avoidable: splines of the same duration do not",
    ))
