"""kernels/*.py -> kernels/c/kernels.c and kernels.h, translated by Pyccel.

All kernels become one C file. Functions other than the entry points are static, so that a C
compiler can inline them. The hand-written span.h replaces Pyccel's span library by the few
operations that occur; the generator fails at any other.
"""

from __future__ import annotations

import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

from segfmu.codegen.amalgam import KERNELS, amalgamated
from segfmu.errors import BuildError
from segfmu.kernels import entry_points

TARGET = KERNELS / "c"
ENTRY_POINTS = tuple(e.name for e in entry_points.ENTRY_POINTS)
PREFIX = "segfmu_"
# functions of the innermost loops, a twelfth of a plan's time if they are called
INLINED = ("ramp_change", "ramp_distance", "ramp_duration", "ramp_variance")

BANNER = "/* Generated from the kernels in Python by `python -m segfmu.codegen`; never edited. */\n"


def generate() -> dict[str, str]:
    """Return the texts of the generated files, by name."""
    with tempfile.TemporaryDirectory() as folder:
        module = Path(folder) / "kernels.py"
        module.write_text(amalgamated(), encoding="utf-8")
        _translate(module)
        body = (module.parent / "__pyccel__" / "kernels.c").read_text(encoding="utf-8")
        header = (module.parent / "__pyccel__" / "kernels.h").read_text(encoding="utf-8")
    lines = header.splitlines()
    prototypes = [line for line in lines if re.match(r"\w[\w ]*\*? \w+\(.*\);$", line)]
    public = [line for line in prototypes if _name(line) in ENTRY_POINTS]
    private = [f"static {line}" for line in prototypes if _name(line) not in ENTRY_POINTS]
    body = _short(_used(_static(_spans(body.removeprefix('#include "kernels.h"\n')))))
    source = f'{BANNER}#include "kernels.h"\n\n#include <math.h>\n\n'
    return {
        "kernels.c": source + _prefixed("\n".join(private) + "\n" + body.rstrip() + "\n"),
        "kernels.h": _prefixed(_header(public)),
    }


def _translate(module: Path) -> None:
    # its trees end with the process; to look for garbage in them takes a quarter of the time
    run = "import gc; gc.disable(); from pyccel.commands.console import pyccel; pyccel()"
    command = [sys.executable, "-c", run, "-t", "--language", "c", module.name]
    # in a worker of pytest-xdist Pyccel would give its folder another name
    usual = {k: v for k, v in os.environ.items() if k != "PYTEST_XDIST_WORKER"}
    done = subprocess.run(
        command, cwd=module.parent, env=usual, capture_output=True, text=True, check=False
    )
    if done.returncode != 0:
        raise BuildError(f"Pyccel: {(done.stdout + done.stderr).strip()}")


def _name(prototype: str) -> str:
    return prototype[: prototype.index("(")].split()[-1].lstrip("*")


def _header(public: list[str]) -> str:
    texts = "\n".join(f"SEGFMU_API {line}" for line in public)
    return (
        f"{BANNER}#ifndef SEGFMU_KERNELS_H\n#define SEGFMU_KERNELS_H\n\n"
        '#include <stdbool.h>\n#include <stdint.h>\n\n#include "span.h"\n#include "visible.h"\n\n'
        f"{texts}\n\n#endif\n"
    )


