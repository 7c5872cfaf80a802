"""Scenarios: margins against an independent look at the tables, refusals, runs that fail."""

from __future__ import annotations

import json
import shutil
import sys
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest

from segfmu.errors import InputError
from segfmu.validation.files.scenario_file import find, load_scenario
from segfmu.validation.suite import Runner
from tests.command import called
from tests.compiler import require_native
from tests.tables import columns

MODELS = Path(__file__).parents[2] / "models"
SUITE = MODELS / "scenarios"
HEAD = 'name = "s"\nmission = "inteco.toml"\nstep = 0.005\n'
CRITERION = '[[criteria]]\nname = "c"\nsignal = "error.load.norm"\nbound = 0.005\n'


@pytest.fixture
def place(tmp_path: Path) -> Path:
    """A folder with a mission and its crane."""
    for name in ("inteco.toml", "crane_inteco.toml", "paper.toml", "crane_lab.toml"):
        shutil.copy(MODELS / name, tmp_path)
    return tmp_path


def written(place: Path, text: str, name: str = "s.toml") -> Path:
    path = place / name
    path.write_text(text, encoding="utf-8")
    return path


DRIVES = '[[criteria]]\nname = "d"\nkind = "drives"\n'
MALFORMED = {
    "no criteria": HEAD,
    "empty criteria": HEAD + "criteria = []",
    "no name": 'mission = "inteco.toml"\n' + CRITERION,
    "no mission": 'name = "s"\n' + CRITERION,
    "missing mission": HEAD.replace("inteco", "none") + CRITERION,
    "unknown key": HEAD + "stpe = 1\n" + CRITERION,
    "not TOML": HEAD + "[[criteria",
    "missing base": 'base = "none.toml"\n' + HEAD + CRITERION,
    "own base": 'base = "s.toml"\n' + HEAD + CRITERION,
    "base no name": "base = 3\n" + HEAD + CRITERION,
    "wrong fmi": HEAD + "fmi = 1\n" + CRITERION,
    "wrong coupling": HEAD + 'coupling = "tight"\n' + CRITERION,
    "lead without parallel": HEAD + "lead = true\n" + CRITERION,
    "step of text": HEAD.replace("0.005", '"fast"') + CRITERION,
    "step of zero": HEAD.replace("0.005", "0.0") + CRITERION,
    "wrong crane": HEAD + "[crane]\nbrige_mass = 1.0\n" + CRITERION,
    "wrong true crane": HEAD + "[true_crane]\npayload_mass = -1.0\n" + CRITERION,
    "wrong controller": HEAD + '[controller]\nsource = "guess"\n' + CRITERION,
    "wrong expectation": HEAD + 'expect = "maybe"\n' + CRITERION,
    "wrong kind": HEAD + CRITERION + 'kind = "never"\n',
    "no bound": HEAD + CRITERION.replace("bound = 0.005\n", ""),
    "bound of text": HEAD + CRITERION.replace("0.005", '"small"'),
    "bound below zero": HEAD + CRITERION.replace("0.005", "-0.005"),
    "bound of no number": HEAD + CRITERION.replace("0.005", "nan"),
    "no signal": HEAD + CRITERION.replace('signal = "error.load.norm"\n', ""),
    "norm of one": HEAD + CRITERION.replace('"error.load.norm"', '["error.load.norm"]'),
    "norm of two units": HEAD + CRITERION.replace(
        '"error.load.norm"', '["error.load.norm", "sway.total"]'),
    "reference of another unit": HEAD + CRITERION + 'kind = "tube"\nreference = "sway.total"\n',
    "two of one name": HEAD + CRITERION + CRITERION,
    "key of another kind": HEAD + CRITERION + "at = 1.0\n",
    "at without time": HEAD + CRITERION + 'kind = "at"\n',
    "tube without reference": HEAD + CRITERION + 'kind = "tube"\n',
    "wrong instant": HEAD + CRITERION + 'window = ["departure", "end"]\n',
    "window of one": HEAD + CRITERION + "window = [1.0]\n",
    "negative delay": HEAD + CRITERION + 'kind = "settled"\ndelay = -1.0\n',
    "event without values": HEAD + CRITERION + "[[events]]\ntime = 1.0\n",
    "profile of two lengths": HEAD + CRITERION
    + '[[profiles]]\nvariable = "wind.x"\ntimes = [0.0, 1.0]\nvalues = [1.0]\n',
    "missing third FMU": HEAD + CRITERION + '[[fmus]]\nname = "d"\npath = "none.fmu"\n',
    "connection of three": HEAD + CRITERION
    + '[[fmus]]\nname = "d"\npath = "s.toml"\nconnections = [["a", "b", "c"]]\n',
}
# what only the FMUs can tell
REFUSED = {
    "unknown signal": HEAD + CRITERION.replace("error.load.norm", "error.load.nrm"),
    "window outside": HEAD + CRITERION + "window = [0.0, 1000.0]\n",
    "empty window": HEAD + CRITERION + 'window = ["end", "start"]\n',
    "event of no variable": HEAD + CRITERION
    + "[[events]]\ntime = 1.0\nvalues = { wnd = 1.0 }\n",
    "event of a fixed parameter": HEAD + CRITERION
    + '[[events]]\ntime = 1.0\nvalues = { "crane.gravity" = 1.0 }\n',
    "event too late": HEAD + CRITERION
    + '[[events]]\ntime = "end + 1"\nvalues = { "wind.x" = 1.0 }\n',
    "event of true for a number": HEAD + CRITERION
    + '[[events]]\ntime = 1.0\nvalues = { "wind.x" = true }\n',
    "profile back in time": HEAD + CRITERION
    + '[[profiles]]\nvariable = "wind.x"\ntimes = ["arrival", 0.5]\nvalues = [1.0, 0.0]\n',
    "parameter of no FMU": HEAD + CRITERION + "[parameters.Other]\nx = 1.0\n",
    "drives without bounds": HEAD.replace("inteco", "paper") + DRIVES,
    "missing reference": HEAD + CRITERION + 'kind = "tube"\nreference = "none.csv"\n',
}


