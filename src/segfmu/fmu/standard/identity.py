"""What ties a description to its binaries: the GUID, in FMI 3.0 the instantiation token."""

from __future__ import annotations

import hashlib
from dataclasses import replace
from importlib.metadata import version

from segfmu.fmu.standard.spec import Spec, Variable

# Of start values that a plan gives. The last digits of sines and powers differ between machines.
DIGITS = 9


def guid(spec: Spec) -> str:
    """The identifier of an interface and of the package that builds it.

    It follows from what is declared: names, types, units, ranges, causalities, start values, and
    the package's version. Start values that the FMU computes from others are left out, and the
    others count with nine digits, so that every machine gives the same identifier.
    """
    declared = replace(
        spec, variables=tuple(map(_declared, spec.variables)), stop_time=_rounded(spec.stop_time)
    )
    told = f"{version('segfmu')} {declared!r}"
    digest = hashlib.sha256(told.encode()).hexdigest()
    return f"{{{digest[:8]}-{digest[8:12]}-{digest[12:16]}-{digest[16:20]}-{digest[20:32]}}}"


def _declared(variable: Variable) -> Variable:
    if variable.computed:
        return replace(variable, start=None)
    if isinstance(variable.start, float):
        return replace(variable, start=_rounded(variable.start))
    return variable


def _rounded(value: float) -> float:
    return float(f"{value:.{DIGITS}g}")
