"""Native archives: what checkers say of them, what they contain, and what they export."""

from __future__ import annotations

import ctypes
import re
import zipfile
from pathlib import Path
from xml.etree import ElementTree as ET

import fmpy
import pytest
from fmpy import read_model_description
from lxml import etree

from segfmu.fmu.gantry_crane import interface as gantry_crane
from segfmu.fmu.gantry_feedforward import interface as gantry_feedforward
from segfmu.fmu.native import archive as native
from segfmu.fmu.native import tables
from segfmu.fmu.python import slave
from segfmu.fmu.standard import times
from tests.fmu.checking import faults
from tests.fmu.native.importer import Importer

SPECS = (gantry_feedforward.native_spec(), gantry_crane.native_spec())
HEADERS = Path(native.__file__).parent / "c" / "fmi"

each = pytest.mark.parametrize(("fmi", "index"), [(2, 0), (2, 1), (3, 0), (3, 1)])


@each
def test_fmpy_finds_nothing(native_fmus, fmi: int, index: int) -> None:
    assert faults(native_fmus[fmi][index]) == []


@each
def test_the_checker_of_the_manipulation_toolbox_finds_nothing(
    native_fmus, fmi: int, index: int, caplog
) -> None:
    toolbox = pytest.importorskip("fmu_manipulation_toolbox.operations")
    checker = pytest.importorskip("fmu_manipulation_toolbox.checker")
    fmu = toolbox.FMU(str(native_fmus[fmi][index]))
    for check in checker.get_checkers():
        fmu.apply_operation(check())
    assert [r.message for r in caplog.records if r.levelname in ("WARNING", "ERROR")] == []


@each
def test_archive_is_complete(native_fmus, fmi: int, index: int) -> None:
    spec = SPECS[index]
    with zipfile.ZipFile(native_fmus[fmi][index]) as archive:
        names = archive.namelist()
        root = ET.fromstring(archive.read("modelDescription.xml"))
        page = archive.read("documentation/index.html").decode()
    assert len(names) == len(set(names)) and names == sorted(names)
    assert "documentation/licenses/license.txt" in names
    assert any(n.startswith("binaries/") for n in names)
    assert all(v.name in page for v in spec.variables if v.causality != "independent")
    assert re.fullmatch(r"\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ", root.get("generationDateAndTime"))
    assert [e.tag for e in root[:2]] == ["ModelExchange", "CoSimulation"]
    if fmi == 2:
        listed = [f.get("name") for f in root[0].findall("SourceFiles/File")]
        assert listed == [f.get("name") for f in root[1].findall("SourceFiles/File")]
    else:
        build = ET.fromstring(zipfile.ZipFile(native_fmus[3][index]).read(
            "sources/buildDescription.xml"
        ))
        listed = [f.get("name") for f in build.iter("SourceFile")]
        assert "terminalsAndIcons/terminalsAndIcons.xml" in names
    assert listed == ["fmu.c"] and "sources/fmu.c" in names


@each
def test_model_structure_is_complete(native_fmus, fmi: int, index: int) -> None:
    found = read_model_description(str(native_fmus[fmi][index]))
    variables = {v.name: v for v in found.modelVariables}
    outputs = {v.name for v in variables.values() if v.causality == "output"}
    assert {u.variable.name for u in found.outputs} == outputs
    derivatives = [(u.variable.derivative.name, u.variable.name) for u in found.derivatives]
    assert derivatives == list(SPECS[index].states)
    assert all(variables[rate].causality == "local" for _, rate in derivatives)
    references = [v.valueReference for v in found.modelVariables]
    assert len(set(references)) == len(references)


@each
def test_all_functions_of_the_standard_are_exported(
    native_fmus, fmi: int, index: int, tmp_path: Path
) -> None:
    header = (HEADERS / f"fmi{fmi}Functions.h").read_text()
    names = re.findall(rf"FMI{fmi}_Export fmi\w+TYPE\s+(fmi\w+);", header)
    assert len(names) == {2: 44, 3: 75}[fmi]
    with zipfile.ZipFile(native_fmus[fmi][index]) as archive:
        binary = next(n for n in archive.namelist() if n.startswith("binaries/"))
        library = ctypes.CDLL(archive.extract(binary, tmp_path))
    for name in names:
        assert hasattr(library, name), name
    for name in ("segfmu_plan_phases", "model_evaluate", "glue_create"):
        assert not hasattr(library, name)


