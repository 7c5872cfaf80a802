"""Feedforward compensation of known lag and dead time of the drives.

The flat inverse is that of the ideal crane. A first-order drive with lag T follows a velocity v
exactly if its setpoint is v + T v'. The inverse gives the accelerations v' of bridge, trolley and
rope, because it uses the plan's fourth derivative. A drive that acts a dead time late gets what it
needs at the end of that time. So that the first setpoints are in time, the load starts to move when
the longest dead time has passed. Friction belongs to the inverse: it is part of the forces, and the
loop of a velocity drive overcomes it by itself.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from segfmu.arrays import FloatArray, finite_times, sized
from segfmu.crane.checks import require_not_negative
from segfmu.crane.inverse import FlatInverse

AXES = ("bridge", "trolley", "hoist")
Three = tuple[float, float, float]


@dataclass(frozen=True)
class Compensation:
    """Known lag and dead time of the drives of bridge, trolley and hoist.

    Parameters
    ----------
    lag : tuple of 3 float
        Time constants of the velocity loops [s].
    dead_time : tuple of 3 float
        From a setpoint to the drive that takes it [s].

    Raises
    ------
    InputError
        For negative values.
    """

    lag: Three = (0.0, 0.0, 0.0)
    dead_time: Three = (0.0, 0.0, 0.0)

    def __post_init__(self) -> None:
        for name in ("lag", "dead_time"):
            values = sized(f"compensation {name}", getattr(self, name), 3)
            for axis, value in zip(AXES, values, strict=True):
                require_not_negative(f"compensation {name} of the {axis}", value)

    @property
    def delay(self) -> float:
        """Time [s] by which the load moves later than the setpoints: the longest dead time."""
        return float(max(self.dead_time))


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
        """Reference state at times t, shape (..., 10), with a hook (..., 14)."""
        return self.inverse.state(finite_times(t) - self.compensation.delay)

    def load(self, t: ArrayLike) -> FloatArray:
        """Reference position of the load at times t [m], shape (..., 3)."""
        found: FloatArray = self.inverse.trajectory(finite_times(t) - self.compensation.delay)
        return found

    def _setpoints(self, t: ArrayLike) -> tuple[FloatArray, FloatArray]:
        known = self.compensation
        found = {
            dead: self._instant(finite_times(t) - known.delay + dead) for dead in {*known.dead_time}
        }
        force, velocity = (
            np.stack([found[dead][kind][..., i] for i, dead in enumerate(known.dead_time)], axis=-1)
            for kind in range(2)
        )
        return force, velocity

    def _instant(self, t: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Setpoints for drives without dead time."""
        values = self.inverse.evaluate(t)
        lag = np.array(self.compensation.lag)
        columns = self.inverse.model.columns
        velocity = values[..., columns.velocity] + lag * values[..., columns.drive_acceleration]
        return values[..., columns.force], velocity
