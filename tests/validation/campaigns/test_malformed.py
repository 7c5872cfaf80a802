"""Malformed scenario and campaign files: one line that says where, exit code 2, nothing written."""

from __future__ import annotations

import os
import sys
from errno import EAGAIN, ENOLCK
from pathlib import Path

import pytest

from segfmu import InputError, campaign
from segfmu.cli.app import run as segfmu
from segfmu.validation.campaigns import store
from segfmu.validation.campaigns.result import load_result
from tests.compiler import require_native
from tests.validation.campaigns.files import CAMPAIGN, SCENARIO, write

# what is written in place of what, and what the line says
CAMPAIGNS = {
    "entry of a list": (
        'key = "simulation.initial_sway.0"\nrange = [0.0, 1.0]',
        'key = "plan.waypoints.1.position.2"\nrange = [-0.5, 3.0]',
        "sway = 3.0 (plan.waypoints.1.position.2, which counts from 0): ",
    ),
    "no toml": ('name = "c"', 'name = "c', "c.toml: not valid TOML"),
    "no name": ('name = "c"', "", "name: this key is missing"),
    "unknown key": ('name = "c"', 'name = "c"\nsampler = 1', "sampler: unknown key; did you mean"),
    "no scenarios": ('["s.toml"]', "[]", "scenarios: must have at least 1 value"),
    "scenario that is not there": ('"s.toml"', '"t.toml"', "t.toml: cannot be read: No such file"),
    "twice the same": ('["s.toml"]', '["s.toml", "s.toml"]', "two of them are called s.toml"),
    "kind": ("latin hypercube", "latin square", "sampling.kind: must be 'latin hypercube'"),
    "no runs": ("runs = 40\n", "", "runs is missing, which latin hypercube needs"),
    "runs of a matrix": ("latin hypercube", "matrix", "runs is no key of matrix"),
    "no run": ("runs = 40", "runs = 0", "sampling.runs: must be at least 1"),
    "too many runs": ("runs = 40", "runs = 2_000_000", "sampling.runs: must be at most 1e+06"),
    "seed": ("seed = 3", "seed = -3", "sampling.seed: must be at least 0"),
    "no factor": ("key = ", "keys = ", "keys: unknown key; did you mean key?"),
    "no names": ("controller.design", "..", "key: must be names with a dot between each two, got"),
    "misspelt crane": (
        "true_crane.payload_mass", "true_crane.paylod_mass", "did you mean payload_mass",
    ),
    "misspelt table": ("simulation.initial_sway", "simulations.initial_sway", "simulations"),
    "beyond a list": ("initial_sway.0", "initial_sway.7", "a list has no entry 7"),
    "wrong type": ('["lqr", "flatness"]', "[1, 2]", "controller.design: must be 'lqr'"),
    "mixed values": ('["lqr", "flatness"]', '["lqr", 2]', "must be all numbers, all text"),
    "empty range": ("[0.5, 1.5]", "[1.5, 0.5]", "range from 1.5 to 0.5 is empty"),
    "infinite range": ("[0.5, 1.5]", "[0.5, inf]", "must be a finite number"),
    "range and values": ("relative = true", "values = [1.0]", "takes one of range, values and"),
    "logarithm": ("range = [0.0, 1.0]", 'range = [0.0, 1.0]\nscale = "log"', "no logarithm"),
    "multiple of text": (
        '"flatness"]', '"flatness"]\nrelative = true', "relative is for numbers",
    ),
    "multiple of nothing": (
        "true_crane.payload_mass", "true_crane.bridge.force_max", "is no number in the files",
    ),
    "multiple of zero": (
        "range = [0.0, 1.0]", "range = [0.0, 1.0]\nrelative = true",
        "sway: relative: simulation.initial_sway.0 is 0 in the files, as all its multiples are",
    ),
    "name of a column": ('name = "sway"', 'name = "error"', "must have no dot and be none of"),
    "twice a name": ('name = "payload"', 'name = "sway"', "two of them are called sway"),
    "variants with a key": (
        'values = ["lqr", "flatness"]', "variants.a = {}", "key is for range and values",
    ),
    "wrong variant": (
        'key = "controller.design"\nvalues = ["lqr", "flatness"]',
        'variants.a.true_crane.wind = { gust = 3 }', "true_crane.wind.gust: must be a table",
    ),
    "changes": ("[sampling]", "[changes]\nspeed = 3\n[sampling]", "speed: unknown key"),
    "criterion among the changes": (
        "[sampling]", '[[changes.criteria]]\nname = "x"\nkind = "alway"\n[sampling]',
        "c.toml: changes.criteria.1.kind: must be 'always'",
    ),
    "step among the changes": ("[sampling]", "changes.step = 0\n[sampling]",
                               "c.toml: changes.step: must be at least 1e-06 s"),
    "outside of what the FMU takes": (
        "simulation.initial_sway.0", "parameters.GantryCrane.drive.bridge.lug",
        "GantryCrane has no variable drive.bridge.lug; did you mean drive.bridge.lag?",
    ),
    "outside of the range of the FMU": (
        'key = "simulation.initial_sway.0"\nrange = [0.0, 1.0]',
        'key = "parameters.GantryCrane.drive.bridge.lag"\nrange = [-0.1, 1.0]',
        "factor sway = -0.1: GantryCrane: drive.bridge.lag must be at least 0, got -0.1",
    ),
    "one key twice": (
        "simulation.initial_sway.0", "true_crane.payload_mass",
        "both set true_crane.payload_mass, of which only one could act; leave one out",
    ),
    "a key and a variant": (
        'key = "controller.design"\nvalues = ["lqr", "flatness"]',
        "variants = { heavy = { true_crane = { payload_mass = 2.0 } }, light = {} }",
        "both set true_crane.payload_mass, of which only one could act; leave one out",
    ),
    "short time": ("[sampling]", "timeout = 0.1\n[sampling]", "timeout: must be at least 1 s"),
    "search for something": (
        "[sampling]", 'search = "best"\n[sampling]',
        "search: must be 'worst' or 'rare', got 'best'",
    ),
    "few runs of a search": (
        "[sampling]", 'search = "worst"\n[sampling]',
        "search needs sampling.runs of at least 50, got 40; 500 are usual",
    ),
    "search in a matrix": (
        '[sampling]\nkind = "latin hypercube"\nruns = 40',
        'search = "worst"\n[sampling]\nkind = "matrix"',
        "search needs sampling.kind latin hypercube, random or sobol, which draws its first runs, "
        "got matrix",
    ),
    "criteria without a search": (
        "[sampling]", 'search_for = ["rests"]\n[sampling]', 'search_for is for a search',
    ),
    "search for no criterion": (
        "[sampling]\nkind = \"latin hypercube\"\nruns = 40",
        'search = "worst"\nsearch_for = ["sway"]\n[sampling]\nruns = 50',
        "search_for: no criterion 'sway'; they are follows, rests",
    ),
    "FMU that is not there": (
        "simulation.initial_sway.0", "parameters.Crane.drive.bridge.lag", "no FMU Crane",
    ),
}
SCENARIOS = {
    "no toml": ("[[criteria]]", "[[criteria]", "s.toml: not valid TOML"),
    "no mission": ('mission = "', '# mission = "', "mission: this key is missing"),
    "mission as base": ('mission = "', 'base = "', "this is a mission file, not a scenario file"),
    "no criteria": ("[[criteria]]", "[[criterion]]", "criterion: unknown key"),
    "unknown kind": ('"settled"', '"settling"', "criteria.2.kind: must be 'always'"),
    "signal that is not there": ("error.load.norm", "error.load.norn", "did you mean error.load"),
    "bound": ("bound = 0.02", "bound = -0.02", "is below 0, which nothing is within"),
    "window": (
        "bound = 0.02", 'bound = 0.02\nwindow = ["end", "start"]', "is empty or outside of the run",
    ),
    "instant": ("bound = 0.02", 'bound = 0.02\nwindow = ["middle", "end"]', "must be a time, or"),
    "step": ("step = 0.01", "step = 0", "step: must be at least 1e-06 s"),
    "coupling": ('"sequential"', '"series"', "coupling: must be 'derivatives'"),
    "unknown key of the crane": ("crane.drive", "crane.drives", "drives: unknown key"),
    "event outside": (
        "[[criteria]]\nname = \"follows\"",
        "[[events]]\ntime = 1e3\nvalues = { \"wind.x\" = 1.0 }\n[[criteria]]\nname = \"follows\"",
        "a change at 1000.0 s is outside of the run",
    ),
}


