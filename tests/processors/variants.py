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
from tests import made

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
# as setup.py does
LIMITED = () if sysconfig.get_config_var("Py_GIL_DISABLED") else ("-DPy_LIMITED_API=0x030B0000",)
UNDEFINED = ("-undefined", "dynamic_lookup") if sys.platform == "darwin" else ()
COMPILERS = ("gcc", "clang", "zig")
OPTIMISED = ("-O0", "-O2", "-O3")
# products and sums rounded once
FUSED = ("-mfma", "-ffp-contract=fast")
CONTRACTED = ("-ffp-contract=off",), FUSED


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


def builds(folder: Path) -> Iterator[Variant]:
    """The kernels by all compilers, at every optimisation, without and with FMA."""
    for compiler in COMPILERS:
        for level in OPTIMISED:
            for flags in CONTRACTED:
                yield build(folder, compiler, level, *flags)


def build(folder: Path, compiler: str, *options: str) -> Variant:
    """The kernels by a compiler with options, as a module of Python."""
    title = " ".join((compiler, *options))
    command = _command(compiler)
    if not command:
        return Variant(title, skipped="not installed")
    if FUSED[0] in options and not (X86 and has("FMA3")):
        return Variant(title, skipped="the processor has no FMA, or not that of Intel and AMD")
    target = folder / (title.replace(" ", "").replace("=", "") + ".so")
    words = [*PLAIN, *LIMITED, *options, f"-I{sysconfig.get_path('include')}", "module.c",
             "kernels.c", *UNDEFINED, "-lm"]

    def told() -> dict[str, bytes]:
        own = {"words": " ".join(words).encode(), "python": made.interpreter()}
        # that of zig is a package
        own["compiler"] = b"zig" if compiler == "zig" else made.compiler(command[0])
        return own | made.contents(TARGET)

    def make() -> bytes:
        subprocess.run([*command, *words, "-o", str(target.resolve())], cwd=TARGET, check=True)
        return target.read_bytes()

    target.write_bytes(made.made("Module", told, make))
    return Variant(title, kernels=target)


def _command(compiler: str) -> list[str]:
    """How to call a compiler; empty where it is not installed."""
    if compiler == "zig":
        found = find_spec("ziglang") is not None
        return [sys.executable, "-m", "ziglang", "cc"] if found else []
    path = shutil.which(compiler)
    return [path] if path else []
