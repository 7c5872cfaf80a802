"""What generators write, kept until a source or a package changes."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import segfmu
from tests import made
from tests.test_layers import ALLOWED

SOURCE = Path(segfmu.__file__).parent


def sources() -> list[Path]:
    """All modules that a generator may import, and hence all that it may read."""
    own = {"codegen"} | ALLOWED["codegen"]
    return [
        path for path in SOURCE.rglob("*.py")
        if path.relative_to(SOURCE).parts[0].removesuffix(".py") in own
    ]


def generated(name: str, generate: Callable[[], str]) -> str:
    """The text of a generator."""
    if not made.unchanged(sources()):
        return generate()

    def told() -> dict[str, bytes]:
        texts = {p.relative_to(SOURCE).as_posix(): p.read_bytes() for p in sources()}
        return {"packages": made.interpreter()} | texts

    return made.made(f"Generated_{name}", told, lambda: generate().encode()).decode()
