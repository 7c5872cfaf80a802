"""Both FMUs, built once for all tests."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import settings

from segfmu.fmu.gantry_crane import interface as gantry_crane
from segfmu.fmu.gantry_feedforward import interface as gantry_feedforward
from segfmu.fmu.native import archive as native
from segfmu.fmu.native.compilers import available
from segfmu.fmu.python.archive import build_all

# The same examples in every run of the whole suite; `--hypothesis-profile=search` looks for more.
settings.register_profile("repeatable", derandomize=True, deadline=None)
settings.register_profile("search", max_examples=2000, deadline=None)
settings.load_profile("repeatable")


@pytest.fixture(scope="session")
def fmus(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Path]:
    """Archives of GantryFeedforward and GantryCrane on the Python backend."""
    specs = (gantry_feedforward.spec(), gantry_crane.spec())
    feedforward, crane = build_all(tmp_path_factory.mktemp("fmus"), specs=specs)
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
