"""modelDescription.xml: what checkers, importers and the interface contract ask of it."""

from __future__ import annotations

import re
import zipfile
from pathlib import Path
from xml.etree import ElementTree as ET

import pytest
from fmpy import read_model_description

from segfmu.fmu.gantry_crane import interface as gantry_crane
from segfmu.fmu.gantry_feedforward import interface as gantry_feedforward
from segfmu.fmu.standard.fmi2 import model_description
from tests.fmu.checking import faults

SPECS = [gantry_feedforward.spec(), gantry_crane.spec()]


@pytest.mark.parametrize("index", [0, 1])
def test_fmpy_finds_nothing(fmus: tuple[Path, Path], index: int) -> None:
    assert faults(fmus[index]) == []


@pytest.mark.parametrize("index", [0, 1])
def test_archive_is_complete(fmus: tuple[Path, Path], index: int) -> None:
    with zipfile.ZipFile(fmus[index]) as archive:
        names = archive.namelist()
        assert archive.read("model.png").startswith(b"\x89PNG")
        page = archive.read("documentation/index.html").decode()
        assert all(v.name in page for v in SPECS[index].variables)
        assert "MIT License" in archive.read("documentation/licenses/license.txt").decode()
        assert archive.read("modelDescription.xml") == model_description(
            SPECS[index], read_model_description(str(fmus[index])).version
        )
    assert len(names) == len(set(names))


@pytest.mark.parametrize("spec", SPECS, ids=lambda s: s.name)
def test_description_by_its_own_words(spec) -> None:
    root = ET.fromstring(model_description(spec, "1.2.3"))
    variables = root.findall("ModelVariables/ScalarVariable")
    references = [v.get("valueReference") for v in variables]
    assert len(set(references)) == len(references) == len(spec.variables)
    assert re.fullmatch(r"\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ", root.get("generationDateAndTime"))
    assert root.find("CoSimulation").get("needsExecutionTool") is None
    units = {u.get("name") for u in root.findall("UnitDefinitions/Unit")}
    assert {v[0].get("unit") for v in variables if v[0].get("unit")} == units
    outputs = [i for i, v in enumerate(variables, 1) if v.get("causality") == "output"]
    listed = [int(u.get("index")) for u in root.findall("ModelStructure/Outputs/Unknown")]
    assert listed == outputs
    unknown = [
        i
        for i, v in enumerate(variables, 1)
        if v.get("causality") in ("output", "calculatedParameter")
        and v.get("initial") == "calculated"
    ]
    listed = [int(u.get("index")) for u in root.findall("ModelStructure/InitialUnknowns/Unknown")]
    assert listed == unknown
    for angle in (v for v in variables if v[0].get("unit") == "rad"):
        assert angle[0].get("displayUnit") == "deg"


def test_contract_of_names() -> None:
    feedforward, crane = ({v.name: v for v in s.variables} for s in SPECS)
    for name in (
        "force.bridge", "velocity.hoist", "reference.load.snap.z", "reference.bridge.acceleration",
        "reference.rope.length", "reference.sway.y.rate", "plan.duration", "plan.interval",
        "plan.done", "crane.rope_max", "limits.z.snap", "waypoint.count", "waypoint[16].dwell",
        "waypoint[1].acceleration.x", "planner.smoothness", "planner.shape",
        "planner.synchronization", "planner.sample_time", "planner.start_time",
    ):
        assert name in feedforward, name
    for name in (
        "force.hoist", "velocity.trolley", "reference.rope.velocity", "reference.load.position.z",
        "wind.y", "bridge.position", "sway.x.rate", "measured.rope.length", "load.velocity.z",
        "error.load.norm", "drive.hoist.force", "drive.bridge.saturated", "energy.work",
        "drive.mode", "feedback.enabled", "feedback.sample_time",
    ):
        assert name in crane, name
    for name, variable in crane.items():
        if variable.causality == "input" and not name.startswith("wind."):
            assert feedforward[name].causality == "output"
            assert feedforward[name].unit == variable.unit


def test_same_interface_same_bytes() -> None:
    for make in (gantry_feedforward.spec, gantry_crane.spec):
        assert model_description(make(), "1.0") == model_description(make(), "1.0")
