"""Calls of an FMU with fixed arguments, and variables that are read or written in one of them."""

from __future__ import annotations

import ctypes
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from segfmu.cosim.messages import WARNING

if TYPE_CHECKING:
    from segfmu.cosim.unit import Unit


@dataclass(frozen=True, eq=False)
class Call:
    """A function of an FMU with fixed arguments.

    Attributes
    ----------
    unit : Unit
        The FMU.
    doing : str
        What the call is for, after "could not".
    function : str
        The standard's name of the function.
    entry : ctypes function
        The function itself; a call through fmpy takes as long as the FMU.
    arguments : tuple of ctypes values
        Instance, value references, their number, and what follows in the standard.
    values : ndarray
        The buffer among them.
    """

    unit: Unit
    doing: str
    function: str
    entry: Any
    arguments: tuple[Any, ...]
    values: NDArray[Any]

    def __call__(self) -> None:
        """Call it; SimulationError if the FMU refuses."""
        status = self.entry(*self.arguments)
        if status > WARNING:
            raise self.unit.refusal(self.doing, self.function, status)


@dataclass(frozen=True)
class Channel:
    """A fixed list of variables of one type, and a buffer to read or write them at once.

    Attributes
    ----------
    values : ndarray, shape (n,)
        The buffer; its type is that of the FMU's variables.
    read, write : Call
        Get the variables into the buffer, and set them from it.
    """

    values: NDArray[Any]
    read: Call
    write: Call


@dataclass(frozen=True, eq=False)
class Copy:
    """Some values of one buffer, into a buffer of the same kind of value.

    Attributes
    ----------
    source, target : ndarray
        Buffers.
    index : ndarray of int64, shape of target, optional
        Which values of the source; by default all.
    """

    source: NDArray[Any]
    target: NDArray[Any]
    index: NDArray[np.int64] | None = None

    def __call__(self) -> None:
        """Copy them."""
        self.target[:] = self.source if self.index is None else self.source[self.index]


def gathered(source: NDArray[Any], index: NDArray[np.int64], target: NDArray[Any]) -> Copy:
    """The copy of some values, of a slice where they follow each other."""
    first = int(index[0])
    if np.array_equal(index, np.arange(first, first + index.size)):
        return Copy(source[first:first + index.size], target)
    return Copy(source, target, index)


def address(values: NDArray[Any]) -> ctypes.c_void_p:
    """Pointer to a buffer; it keeps the memory alive."""
    return values.ctypes.data_as(ctypes.c_void_p)


def named(names: Sequence[str]) -> str:
    """A few words for a list of variables."""
    return names[0] if len(names) == 1 else f"{names[0]} and {len(names) - 1} more"
