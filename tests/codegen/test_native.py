"""The committed C is what the generator writes now, and says what it was made from."""

from __future__ import annotations

import json
import re
from pathlib import Path

from segfmu.codegen import extension, native, stubs
from segfmu.codegen.amalgam import KERNELS
from segfmu.codegen.functions import functions
from tests.codegen.generated import generated, needed
from tests.compiler import STRICT


def test_generated_c_is_up_to_date() -> None:
    files = {*needed(native.__name__), *KERNELS.rglob("*.py")}
    texts = json.loads(generated("C", lambda: json.dumps(native.generate()), sorted(files)))
    for name, text in (texts | extension.generate()).items():
        assert (native.TARGET / name).read_text(encoding="utf-8") == text, name


def test_generated_stub_is_up_to_date() -> None:
    assert stubs.TARGET.read_text(encoding="utf-8") == stubs.generate()


def test_entry_points_alone_are_visible() -> None:
    header = (native.TARGET / "kernels.h").read_text(encoding="utf-8")
    for name in native.ENTRY_POINTS:
        assert f" {native.PREFIX}{name}(" in header
    assert header.count(native.PREFIX) == len(native.ENTRY_POINTS)


def test_models_name_no_function_as_a_kernel() -> None:
    """They are one translation unit in an archive."""
    definition = re.compile(r"^(?:static )?\w+ \*?(\w+)\([^;]*$", re.MULTILINE)
    kernels = set(definition.findall((native.TARGET / "kernels.c").read_text(encoding="utf-8")))
    folder = native.TARGET.parents[1] / "fmu"
    files = [*folder.rglob("*.c"), native.TARGET / "plan.c"]
    assert len(kernels) > 200 and len(files) > 10
    for file in files:
        clash = kernels & set(definition.findall(file.read_text(encoding="utf-8")))
        assert not clash, f"{file.name}: {', '.join(clash)}"


def test_what_a_kernel_writes_to_is_known() -> None:
    kernels = {f.name: f for f in functions()}
    assert kernels["evaluate"].written == {"values"}
    assert kernels["crane_rhs"].written == {"derivative"}
    # limits of the other direction are exchanged for a while
    assert kernels["shortest_profile"].written == {"axis", "phases", "work"}
    # through a view of its row
    assert kernels["set_problems"].written == {"cells"}
    # through a view of a view
    assert "cells" in kernels["expand_plan"].written


def test_c_compiles_without_warning_but_for_unused_variables(kernels_in_c: Path) -> None:
    """They are errors to the compiler, with which all tests that link the kernels compile them."""
    assert {"-Wall", "-Wextra", "-Wpedantic", "-Werror"} <= set(STRICT)
    assert kernels_in_c.is_file()
