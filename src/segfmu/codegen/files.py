"""Writing generated files."""

from __future__ import annotations

import os
from pathlib import Path


def write(target: Path, text: str) -> None:
    """Write a file beside its place, then put it there."""
    temporary = target.with_suffix(".tmp")
    temporary.write_text(text, encoding="utf-8")
    os.replace(temporary, target)
