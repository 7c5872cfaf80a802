"""Results of a co-simulation: a structured array, and its CSV file."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from secrets import token_hex
from typing import Any

import numpy as np
from numpy.typing import NDArray

from segfmu.arrays import require_mapping, shown
from segfmu.errors import InputError
from segfmu.folders import make_folders, work_folder


@contextmanager
def replacing(path: Path) -> Iterator[Path]:
    """Give a temporary path to write to; on success its file becomes that of `path`.

    It replaces a file, also one that `path` is a link to; a device or a pipe gets the bytes.

    Raises
    ------
    InputError
        If the file cannot be written.
    """
    try:
        if path.exists() and not path.is_file() and not path.is_dir():
            with work_folder() as folder:
                temporary = folder / path.name
                yield temporary
                with path.open("wb") as device:
                    device.write(temporary.read_bytes())
            return
        place = Path(os.path.realpath(path))
        # others may write to the same file
        temporary = place.with_name(f"{place.name}.{token_hex(4)}.part")
        make_folders(place.parent)
        try:
            yield temporary
            os.replace(temporary, place)
        finally:
            temporary.unlink(missing_ok=True)
    except OSError as error:
        raise InputError(f"{path}: cannot be written: {error.strerror}") from None


def write_csv(
    path: str | Path, rows: NDArray[Any], units: Mapping[str, str] | None = None
) -> None:
    """Write a structured array as CSV, full precision; the file appears when it is complete.

    The header has the names of the signals, with a unit in brackets where `units` has one.

    Raises
    ------
    InputError
        When the file cannot be written, and for rows that are no structured array of numbers.
    """
    if not isinstance(path, str | Path):
        raise InputError(f"path must be that of a file, got {shown(path)}")
    names = rows.dtype.names if isinstance(rows, np.ndarray) else None
    if not names or rows.ndim != 1:
        raise InputError(
            f"rows must be a structured array, as simulate returns it, got {shown(rows)}"
        )
    known = {} if units is None else units
    require_mapping("units", known)
    texts = [n for n in names if rows.dtype[n].kind not in "biuf"]
    if texts:
        raise InputError(f"column {texts[0]} must have numbers, got {rows.dtype[texts[0]]}")
    columns = np.column_stack([rows[n].astype(np.float64) for n in names])
    header = ",".join(f'"{n} [{known[n]}]"' if n in known else f'"{n}"' for n in names)
    with replacing(Path(path)) as temporary:
        np.savetxt(
            temporary, columns, fmt="%.17g", delimiter=",", comments="", header=header
        )
