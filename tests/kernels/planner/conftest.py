from __future__ import annotations

import pytest

from tests.compiler import require_cc
from tests.kernels.planner.c_planner import Planner
from tests.sharing import shared


@pytest.fixture(scope="session")
def planner(tmp_path_factory: pytest.TempPathFactory) -> Planner:
    """The C entry points."""
    require_cc()
    return Planner(shared(tmp_path_factory, "planner", Planner))
