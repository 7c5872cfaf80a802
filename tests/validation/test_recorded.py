"""Recordings of commands: scenarios and missions that follow them as an operator does."""

from __future__ import annotations

import re
from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest

import segfmu
from segfmu.errors import InputError
from segfmu.validation.files.recording import load_recording
from segfmu.validation.files.scenario_file import find, load_scenario
from segfmu.validation.report import run_page
from segfmu.validation.suite import Runner
from tests.command import called
from tests.compiler import needs_native, require_native

FOLDER = Path(__file__).parents[2] / "models" / "commands"
CRANES = ("lab", "factory", "port")
KINDS = {"inching", "microspeed", "released", "retarget", "wind", "payload", "emergency"}
LOAD = [f"reference.load.position.{a}" for a in "xyz"]


def operated(mission: segfmu.Mission, path: Path, times: np.ndarray, push: float) -> np.ndarray:
    """Positions of the load of an operator that gets a recording."""
    recording, operator = load_recording(path), mission.operator()
    places, row = [operator.load[0]], 0
    for now, following in pairwise(times):
        if row < len(recording.times) and now >= recording.times[row] - 1e-9:
            values = {name: column[row] for name, column in recording.columns.items()}
            operator.command(
                str(values["command.mode"]), distance=push, scale=float(values["limits.scale"]),
                **{n: [float(values[f"command.{n}.{a}"]) for a in "xyz"]
                   for n in ("velocity", "target")},
            )
            row += 1
        places.append(operator.step(following - now)[0])
    return np.array(places)


@pytest.mark.parametrize("name", CRANES)
def test_all_scenarios_of_a_crane_pass(runner: Runner, name: str) -> None:
    paths = find([FOLDER / name])
    assert {p.stem for p in paths} == KINDS
    for path in paths:
        scenario = load_scenario(path)
        result = runner.run(scenario)
        result.require()
        assert result.rows is not None
        if path.stem == "payload":
            continue
        given = scenario.file.parameters.get("GantryFeedforward", {})
        expected = operated(
            scenario.mission, path.with_suffix(".csv"), result.rows["time"],
            given.get("command.distance.y", 0.01),
        )
        found = np.column_stack([result.rows[n] for n in LOAD])
        np.testing.assert_allclose(found, expected, atol=1e-9 * np.abs(expected).max())


