"""Bounds of a crane's drives, and what a motion uses of them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import isfinite
from typing import Any, cast

import numpy as np
from numpy.typing import ArrayLike

from segfmu.arrays import FloatArray, Frozen, limit_values, lower_values, shown
from segfmu.crane.checks import lags_of
from segfmu.errors import InputError
from segfmu.kernels.crane.records import AXES, Demand
from segfmu.kernels.crane.travel import no_stop

# one value, or one per drive of which some may be None
Given = ArrayLike | Sequence[float | None] | None
DRIVES = ("bridge", "trolley", "hoist")
# in the order of the record `Demand`
QUANTITIES = ("force", "velocity", "acceleration", "power", "travel", "sway_angle")
UNITS = {
    "force": "N", "velocity": "m/s", "acceleration": "m/s2", "power": "W", "travel": "m",
    "sway angle": "rad",
}
NAMES = (
    *(f"{drive} {quantity}" for quantity in QUANTITIES[:4] for drive in DRIVES),
    *(f"{axis} travel" for axis in AXES), "sway angle x", "sway angle y",
)
# a magnitude that stands for no bound where infinity stands for another one
UNBOUNDED = 1e300
# end stops that are none [m]
FAR = no_stop()
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
    travel, travel_min : array_like, scalar or shape (3,), optional
        Greatest and least positions of bridge and trolley, and lengths of the rope [m]: the end
        stops of `TravelLimits`; None or infinity for none.
    force_min, velocity_min, acceleration_min : array_like, scalar or shape (3,), optional
        In the negative direction, below zero; None or -infinity for the same bound in both. The
        hoist lifts with a negative velocity and pulls with a negative force.
    lag : array_like, scalar or shape (3,)
        Time constants of the velocity loops [s]. The setpoint of a drive with a lag is
        velocity + lag * acceleration, and its bound is that of the velocity.

    Raises
    ------
    InputError
        For values of the other sign or zero, for negative lags, for end stops without room between
        them, and for other shapes.
    """

    force: FloatArray
    velocity: FloatArray
    acceleration: FloatArray
    power: FloatArray
    travel: FloatArray
    travel_min: FloatArray
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
        travel: Given = None,
        travel_min: Given = None,
        lag: ArrayLike = 0.0,
    ) -> None:
        given = {
            "force": force, "velocity": velocity, "acceleration": acceleration, "power": power,
            "sway_angle": sway_angle,
        }
        for name, value in given.items():
            values = limit_values(name, cast(Any, value), required=False)
            self._set(name, np.where(values > 0.0, values, np.inf))
        least = (force_min, velocity_min, acceleration_min)
        for name, value in zip(DIRECTED, least, strict=True):
            self._set(f"{name}_min", lower_values(f"{name}_min", cast(Any, value)))
        self._set("travel", _ends("travel", travel, np.inf))
        self._set("travel_min", _ends("travel_min", travel_min, -np.inf))
        for axis, least, greatest in zip(AXES, self.travel_min, self.travel, strict=True):
            if not least < greatest:
                raise InputError(
                    f"travel of the {axis}: min {least:g} m must be below max {greatest:g} m"
                )
        object.__setattr__(self, "lag", lags_of("lag", lag))

    def _set(self, name: str, values: FloatArray) -> None:
        size = 2 if name == "sway_angle" else 3
        if values.ndim == 1 and values.size not in (1, size):
            raise InputError(f"{name} has {values.size} values; give one, or {size}")
        object.__setattr__(self, name, np.broadcast_to(values, (size,)))

    def lower(self, name: str) -> FloatArray:
        """Magnitudes of the bounds of a quantity in the negative direction, infinite: none.

        Of the travel, minus the least places.

        Raises
        ------
        InputError
            For a name that is none of a quantity.
        """
        if not isinstance(name, str) or name not in QUANTITIES:
            raise InputError(f"name must be one of {', '.join(QUANTITIES)}, got {shown(name)}")
        own: FloatArray = getattr(self, name)
        if name == "travel":
            return -self.travel_min
        if name not in DIRECTED:
            return own
        least = getattr(self, f"{name}_min")
        return np.asarray(np.where(np.isinf(least), own, -least))

    @property
    def vector(self) -> FloatArray:
        """All bounds of the positive direction in the order of `NAMES`, shape (17,).

        Infinite where absent.
        """
        return np.concatenate([getattr(self, name) for name in QUANTITIES])

    @property
    def table(self) -> FloatArray:
        """Magnitudes of the bounds in the positive and in the negative direction, shape (2, 17)."""
        return np.array([self.vector, np.concatenate([self.lower(n) for n in QUANTITIES])])

    @property
    def record(self) -> FloatArray:
        """As FMUs take them, shape (29,), the record `DriveBounds`."""
        upper, lower = self.table
        own, places = slice(Demand.POWER), slice(Demand.PLACE, Demand.SWAY)
        least = np.where(np.isinf(lower), -UNBOUNDED, -lower)
        least = np.where(lower == upper, 0.0, least)[own]
        greatest = np.where(np.isinf(upper), 0.0, upper)
        greatest[places] = np.minimum(upper[places], FAR)
        return np.concatenate([greatest, least, np.maximum(-lower[places], -FAR)])

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
        bounds["travel_min"] = np.maximum(self.travel_min, other.travel_min)
        for name in DIRECTED:
            lower = np.minimum(self.lower(name), other.lower(name))
            # beyond what any drive has, where only the positive direction has a bound
            least = np.where(np.isinf(lower), -UNBOUNDED, -lower)
            bounds[f"{name}_min"] = np.where(lower == bounds[name], -np.inf, least)
        return ActuatorBounds(**bounds, lag=np.maximum(self.lag, other.lag))