@pytest.mark.parametrize("name", MALFORMED)
def test_malformed_files_are_one_line(
    name: str, place: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    from segfmu import cli

    path = written(place, MALFORMED[name])
    before = sorted(place.iterdir())
    monkeypatch.chdir(place)
    monkeypatch.setattr(
        sys, "argv", ["segfmu", "validate", str(path), "-o", "out", "--junit", "j.xml"]
    )
    assert cli.run() == 2
    error = capsys.readouterr().err
    assert error.count("\n") == 1 and "s.toml" in error
    assert sorted(place.iterdir()) == before


@pytest.mark.parametrize("name", REFUSED)
def test_what_the_fmus_refuse_is_one_line(
    name: str, runner: Runner, place: Path
) -> None:
    scenario = load_scenario(written(place, REFUSED[name]))
    with pytest.raises(ValueError) as refusal:
        runner.run(scenario)
    assert str(scenario.path) in str(refusal.value) and "\n" not in str(refusal.value)


def test_a_design_that_fails_names_keys_of_the_crane_file(runner: Runner, place: Path) -> None:
    scenario = load_scenario(
        written(place, HEAD + "[controller]\nweight.position = 1e300\n" + CRITERION)
    )
    words = r"s\.toml: the feedback has no gain .*: controller\.weight\.position 1e[+]300 is too"
    with pytest.raises(ValueError, match=words):
        runner.run(scenario)


def test_bases_are_merged(place: Path) -> None:
    written(place, HEAD + "[simulation]\nsettle = 2.0\n" + CRITERION, "low.toml")
    written(place, 'base = "low.toml"\n[simulation]\nfeedback = false\n', "middle.toml")
    top = written(place, 'base = "middle.toml"\nname = "top"\n'
                  + CRITERION.replace("0.005", "0.1") + CRITERION.replace('"c"', '"d"'))
    scenario = load_scenario(top)
    assert scenario.file.name == "top"
    assert scenario.mission.simulation.settle == 2.0
    assert scenario.mission.simulation.feedback is False
    assert [(c.name, c.bound) for c in scenario.file.criteria] == [("c", 0.1), ("d", 0.005)]


def test_the_suite_has_a_scenario_of_each_kind_and_one_that_fails() -> None:
    scenarios = [load_scenario(path) for path in find([SUITE])]
    assert len(scenarios) >= 16
    assert any(s.file.expect == "fail" for s in scenarios)
    kinds = {c.kind for s in scenarios for c in s.file.criteria}
    assert kinds == {"always", "eventually", "at", "settled", "tube", "drives"}
    assert {s.file.fmi for s in scenarios} == {2, 3}
    for scenario in scenarios:
        comment = scenario.path.read_text(encoding="utf-8").partition("\n\n")[0]
        assert comment.startswith("#") and ("alid " in comment or scenario.file.expect == "fail")


def dense(columns: dict[str, np.ndarray], values: np.ndarray, first: float, last: float) -> Any:
    """A signal on a hundred times finer grid, with the ends."""
    times = np.unique(np.concatenate([
        np.linspace(first, last, 20001), columns["time"], [first, last]
    ]))
    times = times[(times >= first) & (times <= last)]
    return np.interp(times, columns["time"], values)


def test_margins_are_those_of_the_tables(place: Path) -> None:
    require_native()
    text = HEAD + """
[crane]
drive = "velocity"
[simulation]
initial_sway = [0.5, 0.0]
settle = 2.0
[true_crane]
payload_mass = 1.2
[[criteria]]
name = "always"
signal = ["error.load.x", "error.load.y"]
bound = 0.004
window = [0.333, "arrival + 0.5"]
[[criteria]]
name = "eventually"
kind = "eventually"
signal = "load.position.x"
sense = "at least"
bound = 0.25
window = [1.0, "end - 0.5"]
[[criteria]]
name = "at"
kind = "at"
signal = "load.position.y"
sense = "at most"
at = 2.0012
bound = -0.1
[[criteria]]
name = "settled"
kind = "settled"
signal = "error.load.horizontal"
delay = 1.0
bound = 0.001
[[criteria]]
name = "tube"
kind = "tube"
signal = "bridge.position"
reference = "reference.bridge.position"
bound = 0.02
[[criteria]]
name = "against"
signal = "sway.total"
bound = 0.7
against = "without feedback"
[[criteria]]
name = "drives"
kind = "drives"
"""
    on, off = written(place, text), written(
        place, text.replace("[simulation]", "[simulation]\nfeedback = false"), "off.toml"
    )
    done = called(
        "validate", str(on), str(off), "-o", "out", "--junit", "out/j.xml", cwd=place
    )
    assert done.returncode in (0, 1), done.stderr
    results = json.loads((place / "out" / "results.json").read_text())
    entry = results["scenarios"][0]
    found = {c["name"]: c for c in entry["criteria"]}
    arrival, end = entry["times_s"]["arrival"], entry["times_s"]["end"]
    own, other = (columns(place / "out" / f"{n}.csv") for n in ("s", "off"))
    assert own["time"][-1] == end
    horizontal = np.sqrt(own["error.load.x"] ** 2 + own["error.load.y"] ** 2)
    expected = {
        "always": 0.004 - dense(own, horizontal, 0.333, arrival + 0.5).max(),
        "eventually": dense(own, own["load.position.x"], 1.0, end - 0.5).max() - 0.25,
        "at": -0.1 - np.interp(2.0012, own["time"], own["load.position.y"]),
        "settled": 0.001 - dense(own, horizontal, arrival + 1.0, end).max(),
        "tube": 0.02 - abs(own["bridge.position"] - own["reference.bridge.position"]).max(),
        "against": 0.7 * other["sway.total"].max() - own["sway.total"].max(),
        # bounds of the crane file: 0.3 m/s, 0.6 m/s2
        "drives": 1.0 - max(
            max(abs(rate).max() / 0.3, abs(np.diff(rate) / np.diff(own["time"])).max() / 0.6)
            for rate in (own[f"{axis}.velocity"] for axis in ("bridge", "trolley", "rope"))
        ),
    }
    for name, margin in expected.items():
        assert found[name]["margin"] == pytest.approx(margin, abs=1e-12), name
        assert found[name]["passed"] == (margin >= 0.0)
        share = margin / abs(found[name]["bound"])
        assert found[name]["normalised"] == pytest.approx(share, rel=1e-6)
    assert {c["passed"] for c in entry["criteria"]} == {True, False}
    suites = ElementTree.parse(place / "out" / "j.xml").getroot()
    cases = suites.findall("testsuite/testcase")
    assert len(cases) == 2 * len(expected)
    failed = {c.get("name") for c in suites[0] if c.find("failure") is not None}
    assert failed == {n for n, m in expected.items() if m < 0.0}


def test_a_run_that_an_fmu_stops_is_a_failed_scenario(runner: Runner, place: Path) -> None:
    stopped = HEAD + '[parameters.GantryCrane]\n"bridge.position" = 1e300\n' + CRITERION
    result = runner.run(load_scenario(written(place, stopped)))
    assert result.error and not result.passed and not result.right
    with pytest.raises(AssertionError):
        result.require()


def test_a_plan_that_is_not_possible_is_a_failed_scenario(runner: Runner, place: Path) -> None:
    high = HEAD + "[crane]\nrope_min = 0.7\n" + CRITERION
    result = runner.run(load_scenario(written(place, high)))
    assert result.error and "rope" in result.error and not result.passed


def test_expected_failures_are_right(runner: Runner, place: Path) -> None:
    strict = HEAD + 'expect = "fail"\n' + CRITERION.replace("0.005", "1e-30")
    result = runner.run(load_scenario(written(place, strict)))
    assert not result.passed and result.right
    easy = strict.replace("1e-30", "1.0")
    result = runner.run(load_scenario(written(place, easy)))
    assert result.passed and not result.right


def test_a_folder_in_a_folder_of_scenarios_is_no_scenario(tmp_path: Path) -> None:
    """One whose name ends as theirs was named as a file that cannot be read."""
    (tmp_path / "old.toml").mkdir()
    (tmp_path / "_base.toml").touch()
    with pytest.raises(InputError, match="no scenario files"):
        find([tmp_path])
    (tmp_path / "s.toml").touch()
    assert find([tmp_path]) == [tmp_path / "s.toml"]
