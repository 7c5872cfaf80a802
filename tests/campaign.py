"""How much of a random campaign a test takes: `make soak` takes more of the same."""

from __future__ import annotations

import os
from typing import Any

import pytest

SOAK = bool(os.environ.get("SEGFMU_SOAK"))


def campaign(usual: int, soak: int, name: str = "count") -> pytest.MarkDecorator:
    """Give a test the argument `name`: `usual`, or in a soak `soak`."""
    assert usual < soak
    value = pytest.param(soak if SOAK else usual, marks=pytest.mark.soak)
    return pytest.mark.parametrize(name, [value])


def soaked(*values: object) -> list[Any]:
    """Values of an argument that only a soak takes: others tell the same in less time."""
    return [pytest.param(value, marks=pytest.mark.soak) for value in values] if SOAK else []


def soaked_rows(*rows: tuple[object, ...]) -> list[Any]:
    """The same of values of several arguments."""
    return [pytest.param(*row, marks=pytest.mark.soak) for row in rows] if SOAK else []
