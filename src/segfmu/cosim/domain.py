"""Values that a variable of an FMU takes."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from math import inf, isfinite
from typing import Any

import numpy as np

from segfmu.arrays import shown
from segfmu.errors import InputError

# what messages say of values without names
USUAL: Mapping[type, str] = {float: "a number", int: "an integer", bool: "true or false"}


@dataclass(frozen=True)
class Domain:
    """Values of one variable, which is no text.

    Attributes
    ----------
    kind : type
        float, int or bool.
    least, most : float
        Its range.
    items : mapping of str to int
        Values that have names.
    """

    kind: type
    least: float = -inf
    most: float = inf
    items: Mapping[str, int] = field(default_factory=dict)

    @property
    def bounded(self) -> bool:
        """Whether there is a least or a greatest value."""
        return self.least > -inf or self.most < inf

    def number(self, name: str, value: Any) -> float | int:
        """A value as a number of the variable's kind, whatever its range; `name` is for messages.

        Raises
        ------
        InputError
            For a value of another kind.
        """
        if isinstance(value, str):
            if value not in self.items:
                allowed = ", ".join(self.items) or USUAL[self.kind]
                raise InputError(f"{name} takes {allowed}, got {shown(value)}")
            return self.items[value]
        if isinstance(value, bool | np.bool_) and self.kind is not bool:
            raise InputError(f"{name} takes a number, got {shown(value)}")
        try:
            number = float(value)
        except (TypeError, ValueError, OverflowError):
            raise InputError(f"{name} takes a number, got {shown(value)}") from None
        if self.kind is float:
            return number
        whole = isfinite(number) and number == int(number)
        if not whole or (self.kind is bool and number not in (0.0, 1.0)):
            raise InputError(f"{name} takes {USUAL[self.kind]}, got {shown(value)}")
        # exact where a float is not
        return value if isinstance(value, int) else int(number)

    def require_within(self, name: str, value: Any) -> None:
        """InputError for a number outside of the range."""
        # what else is no number is told with its type
        if isinstance(value, int | float) and not self.least <= value <= self.most:
            bound = f"least {self.least:.15g}" if value < self.least else f"most {self.most:.15g}"
            raise InputError(f"{name} must be at {bound}, got {shown(value)}")


def domain(variable: Any, kind: type) -> Domain:
    """That of a variable as fmpy describes it, of this kind."""
    declared = getattr(variable.declaredType, "items", None) or ()
    items = {item.name: int(item.value) for item in declared}
    numbers = items.values()
    return Domain(
        kind, float(variable.min or min(numbers, default=-inf)),
        float(variable.max or max(numbers, default=inf)), items,
    )
