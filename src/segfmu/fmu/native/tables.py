"""The table of an FMU's variables in C, from its interface specification.

Every variable has an index in one of two arrays, `real` and `integer`; the elements of an FMI 3.0
array are adjacent. variables.h names the indices, and has numbers that Python has as well.
variables.c gives index and kind of every value reference, when it may be set, its name and range,
and which ones are differentiable. build.h has a hash of all sources. None of them depends on start
values, which are in start.bin.
"""

from __future__ import annotations

import hashlib
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from segfmu.fmu.standard.references import Entry, entries
from segfmu.fmu.standard.spec import Spec, Variable
from segfmu.fmu.standard.times import LATEST, REPEATED, ROUNDING, SAME

BANNER = "/* Generated from the interface specification in Python; never edited. */\n"

KINDS = {
    "Real": "KIND_REAL", "Integer": "KIND_INTEGER", "Boolean": "KIND_BOOLEAN",
    "Enumeration": "KIND_ENUMERATION",
}

# names in C, as in Python
TIMES = {"SAME": SAME, "REPEATED": REPEATED, "ROUNDING": ROUNDING, "LATEST": LATEST}

CALCULATED = ("output", "calculatedParameter", "local")


@dataclass(frozen=True)
class Layout:
    """Places of the values: `offsets` by variable, in arrays of these start values."""

    offsets: dict[str, int]
    reals: list[float]
    integers: list[int]


def layout(spec: Spec) -> Layout:
    """Give every variable its place, continuous inputs first."""
    member_of = {m: a for a in spec.arrays for m in a.members}
    variables = {v.name: v for v in spec.variables}
    placed = Layout({}, [], [])
    for variable in (*spec.signals, *spec.variables):
        if variable.name not in placed.offsets:
            array = member_of.get(variable.name)
            for name in array.members if array else (variable.name,):
                _place(variables[name], placed)
    return placed


def _states(spec: Spec) -> dict[str, int]:
    """Places of the continuous states, from 1."""
    return {state: place for place, (state, _) in enumerate(spec.states, 1)}


def _place(variable: Variable, placed: Layout) -> None:
    start = variable.start or 0
    if variable.same_as is not None:
        placed.offsets[variable.name] = placed.offsets[variable.same_as]
    elif variable.kind == "Real":
        placed.offsets[variable.name] = len(placed.reals)
        placed.reals.append(float(start))
    else:
        placed.offsets[variable.name] = len(placed.integers)
        placed.integers.append(int(start))


