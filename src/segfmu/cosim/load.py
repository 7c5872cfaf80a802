"""From an archive to a unit of its version of the standard."""

from __future__ import annotations

import zipfile
from collections.abc import Iterator
from contextlib import contextmanager
from functools import lru_cache
from pathlib import Path
from typing import Any

from fmpy import extract, platform, platform_tuple, read_model_description

from segfmu.cosim.unit import Unit
from segfmu.cosim.unit2 import Unit2
from segfmu.cosim.unit3 import Unit3
from segfmu.errors import InputError, first_line
from segfmu.folders import make_folder, remove_folder, temporary_files


def load(path: Path, *, leads: bool = False, name: str | None = None) -> Unit:
    """Unpack and instantiate an FMU for co-simulation.

    Parameters
    ----------
    path : Path
        The archive.
    leads : bool
        Whether steps may end at its events.
    name : str, optional
        Its name in messages; by default the model's.

    Raises
    ------
    InputError
        If it is not a readable FMU with co-simulation of FMI 2.0 or 3.0.
    SimulationError
        If it cannot be instantiated, with its message.
    """
    folder = make_folder()
    try:
        description = _unpacked(path, folder)
        kind = Unit2 if description.fmiVersion == "2.0" else Unit3
        return kind(folder, description, leads, name)
    except BaseException:
        remove_folder(folder)
        raise


def describe(path: Path) -> Any:
    """The description in an archive, as fmpy reads it.

    Raises
    ------
    InputError
        If it is not a readable FMU.
    """
    with _naming(path):
        found = path.stat()
        return _description(str(path), (found.st_ino, found.st_size, found.st_mtime_ns))


def _unpacked(path: Path, folder: Path) -> Any:
    description = describe(path)
    with _naming(path), temporary_files():
        extract(str(path), unzipdir=str(folder), include=_runs)
    version = description.fmiVersion
    if version not in ("2.0", "3.0") or description.coSimulation is None:
        raise InputError(
            f"{path}: the master needs co-simulation of FMI 2.0 or 3.0, this is FMI {version}"
        )
    return description


@contextmanager
def _naming(path: Path) -> Iterator[None]:
    """Name an archive in what goes wrong with it."""
    try:
        yield
    except InputError:
        raise
    except OSError as error:
        raise InputError(f"{path}: cannot be read: {error.strerror or error}") from None
    except zipfile.BadZipFile as error:
        raise InputError(f"{path}: not a readable FMU: {error}") from None
    except Exception as error:
        # fmpy raises bare exceptions for descriptions it refuses
        raise InputError(f"{path}: not a valid FMU: {first_line(error)}") from None


@lru_cache(maxsize=16)
def _description(path: str, _: tuple[int, ...]) -> Any:
    """The description in an archive, read once while its file stays the same."""
    return read_model_description(path)


def _runs(name: str) -> bool:
    """Whether this machine may need a file of the archive to run it."""
    top, _, below = name.partition("/")
    if top == "binaries":
        return below.split("/")[0] in (platform, platform_tuple)
    return top not in ("sources", "documentation")
