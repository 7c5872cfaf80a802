"""Checked conversion of user input to arrays."""

from __future__ import annotations

from math import inf, isfinite
from operator import index
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from segfmu.errors import InputError

FloatArray = NDArray[np.float64]
ABSENT = np.zeros(())
ABSENT.flags.writeable = False


def finite_vector(name: str, value: ArrayLike) -> FloatArray:
    """Return `value` as a read-only vector of finite numbers, shape (axes,)."""
    array = numbers(name, value)
    if array.ndim == 0:
        array = array.reshape(1)
    if array.ndim != 1 or array.size == 0:
        raise InputError(f"{name} must be one number per axis, not an array of shape {array.shape}")
    if not all(map(isfinite, array.tolist())):
        raise InputError(f"{name} must be finite, got {array.tolist()}")
    array.flags.writeable = False
    return array


def finite_number(name: str, value: ArrayLike) -> float:
    """Return `value` as a finite number; an array of one is one."""
    if isinstance(value, float) and isfinite(value):
        return float(value)
    vector = finite_vector(name, value)
    if vector.size != 1:
        raise InputError(f"{name} must be one number, got {vector.tolist()}")
    return float(vector[0])


def as_tuple(name: str, value: Any) -> tuple[Any, ...]:
    """Return a sequence as a tuple."""
    try:
        return tuple(value)
    except TypeError:
        raise InputError(f"{name} must be a sequence, got {shown(value)}") from None


def as_index(name: str, value: Any, most: float = inf) -> int:
    """Return `value` as an integer from 0 to `most`."""
    try:
        number = None if isinstance(value, bool) else index(value)
    except TypeError:
        number = None
    if number is None:
        raise InputError(f"{name} must be an integer, got {shown(value)}")
    if not 0 <= number <= most:
        bounds = "at least 0" if most == inf else f"from 0 to {most}"
        raise InputError(f"{name} must be {bounds}, got {shown(number)}")
    return number


def shown(value: Any) -> str:
    """What a message shows of a value: one line, not long."""
    text = " ".join(repr(value).split())
    return text if len(text) <= 60 else f"{text[:57]}..."


def limit_values(name: str, value: ArrayLike | None, *, required: bool) -> FloatArray:
    """Return a limit as positive numbers, 0-d or (axes,); None or infinity becomes 0: absent."""
    if value is None and not required:
        return ABSENT
    array = numbers(name, [inf if v is None else v for v in value]
                     if isinstance(value, list | tuple) else inf if value is None else value)
    if array.ndim > 1 or array.size == 0:
        raise InputError(f"{name} must be a number or one per axis, got shape {array.shape}")
    values = array.ravel().tolist()
    if not all(v > 0.0 for v in values):
        raise InputError(f"{name} must be greater than 0, got {array.tolist()}")
    if inf in values:
        if required:
            raise InputError(f"{name} must be finite, got {array.tolist()}")
        array[np.isinf(array)] = 0.0
    array.flags.writeable = False
    return array


def numbers(name: str, value: Any) -> FloatArray:
    try:
        raw = np.asarray(value)
        if raw.dtype.kind not in "iuf":
            raise TypeError
        return np.array(raw, dtype=np.float64)
    except (TypeError, ValueError):
        raise InputError(
            f"{name} must be a number or a list of numbers, got {shown(value)}"
        ) from None
