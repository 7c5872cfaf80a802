"""Archives of the probe: FMUs of either version that do what a test tells them."""

from __future__ import annotations

import subprocess
import sys
import zipfile
from pathlib import Path

from fmpy import platform, platform_tuple
from fmpy.fmi2 import FMU2Slave
from fmpy.fmi3 import FMU3Slave

from segfmu.fmu.native import archive
from tests.compiler import CC

HERE = Path(__file__).parent
HEADERS = Path(archive.__file__).parent / "c" / "fmi"
SLAVES = {2: FMU2Slave, 3: FMU3Slave}
SUFFIX = {"darwin": ".dylib", "win32": ".dll"}.get(sys.platform, ".so")
# name, kind, causality, variability, start, by the places of probe.h
REALS = (
    ("x", "Real", "input", "continuous", "0.0"), ("gain", "Real", "parameter", "tunable", "1.0"),
    ("fail.time", "Real", "parameter", "fixed", "1e9"),
    ("y", "Real", "output", "continuous", None),
    ("narrow", "Float32", "output", "continuous", None),
)
WHOLES = (
    ("n", "Integer", "input", "discrete", "0"),
    ("fail.status", "Integer", "parameter", "fixed", "0"),
    ("reset.status", "Integer", "parameter", "fixed", "0"),
    ("n.out", "Integer", "output", "discrete", None),
    ("runs", "Integer", "output", "discrete", None),
    ("tiny", "Int8", "input", "discrete", "0"), ("wide", "Int64", "output", "discrete", None),
)
FLAGS = (
    ("flag", "Boolean", "input", "discrete", "false"),
    ("talk", "Boolean", "parameter", "fixed", "false"),
    ("flag.out", "Boolean", "output", "discrete", None),
)
TEXTS = (("text", "String", "parameter", "fixed", ""),)
UNITS = '<UnitDefinitions><Unit name="V"/></UnitDefinitions>'
NARROW = ("Float32", "Int8", "Int64")
KINDS3 = {"Real": "Float64", "Integer": "Int32"}


def build(folder: Path, fmi: int, *, complete: bool = True) -> Path:
    """An archive; one that is not complete lacks functions."""
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / f"Probe{fmi}.fmu"
    with zipfile.ZipFile(path, "w") as packed:
        packed.writestr("modelDescription.xml", _description(fmi))
        place = platform if fmi == 2 else platform_tuple
        packed.write(_library(folder, fmi, complete), f"binaries/{place}/Probe{fmi}{SUFFIX}")
    return path


def _library(folder: Path, fmi: int, complete: bool) -> Path:
    names = [n for n in dir(SLAVES[fmi]) if n.startswith(f"fmi{fmi}")]
    stubs = folder / f"stubs{fmi}.c"
    stubs.write_text("".join(
        f"__attribute__((weak)) int {n}(void) {{ return 3; }}\n" for n in names if complete
    ))
    made = folder / f"Probe{fmi}{SUFFIX}"
    subprocess.run(
        [CC, "-std=c99", "-shared", "-fPIC", f"-I{HEADERS}", HERE / f"fmi{fmi}.c", stubs, "-o",
         made],
        check=True,
    )
    return made


def _description(fmi: int) -> str:
    variables = []
    for block, rows in enumerate((REALS, WHOLES, FLAGS, TEXTS)):
        for place, row in enumerate(rows):
            if fmi == 3 or row[1] not in NARROW:
                # references are unique in FMI 3.0 only
                reference = place + (100 * block if fmi == 3 else 0)
                variables.append(_variable(fmi, reference, *row))
    if fmi == 3:
        variables.append('<Float64 name="time" valueReference="400" causality="independent"/>')
    body = "\n".join(variables)
    if fmi == 2:
        return (
            '<?xml version="1.0" encoding="UTF-8"?>\n<fmiModelDescription fmiVersion="2.0" '
            'modelName="Probe2" guid="probe"><CoSimulation modelIdentifier="Probe2" '
            f'canHandleVariableCommunicationStepSize="true"/>{UNITS}<ModelVariables>{body}'
            "</ModelVariables><ModelStructure/></fmiModelDescription>"
        )
    return (
        '<?xml version="1.0" encoding="UTF-8"?>\n<fmiModelDescription fmiVersion="3.0" '
        'modelName="Probe3" instantiationToken="probe"><CoSimulation modelIdentifier="Probe3" '
        'canHandleVariableCommunicationStepSize="true" mightReturnEarlyFromDoStep="true" '
        f'hasEventMode="true"/>{UNITS}<ModelVariables>{body}</ModelVariables><ModelStructure/>'
        "</fmiModelDescription>"
    )


def _variable(
    fmi: int, reference: int, name: str, kind: str, causality: str, variability: str,
    start: str | None,
) -> str:
    shared = f'name="{name}" valueReference="{reference}" causality="{causality}" '
    shared += f'variability="{variability}"'
    given = "" if start is None else f' start="{start}"'
    given += ' unit="V"' if name == "y" else ""
    if fmi == 2:
        return f"<ScalarVariable {shared}><{kind}{given}/></ScalarVariable>"
    kind = KINDS3.get(kind, kind)
    if kind == "String":
        return f'<String {shared}><Start value="{start}"/></String>'
    return f"<{kind} {shared}{given}/>"
