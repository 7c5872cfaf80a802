"""modelDescription.xml of FMI 2.0 from an interface specification."""

from __future__ import annotations

import hashlib
from xml.etree import ElementTree as ET

from segfmu.fmu.spec import Spec, Variable
from segfmu.fmu.units import BASE_UNITS, DISPLAY_UNITS

# Fixed, so that the same interface always gives the same file.
GENERATED = "2026-01-01T00:00:00Z"

CATEGORIES = {
    "logStatusWarning": "messages with status warning",
    "logStatusDiscard": "messages with status discard",
    "logStatusError": "messages with status error",
    "logStatusFatal": "messages with status fatal",
    "logAll": "all messages",
}


def guid(spec: Spec) -> str:
    """An identifier of the interface's content."""
    digest = hashlib.sha256(repr(spec).encode()).hexdigest()
    return f"{{{digest[:8]}-{digest[8:12]}-{digest[12:16]}-{digest[16:20]}-{digest[20:32]}}}"


def model_description(spec: Spec, version: str) -> bytes:
    """The XML text of modelDescription.xml for co-simulation."""
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
    ET.SubElement(
        root,
        "CoSimulation",
        {
            "modelIdentifier": spec.name,
            "canHandleVariableCommunicationStepSize": "true",
            "canNotUseMemoryManagementFunctions": "true",
        },
    )
    _units(root, spec)
    _types(root, spec)
    categories = ET.SubElement(root, "LogCategories")
    for name, description in CATEGORIES.items():
        ET.SubElement(categories, "Category", {"name": name, "description": description})
    ET.SubElement(
        root,
        "DefaultExperiment",
        {"startTime": "0", "stopTime": repr(spec.stop_time), "stepSize": repr(spec.step_size)},
    )
    variables = ET.SubElement(root, "ModelVariables")
    for reference, variable in enumerate(spec.variables):
        variables.append(_variable(reference, variable))
    _structure(root, spec)
    ET.indent(root)
    text: bytes = ET.tostring(root, "utf-8")
    return b'<?xml version="1.0" encoding="UTF-8"?>\n' + text + b"\n"


def _units(root: ET.Element, spec: Spec) -> None:
    used = {v.unit for v in spec.variables if v.unit}
    definitions = ET.SubElement(root, "UnitDefinitions")
    for name in BASE_UNITS:
        if name in used:
            unit = ET.SubElement(definitions, "Unit", {"name": name})
            ET.SubElement(unit, "BaseUnit", {k: str(v) for k, v in BASE_UNITS[name].items()})
            if name in DISPLAY_UNITS:
                shown, factor = DISPLAY_UNITS[name]
                ET.SubElement(unit, "DisplayUnit", {"name": shown, "factor": repr(factor)})


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


def _variable(reference: int, variable: Variable) -> ET.Element:
    attributes = {
        "name": variable.name,
        "valueReference": str(reference),
        "description": variable.description,
        "causality": variable.causality,
        "variability": variable.variability,
    }
    if variable.initial is not None:
        attributes["initial"] = variable.initial
    element = ET.Element("ScalarVariable", attributes)
    details: dict[str, str] = {}
    if variable.enumeration is not None:
        details["declaredType"] = variable.enumeration.name
    if variable.unit is not None:
        details["unit"] = variable.unit
        if variable.unit in DISPLAY_UNITS:
            details["displayUnit"] = DISPLAY_UNITS[variable.unit][0]
    for name, value in (
        ("min", variable.minimum), ("max", variable.maximum), ("nominal", variable.nominal),
        ("start", variable.start),
    ):
        if value is not None:
            details[name] = _text(variable, value)
    ET.SubElement(element, variable.kind, details)
    return element


def _text(variable: Variable, value: float | int | bool) -> str:
    if variable.kind == "Boolean":
        return "true" if value else "false"
    return repr(float(value)) if variable.kind == "Real" else str(int(value))


def _structure(root: ET.Element, spec: Spec) -> None:
    """Outputs follow inputs only through a step, so none depends on an input directly."""
    structure = ET.SubElement(root, "ModelStructure")
    outputs = ET.SubElement(structure, "Outputs")
    unknowns = ET.SubElement(structure, "InitialUnknowns")
    for index, variable in enumerate(spec.variables, 1):
        if variable.causality == "output":
            ET.SubElement(outputs, "Unknown", {"index": str(index), "dependencies": ""})
        if variable.initial == "calculated":
            ET.SubElement(unknowns, "Unknown", {"index": str(index)})
