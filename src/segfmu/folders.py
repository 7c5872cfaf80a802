"""Temporary folders: none outlives the process, whenever a signal ends it."""

from __future__ import annotations

import atexit
import os
import shutil
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from secrets import token_hex

from segfmu.errors import InputError, SegfmuError

# with the process that made it: one that is forked from it must leave it
_present: set[tuple[Path, int]] = set()


def make_folders(folder: Path) -> None:
    """Make a folder that may be there, and those above it: one after the other, however many.

    Raises
    ------
    OSError
        If one cannot be made.
    """
    for place in (*reversed(folder.parents), folder):
        if not place.is_dir():
            place.mkdir(exist_ok=True)


def make_folder(parent: Path | None = None) -> Path:
    """A new temporary folder, in `parent` or in the system's place for them.

    Raises
    ------
    OSError
        If it cannot be made in `parent`.
    InputError
        If it cannot be made in the system's place.
    """
    if parent is None:
        with temporary_files():
            return make_folder(Path(tempfile.gettempdir()))
    folder = parent / f"segfmu_{token_hex(8)}"
    # known before it is there: a signal between the two would leave it
    _present.add((folder, os.getpid()))
    folder.mkdir(mode=0o700)
    return folder


@contextmanager
def temporary_files(kind: type[SegfmuError] = InputError) -> Iterator[None]:
    """Name the system's place for temporary files in what goes wrong with those of a block.

    Raises
    ------
    SegfmuError
        Of this kind, for an error of the system, which callers would take for one of the output.
    """
    try:
        yield
    except OSError as error:
        place = f" in {tempfile.tempdir}" if tempfile.tempdir else ""
        raise kind(
            f"temporary files cannot be written{place}: {error.strerror or error}; the variable "
            "TMPDIR can name another folder"
        ) from error


def remove_folder(folder: Path) -> None:
    """Remove a folder of `make_folder`; if that is interrupted or fails, it is done at the end."""
    shutil.rmtree(folder, ignore_errors=True)
    # a program that is still writing to it can keep it
    if not folder.exists():
        _present.discard((folder, os.getpid()))


@contextmanager
def work_folder(parent: Path | None = None) -> Iterator[Path]:
    """A temporary folder for the time of a block."""
    folder = make_folder(parent)
    try:
        yield folder
    finally:
        remove_folder(folder)


@atexit.register
def _remove_all() -> None:
    for folder, process in tuple(_present):
        if process == os.getpid():
            remove_folder(folder)
