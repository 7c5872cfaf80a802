from __future__ import annotations

import pytest

from tests.compiler import require_cc
from tests.kernels.planner.c_planner import Planner


@pytest.fixture(scope="session")
def planner(tmp_path_factory: pytest.TempPathFactory) -> Planner:
    """The C entry points."""
    require_cc()
    return Planner(tmp_path_factory.mktemp("planner"))
