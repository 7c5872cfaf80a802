"""Both FMUs, built once for all tests."""

from __future__ import annotations

from pathlib import Path

import pytest

from segfmu.fmu.build import build_all


@pytest.fixture(scope="session")
def fmus(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Path]:
    """Archives of GantryFeedforward and GantryCrane."""
    feedforward, crane = build_all(tmp_path_factory.mktemp("fmus"))
    return feedforward, crane
