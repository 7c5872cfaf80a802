"""What the workers do: run scenarios with FMUs that each thread keeps loaded."""

from __future__ import annotations

import logging
import threading
from collections.abc import Callable, Sequence
from concurrent.futures import Future
from dataclasses import dataclass
from functools import partial
from time import perf_counter
from typing import Any, TypeVar

from segfmu.cosim.messages import LOGGER
from segfmu.errors import SegfmuError
from segfmu.validation.files.scenario_file import Source, build_scenario
from segfmu.validation.monitor import Finding
from segfmu.validation.suite import Runner

Found = TypeVar("Found")

# an FMU runs in one thread at a time, and workers may have several
_runners: dict[int, Runner] = {}


@dataclass(frozen=True)
class Order:
    """A run that is to be made: its number, the place of its scenario, and changes of it."""

    number: int
    scenario: int
    changes: dict[str, Any]


@dataclass(frozen=True)
class Outcome:
    """A run that was made.

    Attributes
    ----------
    number : int
    passed : bool
    error : str
        Why there are no findings; empty if there are.
    arrival : float or None
        Time at which the motion ends [s].
    findings : tuple of Finding
    hung : bool
        Whether it is still running in a thread that nothing can stop but the end of the process.
    """

    number: int
    passed: bool = False
    error: str = ""
    arrival: float | None = None
    findings: tuple[Finding, ...] = ()
    hung: bool = False


def perform(
    sources: Sequence[Source], orders: Sequence[Order], timeout: float | None = None
) -> tuple[list[Outcome], float]:
    """Make runs; returns their outcomes, and how long they took [s].

    A run that takes longer than `timeout` [s] is the last one: its FMU may hang.
    """
    # warnings of an FMU are the same in hundreds of runs
    LOGGER.setLevel(logging.CRITICAL)
    begin = perf_counter()
    outcomes: list[Outcome] = []
    for order in orders:
        own = threading.get_ident()
        if own not in _runners:
            _runners[own] = Runner(rows=False)
        made = partial(_made, _runners[own], sources[order.scenario], order)
        outcomes.append(_limited(made, order, timeout))
        if outcomes[-1].hung:
            # the thread that hangs keeps it
            del _runners[own]
            break
    return outcomes, perf_counter() - begin


def release() -> None:
    """Free the FMUs of all threads."""
    while _runners:
        _runners.popitem()[1].close()


def _limited(make: Callable[[], Outcome], order: Order, timeout: float | None) -> Outcome:
    found = within(timeout, make)
    if found is None:
        error = f"did not end within timeout = {timeout:g} s"
        return Outcome(order.number, error=error, hung=True)
    return found


def within(timeout: float | None, work: Callable[[], Found]) -> Found | None:
    """What `work` returns; None if it takes longer [s], and its thread is left to itself.

    Raises
    ------
    SegfmuError
        That of the work.
    """
    if timeout is None:
        return work()
    found: Future[Found] = Future()

    def perform() -> None:
        try:
            found.set_result(work())
        except Exception as error:
            found.set_exception(error)

    threading.Thread(target=perform, daemon=True).start()
    try:
        return found.result(timeout)
    except TimeoutError:
        if found.done():
            raise
        return None


def _made(runner: Runner, source: Source, order: Order) -> Outcome:
    try:
        result = runner.run(build_scenario(source, order.changes))
    except SegfmuError as error:
        return Outcome(order.number, error=_line(str(error)))
    except Exception as error:
        # a campaign goes on, whatever happens to one of its runs
        return Outcome(order.number, error=_line(f"{type(error).__name__}: {error}"))
    return Outcome(
        order.number, result.passed, _line(result.error), result.known.get("arrival"),
        result.findings,
    )


def _line(text: str) -> str:
    return " ".join(text.split())
