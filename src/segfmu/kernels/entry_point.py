"""How an entry point of the kernels is declared."""

from __future__ import annotations

from dataclasses import dataclass

Extent = int | str


@dataclass(frozen=True)
class EntryPoint:
    """Module below `segfmu.kernels`, name, and extents of the array arguments by their names."""

    module: str
    name: str
    extents: dict[str, tuple[Extent, ...]]


def entry(module: str, name: str, /, **extents: Extent | tuple[Extent, ...]) -> EntryPoint:
    """Declare an entry point; give the extent of a vector without a tuple."""
    return EntryPoint(
        module, name, {n: e if isinstance(e, tuple) else (e,) for n, e in extents.items()}
    )
