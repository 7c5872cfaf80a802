"""Native FMUs: archives with sources in C99 and binaries, FMI 2.0 or 3.0, both interfaces."""

from __future__ import annotations

import os
import re
import tempfile
import zipfile
from collections.abc import Callable, Iterable, Sequence
from importlib.metadata import version
from importlib.resources import files
from pathlib import Path

from segfmu.errors import BuildError
from segfmu.fmu.models import named
from segfmu.fmu.native import feeds, tables
from segfmu.fmu.native.compilers import (
    PLATFORMS,
    WARNINGS,
    Compiler,
    compiler,
    host,
    universal,
)
from segfmu.fmu.standard import fmi2, fmi3
from segfmu.fmu.standard.documentation import page
from segfmu.fmu.standard.spec import Spec

KERNELS = (
    "kernels.c", "kernels.h", "messages.c", "messages.h", "plan.c", "records.h", "segfmu.h",
    "span.h",
)
GLUE = (
    "arrays.h", "feed.c", "feed.h", "glue.h", "instance.c", "model.h", "say.c", "say.h",
    "simulation.c", "state.c", "values.c",
)
VERSIONS = {
    2: (
        "fmi2.c", "fmi2_run.c", "fmi/fmi2Functions.h", "fmi/fmi2FunctionTypes.h",
        "fmi/fmi2TypesPlatform.h",
    ),
    3: (
        "fmi3.c", "fmi3_run.c", "fmi3_step.c", "fmi3_values.c", "fmi/fmi3Functions.h",
        "fmi/fmi3FunctionTypes.h", "fmi/fmi3PlatformTypes.h",
    ),
}
LICENCE = files("segfmu.fmu.standard").joinpath("license.txt")
DARWIN = ("x86_64-darwin", "aarch64-darwin")
# of every entry of an archive, so that equal content gives equal bytes
DATE = (*(int(fmi2.GENERATED[i:j]) for i, j in ((0, 4), (5, 7), (8, 10))), 0, 0, 0)


