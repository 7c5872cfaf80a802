"""What acts on a run: events, profiles, references from files, second runs, exit codes."""

from __future__ import annotations

import sys
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest

from segfmu import cli
from segfmu.cosim import write_csv
from segfmu.errors import InputError
from segfmu.validation.files.scenario_file import load_scenario
from segfmu.validation.scenario_result import Result
from segfmu.validation.suite import Runner
from tests.compiler import require_native

MISSION = Path(__file__).parents[2] / "models" / "inteco.toml"
HEAD = f"""name = "s"
mission = "{MISSION.as_posix()}"
step = 0.005
[crane]
drive = "velocity"
[simulation]
feedback = false
settle = 1.0
"""
CRITERION = '[[criteria]]\nname = "c"\nsignal = "error.load.norm"\nbound = 0.005\n'


def done(runner: Runner, folder: Path, text: str) -> Result:
    (folder / "s.toml").write_text(text, encoding="utf-8")
    return runner.run(load_scenario(folder / "s.toml"))


def test_events_and_profiles_act_from_their_times_on(runner: Runner, tmp_path: Path) -> None:
    result = done(runner, tmp_path, HEAD + CRITERION + """
[[events]]
time = "arrival + 0.2"
values = { "wind.y" = 0.3 }
[[profiles]]
variable = "wind.x"
times = [1.0, 2.0]
values = [0.2, -0.1]
""")
    rows, arrival = result.rows, result.known["arrival"]
    assert rows is not None
    times = rows["time"]
    along = np.select([times < 1.0 - 1e-9, times < 2.0 - 1e-9], [0.0, 0.2], -0.1)
    across = np.where(times < arrival + 0.2 - 1e-9, 0.0, 0.3)
    power = along * rows["load.velocity.x"] + across * rows["load.velocity.y"]
    # all but the row of each change itself
    changes = np.array([[1.0], [2.0], [arrival + 0.2]])
    beside = np.all(np.abs(times - changes) > 0.005, axis=0)
    assert rows["power.wind"][beside] == pytest.approx(power[beside], abs=1e-9)
    assert np.abs(power).max() > 0.01


def test_a_tube_about_a_column_of_a_file(runner: Runner, tmp_path: Path) -> None:
    plain = done(runner, tmp_path, HEAD + CRITERION).rows
    assert plain is not None
    shifted = plain[["time", "load.position.x"]].copy()
    shifted["load.position.x"] += 0.25 * shifted["time"]
    write_csv(tmp_path / "reference.csv", shifted)
    tube = CRITERION.replace("error.load.norm", "load.position.x") + (
        'kind = "tube"\nreference = "reference.csv"\nwindow = [0.5, 1.502]\n'
    )
    (found,) = done(runner, tmp_path, HEAD + tube).findings
    assert found.margin == pytest.approx(0.005 - 0.25 * 1.502, abs=1e-12)


def test_a_bound_that_is_a_share_of_the_undisturbed_run(runner: Runner, tmp_path: Path) -> None:
    plain = done(runner, tmp_path, HEAD + CRITERION).rows
    assert plain is not None
    text = HEAD.replace("settle = 1.0", "settle = 1.0\ninitial_sway = [1.0, 0.0]") + (
        '[true_crane]\npayload_mass = 1.3\n[parameters.GantryCrane]\n"wind.constant.y" = 0.05\n'
        + CRITERION.replace("error.load.norm", "sway.total").replace("0.005", "1.5")
        + 'against = "undisturbed"\n[[events]]\ntime = 1.0\nvalues = { "wind.x" = 0.2 }\n'
    )
    result = done(runner, tmp_path, text)
    (found,) = result.findings
    assert result.rows is not None
    assert found.bound == pytest.approx(1.5 * plain["sway.total"].max(), rel=1e-12)
    assert found.margin == pytest.approx(
        found.bound - result.rows["sway.total"].max(), rel=1e-12
    )
    assert not found.passed


def test_a_run_of_no_duration_is_refused_by_its_file(runner: Runner, tmp_path: Path) -> None:
    (tmp_path / "rest.toml").write_text("""
name = "rest"
[crane]
bridge_mass = 2.2
trolley_mass = 1.155
payload_mass = 1.0
[limits]
x = { velocity = 1.0, acceleration = 1.0, jerk = 10.0, snap = 100.0 }
y = { velocity = 1.0, acceleration = 1.0, jerk = 10.0, snap = 100.0 }
z = { velocity = 1.0, acceleration = 1.0, jerk = 10.0, snap = 100.0 }
[[waypoints]]
position = [0.0, 0.0, -0.5]
[[waypoints]]
position = [0.0, 0.0, -0.5]
""", encoding="utf-8")
    text = 'name = "s"\nmission = "rest.toml"\n[simulation]\nsettle = 0.0\n' + CRITERION
    words = r"s\.toml: simulation\.settle: a plan of 0 s needs a time > 0 s"
    with pytest.raises(InputError, match=words):
        done(runner, tmp_path, text)


@pytest.mark.parametrize(("bound", "expect", "code", "outcomes"), [
    ("0.005", "pass", 0, set()),
    ("1e-30", "pass", 1, {"failure"}),
    ("1e-30", "fail", 0, {"skipped"}),
    ("0.005", "fail", 1, {"failure"}),
])
def test_exit_codes_and_junit(
    bound: str, expect: str, code: int, outcomes: set[str], tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    require_native()
    text = f'expect = "{expect}"\n' + HEAD + CRITERION.replace("0.005", bound)
    (tmp_path / "s.toml").write_text(text, encoding="utf-8")
    monkeypatch.setattr(sys, "argv", [
        "segfmu", "validate", str(tmp_path), "--junit", str(tmp_path / "j.xml")
    ])
    assert cli.run() == code
    (suite,) = ElementTree.parse(tmp_path / "j.xml").getroot()
    assert {entry.tag for case in suite for entry in case} == outcomes
    if bound == "1e-30":
        (told,) = (entry.get("message") or "" for case in suite for entry in case)
        assert told.endswith(" m of error.load.norm, bound 1e-30 m")
    counted = {"failures": "failure", "errors": "error", "skipped": "skipped"}
    for key, outcome in counted.items():
        assert int(suite.get(key) or 0) == len(suite.findall(f"testcase/{outcome}"))
    assert int(suite.get("tests") or 0) == len(suite)


@pytest.mark.parametrize("table, told", [
    ('[parameters.GantryCrane]\n"drive.bridge.lag" = -0.1', "drive.bridge.lag must be at least 0"),
    ('[parameters.GantryFeedforward]\n"limits.scale" = 2.0', "limits.scale must be at most 1"),
    ('[parameters.GantryCrane]\n"drive.mode" = 9', "drive.mode must be at most 2"),
])
def test_a_parameter_beyond_its_range_is_no_outcome(
    runner: Runner, tmp_path: Path, table: str, told: str
) -> None:
    """The FMU refused it, and the scenario failed; events and profiles were refused before."""
    with pytest.raises(InputError, match=rf"s\.toml: Gantry\w+: {told}, got "):
        done(runner, tmp_path, f"{HEAD}{CRITERION}{table}\n")
