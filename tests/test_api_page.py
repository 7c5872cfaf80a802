"""The API reference has every public name, with a docstring."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

import segfmu

PAGE = (Path(__file__).parents[1] / "docs/api.md").read_text(encoding="utf-8")
LISTED = set(re.findall(r"^\.\. auto(?:function|class):: (\w+)", PAGE, re.MULTILINE))
ERRORS = {n for n in segfmu.__all__ if n.endswith("Error")}


def test_the_page_lists_every_public_name() -> None:
    assert {"__version__"} | LISTED | ERRORS == set(segfmu.__all__)
    assert ".. automodule:: segfmu.errors" in PAGE


@pytest.mark.parametrize("name", sorted(LISTED))
def test_what_is_listed_is_described(name: str) -> None:
    text = getattr(segfmu, name).__doc__
    assert text and ("Parameters" in text or "Attributes" in text)
