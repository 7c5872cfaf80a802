"""Generated files are those of the sources that are there now."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

from segfmu.codegen import crane, origin


def test_nothing_has_changed_since_the_files_were_generated() -> None:
    told = "a source or a generated file has changed: make generate writes all again"
    assert origin.TARGET.read_text(encoding="utf-8") == origin.generate(), told


@pytest.mark.parametrize("changed", [
    "kernels/crane/rope.py", "kernels/crane/_crane.py", "kernels/c/kernels.c", "codegen/native.py",
    "crane/flatness.py", "crane/hook/lagrangian.py",
])
def test_a_change_of_any_of_them_is_told(
    changed: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    before, read = origin.generate(), Path.read_text

    def other(path: Path, encoding: str) -> str:
        text = read(path, encoding=encoding)
        return f"{text} " if path == origin.PACKAGE / changed else text

    monkeypatch.setattr(Path, "read_text", other)
    assert origin.generate() != before


def test_another_version_of_a_tool_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    before = origin.generate()
    monkeypatch.setattr(origin, "version", lambda tool: "0")
    assert origin.generate() != before


def test_no_source_is_forgotten() -> None:
    """All that generators and the sources of equations import of the package is among them."""
    known = set(origin.files())
    assert crane.TARGET in known
    general = {origin.PACKAGE / name for name in ("errors.py", "arrays.py")}
    for path in known - set((origin.PACKAGE / "kernels").rglob("*")):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.ImportFrom) and (node.module or "").startswith("segfmu"):
                place = origin.PACKAGE.joinpath(*(node.module or "").split(".")[1:])
                found = {place / f"{alias.name}.py" for alias in node.names}
                files = {f for f in found if f.exists()} or {place.with_suffix(".py")}
                assert files <= known | general, (path, files)
