"""Compile the binaries that a released wheel carries: `python -m segfmu.fmu.native.prebuild`.

They lie in `binaries/` beside this file, an archive a processor, for every platform with every
model and version of FMI; for pages with FMI 2 alone, of the models that run there. A build takes
them where its sources are theirs, and then needs no compiler.
"""

from __future__ import annotations

import os
from lzma import LZMAError
from pathlib import Path
from tarfile import TarError

from segfmu.fmu.models import registered
from segfmu.fmu.native.archive import VERSIONS, sources
from segfmu.fmu.native.binaries import archive_name, binary, packaged_name
from segfmu.fmu.native.compilers import BROWSER, TARGETS, portable
from segfmu.fmu.native.packed import pack, unpack
from segfmu.fmu.native.processes import on_all_cores
from segfmu.fmu.pairs import PAIRS

# models that run in pages
PAGE = ("GantryFeedforward", "GantryCrane")
TARGET = Path(__file__).with_name("binaries")
# Their first library waits for zig to compile the C library; others compile meanwhile.
SLOWEST = ("x86_64-windows", BROWSER.name)
# a library: its platform, model and version of FMI
Job = tuple[str, str, int]


def main() -> None:
    """Write the archive of every processor; what the user's cache has is not compiled again."""
    TARGET.mkdir(exist_ok=True)
    ordered = jobs()
    made: dict[str, dict[str, bytes]] = {archive_name(platform): {} for platform in TARGETS}
    for (platform, *_), (name, library) in zip(
        ordered, on_all_cores(_library, ordered), strict=True
    ):
        made[archive_name(platform)][name] = library
    for other in TARGET.iterdir():
        if other.name not in made:
            other.unlink()
    for told in on_all_cores(lambda archive: _write(archive, made[archive]), list(made)):
        print(told, flush=True)


def jobs() -> list[Job]:
    """All libraries: planners, which take longest, before cranes, and platforms in turns."""
    planners = {pair.feedforward for pair in PAIRS}
    models = sorted((m.name for m in registered()), key=lambda name: name not in planners)
    platforms = sorted(TARGETS, key=lambda p: SLOWEST.index(p) if p in SLOWEST else len(SLOWEST))
    return [
        (platform, name, fmi)
        for name in models for fmi in VERSIONS for platform in platforms
        if platform != BROWSER.name or (fmi == 2 and name in PAGE)
    ]


def _library(job: Job) -> tuple[str, bytes]:
    platform, name, fmi = job
    texts = sources(name, fmi)
    library = binary(name, texts, platform, compiler=portable(platform))
    return packaged_name(name, texts, platform), library


def _write(archive: str, libraries: dict[str, bytes]) -> str:
    """Write the archive, if it is another one than before: to compress it takes seconds."""
    path = TARGET / archive
    if _kept(path) != libraries:
        beside = path.with_suffix(".new")
        beside.write_bytes(pack(libraries))
        os.replace(beside, path)
    return f"{path.name}: {path.stat().st_size / 1024:.0f} KiB"


def _kept(path: Path) -> dict[str, bytes] | None:
    """What an archive has; None where there is none, or a damaged one."""
    try:
        return unpack(path.read_bytes())
    except (OSError, LZMAError, TarError):
        return None


if __name__ == "__main__":
    main()
