"""Feedforward by the flat inverse (7): a load trajectory -> forces, velocities, states."""

from __future__ import annotations

from collections.abc import Callable
from typing import Protocol

import numpy as np
from numpy.typing import ArrayLike
from scipy.optimize import minimize_scalar

from segfmu.crane.parameters import Crane
from segfmu.errors import InfeasibleError, InputError
from segfmu.kernels._crane import crane_flat_inverse
from segfmu.planning.arrays import FloatArray

ORDERS = 5
SAMPLES = 2001


class LoadTrajectory(Protocol):
    """What the inverse needs of a trajectory of the load."""

    @property
    def axes(self) -> int:
        """Number of axes."""

    @property
    def duration(self) -> float:
        """Its end [s]."""

    def __call__(self, t: ArrayLike, derivative: int = 0) -> FloatArray:
        """Value of a derivative, shape (..., axes)."""


class FlatInverse:
    """Setpoints that make the load of an ideal crane follow a trajectory of x, y and z exactly.

    Parameters
    ----------
    crane : Crane
    trajectory : Trajectory
        Three axes, four times continuously differentiable (errata E7: z as well).

    Raises
    ------
    InputError
        For a trajectory without exactly three axes.
    InfeasibleError
        When the load reaches the trolley's height, the rope goes slack or leaves its range;
        the error has the time.
    """

    def __init__(self, crane: Crane, trajectory: LoadTrajectory) -> None:
        if trajectory.axes != 3:
            raise InputError(f"the flat inverse needs axes x, y, z; got {trajectory.axes} axes")
        smoothness = getattr(trajectory, "smoothness", 4)
        if smoothness < 4:
            raise InputError(
                f"the flat inverse needs smoothness 4 or more, got {smoothness}; with less, the "
                "carriage's acceleration jumps"
            )
        self.crane = crane
        self.trajectory = trajectory
        self._check()

    def force(self, t: ArrayLike) -> FloatArray:
        """Drive forces F_x, F_y, F_l [N] at times t, shape (..., 3)."""
        return self.evaluate(t)[..., :3]

    def velocity(self, t: ArrayLike) -> FloatArray:
        """Velocities of bridge, trolley and rope [m/s] at times t, shape (..., 3)."""
        return self.evaluate(t)[..., 8:11]

    def state(self, t: ArrayLike) -> FloatArray:
        """State x_t, y_t, l, phi_x, phi_y and rates at times t, shape (..., 10)."""
        return self.evaluate(t)[..., 3:13]

    def acceleration(self, t: ArrayLike) -> FloatArray:
        """Second derivatives of x_t, y_t, l, phi_x, phi_y at times t, shape (..., 5)."""
        return self.evaluate(t)[..., 13:]

    def evaluate(self, t: ArrayLike) -> FloatArray:
        """Forces (3), state (10) and accelerations (5) side by side, shape (..., 18)."""
        flat = np.stack([self.trajectory(t, d) for d in range(ORDERS)], axis=-2)
        results = np.empty((*flat.shape[:-2], 18))
        for row, values in zip(
            results.reshape(-1, 18), flat.reshape(-1, ORDERS, 3), strict=True
        ):
            crane_flat_inverse(values, *self.crane.masses, row[:3], row[3:13], row[13:])
        return results

    def _check(self) -> None:
        crane = self.crane
        self._require(
            self._height, 0.0, "load height z", "m", "the trolley's height", "lower the waypoints"
        )
        self._require(
            self._fall, crane.gravity, "downward acceleration of the load", "m/s2",
            "gravity (the rope goes slack)", "lower limits.z.acceleration",
        )
        if crane.rope_max is not None:
            self._require(
                self._length, crane.rope_max, "rope length", "m", "rope_max",
                "raise the waypoints or rope_max",
            )
        if crane.rope_min is not None:
            self._require(
                lambda t: -self._length(t), -crane.rope_min, "rope length", "m", "rope_min",
                "lower the waypoints or rope_min",
            )

    def _height(self, t: FloatArray) -> FloatArray:
        values: FloatArray = self.trajectory(t)[..., 2]
        return values

    def _fall(self, t: FloatArray) -> FloatArray:
        values: FloatArray = -self.trajectory(t, 2)[..., 2]
        return values

    def _length(self, t: FloatArray) -> FloatArray:
        pull = self.trajectory(t, 2) + np.array([0.0, 0.0, self.crane.gravity])
        values: FloatArray = -self._height(t) * np.linalg.norm(pull, axis=-1) / pull[..., 2]
        return values

    def _require(
        self,
        quantity: Callable[[FloatArray], FloatArray],
        bound: float,
        name: str,
        unit: str,
        limit: str,
        remedy: str,
    ) -> None:
        """Raise unless the quantity stays below its bound over the whole trajectory."""
        times = np.linspace(0.0, self.trajectory.duration, SAMPLES)
        values = quantity(times)
        strict = limit.startswith(("rope_",))
        margin = 1e-9 * max(abs(bound), 1.0) if strict else -1e-9
        worst = self._refine(quantity, times, values)
        over = np.flatnonzero(values > bound + margin)
        time = float(times[over[0]]) if over.size else worst[0]
        value = float(values[over[0]]) if over.size else worst[1]
        if value > bound + margin:
            shown = abs(value) if name == "rope length" else value
            raise InfeasibleError(
                f"at {time:.3f} s: {name} {shown:.6g} {unit} is beyond {limit}, "
                f"{abs(bound):.6g} {unit}; {remedy}",
                limit=limit, value=shown, bound=abs(bound), time=time,
            )

    @staticmethod
    def _refine(
        quantity: Callable[[FloatArray], FloatArray], times: FloatArray, values: FloatArray
    ) -> tuple[float, float]:
        """Time and value of the maximum, refined between the samples next to the largest one."""
        peak = int(values.argmax())
        low, high = times[max(peak - 1, 0)], times[min(peak + 1, times.size - 1)]
        if low == high:
            return float(times[peak]), float(values[peak])
        found = minimize_scalar(
            lambda t: -float(quantity(np.array([t]))[0]), bounds=(low, high), method="bounded",
            options={"xatol": 1e-9 * max(high, 1.0)},
        )
        if -found.fun > values[peak]:
            return float(found.x), float(-found.fun)
        return float(times[peak]), float(values[peak])
