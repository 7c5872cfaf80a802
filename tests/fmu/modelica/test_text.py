"""The text of the Modelica package against the specifications; needs no Modelica tool."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from segfmu.errors import BuildError
from segfmu.fmu.modelica.drawing import HALF_CONNECTOR, HALF_WIDTH, half_height, places
from segfmu.fmu.modelica.names import identifier
from segfmu.fmu.modelica.package import package, write_package
from segfmu.fmu.models import named
from segfmu.fmu.pairs import PAIRS
from segfmu.fmu.standard.spec import Spec, started

NAMES = [name for models in PAIRS for name in models.names]
COMMITTED = Path(__file__).parents[3] / "models" / "modelica" / "Segfmu"
NUMBER = re.compile(r"-?\d+\.\d+(?:e[+-]?\d+)?")
TOKEN = re.compile(r"\{[0-9a-f]{8}(?:-[0-9a-f]{4}){3}-[0-9a-f]{12}\}")


@pytest.fixture(scope="module")
def specs() -> dict[str, Spec]:
    return {name: named(name).native_spec(named(name).spec()) for name in NAMES}


@pytest.fixture(scope="module")
def texts(specs) -> dict[str, str]:
    return {n: t.decode() for n, t in package([*specs.values()]).items()}


def test_committed_package_is_that_of_the_specifications(texts) -> None:
    """But for the last digits of gains, and the token that follows from them."""
    kept = {
        p.relative_to(COMMITTED).as_posix(): p.read_text() for p in COMMITTED.rglob("*")
        if p.is_file() and "FMUs" not in p.parts
    }
    assert kept.keys() == texts.keys()
    for name, text in texts.items():
        expected, found = _parts(text), _parts(kept[name])
        assert found[0] == expected[0], f"{name}: run make generate"
        assert found[1] == pytest.approx(expected[1], rel=1e-9)


def _parts(text: str) -> tuple[str, list[float]]:
    """What lies between the numbers, and the numbers."""
    plain = re.sub(r"\s+", " ", TOKEN.sub("", text))
    return NUMBER.sub("#", plain), [float(n) for n in NUMBER.findall(plain)]


@pytest.mark.parametrize("name", NAMES)
def test_every_settable_variable_is_passed_once(specs, texts, name: str) -> None:
    spec, text = specs[name], texts[f"{name}.mo"]
    passed: list[int] = []
    for table in re.findall(r"\w+_references(?:\[[^=]*\])? = (\[.*?\]|.*?);\n", text, re.S):
        if table == "fill(0, 0)":
            continue
        if "cat(" in table:
            table = re.search(r"cat\(1, \{(.*?)\}", table, re.S)[1]
        passed += map(int, re.findall(r"(?<![\w.])\d+(?![\w.])", table))
    settable = [
        spec.references[v.name] for v in spec.variables
        if v.initial == "exact" or v.causality == "input"
    ]
    counted = {spec.references[a.rows] for a in spec.arrays}
    assert sorted(passed) == sorted(settable)
    assert counted <= set(passed)


@pytest.mark.parametrize("name", NAMES)
def test_units_and_texts_arrive(specs, texts, name: str) -> None:
    text = texts[f"{name}.mo"]
    members = {m for a in specs[name].arrays for m in a.members}
    for v in specs[name].variables:
        if v.name in members or v.causality == "independent":
            continue
        if v.same_as is not None:
            assert identifier(v.name) not in text
            continue
        own = "_start" if v.causality == "output" and v.start is not None else ""
        declared = re.search(rf"^  .* {identifier(v.name)}{own}\b.*$", text, re.M)
        assert declared is not None, v.name
        assert v.unit is None or f'unit = "{v.unit}"' in declared[0]
        assert v.description in declared[0]
        assert v.unit != "rad" or 'displayUnit = "deg"' in declared[0]


@pytest.mark.parametrize("name", NAMES)
def test_connectors_lie_at_the_edges_and_apart(specs, name: str) -> None:
    found = places(specs[name])
    ports = specs[name].where("input", "output")
    assert found.keys() == {v.name for v in ports}
    assert len(set(found.values())) == len(found)
    for v in ports:
        side = -1 if v.causality == "input" else 1
        assert found[v.name].x == side * (HALF_WIDTH + HALF_CONNECTOR)
        assert abs(found[v.name].y) <= half_height(specs[name])


@pytest.mark.parametrize(("name", "crane", "count"), [
    ("Coupled", "gantry", 19), ("HookCoupled", "crane", 23),
])
def test_both_fmus_are_connected_by_name(texts, name: str, crane: str, count: int) -> None:
    text = texts[f"{name}.mo"]
    pairs = re.findall(rf"connect\(feedforward\.(\w+), {crane}\.(\w+)\)", text)
    assert len(pairs) == count and all(a == b for a, b in pairs)


def test_cranes_with_a_hook_have_an_icon_of_their_own(texts) -> None:
    def drawn(name: str) -> str:
        return "".join(re.findall(r"^.*(?:Line|Ellipse)\(.*$", texts[f"{name}.mo"], re.M))

    assert drawn("HookCrane") == drawn("HookFeedforward") != drawn("GantryCrane")
    assert drawn("HookCrane").count("Ellipse") == drawn("GantryCrane").count("Ellipse") + 1


def test_no_line_names_a_tool(texts) -> None:
    """Nothing but the language and C: the package is for every Modelica tool."""
    for name, text in texts.items():
        assert "OpenModelica" not in text and "_OMC" not in text, name


def test_a_package_that_cannot_be_written_leaves_the_one_before(tmp_path: Path) -> None:
    write_package(tmp_path)
    kept = {p: p.read_bytes() for p in tmp_path.rglob("*") if p.is_file()}
    changed = started(named("GantryCrane").spec(), {"crane.payload_mass": 2.0})
    with pytest.raises(BuildError, match="cannot be written"):
        write_package(tmp_path, [changed], [tmp_path / "nowhere.fmu"])
    assert {p: p.read_bytes() for p in tmp_path.rglob("*") if p.is_file()} == kept
    write_package(tmp_path, [changed])
    assert {p for p in tmp_path.rglob("*") if p.is_file()} == kept.keys()
    crane = tmp_path / "Segfmu" / "GantryCrane.mo"
    assert crane.read_bytes() != kept[crane]
