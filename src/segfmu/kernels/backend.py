"""The entry points of the kernels that other layers call: compiled, or else interpreted.

Both give the same numbers. The compiled ones exist where a C compiler was found when the package
was installed; SEGFMU_INTERPRETED=1 in the environment turns them off. What is here is listed in
entry_points.py, and typed in the generated backend.pyi.
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
