"""The entry points of the kernels for other layers: compiled if possible, else interpreted.

Both give the same numbers. The compiled ones exist if a C compiler was found when the package was
installed; SEGFMU_INTERPRETED=1 in the environment turns them off. entry_points.py lists the entry
points, the generated backend.pyi has their types.
"""

import os
from importlib import import_module
from importlib.util import find_spec

from segfmu.kernels.entry_points import ENTRY_POINTS

COMPILED = (
    os.environ.get("SEGFMU_INTERPRETED", "0") in ("", "0")
    and find_spec("segfmu.kernels._compiled") is not None
)

for _point in ENTRY_POINTS:
    _module = "_compiled" if COMPILED else _point.module
    globals()[_point.name] = getattr(import_module(f"segfmu.kernels.{_module}"), _point.name)
