"""Writing generated files."""

from __future__ import annotations

import os
from pathlib import Path


def write(target: Path, text: str) -> None:
    """Write a temporary file, then rename it to the path."""
    temporary = target.with_suffix(".tmp")
    temporary.write_text(text, encoding="utf-8")
    os.replace(temporary, target)
