"""Annotations of the kernels' entry points -> kernels/backend.pyi, for type checkers."""

from __future__ import annotations

from segfmu.codegen.amalgam import KERNELS
from segfmu.codegen.functions import Function, functions
from segfmu.kernels.entry_points import ENTRY_POINTS

TARGET = KERNELS / "backend.pyi"

HEAD = '''# Generated from the kernels in Python by `python -m segfmu.codegen`; never edited.
"""The entry points of the kernels, see backend.py."""

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]

COMPILED: bool
'''
ARRAYS = {"float[:]": "Floats", "float[:,:]": "Floats", "float[:,:,:]": "Floats",
          "int[:]": "Integers"}


def generate() -> str:
    """Return the text of backend.pyi."""
    names = {e.name for e in ENTRY_POINTS}
    return HEAD + "".join(_stub(f) for f in functions() if f.name in names)


def _stub(function: Function) -> str:
    taken = "".join(f"    {n}: {ARRAYS.get(kind, kind)},\n" for n, kind in function.arguments)
    results = ", ".join(function.results) or "None"
    given = f"tuple[{results}]" if function.is_tuple else results
    # positional only, as the compiled functions are
    # nothing stands before the sign that names may not be given
    arguments = f"\n{taken}    /,\n" if taken else ""
    return f"\ndef {function.name}({arguments}) -> {given}: ...\n"
