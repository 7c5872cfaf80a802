"""Start values of an FMU as the file resources/start.bin, which native/c/start.c reads.

One binary serves every mission, as nothing in it depends on start values. The file and the
description come from the same specification.
"""

from __future__ import annotations

import struct

from segfmu.fmu.native.tables import layout, most_rows
from segfmu.fmu.standard.identity import guid
from segfmu.fmu.standard.references import entries
from segfmu.fmu.standard.spec import Spec

MAGIC = b"segfmu\0\1"
TOKEN = 40
MASK = 2**64 - 1


def content(spec: Spec, largest: Spec, version: int, mark: int) -> bytes:
    """The bytes of the file.

    Parameters
    ----------
    spec : Spec
        What the archive describes.
    largest : Spec
        The interface that the binary is made of: it may have more rows.
    version : int
        Of FMI.
    mark : int
        Of the binary's sources.
    """
    own = {v.name: v.start for v in spec.variables}
    placed = layout(largest)
    reals, integers = list(placed.reals), list(placed.integers) or [0]
    for v in largest.variables:
        start = own.get(v.name)
        if start is None:
            continue
        if v.kind == "Real":
            reals[placed.offsets[v.name]] = float(start)
        else:
            integers[placed.offsets[v.name]] = int(start)
    rows = most_rows(spec)
    head = struct.pack(
        f"<8sQQQ{TOKEN}s", MAGIC, mark, rows, len(entries(spec, version)), guid(spec).encode()
    )
    body = head + struct.pack(f"<{len(reals)}d{len(integers)}q", *reals, *integers)
    return body + struct.pack("<Q", _sum(body))


def _sum(body: bytes) -> int:
    words = struct.unpack(f"<{len(body) // 8}Q", body)
    found = len(body)
    for word in words:
        found = ((found ^ word) * 0x9E3779B97F4A7C15) & MASK
        found ^= found >> 29
    return found
