"""The generated kernels are what the generator writes now."""

from __future__ import annotations

import pytest

from segfmu.codegen import crane, hook, partials, rope, series
from tests.codegen.generated import generated, needed


@pytest.mark.parametrize("module", [crane, hook, partials, series, rope])
def test_generated_kernels_are_up_to_date(module) -> None:
    name = module.__name__.rpartition(".")[2]
    found = generated(name, module.generate, needed(module.__name__))
    assert module.TARGET.read_text(encoding="utf-8") == found


def test_what_a_generator_reads_is_known() -> None:
    """They read no file beside the modules that they import."""
    names = {path.name for path in needed(hook.__name__)}
    assert {"hook.py", "crane.py", "lagrangian.py"} <= names
    for module in (crane, hook, partials, series, rope):
        files = needed(module.__name__)
        assert 2 < len(files) < 20
        for path in files:
            text = path.read_text(encoding="utf-8")
            assert "read_text" not in text and "open(" not in text, path
