"""Annotations of the kernels' entry points -> kernels/c/module.c, the compiled Python module."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from segfmu.codegen.functions import Function, functions
from segfmu.codegen.native import BANNER, PREFIX, shallow
from segfmu.errors import BuildError
from segfmu.kernels.entry_point import Extent
from segfmu.kernels.entry_points import ENTRY_POINTS, MAY_BE_EMPTY, MAY_LACK_PIECES

# C type, rank, and kind of the numbers
Array = tuple[str, int, str]

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
        "module.c": shallow(f'{BANNER}#include "arguments.h"\n\n{calls}\n\n'
        f"static PyMethodDef methods[] = {{\n{table}\n    {{NULL, NULL, 0, NULL}},\n}};\n\n"
        "static struct PyModuleDef definition = {\n"
        '    PyModuleDef_HEAD_INIT, "_compiled", "The kernels, compiled.", 0, methods, NULL,\n'
        "    NULL, NULL, NULL,\n};\n\n"
        "PyMODINIT_FUNC PyInit__compiled(void)\n{\n    return PyModuleDef_Init(&definition);\n}\n")
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
    """Conditions that the arrays are as large as the kernel relies on."""
    arrays = {name: ARRAYS[kind] for name, kind in function.arguments if kind in ARRAYS}
    for name in arrays | extents:
        if name not in arrays or len(extents.get(name, ())) != arrays[name][1]:
            raise BuildError(f"{function.name}: argument {name} needs an extent a dimension")
    counts = {name: f"in_{name}" for name, kind in function.arguments if kind == "int"}
    known = dict(counts)
    bound, same, least = [], [], []
    for name in arrays:
        for i, extent in enumerate(extents[name]):
            place = f'&call, "{name}", {i}, in_{name}->shape[{i}]'
            if not (isinstance(extent, str) and extent.isidentifier()) or extent in counts:
                least.append((place, ast.parse(str(extent), mode="eval").body))
            elif extent in known:
                same.append(f"has_extent({place}, {known[extent]})")
            else:
                known[extent] = f"in_{name}->shape[{i}]"
                if extent not in MAY_BE_EMPTY:
                    bound.append(f"has_at_least({place}, 1)")
    # entries of arrays only after these were found to be large enough
    least.sort(key=lambda item: _reads(item[1]))
    spelt = [f"has_at_least({p}, {_in_c(e, known, arrays, function.name)})" for p, e in least]
    return [*bound, *same, *spelt, *_pieces(function, known, extents)]


def _reads(extent: ast.expr) -> bool:
    """Whether an extent depends on entries of arrays."""
    return any(isinstance(part, ast.Call | ast.Subscript) for part in ast.walk(extent))


def _in_c(
    extent: ast.expr, known: dict[str, str], arrays: dict[str, Array], function: str
) -> str:
    """An expression of extents in C."""

    def spelt(node: ast.expr) -> str:
        match node:
            case ast.Constant(int(value)):
                return str(value)
            case ast.BinOp(left, operation, right):
                sign = {ast.Add: "+", ast.Sub: "-", ast.Mult: "*"}[type(operation)]
                return f"({spelt(left)} {sign} {spelt(right)})"
            case ast.Subscript(ast.Name(array), ast.Tuple([row, column])) if array in arrays:
                place = f"{spelt(row)} * in_{array}->shape[1] + {spelt(column)}"
                return f"((double *)in_{array}->buf)[{place}]"
            case ast.Subscript(ast.Name(array), place) if array in arrays:
                return f"((double *)in_{array}->buf)[{spelt(place)}]"
            case ast.Call(ast.Name(called), given):
                return f"{PREFIX}{called}({', '.join(map(passed, given))})"
            case ast.Name(name) if name in known:
                return known[name]
        raise BuildError(f"{function}: no argument has the extent {ast.unparse(node)}")

    def passed(node: ast.expr) -> str:
        if isinstance(node, ast.Name) and node.id in arrays:
            return _array(node.id, arrays[node.id])
        return spelt(node)

    return spelt(extent)


def _array(name: str, array: Array) -> str:
    """An array of the kernels over the buffer of an argument."""
    kind, rank, _ = array
    extents = ", ".join(f"in_{name}->shape[{i}]" for i in range(rank))
    return f"({kind}){{in_{name}->buf, {{{extents}}}}}"


def _pieces(
    function: Function, known: dict[str, str], extents: dict[str, tuple[Extent, ...]]
) -> Iterator[str]:
    """Conditions that the first pieces of the axes, which a kernel reads, are among the pieces."""
    for name, kind in function.arguments:
        if kind == "int[:]" and name not in function.written:
            count = _in_c(
                ast.parse(str(extents[name][0]), mode="eval").body, known, {}, function.name
            )
            least = 0 if name in MAY_LACK_PIECES else 1
            where = f'&call, "{name}", in_{name}->buf'
            yield f"has_pieces({where}, {count}, {least}, {known['pieces']})"


def _evaluate(function: Function) -> Iterator[str]:
    """Call the kernel and turn what it returns into Python's."""
    given = []
    for name, annotation in function.arguments:
        is_array = annotation in ARRAYS
        given.append(_array(name, ARRAYS[annotation]) if is_array else f"in_{name}")
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
