"""The compiled kernels: optional, as the interpreted ones give the same numbers."""

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

SOURCES = "src/segfmu/kernels/c"


class BuildKernels(build_ext):
    """Options by kind of compiler; contraction is off so that every platform computes alike."""

    def build_extension(self, ext: Extension) -> None:
        msvc = self.compiler.compiler_type == "msvc"
        ext.extra_compile_args = (
            ["/O2", "/fp:precise"] if msvc else ["-std=c99", "-O3", "-ffp-contract=off", "-w"]
        )
        super().build_extension(ext)


setup(
    ext_modules=[
        Extension(
            "segfmu.kernels._compiled",
            sources=[f"{SOURCES}/module.c", f"{SOURCES}/kernels.c"],
            depends=[f"{SOURCES}/{name}.h" for name in ("arguments", "kernels", "span")],
            optional=True,
        )
    ],
    cmdclass={"build_ext": BuildKernels},
)
