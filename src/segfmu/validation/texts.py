"""Texts with names of files, whose bytes need not be UTF-8."""

from __future__ import annotations

from pathlib import Path

from segfmu.errors import InputError


def encodable(text: str) -> str:
    """The text, in which bytes of names that are no UTF-8 are escapes."""
    return text.encode("utf-8", "backslashreplace").decode("utf-8")


def require_utf8(path: Path) -> None:
    """Refuse a name that is not UTF-8, where files have to name it.

    Raises
    ------
    InputError
        That names it.
    """
    place = str(path.absolute())
    if encodable(place) != place:
        raise InputError(
            f"{place}: this name is not UTF-8, and a campaign's files have to name it; rename it"
        )
