"""Processors that this one can stand for, and builds of the kernels by other compilers."""

from __future__ import annotations

import ctypes
import os
import platform
import shutil
import subprocess
import sys
import sysconfig
from collections.abc import Iterator
from dataclasses import dataclass, field
from importlib.util import find_spec
from pathlib import Path

import numpy as np
from numpy._core import _multiarray_umath as numpy_core

from segfmu.codegen.native import TARGET

# kernels of OpenBLAS, the processor's features that they need, as NumPy names them now and before,
# and what OpenBLAS calls them; AMD's take those of Haswell
CORES = {
    "SkylakeX": (("X86_V4", "AVX512_SKX"), "SkylakeX"),
    "Haswell": (("X86_V3", "AVX2"), "Haswell"),
    "Nehalem": (("X86_V2", "SSE42"), "Nehalem"),
    "Prescott": (("SSE3", "X86_V2"), "Katmai"),
}
SIMD, LIBM = "NumPy without vector instructions", "C library without FMA"
X86 = platform.machine().lower() in ("x86_64", "amd64")
# zig adds sanitizers where nothing is optimised; newer compilers refuse undeclared functions
PLAIN = (
    "-std=c99", "-w", "-Werror=implicit-function-declaration", "-fPIC", "-shared",
    "-fno-sanitize=all",
)
OPTIMISED = ("-O0", "-O2", "-O3")
CONTRACTED = ("-ffp-contract=off",), ("-mfma", "-ffp-contract=fast")


@dataclass(frozen=True)
class Variant:
    """One way to compute: environment, or a module of the kernels; else why it is skipped."""

    name: str
    environment: dict[str, str] = field(default_factory=dict)
    kernels: Path | None = None
    skipped: str = ""


def has(*features: str) -> bool:
    """Whether the processor has one of the features, as NumPy names them."""
    return any(numpy_core.__cpu_features__.get(name, False) for name in features)


def blas_core(environment: dict[str, str] | None = None) -> str:
    """The kernels that NumPy's OpenBLAS takes; empty where it has another library."""
    code = "from tests.processors.variants import own_core; print(own_core())"
    done = subprocess.run(
        [sys.executable, "-c", code], env=os.environ | (environment or {}), text=True,
        stdout=subprocess.PIPE, check=True, cwd=Path(__file__).parents[2],
    )
    return done.stdout.strip()


def own_core() -> str:
    """`blas_core` of this process."""
    folder = Path(np.__file__).parent.with_name("numpy.libs")
    for file in sorted(folder.glob("*openblas*")) if folder.is_dir() else ():
        library = ctypes.CDLL(str(file))
        for name in ("scipy_openblas_get_corename64_", "openblas_get_corename64_"):
            if hasattr(library, name):
                called = getattr(library, name)
                called.restype = ctypes.c_char_p
                return bytes(called()).decode()
    return ""


def processors() -> Iterator[Variant]:
    """Linear algebra, NumPy and the C library as for other processors."""
    known = bool(blas_core()) and X86
    for core, (needed, name) in CORES.items():
        environment = {"OPENBLAS_CORETYPE": core}
        skipped = "" if known else "NumPy has no OpenBLAS for Intel and AMD"
        if known and not has(*needed):
            skipped = f"the processor lacks {needed[0]}"
        elif known and (taken := blas_core(environment)) != name:
            skipped = f"OpenBLAS takes {taken} instead"
        yield Variant(f"OPENBLAS_CORETYPE={core}", environment, skipped=skipped)
    found = [name for name in numpy_core.__cpu_dispatch__ if has(name)]
    yield Variant(
        SIMD, {"NPY_DISABLE_CPU_FEATURES": " ".join(found)},
        skipped="" if found else "NumPy has none here",
    )
    glibc = platform.libc_ver()[0] == "glibc" and X86
    yield Variant(
        LIBM, {"GLIBC_TUNABLES": "glibc.cpu.hwcaps=-AVX2,-FMA,-FMA4"},
        skipped="" if glibc else "no glibc for Intel and AMD",
    )


def compilers() -> Iterator[tuple[str, list[str], str]]:
    """Name, command, and why it is skipped."""
    for name in ("gcc", "clang"):
        path = shutil.which(name)
        yield name, [path or name], "" if path else "not installed"
    zig = find_spec("ziglang") is not None
    yield "zig", [sys.executable, "-m", "ziglang", "cc"], "" if zig else "not installed"


def builds(
    folder: Path, names: tuple[str, ...] = (), optimised: tuple[str, ...] = OPTIMISED
) -> Iterator[Variant]:
    """The kernels of all compilers, or those named, at every optimisation, without and with FMA."""
    for name, command, skipped in compilers():
        if names and name not in names:
            continue
        for options in ((level, *flags) for level in optimised for flags in CONTRACTED):
            title = " ".join((name, *options))
            reason = skipped
            if "-mfma" in options and not (X86 and has("FMA3")):
                reason = reason or "the processor has no FMA, or not that of Intel and AMD"
            if reason:
                yield Variant(title, skipped=reason)
                continue
            target = folder / (title.replace(" ", "").replace("=", "") + ".so")
            compiled(command, options, target)
            yield Variant(title, kernels=target)


def compiled(command: list[str], options: tuple[str, ...], target: Path) -> None:
    """Compile the kernels to a module of Python."""
    include = sysconfig.get_path("include")
    sources = [str(TARGET / name) for name in ("module.c", "kernels.c")]
    undefined = ("-undefined", "dynamic_lookup") if sys.platform == "darwin" else ()
    subprocess.run(
        [*command, *PLAIN, *options, f"-I{include}", "-DPy_LIMITED_API=0x030B0000", *sources,
         *undefined, "-lm", "-o", str(target)],
        check=True,
    )
