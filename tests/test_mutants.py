"""The faults of mutants.toml can be made: `python -m tests.mutants` makes them."""

from __future__ import annotations

import shlex

import pytest

from tests.mutants import PACKAGE, ROOT, Mutant, listed


@pytest.mark.parametrize("mutant", listed([]), ids=str)
def test_a_fault_has_its_place_and_its_tests(mutant: Mutant) -> None:
    source = (ROOT / PACKAGE / mutant.file).read_text(encoding="utf-8")
    assert source.count(mutant.old) == 1 and mutant.old != mutant.new
    files = [word for word in shlex.split(mutant.tests) if word.startswith("tests/")]
    assert files and all((ROOT / file).exists() for file in files)
