"""The compiled kernels and step loop: optional, as those in Python give the same numbers."""

import lzma
import sys
import sysconfig
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


class PackKernels(build_py):
    """Wheels have the kernels' source, which FMUs take along, in three quarters of the bytes."""

    def run(self) -> None:
        super().run()
        if not self.editable_mode:
            source = Path(self.build_lib, "segfmu", "kernels", "c", "kernels.c")
            packed = lzma.compress(source.read_bytes(), preset=9)
            source.with_name("kernels.c.xz").write_bytes(packed)
            source.unlink()


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
    cmdclass={"build_ext": BuildKernels, "build_py": PackKernels},
    options={"bdist_wheel": {"py_limited_api": "cp311"}} if STABLE else {},
)
