"""The layers: who may import whom, and what importing segfmu must not load."""

from __future__ import annotations

import ast
import subprocess
import sys
from functools import cache
from pathlib import Path

import pytest

SOURCE = Path(__file__).parents[1] / "src" / "segfmu"

ALLOWED = {
    "errors": set(),
    "folders": {"errors"},
    "arrays": {"errors"},
    "kernels": {"errors"},
    "planning": {"arrays", "errors", "kernels"},
    "crane": {"arrays", "errors", "kernels", "planning"},
    "codegen": {"arrays", "errors", "kernels", "planning", "crane"},
    "fmu": {"arrays", "errors", "folders", "kernels", "planning", "crane"},
    "cosim": {"arrays", "errors", "folders", "kernels", "planning", "crane", "fmu"},
    "validation": {"arrays", "errors", "folders", "kernels", "planning", "crane", "fmu", "cosim"},
    "cli": {"errors", "kernels", "planning", "crane", "fmu", "cosim", "validation"},
    "__init__": {"errors", "planning", "crane", "validation"},
    "__main__": {"cli"},
}

EXTERNAL = {
    "sympy": {"crane/lagrangian.py", "crane/hook/lagrangian.py", "crane/flatness.py", "codegen"},
    "fmpy": {"cosim"},
    "pythonfmu": {"fmu"},
    "matplotlib": {"validation"},
    "jinja2": {"validation/report"},
    "pandas": {"validation"},
    "dask": {"validation/campaigns/cluster.py"},
    "distributed": {"validation/campaigns/cluster.py"},
    "pyarrow": {"validation/campaigns"},
    "openturns": {"validation/campaigns/rare.py"},
    "plotly": {"validation/report"},
    "tomlkit": {"validation/identification"},
}

FILES = sorted(SOURCE.rglob("*.py"))


@cache
def imports(path: Path) -> set[str]:
    """Full names of all modules that a file imports, wherever in the file."""
    found = set()
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            found.update(alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, f"{path}: imports are absolute"
            found.add(node.module or "")
            found.update(f"{node.module}.{alias.name}" for alias in node.names)
    return found


def loaded(code: str, heavy: set[str]) -> str:
    """The heavy modules that code has loaded in the end, printed in their order."""
    code = f"{code}\nimport sys; print(sorted(set(sys.modules) & {heavy!r}))"
    return subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True, timeout=60
    ).stdout.strip()


def layer(path: Path) -> str:
    """The layer of a file: its folder below segfmu, or its own name."""
    parts = path.relative_to(SOURCE).parts
    return parts[0] if len(parts) > 1 else path.stem


@pytest.mark.parametrize("own", ALLOWED)
def test_imports_point_one_way(own: str) -> None:
    for path in (p for p in FILES if layer(p) == own):
        used = {name.split(".")[1] for name in imports(path) if name.startswith("segfmu.")}
        # `from segfmu import x` would hide the layer
        assert "segfmu" not in imports(path), path
        assert used - {own} <= ALLOWED[own], path


def test_every_file_is_in_a_layer() -> None:
    assert {layer(path) for path in FILES} == set(ALLOWED)


@pytest.mark.parametrize("package", EXTERNAL)
def test_heavy_packages_stay_in_their_place(package: str) -> None:
    users = {
        path.relative_to(SOURCE).as_posix() for path in FILES
        if any(name.split(".")[0] == package for name in imports(path))
    }
    places = EXTERNAL[package]
    assert [u for u in users if not any(u == p or u.startswith(f"{p}/") for p in places)] == []


def test_the_rules_see_an_import_inside_a_function(tmp_path: Path) -> None:
    module = tmp_path / "module.py"
    module.write_text("def f():\n    from sympy import Symbol\n", encoding="utf-8")
    assert "sympy" in imports(module)


@pytest.mark.parametrize(
    ("code", "heavy"),
    [
        ("import segfmu; [getattr(segfmu, name) for name in segfmu.__all__]", {*EXTERNAL}),
        # every command waits for them
        ("import segfmu.cli", {*EXTERNAL, "scipy"}),
    ],
    ids=["segfmu", "cli"],
)
def test_importing_loads_nothing_heavy(code: str, heavy: set[str]) -> None:
    assert loaded(code, heavy) == "[]"


def test_what_writes_a_report_of_a_run_loads_no_statistics() -> None:
    """They take half a second; those of campaigns need them, which are in the same package."""
    heavy = {"scipy.stats", "scipy.optimize", "distributed", "pyarrow"}
    assert loaded("import segfmu.validation.report", heavy) == "[]"