def _ends(name: str, value: Given, none: float) -> FloatArray:
    """End stops [m] of an argument, infinite where there are none."""
    if value is None:
        return np.full(1, none)
    given = [none if v is None else v for v in np.atleast_1d(np.asarray(value, dtype=object))]
    try:
        values = np.array(given, dtype=np.float64)
    except (TypeError, ValueError, OverflowError):
        values = np.full(1, np.nan)
    if values.ndim != 1 or np.isnan(values).any():
        raise InputError(f"{name} must be positions in m, or None, got {shown(value)}")
    return values


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
        Largest magnitude in the motion, SI units; in the bound's direction, if bounds differ. Of a
        travel, the farthest place.
    bound : float
        Its magnitude, infinite if there is none. Of a travel, the end stop.
    time : float
        When the peak is reached [s].
    origin : float
        From where on the bound is used: of a travel the middle between both end stops, or a metre
        before one that is alone; else 0.
    """

    name: str
    peak: float
    bound: float
    time: float
    origin: float = 0.0

    @property
    def use(self) -> float:
        """Peak over bound, both from the origin on; 0 without a bound."""
        if not isfinite(self.bound):
            return 0.0
        return (self.peak - self.origin) / (self.bound - self.origin)

    @property
    def unit(self) -> str:
        """Unit of peak and bound."""
        return next(unit for name, unit in UNITS.items() if name in self.name)


def uses(bounds: ActuatorBounds, peaks: FloatArray, times: FloatArray) -> tuple[BoundUse, ...]:
    """The use of every bound, in the order of `NAMES`.

    peaks, times (2, 17): greatest magnitudes in the positive and in the negative direction. Where
    both have the same bound they are one.
    """
    found: list[BoundUse] = []
    for i, (upper, lower) in enumerate(bounds.table.T.tolist()):
        if Demand.PLACE <= i < Demand.SWAY:
            found += _travel_uses(NAMES[i], (upper, -lower), peaks[:, i], times[:, i])
            continue
        one = upper == lower
        for side, bound in enumerate((upper,) if one else (upper, lower)):
            row = int(peaks[:, i].argmax()) if one else side
            name = f"{NAMES[i]}_min" if side else NAMES[i]
            found.append(BoundUse(name, float(peaks[row, i]), bound, float(times[row, i])))
    return tuple(found)


def _travel_uses(
    name: str, stops: tuple[float, float], peaks: FloatArray, times: FloatArray
) -> list[BoundUse]:
    """The use of a travel, with its greatest and its least place."""
    found = []
    for side, (stop, other) in enumerate((stops, stops[::-1])):
        sign = 1.0 - 2.0 * side
        origin = 0.5 * (stop + other) if isfinite(other) else stop - sign
        found.append(
            BoundUse(f"{name}_min" if side else name, sign * float(peaks[side]), stop,
                     float(times[side]), origin)
        )
    return found


def sides(values: FloatArray) -> FloatArray:
    """Greatest magnitudes (2, 17) of demands (rows, 17) in both directions; see `demand_peaks`."""
    found: FloatArray = np.array([values.max(axis=0), -values.min(axis=0)])
    places = found[:, Demand.PLACE : Demand.SWAY].copy()
    np.maximum(found, 0.0, out=found)
    found[:, Demand.PLACE : Demand.SWAY] = places
    return found


assert len(NAMES) == Demand.SIZE
