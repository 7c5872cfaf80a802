"""The suite that ships, a third FMU, and the fixture of pytest."""

from __future__ import annotations

import json
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from segfmu.errors import InputError
from segfmu.validation.campaigns.campaign import load_campaign
from segfmu.validation.files.scenario_file import load_scenario
from segfmu.validation.files.scenario_tables import CriterionTable
from segfmu.validation.signal_table import column_units
from segfmu.validation.suite import Runner
from segfmu.validation.suite_files import write_results
from segfmu.validation.suites import validate
from tests.command import called
from tests.compiler import require_native
from tests.cosim.probe import build as probe
from tests.cosim.probe.build import build
from tests.tables import columns

MODELS = Path(__file__).parents[2] / "models"
SUITE = MODELS / "scenarios"
HEAD = f'name = "s"\nmission = "{(MODELS / "inteco.toml").as_posix()}"\nstep = 0.005\n'
VELOCITY = '[crane]\ndrive = "velocity"\n[simulation]\nfeedback = false\n'
CRITERION = '[[criteria]]\nname = "c"\nsignal = "error.load.norm"\nbound = 0.005\n'
CAMPAIGN = """
name = "c"
scenarios = ["s.toml"]
[sampling]
kind = "corners"
[[factors]]
name = "gain"
key = "fmus.probe.values.gain"
range = [0.1, 0.9]
"""


@pytest.fixture(scope="module")
def results(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, list[dict[str, Any]]]:
    """Folder and entries of `segfmu validate models/scenarios`."""
    require_native()
    folder = tmp_path_factory.mktemp("suite")
    done = called("validate", str(SUITE), "-o", str(folder), cwd=folder)
    assert done.returncode == 0, done.stdout + done.stderr
    return folder, json.loads((folder / "results.json").read_text(encoding="utf-8"))["scenarios"]


def instant(value: float | str, times: dict[str, float]) -> float:
    if isinstance(value, str):
        word, *rest = value.split()
        return times[word] + float("".join(rest) or 0.0)
    return value


def margin(
    entry: CriterionTable, own: dict[str, np.ndarray], times: dict[str, float], bound: float
) -> float:
    """The margin on a fine grid, which has the rows and the ends of the window."""
    first, last = (instant(value, times) for value in entry.window)
    if entry.kind == "settled":
        first = times["arrival"] + entry.delay
    if entry.kind == "at":
        assert entry.at is not None
        first = last = instant(entry.at, times)
    signals = [entry.signal] if isinstance(entry.signal, str) else entry.signal
    assert signals is not None
    if signals == ["error.load.horizontal"]:
        signals = ["error.load.x", "error.load.y"]
    columns = [own[name] - (own[entry.reference] if entry.reference else 0.0) for name in signals]
    value = np.sqrt(sum(c**2 for c in columns))
    if entry.sense != "within":
        value = columns[0]
    grid = np.unique(np.concatenate([np.linspace(first, last, 5001), own["time"]]))
    grid = grid[(grid >= first) & (grid <= last)]
    fine = np.interp(grid, own["time"], value)
    distance = fine - bound if entry.sense == "at least" else bound - fine
    return float(distance.max() if entry.kind == "eventually" else distance.min())


def test_every_margin_of_the_suite_is_that_of_its_table(
    results: tuple[Path, list[dict[str, Any]]]
) -> None:
    folder, entries = results
    assert len(entries) >= 16 and all(entry["right"] for entry in entries)
    compared = 0
    for entry in (e for e in entries if not e["error"]):
        own = columns(folder / entry["table"])
        criteria = {c.name: c for c in load_scenario(Path(entry["file"])).file.criteria}
        for found in entry["criteria"]:
            if found["kind"] == "drives":
                continue
            expected = margin(criteria[found["name"]], own, entry["times_s"], found["bound"])
            assert found["margin"] == pytest.approx(expected, abs=1e-12), entry["scenario"]
            assert found["passed"] == (expected >= -1e-12)
            compared += 1
    assert compared >= 20


