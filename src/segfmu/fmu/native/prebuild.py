"""Compile the binaries that a released wheel carries: `python -m segfmu.fmu.native.prebuild`.

They lie in `binaries/` beside this file, for every platform, model and version of FMI. A build
takes them where its sources are theirs, and then needs no compiler.
"""

from __future__ import annotations

import os
import shutil
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from segfmu.fmu.models import registered
from segfmu.fmu.native.archive import VERSIONS, sources
from segfmu.fmu.native.binaries import binary, packaged_name
from segfmu.fmu.native.compilers import PLATFORMS, portable

TARGET = Path(__file__).with_name("binaries")


def main() -> None:
    """Compile what is missing, and remove binaries of other sources."""
    texts = {(m.name, fmi): sources(m.name, fmi) for m in registered() for fmi in VERSIONS}
    wanted = {
        TARGET / packaged_name(name, given, platform): (name, given, platform)
        for (name, _), given in texts.items() for platform in PLATFORMS
    }
    for old in TARGET.glob("*/*"):
        if old not in wanted:
            old.unlink()
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        missing = [path for path in wanted if not path.exists()]
        made = pool.map(
            lambda path: binary(*wanted[path], compiler=portable(wanted[path][-1])), missing
        )
        for path, library in zip(missing, made, strict=True):
            path.parent.mkdir(parents=True, exist_ok=True)
            beside = path.with_suffix(".new")
            beside.write_bytes(library)
            shutil.move(beside, path)
            print(f"{path.relative_to(TARGET)}: {len(library) / 1024:.0f} KiB", flush=True)


if __name__ == "__main__":
    main()
