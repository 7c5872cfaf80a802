"""C tables of the variables that feed the kernels' records, from the records' declarations."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from segfmu.errors import BuildError
from segfmu.fmu.native.tables import BANNER, Layout, layout
from segfmu.fmu.standard.spec import Spec
from segfmu.kernels.records import Record, c_name


def header(records: Sequence[type[Record]]) -> str:
    """The text of feeds.h."""
    tables = "".join(f"static const feeds {_name(r)};\n" for r in records)
    return (
        f'{BANNER}#ifndef SEGFMU_FEEDS_H\n#define SEGFMU_FEEDS_H\n\n#include "feed.h"\n\n'
        f"{tables}\n#endif\n"
    )


def source(spec: Spec, records: Sequence[type[Record]]) -> str:
    """The text of feeds.c.

    Raises
    ------
    BuildError
        If a record names a variable that the specification does not have.
    """
    placed = layout(spec)
    tables = "\n".join(_table(spec, r, placed) for r in records)
    return f'{BANNER}#include "feeds.h"\n\n{tables}'


def _table(spec: Spec, record: type[Record], placed: Layout) -> str:
    kinds = {v.name: v.kind for v in spec.variables}
    rows, places = [], []
    reals_first = sorted(record.feeds(), key=lambda f: kinds.get(f[1].format(1)) != "Real")
    for place, variable, base in reals_first:
        first = variable.format(1)
        if first not in kinds:
            raise BuildError(f"{record.__name__}: {spec.name} has no variable {first}")
        whole = "false" if kinds[first] == "Real" else "true"
        step = _step(variable, placed)
        rows.append(f"    {{{place}, {placed.offsets[first]}, {step}, {base}, {whole}}}")
        if kinds[first] == "Real":
            places.append((place, placed.offsets[first]))
    name = _name(record)
    lines = ",\n".join(rows)
    # C has no arrays of no size
    runs = _runs(places) or [(0, 0, 0)]
    spans = ", ".join(f"{{{place}, {offset}, {count}}}" for place, offset, count in runs)
    return (
        f"static const feed {name}_rows[] = {{\n{lines}\n}};\n"
        f"static const feed_run {name}_runs[] = {{{spans}}};\n"
        f"static const feeds {name} = {{\n"
        f"    {name}_rows, {len(rows)}, {len(places)}, {name}_runs, {len(runs)}\n}};\n"
    )


def _runs(places: Sequence[tuple[int, int]]) -> list[tuple[int, int, int]]:
    """Places and offsets that grow together: the first ones, and their number."""
    found: list[tuple[int, int, int]] = []
    for place, offset in places:
        if found:
            first, begin, count = found[-1]
            if (place, offset) == (first + count, begin + count):
                found[-1] = first, begin, count + 1
                continue
        found.append((place, offset, 1))
    return found


def _step(variable: str, placed: Layout) -> int:
    """From a variable to that of the next row of a table; 0 where it is in none."""
    offsets, row = [placed.offsets[variable.format(1)]], 2
    while "{}" in variable and variable.format(row) in placed.offsets:
        offsets.append(placed.offsets[variable.format(row)])
        row += 1
    steps = {b - a for a, b in pairwise(offsets)} or {0}
    if len(steps) > 1:
        raise BuildError(f"the rows of {variable} do not follow each other evenly")
    return steps.pop()


def _name(record: type[Record]) -> str:
    return f"feeds_{c_name(record).lower()}"
