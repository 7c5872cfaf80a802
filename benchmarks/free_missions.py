"""Random missions whose inner waypoints have free states, of five kinds."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from segfmu import Limits, Waypoint

FloatArray = NDArray[np.float64]
KINDS = ("random", "walk", "line", "arc", "dense")
AXES = 3


class Mission(NamedTuple):
    """Positions, shape (points, axes), and limits c_1 .. c_4, shape (axes, 4)."""

    kind: str
    positions: FloatArray
    limits: FloatArray

    @property
    def bounds(self) -> Limits:
        """As `plan` takes them."""
        return Limits(*self.limits.T)

    def waypoints(self, velocity: str | None, acceleration: str | None) -> list[Waypoint]:
        """Rest at the ends; inner states as given."""
        inner = [Waypoint(p, velocity, acceleration) for p in self.positions[1:-1]]
        return [Waypoint(self.positions[0]), *inner, Waypoint(self.positions[-1])]


def missions(count: int, points: tuple[int, int], seed: int) -> Iterator[Mission]:
    """Missions of the five kinds in turn, each with a number of points from a range."""
    for i in range(count):
        random = np.random.default_rng((seed, i))
        size = int(random.integers(points[0], points[1] + 1))
        kind = KINDS[i % len(KINDS)]
        yield Mission(kind, _positions(kind, size, random), _limits(random))


def _limits(random: np.random.Generator) -> FloatArray:
    velocity = random.uniform(0.3, 2.0)
    acceleration = velocity * random.uniform(0.5, 2.0)
    jerk = acceleration * random.uniform(1.0, 6.0)
    snap = jerk * random.uniform(2.0, 12.0)
    shares = random.uniform(0.4, 1.0, (AXES, 1))
    return np.asarray(shares * np.array([velocity, acceleration, jerk, snap]))


def _positions(kind: str, points: int, random: np.random.Generator) -> FloatArray:
    if kind == "random":
        return np.asarray(random.uniform(0.0, 3.0, (points, AXES)))
    if kind == "walk":
        steps = random.uniform(0.2, 1.5, (points, 1)) * np.array([1.0, 0.5, 0.2])
        return np.asarray(np.cumsum(steps + 0.3 * random.normal(size=(points, AXES)), axis=0))
    if kind == "line":
        direction = random.normal(size=AXES)
        along = np.cumsum(random.uniform(0.1, 1.5, points))
        return np.asarray(along[:, None] * direction / np.linalg.norm(direction))
    if kind == "arc":
        angles = np.linspace(0.0, random.uniform(1.0, 5.0), points)
        radius = random.uniform(0.3, 2.0)
        rise = random.uniform(-0.3, 0.3)
        return np.column_stack([radius * np.cos(angles), radius * np.sin(angles), rise * angles])
    steps = random.uniform(0.02, 0.12, (points, 1))
    turns = 0.3 * np.cumsum(random.normal(size=(points, AXES)), axis=0)
    return np.asarray(np.cumsum(steps * (np.array([1.0, 0.6, 0.3]) + turns), axis=0))