def test_a_mission_follows_a_recording(tmp_path: Path) -> None:
    require_native()
    done = called(
        "simulate", str(FOLDER / "lab" / "_mission.toml"), "--commands",
        str(FOLDER / "lab" / "released.csv"), "--output", str(tmp_path), cwd=tmp_path,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    run = segfmu.simulate(
        FOLDER / "lab" / "_mission.toml", commands=FOLDER / "lab" / "released.csv"
    )
    assert run.passed
    expected = operated(run.mission, FOLDER / "lab" / "released.csv", run.time, 0.01)
    np.testing.assert_allclose(
        np.column_stack([run[n] for n in LOAD]), expected, atol=1e-9
    )
    # the load rests where its last stop has led it, and not before the last row
    assert np.ptp(expected, axis=0).max() > 0.1
    assert run.time[-1] > load_recording(FOLDER / "lab" / "released.csv").end


@pytest.mark.parametrize("crane", CRANES)
def test_missions_allow_for_an_emergency_stop(crane: str) -> None:
    """The command in docs/operator.md ended with a failed verdict."""
    run = segfmu.simulate(
        FOLDER / crane / "_mission.toml", commands=FOLDER / crane / "emergency.csv"
    )
    assert run.passed


@pytest.mark.parametrize(("crane", "told"), [
    ("lab", "31 mm"), ("factory", "0.40 m"), ("port", "1.03 m"),
])
def test_how_far_wind_pushes_the_load_is_told(crane: str, told: str) -> None:
    """The mission's tolerance is beside this, the scenario is about what comes after it."""
    run = segfmu.simulate(FOLDER / crane / "_mission.toml", commands=FOLDER / crane / "wind.csv")
    away, unit = float(run["error.load.norm"].max()), told.split()[1]
    assert told == (f"{1e3 * away:.0f} mm" if unit == "mm" else f"{away:.2f} m")
    assert not run.passed
    assert told in (FOLDER.parents[1] / "docs" / "operator.md").read_text(encoding="utf-8")


def test_values_of_a_profile_may_be_names(runner: Runner, tmp_path: Path) -> None:
    text = (
        f'name = "s"\nmission = "{(FOLDER / "lab" / "_mission.toml").as_posix()}"\n'
        '[parameters.GantryFeedforward]\n"command.enabled" = true\n"command.velocity.x" = 0.2\n'
        '[[profiles]]\nfmu = "GantryFeedforward"\nvariable = "command.mode"\ntimes = [0.5, 1.5]\n'
        'values = ["velocity", "stop"]\n'
        '[[criteria]]\nname = "it moves"\nsignal = "load.position.x"\nkind = "at"\nat = "end"\n'
        'sense = "at least"\nbound = 0.1\n'
    )
    path = tmp_path / "s.toml"
    path.write_text(text, encoding="utf-8")
    result = runner.run(load_scenario(path))
    result.require()
    assert result.rows is not None and result.rows["load.position.x"][-1] < 0.3


WRONG = {
    'file = "none.csv"': "none.csv: cannot be read",
    'file = "wind.csv"\nvariable = "wind.x"': "has a file, and variable, times or values beside it",
    'variable = "wind.x"\ntimes = [0.0]': "needs variable, times and values, or a file",
}


@pytest.mark.parametrize("profile", WRONG)
def test_what_is_no_profile_is_told(tmp_path: Path, profile: str) -> None:
    (tmp_path / "wind.csv").write_text("time,wind.x\n0,1\n", encoding="utf-8")
    path = tmp_path / "s.toml"
    path.write_text(
        f'base = "{(FOLDER / "lab" / "_base.toml").as_posix()}"\n[[profiles]]\n{profile}\n',
        encoding="utf-8",
    )
    with pytest.raises(InputError) as caught:
        load_scenario(path)
    assert WRONG[profile] in str(caught.value)


def test_a_column_that_no_fmu_has_is_told(runner: Runner, tmp_path: Path) -> None:
    scenario = load_scenario(FOLDER / "lab" / "released.toml")
    path = tmp_path / "r.csv"
    path.write_text("time,command.modes\n0,stop\n", encoding="utf-8")
    words = r"r\.csv: column command\.modes is no variable of .*; did you mean command\.mode\?"
    with pytest.raises(InputError, match=words):
        runner.run(replace(scenario, recordings=(load_recording(path),)))


@pytest.mark.parametrize(("column", "value", "told"), [
    ("command.modes", "0", "column command.modes is no variable of .* mean command.mode?"),
    ("bridge.position", "0", "line 3: GantryCrane: bridge.position cannot change"),
    ("velocity.bridge", "0", "line 3: GantryFeedforward: velocity.bridge cannot change"),
    ("reference.bridge.position", "0", "line 3: GantryFeedforward: reference.* cannot change"),
    ("limits.scale", "1.5", "line 3: GantryFeedforward: limits.scale must be at most 1, got 1.5"),
    ("command.target.x", "1e300", "line 3: .* command.target.x must be at most 1000000, got 1e"),
    ("command.go", "0.5", "line 3: GantryFeedforward: command.go takes true or false, got 0.5"),
    ("wind.x", "much", "line 3: GantryCrane: wind.x takes a number, got 'much'"),
    ("wind.x", "true", "line 3: GantryCrane: wind.x takes a number, got True"),
    ("command.go", "2", "line 3: GantryFeedforward: command.go takes true or false, got 2"),
    ("feedback.source", "0", "line 3: GantryCrane: feedback.source cannot change"),
])
def test_what_is_wrong_in_a_recording_is_told_before_there_are_fmus(
    column: str, value: str, told: str, tmp_path: Path
) -> None:
    path = tmp_path / "r.csv"
    path.write_text(f"# lab\ntime,command.mode,{column}\n0,stop,{value}\n", encoding="utf-8")
    words = re.escape(told).replace(re.escape(".*"), ".*")
    with pytest.raises(InputError, match=rf"r\.csv.*{words}"):
        segfmu.simulate(
            FOLDER / "lab" / "_mission.toml", commands=path, output=tmp_path / "out"
        )
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize(("value", "told"), [
    ("9", "must be at most 6, got 9"), ("0.5", "takes an integer"), ("fly", "takes mission, "),
])
def test_modes_of_a_recording_are_told_before_there_are_fmus(
    value: str, told: str, tmp_path: Path
) -> None:
    path = tmp_path / "r.csv"
    path.write_text(f"time,command.mode\n0,{value}\n", encoding="utf-8")
    with pytest.raises(InputError, match=rf"r\.csv, line 2: .*: command\.mode {told}"):
        segfmu.simulate(
            FOLDER / "lab" / "_mission.toml", commands=path, output=tmp_path / "out"
        )
    assert not (tmp_path / "out").exists()


def test_a_crane_with_a_hook_follows_no_commands() -> None:
    with pytest.raises(InputError, match="a crane with a hook has no commands"):
        segfmu.simulate(
            FOLDER.parent / "hook_lab.toml", commands=FOLDER / "lab" / "released.csv"
        )


@needs_native
def test_the_report_of_commands_tells_no_plan_that_was_not_followed(tmp_path: Path) -> None:
    """It had the mission's plan, arrivals at its waypoints, and another command."""
    mission = FOLDER.parent / "container.toml"
    commands = tmp_path / "my commands.csv"
    commands.write_bytes((FOLDER / "port" / "inching.csv").read_bytes())
    run = segfmu.simulate(mission, step=0.02, commands=commands)
    page = run_page(run)
    assert page.kind == "Co-simulated mission under commands"
    assert page.facts[0] == ("at rest from", f"{run.criteria.duration:.3f} s")
    titles = [section.title for section in page.sections]
    assert titles == ["Drives against their bounds", "Sway", "Tracking error", "What was run"]
    assert all(not section.arrivals for section in page.sections)
    (table,) = page.sections[-1].tables
    assert ("commands", "my commands.csv") in table.rows
    assert page.sections[-1].commands == [
        f"segfmu simulate {mission} --step 0.02 --commands '{commands}'"
    ]
    panels = run.plot().axes
    assert panels[-1].get_xlabel() == "time [s]; dashed: bounds of the drives"
    # 115 W of 589 kW: bounds that make it a line are in the legend
    assert panels[3].get_ylabel() == "power\n[W]" and panels[3].get_ylim()[1] < 200.0
    assert "hoist, of 589 kW" in [t.get_text() for t in panels[3].get_legend().get_texts()]


@pytest.mark.parametrize(("changes", "step", "words"), [
    (None, None, "segfmu simulate {}"), (None, 0.05, "segfmu simulate {} --step 0.05"),
    ({"simulation": {"settle": 1.0}}, None, ""),
])
@needs_native
def test_a_run_tells_the_command_that_repeats_it(
    changes: dict[str, object] | None, step: float | None, words: str
) -> None:
    """Of a mission that was changed in Python there is none."""
    file = FOLDER.parent / "paper.toml"
    mission = segfmu.load_mission(segfmu.load_mission(file, changes))
    run = segfmu.simulate(mission, step=step)
    assert run.again == words.format(file)
    assert run_page(run).sections[-1].commands == ([run.again] if words else [])
