"""Archives of the FMUs on the PythonFMU backend (FMI 2.0 co-simulation).

PythonFMU packs the script and its binaries; the description it writes lacks units, types and
initial unknowns, so it is replaced by the one generated from the specification. Two of its FMUs
in one process share Python's module table, so every archive gets a script name of its own.
"""

from __future__ import annotations

import hashlib
import sys
import zipfile
from collections.abc import Callable, Sequence
from importlib.metadata import version
from importlib.resources import files
from pathlib import Path

from pythonfmu import FmuBuilder

from segfmu.errors import BuildError
from segfmu.fmu.gantry_feedforward.interface import WAYPOINTS
from segfmu.fmu.models import named, registered
from segfmu.fmu.placing import placing
from segfmu.fmu.standard.documentation import page
from segfmu.fmu.standard.fmi2 import GENERATED, model_description
from segfmu.fmu.standard.spec import Spec

SCRIPT = '''"""{name} as an FMU; the implementation is in the installed package segfmu."""

from {module} import {base}

# PythonFMU 0.7 releases one reference to this module's names too many per instance, and the names
# vanish with the last one. One reference is kept here for the first instance, and every instance
# keeps one for the next.
REFERENCES = [globals()]


class {name}({base}):
    """See {module}."""

    starts = {starts!r}

    def __init__(self, **kwargs):
        REFERENCES.append(globals())
        super().__init__(**kwargs)
'''


def build_all(
    folder: Path, report: Callable[[str], None] = lambda _: None,
    specs: Sequence[Spec] | None = None,
) -> list[Path]:
    """Build FMUs of `specs`, or of all models, into a folder; `report` gets a line before each.

    They appear together, when all of them are complete.

    Raises
    ------
    BuildError
        When one of them cannot be written, and for a model that this backend does not have.
    """
    chosen = specs or [m.spec() for m in registered() if m.slave]
    built = [folder / f"{spec.name}.fmu" for spec in chosen]
    with placing(built) as work:
        for spec, target in zip(chosen, built, strict=True):
            report(f"building {target.name}")
            # that of PythonFMU has the same name
            own = work / spec.name
            own.mkdir()
            _complete(spec, _pack(spec, own), work / target.name)
    return built


def _pack(spec: Spec, work: Path) -> Path:
    model = named(spec.name)
    if not model.slave:
        raise BuildError(f"{spec.name} has no Python backend; build it natively")
    module, _, base = model.slave.partition(":")
    usual = model.spec()
    if len(usual.variables) != len(spec.variables):
        raise BuildError(
            f"{spec.name}: FMUs of the Python backend have room for {WAYPOINTS} waypoints; build "
            "it natively for another number"
        )
    starts = {
        v.name: v.start
        for v, u in zip(spec.variables, usual.variables, strict=True) if v.start != u.start
    }
    text = SCRIPT.format(name=spec.name, module=module, base=base, starts=starts)
    digest = hashlib.sha256(model_description(spec, version("segfmu")) + text.encode()).hexdigest()
    script = work / f"segfmu_{spec.name.lower()}_{digest[:12]}.py"
    script.write_text(text, encoding="utf-8")
    before = list(sys.path)
    try:
        packed: Path = FmuBuilder.build_FMU(script, dest=work, needsExecutionTool="false")
    finally:
        sys.path[:] = before
        sys.modules.pop(script.stem, None)
    return packed


def _complete(spec: Spec, packed: Path, target: Path) -> None:
    """Copy an archive, with our description, documentation, icon and licence."""
    model = named(spec.name)
    own = {
        "modelDescription.xml": model_description(spec, version("segfmu")),
        "model.png": model.icon,
        "documentation/index.html": page(spec, version("segfmu"), model.about).encode(),
        "documentation/licenses/license.txt": files("segfmu.fmu.standard")
        .joinpath("license.txt").read_bytes(),
    }
    with zipfile.ZipFile(packed) as source:
        entries = {n: source.read(n) for n in source.namelist() if not n.endswith("/")}
    entries.update(own)
    date = tuple(int(GENERATED[i : i + w]) for i, w in ((0, 4), (5, 2), (8, 2)))
    with zipfile.ZipFile(target, "w", zipfile.ZIP_DEFLATED) as archive:
        for name in sorted(entries):
            info = zipfile.ZipInfo(name, (*date, 0, 0, 0))  # type: ignore[arg-type]
            info.compress_type = zipfile.ZIP_DEFLATED
            info.external_attr = 0o644 << 16
            archive.writestr(info, entries[name])