def test_what_is_expected_to_fail_does(results: tuple[Path, list[dict[str, Any]]]) -> None:
    failed = {Path(e["file"]).stem for e in results[1] if not e["passed"]}
    assert failed == {"drive_failure"}


def test_runs_without_rows_have_the_same_findings(runner: Runner, tmp_path: Path) -> None:
    """Each kind of criterion finds what it reads, also a second run's."""
    (tmp_path / "s.toml").write_text(HEAD + """
[[criteria]]
name = "drives"
kind = "drives"
[[criteria]]
name = "tube"
kind = "tube"
signal = ["load.position.x", "load.position.y"]
reference = "error.load.norm"
bound = 1.0
[[criteria]]
name = "horizontal"
signal = "error.load.horizontal"
bound = 0.5
against = "without feedback"
""", encoding="utf-8")
    scenario = load_scenario(tmp_path / "s.toml")
    with Runner(rows=False) as short:
        found = short.run(scenario)
    expected = runner.run(scenario)
    assert found.rows is None and expected.rows is not None
    assert found.error == expected.error == ""
    assert found.findings == expected.findings and len(found.findings) == 3


def third(folder: Path, sink: str, fmi: int = 2) -> str:
    """The probe, whose output is the bridge's velocity and the time, as a table of a scenario."""
    return f"""
[[fmus]]
name = "probe"
path = "{build(folder, fmi).name}"
connections = [
    ["GantryFeedforward", "velocity.bridge", "probe", "x"],
    ["probe", "y", "GantryCrane", "{sink}"],
]
[fmus.values]
gain = 0.5
"""


def test_a_third_fmu_takes_part(runner: Runner, tmp_path: Path) -> None:
    (tmp_path / "s.toml").write_text(
        HEAD + VELOCITY + CRITERION + third(tmp_path, "wind.x"),
        encoding="utf-8",
    )
    rows = runner.run(load_scenario(tmp_path / "s.toml")).rows
    assert rows is not None
    wind = 0.5 * rows["velocity.bridge"] + rows["time"]
    assert np.abs(wind).max() > 5.0
    assert rows["y"] == pytest.approx(wind, abs=1e-12)
    assert rows["power.wind"] == pytest.approx(wind * rows["load.velocity.x"], abs=1e-9)


@pytest.mark.parametrize("fmi", [2, 3])
def test_criteria_tell_the_units_of_a_third_fmu(fmi: int, runner: Runner, tmp_path: Path) -> None:
    own = HEAD + VELOCITY + CRITERION + third(tmp_path, "wind.x", fmi)
    bounded = '[[criteria]]\nname = "third"\nsignal = {}\nbound = 100.0\n'
    path = tmp_path / "s.toml"
    path.write_text(own + bounded.format('"y"'), encoding="utf-8")
    scenario = load_scenario(path)
    result = runner.run(scenario)
    assert result.findings[-1].unit == "V" == scenario.units["probe.y"]
    assert scenario.units["GantryCrane.sway.total"] == "rad"
    (tmp_path / "c.toml").write_text(CAMPAIGN, encoding="utf-8")
    assert load_campaign(tmp_path / "c.toml").units == {"c": "m", "third": "V"}
    write_results(tmp_path, [result])
    assert column_units(tmp_path / "s.csv")["y"] == "V"
    path.write_text(own + bounded.format('["y", "sway.total"]'), encoding="utf-8")
    with pytest.raises(InputError, match=r"criteria\.2: .* y is in V, sway.total in rad"):
        load_scenario(path)


