"""Results of a co-simulation: a structured array, and its CSV file."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from segfmu.errors import InputError


def write_csv(path: Path, rows: NDArray[Any]) -> None:
    """Write a structured array as CSV, full precision; the file appears when it is complete.

    Raises
    ------
    InputError
        When the file cannot be written.
    """
    temporary = path.with_name(f"{path.name}.part")
    names = rows.dtype.names or ()
    columns = np.column_stack([rows[n].astype(np.float64) for n in names])
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        np.savetxt(
            temporary, columns, fmt="%.17g", delimiter=",", comments="",
            header=",".join(f'"{n}"' for n in names),
        )
        os.replace(temporary, path)
    except OSError as error:
        temporary.unlink(missing_ok=True)
        raise InputError(f"{path}: cannot be written: {error.strerror}") from None
