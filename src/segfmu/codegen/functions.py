"""Arguments, results and written arrays of the translated kernels, from their annotations."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache

from segfmu.codegen.amalgam import modules, tree


@dataclass(frozen=True)
class Function:
    """A kernel: names and annotations of its arguments, and annotations of its results.

    `written` names the arrays that it changes.
    """

    name: str
    arguments: tuple[tuple[str, str], ...]
    results: tuple[str, ...]
    is_tuple: bool
    written: frozenset[str]
    doc: str


@cache
def functions() -> tuple[Function, ...]:
    """All kernels, in an order in which the arrays written by called kernels are known."""
    known: dict[str, Function] = {}
    for module in modules():
        nodes = [
            (node, _parts(node)) for node in tree(module).body if isinstance(node, ast.FunctionDef)
        ]
        # within a module a function may call a later one, so two passes are needed
        for node, parts in nodes + nodes:
            known[node.name] = _function(node, parts, known)
    return tuple(known.values())


def _function(node: ast.FunctionDef, parts: list[ast.AST], known: dict[str, Function]) -> Function:
    arguments = tuple((a.arg, _annotation(a.annotation)) for a in node.args.args)
    returned = _annotation(node.returns)
    is_tuple = returned.startswith("tuple[")
    names = returned.removeprefix("tuple[").removesuffix("]").split(", ")
    results = () if returned == "None" else tuple(names)
    written = frozenset(_written(parts, known)) & {name for name, _ in arguments}
    return Function(
        node.name, arguments, results, is_tuple, written, ast.get_docstring(node) or ""
    )


def _annotation(node: ast.expr | None) -> str:
    if isinstance(node, ast.Constant):
        return str(node.value)
    assert isinstance(node, ast.Name)
    return node.id


def _parts(node: ast.FunctionDef) -> list[ast.AST]:
    """What of a function may write to arrays, or name a view of one."""
    return [part for part in ast.walk(node) if isinstance(part, ast.Assign | ast.Call)]


def _written(parts: list[ast.AST], known: dict[str, Function]) -> Iterator[str]:
    """Arrays that a function writes to, directly, through a view or through a call."""
    views: dict[str, str] = {}
    for part in parts:
        if isinstance(part, ast.Assign):
            target = part.targets[0]
            if isinstance(target, ast.Name) and isinstance(part.value, ast.Subscript):
                base = _base(part.value)
                # a view of a view is a view of the array
                views[target.id] = views.get(base, base)
    for part in parts:
        if isinstance(part, ast.Assign) and isinstance(part.targets[0], ast.Subscript):
            name = _base(part.targets[0])
            yield views.get(name, name)
        elif isinstance(part, ast.Call) and isinstance(part.func, ast.Name):
            function = known.get(part.func.id)
            if function is None:
                continue
            for (name, _), given in zip(function.arguments, part.args, strict=True):
                if name in function.written:
                    base = _base(given)
                    yield views.get(base, base)


def _base(node: ast.expr) -> str:
    while isinstance(node, ast.Subscript):
        node = node.value
    return node.id if isinstance(node, ast.Name) else ""
