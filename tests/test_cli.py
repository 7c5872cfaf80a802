"""The command line: what it prints and writes, and one clear line for every bad file."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
import zipfile
from pathlib import Path

import numpy as np
import pytest
from fmpy import read_model_description

import segfmu
from segfmu import cli
from tests.campaign import soaked
from tests.command import called
from tests.tables import columns

MODELS = Path(__file__).parents[1] / "models"
CRANE = "[crane]\nbridge_mass = 2.2\ntrolley_mass = 1.155\npayload_mass = 1.0\n"
LIMITS = "".join(
    f"[limits.{a}]\nvelocity = 1.0\nacceleration = 1.0\njerk = 2.0\nsnap = 20.0\n" for a in "xyz"
)
POINTS = (
    "[[waypoints]]\nposition = [0.0, 0.0, -0.5]\n"
    "[[waypoints]]\nposition = [0.3, 0.2, -0.5]\n"
)
GOOD = CRANE + LIMITS + POINTS


def invoke(monkeypatch, capsys, *arguments: str) -> tuple[int, str, str]:
    """Exit code, standard output and standard error of the command."""
    monkeypatch.setattr(sys, "argv", ["segfmu", *arguments])
    with pytest.raises(SystemExit) as stopped:
        cli.main()
    captured = capsys.readouterr()
    return int(stopped.value.code or 0), captured.out, captured.err


def replaced(old: str, new: str) -> str:
    assert old in GOOD
    return GOOD.replace(old, new, 1)


MALFORMED = {
    "empty": ("", "crane"),
    "broken TOML": ("[crane\n", "not valid TOML"),
    "duplicate key": (GOOD.replace("[crane]\n", "[crane]\nbridge_mass = 1.0\n"), "TOML"),
    "missing crane": (LIMITS + POINTS, "crane"),
    "missing mass": (replaced("payload_mass = 1.0\n", ""), "payload_mass"),
    "missing limits": (CRANE + POINTS, "limits"),
    "missing axis": (replaced("[limits.z]", "[limits.w]"), "limits.z"),
    "missing velocity": (replaced("velocity = 1.0\n", ""), "limits.x.velocity"),
    "missing waypoints": (CRANE + LIMITS, "waypoints"),
    "missing position": (GOOD + "[[waypoints]]\ndwell = 1.0\n", "waypoints.3.position"),
    "mass is text": (replaced("2.2", '"2.2"'), "bridge_mass"),
    "mass is a flag": (replaced("2.2", "true"), "bridge_mass"),
    "mass is a list": (replaced("2.2", "[2.2]"), "bridge_mass"),
    "mass is negative": (replaced("2.2", "-2.2"), "bridge_mass"),
    "mass is zero": (replaced("2.2", "0.0"), "bridge_mass"),
    "mass is nan": (replaced("2.2", "nan"), "bridge_mass"),
    "mass is infinite": (replaced("2.2", "inf"), "bridge_mass"),
    "mass is tiny": (replaced("2.2", "1e-300"), "bridge_mass"),
    "mass is huge": (replaced("2.2", "1e300"), "bridge_mass"),
    "mass of 5000 digits": (replaced("2.2", "1" + "0" * 5000), "a number of 5001 digits"),
    "crane is a list": (
        "crane = [1]\n" + LIMITS + POINTS,
        "crane: must be the name of a crane file, or a table, got [1]",
    ),
    "crane file of no name": ('crane = "a\\u0000b"\n' + LIMITS + POINTS, "null"),
    "name of two lines": ('name = "a\\nb"\n' + GOOD, "name: must be one line"),
    "name is a book": (f'name = "{"x" * 1000}"\n' + GOOD, "name: "),
    "feedback is text": (GOOD + '[simulation]\nfeedback = "yes"\n', "simulation.feedback"),
    "step for ever": (GOOD + "[simulation]\nstep = 1e-300\n", "simulation.step: must be at least"),
    "settles for ever": (GOOD + "[simulation]\nsettle = 1e300\n", "simulation.settle: must be at"),
    "dwells for ever": (GOOD + "dwell = 1e9\n", "waypoints.2.dwell: must be at most 1e+06 s"),
    "rows for ever": (
        GOOD + "dwell = 1e5\n[simulation]\noutput_step = 1e-5\n",
        "at most 2000000 are possible",
    ),
    "limit is zero": (replaced("jerk = 2.0", "jerk = 0.0"), "limits.x.jerk"),
    "limit is negative": (replaced("snap = 20.0", "snap = -1.0"), "limits.x.snap"),
    "limit is nan": (replaced("acceleration = 1.0", "acceleration = nan"), "acceleration"),
    "limit is infinite": (replaced("velocity = 1.0", "velocity = inf"), "limits.x.velocity"),
    "unknown key": ("colour = 1\n" + GOOD, "colour"),
    "unknown limit": (replaced("snap = 20.0", "snop = 20.0"), "limits.x.snop"),
    "unknown shape": ('shape = "round"\n' + GOOD, "shape"),
    "unknown synchronization": ('synchronization = "all"\n' + GOOD, "synchronization"),
    "smoothness too low": ("smoothness = 3\n" + GOOD, "smoothness"),
    "smoothness too high": ("smoothness = 7\n" + GOOD, "smoothness"),
    "smoothness is a fraction": ("smoothness = 4.5\n" + GOOD, "smoothness"),
    "duration is negative": ("duration = -1.0\n" + GOOD, "duration"),
    "sample time is zero": ("sample_time = 0.0\n" + GOOD, "sample_time"),
    "one waypoint": (CRANE + LIMITS + POINTS[: POINTS.rindex("[[")], "waypoints"),
    "too many waypoints": (
        CRANE + LIMITS + "".join(
            f"[[waypoints]]\nposition = [{i}.0, 0.0, -0.5]\n" for i in range(257)
        ),
        "waypoints",
    ),
    "two coordinates": (replaced("[0.3, 0.2, -0.5]", "[0.3, 0.2]"), "waypoints.2.position"),
    "position is text": (replaced("[0.3, 0.2", '["a", 0.2'), "waypoints.2.position"),
    "position is nan": (replaced("[0.3", "[nan"), "waypoints.2.position"),
    "position above the trolley": (replaced("0.2, -0.5]", "0.2, 0.5]"), "waypoints.2.position"),
    "velocity beyond its limit": (
        GOOD + "velocity = [1.5, 0.0, 0.0]\n", "waypoints.2.velocity: axis x",
    ),
    "acceleration beyond its limit": (
        GOOD + "acceleration = [0.0, 0.0, -1.5]\n", "waypoints.2.acceleration: axis z",
    ),
    "dwell while moving": (GOOD + "velocity = [0.5, 0.0, 0.0]\ndwell = 1.0\n", "waypoints.2.dwell"),
    "dwell is negative": (GOOD + "dwell = -1.0\n", "waypoints.2.dwell"),
    "rope range is empty": (
        replaced("payload_mass = 1.0\n", "payload_mass = 1.0\nrope_min = 2.0\nrope_max = 1.0\n"),
        "rope_min",
    ),
    "step is zero": (GOOD + "[simulation]\nstep = 0.0\n", "simulation.step"),
    "unknown feedback source": (
        GOOD + '[simulation]\nfeedback_source = "camera"\n', "simulation.feedback_source",
    ),
    "crane file missing": ('crane = "nowhere.toml"\n' + LIMITS + POINTS, "nowhere.toml"),
    "waypoints are no list": ("waypoints = 3\n" + CRANE + LIMITS, "waypoints"),
    "limits are a number": ("limits = 3\n" + CRANE + POINTS, "limits"),
}


@pytest.mark.parametrize("name", MALFORMED)
def test_malformed_mission_gives_one_line_and_code_2(
    name: str, tmp_path: Path, monkeypatch, capsys
) -> None:
    text, words = MALFORMED[name]
    mission = tmp_path / "mission.toml"
    mission.write_text(text, encoding="utf-8")
    for command in ("plan", "simulate"):
        out = tmp_path / "out"
        code, printed, error = invoke(monkeypatch, capsys, command, str(mission), "-o", str(out))
        assert code == 2
        assert printed == ""
        assert error.count("\n") == 1
        assert words in error
        assert not out.exists()


@pytest.mark.parametrize("kind", ["absent", "folder", "binary"])
def test_unreadable_mission_gives_one_line_and_code_2(
    kind: str, tmp_path: Path, monkeypatch, capsys
) -> None:
    mission = tmp_path / "mission.toml"
    if kind == "folder":
        mission.mkdir()
    elif kind == "binary":
        mission.write_bytes(bytes(range(256)))
    code, _, error = invoke(monkeypatch, capsys, "plan", str(mission))
    assert code == 2
    assert error.count("\n") == 1
    assert "mission.toml" in error


def test_name_is_shown_as_written(tmp_path, monkeypatch, capsys) -> None:
    """Neither markup of the terminal nor mathematics of the plots."""
    mission = tmp_path / "mission.toml"
    mission.write_text('name = "[/bold] $x_{1$ [red]"\n' + GOOD, encoding="utf-8")
    code, printed, error = invoke(
        monkeypatch, capsys, "plan", str(mission), "-o", str(tmp_path / "out")
    )
    assert (code, error) == (0, "")
    assert "[/bold] $x_{1$ [red]" in printed


def test_infeasible_mission_gives_one_line_and_code_1(tmp_path, monkeypatch, capsys) -> None:
    mission = tmp_path / "mission.toml"
    mission.write_text("duration = 0.1\n" + GOOD, encoding="utf-8")
    code, _, error = invoke(monkeypatch, capsys, "plan", str(mission))
    assert code == 1
    assert error.count("\n") == 1
    assert "duration 0.1 s is shorter" in error


@pytest.mark.parametrize("name", ["inteco", *soaked("paper", "pick_and_place")])
def test_every_mission_plans(name: str, tmp_path, monkeypatch, capsys) -> None:
    code, printed, error = invoke(
        monkeypatch, capsys, "plan", str(MODELS / f"{name}.toml"), "-o", str(tmp_path)
    )
    assert (code, error) == (0, "")
    assert "velocity" in printed
    pictures = {"plan.png", "path.png", "drives.png"}
    assert {p.name for p in tmp_path.iterdir()} == {"plan.csv", *pictures}
    assert (tmp_path / "plan.png").read_bytes().startswith(b"\x89PNG")


def test_simulate_judges_and_writes_everything(tmp_path, monkeypatch, capsys) -> None:
    mission = str(MODELS / "pick_and_place.toml")
    code, printed, _ = invoke(
        monkeypatch, capsys, "simulate", mission, "-o", str(tmp_path), "--step", "0.005"
    )
    assert code == 0
    assert "passed" in printed
    names = {p.name for p in tmp_path.iterdir()}
    assert names == {
        "GantryFeedforward.fmu", "GantryCrane.fmu", "run.csv", "run.png", "report.html",
    }


def test_failed_verdict_gives_code_1(tmp_path, monkeypatch, capsys) -> None:
    mission = tmp_path / "mission.toml"
    text = GOOD + "[simulation]\nstep = 0.01\nfeedback = false\ninitial_sway = [5.0, 0.0]\n"
    mission.write_text(text, encoding="utf-8")
    code, printed, _ = invoke(
        monkeypatch, capsys, "simulate", str(mission), "-o", str(tmp_path / "out")
    )
    assert code == 1
    rows = [line for line in printed.splitlines() if line.startswith("failed: ")]
    assert len(rows) == 2
    assert re.match(r"failed: largest tracking error [\d.]+ mm \(at most 1\); simulation", rows[0])
    assert re.match(r"failed: residual sway \d\.\d+ deg \(at most 0.02\); simulation", rows[1])


@pytest.mark.parametrize("backend", ["native", "python"])
def test_build_takes_the_feedback_source_of_the_mission(
    backend: str, tmp_path, monkeypatch, capsys
) -> None:
    starts = {}
    for source, text in (("default", ""), ("measured", 'feedback_source = "measured"\n')):
        mission = tmp_path / f"{source}.toml"
        mission.write_text(GOOD + "[simulation]\n" + text, encoding="utf-8")
        folder = tmp_path / source
        code, _, _ = invoke(
            monkeypatch, capsys, "build", str(mission), "-o", str(folder), "--backend", backend
        )
        assert code == 0
        found = read_model_description(str(folder / "GantryCrane.fmu")).modelVariables
        starts[source] = next(int(v.start) for v in found if v.name == "feedback.source")
    # items of the enumeration: state, measured
    assert starts == {"default": 1, "measured": 2}


@pytest.mark.parametrize("source", ["state", "measured"])
def test_simulate_takes_the_feedback_source_of_the_mission(
    source: str, tmp_path, monkeypatch, capsys
) -> None:
    mission = tmp_path / "mission.toml"
    simulation = f'[simulation]\nstep = 0.005\nfeedback_source = "{source}"\n'
    mission.write_text(GOOD + simulation + "initial_sway = [1.0, 0.0]\n", encoding="utf-8")
    out = tmp_path / "out"
    invoke(monkeypatch, capsys, "simulate", str(mission), "-o", str(out))
    rows = columns(out / "run.csv")
    estimates = rows["estimate.disturbance.bridge"]
    # the observer runs from measured signals alone
    assert np.any(estimates != 0.0) == (source == "measured")
    # and either way the sway of 1 degree is damped, which without feedback it is not
    assert np.abs(rows["sway.x.angle"][-100:]).max() < 2e-3


def test_help_teaches(tmp_path: Path) -> None:
    for command in ([], ["plan"], ["build"], ["simulate"]):
        result = called(*command, "--help", cwd=tmp_path)
        assert result.returncode == 0 and "Usage" in result.stdout
    assert "Example" in result.stdout


SCENARIO = """
name = "s"
mission = "MODELS/inteco.toml"
[[criteria]]
name = "as before"
kind = "tube"
signal = "bridge.position"
reference = "s.csv"
bound = 0.01
"""
CAMPAIGN = """
name = "k"
scenarios = ["t.toml"]
sampling = { kind = "latin hypercube", runs = 3 }
[[factors]]
name = "payload"
key = "true_crane.payload_mass"
range = [0.9, 1.1]
"""


@pytest.mark.parametrize(("words", "lost"), [
    (("plan", "m.toml", "-o", "."), "plan.csv"),
    (("simulate", "c.toml", "--commands", "run.csv", "-o", "."), "run.csv"),
    (("live", "c.toml", "-o", "c.toml"), "c.toml"), (("live", "c.toml", "-o", "l.toml"), "c.toml"),
    (("validate", "s.toml", "-o", "."), "s.csv"),
    (("validate", "s.toml", "--junit", "s.toml"), "s.toml"),
    (("identify", "run.csv", "--crane", "crane.toml", "-o", "."), "crane.toml"),
    (("validate", "t.toml", "--junit", "c.toml"), "c.toml"),
    (("validate", "t.toml", "--junit", "s.toml"), "s.toml"),
    (("validate", "t.toml", "--junit", "run.csv"), "run.csv"),
    (("campaign", "c.toml", "--junit", "c.toml"), "c.toml"),
    (("campaign", "k.toml", "--junit", "s.toml"), "s.toml"),
    (("campaign", "k.toml", "--junit", "c.toml"), "c.toml"),
])
def test_what_is_read_is_not_written_over(words: tuple[str, ...], lost: str, tmp_path) -> None:
    """A recording, a reference and a crane file were replaced by results."""
    lab = MODELS / "commands" / "lab"
    mission = (MODELS / "paper.toml").read_text(encoding="utf-8")
    mission = mission[:mission.index("[[waypoints]]")]
    mission = mission.replace("crane_lab", (MODELS / "crane_lab").as_posix())
    files = {
        "m.toml": f'waypoints = "plan.csv"\n{mission}', "plan.csv": "x,y,z\n0,0,-1\n1,1,-1\n",
        "c.toml": (lab / "_mission.toml").read_text(encoding="utf-8"),
        "run.csv": (lab / "wind.csv").read_text(encoding="utf-8"),
        "s.toml": SCENARIO.replace("MODELS", MODELS.as_posix()),
        "t.toml": 'base = "s.toml"\nmission = "c.toml"\n[[profiles]]\nfile = "run.csv"\n',
        "k.toml": CAMPAIGN, "s.csv": "time,bridge.position\n0,0\n9,0\n",
        "crane.toml": (MODELS / "crane_lab.toml").read_text(encoding="utf-8"),
    }
    for name, text in files.items():
        (tmp_path / name).write_text(text, encoding="utf-8")
    (tmp_path / "l.toml").hardlink_to(tmp_path / "c.toml")
    done = called(*words, cwd=tmp_path)
    assert done.returncode == 2
    # scenarios of a campaign have whole paths
    assert done.stderr.strip().replace(f"{tmp_path}{os.sep}", "") == (
        f"segfmu: {lost}: is read, and the results would be written over it; name another output"
    )
    assert all((tmp_path / n).read_text(encoding="utf-8") == text for n, text in files.items())


@pytest.mark.parametrize(("command", "junit", "told"), [
    ("validate", "o", "o: would be in the place of the results in o"),
    ("validate", "o/results.json", "o/results.json: would be among the results in o"),
    ("validate", "o/../o/t.csv", "o/../o/t.csv: would be among the results in o"),
    ("campaign", "o/campaign.json", "o/campaign.json: would be among the results in o"),
])
def test_tests_are_not_written_over_results(
    command: str, junit: str, told: str, tmp_path, monkeypatch, capsys
) -> None:
    """The suite was run, and its results replaced; or nothing could be written after all."""
    monkeypatch.chdir(tmp_path)
    Path("t.toml").write_text(SCENARIO.replace("MODELS", MODELS.as_posix()), encoding="utf-8")
    Path("k.toml").write_text(CAMPAIGN, encoding="utf-8")
    file = "t.toml" if command == "validate" else "k.toml"
    code, _, error = invoke(monkeypatch, capsys, command, file, "-o", "o", "--junit", junit)
    assert code == 2 and error.strip().endswith(f"{told}; give it another name")
    assert not Path("o").exists()


def test_build_into_a_file_is_refused(tmp_path, monkeypatch, capsys) -> None:
    (tmp_path / "taken").write_text("x", encoding="utf-8")
    code, _, error = invoke(monkeypatch, capsys, "build", "-o", str(tmp_path / "taken"))
    assert code == 2
    assert error.count("\n") == 1


def test_build_writes_files_for_other_tools(tmp_path, monkeypatch, capsys) -> None:
    mission = tmp_path / "mission.toml"
    mission.write_text('name = "over there"\n' + GOOD, encoding="utf-8")
    out = tmp_path / "out"
    code, printed, _ = invoke(
        monkeypatch, capsys, "build", str(mission), "-o", str(out), "--ssp"
    )
    assert code == 0
    names = {"GantryFeedforward.fmu", "GantryCrane.fmu", "mission.ssp", "OspSystemStructure.xml"}
    assert {p.name for p in out.iterdir()} == names
    assert all(n in printed.replace("\n", "") for n in names)
    with zipfile.ZipFile(out / "mission.ssp") as package:
        assert b'description="over there"' in package.read("SystemStructure.ssd")
        values = package.read("resources/GantryFeedforward.ssv")
    assert b'<ssv:Real value="20.0" unit="m/s4" />' in values
    assert b"waypoint[2]." in values and b"waypoint[3]." not in values


def test_files_of_a_build_before_are_told(tmp_path, monkeypatch, capsys) -> None:
    for name in ("mission.ssp", "OspSystemStructure.xml", "Segfmu/package.mo"):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text("old", encoding="utf-8")
    code, _, told = invoke(
        monkeypatch, capsys, "build", "-o", str(tmp_path), "--ssp", "--fmi", "3"
    )
    assert code == 0
    assert told == (
        f"segfmu: OspSystemStructure.xml and Segfmu/package.mo in {tmp_path} were there before and "
        "are not of these FMUs; remove them\n"
    )
    assert (tmp_path / "OspSystemStructure.xml").read_text() == "old"
    run = segfmu.simulate(MODELS / "paper.toml", output=tmp_path)
    assert run.note.startswith("mission.ssp, OspSystemStructure.xml and Segfmu/package.mo in ")


@pytest.mark.parametrize("command", ["plan", "simulate"])
def test_output_that_is_removed_meanwhile_is_told(
    command: str, tmp_path, monkeypatch, capsys
) -> None:
    def save(figure, path: Path) -> None:
        shutil.rmtree(tmp_path / "out")
        (tmp_path / "out").mkdir()

    monkeypatch.setattr("segfmu.validation.plots.style.save", save)
    code, _, told = invoke(
        monkeypatch, capsys, command, str(MODELS / "paper.toml"), "-o", str(tmp_path / "out")
    )
    assert code == 2
    assert told.count("\n") == 1 and "was written and is gone" in told


def test_a_modelica_package_has_the_fmus_that_were_built(tmp_path, monkeypatch, capsys) -> None:
    code, _, _ = invoke(
        monkeypatch, capsys, "build", "-o", str(tmp_path), "--modelica", "--waypoints", "20"
    )
    assert code == 0
    guid = read_model_description(str(tmp_path / "GantryFeedforward.fmu")).guid
    assert guid in (tmp_path / "Segfmu" / "GantryFeedforward.mo").read_text()


def test_a_system_of_fmi_3_is_ssp_2(tmp_path, monkeypatch, capsys) -> None:
    code, printed, _ = invoke(
        monkeypatch, capsys, "build", "-o", str(tmp_path), "--ssp", "--fmi", "3"
    )
    assert code == 0
    names = {"GantryFeedforward.fmu", "GantryCrane.fmu", "mission.ssp"}
    assert {p.name for p in tmp_path.iterdir()} == names
    assert all(n in printed.replace("\n", "") for n in names)
    with zipfile.ZipFile(tmp_path / "mission.ssp") as package:
        assert b' version="2.0" name="mission"' in package.read("SystemStructure.ssd")


@pytest.mark.parametrize(
    ("option", "other", "reason"),
    [
        ("--modelica", ("--fmi", "3"), "modelica needs FMUs of FMI 2"),
        ("--modelica", ("--backend", "python"), "modelica needs native FMUs"),
        ("--ssp", ("--backend", "python"), "ssp needs native FMUs"),
        ("--ssp", ("--fmi", "3", "--enumerations", "integer"), "ssp needs enumerations"),
        ("--ssp", ("--commands", "inputs"), "ssp needs commands as parameters"),
    ],
)
def test_files_for_other_tools_need_fmus_that_have_all(
    option: str, other: tuple[str, ...], reason: str, tmp_path, monkeypatch, capsys
) -> None:
    code, _, error = invoke(monkeypatch, capsys, "build", "-o", str(tmp_path), option, *other)
    assert code == 2 and not list(tmp_path.iterdir())
    assert error.count("\n") == 1 and reason in error


def test_a_terminal_of_unknown_width_is_printed_to() -> None:
    done = subprocess.run(
        [sys.executable, "-m", "segfmu", "plan", "--help"], capture_output=True, text=True,
        env=os.environ | {"COLUMNS": "0"}, timeout=60, check=True,
    )
    assert "Plan a mission and show every peak" in done.stdout
