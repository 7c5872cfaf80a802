"""What commands print with --json, judged by the printed schemas and by other sources."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from math import inf, nan
from pathlib import Path
from typing import Any

import jsonschema
import numpy as np
import pytest

import segfmu
from segfmu.validation.documents.document import Value, refusal, text
from segfmu.validation.documents.schema import DOCUMENTS, document_schema
from segfmu.validation.documents.suite import Judged
from tests.command import called
from tests.compiler import needs_native
from tests.tables import columns

ROOT = Path(__file__).parents[3]
MODELS = ROOT / "models"
PAGE = (ROOT / "docs" / "howto" / "scripts.md").read_text(encoding="utf-8")
HEAD = f'name = "s"\nmission = "{(MODELS / "inteco.toml").as_posix()}"\nstep = 0.005\n'
CRITERION = '[[criteria]]\nname = "c"\nsignal = "error.load.norm"\nbound = 0.005\n'


def printed(folder: Path, *words: str) -> tuple[int, dict[str, Any], str]:
    """Exit code, document and standard error of a command with --json."""
    done = called(*words, "--json", cwd=folder)
    document = json.loads(done.stdout, parse_constant=pytest.fail)
    judge(words[0], document)
    return done.returncode, document, done.stderr


def judge(command: str, document: dict[str, Any]) -> None:
    jsonschema.Draft202012Validator(document_schema(command)).validate(document)


def objects(document: Any) -> list[dict[str, Any]]:
    """All tables of a document, itself among them."""
    if isinstance(document, list):
        return [found for entry in document for found in objects(entry)]
    if not isinstance(document, dict):
        return []
    return [document, *objects(list(document.values()))]


@pytest.mark.parametrize("kind", DOCUMENTS)
def test_schemas_are_printed(kind: str, tmp_path: Path) -> None:
    done = called("schema", kind, cwd=tmp_path)
    assert done.returncode == 0
    found = json.loads(done.stdout)
    assert found == document_schema(kind)
    jsonschema.Draft202012Validator.check_schema(found)


@pytest.mark.parametrize("command", DOCUMENTS)
def test_every_key_says_what_it_is(command: str) -> None:
    for name, part in document_schema(command)["$defs"].items():
        assert part["required"] == list(part["properties"]), name
        for key, entry in part["properties"].items():
            assert entry["description"], f"{name}.{key}"


@pytest.mark.parametrize("command", DOCUMENTS)
def test_the_page_names_every_key_of_a_document(command: str) -> None:
    parts = document_schema(command)["$defs"]
    for name in (DOCUMENTS[command].__name__, "Refusal"):
        for key in parts[name]["properties"]:
            assert f"`{key}`" in PAGE, f"{command}: {key}"


def test_a_plan_is_that_of_the_package(tmp_path: Path) -> None:
    """Of a mission with free states, without limits: the limits are found within the drives."""
    mission = MODELS / "container.toml"
    code, document, error = printed(tmp_path, "plan", str(mission), "-o", "out")
    assert (code, error) == (0, "")
    task = segfmu.load_mission(mission)
    trajectory = task.plan()
    assert document["duration_s"] == trajectory.duration
    assert document["limits_found"] and document["mission"] == task.name
    for i, point in enumerate(document["waypoints"]):
        time = point["time_s"]
        assert time == trajectory.waypoint_times[i]
        for order, key in enumerate(("position_m", "velocity_m_s", "acceleration_m_s2")):
            assert point[key] == pytest.approx(trajectory(time, order).tolist(), abs=1e-9)
    assert np.any([p["velocity_m_s"] for p in document["waypoints"]])
    times = np.linspace(0.0, trajectory.duration, 20001)
    for peak in document["peaks"]:
        order = ("velocity", "acceleration", "jerk", "snap").index(peak["quantity"]) + 1
        axis = document["axes"].index(peak["axis"])
        sampled = np.abs(trajectory(times, order)[:, axis]).max()
        assert sampled <= peak["peak"] * (1.0 + 1e-9)
        assert sampled >= 0.98 * peak["peak"]
    assert document["drives"] and all(0.0 <= u["use"] <= 1.0 + 1e-9 for u in document["drives"])
    assert {Path(name).name for name in document["files"]} == {
        p.name for p in (tmp_path / "out").iterdir()
    }


@needs_native
def test_a_run_and_a_suite_are_those_of_their_tables(tmp_path: Path) -> None:
    mission = str(MODELS / "pick_and_place.toml")
    code, document, _ = printed(tmp_path, "simulate", mission, "--step", "0.005")
    assert code == 0 and document["passed"]
    rows = columns(tmp_path / "out" / "run.csv")
    assert document["end_s"] == pytest.approx(rows["time"][-1], abs=1e-9)
    (error, sway, *_) = document["measures"]
    assert (error["unit"], sway["unit"]) == ("mm", "deg")
    assert error["value"] == pytest.approx(1e3 * rows["error.load.norm"].max(), rel=1e-6)
    bridge = document["peaks"][0]
    assert bridge["force_N"] == pytest.approx(np.abs(rows["drive.bridge.force"]).max(), rel=1e-6)
    assert all((tmp_path / name).exists() for name in document["files"])


@needs_native
def test_a_failed_verdict_is_a_result(tmp_path: Path) -> None:
    (tmp_path / "s.toml").write_text(
        HEAD + CRITERION.replace("0.005", "1e-15") + 'requirement = "R 1"\n', encoding="utf-8"
    )
    code, document, _ = printed(tmp_path, "validate", "s.toml", "-o", "out")
    assert code == 1 and document["error"] is None
    assert not document["passed"]
    (scenario,) = document["scenarios"]
    (found,) = scenario["criteria"]
    rows = columns(tmp_path / "out" / scenario["table"])
    assert found["margin"] == pytest.approx(1e-15 - rows["error.load.norm"].max(), rel=1e-6)
    assert (found["unit"], found["passed"]) == ("m", False)
    assert document["requirements"][0]["verdict"] == "fails"
    assert json.loads((tmp_path / "out" / "results.json").read_text("utf-8")) == document


@pytest.mark.parametrize(
    ("words", "code", "kind"),
    [
        (("plan", "nowhere.toml"), 2, "input"),
        (("plan", "fast.toml"), 1, "infeasible"),
        (("simulate", "fast.toml"), 1, "infeasible"),
        (("plan", "fast.toml", "--colour"), 2, "input"),
        (("validate",), 2, "input"),
        (("validate", "nowhere.toml", "-o", "taken"), 2, "input"),
    ],
)
def test_refusals_are_documents(
    words: tuple[str, ...], code: int, kind: str, tmp_path: Path
) -> None:
    (tmp_path / "taken").touch()
    crane = (MODELS / "crane_inteco.toml").as_posix()
    (tmp_path / "fast.toml").write_text(
        f'crane = "{crane}"\nduration = 0.1\n[limits]\n'
        + "".join(f"{a} = {{velocity = 0.1, acceleration = 0.1}}\n" for a in "xyz")
        + "[[waypoints]]\nposition = [0.0, 0.0, -0.5]\n"
        + "[[waypoints]]\nposition = [0.1, 0.1, -0.5]\n", encoding="utf-8",
    )
    found, document, error = printed(tmp_path, *words)
    assert found == code
    assert document["error"]["kind"] == kind
    assert error == f"segfmu: {document['error']['message']}\n"


def test_a_name_that_no_encoding_has_is_in_both(tmp_path: Path) -> None:
    done = subprocess.run(
        [sys.executable, "-m", "segfmu", "validate", "\udcff.toml", "--json"], cwd=tmp_path,
        capture_output=True, text=True, timeout=60, check=False,
    )
    assert done.returncode == 2
    document = json.loads(done.stdout)
    judge("validate", document)
    assert done.stderr == f"segfmu: {document['error']['message']}\n"


def test_the_numbers_of_a_refusal_are_those_of_the_exception() -> None:
    points = [segfmu.Waypoint([0.0, 0.0]), segfmu.Waypoint([1.0, 0.0], velocity=[0.0, 3.0])]
    with pytest.raises(segfmu.InfeasibleError) as raised:
        segfmu.plan(points, segfmu.Limits(1.0, 1.0))
    error = raised.value
    document = json.loads(text(refusal(error, str(error))))
    for command in DOCUMENTS:
        judge(command, document)
    told = document["error"]
    assert (told["axis"], told["value"], told["bound"]) == (1, 3.0, 1.0)
    assert told["message"] == str(error)


@pytest.mark.parametrize("value", [nan, inf])
def test_what_is_no_number_is_null(value: Value) -> None:
    found = Judged(name="c", kind="always", signal="s", unit=None, bound=1.0, margin=value,
                   normalised=value, passed=False)
    assert json.loads(found.model_dump_json())["margin"] is None


def test_the_schemas_find_what_is_wrong(tmp_path: Path) -> None:
    _, document, _ = printed(tmp_path, "plan", str(MODELS / "paper.toml"))
    for place, part in enumerate(objects(document)):
        for key in part:
            for wrong in (lambda found, key: found.pop(key), lambda found, key: found.update(
                {key: {"a": 1}}
            )):
                other = json.loads(json.dumps(document))
                wrong(objects(other)[place], key)
                with pytest.raises(jsonschema.ValidationError):
                    judge("plan", other)


@pytest.mark.skipif(not hasattr(os, "openpty"), reason="this system has no terminals")
def test_a_terminal_gets_the_document_alone(tmp_path: Path) -> None:
    """Progress and escapes are for people."""
    terminal, end = os.openpty()
    with subprocess.Popen(
        [sys.executable, "-m", "segfmu", "plan", str(MODELS / "paper.toml"), "--json"],
        cwd=tmp_path, stdout=end, stderr=subprocess.DEVNULL,
    ) as process:
        os.close(end)
        found = b""
        try:
            while block := os.read(terminal, 65536):
                found += block
        except OSError:
            # the end of a terminal whose process has gone
            pass
        os.close(terminal)
    assert process.returncode == 0
    judge("plan", json.loads(found))


def test_what_cannot_be_printed_is_one_line(tmp_path: Path) -> None:
    full = Path("/dev/full")
    if not full.exists():
        pytest.skip("this system has no /dev/full")
    for mission in (MODELS / "paper.toml", Path("nowhere.toml")):
        with full.open("w", encoding="utf-8") as target:
            done = subprocess.run(
                [sys.executable, "-m", "segfmu", "plan", str(mission), "--json"], cwd=tmp_path,
                stdout=target, stderr=subprocess.PIPE, text=True, timeout=60, check=False,
            )
        assert done.returncode == 2
        assert done.stderr.count("\n") == 1
