"""Tables of results, read without the code that writes them."""

from __future__ import annotations

import csv
from pathlib import Path

import numpy as np


def columns(path: Path) -> dict[str, np.ndarray]:
    """Columns by the names of the signals, without the units behind them."""
    with path.open(encoding="utf-8", newline="") as file:
        names = [name.partition(" [")[0] for name in next(csv.reader(file))]
        return dict(zip(names, np.loadtxt(file, delimiter=",", ndmin=2).T, strict=True))
