"""Compile the binaries that a released wheel carries: `python -m segfmu.fmu.native.prebuild`.

They lie in `binaries/` beside this file, an archive a platform, with every model and version of
FMI; that of pages with FMI 2 alone, of the models that run there. A build takes them where its
sources are theirs, and then needs no compiler.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from segfmu.fmu.models import registered
from segfmu.fmu.native.archive import VERSIONS, sources
from segfmu.fmu.native.binaries import binary, packaged_name
from segfmu.fmu.native.compilers import BROWSER, TARGETS, portable
from segfmu.fmu.native.packed import pack

# models that run in pages
PAGE = ("GantryFeedforward", "GantryCrane")
TARGET = Path(__file__).with_name("binaries")


def main() -> None:
    """Write the archive of every platform; what the user's cache has is not compiled again."""
    TARGET.mkdir(exist_ok=True)
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        for told in pool.map(lambda platform: _write(platform, _given(platform)), TARGETS):
            print(told, flush=True)


def _given(platform: str) -> list[tuple[str, Mapping[str, bytes]]]:
    """Models with their sources of the versions of FMI that a platform has."""
    if platform == BROWSER.name:
        return [(name, sources(name, 2)) for name in PAGE]
    return [(m.name, sources(m.name, fmi)) for m in registered() for fmi in VERSIONS]


def _write(platform: str, given: Iterable[tuple[str, Mapping[str, bytes]]]) -> str:
    content = pack({
        packaged_name(name, texts, platform): binary(
            name, texts, platform, compiler=portable(platform)
        )
        for name, texts in given
    })
    path = TARGET / f"{platform}.tar.xz"
    beside = path.with_suffix(".new")
    beside.write_bytes(content)
    os.replace(beside, path)
    return f"{path.name}: {len(content) / 1024:.0f} KiB"


if __name__ == "__main__":
    main()
