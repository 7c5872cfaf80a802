"""Both FMUs, built once for all tests."""

from __future__ import annotations

import os
import sys
from pathlib import Path

import pytest
from hypothesis import settings

from segfmu.fmu import gantry_crane, gantry_feedforward, native
from segfmu.fmu.build import build_all
from segfmu.fmu.compilers import available

# The same examples in every run of the whole suite; `--hypothesis-profile=search` looks for more.
settings.register_profile("repeatable", derandomize=True, deadline=None)
settings.register_profile("search", max_examples=2000, deadline=None)
settings.load_profile("repeatable")


# set by the first test that loads FMUs of the Python backend
PYTHON_FMUS = pytest.StashKey[bool]()
STATUS = pytest.StashKey[int]()


def pytest_sessionfinish(session: pytest.Session, exitstatus: int) -> None:
    """Keep the result of the tests for `pytest_unconfigure`."""
    session.config.stash[STATUS] = int(exitstatus)


@pytest.hookimpl(trylast=True)
def pytest_unconfigure(config: pytest.Config) -> None:
    """End the process without destructors where PythonFMU was loaded.

    PythonFMU 0.7 reads freed memory in its library's destructor, after Python has ended, and now
    and then the process aborts there. What the tests found is settled and printed by then.
    """
    if config.stash.get(PYTHON_FMUS, False):
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(config.stash[STATUS])


@pytest.fixture(scope="session")
def fmus(
    tmp_path_factory: pytest.TempPathFactory, pytestconfig: pytest.Config
) -> tuple[Path, Path]:
    """Archives of GantryFeedforward and GantryCrane on the Python backend."""
    pytestconfig.stash[PYTHON_FMUS] = True
    feedforward, crane = build_all(tmp_path_factory.mktemp("fmus"))
    return feedforward, crane


@pytest.fixture(scope="session")
def native_fmus(tmp_path_factory: pytest.TempPathFactory) -> dict[int, tuple[Path, Path]]:
    """Native archives of GantryFeedforward and GantryCrane, by version of FMI."""
    if not available():
        pytest.skip("native FMUs need a C compiler; none was found")
    specs = (gantry_feedforward.native_spec(), gantry_crane.native_spec())
    built = {}
    for fmi in (2, 3):
        feedforward, crane = native.build_all(
            specs, tmp_path_factory.mktemp(f"native{fmi}"), fmi=fmi
        )
        built[fmi] = (feedforward, crane)
    return built
