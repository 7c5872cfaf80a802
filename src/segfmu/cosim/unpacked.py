"""Folders of unpacked archives: none outlives the process, whenever it is stopped."""

from __future__ import annotations

import atexit
import shutil
import tempfile
from pathlib import Path

_present: set[Path] = set()


def make_folder() -> Path:
    """A new temporary folder."""
    folder = Path(tempfile.mkdtemp(prefix="segfmu_fmu_"))
    _present.add(folder)
    return folder


def remove_folder(folder: Path) -> None:
    """Remove a folder of `make_folder`; if that is interrupted, it is done at the end."""
    shutil.rmtree(folder, ignore_errors=True)
    _present.discard(folder)


@atexit.register
def _remove_all() -> None:
    for folder in tuple(_present):
        remove_folder(folder)
