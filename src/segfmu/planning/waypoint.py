"""A point that the trajectory passes in a given state: P_j of section 3."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike

from segfmu.errors import InputError
from segfmu.planning.arrays import FloatArray, finite_vector


@dataclass(frozen=True, eq=False)
class Waypoint:
    """One point of a mission.

    Parameters
    ----------
    position : array_like, shape (axes,)
        Position [m].
    velocity, acceleration : array_like, shape (axes,), or "free", optional
        State at the point [m/s, m/s2]; rest by default. With "free", or None for single axes,
        `plan` chooses a state that makes the move short; before planning it is NaN. The higher
        derivatives are zero.
    dwell : float
        Time to rest there [s]; only if the point is at rest.

    Raises
    ------
    InputError
        For different shapes and for numbers that are not finite.
    """

    position: FloatArray
    velocity: FloatArray
    acceleration: FloatArray
    dwell: float = field(default=0.0)

    def __init__(
        self,
        position: ArrayLike,
        velocity: ArrayLike | str | None = None,
        acceleration: ArrayLike | str | None = None,
        dwell: float = 0.0,
    ) -> None:
        values = finite_vector("position", position)
        object.__setattr__(self, "position", values)
        for name, given in (("velocity", velocity), ("acceleration", acceleration)):
            vector = _state(name, given, values.size)
            if vector.size != values.size:
                raise InputError(
                    f"{name} has {vector.size} values, position has {values.size}; "
                    "give one value per axis"
                )
            object.__setattr__(self, name, vector)
        rest = finite_vector("dwell", dwell)
        if rest.size != 1 or rest[0] < 0.0:
            raise InputError(f"dwell must be a time >= 0 s, got {dwell!r}")
        object.__setattr__(self, "dwell", float(rest[0]))

    @property
    def axes(self) -> int:
        """Number of axes."""
        return int(self.position.size)


def _state(name: str, given: ArrayLike | str | None, axes: int) -> FloatArray:
    """Finite numbers; NaN for a free state."""
    if given is None:
        return finite_vector(name, np.zeros(axes))
    if isinstance(given, str):
        if given != "free":
            raise InputError(f'{name} must be numbers or "free", got {given!r}')
        vector = np.full(axes, np.nan)
        vector.flags.writeable = False
        return vector
    if not isinstance(given, list | tuple) or None not in given:
        return finite_vector(name, given)
    vector = finite_vector(name, [0.0 if v is None else v for v in given]).copy()
    vector[[v is None for v in given]] = np.nan
    vector.flags.writeable = False
    return vector
