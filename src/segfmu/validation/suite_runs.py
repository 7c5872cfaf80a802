"""Runs of a suite: those with FMUs of others in a process of their own, which these may end."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager

from segfmu.validation.apart import Apart, Ended
from segfmu.validation.files.scenario_file import Scenario
from segfmu.validation.scenario_result import Result
from segfmu.validation.suite import Runner


class Runs:
    """Runs scenarios, as `Runner` does; a context manager that frees the FMUs."""

    def __init__(self) -> None:
        self._own, self._others = Runner(), Apart(_runner)

    def __enter__(self) -> Runs:
        return self

    def __exit__(self, *_: object) -> None:
        self._own.close()
        self._others.close()

    def run(self, scenario: Scenario) -> Result:
        """As `Runner.run`; an FMU that ends its process is a result with an error, too."""
        if not scenario.file.fmus:
            return self._own.run(scenario)
        try:
            return self._others(scenario)
        except Ended as error:
            names = ", ".join(f"{unit.name} ({unit.path})" for unit in scenario.file.fmus)
            return Result(scenario, {}, error=f"{error}; beside ours it had {names}")


@contextmanager
def _runner() -> Iterator[Callable[[Scenario], Result]]:
    with Runner() as runner:
        yield runner.run
