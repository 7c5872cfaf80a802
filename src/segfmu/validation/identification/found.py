"""What a fit has found, in units of the unknowns' scales."""

from __future__ import annotations

from dataclasses import dataclass

from segfmu.arrays import FloatArray


@dataclass(frozen=True)
class Direction:
    """A combination of unknowns that the signals do not tell.

    Attributes
    ----------
    held : int
        The unknown that was held, so that the others are told.
    parts : tuple of (int, float)
        All that change together, in units of their scales, the largest first.
    """

    held: int
    parts: tuple[tuple[int, float], ...]


@dataclass(frozen=True, eq=False)
class Fit:
    """A fit.

    Attributes
    ----------
    point : ndarray, shape (unknowns,)
    half : ndarray, shape (unknowns,)
        Half of the intervals; NaN of unknowns that were held.
    free : tuple of int
        Unknowns that were not held.
    directions : tuple of Direction
    noise : list of ndarray, shape (5,)
        Standard deviations of every log's signals.
    converged : bool
        Whether the last fit came to its end.
    """

    point: FloatArray
    half: FloatArray
    free: tuple[int, ...]
    directions: tuple[Direction, ...]
    noise: list[FloatArray]
    converged: bool
