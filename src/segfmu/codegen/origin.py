"""What the generated files were made from: a digest that `python -m segfmu.codegen` writes.

To generate them again takes a minute; the digest tells at once that a source, a generator, SymPy,
Pyccel or a generated file has changed since.
"""

from __future__ import annotations

import hashlib
from collections.abc import Iterator
from importlib.metadata import version
from pathlib import Path

PACKAGE = Path(__file__).parents[1]
TARGET = Path(__file__).with_name("origin.txt")
TOOLS = ("sympy", "pyccel")
# generators, kernels with those that are generated, and what the equations follow from
SOURCES = (
    "codegen/*.py", "kernels/**/*.py", "crane/flatness.py", "crane/lagrangian.py",
    "crane/hook/lagrangian.py",
)
MADE = ("kernels/c/kernels.c", "kernels/c/kernels.h")


def files() -> Iterator[Path]:
    """All files of which the digest is."""
    for pattern in (*SOURCES, *MADE):
        yield from sorted(PACKAGE.glob(pattern))


def generate() -> str:
    """Return the text of origin.txt."""
    digest = hashlib.sha256(" ".join(version(tool) for tool in TOOLS).encode())
    for path in files():
        text = path.read_text(encoding="utf-8").encode()
        digest.update(f"{path.relative_to(PACKAGE).as_posix()} {len(text)} ".encode() + text)
    return f"{digest.hexdigest()}\n"
