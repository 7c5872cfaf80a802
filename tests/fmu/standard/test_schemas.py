"""Archives against the XML schemas of the standard and its rules, read from the XML alone."""

from __future__ import annotations

import zipfile
from datetime import UTC, datetime
from pathlib import Path
from xml.etree import ElementTree as ET

import fmpy
import pytest
from lxml import etree

SCHEMAS = Path(fmpy.__file__).parent / "schema"
DOCUMENTS = {
    2: {"modelDescription.xml": "fmi2/fmi2ModelDescription.xsd"},
    3: {
        "modelDescription.xml": "fmi3/fmi3ModelDescription.xsd",
        "sources/buildDescription.xml": "fmi3/fmi3BuildDescription.xsd",
        "terminalsAndIcons/terminalsAndIcons.xml": "fmi3/fmi3TerminalsAndIcons.xsd",
    },
}
EACH = [(2, 0), (2, 1), (3, 0), (3, 1)]
each = pytest.mark.parametrize(("fmi", "index"), EACH)


def entry(path: Path, name: str) -> bytes:
    with zipfile.ZipFile(path) as archive:
        return archive.read(name)


def findings(fmi: int, document: str, text: bytes) -> list[str]:
    schema = etree.XMLSchema(file=str(SCHEMAS / DOCUMENTS[fmi][document]))
    schema.validate(etree.fromstring(text))
    return [f"{e.line}: {e.message}" for e in schema.error_log]


@pytest.mark.parametrize(
    ("fmi", "index", "document"), [(*pair, d) for pair in EACH for d in DOCUMENTS[pair[0]]]
)
def test_schema_has_no_finding(native_fmus, fmi: int, index: int, document: str) -> None:
    text = entry(native_fmus[fmi][index], document)
    assert findings(fmi, document, text) == []
    # a schema that never finds anything would prove nothing
    assert findings(fmi, document, text.replace(b" fmiVersion=", b" wrong=")) != []


@pytest.mark.parametrize("index", [0, 1])
def test_python_backend_meets_the_schema(fmus, index: int) -> None:
    document = "modelDescription.xml"
    assert findings(2, document, entry(fmus[index], document)) == []


class Description:
    """What both versions say, in one form; unknowns are known by their value references."""

    def __init__(self, path: Path) -> None:
        self.root = ET.fromstring(entry(path, "modelDescription.xml"))
        self.three = self.root.get("fmiVersion") != "2.0"
        self.variables = list(self.root.find("ModelVariables"))
        self.by_reference = {v.get("valueReference"): v for v in self.variables}

    def attribute(self, variable: ET.Element, name: str) -> str | None:
        """Of the variable, or in FMI 2 of its type element."""
        return variable.get(name) or (None if self.three else variable[0].get(name))

    def initial(self, variable: ET.Element) -> str | None:
        """With the standard's defaults."""
        if variable.get("causality") in ("input", "independent"):
            return None
        calculated = variable.get("causality") in ("output", "local", "calculatedParameter")
        return variable.get("initial") or ("calculated" if calculated else "exact")

    def listed(self, kind: str) -> list[str]:
        """References of a list in ModelStructure."""
        if self.three:
            return [u.get("valueReference") for u in self.root.findall(f"ModelStructure/{kind}")]
        lists = {"Output": "Outputs", "ContinuousStateDerivative": "Derivatives",
                 "InitialUnknown": "InitialUnknowns"}
        found = self.root.findall(f"ModelStructure/{lists[kind]}/Unknown")
        return [self.variables[int(u.get("index")) - 1].get("valueReference") for u in found]

    def states(self) -> dict[str, str]:
        """References of derivatives, and of their states."""
        found = {}
        for variable in self.variables:
            state = self.attribute(variable, "derivative")
            if state is not None:
                target = self.by_reference[state] if self.three else self.variables[int(state) - 1]
                found[variable.get("valueReference")] = target.get("valueReference")
        return found


@each
def test_structure_lists_all_and_nothing_else(native_fmus, fmi: int, index: int) -> None:
    found = Description(native_fmus[fmi][index])
    assert len(found.by_reference) == len(found.variables)
    outputs = [r for r, v in found.by_reference.items() if v.get("causality") == "output"]
    states = found.states()
    assert found.listed("Output") == outputs
    assert sorted(found.listed("ContinuousStateDerivative")) == sorted(states)
    # ten of the crane, three deflections of friction, three energies
    assert len(states) == (0 if index == 0 else 16)
    involved = {*outputs, *states, *states.values()}
    unknown = {
        r for r, v in found.by_reference.items()
        if found.initial(v) in ("calculated", "approx")
        and (r in involved or v.get("causality") == "calculatedParameter")
    }
    listed = found.listed("InitialUnknown")
    assert len(set(listed)) == len(listed) and set(listed) == unknown


@each
def test_starts_are_where_the_standard_wants_them(native_fmus, fmi: int, index: int) -> None:
    found = Description(native_fmus[fmi][index])
    for variable in found.variables:
        start = found.attribute(variable, "start")
        wanted = variable.get("causality") in ("input", "parameter", "structuralParameter")
        wanted = wanted or found.initial(variable) == "exact"
        assert (start is not None) == wanted, variable.get("name")


@each
def test_date_is_utc_and_attributes_are_those_of_an_importer(
    native_fmus, fmi: int, index: int
) -> None:
    root = Description(native_fmus[fmi][index]).root
    date = root.get("generationDateAndTime")
    assert date.endswith("Z")
    assert datetime.strptime(date, "%Y-%m-%dT%H:%M:%SZ").replace(tzinfo=UTC) < datetime.now(UTC)
    for name in ("ModelExchange", "CoSimulation"):
        element = root.find(name)
        assert element.get("needsExecutionTool", "false") == "false"
        assert element.get("canBeInstantiatedOnlyOncePerProcess", "false") == "false"
        identifier = element.get("modelIdentifier")
        assert identifier == root.get("modelName") and identifier.isidentifier()


def test_terminals_fit_together(native_fmus) -> None:
    """The crane's terminal has no member that the feedforward's has not."""
    members = []
    for path in native_fmus[3]:
        root = ET.fromstring(entry(path, "terminalsAndIcons/terminalsAndIcons.xml"))
        names = {v.get("name") for v in Description(path).variables}
        found = [m.get("variableName") for m in root.iter("TerminalMemberVariable")]
        assert set(found) <= names and len(set(found)) == len(found)
        members.append({m.get("memberName") for m in root.iter("TerminalMemberVariable")})
    assert members[1] <= members[0]
