"""Bounds of a crane's drives, and what a motion uses of them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import isfinite
from typing import Any, cast

import numpy as np
from numpy.typing import ArrayLike

from segfmu.crane.checks import lags_of
from segfmu.errors import InputError
from segfmu.kernels.crane.records import Demand
from segfmu.planning.arrays import FloatArray, Frozen, limit_values, lower_values

# one value, or one per drive of which some may be None
Given = ArrayLike | Sequence[float | None] | None
DRIVES = ("bridge", "trolley", "hoist")
# in the order of the record `Demand`
QUANTITIES = ("force", "velocity", "acceleration", "power", "sway_angle")
UNITS = {
    "force": "N", "velocity": "m/s", "acceleration": "m/s2", "power": "W", "sway angle": "rad",
}
NAMES = (
    *(f"{drive} {quantity}" for quantity in QUANTITIES[:-1] for drive in DRIVES),
    "sway angle x", "sway angle y",
)
# a magnitude that stands for no bound where infinity stands for another one
UNBOUNDED = 1e300
# that may differ in the negative direction
DIRECTED = ("force", "velocity", "acceleration")


@dataclass(frozen=True, eq=False)
class ActuatorBounds(Frozen):
    """Bounds of a crane's drives.

    Parameters
    ----------
    force, velocity, acceleration, power : array_like, scalar or shape (3,), optional
        Of bridge, trolley and hoist [N], [m/s], [m/s2], [W]; None or infinity for no bound. The
        hoist can only pull: its force is the rope's tension, from 0 to the bound. The power is
        force times velocity, driving or braking.
    sway_angle : array_like, scalar or shape (2,), optional
        Of the rope about both axes [rad].
    force_min, velocity_min, acceleration_min : array_like, scalar or shape (3,), optional
        In the negative direction, below zero; None or -infinity for the same bound in both. The
        hoist lifts with a negative velocity and pulls with a negative force.
    lag : array_like, scalar or shape (3,)
        Time constants of the velocity loops [s]. The setpoint of a drive with a lag is
        velocity + lag * acceleration, and its bound is that of the velocity.

    Raises
    ------
    InputError
        For values of the other sign or zero, for negative lags, and for other shapes.
    """

    force: FloatArray
    velocity: FloatArray
    acceleration: FloatArray
    power: FloatArray
    sway_angle: FloatArray
    force_min: FloatArray
    velocity_min: FloatArray
    acceleration_min: FloatArray
    lag: FloatArray

    def __init__(
        self,
        force: Given = None,
        velocity: Given = None,
        acceleration: Given = None,
        sway_angle: Given = None,
        power: Given = None,
        *,
        force_min: Given = None,
        velocity_min: Given = None,
        acceleration_min: Given = None,
        lag: ArrayLike = 0.0,
    ) -> None:
        given = (force, velocity, acceleration, power, sway_angle)
        for name, value in zip(QUANTITIES, given, strict=True):
            values = limit_values(name, cast(Any, value), required=False)
            self._set(name, np.where(values > 0.0, values, np.inf))
        least = (force_min, velocity_min, acceleration_min)
        for name, value in zip(DIRECTED, least, strict=True):
            self._set(f"{name}_min", lower_values(f"{name}_min", cast(Any, value)))
        object.__setattr__(self, "lag", lags_of("lag", lag))

    def _set(self, name: str, values: FloatArray) -> None:
        size = 2 if name == "sway_angle" else 3
        if values.ndim == 1 and values.size not in (1, size):
            raise InputError(f"{name} has {values.size} values; give one, or {size}")
        object.__setattr__(self, name, np.broadcast_to(values, (size,)))

    def lower(self, name: str) -> FloatArray:
        """Magnitudes of the bounds of a quantity in the negative direction, infinite: none."""
        own: FloatArray = getattr(self, name)
        if name not in DIRECTED:
            return own
        least = getattr(self, f"{name}_min")
        return np.asarray(np.where(np.isinf(least), own, -least))

    @property
    def vector(self) -> FloatArray:
        """All bounds of the positive direction in the order of `NAMES`, shape (14,).

        Infinite where absent.
        """
        return np.concatenate([getattr(self, name) for name in QUANTITIES])

    @property
    def table(self) -> FloatArray:
        """Magnitudes of the bounds in the positive and in the negative direction, shape (2, 14)."""
        return np.array([self.vector, np.concatenate([self.lower(n) for n in QUANTITIES])])

    @property
    def record(self) -> FloatArray:
        """As FMUs take them, shape (23,), the record `DriveBounds`."""
        upper, lower = self.table
        own = slice(Demand.POWER)
        least = np.where(np.isinf(lower), -UNBOUNDED, -lower)
        least = np.where(lower == upper, 0.0, least)[own]
        return np.concatenate([np.where(np.isinf(upper), 0.0, upper), least])

    @property
    def known(self) -> bool:
        """Whether there is any bound."""
        return bool(np.isfinite(self.table).any())

    def tightened(self, other: ActuatorBounds) -> ActuatorBounds:
        """The smaller of two bounds each: those of the drives and those that a mission sets.

        The lag is the larger one.

        Raises
        ------
        InputError
            For anything but ActuatorBounds.
        """
        require_bounds("other", other)
        bounds: dict[str, Any] = {
            n: np.minimum(getattr(self, n), getattr(other, n)) for n in QUANTITIES
        }
        for name in DIRECTED:
            lower = np.minimum(self.lower(name), other.lower(name))
            # beyond what any drive has, where only the positive direction has a bound
            least = np.where(np.isinf(lower), -UNBOUNDED, -lower)
            bounds[f"{name}_min"] = np.where(lower == bounds[name], -np.inf, least)
        return ActuatorBounds(**bounds, lag=np.maximum(self.lag, other.lag))


def require_bounds(name: str, value: object) -> None:
    """Raise InputError for anything but ActuatorBounds."""
    if not isinstance(value, ActuatorBounds):
        raise InputError(f"{name} must be an ActuatorBounds, got {type(value).__name__}")


@dataclass(frozen=True)
class BoundUse:
    """The peak of a quantity of the drives, and its bound.

    Attributes
    ----------
    name : str
        Such as "trolley force"; "trolley force_min" in the negative direction if bounds differ.
    peak : float
        Largest magnitude in the motion, SI units; in the bound's direction, if bounds differ.
    bound : float
        Its magnitude, infinite if there is none.
    time : float
        When the peak is reached [s].
    """

    name: str
    peak: float
    bound: float
    time: float

    @property
    def use(self) -> float:
        """Peak over bound; 0 without a bound."""
        return self.peak / self.bound if isfinite(self.bound) else 0.0

    @property
    def unit(self) -> str:
        """Unit of peak and bound."""
        return next(unit for name, unit in UNITS.items() if name in self.name)


def uses(bounds: ActuatorBounds, peaks: FloatArray, times: FloatArray) -> tuple[BoundUse, ...]:
    """The use of every bound, in the order of `NAMES`.

    peaks, times (2, 14): greatest magnitudes in the positive and in the negative direction. Where
    both have the same bound they are one.
    """
    found = []
    for i, (upper, lower) in enumerate(bounds.table.T.tolist()):
        one = upper == lower
        for side, bound in enumerate((upper,) if one else (upper, lower)):
            row = int(peaks[:, i].argmax()) if one else side
            name = f"{NAMES[i]}_min" if side else NAMES[i]
            found.append(BoundUse(name, float(peaks[row, i]), bound, float(times[row, i])))
    return tuple(found)


def sides(values: FloatArray) -> FloatArray:
    """Greatest magnitudes (2, columns) of values (rows, columns) in both directions."""
    return np.maximum([values.max(axis=0), -values.min(axis=0)], 0.0)


assert len(NAMES) == Demand.SIZE
