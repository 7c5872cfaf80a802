"""The importers of others that the tests run in."""

from __future__ import annotations

import ctypes
import platform
import sys
from importlib.util import find_spec
from pathlib import Path

import pytest


def require(package: str) -> None:
    """Skip where a package has no wheels; where it has some, its absence is a failure."""
    if find_spec(package) is not None:
        return
    wheels = sys.platform == "linux" and platform.machine() == "x86_64"
    assert not wheels, f"{package} is missing; install the extra dev"
    pytest.skip(f"{package} has wheels for 64-bit Linux on x86 only")


def threads() -> Path:
    """The library that Ecos needs; the package tbb puts it where no linker looks."""
    return Path(sys.prefix) / "lib" / "libtbb.so.12"


def load_threads() -> None:
    """Load it for Ecos."""
    ctypes.CDLL(str(threads()), mode=ctypes.RTLD_GLOBAL)
