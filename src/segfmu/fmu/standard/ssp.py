"""System Structure and Parameterization, SSP 1.0: a system of FMUs with its parameters.

Importers know parts of the standard. Parameters are bound at their components, as libcosim and Ecos
take them nowhere else. Enumerations are bound at the system: at a component, libcosim ends the
process and Ecos refuses the file. Both find the prefixes of elements by their usual letters.
"""

from __future__ import annotations

from collections.abc import Iterable
from xml.etree import ElementTree as ET

from segfmu.fmu.standard.fmi2 import GENERATED, document, text
from segfmu.fmu.standard.spec import Enumeration, Spec, Variable
from segfmu.fmu.standard.system import System, archive, values
from segfmu.fmu.standard.units import BASE_UNITS

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
# size of a component in a diagram, and of the space around it
WIDTH, SPACE = 200.0, 100.0
PITCH = 10.0


def files(system: System, version: str) -> dict[str, bytes]:
    """Texts of a package by their names in it; the archives go to `resources` beside them.

    `version` is that of this package.
    """
    texts = {"SystemStructure.ssd": _description(system, version)}
    for spec in system.specs:
        texts[f"{RESOURCES}/{spec.name}.ssv"] = _parameters(spec, version)
    texts[f"{RESOURCES}/{CHOICES}.ssv"] = _choices(system, version)
    return texts


def _made(version: str) -> dict[str, str]:
    return {"generationTool": f"segfmu {version}", "generationDateAndTime": GENERATED}


def _description(system: System, version: str) -> bytes:
    root = ET.Element(
        "ssd:SystemStructureDescription",
        DESCRIBING | NAMESPACES
        | {"version": "1.0", "name": NAME, "description": system.title} | _made(version),
    )
    inner = ET.SubElement(root, "ssd:System", {"name": "root", "description": system.title})
    _binding(inner, CHOICES)
    elements = ET.SubElement(inner, "ssd:Elements")
    for place, spec in enumerate(system.specs):
        _component(elements, spec, place)
    connections = ET.SubElement(inner, "ssd:Connections")
    for name in system.connections:
        ET.SubElement(connections, "ssd:Connection", {
            "startElement": system.source.name, "startConnector": name,
            "endElement": system.sink.name, "endConnector": name,
        })
    _step_of_omsimulator(inner, system)
    variables = [v for spec in system.specs for v in _shown(spec)]
    _enumerations(root, "ssd", [e for spec in system.specs for e in spec.enumerations])
    _units(root, "ssd", variables)
    experiment = ET.SubElement(
        root, "ssd:DefaultExperiment",
        {"startTime": "0", "stopTime": repr(system.source.stop_time)},
    )
    _step_of_libcosim(experiment, system)
    return document(root)


def _component(parent: ET.Element, spec: Spec, place: int) -> None:
    component = ET.SubElement(parent, "ssd:Component", {
        "name": spec.name, "description": spec.description,
        "type": "application/x-fmu-sharedlibrary", "source": f"{RESOURCES}/{archive(spec)}",
        "implementation": "CoSimulation",
    })
    connectors = ET.SubElement(component, "ssd:Connectors")
    sides = {kind: [v.name for v in _shown(spec) if v.causality == kind]
             for kind in ("input", "output")}
    for variable in _shown(spec):
        connector = ET.SubElement(
            connectors, "ssd:Connector",
            {"name": variable.name, "kind": KINDS[variable.causality],
             "description": variable.description},
        )
        ET.SubElement(connector, f"ssc:{variable.kind}", _unit(variable))
        names = sides.get(variable.causality)
        if names:
            y = (names.index(variable.name) + 0.5) / len(names)
            x = "0" if variable.causality == "input" else "1"
            ET.SubElement(connector, "ssd:ConnectorGeometry", {"x": x, "y": repr(y)})
    left = SPACE + place * (WIDTH + SPACE)
    height = PITCH * max(map(len, sides.values()))
    corners = {"x1": left, "y1": SPACE, "x2": left + WIDTH, "y2": SPACE + height}
    ET.SubElement(component, "ssd:ElementGeometry", {k: repr(v) for k, v in corners.items()})
    _binding(component, spec.name)


def _shown(spec: Spec) -> list[Variable]:
    """Variables that are connectors: a component needs not have all, and libcosim has no
    enumerations."""
    given = {v.name for v, _ in values(spec)}
    return [
        v for v in spec.variables
        if v.kind != "Enumeration" and v.causality in KINDS
        and (v.causality != "parameter" or v.name in given)
    ]


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
    """SSP 1.0 has no communication step; without this, OMSimulator takes 0.1 s."""
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


def _set(name: str, version: str, description: str) -> tuple[ET.Element, ET.Element]:
    """A set of parameters, and the element that takes them."""
    root = ET.Element(
        "ssv:ParameterSet",
        NAMESPACES | {"version": "1.0", "name": name, "description": description}
        | _made(version),
    )
    return root, ET.SubElement(root, "ssv:Parameters")


def _parameters(spec: Spec, version: str) -> bytes:
    """Values of a component but its enumerations."""
    root, entries = _set(NAME, version, f"parameters of {spec.name}")
    given = [(v, value) for v, value in values(spec) if v.kind != "Enumeration"]
    for variable, value in given:
        entry = ET.SubElement(
            entries, "ssv:Parameter",
            {"name": variable.name, "description": variable.description},
        )
        told = {"value": text(variable, value)} | _unit(variable)
        ET.SubElement(entry, f"ssv:{variable.kind}", told)
    _units(root, "ssv", [v for v, _ in given])
    return document(root)


def _choices(system: System, version: str) -> bytes:
    """Values of all enumerations by their names in the system."""
    root, entries = _set(CHOICES, version, "enumerations of all components")
    for spec in system.specs:
        for variable, value in values(spec):
            if variable.enumeration is not None:
                entry = ET.SubElement(
                    entries, "ssv:Parameter",
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
    used = {v.unit for v in variables if v.unit}
    parent = ET.SubElement(root, f"{prefix}:Units")
    for name in (n for n in BASE_UNITS if n in used):
        unit = ET.SubElement(parent, "ssc:Unit", {"name": name})
        ET.SubElement(unit, "ssc:BaseUnit", {k: str(v) for k, v in BASE_UNITS[name].items()})
