"""What a long call tells of its progress."""

from __future__ import annotations

from collections.abc import Callable

# what is being done, and the share of it that is done, from 0 to 1
Progress = Callable[[str, float], None]


def quiet(_: str, __: float) -> None:
    """Tell nothing."""
