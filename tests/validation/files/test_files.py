"""What is made from the models of mission and crane files: reference page, schema, first files."""

from __future__ import annotations

import json
import subprocess
import sys
import tomllib
from collections import deque
from pathlib import Path

import jsonschema
import pytest

from segfmu import Crane, InputError, Limits, Waypoint
from segfmu.validation.files import reference, template
from segfmu.validation.files.crane_file import CraneFile
from segfmu.validation.files.keys import entries
from segfmu.validation.files.mission import Mission
from segfmu.validation.files.mission_file import load_mission
from segfmu.validation.files.schema import file_schema
from tests.command import called as segfmu
from tests.validation.files.test_crane_file import EVERYTHING

ROOT = Path(__file__).parents[3]
PAGE = ROOT / "docs" / "mission-reference.md"
FILES = sorted(ROOT.glob("models/*.toml")) + sorted(ROOT.glob("src/segfmu/validation/*/*.toml"))


def test_reference_page_is_that_of_the_models() -> None:
    assert PAGE.read_text(encoding="utf-8") == reference.page(), "run make generate"


def test_every_key_is_on_the_page_with_its_meaning() -> None:
    text = PAGE.read_text(encoding="utf-8")
    for kind in (Mission, CraneFile):
        for entry in entries(kind):
            if entry.kind is None:
                assert any(
                    line.startswith(f"| `{entry.path[-1]}` | {entry.key.unit} |")
                    and entry.key.meaning in line for line in text.splitlines()
                ), entry.path


@pytest.mark.parametrize("kind", ["mission", "crane", "scenario", "campaign"])
def test_schemas_are_schemas(kind: str, tmp_path: Path) -> None:
    printed = segfmu("schema", kind, cwd=tmp_path)
    assert printed.returncode == 0
    found = json.loads(printed.stdout)
    assert found == file_schema(kind)
    jsonschema.Draft202012Validator.check_schema(found)


def accepted(kind: str, data: dict) -> bool:
    return jsonschema.Draft202012Validator(file_schema(kind)).is_valid(data)


@pytest.mark.parametrize("path", FILES, ids=lambda p: p.stem)
def test_schemas_accept_what_is_shipped(path: Path) -> None:
    data = tomllib.loads(path.read_text(encoding="utf-8"))
    assert accepted("crane" if path.name.startswith("crane") else "mission", data)


def test_schemas_accept_every_key_and_refuse_what_the_models_refuse() -> None:
    crane = tomllib.loads(EVERYTHING)
    mission = tomllib.loads(template.mission_text())
    assert accepted("crane", crane)
    assert accepted("mission", mission | {"crane": crane, "true_crane": {"payload_mass": 1.0}})
    for changes in (
        {"payload_mas": 1.0}, {"payload_mass": "1"}, {"payload_mass": -1.0}, {"gravity": 1e9},
        {"drive": "steam"}, {"bridge": {"lag": -1.0}}, {"bridge": {"lags": 1.0}},
        {"sway_max": [1.0]}, {"wind": {"gust": {"start": 1.0}}}, {"rope_max": None},
    ):
        assert not accepted("crane", crane | changes), changes
        assert not accepted("mission", mission | {"true_crane": changes}), changes
    for name in ("waypoints", "crane"):
        assert not accepted("mission", {k: v for k, v in mission.items() if k != name})


def test_schemas_of_scenarios_and_campaigns() -> None:
    models = Path(__file__).parents[3] / "models"
    for kind in ("scenario", "campaign"):
        files = sorted((models / f"{kind}s").glob("*.toml"))
        for path in files:
            data = tomllib.loads(path.read_text(encoding="utf-8"))
            # the files of underscores are scenarios and missions that others inherit
            if "waypoints" not in data:
                assert accepted(kind if "factors" in data else "scenario", data), path
                assert not accepted(kind, data | {"crit": []}), path
        assert files
    sampling = {"name": "c", "scenarios": ["s.toml"], "sampling": {"kind": "sobol"}}
    assert accepted("campaign", sampling)
    for changes in ({"scenarios": []}, {"sampling": {"kind": "dice"}}, {"factors": [{}]}):
        assert not accepted("campaign", sampling | changes), changes


def test_descriptions_name_units() -> None:
    drive = file_schema("crane")["$defs"]["DriveTable"]["properties"]
    assert drive["acceleration_max"]["description"].endswith("[m/s2]")


