"""Checked conversion of user input to arrays."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import fields
from math import inf, isfinite
from operator import index
from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from segfmu.errors import InputError

FloatArray = NDArray[np.float64]
# one bound, or one per axis of which some may be None
Range = ArrayLike | Sequence[float | None] | None
# checked in each plan: a union made on the spot takes as long as the check
SEQUENCES = (list, tuple)
ABSENT = np.array(inf)
ABSENT.flags.writeable = False
# of a limit in the negative direction: as in the positive one
SAME = np.array(-inf)
SAME.flags.writeable = False


class Frozen:
    """Base of frozen data classes of arrays.

    Arrays stay read-only in copies, also in those by pickle. Objects are equal if all values are:
    NaN, which stands for a free state, equals NaN, and -0 equals 0.
    """

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Frozen) or type(other) is not type(self):
            return NotImplemented
        return self is other or self._values() == other._values()

    def __hash__(self) -> int:
        return hash(self._values())

    def _values(self) -> tuple[object, ...]:
        given = (getattr(self, f.name) for f in fields(self))  # type: ignore[arg-type]
        return tuple(
            (v.shape, (v + 0.0).tobytes()) if isinstance(v, np.ndarray) else v for v in given
        )

    def __deepcopy__(self, _: dict[int, Any]) -> Self:
        return self

    def __setstate__(self, state: dict[str, Any]) -> None:
        for value in state.values():
            if isinstance(value, np.ndarray):
                value.flags.writeable = False
        # what is kept for later calls is made again
        self.__dict__.update({n: v for n, v in state.items() if not n.startswith("_")})


def finite_vector(name: str, value: ArrayLike) -> FloatArray:
    """Return `value` as a read-only vector of finite numbers, shape (axes,)."""
    array = numbers(name, value)
    if array.ndim == 0:
        array = array.reshape(1)
    values = array.tolist()
    if array.ndim > 1 or not values:
        raise InputError(f"{name} must be one number per axis, not an array of shape {array.shape}")
    if not all(map(isfinite, values)):
        raise InputError(f"{name} must be finite, got {values}")
    array.setflags(write=False)
    return array


def sized(name: str, value: ArrayLike, size: int, *, alike: bool = False) -> FloatArray:
    """Return `value` as a read-only vector of `size` finite numbers; `alike`: or one for all."""
    vector = finite_vector(name, value)
    if alike and vector.size == 1:
        vector = np.repeat(vector, size)
        vector.setflags(write=False)
    if vector.size != size:
        raise InputError(f"{name} must have {size} values, got {vector.size}")
    return vector


def range_bounds(name: str, value: Range, absent: float) -> FloatArray:
    """Return bounds of a range, 0-d or (axes,), read-only; None becomes `absent`, -inf or inf."""
    array = numbers(name, _replaced(value, absent))
    if array.ndim > 1 or array.size == 0:
        raise InputError(f"{name} must be a number or one per axis, got shape {array.shape}")
    if not all(isfinite(v) or v == absent for v in array.ravel().tolist()):
        raise InputError(
            f"{name} must be finite, or None or {absent} for no bound, got {_given(value)}"
        )
    array.setflags(write=False)
    return array


def finite_number(name: str, value: ArrayLike) -> float:
    """Return `value` as a finite number; an array of one is one."""
    if isinstance(value, float) and isfinite(value):
        return float(value)
    array = numbers(name, value, "one number")
    if array.size != 1 or array.ndim > 1:
        raise InputError(f"{name} must be one number, got {_given(value)}")
    number = array.item()
    if not isfinite(number):
        raise InputError(f"{name} must be finite, got {number}")
    return number


def finite_times(t: ArrayLike) -> FloatArray:
    """Return times of any shape as finite numbers."""
    times = numbers("t", t)
    if not np.isfinite(times).all():
        raise InputError("t must be finite")
    return times


def as_tuple(name: str, value: Any) -> tuple[Any, ...]:
    """Return a sequence as a tuple; mappings, tables and bytes are none."""
    # to look for a mapping takes longer than all else
    if type(value) in (tuple, list):
        return tuple(value)
    if isinstance(value, Mapping | bytes) or hasattr(value, "columns"):
        raise InputError(f"{name} must be a sequence, got {shown(value)}")
    return _as_tuple(name, value)


def as_names(name: str, value: Any) -> tuple[str, ...]:
    """Return a sequence of names as a tuple; a single name is none."""
    found = () if isinstance(value, str) else _as_tuple(name, value)
    if isinstance(value, str) or not all(isinstance(v, str) for v in found):
        raise InputError(f"{name} must be a sequence of names, got {shown(value)}")
    return found


def _as_tuple(name: str, value: Any) -> tuple[Any, ...]:
    try:
        return tuple(value)
    except TypeError:
        raise InputError(f"{name} must be a sequence, got {shown(value)}") from None


def as_index(name: str, value: Any, most: float = inf, *, least: int = 0) -> int:
    """Return `value` as an integer from `least` to `most`."""
    try:
        number = None if isinstance(value, bool) else index(value)
    except TypeError:
        number = None
    if number is None:
        raise InputError(f"{name} must be an integer, got {shown(value)}")
    if not least <= number <= most:
        bounds = f"at least {least}" if most == inf else f"from {least} to {most}"
        raise InputError(f"{name} must be {bounds}, got {shown(number)}")
    return number


def as_flag(name: str, value: Any) -> bool:
    """Return `value` as True or False; nothing else is one."""
    if not isinstance(value, bool | np.bool_):
        raise InputError(f"{name} must be True or False, got {shown(value)}")
    return bool(value)


def table_of(name: str, value: ArrayLike, *shape: int | None) -> FloatArray:
    """Return `value` as a read-only array of finite numbers; of any size where `shape` has None."""
    array = numbers(name, value, "an array of numbers")
    fits = len(shape) == array.ndim and all(
        n is None or n == own for n, own in zip(shape, array.shape, strict=True)
    )
    if not fits:
        told = ", ".join("any" if n is None else str(n) for n in shape)
        raise InputError(f"{name} must have shape ({told}), got {array.shape}")
    if not np.isfinite(array).all():
        raise InputError(f"{name} must be finite")
    array.setflags(write=False)
    return array


def require_mapping(name: str, value: Any) -> None:
    """InputError for what is no mapping."""
    if not isinstance(value, Mapping):
        raise InputError(f"{name} must be a mapping from names, got {shown(value)}")


def require_callable(name: str, value: Any) -> None:
    """InputError for what cannot be called."""
    if not callable(value):
        raise InputError(f"{name} must be a function, got {shown(value)}")


def shown(value: Any) -> str:
    """What a message shows of a value: one line, not long."""
    try:
        text = " ".join(repr(value).split())
    except ValueError:
        # an integer of more digits than Python writes
        text = f"{type(value).__name__} of thousands of digits"
    return text if len(text) <= 60 else f"{text[:57]}..."


def limit_values(name: str, value: ArrayLike | None, *, required: bool) -> FloatArray:
    """Return a limit as positive numbers, 0-d or (axes,); None becomes infinity: absent."""
    if value is None and not required:
        return ABSENT
    array = numbers(name, _replaced(value, inf))
    if array.ndim > 1 or array.size == 0:
        raise InputError(f"{name} must be a number or one per axis, got shape {array.shape}")
    values = array.ravel().tolist()
    # as a generator it would take as long as all else here
    if not all(map((0.0).__lt__, values)):
        raise InputError(f"{name} must be greater than 0, got {_given(value)}")
    if required and inf in values:
        raise InputError(f"{name} must be finite, got {_given(value)}")
    array.setflags(write=False)
    return array


def lower_values(name: str, value: Range) -> FloatArray:
    """Return limits in the negative direction, 0-d or (axes,); None becomes -infinity."""
    if value is None:
        return SAME
    array = numbers(name, _replaced(value, -inf))
    if array.ndim > 1 or array.size == 0:
        raise InputError(f"{name} must be a number or one per axis, got shape {array.shape}")
    if not all(v < 0.0 for v in array.ravel().tolist()):
        raise InputError(
            f"{name} must be less than 0, got {_given(value)}; leave it out for the same in both "
            "directions"
        )
    array.setflags(write=False)
    return array


def _replaced(value: Any, absent: float) -> Any:
    """A value with a number in place of None."""
    if isinstance(value, SEQUENCES):
        return [absent if v is None else v for v in value]
    return absent if value is None else value


def _given(value: Any) -> str:
    """What a message shows of numbers as they were given."""
    return shown(value.tolist() if isinstance(value, np.ndarray | np.generic) else value)


def numbers(name: str, value: Any, kind: str = "a number or a list of numbers") -> FloatArray:
    if type(value) is np.ndarray and value.dtype == np.float64:
        return value.copy()
    if isinstance(value, np.ma.MaskedArray):
        raise InputError(f"{name} must not be a masked array; leave out or fill what is masked")
    try:
        raw = np.asarray(value)
        if raw.dtype.kind not in "iuf":
            raise TypeError
        return np.array(raw, dtype=np.float64)
    except (TypeError, ValueError):
        raise InputError(f"{name} must be {kind}, got {shown(value)}") from None
