"""The generated kernels are what the generator writes now."""

from __future__ import annotations

import pytest

from segfmu.codegen import crane, hook, partials, rope, series
from tests.campaign import soaked


@pytest.mark.parametrize("module", [series, rope, *soaked(crane, hook, partials)])
def test_generated_kernels_are_up_to_date(module) -> None:
    """Those of seconds are generated in a soak; until then test_origin.py tells what changed."""
    assert module.TARGET.read_text(encoding="utf-8") == module.generate()
