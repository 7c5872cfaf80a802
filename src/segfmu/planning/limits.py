"""The output constraints (8): one limit per derivative, the same in both directions."""

from __future__ import annotations

from dataclasses import dataclass
from math import inf

import numpy as np
from numpy.typing import ArrayLike

from segfmu.errors import InputError
from segfmu.planning.arrays import ABSENT, FloatArray, Frozen, as_index, limit_values

NAMES = ("velocity", "acceleration", "jerk", "snap", "crackle", "pop")
UNITS = ("m/s", "m/s2", "m/s3", "m/s4", "m/s5", "m/s6")


@dataclass(frozen=True, eq=False, repr=False)
class Limits(Frozen):
    """Bounds c_1 .. c_6 on the derivatives of the position, SI units.

    Parameters
    ----------
    velocity, acceleration : array_like, scalar or shape (axes,)
        Required, finite and positive.
    jerk, snap, crackle, pop : array_like, scalar or shape (axes,), optional
        Positive; None or infinity if a derivative is not limited, which is infinity afterwards.

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

    def __init__(
        self,
        velocity: ArrayLike,
        acceleration: ArrayLike,
        jerk: ArrayLike | None = None,
        snap: ArrayLike | None = None,
        crackle: ArrayLike | None = None,
        pop: ArrayLike | None = None,
    ) -> None:
        given = (velocity, acceleration, jerk, snap, crackle, pop)
        for i, (name, value) in enumerate(zip(NAMES, given, strict=True)):
            values = limit_values(f"limits.{name}", value, required=i < 2)
            object.__setattr__(self, name, values)
        sizes = {v.size for v in self._all() if v.ndim == 1}
        if len(sizes) > 1:
            raise InputError(f"limits have different numbers of axes: {sorted(sizes)}")

    def __repr__(self) -> str:
        given = ((n, v) for n, v in zip(NAMES, self._all(), strict=True) if limited(v))
        return f"Limits({', '.join(f'{n}={_given(v)}' for n, v in given)})"

    def _all(self) -> tuple[FloatArray, ...]:
        return tuple(getattr(self, name) for name in NAMES)

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
        tables: dict[tuple[int, int], FloatArray] = self.__dict__.setdefault("_tables", {})
        size = axes, smoothness
        if not (type(axes) is int and type(smoothness) is int and size in tables):
            size = as_index("axes", axes), as_index("smoothness", smoothness, len(NAMES))
            tables[size] = self._table(*size)
        return tables[size]

    def _table(self, axes: int, smoothness: int) -> FloatArray:
        table = np.zeros((axes, smoothness + 1))
        for i, (name, values) in enumerate(zip(NAMES, self._all(), strict=True)):
            if values.ndim == 1 and values.size not in (1, axes):
                raise InputError(
                    f"limits.{name} has {values.size} values for {axes} axes; "
                    "give one value, or one per axis"
                )
            if i <= smoothness:
                table[:, i] = values
            elif limited(values):
                raise InputError(
                    f"limits.{name} cannot be kept with smoothness {smoothness}, which leaves this "
                    f"derivative unbounded; raise smoothness to {i} or omit the limit"
                )
        table[np.isinf(table)] = 0.0
        table.setflags(write=False)
        return table


def limited(values: FloatArray) -> bool:
    """Whether any axis has a limit."""
    return values is not ABSENT and bool(np.isfinite(values).any())


def _given(values: FloatArray) -> object:
    """A limit as `Limits` takes it, None where it is absent."""
    return [v if v < inf else None for v in values.tolist()] if values.ndim else values.tolist()
