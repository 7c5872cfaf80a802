"""What the parts hand back, as tables on the terminal and as one JSON file."""

from __future__ import annotations

import json
import os
import platform
from collections.abc import Sequence
from dataclasses import asdict, dataclass, field
from importlib import metadata
from pathlib import Path

from rich.console import Console
from rich.table import Table

from segfmu.kernels.backend import COMPILED

Record = dict[str, str | float | int | None]
PACKAGES = ("segfmu", "numpy", "scipy", "ruckig", "casadi")


@dataclass(frozen=True)
class Settings:
    """What all parts are told.

    Attributes
    ----------
    problems : int
        Random problems of the comparison of durations.
    samples : int
        Problems of a timing.
    repetitions : int
        Passes over the problems of a timing; a ratio's spread is that of the passes.
    folder : Path
        Where archives and compiled drivers are kept.
    """

    problems: int
    samples: int
    repetitions: int
    folder: Path


@dataclass(frozen=True)
class Section:
    """One table; all its records have the same keys, which name value and unit."""

    title: str
    records: Sequence[Record]


@dataclass(frozen=True)
class Part:
    """The result of one module: tables, and lines on what they leave out."""

    title: str
    sections: Sequence[Section]
    notes: Sequence[str] = field(default_factory=tuple)


def show(part: Part, console: Console) -> None:
    """Print the tables of a part."""
    console.rule(part.title, align="left")
    for section in part.sections:
        columns = list(section.records[0]) if section.records else []
        table = Table(title=section.title, title_justify="left", title_style="bold")
        for column in columns:
            words = isinstance(section.records[0][column], str)
            table.add_column(column, justify="left" if words else "right")
        for record in section.records:
            table.add_row(*(_text(record[column]) for column in columns))
        console.print(table)
    for note in part.notes:
        console.print(f"note: {note}", markup=False, highlight=False)


def save(parts: dict[str, Part], path: Path) -> None:
    """Write all records, and on what they were measured, as JSON."""
    content = {"machine": machine(), "parts": {name: asdict(p) for name, p in parts.items()}}
    path.parent.mkdir(parents=True, exist_ok=True)
    beside = path.with_suffix(".part")
    beside.write_text(json.dumps(content, indent=1), encoding="utf-8")
    os.replace(beside, path)


def machine() -> Record:
    """Processor family, cores and versions; nothing that identifies the machine."""
    record: Record = {
        "processor": platform.machine(),
        "cores": os.cpu_count(),
        "system": platform.system(),
        "python": platform.python_version(),
        "kernels": "compiled" if COMPILED else "interpreted",
    }
    for package in PACKAGES:
        record[package] = installed_version(package)
    return record


def installed_version(package: str) -> str | None:
    """Version of an installed package, None where it is not."""
    try:
        return metadata.version(package)
    except metadata.PackageNotFoundError:
        return None


def _text(value: str | float | int | None) -> str:
    if value is None:
        return "-"
    if isinstance(value, float):
        return f"{value:.4g}"
    return str(value)
