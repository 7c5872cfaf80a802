"""Tables of results and of pages, read without the code that writes them."""

from __future__ import annotations

import csv
import re
from pathlib import Path

import numpy as np


def columns(path: Path) -> dict[str, np.ndarray]:
    """Columns by the names of the signals, without the units behind them."""
    with path.open(encoding="utf-8", newline="") as file:
        names = [name.partition(" [")[0] for name in next(csv.reader(file))]
        return dict(zip(names, np.loadtxt(file, delimiter=",", ndmin=2).T, strict=True))


def rows_of(page: Path, head: str) -> list[list[str]]:
    """Cells of the rows of the table whose first line begins so."""
    text = page.read_text(encoding="utf-8")
    block = text[text.index(f"| {head} |") :].partition("\n\n")[0]
    lines = block.splitlines()[2:]
    return [[cell.strip() for cell in line.strip("|").split("|")] for line in lines]


def require_length(told: str, found: float) -> None:
    """A length [m] is as told within a third, as "0.2 um", or "below 0.01 nm"."""
    number, unit = re.fullmatch(r"(?:below )?([\d.]+) (um|nm)", told).groups()  # type: ignore[union-attr]
    value = float(number) * {"um": 1e-6, "nm": 1e-9}[unit]
    assert found < 1.33 * value, (told, found)
    assert told.startswith("below") or found > value / 1.33, (told, found)
