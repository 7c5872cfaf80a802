"""modelDescription.xml, buildDescription.xml and terminals of FMI 3.0 from a specification."""

from __future__ import annotations

from collections.abc import Iterable
from xml.etree import ElementTree as ET

from segfmu.fmu.standard.fmi2 import (
    CATEGORIES,
    GENERATED,
    details,
    document,
    experiment,
    initial_unknowns,
    text,
)
from segfmu.fmu.standard.identity import guid
from segfmu.fmu.standard.references import Entry, entries
from segfmu.fmu.standard.spec import Array, Spec, Terminal, Variable
from segfmu.fmu.standard.units import unit_definitions

TYPES = {
    "Real": "Float64", "Integer": "Int32", "Boolean": "Boolean", "Enumeration": "Enumeration"
}


def model_description(spec: Spec, version: str) -> bytes:
    """The XML text of modelDescription.xml."""
    root = ET.Element(
        "fmiModelDescription",
        {
            "fmiVersion": "3.0",
            "modelName": spec.name,
            "instantiationToken": guid(spec),
            "description": spec.description,
            "version": version,
            "license": "MIT",
            "generationTool": f"segfmu {version}",
            "generationDateAndTime": GENERATED,
            "variableNamingConvention": "structured",
        },
    )
    _interfaces(root, spec)
    unit_definitions(root, spec)
    _types(root, spec)
    categories = ET.SubElement(root, "LogCategories")
    for name, description in CATEGORIES.items():
        ET.SubElement(categories, "Category", {"name": name, "description": description})
    ET.SubElement(root, "DefaultExperiment", experiment(spec))
    rows = entries(spec, 3)
    references = {e.variable.name: i for i, e in enumerate(rows, 1)}
    variables = ET.SubElement(root, "ModelVariables")
    for entry in rows:
        variables.append(_variable(entry, spec, references))
    _structure(root, spec, references)
    return document(root)


def build_description(spec: Spec, sources: tuple[str, ...]) -> bytes:
    """The XML text of sources/buildDescription.xml."""
    root = ET.Element("fmiBuildDescription", {"fmiVersion": "3.0"})
    build = ET.SubElement(root, "BuildConfiguration", {"modelIdentifier": spec.name})
    files = ET.SubElement(build, "SourceFileSet", {"language": "C99"})
    for source in sources:
        ET.SubElement(files, "SourceFile", {"name": source})
    return document(root)


def terminals(spec: Spec) -> bytes:
    """The XML text of terminalsAndIcons.xml."""
    root = ET.Element("fmiTerminalsAndIcons", {"fmiVersion": "3.0"})
    box = {"x1": "-100", "y1": "-100", "x2": "100", "y2": "100"}
    graphic = ET.SubElement(root, "GraphicalRepresentation")
    ET.SubElement(graphic, "CoordinateSystem", box | {"suggestedScalingFactorTo_mm": "0.1"})
    ET.SubElement(graphic, "Icon", box)
    if spec.terminals:
        buses = ET.SubElement(root, "Terminals")
        for terminal in spec.terminals:
            _terminal(buses, terminal, spec)
    return document(root)


def _terminal(parent: ET.Element, terminal: Terminal, spec: Spec) -> None:
    bus = ET.SubElement(
        parent, "Terminal",
        {
            "name": terminal.name, "matchingRule": "bus", "description": terminal.description,
        },
    )
    for v in spec.where("input", "output"):
        if v.name.split(".")[0] in terminal.words:
            ET.SubElement(
                bus, "TerminalMemberVariable",
                {"variableName": v.name, "memberName": v.name, "variableKind": "signal"},
            )


def _interfaces(root: ET.Element, spec: Spec) -> None:
    common = {
        "modelIdentifier": spec.name, "canGetAndSetFMUState": "true",
        "canSerializeFMUState": "true",
    }
    partials = {"providesDirectionalDerivatives": "true", "providesAdjointDerivatives": "true"}
    accepts = {"needsCompletedIntegratorStep": "true"} if spec.states else {}
    if "ModelExchange" in spec.partials:
        accepts |= partials
    ET.SubElement(root, "ModelExchange", common | accepts)
    steps = {
        "canHandleVariableCommunicationStepSize": "true",
        "maxOutputDerivativeOrder": str(spec.orders), "providesIntermediateUpdate": "true",
        "mightReturnEarlyFromDoStep": "true", "canReturnEarlyAfterIntermediateUpdate": "true",
        "hasEventMode": "true",
    }
    if "CoSimulation" in spec.partials:
        steps |= partials
    ET.SubElement(root, "CoSimulation", common | steps)


def _types(root: ET.Element, spec: Spec) -> None:
    if not spec.enumerations:
        return
    definitions = ET.SubElement(root, "TypeDefinitions")
    for enumeration in spec.enumerations:
        kind = ET.SubElement(
            definitions, "EnumerationType",
            {"name": enumeration.name, "description": enumeration.description},
        )
        for value, name in enumerate(enumeration.items, 1):
            ET.SubElement(kind, "Item", {"name": name, "value": str(value)})


def _variable(entry: Entry, spec: Spec, references: dict[str, int]) -> ET.Element:
    v = entry.variable
    attributes = {
        "name": entry.name,
        "valueReference": str(references[v.name]),
        "description": entry.description,
        "causality": v.causality,
        "variability": v.variability,
    }
    if v.initial is not None:
        attributes["initial"] = v.initial
    attributes |= details(v)
    state = {rate: state for state, rate in spec.states}.get(v.name)
    if state is not None:
        attributes["derivative"] = str(references[state])
    element = ET.Element(TYPES[v.kind], attributes)
    if entry.array is not None:
        element.set("start", starts(entry.array, spec))
        for size in entry.shape:
            ET.SubElement(element, "Dimension", {"start": str(size)})
    return element


def starts(array: Array, spec: Spec) -> str:
    """Start values of all rows, as XML has them."""
    members = [spec.variable(n) for n in array.members]
    return " ".join(text(v, v.start or 0.0) for v in members)


def _structure(root: ET.Element, spec: Spec, references: dict[str, int]) -> None:
    structure = ET.SubElement(root, "ModelStructure")
    known = dict(spec.dependencies)

    def unknown(kind: str, name: str, knowns: Iterable[str]) -> None:
        listed = sorted(references[n] for n in knowns)
        ET.SubElement(
            structure, kind,
            {
                "valueReference": str(references[name]),
                "dependencies": " ".join(map(str, listed)),
            },
        )

    for variable in spec.where("output"):
        unknown("Output", variable.name, known.get(variable.name, ()))
    for _, rate in spec.states:
        unknown("ContinuousStateDerivative", rate, known.get(rate, ()))
    # all but time, as where nothing is said; CasADi wants it said
    given = [v.name for v in spec.variables if v.name in references and _given(v)]
    for name in initial_unknowns(spec):
        timely = [n for n in known.get(name, ()) if spec.variable(n).causality == "independent"]
        unknown("InitialUnknown", name, [*given, *timely])


def _given(variable: Variable) -> bool:
    """Whether a variable is known in initialisation mode; time aside."""
    return variable.causality == "input" or variable.initial == "exact"
