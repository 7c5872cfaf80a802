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
from segfmu.errors import InputError, SimulationError, first_line
from segfmu.folders import make_folder, remove_folder

Arguments = ParamSpec("Arguments")
Found = TypeVar("Found")

# s; for the process to free what it has, and to end its compilers
PATIENCE = 5.0
# kinds of what the process tells
SAID, FOUND, RAISED = range(3)
# what goes from process to process, and how
GIVEN = "what is given to the process that has the FMUs of others"
MADE = "the result of the process that has the FMUs of others"
PICKLED = "use values and classes that pickle takes, of modules that both processes import"


class Ended(SimulationError):
    """The process ended before the function did."""


class Apart(Generic[Arguments, Found]):
    """Calls a function in another process; a context manager that ends it.

    The process begins with the first call, and anew with the one after its end. A signal of the
    terminal does not reach it. Arguments, results and errors are pickled.

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
        InputError
            For arguments that cannot be pickled, or that the process cannot make of that.
        SimulationError
            For a result that cannot be pickled, and in place of an error of the function of which
            this is true.
        Exception
            That of the function.
        """
        try:
            # as bytes, which are read whole, whatever becomes of them
            given = pickle.dumps((values, named))
        except Exception as error:
            raise InputError(f"{GIVEN} cannot be pickled: {_told(error)}; {PICKLED}") from None
        process = self._process or self._begin()
        try:
            _send(process.stdin, pickle.dumps(given))
            kind, told = _heard(process.stdout)
        except (EOFError, OSError, pickle.UnpicklingError):
            raise Ended(f"an FMU ended its process: {self._reason(process)}") from None
        except Exception as error:
            # what is left of it would pass for the next one
            self.close()
            raise SimulationError(f"{MADE} cannot be read: {_told(error)}; {PICKLED}") from None
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
            _send(self._process.stdin, pickle.dumps(self._make))
        return self._process

    def _reason(self, process: subprocess.Popen[bytes]) -> str:
        with suppress(subprocess.TimeoutExpired):
            process.wait(PATIENCE)
        self.close()
        code = process.returncode
        return signal.Signals(-code).name if code < 0 else f"exit code {code}"


def _send(pipe: IO[bytes] | None, pickled: bytes) -> None:
    assert pipe is not None
    pipe.write(pickled)
    pipe.flush()


def _told(error: Exception) -> str:
    return f"{type(error).__name__}: {first_line(error)}"


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
    """Sends all records, as texts; runs that are given up log in threads of their own."""

    def __init__(self, replies: IO[bytes]) -> None:
        super().__init__(logging.INFO)
        self._replies, self._sending = replies, Lock()

    def emit(self, record: logging.LogRecord) -> None:
        text = {"msg": record.getMessage(), "args": None, "exc_info": None}
        self.send(pickle.dumps((SAID, logging.makeLogRecord(vars(record) | text))))

    def send(self, pickled: bytes) -> None:
        with self._sending:
            _send(self._replies, pickled)


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
            records.send(_reply(function, pickle.load(calls)))


def _reply(function: Callable[..., object], given: bytes) -> bytes:
    """What a call came to, pickled."""
    try:
        values, named = pickle.loads(given)
    except Exception as error:
        text = f"{GIVEN} cannot be made there: {_told(error)}; {PICKLED}"
        return pickle.dumps((RAISED, InputError(text)))
    try:
        found = function(*values, **named)
    except Exception as error:
        return _raised(error)
    try:
        return pickle.dumps((FOUND, found))
    except Exception as error:
        text = f"{MADE} cannot be pickled: {_told(error)}; {PICKLED}"
        return pickle.dumps((RAISED, SimulationError(text)))


def _raised(error: Exception) -> bytes:
    """An error, pickled; in place of one that is not made again of this its text."""
    try:
        pickled = pickle.dumps((RAISED, error))
        pickle.loads(pickled)
    except Exception:
        return pickle.dumps((RAISED, SimulationError(_told(error))))
    return pickled