class Objects:
    """The kernels, compiled once a platform for all archives of a build."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._made: dict[str, list[Path]] = {}

    def kernels(self, chosen: Compiler) -> list[Path]:
        """Object files of the kernels for a platform."""
        name = chosen.platform.name
        if name not in self._made:
            folder = self._folder / name
            folder.mkdir()
            texts = _packaged("segfmu.kernels", KERNELS)
            _write(folder, texts)
            # Pyccel declares variables that it does not use
            self._made[name] = _compiled(chosen, folder, texts, ("-w",))
        return self._made[name]


def build_all(
    specs: Sequence[Spec], folder: Path, *, fmi: int = 2, platforms: Sequence[str] = (),
    report: Callable[[str], None] = lambda _: None,
) -> list[Path]:
    """Build archives into a folder, for the host's platform where none is given.

    Raises
    ------
    BuildError
        When the folder cannot be written, and where a compiler is missing or fails.
    """
    chosen = [compiler(name) for name in platforms or [host() or "this platform"]]
    built = []
    try:
        folder.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(prefix="segfmu_", dir=folder) as work:
            objects = Objects(Path(work))
            for spec in specs:
                report(f"building {spec.name}.fmu")
                built.append(_build(spec, folder, fmi, chosen, objects, Path(work)))
    except OSError as error:
        raise BuildError(f"{folder}: cannot be written: {error.strerror}") from error
    return built


def sources(spec: Spec, fmi: int) -> dict[str, bytes]:
    """All sources of an FMU by their names in the archive, which has them in one folder."""
    found = _packaged("segfmu.kernels", KERNELS)
    found |= _packaged("segfmu.fmu.native", (*GLUE, *VERSIONS[fmi]))
    model = named(spec.name)
    found |= model.sources
    found["variables.h"] = tables.header(spec, fmi).encode()
    found["feeds.h"] = feeds.header(model.records).encode()
    found["feeds.c"] = feeds.source(spec, model.records).encode()
    # start values are no part of the layout: gains are computed, and differ in their last digits
    found["build.h"] = tables.build(found).encode()
    found["variables.c"] = tables.source(spec, fmi).encode()
    return found


def _packaged(package: str, names: Iterable[str]) -> dict[str, bytes]:
    """Sources of a package by the last part of their names."""
    folder = files(package).joinpath("c")
    return {n.rpartition("/")[2]: folder.joinpath(*n.split("/")).read_bytes() for n in names}


def _write(folder: Path, texts: dict[str, bytes]) -> None:
    for name, text in texts.items():
        (folder / name).write_bytes(text)


def _compiled(
    chosen: Compiler, folder: Path, texts: dict[str, bytes], options: tuple[str, ...]
) -> list[Path]:
    objects = []
    for name in (n for n in texts if n.endswith(".c")):
        objects.append(folder / f"{name}.o")
        chosen.compile(folder / name, objects[-1], options)
    return objects


def _build(
    spec: Spec, folder: Path, fmi: int, chosen: list[Compiler], objects: Objects, work: Path
) -> Path:
    texts = sources(spec, fmi)
    entries = _described(spec, fmi, texts)
    entries |= {f"sources/{n}": t for n, t in texts.items()}
    for one in chosen:
        place = work / f"{spec.name}-{fmi}-{one.platform.name}"
        place.mkdir()
        library = place / f"{spec.name}{one.platform.suffix}"
        # the standard's headers have declarations of old form, so they count as the system's
        standard = {n: t for n, t in texts.items() if re.match(r"fmi\d.*\.h", n)}
        own = {n: t for n, t in texts.items() if n not in standard}
        (place / "standard").mkdir()
        _write(place / "standard", standard)
        _write(place, own)
        units = {n: t for n, t in own.items() if n not in KERNELS}
        made = _compiled(one, place, units, (*WARNINGS, "-isystem", str(place / "standard")))
        one.link([*objects.kernels(one), *made], library)
        directory = one.platform.folder if fmi == 2 else one.platform.name
        entries[f"binaries/{directory}/{library.name}"] = library.read_bytes()
    if fmi == 2:
        _join_darwin(spec.name, entries)
    target, complete = folder / f"{spec.name}.fmu", work / f"{spec.name}.zip"
    _pack(entries, complete)
    os.replace(complete, target)
    return target


def _join_darwin(name: str, entries: dict[str, bytes]) -> None:
    """FMI 2.0 has one folder for macOS: where both processors are built, it gets both."""
    both = [f"binaries/{PLATFORMS[p].folder}/{name}.dylib" for p in DARWIN]
    if all(path in entries for path in both):
        slices = dict(zip(DARWIN, (entries.pop(path) for path in both), strict=True))
        entries[both[0]] = universal(slices)


def _described(spec: Spec, fmi: int, texts: dict[str, bytes]) -> dict[str, bytes]:
    """All entries of an archive but sources and binaries."""
    release = version("segfmu")
    units = tuple(sorted(n for n in texts if n.endswith(".c")))
    model = named(spec.name)
    entries = {
        "documentation/index.html": page(spec, release, model.about).encode(),
        "documentation/licenses/license.txt": LICENCE.read_bytes(),
    }
    if fmi == 2:
        entries["modelDescription.xml"] = fmi2.model_description(spec, release, units)
        entries["model.png"] = model.icon
    else:
        entries["modelDescription.xml"] = fmi3.model_description(spec, release)
        entries["sources/buildDescription.xml"] = fmi3.build_description(spec, units)
        entries["terminalsAndIcons/terminalsAndIcons.xml"] = fmi3.terminals(spec)
        entries["terminalsAndIcons/icon.png"] = model.icon
    return entries


def _pack(entries: dict[str, bytes], target: Path) -> None:
    with zipfile.ZipFile(target, "w", zipfile.ZIP_DEFLATED) as archive:
        for name in sorted(entries):
            info = zipfile.ZipInfo(name, DATE)  # type: ignore[arg-type]
            info.compress_type = zipfile.ZIP_DEFLATED
            info.external_attr = (0o755 if name.startswith("binaries/") else 0o644) << 16
            archive.writestr(info, entries[name])
