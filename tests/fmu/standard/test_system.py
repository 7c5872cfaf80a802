"""mission.ssp and OspSystemStructure.xml: schemas of SSP 1.0, and agreement with the FMUs."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from xml.etree import ElementTree as ET

import fmpy
import pytest

from segfmu.fmu.pairs import GANTRY
from segfmu.fmu.standard import osp, ssp
from segfmu.fmu.standard.spec import Spec, parameter
from segfmu.fmu.standard.system import LEAD, System, values
from segfmu.fmu.system import write_system
from tests.cosim.pair import SIGNALS, SPECS
from tests.fmu.standard.packages import DOCUMENTS, SETS, entries_of, findings, variables_of

SCHEMAS = Path(fmpy.__file__).parent / "ssp" / "schema"
SSP = "{http://ssp-standard.org/SSP1/SystemStructure%s}"
SSC, SSD, SSV = (SSP % n for n in ("Common", "Description", "ParameterValues"))
OSP = f"{{{osp.NAMESPACE}}}"


@pytest.fixture(scope="module")
def written(native_fmus, tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Path]:
    folder = tmp_path_factory.mktemp("system")
    package, structure = write_system(folder, native_fmus[2], title="a mission")
    return package, structure


@pytest.fixture(scope="module")
def entries(written) -> dict[str, bytes]:
    return entries_of(written[0])


@pytest.fixture(scope="module")
def described(native_fmus) -> dict[str, dict]:
    return variables_of(native_fmus[2])


@pytest.mark.parametrize("document", DOCUMENTS)
def test_schema_has_no_finding(entries, document: str) -> None:
    text = entries[document]
    assert findings(SCHEMAS, document, text) == []
    # a schema that never finds anything would prove nothing
    other = text.replace(b'version="1.0" name', b'version="2.0" name')
    assert findings(SCHEMAS, document, other) != []


def test_package_has_both_archives_and_nothing_unnamed(entries, native_fmus) -> None:
    archives = {f"resources/{p.name}": p.read_bytes() for p in native_fmus[2]}
    assert entries.keys() == archives.keys() | DOCUMENTS.keys()
    assert all(entries[n] == content for n, content in archives.items())


def test_equal_input_gives_equal_bytes(written, native_fmus, tmp_path) -> None:
    again = write_system(tmp_path, native_fmus[2], title="a mission")
    assert [p.read_bytes() for p in again] == [p.read_bytes() for p in written]
    assert sorted(p.name for p in tmp_path.iterdir()) == ["OspSystemStructure.xml", "mission.ssp"]


def test_connectors_are_variables_of_the_fmus(entries, described) -> None:
    root = ET.fromstring(entries["SystemStructure.ssd"])
    units = {u.get("name") for u in root.iter(f"{SSC}Unit")}
    components = list(root.iter(f"{SSD}Component"))
    assert [c.get("name") for c in components] == list(GANTRY.names)
    for component in components:
        variables = described[component.get("name")]
        connectors = list(component.iter(f"{SSD}Connector"))
        assert len({c.get("name") for c in connectors}) == len(connectors)
        for connector in connectors:
            variable = variables[connector.get("name")]
            assert connector.get("kind") == variable.causality
            assert connector[0].tag == SSC + variable.type
            assert connector[0].get("unit") == variable.unit
            assert variable.unit is None or variable.unit in units
        assert {c.get("name") for c in connectors if c.get("kind") in ("input", "output")} == {
            n for n, v in variables.items() if v.causality in ("input", "output")
        }


def test_connections_are_those_by_name(entries, written) -> None:
    root = ET.fromstring(entries["SystemStructure.ssd"])
    found = [
        tuple(c.get(n) for n in ("startElement", "startConnector", "endElement", "endConnector"))
        for c in root.iter(f"{SSD}Connection")
    ]
    assert len(SIGNALS) == 19
    assert found == [(GANTRY.names[0], n, GANTRY.names[1], n) for n in SIGNALS]
    pairs = [
        [(v.get("simulator"), v.get("name")) for v in c]
        for c in ET.parse(written[1]).iter(f"{OSP}VariableConnection")
    ]
    assert pairs == [[(GANTRY.names[0], n), (GANTRY.names[1], n)] for n in SIGNALS]


def given(entries: dict[str, bytes], name: str) -> dict[str, tuple[str, str, str | None]]:
    """Kind, value and unit of each parameter in a set."""
    root = ET.fromstring(entries[name])
    units = {u.get("name") for u in root.iter(f"{SSC}Unit")}
    found = {}
    for entry in root.iter(f"{SSV}Parameter"):
        unit = entry[0].get("unit")
        assert unit is None or unit in units
        found[entry.get("name")] = entry[0].tag.removeprefix(SSV), entry[0].get("value"), unit
    return found


@pytest.mark.parametrize("name", GANTRY.names)
def test_parameters_are_start_values_of_the_fmus(
    entries, written, described, name: str
) -> None:
    found = given(entries, f"resources/{name}.ssv")
    variables = described[name]
    for parameter_name, (kind, value, unit) in found.items():
        variable = variables[parameter_name]
        assert (variable.causality, variable.type, variable.unit) == ("parameter", kind, unit)
        if parameter_name != LEAD:
            assert variable.start == value
    simulator = next(
        s for s in ET.parse(written[1]).iter(f"{OSP}Simulator") if s.get("name") == name
    )
    initial = {v.get("variable"): v[0].get("value") for v in simulator.iter(f"{OSP}InitialValue")}
    assert initial == {n: value for n, (_, value, _) in found.items()}


def test_tables_have_the_rows_in_use_and_none_that_was_computed(entries) -> None:
    feedforward = given(entries, SETS[0])
    rows = int(feedforward["waypoint.count"][1])
    assert sum(n.startswith("waypoint[") for n in feedforward) == 16 * rows
    assert not any(n.startswith("feedback.table[") for n in given(entries, SETS[1]))


def test_enumerations_are_bound_at_the_system_alone(entries, described) -> None:
    root = ET.fromstring(entries["SystemStructure.ssd"])
    assert all(c.find(f"{SSC}Enumeration") is None for c in root.iter(f"{SSD}Connector"))
    system = root.find(f"{SSD}System/{SSD}ParameterBindings/{SSD}ParameterBinding")
    assert system.get("source") == SETS[2]
    found = given(entries, SETS[2])
    expected = {
        f"{name}.{n}": v for name, variables in described.items() for n, v in variables.items()
        if v.type == "Enumeration" and v.causality == "parameter"
    }
    assert found.keys() == expected.keys() and len(found) >= 6
    for name, (kind, value, _) in found.items():
        items = {i.value: i.name for i in expected[name].declaredType.items}
        assert (kind, value) == ("Enumeration", items[expected[name].start])


def test_default_experiment_and_step_are_those_of_the_mission(entries, written) -> None:
    spec = SPECS[GANTRY.names[0]]
    root = ET.fromstring(entries["SystemStructure.ssd"])
    experiment = root.find(f"{SSD}DefaultExperiment")
    assert float(experiment.get("stopTime")) == spec.stop_time
    steps = [e.get(n) for e in root.iter() for n in ("stepSize", "baseStepSize") if e.get(n)]
    assert [float(s) for s in steps] == [spec.step_size] * 2
    structure = ET.parse(written[1]).getroot()
    assert float(structure.findtext(f"{OSP}EndTime")) == spec.stop_time
    assert float(structure.findtext(f"{OSP}BaseStepSize")) == spec.step_size
    assert structure.findtext(f"{OSP}Algorithm") == "fixedStep"


def leading(spec: Spec) -> Spec:
    if LEAD in spec.references:
        return spec
    return replace(spec, variables=(parameter(LEAD, 0.0, "s", "shift"), *spec.variables))


def test_the_lead_is_the_step() -> None:
    """What parallel coupling needs, wherever the parameter is there."""
    source = replace(leading(SPECS[GANTRY.names[0]]), step_size=0.004)
    assert {v.name: x for v, x in values(source)}[LEAD] == 0.004
    texts = ssp.files(System("", source, SPECS[GANTRY.names[1]]), "0")
    assert given(texts, SETS[0])[LEAD] == ("Real", "0.004", "s")
