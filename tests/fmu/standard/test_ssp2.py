"""mission.ssp of FMI 3.0: schemas of SSP 2.0, agreement with the FMUs, and a run as it says."""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from contextlib import ExitStack
from dataclasses import replace
from pathlib import Path
from typing import Any
from xml.etree import ElementTree as ET

import numpy as np
import pytest

from segfmu.cosim import simulate
from segfmu.fmu.gantry_crane import interface as gantry_crane
from segfmu.fmu.gantry_feedforward import interface as gantry_feedforward
from segfmu.fmu.pairs import GANTRY
from segfmu.fmu.standard.spec import started
from segfmu.fmu.standard.system import LEAD
from segfmu.fmu.system import write_system
from tests.fmu.native.importer import Importer
from tests.fmu.standard.packages import DOCUMENTS, entries_of, findings, variables_of
from tests.fmu.standard.test_system import SSC, SSD, SSV

SCHEMAS = Path(__file__).parents[2] / "data" / "ssp2"
STEP, STOP = 0.002, 1.2
# values that the archives do not have, of every type and of an array
CHANGED: tuple[dict[str, Any], dict[str, Any]] = (
    {"waypoint.count": 2, "waypoint[2].position.x": 0.4, "waypoint[2].position.y": 0.1,
     **{f"waypoint[2].{q}.{a}": 0.0 for q in ("velocity", "acceleration") for a in "xyz"},
     "planner.smoothness": 5, "planner.shape": "smoothstep", "limits.x.velocity": 0.3},
    {"crane.payload_mass": 1.2, "feedback.enabled": False, "feedback.design": "flatness",
     "wind.gust.start": 0.2, "wind.gust.duration": 0.5, "wind.gust.force.x": 0.4},
)


@pytest.fixture(scope="module")
def folder(native_fmus, tmp_path_factory: pytest.TempPathFactory) -> Path:
    target = tmp_path_factory.mktemp("system")
    archives = [Path(shutil.copy(p, target)) for p in native_fmus[3]]
    specs = [
        replace(started(m.spec(), values), stop_time=STOP, step_size=STEP)
        for m, values in zip((gantry_feedforward, gantry_crane), CHANGED, strict=True)
    ]
    written = write_system(target, archives, specs, "a mission", fmi=3)
    assert [p.name for p in written] == ["mission.ssp"]
    assert sorted(p.name for p in target.iterdir()) == [
        "GantryCrane.fmu", "GantryFeedforward.fmu", "mission.ssp"
    ]
    return target


@pytest.fixture(scope="module")
def entries(folder) -> dict[str, bytes]:
    return entries_of(folder / "mission.ssp")


@pytest.fixture(scope="module")
def described(native_fmus) -> dict[str, dict]:
    return variables_of(native_fmus[3])


@pytest.mark.parametrize("document", DOCUMENTS)
def test_schema_has_no_finding(entries, document: str) -> None:
    text = entries[document]
    assert findings(SCHEMAS, document, text) == [] and b'version="2.0"' in text
    # a schema that never finds anything would prove nothing
    other = text.replace(b'version="2.0" name', b'version="3.0" name')
    assert findings(SCHEMAS, document, other) != []
    assert findings(SCHEMAS, document, text.replace(b" description=", b" remark=")) != []


def test_package_has_both_archives_and_nothing_unnamed(entries, native_fmus) -> None:
    archives = {f"resources/{p.name}": p.read_bytes() for p in native_fmus[3]}
    assert entries.keys() == archives.keys() | DOCUMENTS.keys()
    assert all(entries[n] == content for n, content in archives.items())


def sizes(element: ET.Element) -> list[int]:
    return [int(d.get("size")) for d in element.iter(f"{SSC}Dimension")]


def test_connectors_have_the_types_of_fmi3(entries, described) -> None:
    root = ET.fromstring(entries["SystemStructure.ssd"])
    units = {u.get("name") for u in root.iter(f"{SSC}Unit")}
    kinds = set()
    for component in root.iter(f"{SSD}Component"):
        variables = described[component.get("name")]
        connectors = {c.get("name"): c for c in component.iter(f"{SSD}Connector")}
        for name, connector in connectors.items():
            variable = variables[name]
            assert connector.get("kind") == variable.causality
            assert connector[0].tag == SSC + variable.type
            assert connector[0].get("unit") == variable.unit
            assert variable.unit is None or variable.unit in units
            assert sizes(connector) == [d.start for d in variable.dimensions]
            kinds.add((variable.type, len(variable.dimensions)))
        assert {n for n, c in connectors.items() if c.get("kind") in ("input", "output")} == {
            n for n, v in variables.items() if v.causality in ("input", "output")
        }
    assert kinds == {
        ("Float64", 0), ("Float64", 1), ("Float64", 2), ("Int32", 0), ("Boolean", 0),
        ("Boolean", 1), ("Boolean", 2),
    }