@pytest.mark.parametrize("fmi", [2, 3])
def test_same_input_same_bytes(native_fmus, fmi: int, tmp_path: Path) -> None:
    again = native.build_all(SPECS[:1], tmp_path, fmi=fmi)
    assert again[0].read_bytes() == native_fmus[fmi][0].read_bytes()


@pytest.mark.parametrize("fmi", [2, 3])
def test_what_a_run_needs_is_that_of_the_whole(native_fmus, fmi: int, tmp_path: Path) -> None:
    path, = native.build_all(SPECS[:1], tmp_path, fmi=fmi, whole=False)
    with zipfile.ZipFile(path) as part, zipfile.ZipFile(native_fmus[fmi][0]) as whole:
        names = part.namelist()
        assert [n for n in names if part.read(n) != whole.read(n)] == []
        tops = {n.split("/")[0] for n in names}
        assert tops == {"binaries", "modelDescription.xml", "resources"}
    with Importer(path) as fmu:
        fmu.initialise()
        fmu.step(0.0, 0.1)


def test_waypoints_are_arrays_of_fmi3(native_fmus) -> None:
    found = read_model_description(str(native_fmus[3][0]))
    variables = {v.name: v for v in found.modelVariables}
    assert variables["waypoint.count"].causality == "parameter"
    assert [d.start for d in variables["waypoint.position"].dimensions] == [16, 3]
    assert variables["waypoint.position"].start.split() == [
        "0.0", "0.0", "-0.5", "0.07", "0.055", "-0.5", *["1.0", "0.8", "-0.5"] * 14
    ]
    assert "waypoint[1].position.x" not in variables


def test_both_backends_have_the_same_times_from_one_place() -> None:
    text = tables.header(SPECS[0], 3)
    for name in ("SAME", "REPEATED", "ROUNDING", "LATEST"):
        assert f"#define {name} {getattr(times, name)!r}\n" in text
        assert getattr(slave, name) is getattr(times, name)
        for source in HEADERS.parent.glob("*.[ch]"):
            given = rf"(#define|double) {name}\b"
            assert not re.search(given, source.read_text(encoding="utf-8")), source


def test_places_of_values_do_not_overlap() -> None:
    for spec in SPECS:
        placed = tables.layout(spec)
        shared = {v.name: v.same_as for v in spec.variables if v.same_as}
        for name, other in shared.items():
            assert placed.offsets.pop(name) == placed.offsets[other]
        real = {v.name for v in spec.variables if v.kind == "Real" and v.name not in shared}
        assert sorted(placed.offsets[n] for n in real) == list(range(len(placed.reals)))
        rest = placed.offsets.keys() - real
        assert sorted(placed.offsets[n] for n in rest) == list(range(len(placed.integers)))
        for array in spec.arrays:
            places = [placed.offsets[n] for n in array.members]
            assert places == list(range(places[0], places[0] + len(places)))
        for i, variable in enumerate(spec.signals):
            assert placed.offsets[variable.name] == i


@pytest.mark.parametrize("index", [0, 1])
@pytest.mark.parametrize(
    ("name", "schema"),
    [
        ("modelDescription.xml", "fmi3ModelDescription.xsd"),
        ("sources/buildDescription.xml", "fmi3BuildDescription.xsd"),
        ("terminalsAndIcons/terminalsAndIcons.xml", "fmi3TerminalsAndIcons.xsd"),
    ],
)
def test_schemas_of_fmi3(native_fmus, index: int, name: str, schema: str) -> None:
    folder = Path(fmpy.__file__).parent / "schema" / "fmi3"
    judge = etree.XMLSchema(etree.parse(str(folder / schema)))
    with zipfile.ZipFile(native_fmus[3][index]) as archive:
        document = etree.fromstring(archive.read(name))
    assert judge.validate(document), judge.error_log
