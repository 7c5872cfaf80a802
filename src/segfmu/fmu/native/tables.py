"""The table of an FMU's variables in C, from its interface specification.

Every variable has a place in one of two arrays, `real` and `integer`; the members of an FMI 3.0
array lie side by side. variables.h names the places, variables.c says of every value reference
where its value is, of which kind, in which range, and when it may be set. build.h has a
mark of all sources.
"""

from __future__ import annotations

import hashlib
import re
from collections.abc import Mapping
from dataclasses import dataclass

from segfmu.fmu.standard.identity import guid
from segfmu.fmu.standard.references import Entry, entries
from segfmu.fmu.standard.spec import Spec, Variable

BANNER = "/* Generated from the interface specification in Python; never edited. */\n"

KINDS = {
    "Real": "KIND_REAL", "Integer": "KIND_INTEGER", "Boolean": "KIND_BOOLEAN",
    "Enumeration": "KIND_ENUMERATION",
}


@dataclass(frozen=True)
class Layout:
    """Places of the values: `offsets` by variable, in arrays of these start values."""

    offsets: dict[str, int]
    reals: list[float]
    integers: list[int]


def layout(spec: Spec) -> Layout:
    """Give every variable its place, inputs first."""
    member_of = {m: a for a in spec.arrays for m in a.members}
    variables = {v.name: v for v in spec.variables}
    placed = Layout({}, [], [])
    for variable in (*spec.where("input"), *spec.variables):
        array = member_of.get(variable.name)
        for name in array.members if array else (variable.name,):
            if name not in placed.offsets:
                _place(variables[name], placed)
    return placed


def _place(variable: Variable, placed: Layout) -> None:
    start = variable.start or 0
    if variable.kind == "Real":
        placed.offsets[variable.name] = len(placed.reals)
        placed.reals.append(float(start))
    else:
        placed.offsets[variable.name] = len(placed.integers)
        placed.integers.append(int(start))


def header(spec: Spec, version: int) -> str:
    """The text of variables.h."""
    placed = layout(spec)
    arrays = {a.members[0]: a.name for a in spec.arrays}
    members = {m for a in spec.arrays for m in a.members}
    names = [
        f"    V_{_identifier(arrays.get(n, n))} = {offset},"
        for n, offset in placed.offsets.items()
        if n in arrays or n not in members
    ]
    rows = max((len(a.members) // a.columns for a in spec.arrays), default=0)
    sizes = {
        "VARIABLES": len(entries(spec, version)), "REALS": len(placed.reals),
        # C has no arrays of no size
        "INTEGERS": max(1, len(placed.integers)), "INPUTS": len(spec.where("input")),
        "STATES": len(spec.states), "ROWS": rows, "ORDERS": spec.orders,
    }
    lines = [
        BANNER + "#ifndef SEGFMU_VARIABLES_H", "#define SEGFMU_VARIABLES_H", "", "enum {",
        *(f"    MODEL_{name} = {size}," for name, size in sizes.items()), "};", "",
        *(f"#define {name} {value!r}" for name, value in spec.constants), "",
        "/* places in `real` and `integer` */", "enum {", *names, "};", "", "#endif", "",
    ]
    return "\n".join(lines).replace(",\n}", "\n}")


def build(sources: Mapping[str, bytes]) -> str:
    """The text of build.h: the mark of these sources, of which one version of FMI is a part."""
    digest = hashlib.sha256()
    for name in sorted(sources):
        digest.update(f"{name} {len(sources[name])} ".encode() + sources[name])
    return (
        f"{BANNER}#ifndef SEGFMU_BUILD_H\n#define SEGFMU_BUILD_H\n\n"
        "/* of the sources: with others, a state may lie in memory in another way */\n"
        f"#define BUILD_MARK 0x{digest.hexdigest()[:16]}u\n\n#endif\n"
    )


def source(spec: Spec, version: int) -> str:
    """The text of variables.c."""
    placed = layout(spec)
    rows = ",\n".join(_row(spec, e, placed, version) for e in entries(spec, version))
    reals = _wrapped([repr(x) for x in placed.reals])
    integers = _wrapped([str(x) for x in placed.integers] or ["0"])
    return (
        f'{BANNER}#include <math.h>\n\n#include "model.h"\n\n'
        f'const char model_name[] = "{spec.name}";\n'
        f'const char model_token[] = "{guid(spec)}";\n\n'
        f"const variable model_variables[MODEL_VARIABLES] = {{\n{rows}\n}};\n\n"
        f"const double model_real_start[MODEL_REALS] = {{\n{reals}\n}};\n\n"
        f"const int64_t model_integer_start[MODEL_INTEGERS] = {{\n{integers}\n}};\n"
    )


def _row(spec: Spec, entry: Entry, placed: Layout, version: int) -> str:
    v = entry.variable
    counts = version == 3 and any(v.name == a.rows for a in spec.arrays)
    kind = "KIND_COUNT" if counts else KINDS[v.kind]
    least, most = v.minimum, v.maximum
    if v.enumeration is not None:
        least, most = 1, len(v.enumeration.items)
    calculated = v.causality in ("output", "calculatedParameter", "local")
    derived = calculated and v.variability == "continuous"
    fields = (
        f'"{entry.name}"', "-INFINITY" if least is None else repr(float(least)),
        "INFINITY" if most is None else repr(float(most)), str(placed.offsets[v.name]),
        str(entry.array.columns if entry.array else 0), kind,
        "SET_STRUCTURE" if counts else _setting(v), _truth(calculated), _truth(derived),
    )
    return f"    {{{', '.join(fields)}}}"


def _setting(v: Variable) -> str:
    if v.causality == "input":
        return "SET_INPUT"
    if v.causality == "parameter":
        return "SET_TUNABLE" if v.variability == "tunable" else "SET_FIXED"
    return "SET_NEVER" if v.initial != "exact" else "SET_START"


def _truth(value: bool) -> str:
    return "true" if value else "false"


def _identifier(name: str) -> str:
    return re.sub(r"\W+", "_", name).strip("_").upper()


def _wrapped(texts: list[str]) -> str:
    rows = [texts[i : i + 8] for i in range(0, len(texts), 8)]
    return ",\n".join(f"    {', '.join(row)}" for row in rows)
