"""kernels/messages.py -> kernels/c/messages.c and messages.h: one function per table of texts."""

from __future__ import annotations

import re
from collections.abc import Iterator

from segfmu.codegen.native import BANNER
from segfmu.codegen.records import constant
from segfmu.kernels.messages import PLACE, TABLES, Messages

HEAD = BANNER.replace("kernels in Python", "texts in kernels/messages.py")
WIDTH = 76


def generate() -> dict[str, str]:
    """Return the texts of the generated files, by name."""
    prototypes = "".join(f"SEGFMU_API {_prototype(t)};\n" for t in TABLES)
    functions = "\n".join("\n".join(_function(t)) + "\n" for t in TABLES)
    return {
        "messages.h": f"{HEAD}#ifndef SEGFMU_MESSAGES_H\n#define SEGFMU_MESSAGES_H\n\n"
        "#include <stdbool.h>\n#include <stddef.h>\n#include <stdint.h>\n\n"
        '#include "visible.h"\n\n'
        "/* The message of a status and its report; false for a status without one. */\n"
        f"{prototypes}\n#endif\n",
        "messages.c": f'{HEAD}#include "messages.h"\n\n#include <stdio.h>\n\n'
        f'#include "records.h"\n\n{functions}',
    }


def _prototype(table: Messages) -> str:
    return (
        f"bool segfmu_{table.name}_message(\n"
        "    int64_t status, const double *report, char *text, size_t size)"
    )


def _function(table: Messages) -> Iterator[str]:
    yield _prototype(table)
    yield "{"
    for name, words in table.words.items():
        listed = ", ".join(f'"{w}"' for w in words)
        yield f"    static const char *const {name.lower()}[] = {{{listed}}};"
    yield "    switch (status) {"
    for status, text in table.texts.items():
        form, values = _printed(table, text)
        yield f"    case {status}:"
        yield "        snprintf(text, size,"
        lines = [f'            "{part}"' for part in _parts(form)]
        yield from lines[:-1]
        yield lines[-1] + "".join(f",\n            {v}" for v in values) + ");"
        yield "        return true;"
    yield "    default:"
    yield "        return false;"
    yield "    }"
    yield "}"


def _printed(table: Messages, text: str) -> tuple[str, list[str]]:
    """The format of printf, and its arguments."""
    values = []

    def place(found: re.Match[str]) -> str:
        name, added, form = found.groups()
        value = f"report[{constant(table.report, name)}]"
        if name in table.words:
            values.append(f"{name.lower()}[(int){value}]")
            return "%s"
        values.append(value if form else f"(int){value}" + (f" + {added}" if added else ""))
        return f"%{form or 'd'}"

    escaped = text.replace("%", "%%").replace('"', r"\"")
    return PLACE.sub(place, escaped), values


def _parts(text: str) -> list[str]:
    """A long text, split between words."""
    parts = [""]
    for word in re.findall(r"\S+ ?", text):
        if len(parts[-1]) + len(word) > WIDTH:
            parts.append("")
        parts[-1] += word
    return parts
