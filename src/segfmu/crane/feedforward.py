"""Feedforward compensation of known drive lag and friction.

The flat inverse is that of the ideal crane. A first-order drive with lag T follows a velocity v
exactly if its setpoint is v + T v'. The inverse gives the accelerations v' of bridge, trolley and
rope, because it uses the plan's fourth derivative. Friction is added to the inverse's forces, which
already include the rope's acceleration.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from segfmu.crane.checks import require_not_negative, require_positive, sized
from segfmu.crane.inverse import DRIVE_ACCELERATION, FORCE, VELOCITY, FlatInverse
from segfmu.kernels import backend
from segfmu.planning.arrays import FloatArray

AXES = ("bridge", "trolley", "hoist")
Three = tuple[float, float, float]


@dataclass(frozen=True)
class Compensation:
    """Known lag and friction of the drives of bridge, trolley and hoist.

    Parameters
    ----------
    lag : tuple of 3 float
        Time constants of the velocity loops [s].
    viscous, coulomb : tuple of 3 float
        Friction [N s/m], [N].
    width : float
        Velocity [m/s] that smooths the sign of Coulomb friction: coulomb * tanh(v / width).

    Raises
    ------
    InputError
        For negative values and for a width that is not positive.
    """

    lag: Three = (0.0, 0.0, 0.0)
    viscous: Three = (0.0, 0.0, 0.0)
    coulomb: Three = (0.0, 0.0, 0.0)
    width: float = 1e-3

    def __post_init__(self) -> None:
        for name in ("lag", "viscous", "coulomb"):
            values = sized(f"compensation {name}", getattr(self, name), 3)
            for axis, value in zip(AXES, values, strict=True):
                require_not_negative(f"compensation {name} of the {axis}", value)
        require_positive("compensation width", self.width)

    def setpoints(
        self, force: ArrayLike, velocity: ArrayLike, acceleration: ArrayLike
    ) -> tuple[FloatArray, FloatArray]:
        """Force and velocity setpoints, shapes (..., 3).

        Parameters
        ----------
        force, velocity, acceleration : array_like, shape (..., 3)
            Of the ideal crane [N], [m/s], [m/s2].
        """
        forces = np.array(force, dtype=np.float64)
        velocities = np.asarray(velocity, dtype=np.float64)
        setpoints = np.zeros(velocities.shape)
        known = np.array([*self.lag, *self.viscous, *self.coulomb, self.width], dtype=np.float64)
        for rows in zip(
            *(a.reshape(-1, 3) for a in (velocities, np.asarray(acceleration), forces, setpoints)),
            strict=True,
        ):
            v, a, f, s = rows
            backend.compensate_setpoints(v.copy(), a.copy(), known, f, s)
        return forces, setpoints


class Feedforward:
    """Setpoints of a planned motion for a crane with real drives.

    Parameters
    ----------
    inverse : FlatInverse
    compensation : Compensation
    """

    def __init__(self, inverse: FlatInverse, compensation: Compensation) -> None:
        self.inverse = inverse
        self.compensation = compensation

    def force(self, t: ArrayLike) -> FloatArray:
        """Drive forces F_x, F_y, F_l [N] at times t, shape (..., 3)."""
        return self._setpoints(t)[0]

    def velocity(self, t: ArrayLike) -> FloatArray:
        """Velocity setpoints of bridge, trolley and rope [m/s] at times t, shape (..., 3)."""
        return self._setpoints(t)[1]

    def _setpoints(self, t: ArrayLike) -> tuple[FloatArray, FloatArray]:
        values = self.inverse.evaluate(t)
        return self.compensation.setpoints(
            values[..., FORCE], values[..., VELOCITY], values[..., DRIVE_ACCELERATION]
        )
