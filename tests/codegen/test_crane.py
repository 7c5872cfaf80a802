"""The generated kernels are what the generator writes now."""

from __future__ import annotations

from segfmu.codegen.crane import TARGET, generate


def test_generated_crane_is_up_to_date() -> None:
    assert TARGET.read_text(encoding="utf-8") == generate()
