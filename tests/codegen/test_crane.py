"""The generated kernels are what the generator writes now."""

from __future__ import annotations

import pytest

from segfmu.codegen import crane, hook, partials, rope, series
from tests.codegen.generated import generated


@pytest.mark.parametrize("module", [crane, hook, partials, series, rope])
def test_generated_kernels_are_up_to_date(module) -> None:
    name = module.__name__.rpartition(".")[2]
    assert module.TARGET.read_text(encoding="utf-8") == generated(name, module.generate)
