"""What tests of scenarios share."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from segfmu.validation.suite import Runner
from tests.compiler import require_native


@pytest.fixture(scope="module")
def runner() -> Iterator[Runner]:
    """Runs scenarios with the native FMUs, which it keeps loaded."""
    require_native()
    with Runner() as runner:
        yield runner
