"""Checks of the user's numbers."""

from __future__ import annotations

from collections.abc import Container, Mapping
from math import isfinite
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from segfmu.arrays import FloatArray, shown, sized
from segfmu.errors import InputError
from segfmu.kernels.crane.records import Axes

LARGEST_SEED = 2**31 - 1
# of noise [Hz]; as with the shortest sample time, each period takes steps of the integration
HIGHEST_FREQUENCY = 1e6


def require_kind(name: str, value: object, kind: type) -> None:
    """Raise InputError unless `value` is an object of this class."""
    if not isinstance(value, kind):
        raise InputError(f"{name} must be of class {kind.__name__}, got {type(value).__name__}")


def require_finite(name: str, value: object) -> None:
    """Raise InputError unless `value` is a finite number."""
    if not _finite(value):
        raise InputError(f"{name} must be a finite number, got {shown(value)}")


def require_number(name: str, value: object) -> None:
    """Raise InputError unless `value` is a number, also infinity or NaN."""
    if not _finite(value) and not isinstance(value, float | np.floating):
        raise InputError(f"{name} must be a number, got {shown(value)}")


def require_positive(name: str, value: object) -> None:
    """Raise InputError unless `value` is a finite number above 0."""
    if not _finite(value) or value <= 0:  # type: ignore[operator]
        raise InputError(f"{name} must be a finite number > 0, got {shown(value)}")


def require_negative(name: str, value: object) -> None:
    """Raise InputError unless `value` is a finite number below 0."""
    if not _finite(value) or value >= 0:  # type: ignore[operator]
        raise InputError(f"{name} must be a finite number < 0, got {shown(value)}")


def require_quantity(name: str, value: object) -> None:
    """Raise InputError unless `value` is a number from 1e-9 to 1e9, as crane files have them."""
    require_positive(name, value)
    # as a float: the bounds can be beyond a shorter type of NumPy
    if not 1e-9 <= float(value) <= 1e9:  # type: ignore[arg-type]
        raise InputError(f"{name} must be from 1e-9 to 1e9, got {shown(value)}")


def require_frequency(name: str, value: object) -> None:
    """Raise InputError unless `value` is a frequency [Hz] that can be integrated."""
    require_positive(name, value)
    if float(value) > HIGHEST_FREQUENCY:  # type: ignore[arg-type]
        raise InputError(f"{name} must be at most {HIGHEST_FREQUENCY:g} Hz, got {shown(value)}")


def require_not_negative(name: str, value: object) -> None:
    """Raise InputError unless `value` is a finite number of at least 0."""
    if not _finite(value) or value < 0:  # type: ignore[operator]
        raise InputError(f"{name} must be a finite number >= 0, got {shown(value)}")


def require_weights(weights: Mapping[str, Any], needed: Container[str]) -> None:
    """Raise InputError unless weights by name are finite and at least 0, those needed above 0."""
    for name, value in weights.items():
        if not _finite(value) or value < 0.0 or (name in needed and value == 0.0):
            raise InputError(f"weight {name} must be positive and finite, got {shown(value)}")


def require_seed(name: str, value: object) -> None:
    """Raise InputError unless `value` is an integer from 0 to 2^31 - 1."""
    integer = isinstance(value, int | np.integer) and not isinstance(value, bool)
    if not integer or not 0 <= value <= LARGEST_SEED:  # type: ignore[operator]
        raise InputError(f"{name} must be an integer from 0 to {LARGEST_SEED}, got {shown(value)}")


def lags_of(name: str, lag: ArrayLike) -> FloatArray:
    """Lags of the three drives [s] from one or three values.

    Raises
    ------
    InputError
        For other numbers of values and for negative ones.
    """
    found = sized(name, lag, Axes.SIZE, alike=True)
    for entry in found.tolist():
        require_not_negative(name, entry)
    return found


def _finite(value: object) -> bool:
    if isinstance(value, bool) or not isinstance(value, int | float | np.integer | np.floating):
        return False
    try:
        return isfinite(value)
    except OverflowError:
        # an integer that is too large for a float
        return False
