"""Build FMUs with the chosen backend, and files for other tools."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path

from segfmu.fmu.choice import Choice
from segfmu.fmu.models import named, registered
from segfmu.fmu.standard.spec import Spec, connected, numbered


def build_all(
    folder: Path, choice: Choice, specs: Sequence[Spec] | None = None, *,
    report: Callable[[str], None] = lambda _: None, whole: bool = True,
) -> list[Path]:
    """Build FMUs of `specs`, or of all models, into a folder; `report` gets a line before each.

    Native ones that are not `whole` have what a run needs alone.

    Raises
    ------
    BuildError
        When the folder cannot be written, and where a compiler or a backend is missing or fails.
    """
    interfaces = specs or [m.spec() for m in registered()]
    if choice.native:
        from segfmu.fmu.native.archive import build_all as build_native

        natives = [_typed(named(s.name).native_spec(s), choice) for s in interfaces]
        return build_native(
            natives, folder, fmi=choice.fmi, platforms=choice.platforms, report=report, whole=whole
        )
    from segfmu.fmu.python.archive import build_all as build_python

    return build_python(folder, report, [_typed(s, choice) for s in interfaces])


def describe(
    folder: Path, archives: Sequence[Path], specs: Sequence[Spec] | None, title: str = "", *,
    fmi: int = 2, modelica: bool = False, ssp: bool = False,
) -> list[Path]:
    """Write the files with which other tools load both native FMUs as one system.

    `specs` are interfaces with a mission's start values, `title` is its name, `fmi` the archives'
    version of FMI.

    Raises
    ------
    BuildError
        When the folder cannot be written.
    """
    written = []
    if modelica:
        from segfmu.fmu.modelica.package import write_package

        written.append(write_package(folder, specs, archives))
    if ssp:
        from segfmu.fmu.system import write_system

        written += write_system(folder, archives, specs, title, fmi=fmi)
    return written


def left_over(folder: Path, written: Sequence[Path]) -> str:
    """What of a build before lies beside new FMUs, in words; empty if nothing.

    It is not removed: libcosim has one name for the structure of every system.
    """
    from segfmu.fmu.modelica.package import NAME
    from segfmu.fmu.system import PACKAGE, STRUCTURE

    places = (PACKAGE, STRUCTURE, f"{NAME}/package.mo")
    old = [place for place in places if (folder / place).exists() and folder / place not in written]
    if not old:
        return ""
    names, were, are, them = old[0], "was", "is", "it"
    if len(old) > 1:
        names, were, are, them = f"{', '.join(old[:-1])} and {old[-1]}", "were", "are", "them"
    return f"{names} in {folder} {were} there before and {are} not of these FMUs; remove {them}"


def _typed(spec: Spec, choice: Choice) -> Spec:
    spec = connected(spec) if choice.connected else spec
    return numbered(spec) if choice.numbered else spec
