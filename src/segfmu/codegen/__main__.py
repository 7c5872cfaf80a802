"""Write every generated file again: `python -m segfmu.codegen`."""

from __future__ import annotations

from importlib import import_module
from pathlib import Path
from pkgutil import iter_modules

from segfmu.codegen import drawing, extension, messages, native, records, stubs
from segfmu.codegen.amalgam import KERNELS
from segfmu.codegen.files import write


def main() -> None:
    """Write the equations first, because the C kernels contain them."""
    for target, text in equations().items():
        write(target, text)
    for name, text in (native.generate() | extension.generate() | messages.generate()).items():
        write(native.TARGET / name, text)
    write(stubs.TARGET, stubs.generate())
    for target, text in records.generate().items():
        write(target, text)
    for target in drawing.TARGETS:
        write(target, drawing.generate())


def equations() -> dict[Path, str]:
    """Texts of the kernels that are generated: every module here with such a target writes one."""
    names = (found.name for found in iter_modules([str(Path(__file__).parent)]))
    modules = [import_module(f"segfmu.codegen.{n}") for n in names if n != "__main__"]
    return {
        module.TARGET: module.generate() for module in modules
        if getattr(module, "TARGET", Path()).suffix == ".py"
        and KERNELS in module.TARGET.parents
    }


if __name__ == "__main__":
    main()