def refused(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], *words: str
) -> str:
    """The one line of a command that is refused."""
    monkeypatch.setattr(sys, "argv", ["segfmu", *words])
    assert segfmu() == 2
    line = capsys.readouterr().err
    assert line.count("\n") == 1 and line.startswith("segfmu: ")
    return line


@pytest.mark.parametrize("case", CAMPAIGNS)
def test_campaigns(
    case: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    require_native()
    old, new, said = CAMPAIGNS[case]
    assert old in CAMPAIGN
    path = write(tmp_path, CAMPAIGN.replace(old, new))
    before = sorted(tmp_path.rglob("*"))
    line = refused(monkeypatch, capsys, "campaign", str(path), "-o", str(tmp_path / "out"))
    assert said in line and str(path) in line
    assert sorted(tmp_path.rglob("*")) == before


@pytest.mark.parametrize("command", ["validate", "campaign"])
@pytest.mark.parametrize("case", SCENARIOS)
def test_scenarios(
    case: str, command: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    require_native()
    old, new, said = SCENARIOS[case]
    assert old in SCENARIO
    path = write(tmp_path, scenario=SCENARIO.replace(old, new))
    before = sorted(tmp_path.rglob("*"))
    file = path if command == "campaign" else tmp_path / "s.toml"
    line = refused(monkeypatch, capsys, command, str(file), "-o", str(tmp_path / "out"))
    assert said in line and "s.toml" in line
    assert sorted(tmp_path.rglob("*")) == before


def test_an_empty_name_of_a_folder(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    require_native()
    path = write(tmp_path)
    (tmp_path / "file").touch()
    for name, said in (("", "output is empty"), (str(tmp_path / "file" / "x"), "Not a directory")):
        assert said in refused(monkeypatch, capsys, "campaign", str(path), "-o", name)


@pytest.mark.parametrize("name", ["campaign.json", "runs.parquet", "results.json", "report.html"])
def test_places_of_results_are_checked_before_the_runs(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Also before the file of the campaign: it would take as long to be checked."""
    (tmp_path / name).mkdir()
    said = f"{name}: cannot be written: Is a directory"
    assert said in refused(monkeypatch, capsys, "campaign", "nowhere.toml", "-o", str(tmp_path))
    if name != "report.html":
        with pytest.raises(InputError, match=said):
            campaign("nowhere.toml", tmp_path)


@pytest.mark.parametrize("about", ["[]", "{}", '{"name": "x"}', "{", ""])
def test_a_folder_that_has_no_campaign(about: str, tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"campaign\.json: cannot be read: No such file[\w ]*$"):
        load_result(tmp_path)
    (tmp_path / "campaign.json").write_text(about, encoding="utf-8")
    with pytest.raises(InputError, match=r"campaign\.json: "):
        load_result(tmp_path)


@pytest.mark.parametrize(("number", "words"), [
    (EAGAIN, "another campaign is running"), (ENOLCK, "cannot be locked: "),
])
def test_why_a_folder_cannot_be_locked(
    number: int, words: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuse(_: int) -> None:
        raise OSError(number, os.strerror(number))

    monkeypatch.setattr(store, "_lock", refuse)
    with pytest.raises(InputError, match=words), store.alone(tmp_path):
        pass


def test_a_run_that_there_is_not(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    path = write(tmp_path)
    words = ("campaign", str(path), "-o", str(tmp_path / "out"), "--replay", "40")
    assert "no run 40; they are 0 to 39" in refused(monkeypatch, capsys, *words)


def test_packages_that_are_missing_are_one_line(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(
        "segfmu.validation.campaigns.run.find_spec", lambda name: None if name == "dask" else name
    )
    line = refused(monkeypatch, capsys, "campaign", str(write(tmp_path)))
    assert "campaigns need dask: pip install 'segfmu[campaign]'" in line


def test_a_link_to_itself_is_no_campaign(tmp_path: Path) -> None:
    """It ended with an error of Python, where the place of the file was looked for first."""
    path = tmp_path / "c.toml"
    path.symlink_to(path)
    with pytest.raises(InputError, match=r"c\.toml: cannot be read: Too many levels of symbolic l"):
        campaign(path, tmp_path / "out")
    assert not (tmp_path / "out").exists()
