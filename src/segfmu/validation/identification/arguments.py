"""What `identify` is given: a crane, logs, and names of their columns."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from segfmu.arrays import as_names, as_tuple, require_mapping, shown
from segfmu.errors import InputError
from segfmu.validation.files.crane_file import CraneFile
from segfmu.validation.files.crane_models import model_of
from segfmu.validation.files.crane_parameters import check
from segfmu.validation.files.kinds import require_kind
from segfmu.validation.files.objects import plain
from segfmu.validation.files.reading import checked, read
from segfmu.validation.identification.log import Log, LogSource, read_log


def checked_columns(given: Any) -> Mapping[str, str]:
    """Names of columns in the logs; none where none are given."""
    columns: Mapping[str, str] = {} if given is None else given
    require_mapping("columns", columns)
    as_names("columns", (*columns, *columns.values()))
    return columns


def crane_of(source: str | Path | Mapping[str, Any]) -> tuple[CraneFile, Path | None]:
    """The crane and its file, if it has one; InputError for a crane that no log can tell."""
    if not isinstance(source, str | Path | Mapping):
        raise InputError(f"crane must be a file or a dict, got {shown(source)}")
    path = None if isinstance(source, Mapping) else Path(source)
    where = str(path or "crane")
    data = plain(source) if path is None else read(path)
    require_kind("crane", data, where)
    file = checked(CraneFile, data, where)
    check(file, where)
    if key := model_of(file).key:
        raise InputError(
            f"{where}: {key}: a log is told by the model of a load on its rope; measure with the "
            f"load alone on it, and take [{key}] out of the crane file meanwhile"
        )
    return file, path


def logs_of(
    logs: LogSource | Sequence[LogSource], file: CraneFile, columns: Mapping[str, str]
) -> list[Log]:
    """All logs; a table of another package is none, and its parts are none either."""
    if isinstance(logs, np.ndarray) or hasattr(logs, "columns"):
        raise InputError(
            f"logs must be files or dicts of columns, got {type(logs).__name__}; give a dict of "
            "its columns by their names"
        )
    sources = _sources(logs)
    if not sources:
        raise InputError("no logs; name at least one")
    for i, source in enumerate(sources):
        if any(_same(source, other) for other in sources[:i]):
            raise InputError(f"{source}: is there twice among the logs, and would count twice")
    return [
        read_log(source, file.drive, columns, f"log {i}") for i, source in enumerate(sources, 1)
    ]


def unseen_of(
    validation: LogSource, logs: LogSource | Sequence[LogSource], file: CraneFile,
    columns: Mapping[str, str],
) -> Log:
    """The log that is only predicted; InputError for one that is fitted."""
    if any(_same(validation, log) for log in _sources(logs)):
        raise InputError(
            f"{validation}: is fitted, so that it validates nothing; name another log, or leave "
            "validation out: the end of each log is held out"
        )
    return read_log(validation, file.drive, columns, "validation")


def _sources(logs: LogSource | Sequence[LogSource]) -> Sequence[LogSource]:
    return [logs] if isinstance(logs, str | Path | Mapping) else as_tuple("logs", logs)


def _same(one: Any, other: Any) -> bool:
    """Whether both are one file."""
    paths = isinstance(one, str | Path) and isinstance(other, str | Path)
    return paths and os.path.exists(one) and os.path.exists(other) and os.path.samefile(one, other)
