"""What generators write, kept until a source or a package changes."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path

import segfmu
from tests import made
from tests.test_layers import imports

SOURCE = Path(segfmu.__file__).parent


def needed(module: str) -> list[Path]:
    """A module and all that it imports, one after another; not packages, which only name others."""
    found: set[Path] = set()
    left = {module}
    while left:
        path = SOURCE.parent.joinpath(*left.pop().split(".")).with_suffix(".py")
        if path.is_file() and path not in found:
            found.add(path)
            left |= {name for name in imports(path) if name.startswith(f"{SOURCE.name}.")}
    return sorted(found)


def generated(name: str, generate: Callable[[], str], files: Sequence[Path]) -> str:
    """The text of a generator, which follows from files of the package."""
    if not made.unchanged(files):
        return generate()

    def told() -> dict[str, bytes]:
        texts = {p.relative_to(SOURCE).as_posix(): p.read_bytes() for p in files}
        return {"packages": made.interpreter()} | texts

    return made.made(f"Generated_{name}", told, lambda: generate().encode()).decode()
