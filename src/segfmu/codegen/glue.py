"""Annotations of the kernels' entry points -> kernels/c/module.c, the compiled Python module."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from dataclasses import dataclass

from segfmu.codegen.amalgam import modules, tree
from segfmu.codegen.native import BANNER, ENTRY_POINTS, PREFIX

C_TYPES = {"float": "double", "int": "int64_t", "bool": "bool"}
ARRAYS = {
    "float[:]": ("array_double_1d", 1, "d"),
    "float[:,:]": ("array_double_2d", 2, "d"),
    "float[:,:,:]": ("array_double_3d", 3, "d"),
    "int[:]": ("array_int64_t_1d", 1, "l"),
}
TO_PYTHON = {
    "double": "PyFloat_FromDouble({})",
    "int64_t": "PyLong_FromLongLong({})",
    "bool": "PyBool_FromLong({})",
}


@dataclass(frozen=True)
class Function:
    """An entry point: names and annotations of its arguments, and of what it returns."""

    name: str
    arguments: tuple[tuple[str, str], ...]
    results: tuple[str, ...]
    is_tuple: bool
    written: frozenset[str]


def generate() -> dict[str, str]:
    """Return the texts of the generated files, by name."""
    functions = [f for f in _functions() if f.name in ENTRY_POINTS]
    calls = "\n\n".join("\n".join(_call(f)) for f in functions)
    table = "\n".join(
        f'    {{"{f.name}", (PyCFunction)(void (*)(void))call_{f.name}, METH_FASTCALL, NULL}},'
        for f in functions
    )
    return {
        "module.c": f'{BANNER}#include "arguments.h"\n\n{calls}\n\n'
        f"static PyMethodDef methods[] = {{\n{table}\n    {{NULL, NULL, 0, NULL}},\n}};\n\n"
        "static struct PyModuleDef definition = {\n"
        '    PyModuleDef_HEAD_INIT, "_compiled", "The kernels, compiled.", 0, methods, NULL,\n'
        "    NULL, NULL, NULL,\n};\n\n"
        "PyMODINIT_FUNC PyInit__compiled(void)\n{\n    return PyModuleDef_Init(&definition);\n}\n"
    }


def _functions() -> list[Function]:
    """All kernels; later ones use earlier ones, so what they write to is known in time."""
    known: dict[str, Function] = {}
    for module in modules():
        nodes = [node for node in tree(module).body if isinstance(node, ast.FunctionDef)]
        # within a module a function may use a later one: twice finds what both write to
        for node in nodes + nodes:
            known[node.name] = _function(node, known)
    return list(known.values())


def _function(node: ast.FunctionDef, known: dict[str, Function]) -> Function:
    arguments = tuple((a.arg, _annotation(a.annotation)) for a in node.args.args)
    returned = _annotation(node.returns)
    is_tuple = returned.startswith("tuple[")
    names = returned.removeprefix("tuple[").removesuffix("]").split(", ")
    results = () if returned == "None" else tuple(C_TYPES[name] for name in names)
    written = frozenset(_written(node, known)) & {name for name, _ in arguments}
    return Function(node.name, arguments, results, is_tuple, written)


def _annotation(node: ast.expr | None) -> str:
    if isinstance(node, ast.Constant):
        return str(node.value)
    assert isinstance(node, ast.Name)
    return node.id


def _written(node: ast.FunctionDef, known: dict[str, Function]) -> Iterator[str]:
    """Arrays that a function writes to, itself, through a view or through what it calls."""
    views: dict[str, str] = {}
    for part in ast.walk(node):
        if isinstance(part, ast.Assign):
            target = part.targets[0]
            if isinstance(target, ast.Name) and isinstance(part.value, ast.Subscript):
                views[target.id] = _base(part.value)
    for part in ast.walk(node):
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


def _call(function: Function) -> Iterator[str]:
    count = len(function.arguments)
    yield f"static PyObject *call_{function.name}("
    yield "    PyObject *self, PyObject *const *values, Py_ssize_t count)"
    yield "{"
    yield f'    arguments call = {{.function = "{function.name}", .values = values}};'
    yield "    PyObject *answer = NULL;"
    for name, annotation in function.arguments:
        if annotation in ARRAYS:
            yield f"    Py_buffer *in_{name};"
        else:
            yield f"    {C_TYPES[annotation]} in_{name};"
    yield "    (void)self;"
    takes = [f"take_count(&call, count, {count})"]
    takes += [_take(function, i, *argument) for i, argument in enumerate(function.arguments)]
    yield "    if (" + "\n        && ".join(takes) + ") {"
    yield from (f"        {line}" for line in _evaluate(function))
    yield "    }"
    yield "    release_arguments(&call);"
    yield "    return answer;"
    yield "}"


def _take(function: Function, index: int, name: str, annotation: str) -> str:
    if annotation in ARRAYS:
        _, rank, code = ARRAYS[annotation]
        writable = "true" if name in function.written else "false"
        return f"(in_{name} = take_array(&call, {index}, {rank}, '{code}', {writable})) != NULL"
    return f"take_{annotation}(&call, {index}, &in_{name})"


def _evaluate(function: Function) -> Iterator[str]:
    """Call the kernel and turn what it returns into Python's."""
    given = []
    for name, annotation in function.arguments:
        if annotation not in ARRAYS:
            given.append(f"in_{name}")
            continue
        kind, rank, _ = ARRAYS[annotation]
        extents = ", ".join(f"in_{name}->shape[{i}]" for i in range(rank))
        given.append(f"({kind}){{in_{name}->buf, {{{extents}}}}}")
    if function.is_tuple:
        for i, kind in enumerate(function.results):
            yield f"{kind} result_{i};"
        given = [f"&result_{i}" for i in range(len(function.results))] + given
    call = f"{PREFIX}{function.name}(\n            " + ",\n            ".join(given) + ")"
    if not function.results:
        yield f"{call};"
        yield "answer = Py_NewRef(Py_None);"
    elif not function.is_tuple:
        yield f"answer = {TO_PYTHON[function.results[0]].format(call)};"
    else:
        yield f"{call};"
        codes = "".join({"double": "d", "int64_t": "L", "bool": "i"}[k] for k in function.results)
        values = ", ".join(
            f"(long long)result_{i}" if kind == "int64_t" else f"result_{i}"
            for i, kind in enumerate(function.results)
        )
        yield f'answer = Py_BuildValue("({codes})", {values});'