def most_rows(spec: Spec) -> int:
    """Rows of the arrays that have those of the build."""
    return max((len(a.members) // a.columns for a in spec.arrays if not a.fixed), default=0)


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
    described = entries(spec, version)
    rows = most_rows(spec)
    sizes = {
        "VARIABLES": len(described), "NAME": 1 + max(len(e.name) for e in described),
        "RANGES": len(_ranges(described)),
        "RUNS": len(_differentiable_runs(described, placed)),
        "REALS": len(placed.reals),
        # C has no arrays of no size
        "INTEGERS": max(1, len(placed.integers)), "INPUTS": len(spec.signals),
        "STATES": len(spec.states), "ROWS": rows, "ORDERS": spec.orders,
    }
    lines = [
        BANNER + "#ifndef SEGFMU_VARIABLES_H", "#define SEGFMU_VARIABLES_H", "", "enum {",
        *(f"    MODEL_{name} = {size}," for name, size in sizes.items()), "};", "",
        *(f"#define {name} {value!r}" for name, value in (*TIMES.items(), *spec.constants)), "",
        "/* places in `real` and `integer` */", "enum {", *names, "};", "", "#endif", "",
    ]
    return "\n".join(lines).replace(",\n}", "\n}")


def mark(sources: Mapping[str, bytes]) -> int:
    """A number that follows from these sources, of which one version of FMI is a part."""
    digest = hashlib.sha256()
    for name in sorted(sources):
        digest.update(f"{name} {len(sources[name])} ".encode() + sources[name])
    return int(digest.hexdigest()[:16], 16)


def build(number: int) -> str:
    """The text of build.h, with the mark of the other sources."""
    return (
        f"{BANNER}#ifndef SEGFMU_BUILD_H\n#define SEGFMU_BUILD_H\n\n"
        "/* of the sources: with others, values lie in memory and in files in another way */\n"
        f"#define BUILD_MARK 0x{number:016x}u\n\n#endif\n"
    )


def source(spec: Spec, version: int) -> str:
    """The text of variables.c."""
    placed = layout(spec)
    described = entries(spec, version)
    rows = ",\n".join(_row(spec, e, placed) for e in described)
    known = _ranges(described)
    labels = ",\n".join(
        f'    {{"{e.name}", {known.index(_range(e.variable))}}}' for e in described
    )
    ranges = ",\n".join(f"    {{{low}, {high}}}" for low, high in known)
    # C has no arrays of no size
    runs = [*_differentiable_runs(described, placed), (0, 0)]
    places = ", ".join(f"{{{first}, {count}}}" for first, count in runs)
    return (
        f'{BANNER}#include <math.h>\n\n#include "model.h"\n\n'
        f'static const char model_name[] = "{spec.name}";\n\n'
        f"static const variable model_variables[MODEL_VARIABLES] = {{\n{rows}\n}};\n\n"
        f"static const label model_labels[MODEL_VARIABLES] = {{\n{labels}\n}};\n\n"
        f"static const range model_ranges[MODEL_RANGES] = {{\n{ranges}\n}};\n\n"
        "static const run model_differentiable[MODEL_RUNS + 1] = "
        f"{{{places}}};\n"
    )


def _row(spec: Spec, entry: Entry, placed: Layout) -> str:
    v = entry.variable
    counts = any(v.name == a.rows for a in spec.arrays if not a.fixed)
    calculated = v.causality in CALCULATED
    derived = _differentiable(v)
    fields = (
        str(placed.offsets[v.name]),
        *_sizes(entry), KINDS[v.kind],
        _setting(v), str(_states(spec).get(v.name, 0)), _truth(calculated), _truth(derived),
        _truth(counts),
    )
    return f"    {{{', '.join(fields)}}}"


def _sizes(entry: Entry) -> tuple[str, str]:
    """Elements whatever the build has room for, and elements of each of its rows."""
    array = entry.array
    if array is None or array.fixed:
        return str(1 if array is None else len(array.members)), "0"
    return "0", str(array.columns)


def _ranges(described: Sequence[Entry]) -> list[tuple[str, str]]:
    """Every range once: many variables share one."""
    return list(dict.fromkeys(_range(e.variable) for e in described))


def _range(v: Variable) -> tuple[str, str]:
    least, most = v.minimum, v.maximum
    if v.enumeration is not None:
        least, most = 1, len(v.enumeration.items)
    return (
        "-INFINITY" if least is None else repr(float(least)),
        "INFINITY" if most is None else repr(float(most)),
    )


def _differentiable_runs(described: Sequence[Entry], placed: Layout) -> list[tuple[int, int]]:
    """Values of differentiable variables that follow each other: the first place, their number."""
    places = {placed.offsets[e.variable.name] for e in described if _differentiable(e.variable)}
    firsts = sorted(p for p in places if p - 1 not in places)
    ends = sorted(p + 1 for p in places if p + 1 not in places)
    return [(first, end - first) for first, end in zip(firsts, ends, strict=True)]


def _differentiable(v: Variable) -> bool:
    """An output or a state's derivative, continuous."""
    return v.causality in CALCULATED and v.variability == "continuous"


def _setting(v: Variable) -> str:
    if v.commands:
        return "SET_COMMAND"
    if v.causality == "input":
        return "SET_INPUT"
    if v.causality == "parameter":
        return "SET_TUNABLE" if v.variability == "tunable" else "SET_FIXED"
    return "SET_NEVER" if v.initial != "exact" else "SET_START"


def _truth(value: bool) -> str:
    return "true" if value else "false"


def _identifier(name: str) -> str:
    return re.sub(r"\W+", "_", name).strip("_").upper()
