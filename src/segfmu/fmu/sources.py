"""Sources in C of the kernels and models: in folders `c`, or in the one archive of a wheel."""

from __future__ import annotations

import tarfile
from collections.abc import Iterator
from functools import cache
from importlib.resources import files
from importlib.resources.abc import Traversable
from io import BytesIO

ARCHIVE = "sources.tar.bz2"


def sources_of(package: str) -> dict[str, bytes]:
    """Sources of a package by their names in its folder `c`, in the order of these."""
    folder = files(package).joinpath("c")
    if folder.is_dir():
        return dict(sorted(_walked(folder, "")))
    prefix = "/".join((*package.split(".")[1:], "c", ""))
    return {
        name.removeprefix(prefix): content
        for name, content in sorted(_archived().items()) if name.startswith(prefix)
    }


def _walked(folder: Traversable, prefix: str) -> Iterator[tuple[str, bytes]]:
    for place in folder.iterdir():
        if place.is_dir():
            yield from _walked(place, f"{prefix}{place.name}/")
        elif place.name.endswith((".c", ".h")):
            yield prefix + place.name, place.read_bytes()


@cache
def _archived() -> dict[str, bytes]:
    """What setup.py put into a wheel, by its place in the package."""
    content = files("segfmu.fmu").joinpath(ARCHIVE).read_bytes()
    with tarfile.open(fileobj=BytesIO(content)) as archive:
        opened = ((entry.name, archive.extractfile(entry)) for entry in archive)
        return {name: file.read() for name, file in opened if file is not None}
