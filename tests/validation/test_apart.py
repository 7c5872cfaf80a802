"""Functions in a process of their own: results, errors, messages, and its end."""

from __future__ import annotations

import logging
import os
import signal
import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from segfmu.cosim.messages import LOGGER
from segfmu.errors import InputError
from segfmu.validation.apart import Apart, Ended


@contextmanager
def working() -> Iterator[Callable[[str], tuple[int, str]]]:
    yield work


def work(task: str) -> tuple[int, str]:
    """The process and its place for temporary files, but for some words."""
    if task == "refuse":
        raise InputError("not this")
    if task == "say":
        print("in the way")
        LOGGER.warning("%s: %s", "probe", "hot", extra={"fmu": "probe"})
        LOGGER.info("not wanted")
    if task == "hang":
        signal.signal(signal.SIGTERM, signal.SIG_IGN)
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