def _spans(text: str) -> str:
    """Replace the slices and the minima by the functions of span.h."""
    every = r"\{c_ALL\}"
    index = r"\{([^{},]+)\}"
    part = r"\{([^{},]+), ([^{},]+)\}"
    rules = (
        (rf"cspan_slice\(array_double_1d, (&\w+), {index}, {every}\)", r"span_row(\1, \2)"),
        (rf"cspan_slice\(array_double_2d, (&\w+), {index}, {every}, {every}\)",
         r"span_matrix(\1, \2)"),
        (rf"cspan_slice\(array_double_2d, (&\w+), {part}, {every}\)",
         r"span_rows(\1, \2, \3)"),
        (rf"cspan_slice\(array_double_3d, (&\w+), {part}, {every}, {every}\)",
         r"span_layers(\1, \2, \3)"),
        (rf"cspan_slice\(array_int64_t_1d, (&\w+), {part}\)",
         r"span_part(\1, \2, \3)"),
        (r"cspan_slice\(array_double_1d, (&\w+), \{([^{},]+), ([^{},]+)\}\)",
         r"span_piece(\1, \2, \3)"),
        (r"\bdouble_(min|max)\(2, ", r"span_\1("),
        (r"\bint64_t_(min|max)\(2, ", r"span_\1_int("),
        (r"\bpy_floor_div_int64_t\(", "span_floor_div("),
        (r"\bpyc_modulo\(", "span_floor_mod("),
    )
    for pattern, replacement in rules:
        text = re.sub(pattern, replacement, text)
    left = re.search(r"cspan_slice.*|\b(?:double|int64_t)_m\w+\(.*|\bpyc?_.*|\bmalloc.*", text)
    if left:
        raise BuildError(f"no rule for this text of Pyccel's: {left.group()}")
    return text


def _static(text: str) -> str:
    """Make all functions static except the entry points; leave out comments, which Python has."""
    text = re.sub(r"^ */\*.*?\*/\n", "", text, flags=re.M | re.S)

    def storage(match: re.Match[str]) -> str:
        name = _name(match.group())
        function = f"SPAN_INLINE {match.group()}" if name in INLINED else match.group()
        return function if name in ENTRY_POINTS else f"static {function}"

    return re.sub(r"^(?:void|double|bool|int64_t) \w+\([^;]*?\)$", storage, text, flags=re.M)


def _used(text: str) -> str:
    """Leave out what a function declares or sets and does not use."""
    return re.sub(r"^\{\n.*?^\}$", lambda m: _used_in(m.group()), text, flags=re.M | re.S)


def _used_in(body: str) -> str:
    for name in re.findall(r"^ +(?:double|int64_t|bool) (\w+);$", body, flags=re.M):
        setting = rf"^( +){name} = (.*);\n"
        times = len(re.findall(rf"\b{name}\b", body))
        if times != 1 + len(re.findall(setting, body, flags=re.M)):
            continue
        # a call may do more than give a value
        body = re.sub(
            setting, lambda m: f"{m[1]}{m[2]};\n" if m[2].endswith(")") else "", body, flags=re.M
        )
        body = re.sub(rf"^ +(?:double|int64_t|bool) {name};\n", "", body, flags=re.M)
    return body


def _short(text: str) -> str:
    """The same in fewer characters, as it is in each archive: plain numbers, and no indents."""
    text = re.sub(r"INT64_C\((\d{1,9})\)", r"\1", text)
    text = re.sub(r"\(\*(cspan_at\([^()]*\))\)", r"*\1", text)
    kinds = r"(?:double|int64_t|bool|array_\w+)"
    text = re.sub(rf"(?:^ +{kinds} \w+;\n)+", _together, text, flags=re.M)
    return re.sub(r"^ +", "", shallow(text), flags=re.M)


def shallow(text: str) -> str:
    """C with a space a level, and no lines of opening braces alone."""
    text = re.sub(r"\n *\{\n", " {\n", text)
    return re.sub(r"^(?: {4})+", lambda m: " " * (len(m[0]) // 4), text, flags=re.M)


def _together(declarations: re.Match[str]) -> str:
    """Declarations of one kind in one line."""
    names: dict[str, list[str]] = {}
    for kind, name in re.findall(r"(\w+) (\w+);", declarations[0]):
        names.setdefault(kind, []).append(name)
    return "".join(f"    {kind} {', '.join(them)};\n" for kind, them in names.items())


def _prefixed(text: str) -> str:
    names = "|".join(ENTRY_POINTS)
    return re.sub(rf"\b({names})\(", rf"{PREFIX}\1(", text)
