"""A function in a process of its own, which an FMU of others may end without ending ours.

What the FMUs say there is logged here; what they print goes to standard error.
"""

from __future__ import annotations

import logging
import os
import pickle
import signal
import subprocess
import sys
import tempfile
from collections.abc import Callable
from contextlib import AbstractContextManager, suppress
from pathlib import Path
from threading import Lock
from typing import IO, Any, Generic, ParamSpec, TypeVar

from segfmu.cosim.messages import LOGGER
from segfmu.errors import SimulationError
from segfmu.folders import make_folder, remove_folder

Arguments = ParamSpec("Arguments")
Found = TypeVar("Found")

# s; for the process to free what it has, and to end its compilers
PATIENCE = 5.0
# kinds of what the process tells
SAID, FOUND, RAISED = range(3)


class Ended(SimulationError):
    """The process ended before the function did."""


class Apart(Generic[Arguments, Found]):
    """Calls a function in another process; a context manager that ends it.

    The process begins with the first call, and anew with the one after its end. A signal of the
    terminal does not reach it. Arguments and results are pickled.

    Parameters
    ----------
    make : callable
        Returns a context manager of the function, which the process enters once.
    """

    def __init__(
        self, make: Callable[[], AbstractContextManager[Callable[Arguments, Found]]]
    ) -> None:
        self._make = make
        self._process: subprocess.Popen[bytes] | None = None
        # its temporary files: one that is killed leaves them
        self._folder: Path | None = None

    def __enter__(self) -> Apart[Arguments, Found]:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def __call__(self, *values: Arguments.args, **named: Arguments.kwargs) -> Found:
        """What the function returns.

        Raises
        ------
        Ended
            If the process ended, with its signal or exit code.
        Exception
            That of the function.
        """
        process = self._process or self._begin()
        try:
            _send(process.stdin, (values, named))
            kind, told = _heard(process.stdout)
        except (EOFError, OSError, pickle.UnpicklingError):
            raise Ended(f"an FMU ended its process: {self._reason(process)}") from None
        if kind == RAISED:
            raise told
        found: Found = told
        return found

    def close(self) -> None:
        """End the process, and remove its temporary files."""
        process, self._process = self._process, None
        if process is not None:
            # leaving it closes the pipes, one of which may be broken
            with suppress(OSError), process:
                process.terminate()
                try:
                    with suppress(subprocess.TimeoutExpired):
                        process.wait(PATIENCE)
                finally:
                    # a signal that stops the command may be raised again in this wait
                    process.kill()
        if self._folder is not None:
            remove_folder(self._folder)
            self._folder = None

    def _begin(self) -> subprocess.Popen[bytes]:
        self._folder = make_folder()
        code = f"import sys; sys.path[:] = {sys.path!r}; from {__name__} import main; main()"
        self._process = subprocess.Popen(
            [sys.executable, "-c", code, str(self._folder)], start_new_session=True,
            stdin=subprocess.PIPE, stdout=subprocess.PIPE,
        )
        with suppress(OSError):
            _send(self._process.stdin, self._make)
        return self._process

    def _reason(self, process: subprocess.Popen[bytes]) -> str:
        with suppress(subprocess.TimeoutExpired):
            process.wait(PATIENCE)
        self.close()
        code = process.returncode
        return signal.Signals(-code).name if code < 0 else f"exit code {code}"


def _send(pipe: IO[bytes] | None, what: object) -> None:
    assert pipe is not None
    pipe.write(pickle.dumps(what))
    pipe.flush()


def _heard(pipe: IO[bytes] | None) -> tuple[int, Any]:
    """Kind and value of what the function came to; what FMUs say until then is logged."""
    assert pipe is not None
    while True:
        kind, told = pickle.load(pipe)
        if kind != SAID:
            return kind, told
        if LOGGER.isEnabledFor(told.levelno):
            LOGGER.handle(told)


class _Records(logging.Handler):
    """Sends all records; runs that are given up log in threads of their own."""

    def __init__(self, replies: IO[bytes]) -> None:
        super().__init__(logging.INFO)
        self._replies, self._sending = replies, Lock()

    def emit(self, record: logging.LogRecord) -> None:
        self.send(SAID, record)

    def send(self, kind: int, what: object) -> None:
        with self._sending:
            _send(self._replies, (kind, what))


def main() -> None:
    """Perform the calls that standard input has, until this process is ended."""
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))
    tempfile.tempdir = sys.argv[1]
    # FMUs may read and print
    calls, replies = os.fdopen(os.dup(0), "rb"), os.fdopen(os.dup(1), "wb")
    os.dup2(os.open(os.devnull, os.O_RDONLY), 0)
    os.dup2(2, 1)
    records = _Records(replies)
    LOGGER.addHandler(records)
    LOGGER.setLevel(logging.INFO)
    LOGGER.propagate = False
    with suppress(EOFError), pickle.load(calls)() as function:
        while True:
            values, named = pickle.load(calls)
            try:
                found = FOUND, function(*values, **named)
            except Exception as error:
                found = RAISED, error
            records.send(*found)