def sets(entries: dict[str, bytes]) -> Iterator[tuple[str, ET.Element]]:
    """Names of components, and the parameters that are bound to them or, by prefix, at the root."""
    root = ET.fromstring(entries["SystemStructure.ssd"])

    def bound(element: ET.Element) -> Iterator[ET.Element]:
        for binding in element.findall(f"{SSD}ParameterBindings/{SSD}ParameterBinding"):
            yield from ET.fromstring(entries[binding.get("source")]).iter(f"{SSV}Parameter")

    for component in root.iter(f"{SSD}Component"):
        for entry in bound(component):
            yield component.get("name"), entry
    for entry in bound(root.find(f"{SSD}System")):
        component, _, name = entry.get("name").partition(".")
        yield component, replaced(entry, name)


def replaced(entry: ET.Element, name: str) -> ET.Element:
    entry.set("name", name)
    return entry


def test_parameters_fit_the_variables(entries, described) -> None:
    found = {(name, e.get("name")): e for name, e in sets(entries)}
    assert ("GantryFeedforward", "waypoint.position") in found
    assert not any(name.startswith("waypoint[") for _, name in found)
    # those that were computed are in the FMU
    assert not any(described[c][n].dimensions for c, n in found if c == "GantryCrane")
    for (component, name), entry in found.items():
        variable = described[component][name]
        assert variable.causality == "parameter" and entry[0].tag == SSV + variable.type
        assert entry[0].get("unit") == variable.unit
        shape = [d.start for d in variable.dimensions]
        assert sizes(entry) == shape
        assert len(entry[0].get("value").split()) == int(np.prod(shape))


def value(variable: Any, text: str) -> Any:
    if variable.type == "Boolean":
        return [word == "true" for word in text.split()]
    return text if variable.type == "Enumeration" else [float(x) for x in text.split()]


def test_a_run_as_the_package_says(folder, entries, native_fmus) -> None:
    """Every parameter set by its name, connections passed on in parallel; against our master with
    the FMUs of FMI 2.0."""
    root = ET.fromstring(entries["SystemStructure.ssd"])
    with ExitStack() as stack:
        fmus = {n: stack.enter_context(Importer(folder / f"{n}.fmu")) for n in GANTRY.names}
        for name, entry in sets(entries):
            fmu = fmus[name]
            variable = fmu.variables[entry.get("name")]
            given = value(variable, entry[0].get("value"))
            if variable.type == "Int32":
                given = int(given[0])
            fmu.set({variable.name: given})
        ends = [
            [c.get(n) for n in ("startElement", "startConnector", "endElement", "endConnector")]
            for c in root.iter(f"{SSD}Connection")
        ]
        assert len(ends) == 19
        source, sink = fmus[ends[0][0]], fmus[ends[0][2]]
        signals = tuple(e[1] for e in ends)
        source.begin()
        sink.begin()
        sink.write(tuple(e[3] for e in ends), source.get(*signals))
        source.fmu.exitInitializationMode()
        sink.fmu.exitInitializationMode()
        rows = []
        for i in range(round(STOP / STEP)):
            handed = source.get(*signals)
            sink.write(tuple(e[3] for e in ends), handed)
            source.step(i * STEP, STEP)
            sink.step(i * STEP, STEP)
            rows.append(sink.get(*(f"load.position.{a}" for a in "xyz")))
    values = (CHANGED[0] | {LEAD: STEP}, CHANGED[1])
    expected = simulate(
        *native_fmus[2], stop_time=STOP, step=STEP, source_values=values[0],
        sink_values=values[1], coupling="parallel", events=False,
    )
    load = np.array([expected[f"load.position.{a}"][1:] for a in "xyz"]).T
    assert np.abs(np.array(rows) - load).max() <= 1e-9
    assert np.ptp(load, axis=0)[0] > 0.1
