"""OspSystemStructure.xml, from which libcosim of the Open Simulation Platform runs a system."""

from __future__ import annotations

from xml.etree import ElementTree as ET

from segfmu.fmu.standard.fmi2 import document, text
from segfmu.fmu.standard.spec import Spec
from segfmu.fmu.standard.system import System, archive, values

NAMESPACE = "http://opensimulationplatform.com/MSMI/OSPSystemStructure"


def system_structure(system: System) -> bytes:
    """The text of OspSystemStructure.xml, which lies beside the archives."""
    root = ET.Element("OspSystemStructure", {"xmlns": NAMESPACE, "version": "0.1"})
    for name, content in (
        ("StartTime", "0"),
        ("EndTime", repr(system.source.stop_time)),
        ("BaseStepSize", repr(system.source.step_size)),
        ("Algorithm", "fixedStep"),
    ):
        ET.SubElement(root, name).text = content
    simulators = ET.SubElement(root, "Simulators")
    for spec in system.specs:
        _simulator(simulators, spec)
    connections = ET.SubElement(root, "Connections")
    for name in system.connections:
        connection = ET.SubElement(connections, "VariableConnection")
        for spec in system.specs:
            ET.SubElement(connection, "Variable", {"simulator": spec.name, "name": name})
    return document(root)


def _simulator(parent: ET.Element, spec: Spec) -> None:
    simulator = ET.SubElement(
        parent, "Simulator",
        {"name": spec.name, "source": archive(spec), "stepSize": repr(spec.step_size)},
    )
    initial = ET.SubElement(simulator, "InitialValues")
    for variable, value in values(spec):
        # libcosim has no enumerations; they are start values of the FMU
        if variable.kind != "Enumeration":
            entry = ET.SubElement(initial, "InitialValue", {"variable": variable.name})
            ET.SubElement(entry, variable.kind, {"value": text(variable, value)})
