"""Annotations of the kernels' entry points -> kernels/c/module.c, the compiled Python module."""

from __future__ import annotations

import re
from collections.abc import Iterator

from segfmu.codegen.functions import Function, functions
from segfmu.codegen.native import BANNER, PREFIX
from segfmu.errors import BuildError
from segfmu.kernels.entry_points import ENTRY_POINTS, Extent

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


def generate() -> dict[str, str]:
    """Return the texts of the generated files, by name."""
    points = {e.name: e.extents for e in ENTRY_POINTS}
    chosen = [f for f in functions() if f.name in points]
    calls = "\n\n".join("\n".join(_call(f, points[f.name])) for f in chosen)
    table = "\n".join(
        f'    {{"{f.name}", (PyCFunction)(void (*)(void))call_{f.name}, METH_FASTCALL, NULL}},'
        for f in chosen
    )
    return {
        "module.c": f'{BANNER}#include "arguments.h"\n\n{calls}\n\n'
        f"static PyMethodDef methods[] = {{\n{table}\n    {{NULL, NULL, 0, NULL}},\n}};\n\n"
        "static struct PyModuleDef definition = {\n"
        '    PyModuleDef_HEAD_INIT, "_compiled", "The kernels, compiled.", 0, methods, NULL,\n'
        "    NULL, NULL, NULL,\n};\n\n"
        "PyMODINIT_FUNC PyInit__compiled(void)\n{\n    return PyModuleDef_Init(&definition);\n}\n"
    }


def _call(function: Function, extents: dict[str, tuple[Extent, ...]]) -> Iterator[str]:
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
    takes += _checks(function, extents)
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


def _checks(function: Function, extents: dict[str, tuple[Extent, ...]]) -> list[str]:
    """Conditions on the extents of the arrays that the kernel relies on."""
    counts = {name: f"in_{name}" for name, kind in function.arguments if kind == "int"}
    known = dict(counts)
    rows, later = [], []
    for name, annotation in function.arguments:
        if annotation not in ARRAYS:
            continue
        for i, extent in enumerate(extents.get(name, ())):
            actual = f"in_{name}->shape[{i}]"
            if isinstance(extent, str) and extent.isidentifier() and extent not in counts:
                if extent not in known:
                    known[extent] = actual
                    continue
                rows.append(f'has_extent(&call, "{name}", {i}, {actual}, {known[extent]})')
            else:
                later.append((name, i, actual, str(extent)))
    for name, i, actual, extent in later:
        least = _in_c(extent, known, function.name)
        rows.append(f'has_at_least(&call, "{name}", {i}, {actual}, {least})')
    return rows


def _in_c(extent: str, known: dict[str, str], function: str) -> str:
    """An expression of extents in C."""

    def value(match: re.Match[str]) -> str:
        if match.group() not in known:
            raise BuildError(f"{function}: no argument has the extent {match.group()}")
        return known[match.group()]

    return re.sub(r"[A-Za-z]\w*", value, extent)


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
        for i, name in enumerate(function.results):
            yield f"{C_TYPES[name]} result_{i};"
        given = [f"&result_{i}" for i in range(len(function.results))] + given
    call = f"{PREFIX}{function.name}(\n            " + ",\n            ".join(given) + ")"
    results = [C_TYPES[name] for name in function.results]
    if not results:
        yield f"{call};"
        yield "answer = Py_NewRef(Py_None);"
    elif not function.is_tuple:
        yield f"answer = {TO_PYTHON[results[0]].format(call)};"
    else:
        yield f"{call};"
        codes = "".join({"double": "d", "int64_t": "L", "bool": "i"}[k] for k in results)
        values = ", ".join(
            f"(long long)result_{i}" if kind == "int64_t" else f"result_{i}"
            for i, kind in enumerate(results)
        )
        yield f'answer = Py_BuildValue("({codes})", {values});'
