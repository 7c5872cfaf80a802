"""Tables of signals over time, read from CSV."""

from __future__ import annotations

import csv
import re
import warnings
from pathlib import Path
from typing import TextIO

import numpy as np

from segfmu.arrays import FloatArray
from segfmu.errors import InputError

# behind a name, as in "load.position.x [m]"; indices of arrays follow theirs without a space
UNIT = re.compile(r"\s+\[[^\]]*\]$")


def _rows(file: TextIO) -> FloatArray:
    with warnings.catch_warnings():
        # an empty table is refused below
        warnings.filterwarnings("ignore", "loadtxt: input contained no data")
        return np.loadtxt(file, delimiter=",", ndmin=2)


def read_table(path: Path) -> dict[str, FloatArray]:
    """Columns of a CSV file by name: "time", which increases, and signals.

    Units in brackets behind the names are left out.

    Raises
    ------
    InputError
        If it cannot be read or is no such table.
    """
    try:
        with path.open(encoding="utf-8-sig", newline="") as file:
            names = [UNIT.sub("", name) for name in next(csv.reader(file), [])]
            data = _rows(file)
    except OSError as error:
        raise InputError(f"{path}: cannot be read: {error.strerror}") from None
    except (ValueError, csv.Error) as error:
        # what NumPy advises behind the semicolon is for its callers
        (told, *_) = re.split("[;\n]", str(error))
        raise InputError(f"{path}: no table of numbers: {told}") from None
    if "time" not in names:
        raise InputError(f"{path}: no column time")
    if len(set(names)) != len(names):
        raise InputError(f"{path}: two columns have one name")
    if data.shape[0] == 0:
        raise InputError(f"{path}: there is no row of numbers")
    if data.shape[1] != len(names):
        raise InputError(f"{path}: {len(names)} names but rows of {data.shape[1]} numbers")
    table: dict[str, FloatArray] = dict(zip(names, data.T, strict=True))
    if not np.all(np.diff(table["time"]) > 0.0):
        raise InputError(f"{path}: time does not increase")
    return table
