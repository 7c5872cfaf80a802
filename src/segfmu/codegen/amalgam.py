"""kernels/**/*.py -> one module of functions, with numbers in place of the names of constants."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from functools import cache
from importlib import import_module
from pathlib import Path

from segfmu.errors import BuildError
from segfmu.kernels.records import Codes, Record

KERNELS = Path(__file__).parents[1] / "kernels"
PACKAGE = "segfmu.kernels"
# modules of a room that have no kernels
DECLARATIONS = ("__init__", "records", "entry_points")


def modules() -> list[str]:
    """Kernel modules below `segfmu.kernels`, each after those that it imports."""
    paths = sorted(KERNELS.glob("*/*.py"))
    names = [f"{p.parent.name}.{p.stem}" for p in paths if p.stem not in DECLARATIONS]
    ordered: list[str] = []
    for name in names:
        _visit(name, ordered, ())
    return ordered


def _visit(name: str, ordered: list[str], above: tuple[str, ...]) -> None:
    if name in above:
        raise BuildError(f"kernels import each other: {' -> '.join((*above, name))}")
    if name in ordered:
        return
    for node in tree(name).body:
        if isinstance(node, ast.ImportFrom) and (node.module or "").startswith(f"{PACKAGE}."):
            used = (node.module or "").removeprefix(f"{PACKAGE}.")
            if not used.endswith("records"):
                _visit(used, ordered, (*above, name))
    ordered.append(name)


def text(name: str) -> str:
    """Source of a kernel module."""
    return (KERNELS / f"{name.replace('.', '/')}.py").read_text(encoding="utf-8")


def tree(name: str) -> ast.Module:
    """Syntax tree of a kernel module, which nobody changes."""
    return _parsed(text(name))


@cache
def _parsed(source: str) -> ast.Module:
    return ast.parse(source)


def amalgamated() -> str:
    """All kernels as one Python module."""
    imported: set[str] = set()
    texts = []
    found: dict[str, str] = {}
    for name in modules():
        source = resolved(name)
        lines = source.splitlines()
        for node in ast.parse(source).body:
            module = node.module if isinstance(node, ast.ImportFrom) else None
            if isinstance(node, ast.ImportFrom) and module == "math":
                imported.update(alias.name for alias in node.names)
            elif isinstance(node, ast.FunctionDef):
                if node.name in found:
                    raise BuildError(
                        f"kernels/{name}.py:{node.lineno}: {found[node.name]} has a function "
                        f"{node.name} too; all kernels become one C file"
                    )
                found[node.name] = name
                texts.append("\n".join(lines[node.lineno - 1 : node.end_lineno]))
            elif not isinstance(node, ast.ImportFrom | ast.Expr | ast.Assign):
                raise BuildError(
                    f"kernels/{name}.py:{node.lineno}: only functions and constants translate"
                )
    head = f"from math import {', '.join(sorted(imported))}"
    return _unquoted("\n\n\n".join([head, *texts]) + "\n")


def _unquoted(source: str) -> str:
    """Annotations without their quotes: what stands in quotes Pyccel reads with another parser."""
    return re.sub(r"'(\w+\[[:,]*\])'", r"\1", source)


def resolved(name: str) -> str:
    """A kernel module with numbers in place of the names of records, codes and constants."""
    source = text(name)
    lines = source.splitlines(keepends=True)
    parsed = tree(name)
    # from the end, so that the other positions stay valid
    for node, value in sorted(_places(name, parsed), key=lambda p: _position(p[0]), reverse=True):
        row = lines[node.lineno - 1].encode()
        spelt = repr(value).encode()
        changed = row[: node.col_offset] + spelt + row[node.end_col_offset :]
        lines[node.lineno - 1] = changed.decode()
    return "".join(lines)


def _position(node: ast.expr) -> tuple[int, int]:
    return node.lineno, node.col_offset


def _places(name: str, parsed: ast.Module) -> Iterator[tuple[ast.expr, float]]:
    """Every use of the name of a record, a code or a constant, and its value."""
    records = _records(parsed)
    numbers = _constants(name, parsed)
    for node in ast.walk(parsed):
        if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Load) and node.id in numbers:
            yield node, numbers[node.id]
        if not (isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name)):
            continue
        record = records.get(node.value.id)
        if record is None:
            continue
        value = getattr(record, node.attr, None)
        if not isinstance(value, int):
            raise BuildError(
                f"kernels/{name}.py:{node.lineno}: {record.__name__} has no {node.attr}"
            )
        yield node, value


def _records(parsed: ast.Module) -> dict[str, type[Record] | type[Codes]]:
    """Records and codes that a module imports, by their names in it."""
    found: dict[str, type[Record] | type[Codes]] = {}
    for node in parsed.body:
        if isinstance(node, ast.ImportFrom) and (node.module or "").endswith("records"):
            module = import_module(node.module or "")
            found |= {a.asname or a.name: getattr(module, a.name) for a in node.names}
    return found


def _constants(name: str, parsed: ast.Module) -> dict[str, float]:
    """Constants of a kernel module, its own and those that it imports from others."""
    found: dict[str, float] = {}
    for node in parsed.body:
        if isinstance(node, ast.Assign):
            value = _number(node.value)
            if value is None or len(node.targets) > 1:
                raise BuildError(f"kernels/{name}.py:{node.lineno}: a constant has to be a number")
            found[ast.unparse(node.targets[0])] = value
        elif isinstance(node, ast.ImportFrom) and (node.module or "").startswith(f"{PACKAGE}."):
            module = import_module(node.module or "")
            found |= {
                a.asname or a.name: getattr(module, a.name)
                for a in node.names if isinstance(getattr(module, a.name), int | float)
            }
    return found


def _number(node: ast.expr) -> float | None:
    """The number that an expression is; None unless it is one."""
    try:
        value = ast.literal_eval(node)
    except ValueError:
        return None
    return value if isinstance(value, int | float) else None
