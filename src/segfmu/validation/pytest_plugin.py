"""A fixture of pytest that runs scenario files.

    pytest_plugins = ["segfmu.validation.pytest_plugin"]    # in conftest.py

    def test_gust(run_scenario):
        run_scenario("gust.toml").require()

It is no entry point: those would load segfmu in every run of pytest in its environment.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from segfmu.validation.files.scenario_file import load_scenario
from segfmu.validation.scenario_result import Result
from segfmu.validation.suite_runs import Runs


@pytest.fixture(scope="session")
def scenario_runner() -> Iterator[Runs]:
    """Builds FMUs once in a session."""
    with Runs() as runs:
        yield runs


@pytest.fixture
def run_scenario(
    scenario_runner: Runs, request: pytest.FixtureRequest
) -> Callable[[str | Path], Result]:
    """Runs a scenario file, whose name is relative to the file of the test."""
    return lambda path: scenario_runner.run(load_scenario(request.path.parent / path))
