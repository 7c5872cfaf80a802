"""System Structure and Parameterization: a system of FMUs with its parameters.

It is SSP 1.0 for FMI 2.0, and SSP 2.0, which has the types and arrays of FMI 3.0, for that.
Importers know parts of the standard. Parameters are bound at their components, as libcosim and Ecos
take them nowhere else. Enumerations are bound at the system: at a component, libcosim ends the
process and Ecos refuses the file. Both find the prefixes of elements by their usual letters.
"""

from __future__ import annotations

from collections.abc import Iterable
from xml.etree import ElementTree as ET

from segfmu.fmu.standard.fmi2 import GENERATED, document
from segfmu.fmu.standard.fmi3 import TYPES
from segfmu.fmu.standard.references import Entry, entries
from segfmu.fmu.standard.spec import Enumeration, Spec, Variable
from segfmu.fmu.standard.system import System, archive, settings, values
from segfmu.fmu.standard.units import exponents, used_units

SSP = "http://ssp-standard.org/SSP1/"
NAMESPACES = {
    "xmlns:ssc": f"{SSP}SystemStructureCommon",
    "xmlns:ssv": f"{SSP}SystemStructureParameterValues",
}
DESCRIBING = {
    "xmlns:ssd": f"{SSP}SystemStructureDescription",
    "xmlns:oms": "https://raw.githubusercontent.com/OpenModelica/OMSimulator/master/schema/oms.xsd",
    "xmlns:osp": "http://opensimulationplatform.com/SSP/OSPAnnotations",
}
RESOURCES = "resources"
# Ecos applies the sets of all components that have one name.
NAME = "mission"
CHOICES = "choices"
KINDS = {"input": "input", "output": "output", "parameter": "parameter",
         "calculatedParameter": "calculatedParameter"}
# version of SSP by that of FMI
VERSIONS = {2: "1.0", 3: "2.0"}
# size of a component in a diagram, and of the space around it
WIDTH, SPACE = 200.0, 100.0
PITCH = 10.0


def files(system: System, version: str) -> dict[str, bytes]:
    """Texts of a package by their names in it; the archives go to `resources` beside them.

    `version` is that of this package.
    """
    texts = {"SystemStructure.ssd": _description(system, version)}
    for spec in system.specs:
        texts[f"{RESOURCES}/{spec.name}.ssv"] = _parameters(spec, system.fmi, version)
    texts[f"{RESOURCES}/{CHOICES}.ssv"] = _choices(system, version)
    return texts


def _made(version: str) -> dict[str, str]:
    return {"generationTool": f"segfmu {version}", "generationDateAndTime": GENERATED}


def _description(system: System, version: str) -> bytes:
    root = ET.Element(
        "ssd:SystemStructureDescription",
        DESCRIBING | NAMESPACES
        | {"version": VERSIONS[system.fmi], "name": NAME, "description": system.title}
        | _made(version),
    )
    inner = ET.SubElement(root, "ssd:System", {"name": "root", "description": system.title})
    _binding(inner, CHOICES)
    elements = ET.SubElement(inner, "ssd:Elements")
    for place, spec in enumerate(system.specs):
        _component(elements, spec, place, system.fmi)
    connections = ET.SubElement(inner, "ssd:Connections")
    for name in system.connections:
        ET.SubElement(connections, "ssd:Connection", {
            "startElement": system.source.name, "startConnector": name,
            "endElement": system.sink.name, "endConnector": name,
        })
    _step_of_omsimulator(inner, system)
    variables = [e.variable for spec in system.specs for e in _shown(spec, system.fmi)]
    _enumerations(root, "ssd", [e for spec in system.specs for e in spec.enumerations])
    _units(root, "ssd", variables)
    experiment = ET.SubElement(
        root, "ssd:DefaultExperiment",
        {"startTime": "0", "stopTime": repr(system.source.stop_time)},
    )
    if system.fmi == 2:
        _step_of_libcosim(experiment, system)
    return document(root)


def _component(parent: ET.Element, spec: Spec, place: int, fmi: int) -> None:
    component = ET.SubElement(parent, "ssd:Component", {
        "name": spec.name, "description": spec.description,
        "type": "application/x-fmu-sharedlibrary", "source": f"{RESOURCES}/{archive(spec)}",
        "implementation": "CoSimulation",
    })
    connectors = ET.SubElement(component, "ssd:Connectors")
    sides = {kind: [e.name for e in _shown(spec, fmi) if e.variable.causality == kind]
             for kind in ("input", "output")}
    for entry in _shown(spec, fmi):
        variable = entry.variable
        connector = ET.SubElement(
            connectors, "ssd:Connector",
            {"name": entry.name, "kind": KINDS[variable.causality],
             "description": entry.description},
        )
        ET.SubElement(connector, f"ssc:{_type(variable, fmi)}", _unit(variable))
        _dimensions(connector, entry)
        names = sides.get(variable.causality)
        if names:
            y = (names.index(entry.name) + 0.5) / len(names)
            x = "0" if variable.causality == "input" else "1"
            ET.SubElement(connector, "ssd:ConnectorGeometry", {"x": x, "y": repr(y)})
    left = SPACE + place * (WIDTH + SPACE)
    height = PITCH * max(map(len, sides.values()))
    corners = {"x1": left, "y1": SPACE, "x2": left + WIDTH, "y2": SPACE + height}
    ET.SubElement(component, "ssd:ElementGeometry", {k: repr(v) for k, v in corners.items()})
    _binding(component, spec.name)


