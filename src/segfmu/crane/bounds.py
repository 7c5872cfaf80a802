"""Bounds of a crane's drives, and what a motion uses of them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import isfinite
from typing import Any, cast

import numpy as np
from numpy.typing import ArrayLike

from segfmu.errors import InputError
from segfmu.kernels.crane.records import Demand
from segfmu.planning.arrays import FloatArray, Frozen, limit_values

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


@dataclass(frozen=True, eq=False)
class ActuatorBounds(Frozen):
    """Bounds of a crane's drives, the same in both directions.

    Parameters
    ----------
    force, velocity, acceleration, power : array_like, scalar or shape (3,), optional
        Of bridge, trolley and hoist [N], [m/s], [m/s2], [W]; None or infinity for no bound. The
        hoist can only pull: its force is the rope's tension, from 0 to the bound. The power is
        force times velocity, driving or braking.
    sway_angle : array_like, scalar or shape (2,), optional
        Of the rope about both axes [rad].

    Raises
    ------
    InputError
        For values that are not positive and for other shapes.
    """

    force: FloatArray
    velocity: FloatArray
    acceleration: FloatArray
    power: FloatArray
    sway_angle: FloatArray

    def __init__(
        self,
        force: Given = None,
        velocity: Given = None,
        acceleration: Given = None,
        sway_angle: Given = None,
        power: Given = None,
    ) -> None:
        given = (force, velocity, acceleration, power, sway_angle)
        for name, value in zip(QUANTITIES, given, strict=True):
            size = 2 if name == "sway_angle" else 3
            values = limit_values(name, cast(Any, value), required=False)
            if values.ndim == 1 and values.size not in (1, size):
                raise InputError(f"{name} has {values.size} values; give one, or {size}")
            bounds = np.where(values > 0.0, values, np.inf)
            object.__setattr__(self, name, np.broadcast_to(bounds, (size,)))

    @property
    def vector(self) -> FloatArray:
        """All bounds in the order of `NAMES`, infinite where absent, shape (14,)."""
        return np.concatenate([getattr(self, name) for name in QUANTITIES])

    @property
    def known(self) -> bool:
        """Whether there is any bound."""
        return bool(np.isfinite(self.vector).any())

    def tightened(self, other: ActuatorBounds) -> ActuatorBounds:
        """The lower of two bounds each: those of the drives and those that a mission sets.

        Raises
        ------
        InputError
            For anything but ActuatorBounds.
        """
        require_bounds("other", other)
        return ActuatorBounds(
            **{n: np.minimum(getattr(self, n), getattr(other, n)) for n in QUANTITIES}
        )


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
        Such as "trolley force".
    peak : float
        Largest magnitude in the motion, SI units.
    bound : float
        Infinite if there is none.
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
    """The use of every bound for peaks and their times in the order of `NAMES`, shape (14,)."""
    return tuple(
        BoundUse(name, float(peak), float(bound), float(time))
        for name, peak, bound, time in zip(NAMES, peaks, bounds.vector, times, strict=True)
    )


assert len(NAMES) == Demand.SIZE
