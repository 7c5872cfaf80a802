"""What tests make of sources and tools alone, kept from one run to the next.

An entry is found by a hash of all that it follows from, so that a change of a source, a tool or an
option makes it anew. A soak makes everything. The entries are in a folder of the cache of binaries.
"""

from __future__ import annotations

import hashlib
import platform
import subprocess
import sys
from collections.abc import Callable, Iterable, Mapping
from functools import cache
from importlib.metadata import distributions
from pathlib import Path

import psutil

from segfmu.fmu.native import binaries
from tests.campaign import SOAK


def made(name: str, told: Callable[[], Mapping[str, bytes]], make: Callable[[], bytes]) -> bytes:
    """What `make` gives, which has to follow from what `told` gives and from nothing else.

    It is not kept where that has changed meanwhile.
    """
    digest = binaries.source_digest(told())
    path = binaries.folder() / "tests" / f"{name}-made-once-{digest[:32]}"
    found = None if SOAK else binaries._read(path)
    if found is None:
        found = make()
        if binaries.source_digest(told()) == digest:
            binaries._keep(path, found)
    return found


def contents(folder: Path) -> dict[str, bytes]:
    """Sources and objects of C in a folder, by their names."""
    return {path.name: path.read_bytes() for path in sorted(folder.glob("*.[cho]"))}


def unchanged(files: Iterable[Path]) -> bool:
    """Whether all files are older than this process: what it has imported is what they have."""
    return max(path.stat().st_ctime for path in files) < psutil.Process().create_time()


@cache
def compiler(command: str) -> bytes:
    """What a compiler's objects follow from beside sources and options."""
    said = subprocess.run([command, "--version"], capture_output=True, check=True).stdout
    return f"{command} {platform.libc_ver()} {platform.machine()} ".encode() + said


@cache
def interpreter() -> bytes:
    """Python and all other packages, with the digests of their files."""
    digest = hashlib.sha256(sys.version.encode())
    records = (f.read_text("RECORD") or "" for f in distributions() if f.name != "segfmu")
    for record in sorted(records):
        # commands name their folder
        own = (line for line in record.splitlines(keepends=True) if not line.startswith(".."))
        digest.update("".join(own).encode())
    return digest.digest()
