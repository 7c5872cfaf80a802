"""A scenario that an end stop ends, as its file expects."""

from __future__ import annotations

from pathlib import Path

BASE = Path(__file__).parents[2] / "models" / "scenarios" / "_lab.toml"


def stopped(folder: Path) -> Path:
    """Write the file."""
    path = folder / "stopped.toml"
    path.write_text(
        f'base = "{BASE.as_posix()}"\nname = "an end stop nearer than the crane file has it"\n'
        'expect = "fail"\n[true_crane.travel]\nbridge = [-0.26, 0.1]\n',
        encoding="utf-8",
    )
    return path
