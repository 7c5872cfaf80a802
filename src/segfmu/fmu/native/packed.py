"""Libraries for a processor in one compressed archive.

They share most of their code, so that together they take half of what they take one by one.
"""

from __future__ import annotations

import io
import lzma
import tarfile
from collections.abc import Mapping

# bits of the last byte, of the place, and of its alignment by which bytes are foretold: usual, and
# what instructions of 4 bytes and of any size are like
CONTEXTS = ((3, 0, 2), (2, 2, 2), (4, 0, 1), (2, 0, 0))
FAST, SMALL = 1, 9 | lzma.PRESET_EXTREME


def pack(libraries: Mapping[str, bytes]) -> bytes:
    """A .tar.xz archive of libraries by their names; equal libraries give equal bytes."""
    written = io.BytesIO()
    with tarfile.open(fileobj=written, mode="w", format=tarfile.USTAR_FORMAT) as archive:
        for name in sorted(libraries):
            entry = tarfile.TarInfo(name)
            entry.size = len(libraries[name])
            archive.addfile(entry, io.BytesIO(libraries[name]))
    content = written.getvalue()
    # the fast way tells the best one, or one larger by less than a hundredth
    best = min(CONTEXTS, key=lambda each: len(_compressed(content, FAST, *each)))
    return _compressed(content, SMALL, *best)


def _compressed(content: bytes, preset: int, lc: int, lp: int, pb: int) -> bytes:
    chosen = {"id": lzma.FILTER_LZMA2, "preset": preset}
    return lzma.compress(content, filters=[chosen | {"lc": lc, "lp": lp, "pb": pb}])


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
