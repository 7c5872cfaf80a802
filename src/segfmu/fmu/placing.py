"""Archives that get their names together, when all of them are complete."""

from __future__ import annotations

import errno
import os
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path

from segfmu.errors import BuildError
from segfmu.folders import make_folders, work_folder


@contextmanager
def placing(targets: Sequence[Path]) -> Iterator[Path]:
    """Give a temporary folder for files with the names of `targets`; on success they replace these.

    Raises
    ------
    BuildError
        If one of them cannot be written; if a folder has its name, none is replaced.
    """
    place = folder = targets[0].parent
    try:
        make_folders(folder)
        _require_files(targets)
        with work_folder(folder) as work:
            yield work
            _require_files(targets)
            for target in targets:
                place = target
                os.replace(work / target.name, target)
    except OSError as error:
        raise BuildError(f"{place}: cannot be written: {error.strerror}") from error


def _require_files(targets: Sequence[Path]) -> None:
    for target in targets:
        if target.is_dir():
            raise BuildError(f"{target}: cannot be written: {os.strerror(errno.EISDIR)}")
