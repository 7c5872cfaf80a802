"""Variables of an FMU, read or written in one call."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

from numpy.typing import NDArray


@dataclass(frozen=True)
class Channel:
    """A fixed list of variables of one type, and a buffer to read or write them at once.

    Attributes
    ----------
    values : ndarray, shape (n,)
        The buffer; its type is that of the FMU's variables.
    read, write : callable
        Get the variables into the buffer, and set them from it; SimulationError if the FMU
        refuses.
    """

    values: NDArray[Any]
    read: Callable[[], None]
    write: Callable[[], None]


def named(names: Sequence[str]) -> str:
    """A few words for a list of variables."""
    return names[0] if len(names) == 1 else f"{names[0]} and {len(names) - 1} more"
