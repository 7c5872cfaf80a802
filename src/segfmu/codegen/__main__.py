"""Write every generated file again: `python -m segfmu.codegen`."""

from __future__ import annotations

from segfmu.codegen import (
    crane,
    drawing,
    extension,
    hook,
    messages,
    native,
    partials,
    records,
    rope,
    series,
    stubs,
)
from segfmu.codegen.files import write


def main() -> None:
    """Write the crane's equations first, because the C kernels contain them."""
    for source in (crane, hook, partials, series, rope):
        write(source.TARGET, source.generate())
    for name, text in (native.generate() | extension.generate() | messages.generate()).items():
        write(native.TARGET / name, text)
    write(stubs.TARGET, stubs.generate())
    for target, text in records.generate().items():
        write(target, text)
    for target in drawing.TARGETS:
        write(target, drawing.generate())


if __name__ == "__main__":
    main()
