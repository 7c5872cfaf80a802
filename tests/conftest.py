"""Both FMUs, built once for all tests."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import settings

from segfmu.fmu.build import build_all

# The same examples in every run of the whole suite; `--hypothesis-profile=search` looks for more.
settings.register_profile("repeatable", derandomize=True, deadline=None)
settings.register_profile("search", max_examples=2000, deadline=None)
settings.load_profile("repeatable")


@pytest.fixture(scope="session")
def fmus(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Path]:
    """Archives of GantryFeedforward and GantryCrane."""
    feedforward, crane = build_all(tmp_path_factory.mktemp("fmus"))
    return feedforward, crane
