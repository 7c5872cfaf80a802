"""Programs that compile: several at once, and none goes on when the work is stopped."""

from __future__ import annotations

import os
import signal
import subprocess
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from pathlib import Path
from threading import Event, Lock, local
from typing import TypeVar

from segfmu.errors import BuildError

T = TypeVar("T")
R = TypeVar("R")
_running: set[subprocess.Popen[str]] = set()
# held while a program starts: one that is ended all at once is known by then
_starting = Lock()
# of a thread of `on_all_cores`: whether its work has been stopped
_own = local()


def run(command: Sequence[str], folder: Path) -> tuple[int, str]:
    """Exit code and errors of a program that works in a folder.

    Raises
    ------
    BuildError
        If it cannot be run.
    """
    # a compiler that is stopped leaves its files: in the folder, which is removed
    own = os.environ | {"TMPDIR": str(folder)}
    try:
        with _starting:
            if hasattr(_own, "stopped") and _own.stopped.is_set():
                raise BuildError(f"{command[0]}: stopped before it began")
            process = subprocess.Popen(
                command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
                errors="replace", cwd=folder, env=own, start_new_session=True,
            )
            _running.add(process)
    except OSError as error:
        raise BuildError(f"{command[0]} cannot be run: {error.strerror}") from None
    with process:
        try:
            _, said = process.communicate()
        except BaseException:
            _end(process)
            raise
        finally:
            _running.discard(process)
    return process.returncode, said


def on_all_cores(work: Callable[[T], R], items: Sequence[T]) -> list[R]:
    """Results of calls that run programs, in order; what stops one of them stops all.

    A signal reaches this thread alone, so it ends the programs of the others.
    """
    stopped = Event()
    with ThreadPoolExecutor(
        os.cpu_count(), initializer=setattr, initargs=(_own, "stopped", stopped)
    ) as pool:
        try:
            calls = [pool.submit(work, item) for item in items]
            return [call.result() for call in calls]
        except BaseException:
            pool.shutdown(wait=False, cancel_futures=True)
            with _starting:
                stopped.set()
                for process in tuple(_running):
                    _end(process)
            raise


def _end(process: subprocess.Popen[str]) -> None:
    """End a compiler and the programs that it runs: these would go on to write files."""
    if os.name == "posix":
        with suppress(ProcessLookupError):
            os.killpg(process.pid, signal.SIGKILL)
    else:
        process.kill()
