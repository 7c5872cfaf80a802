"""The C compiler of the tests, and the one reason to skip where there is none."""

from __future__ import annotations

import shutil
import subprocess
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from types import ModuleType

import pytest

from segfmu.codegen.native import TARGET
from segfmu.cosim import native
from segfmu.fmu import pairs
from segfmu.fmu.native import binaries, compilers
from segfmu.fmu.native.compilers import available
from segfmu.kernels import backend
from tests import made

CC = next(filter(None, map(shutil.which, ("cc", "gcc", "clang"))), "")
STRICT = (
    "-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-ffp-contract=off",
    "-Wno-unused-variable", "-Wno-unused-but-set-variable",
)
# of memory and undefined behaviour
SANITIZERS = ("-fsanitize=address,undefined,float-cast-overflow", "-fno-sanitize-recover=all")
NO_CC = "no C compiler found (cc, gcc, clang)"
needs_cc = pytest.mark.skipif(not CC, reason=NO_CC)
needs_native = pytest.mark.skipif(not available(), reason="no C compiler found for native FMUs")

# tests/test_release.py fails where kernels or loop are missing beside a compiler
NO_KERNELS = "the kernels were installed without a C compiler"
needs_kernels = pytest.mark.skipif(not backend.COMPILED, reason=NO_KERNELS)
needs_loop = pytest.mark.skipif(
    not native.COMPILED, reason="the step loop was installed without a C compiler"
)


def require_cc() -> None:
    """Skip a fixture's tests where there is no C compiler."""
    if not CC:
        pytest.skip(NO_CC)


def kernels_object(folder: Path, *options: str) -> Path:
    """The kernels in C, compiled alone, for several programs to be linked with."""
    return compiled(folder / "kernels.o", [*STRICT, *options, "-c", "kernels.c"], TARGET)


def compiled(
    target: Path, words: Sequence[str], folder: Path, compiler: str = CC
) -> Path:
    """What a C compiler makes of sources and objects in a folder, with words that name them."""

    def told() -> dict[str, bytes]:
        own = {"words": " ".join(words).encode(), "compiler": made.compiler(compiler)}
        return own | made.contents(folder)

    def make() -> bytes:
        subprocess.run([compiler, *words, "-o", target.resolve()], cwd=folder, check=True)
        return target.read_bytes()

    target.write_bytes(made.made("Compiled", told, make))
    target.chmod(0o755)
    return target


@contextmanager
def optimised(level: str) -> Iterator[None]:
    """Build FMUs that compile sooner than those of users with -O3.

    -Og, unlike -O0, leaves out kernels that the model does not call.
    """
    with pytest.MonkeyPatch.context() as patch:
        options = tuple(level if option == "-O3" else option for option in compilers.OPTIONS)
        patch.setattr(compilers, "OPTIONS", options)
        yield


def binary(name: str, texts: Mapping[str, bytes], platform: str) -> bytes:
    """Of GantryFeedforward and GantryCrane of FMI 2, what users have.

    All others of this platform, where they do not come with the package, share kernels that are
    compiled once, in a third of the time.
    """
    usual = name in (pairs.GANTRY.feedforward, pairs.GANTRY.crane) and "fmi2.c" in texts
    given = usual or platform != compilers.host() or not CC
    if given or platform in binaries.packaged([(name, texts)]):
        return binaries.binary(name, texts, platform)
    own = compilers.compiler(platform)
    sooner = replace(own.platform, compile=(*own.platform.compile, "-Og"))
    return binaries.binary(name, texts, platform, compiler=replace(own, platform=sooner))


def compiled_kernels() -> ModuleType:
    """The compiled kernels, also where the environment asks for the interpreted ones."""
    found: ModuleType = pytest.importorskip("segfmu.kernels._compiled", reason=NO_KERNELS)
    return found


def require_native() -> None:
    """Skip a fixture's tests where native FMUs cannot be built."""
    if not available():
        pytest.skip("no C compiler found for native FMUs")
