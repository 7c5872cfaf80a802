"""Binaries of native FMUs: packaged, from the user's cache, or compiled now.

No binary depends on a mission, so each is made once: for a released wheel with those of all
platforms, or else once on a machine, where the cache keeps it by a hash of its sources, its
compiler and the options.
"""

from __future__ import annotations

import hashlib
import os
import re
from collections.abc import Iterable, Mapping
from functools import cache
from importlib.resources import files
from pathlib import Path

from platformdirs import user_cache_path

from segfmu.errors import BuildError
from segfmu.fmu.native.compilers import PLATFORMS, TARGETS, Compiler
from segfmu.fmu.native.compilers import compiler as compiler_for
from segfmu.fmu.native.packed import unpack
from segfmu.folders import temporary_files, work_folder

# the one translation unit of an FMU, which includes its other sources
UNIT = "fmu.c"
# bytes of the digest that a file of the cache begins with
DIGEST = hashlib.sha256().digest_size
# newest libraries that the cache keeps, and their names
KEPT = 64
OWN = re.compile(r"\w+-\w+-\w+-[0-9a-f]{32}")


def binary(
    name: str, texts: Mapping[str, bytes], platform: str, *, compiler: Compiler | None = None
) -> bytes:
    """The shared library of a model, of these sources, for a platform.

    Parameters
    ----------
    name : str
        Of the model; the library's file in an archive has it too.
    texts : mapping of str to bytes
        Sources by their names.
    platform : str
        A name of `TARGETS`.
    compiler : Compiler, optional
        In place of a packaged binary and of the machine's compiler.

    Raises
    ------
    BuildError
        Where there is neither a binary nor a compiler for the platform, or the compiler fails.
    """
    if platform not in TARGETS:
        raise BuildError(f"platform must be one of {', '.join(TARGETS)}, got {platform!r}")
    ready = None if compiler else _packaged(platform).get(packaged_name(name, texts, platform))
    if ready is not None:
        return ready
    chosen = compiler or compiler_for(platform)
    path = folder() / _key(name, texts, chosen)
    found = _read(path)
    if found is None:
        found = compiled(name, texts, chosen)
        _keep(path, found)
    return found


def packaged(models: Iterable[tuple[str, Mapping[str, bytes]]]) -> tuple[str, ...]:
    """Platforms whose binaries of all these models, of these sources, come with the package."""
    given = list(models)
    return tuple(
        p for p in PLATFORMS
        if _packaged(p).keys() >= {packaged_name(name, texts, p) for name, texts in given}
    )


def folder() -> Path:
    """The cache: SEGFMU_CACHE of the environment, or the usual place of the user's system."""
    return Path(os.environ.get("SEGFMU_CACHE") or user_cache_path("segfmu"))


def compiled(name: str, texts: Mapping[str, bytes], chosen: Compiler) -> bytes:
    """Compile and link; the folder that this happens in leaves no trace in the library."""
    with work_folder() as root, temporary_files(BuildError):
        for source, text in texts.items():
            target = root / source
            target.parent.mkdir(exist_ok=True)
            target.write_bytes(text)
        library = root / f"{name}{chosen.platform.suffix}"
        chosen.build(root / UNIT, library)
        return library.read_bytes()


def source_digest(texts: Mapping[str, bytes]) -> str:
    """Hash of sources by their names."""
    digest = hashlib.sha256()
    for name in sorted(texts):
        digest.update(f"{name} {len(texts[name])} ".encode() + texts[name])
    return digest.hexdigest()


def packaged_name(name: str, texts: Mapping[str, bytes], platform: str) -> str:
    """A library's name in the archive of its platform: the sources are part of it."""
    return f"{name}-{source_digest(texts)[:16]}{TARGETS[platform].suffix}"


@cache
def _packaged(platform: str) -> Mapping[str, bytes]:
    """Libraries that come with the package for a platform, by their names."""
    path = files("segfmu.fmu.native").joinpath("binaries", f"{platform}.tar.xz")
    return unpack(path.read_bytes()) if path.is_file() else {}


def _key(name: str, texts: Mapping[str, bytes], chosen: Compiler) -> str:
    told = f"{source_digest(texts)} {chosen.identity}"
    digest = hashlib.sha256(told.encode()).hexdigest()
    return f"{name}-{chosen.platform.name}-{digest[:32]}"


def _read(path: Path) -> bytes | None:
    """A library of the cache, if it is there and whole."""
    try:
        content = path.read_bytes()
    except OSError:
        return None
    library = content[DIGEST:]
    return library if hashlib.sha256(library).digest() == content[:DIGEST] else None


def _keep(path: Path, library: bytes) -> None:
    """Put a library into the cache; without one, the next build compiles again."""
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        with work_folder(path.parent) as beside:
            whole = beside / path.name
            whole.write_bytes(hashlib.sha256(library).digest() + library)
            os.replace(whole, path)
        # the folder may be one that has other files too
        entries = [p for p in path.parent.iterdir() if OWN.fullmatch(p.name) and p.is_file()]
        for old in sorted(entries, key=lambda p: p.stat().st_mtime)[:-KEPT]:
            old.unlink(missing_ok=True)
    except OSError:
        return
