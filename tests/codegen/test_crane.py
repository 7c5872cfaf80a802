"""The generated kernels are what the generator writes now."""

from __future__ import annotations

import pytest

from segfmu.codegen import crane, hook, partials, rope, series


@pytest.mark.parametrize("module", [crane, hook, partials, series, rope])
def test_generated_kernels_are_up_to_date(module) -> None:
    assert module.TARGET.read_text(encoding="utf-8") == module.generate()
