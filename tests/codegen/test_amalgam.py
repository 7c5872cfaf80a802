"""Names of records and constants in kernels become numbers."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

from segfmu.codegen import amalgam
from segfmu.errors import BuildError


@pytest.fixture
def written(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A module among the kernels."""
    monkeypatch.setattr(amalgam, "KERNELS", tmp_path)
    (tmp_path / "new").mkdir()
    return tmp_path / "new" / "module.py"


def test_constants_of_a_module_and_of_others_become_numbers(written: Path) -> None:
    written.write_text(
        "from segfmu.kernels.numerics.numbers import NEVER\n\nLIMIT = -2.5e-3\nMOST = 7\n\n\n"
        "def least(a: float) -> float:\n    return max(LIMIT, a, -NEVER, MOST)\n"
    )
    tree = ast.parse(amalgam.resolved("new.module"))
    (function,) = (node for node in tree.body if isinstance(node, ast.FunctionDef))
    assert ast.unparse(function.body[0]) == "return max(-0.0025, a, -1e+300, 7)"


@pytest.mark.parametrize("line", ["LIMIT = LEAST = 1.0", "LIMIT = [1.0]", "LIMIT = 2.0 * 3.0"])
def test_a_constant_is_one_number(written: Path, line: str) -> None:
    written.write_text(f"{line}\n")
    with pytest.raises(BuildError, match=r"kernels/new\.module\.py:1: a constant has to be"):
        amalgam.resolved("new.module")


def test_nothing_else_stands_at_the_top(written: Path) -> None:
    written.write_text("LIMIT: float = 1.0\n")
    with pytest.raises(BuildError, match="only functions and constants translate"):
        amalgam.amalgamated()
