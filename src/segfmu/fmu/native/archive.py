"""Native FMUs: archives with sources in C99 and binaries, FMI 2.0 or 3.0, both interfaces."""

from __future__ import annotations

import zipfile
from collections.abc import Callable, Iterable, Sequence
from functools import cache
from importlib.metadata import version
from importlib.resources import files
from pathlib import Path

from segfmu.fmu.models import named
from segfmu.fmu.native import feeds, start, tables
from segfmu.fmu.native.binaries import APART, CORE, SHARED, UNIT, binary
from segfmu.fmu.native.compilers import PLATFORMS, host, universal
from segfmu.fmu.native.processes import on_all_cores
from segfmu.fmu.placing import placing
from segfmu.fmu.sources import sources_of
from segfmu.fmu.standard import fmi2, fmi3
from segfmu.fmu.standard.documentation import page
from segfmu.fmu.standard.spec import Spec

KERNELS = tuple(name for name in SHARED if name not in (CORE, "oldest.h"))
GLUE = (
    "checksum.h", "feed.c", "feed.h", "glue.h", "instance.c", "model.h", "oldest.h", "say.c",
    "say.h", "simulation.c", "start.c", "start.h", "state.c", "values.c",
)
VERSIONS = {
    2: (
        "fmi2.c", "fmi2.h", "fmi2_run.c", "fmi/fmi2Functions.h", "fmi/fmi2FunctionTypes.h",
        "fmi/fmi2TypesPlatform.h",
    ),
    3: (
        "fmi3.c", "fmi3.h", "fmi3_run.c", "fmi3_step.c", "fmi3_values.c", "fmi/fmi3Functions.h",
        "fmi/fmi3FunctionTypes.h", "fmi/fmi3PlatformTypes.h",
    ),
}
LICENCE = files("segfmu.fmu.standard").joinpath("license.txt")
DARWIN = ("x86_64-darwin", "aarch64-darwin")
# date of every entry of an archive, so that equal content gives equal bytes
DATE = (*(int(fmi2.GENERATED[i:j]) for i, j in ((0, 4), (5, 7), (8, 10))), 0, 0, 0)


def build_all(
    specs: Sequence[Spec], folder: Path, *, fmi: int = 2, platforms: Sequence[str] = (),
    report: Callable[[str], None] = lambda _: None, whole: bool = True,
) -> list[Path]:
    """Build archives into a folder, by default for the host's platform; they appear together.

    Without `whole` they have what a run needs alone, and are not compressed: in a third of the
    time, for this process.

    Raises
    ------
    BuildError
        When one of them cannot be written, and where a compiler is missing or fails.
    """
    names = tuple(platforms) or (host() or "this platform",)
    built = [folder / f"{spec.name}.fmu" for spec in specs]
    with placing(built) as work:
        for target in built:
            report(f"building {target.name}")
        chosen = entries if whole else running
        contents = on_all_cores(lambda spec: chosen(spec, fmi, names), specs)
        for content, target in zip(contents, built, strict=True):
            pack(content, work / target.name, zipfile.ZIP_DEFLATED if whole else zipfile.ZIP_STORED)
    return built


@cache
def sources(name: str, fmi: int) -> dict[str, bytes]:
    """All sources of a model by their names in the archive, which has them in one folder.

    They follow from the model alone. `binaries.UNIT` includes the others; an importer compiles it
    alone, and binaries of this package link it with the kernels.
    """
    model = named(name)
    spec = model.largest()
    found = _packaged("segfmu.kernels", KERNELS)
    found |= _packaged("segfmu.fmu.native", (*GLUE, *VERSIONS[fmi]))
    found |= model.sources
    found["variables.h"] = tables.header(spec, fmi).encode()
    found["variables.c"] = tables.source(spec, fmi).encode()
    if model.records:
        found["feeds.h"] = feeds.header(model.records).encode()
        found["feeds.c"] = feeds.source(spec, model.records).encode()
    found[CORE] = _core().encode()
    found[UNIT] = _unit(found).encode()
    found["build.h"] = tables.build(tables.mark(found)).encode()
    return found


def _core() -> str:
    """The text that has all kernels: equal in all models and versions."""
    return (
        f"{tables.BANNER}/* The kernels: {UNIT} includes them, or is linked with them where "
        f"{APART} is defined. */\n#include \"oldest.h\"\n\n"
        + "".join(f'#include "{name}"\n' for name in KERNELS if name.endswith(".c"))
    )


