"""The C compiler of the tests, and the one reason to skip where there is none."""

from __future__ import annotations

import shutil

import pytest

from segfmu.fmu.native.compilers import available

CC = next(filter(None, map(shutil.which, ("cc", "gcc", "clang"))), "")
needs_cc = pytest.mark.skipif(not CC, reason="no C compiler found (cc, gcc, clang)")
needs_native = pytest.mark.skipif(not available(), reason="no C compiler found for native FMUs")


def require_native() -> None:
    """Skip a fixture's tests where native FMUs cannot be built."""
    if not available():
        pytest.skip("no C compiler found for native FMUs")
