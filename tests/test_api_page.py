"""The API reference has every public name, with a docstring."""

from __future__ import annotations

import doctest
import re
from pathlib import Path

import pytest

import segfmu
from segfmu.validation.files.template import write
from tests.compiler import needs_native

PAGE = (Path(__file__).parents[1] / "docs/api.md").read_text(encoding="utf-8")
LISTED = set(re.findall(r"^\.\. auto(?:function|class):: (\w+)", PAGE, re.MULTILINE))
ERRORS = {n for n in segfmu.__all__ if n.endswith("Error")}


def test_the_page_lists_every_public_name() -> None:
    assert {"__version__"} | LISTED | ERRORS == set(segfmu.__all__)
    assert dir(segfmu) == segfmu.__all__
    assert ".. automodule:: segfmu.errors" in PAGE


@pytest.mark.parametrize("name", sorted(LISTED))
def test_what_is_listed_is_described(name: str) -> None:
    text = getattr(segfmu, name).__doc__
    assert text and ("Parameters" in text or "Attributes" in text)


SCENARIO = """name = "mission as it is"
mission = "mission.toml"

[[criteria]]
name = "load near its plan"
signal = "error.load.norm"
bound = 0.001
"""


@needs_native
@pytest.mark.parametrize("name", ["load_mission", "build", "simulate", "validate"])
def test_examples_show_what_happens(name: str, tmp_path: Path, monkeypatch) -> None:
    write(tmp_path)
    (tmp_path / "scenario.toml").write_text(SCENARIO, encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    (example,) = doctest.DocTestFinder(recurse=False).find(getattr(segfmu, name), name, globs={})
    runner = doctest.DocTestRunner()
    assert runner.run(example).failed == 0
    assert runner.tries > 1
