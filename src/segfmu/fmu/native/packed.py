"""Libraries of a platform in one compressed archive.

They share most of their code, so that together they take half of what they take one by one.
"""

from __future__ import annotations

import io
import lzma
import tarfile
from collections.abc import Mapping


def pack(libraries: Mapping[str, bytes]) -> bytes:
    """A .tar.xz archive of libraries by their names; equal libraries give equal bytes."""
    written = io.BytesIO()
    with tarfile.open(fileobj=written, mode="w", format=tarfile.USTAR_FORMAT) as archive:
        for name in sorted(libraries):
            entry = tarfile.TarInfo(name)
            entry.size = len(libraries[name])
            archive.addfile(entry, io.BytesIO(libraries[name]))
    return lzma.compress(written.getvalue(), preset=9 | lzma.PRESET_EXTREME)


def unpack(content: bytes) -> dict[str, bytes]:
    """The libraries of an archive that `pack` wrote, by their names.

    Raises
    ------
    lzma.LZMAError
        Where the archive is damaged.
    """
    whole = lzma.decompress(content)
    with tarfile.open(fileobj=io.BytesIO(whole), mode="r:") as archive:
        return {e.name: whole[e.offset_data : e.offset_data + e.size] for e in archive}
