"""Results that are kept while they are in use: the last few of a function's."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Callable, Hashable
from typing import Generic, TypeVar

Value = TypeVar("Value")


class Kept(Generic[Value]):
    """The values that were asked for last, by key.

    Parameters
    ----------
    most : int
        Values that are kept.
    drop : callable
        Called with each value that no longer is.
    """

    def __init__(self, most: int, drop: Callable[[Value], object] = lambda _: None) -> None:
        self._most, self._drop = most, drop
        self._values: OrderedDict[Hashable, Value] = OrderedDict()

    def get(self, key: Hashable, make: Callable[[], Value]) -> Value:
        """The value of a key, made if it is not there."""
        if key not in self._values:
            self._values[key] = make()
            if len(self._values) > self._most:
                self._drop(self._values.popitem(last=False)[1])
        self._values.move_to_end(key)
        return self._values[key]

    def clear(self) -> None:
        """Drop everything."""
        while self._values:
            self._drop(self._values.popitem()[1])


class Right:
    """Keys of what was found right: runs of a campaign have most of it in common.

    Threads may share it. When it is full it begins anew.

    Parameters
    ----------
    most : int
        Keys that are remembered.
    """

    def __init__(self, most: int) -> None:
        self._most = most
        self._keys: set[Hashable] = set()

    def __contains__(self, key: Hashable) -> bool:
        return key in self._keys

    def add(self, key: Hashable) -> None:
        """Remember a key."""
        if len(self._keys) >= self._most:
            self._keys.clear()
        self._keys.add(key)
