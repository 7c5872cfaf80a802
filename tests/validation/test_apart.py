"""Functions in a process of their own: results, errors, messages, and its end."""

from __future__ import annotations

import logging
import os
import signal
import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest

from segfmu.cosim.messages import LOGGER
from segfmu.errors import InputError, SimulationError
from segfmu.validation.apart import Apart, Ended


@contextmanager
def working() -> Iterator[Callable[[Any], Any]]:
    yield work


class Two(Exception):
    """As of other packages: pickle cannot make it again of its text."""

    def __init__(self, first: str, second: str) -> None:
        super().__init__(f"{first} and {second}")


class Bare:
    """What pickle writes, and no other process can read."""

    def __reduce__(self) -> Any:
        return made, (os.getpid(),)


def made(process: int) -> Bare:
    if process != os.getpid():
        raise TypeError("not here")
    return Bare()


def work(task: Any) -> Any:
    """The process and its place for temporary files, but for some words."""
    if task == "refuse":
        raise InputError("not this")
    if task == "say":
        print("in the way")
        LOGGER.warning("%s: %s", "probe", "hot", extra={"fmu": "probe"})
        LOGGER.info("not wanted")
    if task == "hang":
        signal.signal(signal.SIGTERM, signal.SIG_IGN)
    if task == "say more":
        LOGGER.warning("%s", lambda: "no text")
    if task == "no result":
        return lambda: None
    if task == "no result there":
        return Bare()
    if task == "no error":
        raise Two("this", "that")
    if task == "exit":
        os._exit(0)
    if task == "die":
        os.kill(os.getpid(), signal.SIGSEGV)
    return os.getpid(), tempfile.gettempdir()


def test_one_process_has_all_calls_and_tells_errors_and_messages(
    caplog: pytest.LogCaptureFixture,
) -> None:
    with Apart(working) as apart:
        process, place = apart("")
        assert process != os.getpid() and Path(place).is_dir()
        with pytest.raises(InputError, match=r"^not this$"):
            apart("refuse")
        with caplog.at_level(logging.WARNING, LOGGER.name):
            assert apart("say") == (process, place)
    assert [record.getMessage() for record in caplog.records] == ["probe: hot"]
    assert not Path(place).exists()
    with pytest.raises(ProcessLookupError):
        os.kill(process, 0)


@pytest.mark.parametrize(("task", "reason"), [("die", "SIGSEGV"), ("exit", "exit code 0")])
def test_an_end_is_an_error_and_the_next_call_has_another_process(task: str, reason: str) -> None:
    with Apart(working) as apart:
        process, place = apart("")
        with pytest.raises(Ended, match=f"^an FMU ended its process: {reason}$"):
            apart(task)
        assert not Path(place).exists()
        assert apart("")[0] != process


@pytest.mark.parametrize(("task", "kind", "told"), [
    ("no result", SimulationError, "the result of the process that has .* cannot be pickled: .*la"),
    ("no result there", SimulationError, "the result .* cannot be read: TypeError: not here"),
    ("no error", SimulationError, "^Two: this and that$"),
    (lambda: None, InputError, "what is given to the process .* cannot be pickled: .*lambda"),
    (Bare(), InputError, "what is given .* cannot be made there: TypeError: not here"),
])
def test_what_goes_from_process_to_process_is_told_as_what_it_is(
    task: object, kind: type[Exception], told: str
) -> None:
    """All were "an FMU ended its process: exit code 1"."""
    with Apart(working) as apart:
        process, _ = apart("")
        with pytest.raises(kind, match=told) as found:
            apart(task)
        assert not isinstance(found.value, Ended)
        assert (apart("")[0] == process) is (task != "no result there")


def test_a_message_of_what_cannot_be_pickled_is_a_text(caplog: pytest.LogCaptureFixture) -> None:
    with Apart(working) as apart, caplog.at_level(logging.WARNING, LOGGER.name):
        apart("say more")
    (record,) = caplog.records
    assert record.getMessage().startswith("<function work.<locals>.<lambda>")


def test_a_process_that_hangs_is_killed_though_the_wait_for_it_is_interrupted() -> None:
    def stop(*_: object) -> None:
        raise SystemExit(143)

    before = signal.signal(signal.SIGALRM, stop)
    try:
        with pytest.raises(SystemExit), Apart(working) as apart:
            process, _ = apart("hang")
            signal.setitimer(signal.ITIMER_REAL, 0.3)
    finally:
        signal.signal(signal.SIGALRM, before)
    with pytest.raises(ProcessLookupError):
        os.kill(process, 0)
