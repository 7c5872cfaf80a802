"""The compiled kernels and step loop: optional, as those in Python give the same numbers."""

import sys
import sysconfig
import tarfile
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext
from setuptools.command.build_py import build_py

SOURCES = "src/segfmu/kernels/c"
LOOP = "src/segfmu/cosim/c"
# One binary for every Python from 3.11 on. Python without its global lock has no stable ABI yet.
STABLE = sys.implementation.name == "cpython" and not sysconfig.get_config_var("Py_GIL_DISABLED")


class BuildKernels(build_ext):
    """Options by kind of compiler; contraction is off so that every platform computes alike."""

    def build_extension(self, ext: Extension) -> None:
        if self.compiler.compiler_type == "msvc":
            ext.extra_compile_args = ["/O2", "/fp:precise"]
        else:
            # some builds of Python ask for debugging symbols: -g0 overrides
            ext.extra_compile_args = ["-std=c99", "-O3", "-ffp-contract=off", "-w", "-g0"]
            # nothing reads errno or traps, and nothing but the module's initialiser is called
            ext.extra_compile_args += [
                "-fno-math-errno", "-fno-trapping-math", "-fno-tree-vectorize",
                "-fvisibility=hidden",
            ]
            # C has nothing to unwind; some builds of Python ask for guards of the stack
            ext.extra_compile_args += ["-fno-asynchronous-unwind-tables", "-fno-stack-protector"]
            # symbols for the static linker alone are of no use in a module
            ext.extra_link_args = ["-Wl,-x" if sys.platform == "darwin" else "-Wl,-s"]
        super().build_extension(ext)


class PackSources(build_py):
    """Wheels have the sources that FMUs take along in one archive: 0.4 of the bytes.

    `segfmu/fmu/sources.py` reads it. bzip2 does better with such text than LZMA.
    """

    def run(self) -> None:
        super().run()
        if self.editable_mode:
            return
        root = Path(self.build_lib, "segfmu")
        places = sorted(p for p in root.rglob("*.[ch]") if "c" in p.relative_to(root).parts)
        with tarfile.open(root / "fmu" / "sources.tar.bz2", "w:bz2") as archive:
            for place in places:
                entry = tarfile.TarInfo(place.relative_to(root).as_posix())
                entry.size = place.stat().st_size
                with place.open("rb") as content:
                    archive.addfile(entry, content)
                place.unlink()


setup(
    ext_modules=[
        Extension(
            "segfmu.kernels._compiled",
            sources=[f"{SOURCES}/module.c", f"{SOURCES}/kernels.c"],
            depends=[f"{SOURCES}/{name}.h" for name in ("arguments", "kernels", "span")],
            define_macros=[("Py_LIMITED_API", "0x030B0000")] if STABLE else [],
            py_limited_api=STABLE,
            optional=True,
        ),
        Extension(
            "segfmu.cosim._loop",
            sources=[f"{LOOP}/{name}.c" for name in ("module", "loop", "copy", "tape")],
            depends=[f"{LOOP}/loop.h"],
            define_macros=[("Py_LIMITED_API", "0x030B0000")] if STABLE else [],
            py_limited_api=STABLE,
            optional=True,
        ),
    ],
    cmdclass={"build_ext": BuildKernels, "build_py": PackSources},
    options={"bdist_wheel": {"py_limited_api": "cp311"}} if STABLE else {},
)
