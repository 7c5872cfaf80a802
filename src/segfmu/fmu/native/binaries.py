"""Binaries of native FMUs: packaged, from the user's cache, or compiled now.

No binary depends on a mission, so each is made once: for a released wheel with those of all
platforms, or else once on a machine, where the cache keeps it by a hash of its sources, its
compiler and the options.
"""

from __future__ import annotations

import hashlib
import os
import re
from collections import defaultdict
from collections.abc import Callable, Iterable, Mapping
from contextlib import suppress
from functools import cache
from importlib.resources import files
from pathlib import Path
from threading import Lock

from platformdirs import user_cache_path

from segfmu.errors import BuildError
from segfmu.fmu.native.compilers import BROWSER, PLATFORMS, TARGETS, Compiler
from segfmu.fmu.native.compilers import compiler as compiler_for
from segfmu.fmu.native.packed import unpack
from segfmu.folders import make_folders, temporary_files, work_folder

# the one translation unit of an FMU, which includes its other sources
UNIT = "fmu.c"
# The kernels, of which it does without where APART is defined: they take most of the time, and are
# equal in all models and versions of FMI.
CORE, APART = "core.c", "SEGFMU_KERNELS_APART"
# and what they include
SHARED = (
    CORE, "arrays.h", "kernels.c", "kernels.h", "messages.c", "messages.h", "oldest.h", "plan.c",
    "problem.h", "records.h", "segfmu.h", "span.h", "visible.h",
)
# bytes of the digest that a file of the cache begins with
DIGEST = hashlib.sha256().digest_size
# entries of the cache that are kept, those used last, and their names
KEPT = 64
OWN = re.compile(r"\w+-\w+-\w+-[0-9a-f]{32}")
# by platform, held while its kernels are compiled
_locks: defaultdict[str, Lock] = defaultdict(Lock)


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
        In place of a packaged binary and of the machine's compiler; it compiles the kernels once
        for all libraries of the platform, as is done for pages. That takes half the time, and a
        step of the crane 3 % more with zig, yet 15 % with GCC.

    Raises
    ------
    BuildError
        Where there is neither a binary nor a compiler for the platform, or the compiler fails.
    """
    if platform not in TARGETS:
        raise BuildError(f"platform must be one of {', '.join(TARGETS)}, got {platform!r}")
    if compiler is None:
        ready = _packaged(platform).get(packaged_name(name, texts, platform))
        if ready is not None:
            return ready
    chosen = compiler or compiler_for(platform)
    # a page has two FMUs
    if compiler is None and platform != BROWSER.name:
        return _cached(name, texts, chosen, lambda: compiled(name, texts, chosen))
    return _cached(f"{name}_apart", texts, chosen, lambda: _linked(name, texts, chosen))


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
    return _built(texts, lambda root: chosen.build(root / UNIT, _library(root, name, chosen)))


def _linked(name: str, texts: Mapping[str, bytes], chosen: Compiler) -> bytes:
    """The same with kernels that other libraries have as well."""
    core = {source: texts[source] for source in SHARED}
    # the first model compiles them, others wait
    with _locks[chosen.platform.name]:
        kernels = _cached("Kernels", core, chosen, lambda: _built(
            core, lambda root: chosen.compile(root / CORE)
        ))

    def linked(root: Path) -> Path:
        ready = root / "kernels.o"
        ready.write_bytes(kernels)
        own = chosen.compile(root / UNIT, f"-D{APART}")
        return chosen.link(_library(root, name, chosen), own, ready)

    return _built(texts, linked)


def _library(root: Path, name: str, chosen: Compiler) -> Path:
    return root / f"{name}{chosen.platform.suffix}"


def _built(texts: Mapping[str, bytes], build: Callable[[Path], Path]) -> bytes:
    """What is made of sources in a folder that has them and nothing else."""
    with work_folder() as root, temporary_files(BuildError):
        for source, text in texts.items():
            target = root / source
            target.parent.mkdir(exist_ok=True)
            target.write_bytes(text)
        return build(root).read_bytes()


def source_digest(texts: Mapping[str, bytes]) -> str:
    """Hash of sources by their names."""
    digest = hashlib.sha256()
    for name in sorted(texts):
        digest.update(f"{name} {len(texts[name])} ".encode() + texts[name])
    return digest.hexdigest()


def packaged_name(name: str, texts: Mapping[str, bytes], platform: str) -> str:
    """A library's name in the archive of its processor: the sources are part of it."""
    return f"{name}-{source_digest(texts)[:16]}{TARGETS[platform].suffix}"


def archive_name(platform: str) -> str:
    """The archive with a platform's libraries: those for the same processor share most code."""
    return f"{platform.partition('-')[0]}.tar.xz"


def _packaged(platform: str) -> Mapping[str, bytes]:
    """Libraries that come with the package for a platform's processor, by their names."""
    return _unpacked(archive_name(platform))


@cache
def _unpacked(archive: str) -> Mapping[str, bytes]:
    path = files("segfmu.fmu.native").joinpath("binaries", archive)
    return unpack(path.read_bytes()) if path.is_file() else {}


def _key(name: str, texts: Mapping[str, bytes], chosen: Compiler) -> str:
    told = f"{source_digest(texts)} {chosen.identity}"
    digest = hashlib.sha256(told.encode()).hexdigest()
    return f"{name}-{chosen.platform.name}-{digest[:32]}"


def _cached(
    name: str, texts: Mapping[str, bytes], chosen: Compiler, make: Callable[[], bytes]
) -> bytes:
    """An entry of the cache, made where it is not there."""
    path = folder() / _key(name, texts, chosen)
    found = _read(path)
    if found is None:
        found = make()
        _keep(path, found)
    return found


def _read(path: Path) -> bytes | None:
    """An entry of the cache, if it is there and whole."""
    try:
        content = path.read_bytes()
    except OSError:
        return None
    kept = content[DIGEST:]
    if hashlib.sha256(kept).digest() != content[:DIGEST]:
        return None
    # another user's cache is one to read
    with suppress(OSError):
        os.utime(path)
    return kept


def _keep(path: Path, made: bytes) -> None:
    """Put an entry into the cache; without one, the next build compiles again."""
    try:
        make_folders(path.parent)
        with work_folder(path.parent) as beside:
            whole = beside / path.name
            whole.write_bytes(hashlib.sha256(made).digest() + made)
            os.replace(whole, path)
        # the folder may be one that has other files too
        entries = [p for p in path.parent.iterdir() if OWN.fullmatch(p.name) and p.is_file()]
        for old in sorted(entries, key=lambda p: p.stat().st_mtime)[:-KEPT]:
            old.unlink(missing_ok=True)
    except OSError:
        return
