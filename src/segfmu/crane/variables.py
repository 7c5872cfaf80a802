"""Conversion between dataclasses and FMU variables, by the fields of the kernels' records.

Only the records name the variables. A class declares once which of them its fields are, so the
Python simulation and the slave on PythonFMU fill the same records.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial, wraps
from typing import Any, TypeVar

import numpy as np

from segfmu.arrays import FloatArray, shown
from segfmu.errors import InputError
from segfmu.kernels.records import Record

T = TypeVar("T")
Value = Callable[[str], Any]
# a crane has some ten parts, and cranes that come one after the other have most of them in common
MOST_BUILT = 64
_built: dict[tuple[Any, ...], Any] = {}


@dataclass(frozen=True)
class Fed:
    """The FMU variables of a field of a dataclass.

    Attributes
    ----------
    variables : tuple of str
        One per number of the field.
    none : tuple of float
        Their values if the field is None; empty if it cannot be None.
    items : tuple of str
        Of an enumeration, whose values count from 1.
    whole : bool
        The field is an integer.
    """

    variables: tuple[str, ...]
    none: tuple[float, ...] = ()
    items: tuple[str, ...] = ()
    whole: bool = False

    def numbers(self, field: Any) -> tuple[float, ...]:
        """Values of the variables for a value of the field."""
        if field is None:
            return self.none
        if self.items:
            return (1 + self.items.index(field),)
        return tuple(field) if len(self.variables) > 1 else (field,)

    def field(self, value: Value) -> Any:
        """The value of the field for values of the variables, by name."""
        numbers = tuple(float(value(v)) for v in self.variables)
        if numbers == self.none:
            return None
        if self.items:
            return self.items[int(numbers[0]) - 1]
        if self.whole:
            return int(numbers[0])
        return numbers if len(numbers) > 1 else numbers[0]


def fed(
    record: type[Record],
    name: str,
    entry: int | None = None,
    *,
    none: tuple[float, ...] = (),
    items: tuple[str, ...] = (),
    whole: bool = False,
) -> Fed:
    """A field of a record, or one entry of it, as a field of a dataclass; the rest as in `Fed`."""
    variables = record.FIELDS[name].variables
    chosen = variables if entry is None else variables[entry : entry + 1]
    return Fed(chosen, none, items, whole)


def values(own: Any, mapping: Mapping[str, Fed]) -> dict[str, float]:
    """Values of the variables by name for a dataclass."""
    return {
        v: number
        for name, f in mapping.items()
        for v, number in zip(f.variables, f.numbers(getattr(own, name)), strict=True)
    }


def filled(record: type[Record], value: Value) -> FloatArray:
    """A record, shape (SIZE,), from the variables that feed it; `value` gives them by name."""
    array = np.zeros(record.SIZE)
    record.fill(array, value)
    return array


def of_values(make: Callable[[type[T], Value], T]) -> Callable[[type[T], Value], T]:
    """A class method `of` that refuses, with an InputError, what gives no numbers by names."""

    @wraps(make)
    def of(kind: type[T], value: Value) -> T:
        if not callable(value):
            raise InputError(
                f"value must be a function of a variable's name, got {shown(value)}; of a dict d "
                "give d.__getitem__"
            )
        try:
            return make(kind, value)
        except InputError:
            raise
        except (TypeError, ValueError, OverflowError, LookupError) as error:
            raise InputError(
                "value must give a number for the name of every variable, got "
                f"{type(error).__name__}: {error}"
            ) from None

    return of


def build(kind: Callable[..., T], mapping: Mapping[str, Fed], value: Value) -> T:
    """A dataclass from the values of variables; `value` gives them by name."""
    return kind(**{name: f.field(value) for name, f in mapping.items()})


def kept(kind: Callable[..., T], mapping: Mapping[str, Fed], value: Value, **parts: Any) -> T:
    """The same of a frozen class, the one that was built last for the same numbers if there is.

    parts : fields that no variables of the mapping feed, of frozen classes as well.
    """
    key = kind, *parts.items(), *[float(value(v)) for f in mapping.values() for v in f.variables]
    found = _built.get(key)
    if found is None:
        found = build(partial(kind, **parts), mapping, value)
        if len(_built) >= MOST_BUILT:
            _built.clear()
        _built[key] = found
    return found
