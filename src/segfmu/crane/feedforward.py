"""Feedforward compensation of known drive lag and friction.

The flat inverse is that of the ideal crane. A first-order drive with lag T follows a velocity v
exactly if its setpoint is v + T v'. The inverse gives the accelerations v' of bridge, trolley and
rope, because it uses the plan's fourth derivative. Friction is added to the inverse's forces, which
already include the rope's acceleration. A drive that acts a dead time late gets what it needs at
the end of that time. So that the first setpoints are in time, the load starts to move when the
longest dead time has passed.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from segfmu.crane.checks import require_not_negative, require_positive, sized
from segfmu.crane.inverse import DRIVE_ACCELERATION, FORCE, VELOCITY, FlatInverse
from segfmu.kernels import backend
from segfmu.kernels.crane.records import Compensation as Known
from segfmu.planning.arrays import FloatArray

AXES = ("bridge", "trolley", "hoist")
Three = tuple[float, float, float]


@dataclass(frozen=True)
class Compensation:
    """Known lag, dead time and friction of the drives of bridge, trolley and hoist.

    Parameters
    ----------
    lag : tuple of 3 float
        Time constants of the velocity loops [s].
    viscous, coulomb : tuple of 3 float
        Friction [N s/m], [N].
    width : float
        Velocity [m/s] that smooths the sign of Coulomb friction: coulomb * tanh(v / width).
    dead_time : tuple of 3 float
        From a setpoint to the drive that takes it [s].

    Raises
    ------
    InputError
        For negative values and for a width that is not positive.
    """

    lag: Three = (0.0, 0.0, 0.0)
    viscous: Three = (0.0, 0.0, 0.0)
    coulomb: Three = (0.0, 0.0, 0.0)
    width: float = 1e-3
    dead_time: Three = (0.0, 0.0, 0.0)

    def __post_init__(self) -> None:
        for name in ("lag", "viscous", "coulomb", "dead_time"):
            values = sized(f"compensation {name}", getattr(self, name), 3)
            for axis, value in zip(AXES, values, strict=True):
                require_not_negative(f"compensation {name} of the {axis}", value)
        require_positive("compensation width", self.width)

    @property
    def delay(self) -> float:
        """Time [s] by which the load moves later than the setpoints: the longest dead time."""
        return float(max(self.dead_time))

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
        known = np.zeros(Known.SIZE)
        known[Known.LAG : Known.DEAD_TIME] = self.lag
        known[Known.DEAD_TIME : Known.VISCOUS] = self.dead_time
        known[Known.VISCOUS : Known.COULOMB] = self.viscous
        known[Known.COULOMB : Known.FRICTION_WIDTH] = self.coulomb
        known[Known.FRICTION_WIDTH] = self.width
        for rows in zip(
            *(a.reshape(-1, 3) for a in (velocities, np.asarray(acceleration), forces, setpoints)),
            strict=True,
        ):
            v, a, f, s = rows
            backend.compensate_setpoints(v.copy(), a.copy(), known, f, s)
        return forces, setpoints


class Feedforward:
    """Setpoints of a planned motion for a crane with real drives.

    Times count from the start of the setpoints. The load starts the compensation's `delay` later,
    as dead times have to pass before anything moves.

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

    def state(self, t: ArrayLike) -> FloatArray:
        """Reference state at times t, shape (..., 10)."""
        return self.inverse.state(np.asarray(t) - self.compensation.delay)

    def load(self, t: ArrayLike) -> FloatArray:
        """Reference position of the load at times t [m], shape (..., 3)."""
        found: FloatArray = self.inverse.trajectory(np.asarray(t) - self.compensation.delay)
        return found

    def _setpoints(self, t: ArrayLike) -> tuple[FloatArray, FloatArray]:
        known = self.compensation
        found = {
            dead: self._instant(np.asarray(t) - known.delay + dead) for dead in {*known.dead_time}
        }
        force, velocity = (
            np.stack([found[dead][kind][..., i] for i, dead in enumerate(known.dead_time)], axis=-1)
            for kind in range(2)
        )
        return force, velocity

    def _instant(self, t: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Setpoints for drives without dead time."""
        values = self.inverse.evaluate(t)
        return self.compensation.setpoints(
            values[..., FORCE], values[..., VELOCITY], values[..., DRIVE_ACCELERATION]
        )
