"""Random boundary problems, as arrays, as waypoints of segfmu and as input of Ruckig."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from segfmu import Limits, Waypoint

FloatArray = NDArray[np.float64]
KINDS = ("rest to rest", "moving", "mixed")


@dataclass(frozen=True, eq=False)
class Problems:
    """Many problems of the same number of axes.

    Attributes
    ----------
    limits : ndarray, shape (count, axes, 4)
        Velocity, acceleration, jerk and snap.
    positions, velocities, accelerations : ndarray, shape (count, 2, axes)
        At start and end.
    """

    limits: FloatArray
    positions: FloatArray
    velocities: FloatArray
    accelerations: FloatArray

    @property
    def count(self) -> int:
        """Number of problems."""
        return len(self.limits)

    @property
    def axes(self) -> int:
        """Number of axes."""
        return int(self.limits.shape[1])

    def pick(self, chosen: NDArray[np.bool_]) -> Problems:
        """Those problems that are chosen."""
        return Problems(
            *(a[chosen] for a in (self.limits, self.positions, self.velocities, self.accelerations))
        )

    def table(self, smoothness: int) -> FloatArray:
        """Limits c_1 .. c_{n+1}, shape (count, axes, n + 1): for n = 2 up to jerk, else to snap."""
        table = np.zeros((self.count, self.axes, smoothness + 1))
        used = min(4, smoothness + 1)
        table[:, :, :used] = self.limits[:, :, :used]
        return table

    def waypoints(self, i: int) -> list[Waypoint]:
        """Start and end of problem i."""
        states = (self.positions[i], self.velocities[i], self.accelerations[i])
        return [Waypoint(*(s[end] for s in states)) for end in (0, 1)]

    def bounds(self, i: int, smoothness: int) -> Limits:
        """Limits of problem i: for n = 2 up to jerk, else up to snap."""
        return Limits(*self.limits[i].T[: 3 if smoothness == 2 else 4])

    def ruckig_input(self, i: int) -> Any:
        """Problem i, without its snap limit, as Ruckig's InputParameter."""
        from ruckig import InputParameter

        given = InputParameter(self.axes)
        states = {
            "position": self.positions, "velocity": self.velocities,
            "acceleration": self.accelerations,
        }
        for name, values in states.items():
            setattr(given, f"current_{name}", values[i, 0].tolist())
            setattr(given, f"target_{name}", values[i, 1].tolist())
        for column, name in enumerate(("velocity", "acceleration", "jerk")):
            setattr(given, f"max_{name}", self.limits[i, :, column].tolist())
        return given


def random_problems(kind: str, axes: int, count: int, seed: int) -> Problems:
    """Problems of a kind: "rest to rest"; "moving", with states up to 60 % of the limits;
    "mixed", with states up to the limits of which three in ten are zero."""
    random = np.random.default_rng(seed)
    low, high = [0.3, 0.3, 0.3, 2.0], [3.0, 3.0, 6.0, 30.0]
    limits = random.uniform(low, high, (count, axes, 4))
    share = random.uniform(-1.0, 1.0, (3, count, 2, axes))
    share[0, :, 0] = 0.0
    if kind == "rest to rest":
        share[1:] = 0.0
    elif kind == "moving":
        share[1:] *= 0.6
    else:
        share[random.random(share.shape) < 0.3] = 0.0
        # a problem with nothing to do is none
        share[0, (share == 0.0).all(axis=(0, 2, 3)), 1] = 0.5
    positions = 5.0 * share[0]
    rates = limits[:, None, :, :2] * np.moveaxis(share[1:], 0, -1)
    velocities, accelerations = (np.ascontiguousarray(rates[..., d]) for d in (0, 1))
    return Problems(limits, positions, velocities, accelerations)