def test_a_third_fmu_has_a_step_of_its_own(runner: Runner, tmp_path: Path) -> None:
    text = HEAD + VELOCITY + CRITERION + third(tmp_path, "wind.x")
    (tmp_path / "s.toml").write_text(
        text.replace('name = "probe"', 'name = "probe"\nstep = 0.02'), encoding="utf-8"
    )
    rows = runner.run(load_scenario(tmp_path / "s.toml")).rows
    assert rows is not None
    own = 4 * (np.arange(rows.size) // 4)
    wind = (0.5 * rows["velocity.bridge"] + rows["time"])[own]
    # its outputs are held, but for a last step that is shorter
    assert rows["y"][4:-4] == pytest.approx(wind[4:-4], abs=1e-12)
    (tmp_path / "s.toml").write_text(
        text.replace('name = "probe"', 'name = "probe"\nstep = 0.007'), encoding="utf-8"
    )
    with pytest.raises(InputError, match=r"step 0\.007 s of probe is no multiple"):
        runner.run(load_scenario(tmp_path / "s.toml"))


def test_a_third_fmu_stands_between(runner: Runner, tmp_path: Path) -> None:
    (tmp_path / "s.toml").write_text(
        HEAD + VELOCITY + CRITERION + third(tmp_path, "velocity.bridge"),
        encoding="utf-8",
    )
    # a velocity that grows with time takes the bridge to its end stop
    assert "end stop" in runner.run(load_scenario(tmp_path / "s.toml")).error


def test_a_third_fmu_that_fails_is_a_failed_scenario(runner: Runner, tmp_path: Path) -> None:
    failing = third(tmp_path, "wind.x") + '"fail.time" = 1.0\n"fail.status" = 3\n'
    (tmp_path / "s.toml").write_text(HEAD + CRITERION + failing, encoding="utf-8")
    result = runner.run(load_scenario(tmp_path / "s.toml"))
    assert "probe" in result.error and "told to fail" in result.error and not result.passed


@pytest.mark.parametrize("place", ["step", "load"])
def test_a_third_fmu_that_ends_its_process_is_a_failed_scenario(
    place: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    require_native()
    if place == "load":
        with (tmp_path / "fmi2.c").open("w") as file:
            file.write('#include <stdlib.h>\n__attribute__((constructor)) static void end(void)'
                       '{ abort(); }\n')
            file.write((probe.HERE / "fmi2.c").read_text(encoding="utf-8"))
        shutil.copy(probe.HERE / "probe.h", tmp_path)
        monkeypatch.setattr(probe, "HERE", tmp_path)
    dies = '"fail.time" = 1.0\n"fail.status" = 99\n'
    for name, own in (("a", third(tmp_path, "wind.z") + dies), ("b", "")):
        (tmp_path / f"{name}.toml").write_text(HEAD + CRITERION + own, encoding="utf-8")
    failed, passed = validate([tmp_path / "a.toml", tmp_path / "b.toml"])
    assert "an FMU ended its process: SIGABRT; beside ours it had probe (" in failed.error
    assert not failed.passed and passed.passed


def test_the_fixture_runs_a_scenario(tmp_path: Path) -> None:
    require_native()
    for name in ("inteco.toml", "crane_inteco.toml"):
        shutil.copy(MODELS / name, tmp_path)
    head = HEAD.replace(f"{MODELS.as_posix()}/", "")
    (tmp_path / "good.toml").write_text(head + CRITERION, encoding="utf-8")
    (tmp_path / "bad.toml").write_text(
        head + CRITERION.replace("0.005", "1e-30"), encoding="utf-8"
    )
    (tmp_path / "conftest.py").write_text(
        'pytest_plugins = ["segfmu.validation.pytest_plugin"]\n', encoding="utf-8"
    )
    (tmp_path / "pytest.ini").write_text("[pytest]\n", encoding="utf-8")
    (tmp_path / "test_own.py").write_text(
        "\n".join(
            f'def test_{name}(run_scenario):\n    run_scenario("{name}.toml").require()\n'
            for name in ("good", "bad")
        ), encoding="utf-8",
    )
    done = subprocess.run(
        [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", str(tmp_path)],
        capture_output=True, text=True, cwd=tmp_path.parent, timeout=300,
    )
    assert "1 failed, 1 passed" in done.stdout, done.stdout + done.stderr
    assert "c: margin" in done.stdout