def _unit(texts: Iterable[str]) -> str:
    """The text of the one translation unit: what its sources share is visible nowhere else."""
    shared = (*(n for n in SHARED if n.endswith(".c")), "variables.c", "feed.c")
    own = "".join(
        f'#include "{n}"\n' for n in sorted(texts) if n.endswith(".c") and n not in shared
    )
    return (
        f"{tables.BANNER}/* Compile this file alone: it includes all others. Nothing but the "
        "functions of FMI is visible\n   outside; FMI2_FUNCTION_PREFIX, FMI3_FUNCTION_PREFIX go "
        "before their names. */\n"
        "/* no model calls all of these */\n#if defined(__GNUC__)\n#pragma GCC diagnostic push\n"
        '#pragma GCC diagnostic ignored "-Wunused-function"\n#endif\n'
        f'#ifdef {APART}\n#include "oldest.h"\n'
        f'#else\n#define SEGFMU_API static\n#include "{CORE}"\n#endif\n'
        '#include "variables.c"\n#include "feed.c"\n'
        f"#if defined(__GNUC__)\n#pragma GCC diagnostic pop\n#endif\n\n{own}"
    )


def _packaged(package: str, names: Iterable[str]) -> dict[str, bytes]:
    """Sources of a package by the last part of their names."""
    texts = sources_of(package)
    return {n.rpartition("/")[2]: texts[n] for n in names}


def entries(spec: Spec, fmi: int, platforms: Sequence[str]) -> dict[str, bytes]:
    """All entries of an archive."""
    found = running(spec, fmi, platforms) | _described(spec, fmi)
    return found | {f"sources/{n}": t for n, t in sources(spec.name, fmi).items()}


def running(spec: Spec, fmi: int, platforms: Sequence[str]) -> dict[str, bytes]:
    """The entries that a run needs: description, start values and binaries."""
    texts = sources(spec.name, fmi)
    found = {"resources/start.bin": start_values(spec, fmi)}
    release = version("segfmu")
    if fmi == 2:
        found["modelDescription.xml"] = fmi2.model_description(spec, release, (UNIT,))
    else:
        found["modelDescription.xml"] = fmi3.model_description(spec, release)
    for name in platforms:
        library = binary(spec.name, texts, name)
        platform = PLATFORMS[name]
        directory = platform.folder if fmi == 2 else platform.name
        found[f"binaries/{directory}/{spec.name}{platform.suffix}"] = library
    if fmi == 2:
        _join_darwin(spec.name, found)
    return found


def start_values(spec: Spec, fmi: int) -> bytes:
    """The file start.bin that a binary of this model's sources reads."""
    texts = sources(spec.name, fmi)
    mark = tables.mark({n: t for n, t in texts.items() if n != "build.h"})
    return start.content(spec, named(spec.name).largest(), fmi, mark)


def _join_darwin(name: str, entries: dict[str, bytes]) -> None:
    """FMI 2.0 has one folder for macOS: where both processors are built, it gets both."""
    both = [f"binaries/{PLATFORMS[p].folder}/{name}.dylib" for p in DARWIN]
    if all(path in entries for path in both):
        slices = dict(zip(DARWIN, (entries.pop(path) for path in both), strict=True))
        entries[both[0]] = universal(slices)


def _described(spec: Spec, fmi: int) -> dict[str, bytes]:
    """What an archive tells of itself, and no run needs."""
    release = version("segfmu")
    model = named(spec.name)
    entries = {
        "documentation/index.html": page(spec, release, model.about).encode(),
        "documentation/licenses/license.txt": LICENCE.read_bytes(),
    }
    if fmi == 2:
        entries["model.png"] = model.icon
    else:
        entries["sources/buildDescription.xml"] = fmi3.build_description(spec, (UNIT,))
        entries["terminalsAndIcons/terminalsAndIcons.xml"] = fmi3.terminals(spec)
        entries["terminalsAndIcons/icon.png"] = model.icon
    return entries


def pack(
    entries: dict[str, bytes], target: Path, compression: int = zipfile.ZIP_DEFLATED
) -> None:
    """Write a zip archive; equal entries give equal bytes."""
    with zipfile.ZipFile(target, "w", compression) as archive:
        for name in sorted(entries):
            info = zipfile.ZipInfo(name, DATE)  # type: ignore[arg-type]
            info.compress_type = compression
            info.external_attr = (0o755 if name.startswith("binaries/") else 0o644) << 16
            archive.writestr(info, entries[name])