def _shown(spec: Spec, fmi: int) -> list[Entry]:
    """Variables that are connectors: a component needs not have all, and libcosim has no
    enumerations."""
    given = {e.name for e, _ in settings(spec, fmi)}
    return [
        e for e in entries(spec, fmi)
        if e.variable.kind != "Enumeration" and e.variable.causality in KINDS
        and (e.variable.causality != "parameter" or e.name in given)
    ]


def _type(variable: Variable, fmi: int) -> str:
    return variable.kind if fmi == 2 else TYPES[variable.kind]


def _dimensions(parent: ET.Element, entry: Entry) -> None:
    for size in entry.shape:
        ET.SubElement(parent, "ssc:Dimension", {"size": str(size)})


def _unit(variable: Variable) -> dict[str, str]:
    return {} if variable.unit is None else {"unit": variable.unit}


def _binding(parent: ET.Element, name: str) -> None:
    bindings = ET.SubElement(parent, "ssd:ParameterBindings")
    ET.SubElement(bindings, "ssd:ParameterBinding", {
        "type": "application/x-ssp-parameter-set", "source": f"{RESOURCES}/{name}.ssv",
    })


def _annotation(parent: ET.Element, kind: str) -> ET.Element:
    annotations = ET.SubElement(parent, "ssd:Annotations")
    return ET.SubElement(annotations, "ssc:Annotation", {"type": kind})


def _step_of_omsimulator(parent: ET.Element, system: System) -> None:
    """SSP has no communication step; without this, OMSimulator takes 0.1 s."""
    own = ET.SubElement(_annotation(parent, "org.openmodelica"), "oms:Annotations")
    information = ET.SubElement(own, "oms:SimulationInformation")
    ET.SubElement(information, "oms:FixedStepMaster", {
        "description": "oms-ma", "stepSize": repr(system.source.step_size),
        "absoluteTolerance": "1e-8", "relativeTolerance": "1e-8",
    })


def _step_of_libcosim(parent: ET.Element, system: System) -> None:
    """Without this, libcosim runs the package only where it is told a step."""
    algorithm = ET.SubElement(_annotation(parent, "com.opensimulationplatform"), "osp:Algorithm")
    step = {"baseStepSize": repr(system.source.step_size)}
    ET.SubElement(algorithm, "osp:FixedStepAlgorithm", step)


def _set(name: str, fmi: int, version: str, description: str) -> tuple[ET.Element, ET.Element]:
    """A set of parameters, and the element that takes them."""
    root = ET.Element(
        "ssv:ParameterSet",
        NAMESPACES | {"version": VERSIONS[fmi], "name": name, "description": description}
        | _made(version),
    )
    return root, ET.SubElement(root, "ssv:Parameters")


def _parameters(spec: Spec, fmi: int, version: str) -> bytes:
    """Values of a component but its enumerations."""
    root, listed = _set(NAME, fmi, version, f"parameters of {spec.name}")
    given = [(e, value) for e, value in settings(spec, fmi) if e.variable.kind != "Enumeration"]
    for entry, value in given:
        element = ET.SubElement(
            listed, "ssv:Parameter", {"name": entry.name, "description": entry.description}
        )
        told = {"value": value} | _unit(entry.variable)
        ET.SubElement(element, f"ssv:{_type(entry.variable, fmi)}", told)
        _dimensions(element, entry)
    _units(root, "ssv", [e.variable for e, _ in given])
    return document(root)


def _choices(system: System, version: str) -> bytes:
    """Values of all enumerations by their names in the system."""
    root, listed = _set(CHOICES, system.fmi, version, "enumerations of all components")
    for spec in system.specs:
        for variable, value in values(spec):
            if variable.enumeration is not None:
                entry = ET.SubElement(
                    listed, "ssv:Parameter",
                    {"name": f"{spec.name}.{variable.name}", "description": variable.description},
                )
                item = variable.enumeration.items[int(value) - 1]
                told = {"value": item, "name": variable.enumeration.name}
                ET.SubElement(entry, "ssv:Enumeration", told)
    _enumerations(root, "ssv", [e for spec in system.specs for e in spec.enumerations])
    return document(root)


def _enumerations(root: ET.Element, prefix: str, found: Iterable[Enumeration]) -> None:
    unique = tuple(dict.fromkeys(found))
    if not unique:
        return
    parent = ET.SubElement(root, f"{prefix}:Enumerations")
    for one in unique:
        element = ET.SubElement(
            parent, "ssc:Enumeration", {"name": one.name, "description": one.description}
        )
        for value, name in enumerate(one.items, 1):
            ET.SubElement(element, "ssc:Item", {"name": name, "value": str(value)})


def _units(root: ET.Element, prefix: str, variables: Iterable[Variable]) -> None:
    parent = ET.SubElement(root, f"{prefix}:Units")
    for name in used_units(variables):
        unit = ET.SubElement(parent, "ssc:Unit", {"name": name})
        ET.SubElement(unit, "ssc:BaseUnit", exponents(name))
