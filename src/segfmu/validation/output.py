"""Where results go: folders, and tables that are thinned to a useful size."""

from __future__ import annotations

import errno
import os
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from math import ceil
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from segfmu.arrays import shown
from segfmu.cosim import require_steps
from segfmu.crane import FlatInverse
from segfmu.errors import InputError, SegfmuError
from segfmu.folders import make_folder, make_folders, remove_folder
from segfmu.planning import Trajectory

if TYPE_CHECKING:
    from segfmu.validation.files.mission import Mission

# of a table without `simulation.output_step`: what spreadsheets and editors open at once
MOST_ROWS = 20_000


@contextmanager
def about(path: Path | None) -> Iterator[None]:
    """Name a mission's file, if it has one, in the errors that follow from it."""
    try:
        yield
    except SegfmuError as error:
        if path is not None and not str(error).startswith(str(path)):
            error.args = (f"{path}: {error}",)
        raise


def require_folder(name: str | Path, *files: str) -> None:
    """Check, without making anything, that a folder and files in it can be written.

    Raises
    ------
    InputError
        For the first thing that is in the way.
    """
    path = folder_path(name)
    reason = _obstacle(path)
    if reason is not None:
        raise _refusal(path, reason)
    for file in files:
        require_file(path / file)


def require_file(path: Path) -> None:
    """Check, without making anything, that a file can be written in a folder that can be made.

    Raises
    ------
    InputError
        If a folder has its name, or its own folder cannot be made or written to.
    """
    reason = os.strerror(errno.EISDIR) if path.is_dir() else _obstacle(path.absolute().parent)
    if reason is not None:
        raise InputError(f"{path}: cannot be written: {reason}")


def require_apart(file: Path, output: str | Path, *names: str) -> None:
    """Refuse a file that is the folder of the results, above it, or one of these files in it.

    Raises
    ------
    InputError
        That names both.
    """
    own, place = file.resolve(), folder_path(output).resolve()
    if own == place or own in place.parents or own in [place / name for name in names]:
        what = "among" if own.parent == place else "in the place of"
        raise InputError(
            f"{file}: would be {what} the results in {output}; give it another name"
        )


def require_kept(read: Iterable[str | Path | None], written: Iterable[Path]) -> None:
    """Refuse to write over what is read.

    Raises
    ------
    InputError
        That names the first file that would be lost.
    """
    there = [path for path in read if path is not None and os.path.exists(path)]
    for path in filter(os.path.exists, written):
        lost = next((own for own in there if os.path.samefile(own, path)), None)
        if lost is not None:
            raise InputError(
                f"{lost}: is read, and the results would be written over it; name another output"
            )


def require_there(paths: Iterable[Path]) -> None:
    """Refuse to go on, or to tell of files, where others have removed what was written.

    Raises
    ------
    InputError
        That names the first one.
    """
    gone = next((path for path in paths if not path.exists()), None)
    if gone is not None:
        raise InputError(
            f"{gone}: was written and is gone: it or its folder was removed meanwhile; repeat the "
            "command, and leave the folder alone until it ends"
        )


def _obstacle(path: Path) -> str | None:
    """Why nothing can be written into a folder, or it cannot be made."""
    # the part that there is
    there = next((p for p in (path, *path.parents) if os.path.lexists(p)), Path())
    if not there.is_dir():
        return os.strerror(errno.ENOTDIR)
    if os.access(there, os.W_OK | os.X_OK):
        return None
    closed = hasattr(os, "statvfs") and os.statvfs(there).f_flag & os.ST_RDONLY
    return os.strerror(errno.EROFS if closed else errno.EACCES)


def file_path(name: Any) -> Path:
    """The path of a file to be written.

    Raises
    ------
    InputError
        If it is none.
    """
    if not isinstance(name, str | os.PathLike) or not os.fspath(name) or "\0" in str(name):
        raise InputError(f"the path of a file must be given, got {shown(name)}")
    return Path(name)


def folder(name: str | Path) -> Path:
    """The folder for the output, created.

    Raises
    ------
    InputError
        If there is no name, or no folder of this name can be made or written to.
    """
    path = folder_path(name)
    try:
        make_folders(path)
        remove_folder(make_folder(path))
    except (OSError, ValueError) as error:
        reason = (error.strerror if isinstance(error, OSError) else None) or str(error)
        raise _refusal(path, reason) from None
    return path


def _refusal(path: Path, reason: str) -> InputError:
    """Why a path is no folder for the output."""
    try:
        if path.is_dir():
            return InputError(f"output {path}: cannot write into this folder: {reason}")
        if os.path.lexists(path):
            what = "a file" if os.path.exists(path) else "a link that leads nowhere"
            return InputError(f"output {path}: this is no folder, but {what}; name another one")
    except ValueError:
        # a zero byte
        pass
    return InputError(f"output {path}: cannot create this folder: {reason}")


def folder_path(name: Any) -> Path:
    """The path of a folder for the output, or with it.

    Raises
    ------
    InputError
        If it is none.
    """
    if not isinstance(name, str | os.PathLike):
        raise InputError(f"output must be the path of a folder, got {shown(name)}")
    if not str(name).strip():
        raise InputError("output is empty; name a folder, . for this one")
    return Path(name)


def stride(mission: Mission, duration: float) -> int:
    """Communication steps from one row of a table to the next.

    Raises
    ------
    InputError
        For an `output_step` of too many rows.
    """
    own = mission.simulation
    if own.output_step is None:
        return max(1, ceil(duration / own.step / MOST_ROWS - 1e-9))
    try:
        require_steps(duration, own.output_step)
    except InputError as error:
        raise InputError(f"simulation.output_step: {error}") from None
    return max(1, round(own.output_step / own.step))


def thinned(rows: NDArray[np.void], every: int) -> NDArray[np.void]:
    """Every so many rows, and the last one."""
    places = np.arange(0, rows.size, every)
    return rows[places if places[-1] == rows.size - 1 else np.append(places, rows.size - 1)]


def note(name: str, every: int, step: float) -> str:
    """What a thinned table leaves out; empty if nothing."""
    if every == 1:
        return ""
    return (
        f"{name} has a row every {every * step:.6g} s, not every step of {step:.6g} s; "
        "simulation.output_step sets this"
    )


def plan_samples(mission: Mission, trajectory: Trajectory, every: int) -> NDArray[np.void]:
    """The plan and its feedforward every so many communication steps, and at its end.

    Forces are left out where they jump, see `FlatInverse.force`.
    """
    step = every * mission.simulation.step
    times = np.append(np.arange(0.0, trajectory.duration, step), trajectory.duration)
    columns = {"time": times}
    for order, name in enumerate(("position", "velocity", "acceleration", "jerk", "snap")):
        for axis, values in zip("xyz", trajectory(times, order).T, strict=True):
            columns[f"reference.load.{name}.{axis}"] = values
    inverse = FlatInverse(mission.build_crane(), trajectory, mission.build_friction())
    tables = {"velocity": inverse.velocity(times)}
    if trajectory.smoothness >= inverse.model.orders - 1:
        tables = {"force": inverse.force(times), **tables}
    for kind, table in tables.items():
        for drive, values in zip(("bridge", "trolley", "hoist"), table.T, strict=True):
            columns[f"{kind}.{drive}"] = values
    rows = np.zeros(times.size, dtype=[(n, np.float64) for n in columns])
    for name, values in columns.items():
        rows[name] = values
    return rows
