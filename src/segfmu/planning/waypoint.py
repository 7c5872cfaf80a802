"""A point that the trajectory passes in a given state: P_j of section 3."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import lru_cache
from operator import attrgetter

import numpy as np
from numpy.typing import ArrayLike

from segfmu.arrays import (
    SEQUENCES,
    FloatArray,
    Frozen,
    as_index,
    finite_number,
    finite_vector,
    shown,
)
from segfmu.errors import InputError

DERIVATIVES = ("velocity", "acceleration", "jerk", "snap", "crackle", "pop")
# how many of them may be free
FREE = 2
_rows: Callable[[object], tuple[FloatArray, ...]] = attrgetter("position", *DERIVATIVES)


@dataclass(frozen=True, eq=False)
class Waypoint(Frozen):
    """One point of a mission.

    Parameters
    ----------
    position : array_like, shape (axes,)
        Position [m].
    velocity, acceleration : array_like, shape (axes,), or "free", optional
        State at the point [m/s, m/s2]; rest by default. With "free", or None for single axes,
        `plan` chooses a state that makes the move short; before planning it is NaN. At the first
        and the last waypoint, and at one with a dwell, what is free becomes zero.
    jerk, snap, crackle, pop : array_like, shape (axes,), optional
        Higher derivatives [m/s3 .. m/s6] of the first waypoint of a plan, as far as its smoothness
        has them continuous; zero by default, and at all other waypoints.
    dwell : float
        Time to rest there [s]; only if the point is at rest.

    Attributes
    ----------
    axes : int
        Number of axes.
    planned : ndarray, shape (axes, 3)
        Position, velocity and acceleration.
    free : bool
        Whether a velocity or acceleration is free.
    settled : bool
        Whether all derivatives above the acceleration are zero.

    Raises
    ------
    InputError
        For different shapes and for numbers that are not finite.
    """

    position: FloatArray
    velocity: FloatArray
    acceleration: FloatArray
    jerk: FloatArray
    snap: FloatArray
    crackle: FloatArray
    pop: FloatArray
    dwell: float = field(default=0.0)
    axes: int = field(init=False, repr=False)
    planned: FloatArray = field(init=False, repr=False)
    free: bool = field(init=False, repr=False)
    settled: bool = field(init=False, repr=False)

    def __init__(
        self,
        position: ArrayLike,
        velocity: ArrayLike | str | None = None,
        acceleration: ArrayLike | str | None = None,
        jerk: ArrayLike | None = None,
        snap: ArrayLike | None = None,
        crackle: ArrayLike | None = None,
        pop: ArrayLike | None = None,
        dwell: float = 0.0,
    ) -> None:
        values = finite_vector("position", position)
        axes = values.size
        vectors = dict.fromkeys(DERIVATIVES, _zeros(axes))
        states = velocity, acceleration, jerk, snap, crackle, pop
        free, settled = False, True
        for i, (name, given) in enumerate(zip(DERIVATIVES, states, strict=True)):
            if given is None:
                continue
            if i < FREE:
                vector, is_free = _state(name, given, axes)
                free = free or is_free
            else:
                vector = finite_vector(name, given)
                settled = settled and not vector.any()
            if vector.size != axes:
                raise InputError(
                    f"{name} needs one value per axis, as position has them: {axes}, got "
                    f"{vector.size}"
                )
            vectors[name] = vector
        rest = finite_number("dwell", dwell)
        if rest < 0.0:
            raise InputError(f"dwell must be a time >= 0 s, got {shown(dwell)}")
        rows = np.array((values, vectors["velocity"], vectors["acceleration"]))
        rows.setflags(write=False)
        vars(self).update(
            vectors, position=values, dwell=rest, axes=axes, planned=rows.T, free=free,
            settled=settled,
        )

    def state(self, order: int) -> FloatArray:
        """Position and the derivatives 1 .. order, at most 6, shape (axes, order + 1).

        Raises
        ------
        InputError
            For another order.
        """
        count = as_index("order", order, len(DERIVATIVES)) + 1
        return np.array(_rows(self)[:count]).T.copy()


def waypoint_of(states: FloatArray) -> Waypoint:
    """The waypoint of position and derivatives 1 .. n that are finite, shape (axes, n + 1).

    As nothing is checked, it takes a tenth of the time of `Waypoint`.
    """
    axes, width = states.shape
    rows = np.zeros((1 + len(DERIVATIVES), axes))
    rows[:width] = states.T
    rows.setflags(write=False)
    point = object.__new__(Waypoint)
    vars(point).update(
        zip(("position", *DERIVATIVES), rows, strict=True), dwell=0.0, axes=axes,
        planned=rows[: 1 + FREE].T, free=False, settled=not np.count_nonzero(rows[1 + FREE :]),
    )
    return point


@lru_cache(maxsize=16)
def _zeros(axes: int) -> FloatArray:
    zeros = np.zeros(axes)
    zeros.flags.writeable = False
    return zeros


def _state(name: str, given: ArrayLike | str, axes: int) -> tuple[FloatArray, bool]:
    """Finite numbers, NaN where the state is free, and whether one is."""
    if isinstance(given, np.ndarray) and given.dtype.hasobject:
        given = given.tolist()
    if isinstance(given, str):
        if given != "free":
            raise InputError(f'{name} must be numbers or "free", got {shown(given)}')
        vector = np.full(axes, np.nan)
        vector.flags.writeable = False
        return vector, True
    if not isinstance(given, SEQUENCES) or not any(v is None for v in given):
        return finite_vector(name, given), False
    try:
        vector = finite_vector(name, [0.0 if v is None else v for v in given]).copy()
    except InputError:
        raise InputError(
            f"{name} must be finite numbers, None where free, got {shown(given)}"
        ) from None
    vector[[v is None for v in given]] = np.nan
    vector.flags.writeable = False
    return vector, True
