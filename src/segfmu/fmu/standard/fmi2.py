"""modelDescription.xml of FMI 2.0 from an interface specification.

A native FMU has model exchange beside co-simulation, its capabilities and its sources; what
PythonFMU packs has co-simulation alone.
"""

from __future__ import annotations

from xml.etree import ElementTree as ET

from segfmu.fmu.standard.identity import guid
from segfmu.fmu.standard.references import entries
from segfmu.fmu.standard.spec import Spec, Variable
from segfmu.fmu.standard.units import DISPLAY_UNITS, nominal, unit_definitions

# of the importer's solver in model exchange; with the 1e-5 of some, the load is off by 0.1 mm
TOLERANCE = "1e-8"
# Fixed, so that the same interface always gives the same file.
GENERATED = "2026-01-01T00:00:00Z"

CATEGORIES = {
    "logEvents": "what the FMU did",
    "logStatusWarning": "messages with status warning",
    "logStatusDiscard": "messages with status discard",
    "logStatusError": "messages with status error",
    "logStatusFatal": "messages with status fatal",
    "logAll": "all messages",
}


def model_description(
    spec: Spec, version: str, sources: tuple[str, ...] | None = None
) -> bytes:
    """The XML text of modelDescription.xml; `sources` are those of a native FMU."""
    root = ET.Element(
        "fmiModelDescription",
        {
            "fmiVersion": "2.0",
            "modelName": spec.name,
            "guid": guid(spec),
            "description": spec.description,
            "version": version,
            "license": "MIT",
            "generationTool": f"segfmu {version}",
            "generationDateAndTime": GENERATED,
            "variableNamingConvention": "structured",
        },
    )
    _interfaces(root, spec, sources)
    unit_definitions(root, spec)
    _types(root, spec)
    categories = ET.SubElement(root, "LogCategories")
    for name, description in CATEGORIES.items():
        ET.SubElement(categories, "Category", {"name": name, "description": description})
    ET.SubElement(root, "DefaultExperiment", experiment(spec))
    variables = ET.SubElement(root, "ModelVariables")
    for entry in entries(spec, 2):
        variables.append(_variable(entry.variable, spec))
    _structure(root, spec)
    return document(root)


def document(root: ET.Element) -> bytes:
    """The text of an XML document."""
    ET.indent(root)
    text: bytes = ET.tostring(root, "utf-8")
    return b'<?xml version="1.0" encoding="UTF-8"?>\n' + text + b"\n"


def _interfaces(root: ET.Element, spec: Spec, sources: tuple[str, ...] | None) -> None:
    common = {"modelIdentifier": spec.name, "canNotUseMemoryManagementFunctions": "true"}
    steps = {"canHandleVariableCommunicationStepSize": "true"}
    if sources is None:
        ET.SubElement(root, "CoSimulation", common | steps)
        return
    common |= {"canGetAndSetFMUstate": "true", "canSerializeFMUstate": "true"}
    steps |= {
        # also without inputs: PyFMI extrapolates only where every FMU says so
        "canInterpolateInputs": "true",
        "maxOutputDerivativeOrder": str(spec.orders),
    }
    accepts = {} if spec.states else {"completedIntegratorStepNotNeeded": "true"}
    for name, own in (("ModelExchange", accepts), ("CoSimulation", steps)):
        partial = {"providesDirectionalDerivative": "true"} if name in spec.partials else {}
        files = ET.SubElement(ET.SubElement(root, name, common | partial | own), "SourceFiles")
        for source in sources:
            ET.SubElement(files, "File", {"name": source})


def _types(root: ET.Element, spec: Spec) -> None:
    if not spec.enumerations:
        return
    definitions = ET.SubElement(root, "TypeDefinitions")
    for enumeration in spec.enumerations:
        simple = ET.SubElement(
            definitions,
            "SimpleType",
            {"name": enumeration.name, "description": enumeration.description},
        )
        items = ET.SubElement(simple, "Enumeration")
        for value, name in enumerate(enumeration.items, 1):
            ET.SubElement(items, "Item", {"name": name, "value": str(value)})


def _variable(variable: Variable, spec: Spec) -> ET.Element:
    attributes = {
        "name": variable.name,
        "valueReference": str(spec.references[variable.name]),
        "description": variable.description,
        "causality": variable.causality,
        "variability": variable.variability,
    }
    if variable.initial is not None:
        attributes["initial"] = variable.initial
    element = ET.Element("ScalarVariable", attributes)
    found = details(variable)
    state = {rate: state for state, rate in spec.states}.get(variable.name)
    if state is not None:
        found["derivative"] = str(spec.references[state])
    ET.SubElement(element, variable.kind, found)
    return element


def details(variable: Variable) -> dict[str, str]:
    """Attributes of a variable's type, the same in both versions of FMI."""
    found: dict[str, str] = {}
    if variable.enumeration is not None:
        found["declaredType"] = variable.enumeration.name
    if variable.unit is not None:
        found["unit"] = variable.unit
        if variable.unit in DISPLAY_UNITS:
            found["displayUnit"] = DISPLAY_UNITS[variable.unit][0]
    for name, value in (
        ("min", variable.minimum), ("max", variable.maximum), ("nominal", nominal(variable)),
        ("start", variable.start),
    ):
        if value is not None:
            found[name] = text(variable, value)
    return found


def text(variable: Variable, value: float | int | bool) -> str:
    """A value as XML has it."""
    if variable.kind == "Boolean":
        return "true" if value else "false"
    return repr(float(value)) if variable.kind == "Real" else str(int(value))


def _structure(root: ET.Element, spec: Spec) -> None:
    """Without other word, outputs follow inputs only through a step: none depends on one."""
    structure = ET.SubElement(root, "ModelStructure")
    described = {e.name for e in entries(spec, 2)}
    dependencies = dict(spec.dependencies)

    def add(parent: ET.Element, name: str) -> None:
        known = described.intersection(dependencies.get(name, ()))
        knowns = sorted(spec.references[n] for n in known)
        attributes = {"index": str(spec.references[name])}
        attributes["dependencies"] = " ".join(map(str, knowns))
        ET.SubElement(parent, "Unknown", attributes)

    outputs = ET.SubElement(structure, "Outputs")
    for variable in spec.where("output"):
        add(outputs, variable.name)
    if spec.states:
        derivatives = ET.SubElement(structure, "Derivatives")
        for _, rate in spec.states:
            add(derivatives, rate)
    unknowns = ET.SubElement(structure, "InitialUnknowns")
    for name in initial_unknowns(spec):
        ET.SubElement(unknowns, "Unknown", {"index": str(spec.references[name])})


def experiment(spec: Spec) -> dict[str, str]:
    """Attributes of DefaultExperiment, of both versions."""
    return {
        "startTime": "0", "stopTime": repr(spec.stop_time), "tolerance": TOLERANCE,
        "stepSize": repr(spec.step_size),
    }


def initial_unknowns(spec: Spec) -> list[str]:
    """What is calculated in initialisation: outputs, parameters, states and derivatives."""
    involved = {name for pair in spec.states for name in pair}
    return [
        v.name for v in spec.variables
        if v.initial == "calculated" and (v.causality != "local" or v.name in involved)
    ]
