"""The compiler of WebAssembly, and the one reason to skip where there is none."""

from __future__ import annotations

from importlib.util import find_spec

import pytest

needs_wasm = pytest.mark.skipif(
    find_spec("ziglang") is None,
    reason="no compiler for WebAssembly: pip install segfmu[platforms]",
)