def test_first_files_plan_and_pass_as_they_are(tmp_path: Path) -> None:
    done = segfmu("init", "hall", cwd=tmp_path)
    assert (done.returncode, done.stderr) == (0, "")
    assert {p.name for p in (tmp_path / "hall").iterdir()} == {"mission.toml", "crane.toml"}
    run = segfmu("simulate", "hall/mission.toml", "-o", "out", cwd=tmp_path)
    assert run.returncode == 0, run.stdout + run.stderr
    assert "passed" in run.stdout and "failed" not in run.stdout


def test_first_files_have_every_key() -> None:
    # keys of the crane are in its own file, those of waypoints in their example
    other = ("crane", "true_crane", "waypoints")
    for text, kind in ((template.crane_text(), CraneFile), (template.mission_text(), Mission)):
        lines = {line.removeprefix("# ").split(" =")[0] for line in text.splitlines()}
        for entry in entries(kind):
            if entry.kind is None and not (kind is Mission and entry.path[0] in other):
                assert entry.path[-1] in lines


def test_bounds_of_the_first_crane_are_known(tmp_path: Path) -> None:
    for path in template.write(tmp_path):
        assert path.exists()
    assert load_mission(tmp_path / "mission.toml").build_bounds() is not None


@pytest.mark.parametrize("name", ["crane.toml", "mission.toml"])
def test_files_are_never_overwritten(name: str, tmp_path: Path) -> None:
    (tmp_path / name).write_text("mine", encoding="utf-8")
    done = segfmu("init", cwd=tmp_path)
    assert done.returncode == 2 and f"{name}: is there already" in done.stderr
    assert done.stderr.count("\n") == 1
    assert [p.name for p in tmp_path.iterdir()] == [name]
    assert (tmp_path / name).read_text(encoding="utf-8") == "mine"


def test_other_kinds_have_no_schema(tmp_path: Path) -> None:
    done = segfmu("schema", "house", cwd=tmp_path)
    assert done.returncode == 2 and done.stderr.count("\n") == 1


def test_what_was_read_does_not_change_and_says_how_to_change_it() -> None:
    mission = load_mission(ROOT / "models" / "paper.toml")
    assert mission.crane.payload_mass != 5.0
    for table, name in ((mission, "smoothness"), (mission.crane, "payload_mass"), (mission, "x")):
        with pytest.raises(InputError, match=rf"^{name} cannot be set: .*load_mission\(mission"):
            setattr(table, name, 5)
    assert load_mission(mission, {"crane": {"payload_mass": 5.0}}).crane.payload_mass == 5.0


def test_waypoints_of_a_dict_are_any_sequence() -> None:
    points = [Waypoint([0.0, 0.0, -0.5]), Waypoint([0.3, 0.2, -0.5])]
    data = {"crane": Crane(2.0, 1.0, 1.0), "limits": Limits(1.0, 1.0, 2.0)}
    listed = load_mission({**data, "waypoints": points})
    for given in (iter(points), dict.fromkeys(points).keys(), deque(points)):
        assert load_mission({**data, "waypoints": given}) == listed


@pytest.mark.skipif(sys.platform == "win32", reason="files are kept small by a limit of POSIX")
def test_first_files_that_cannot_be_written_leave_none(tmp_path: Path) -> None:
    script = (
        "import resource, signal\nfrom pathlib import Path\n"
        "from segfmu.validation.files import template\n"
        "signal.signal(signal.SIGXFSZ, signal.SIG_IGN)\n"
        "resource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096))\n"
        "template.write(Path())\n"
    )
    done = subprocess.run(
        [sys.executable, "-B", "-c", script], capture_output=True, text=True, cwd=tmp_path,
        timeout=60, check=False,
    )
    assert "InputError: crane.toml: cannot be written: File too large" in done.stderr
    assert not list(tmp_path.iterdir())


def test_templates_have_the_choices_of_keys() -> None:
    """Which shapes there are was told by the error for another one."""
    text = template.mission_text() + template.crane_text()
    for key, choices in (
        ("shape", '"plateau" or "smoothstep"'), ("slack", '"error" or "free_fall"'),
        ("synchronization", '"waypoints" or "total" or "none"'), ("drive", '"force" or "velocity"'),
    ):
        lines = [line for line in text.splitlines() if line.lstrip("# ").startswith(f"{key} = ")]
        assert any(f"; {choices}; " in line for line in lines), key
