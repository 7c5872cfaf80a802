"""What the workers do: run scenarios with FMUs that each thread keeps loaded."""

from __future__ import annotations

import logging
import threading
from collections.abc import Sequence
from dataclasses import dataclass
from time import perf_counter
from typing import Any

from segfmu.cosim.messages import LOGGER
from segfmu.errors import SegfmuError
from segfmu.validation.files.scenario_file import Source, build_scenario
from segfmu.validation.monitor import Finding
from segfmu.validation.suite import Runner

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
    """

    number: int
    passed: bool = False
    error: str = ""
    arrival: float | None = None
    findings: tuple[Finding, ...] = ()


def perform(
    sources: Sequence[Source], orders: Sequence[Order]
) -> tuple[list[Outcome], float]:
    """Make runs; returns their outcomes, and how long they took [s]."""
    # warnings of an FMU are the same in hundreds of runs
    LOGGER.setLevel(logging.CRITICAL)
    begin = perf_counter()
    runner = _runners.setdefault(threading.get_ident(), Runner())
    return [_made(runner, sources[o.scenario], o) for o in orders], perf_counter() - begin


def release() -> None:
    """Free the FMUs of all threads."""
    while _runners:
        _runners.popitem()[1].close()


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
