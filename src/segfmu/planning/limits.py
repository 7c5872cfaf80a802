"""The output constraints (8): one limit per derivative, of the first two one per direction."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import inf
from operator import attrgetter

import numpy as np
from numpy.typing import ArrayLike

from segfmu.arrays import (
    ABSENT,
    SAME,
    FloatArray,
    Frozen,
    Range,
    as_index,
    finite_number,
    limit_values,
    lower_values,
    shown,
)
from segfmu.errors import InputError

NAMES = ("velocity", "acceleration", "jerk", "snap", "crackle", "pop")
# in the negative direction
LOWER = ("velocity_min", "acceleration_min")
_upper: Callable[[object], tuple[FloatArray, ...]] = attrgetter(*NAMES)
UNITS = ("m/s", "m/s2", "m/s3", "m/s4", "m/s5", "m/s6")
# more than any machine has, so few that tables have room
MOST_AXES = 1_000_000


@dataclass(frozen=True, eq=False, repr=False)
class Limits(Frozen):
    """Bounds c_1 .. c_6 on the derivatives of the position, SI units.

    Parameters
    ----------
    velocity, acceleration : array_like, scalar or shape (axes,)
        Required, finite and positive.
    jerk, snap, crackle, pop : array_like, scalar or shape (axes,), optional
        Positive; None or infinity for no limit, stored as infinity.
    velocity_min, acceleration_min : array_like, scalar or shape (axes,), optional
        Limits in the negative direction, below zero: a hoist that lowers slower than it lifts, an
        axis that drives and brakes differently. None or -infinity for the same limit in both
        directions, stored as -infinity.

    Raises
    ------
    InputError
        For values that are not positive, and shapes that do not fit each other.
    """

    velocity: FloatArray
    acceleration: FloatArray
    jerk: FloatArray
    snap: FloatArray
    crackle: FloatArray
    pop: FloatArray
    velocity_min: FloatArray
    acceleration_min: FloatArray

    def __init__(
        self,
        velocity: ArrayLike,
        acceleration: ArrayLike,
        jerk: ArrayLike | None = None,
        snap: ArrayLike | None = None,
        crackle: ArrayLike | None = None,
        pop: ArrayLike | None = None,
        *,
        velocity_min: Range = None,
        acceleration_min: Range = None,
    ) -> None:
        given = (velocity, acceleration, jerk, snap, crackle, pop)
        found = {}
        for i, (name, value) in enumerate(zip(NAMES, given, strict=True)):
            found[name] = limit_values(f"limits.{name}", value, required=i < len(LOWER))
        for name, least in zip(LOWER, (velocity_min, acceleration_min), strict=True):
            found[name] = lower_values(f"limits.{name}", least)
        sizes = {v.size for v in found.values() if v.ndim}
        if len(sizes) > 1:
            raise InputError(f"limits have different numbers of axes: {sorted(sizes)}")
        vars(self).update(found)

    def __repr__(self) -> str:
        given = ((n, v) for n, v in zip(NAMES, self._all(), strict=True) if limited(v))
        shown = [f"{n}={_given(v)}" for n, v in given]
        for name, value in zip(LOWER, self._lower(), strict=True):
            if np.isfinite(value).any():
                shown.append(f"{name}={value.tolist()}")
        return f"Limits({', '.join(shown)})"

    def _all(self) -> tuple[FloatArray, ...]:
        return _upper(self)

    def _kept(self) -> dict[int | tuple[int, int], FloatArray]:
        """Tables that have been made, by the number of axes, or that and the smoothness."""
        kept: dict[int | tuple[int, int], FloatArray] = vars(self).setdefault("_tables", {})
        return kept

    def _lower(self) -> tuple[FloatArray, FloatArray]:
        return self.velocity_min, self.acceleration_min

    def bound(self, name: str, axis: int, value: float) -> float:
        """Magnitude of the limit of a derivative in the direction of a value; 2 is axis z.

        Raises
        ------
        InputError
            As `named`.
        """
        return abs(self._of_axis(self.named(name, axis, value), axis))

    def named(self, name: str, axis: int, value: float) -> str:
        """The name of that limit: `velocity_min` where it differs from `velocity`.

        Raises
        ------
        InputError
            For a derivative or an axis without limits, and a value that is no number.
        """
        if not isinstance(name, str) or name not in NAMES:
            raise InputError(f"name must be one of {', '.join(NAMES)}, got {shown(name)}")
        lower, upper = f"{name}_min", self._of_axis(name, axis)
        if finite_number("value", value) >= 0.0 or lower not in LOWER:
            return name
        return name if self._of_axis(lower, axis) in (-inf, -upper) else lower

    def _of_axis(self, name: str, axis: int) -> float:
        values: FloatArray = getattr(self, name)
        row = as_index("axis", axis, values.size - 1 if values.size > 1 else inf)
        return float(values[row] if values.size > 1 else values.item())

    def lower(self, axes: int) -> FloatArray:
        """Magnitudes of the limits of velocity and acceleration in the negative direction.

        Returns
        -------
        ndarray, shape (axes, 2)
            Read-only.

        Raises
        ------
        InputError
            For another number of axes than that of the limits.
        """
        tables = self._kept()
        if not (type(axes) is int and axes in tables):
            axes = as_index("axes", axes, MOST_AXES)
            tables[axes] = self._lower_table(axes)
        return tables[axes]

    def _lower_table(self, axes: int) -> FloatArray:
        found = np.empty((axes, len(LOWER)))
        sides = zip(self._lower(), self._all(), strict=False)
        for i, (values, upper) in enumerate(sides):
            _require_axes(LOWER[i], values, axes)
            found[:, i] = upper if values is SAME else np.where(np.isinf(values), upper, -values)
        found.setflags(write=False)
        return found

    def table(self, axes: int, smoothness: int) -> FloatArray:
        """Limits c_1 .. c_{smoothness + 1} of every axis, 0 where absent.

        Returns
        -------
        ndarray, shape (axes, smoothness + 1)
            Read-only.

        Raises
        ------
        InputError
            For a limit of a derivative that is unbounded at this smoothness, and for another number
            of axes than that of the limits.
        """
        tables = self._kept()
        size = axes, smoothness
        if not (type(axes) is int and type(smoothness) is int and size in tables):
            size = as_index("axes", axes, MOST_AXES), as_index("smoothness", smoothness, len(NAMES))
            tables[size] = self._table(*size)
        return tables[size]

    def sides(self, axes: int, smoothness: int) -> FloatArray:
        """`table` in the positive direction and, as magnitudes, in the negative one.

        Returns
        -------
        ndarray, shape (2, axes, smoothness + 1)
        """
        upper = self.table(axes, smoothness)
        return np.array([upper, np.hstack([self.lower(axes), upper[:, len(LOWER) :]])])

    def _table(self, axes: int, smoothness: int) -> FloatArray:
        table = np.zeros((axes, smoothness + 1))
        for i, values in enumerate(self._all()):
            if values is ABSENT:
                continue
            _require_axes(NAMES[i], values, axes)
            if i <= smoothness:
                table[:, i] = values
            elif limited(values):
                raise InputError(
                    f"limits.{NAMES[i]} cannot be kept with smoothness {smoothness}, which leaves "
                    f"this derivative unbounded; raise smoothness to {i} or omit the limit"
                )
        if inf in table.ravel().tolist():
            table[table == inf] = 0.0
        table.setflags(write=False)
        return table


def _require_axes(name: str, values: FloatArray, axes: int) -> None:
    if values.ndim and values.size not in (1, axes):
        raise InputError(
            f"limits.{name} has {values.size} values for {axes} axes; "
            "give one value, or one per axis"
        )


def limited(values: FloatArray) -> bool:
    """Whether any axis has a limit."""
    return values is not ABSENT and bool(np.isfinite(values).any())


def _given(values: FloatArray) -> object:
    """A limit as `Limits` takes it, None where it is absent."""
    return [v if v < inf else None for v in values.tolist()] if values.ndim else values.tolist()
