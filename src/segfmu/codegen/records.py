"""Records and codes of all rooms -> docs/records.md, those that C names -> kernels/c/records.h."""

from __future__ import annotations

import re
from collections.abc import Iterator
from importlib import import_module
from pathlib import Path

from segfmu.codegen.amalgam import KERNELS, PACKAGE
from segfmu.codegen.native import BANNER
from segfmu.errors import BuildError
from segfmu.kernels.records import Codes, Field, Record, c_name

HEADER = KERNELS / "c" / "records.h"
ROOT = Path(__file__).parents[3]
PAGE = ROOT / "docs" / "records.md"

Declared = type[Record] | type[Codes]

INTRODUCTION = """# Records

<!-- Generated from kernels/*/records.py by `python -m segfmu.codegen`; never edited. -->

For contributors: what the entries of the kernels' arrays are. A record names the entries of an
array, or the rows of one with two dimensions; codes are numbers with a meaning. Kernels, the Python
layer and the C of the FMUs use these names alone: `Plant.LAG` in Python is `PLANT_LAG` in C, whose
header has the records of which it names an entry. A record that begins with the fields of another
one can be passed in its place.
"""


def generate() -> dict[Path, str]:
    """Return the texts of the generated files."""
    rooms = _rooms()
    return {HEADER: _header(rooms), PAGE: _page(rooms)}


def _rooms() -> dict[str, list[Declared]]:
    """Records and codes in the order of declaration, by room."""
    rooms: dict[str, list[Declared]] = {}
    for path in sorted(KERNELS.glob("*/records.py")):
        module = import_module(f"{PACKAGE}.{path.parent.name}.records")
        rooms[path.parent.name] = [
            value for value in vars(module).values()
            if isinstance(value, type) and issubclass(value, Record | Codes)
            and value.__module__ == module.__name__
        ]
    return rooms


def _header(rooms: dict[str, list[Declared]]) -> str:
    values: dict[str, int] = {}
    texts = []
    named = _names_in_c()
    for room, declared in rooms.items():
        texts.append(f"/* kernels/{room}/records.py */")
        for one in declared:
            constants = dict(_constants(one))
            repeated = values.keys() & constants.keys()
            if repeated:
                raise BuildError(f"records.h: {', '.join(sorted(repeated))} more than once")
            values |= constants
            # wheels carry the header
            if named.isdisjoint(constants):
                continue
            lines = ",\n".join(f"    {name} = {value}" for name, value in constants.items())
            texts.append(f"enum {{\n{lines}\n}};")
    body = "\n\n".join(texts)
    banner = BANNER.replace("kernels in Python", "records of the kernels")
    return f"{banner}#ifndef SEGFMU_RECORDS_H\n#define SEGFMU_RECORDS_H\n\n{body}\n\n#endif\n"


def _names_in_c() -> set[str]:
    """Names in capitals of all C sources, those of benchmarks and tests too, but of the header."""
    folders = [KERNELS.parent, ROOT / "benchmarks", ROOT / "tests"]
    sources = [p for folder in folders for p in folder.rglob("*.[ch]") if p != HEADER]
    texts = "".join(path.read_text(encoding="utf-8") for path in sources)
    return set(re.findall(r"\b[A-Z][A-Z0-9_]*\b", texts))


def constant(one: Declared, name: str) -> str:
    """The name of a field, code or size in C."""
    return f"{c_name(one)}_{name}"


def _constants(one: Declared) -> Iterator[tuple[str, int]]:
    if issubclass(one, Codes):
        yield from ((constant(one, name), value) for name, value in one.items().items())
        return
    yield from ((constant(one, name), getattr(one, name)) for name in one.FIELDS)
    yield constant(one, "SIZE"), one.SIZE
    if one.COLUMNS:
        yield constant(one, "COLUMNS"), one.COLUMNS


def _page(rooms: dict[str, list[Declared]]) -> str:
    parts = [INTRODUCTION]
    for room, declared in rooms.items():
        parts.append(f"\n## {room}\n")
        parts += ["".join(f"{line}\n" for line in _section(one)) for one in declared]
    return "".join(parts)


def _section(one: Declared) -> Iterator[str]:
    yield ""
    yield f"### {one.__name__}"
    yield ""
    yield " ".join((one.__doc__ or "").split())
    yield ""
    if issubclass(one, Codes):
        yield "| name | value |"
        yield "|---|---|"
        yield from (f"| {name} | {value} |" for name, value in one.items().items())
        return
    yield "| name | place | size | unit | meaning | FMU variables |"
    yield "|---|---|---|---|---|---|"
    yield from (_row(one, name, declared) for name, declared in one.FIELDS.items())


def _row(one: type[Record], name: str, declared: Field) -> str:
    meaning = declared.meaning + (f"; see {declared.of.__name__}" if declared.of else "")
    variables = ", ".join(f"`{v.replace('{}', 'i')}`" for v in declared.variables if v)
    size = str(declared.size) if declared.size else "any"
    cells = (name, str(getattr(one, name)), size, declared.unit, meaning, variables)
    return "| " + " | ".join(cells) + " |"
