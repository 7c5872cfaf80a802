"""Variables of an FMU that are read or written in one call."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

from numpy.typing import NDArray


@dataclass(frozen=True)
class Channel:
    """A fixed list of variables of one type, and the memory to read or write them at once.

    Attributes
    ----------
    values : ndarray, shape (n,)
        That memory; of the type that the FMU has for the variables.
    read, write : callable
        Fetch the variables into the memory, and set them from it; SimulationError when the FMU
        refuses.
    """

    values: NDArray[Any]
    read: Callable[[], None]
    write: Callable[[], None]


def named(names: Sequence[str]) -> str:
    """A few words for a list of variables."""
    return names[0] if len(names) == 1 else f"{names[0]} and {len(names) - 1} more"
