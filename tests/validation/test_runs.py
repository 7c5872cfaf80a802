"""Missions in Python: from a file and from objects, the result, and what it shows of itself."""

from __future__ import annotations

import shutil
import sys
from pathlib import Path

import numpy as np
import pytest

import segfmu
from segfmu.errors import InputError
from segfmu.validation.signal_table import read_table
from tests.compiler import needs_native
from tests.validation.stopped import stopped

MODELS = Path(__file__).parents[2] / "models"
CRANE = segfmu.Crane(bridge_mass=2.2, trolley_mass=1.155, payload_mass=1.0, rope_max=1.5)
LIMITS = segfmu.Limits([1.0, 0.4, 0.3], [1.0, 0.5, 0.5], [1.0, 0.5, 0.5], [10.0, 5.0, 5.0])
POINTS = [
    segfmu.Waypoint([0.0, 0.0, -0.5]),
    segfmu.Waypoint([0.07, 0.055, -0.5], [0.2, 0.17, 0.0], [0.34, 0.27, 0.0]),
    segfmu.Waypoint([1.0, 0.8, -0.5]),
]
OBJECTS = {
    "name": "in Python", "crane": CRANE, "limits": LIMITS, "waypoints": POINTS,
    "simulation": {"step": 0.01},
}


def test_a_mission_of_objects_plans_as_the_planner_does() -> None:
    direct = segfmu.plan(POINTS, LIMITS, axis_names="xyz")
    own = segfmu.load_mission(OBJECTS).plan()
    times = np.linspace(0.0, direct.duration, 50)
    assert own.duration == direct.duration
    assert np.array_equal(own(times), direct(times))


def test_a_mission_of_objects_has_their_crane() -> None:
    mission = segfmu.load_mission(OBJECTS)
    assert mission.build_crane() == CRANE
    assert mission.file is None and len(repr(mission)) < 100


def test_free_waypoints_and_obstacles_arrive() -> None:
    wall = segfmu.Obstacle("wall", [0.6, -1.0, -1.5], [0.8, 2.0, -0.7], margin=0.05)
    mission = segfmu.load_mission({
        **OBJECTS, "obstacles": [wall],
        "waypoints": [POINTS[0], segfmu.Waypoint([0.07, 0.055, -0.5], "free", "free"), POINTS[2]],
    })
    assert mission.waypoints[1].velocity == "free"
    assert mission.build_clearance().obstacles[0].margin == 0.05


def test_changes_are_those_of_the_file() -> None:
    mission = segfmu.load_mission(MODELS / "paper.toml", {"limits": {"x": {"velocity": 0.7}}})
    assert mission.limits.x.velocity == 0.7 and mission.limits.x.jerk == 1.0
    again = segfmu.load_mission(mission, {"simulation": {"step": 0.02}})
    assert again.limits.x.velocity == 0.7 and again.simulation.step == 0.02
    assert again.file == MODELS / "paper.toml"


@pytest.mark.parametrize(
    ("given", "words"),
    [
        (3, "a mission is a file or a dict, got int"),
        ({}, "mission: crane: this key is missing"),
        ({**OBJECTS, "crane": "nowhere.toml"}, "mission: crane: nowhere.toml: cannot be read"),
        ({**OBJECTS, "crane": str(MODELS / "paper.toml")}, "is a mission file, not a crane file"),
        ({**OBJECTS, "limits": segfmu.Limits(1.0, 1.0, crackle=9.0)}, "leave out crackle"),
        ({**OBJECTS, "waypoints": [segfmu.Waypoint([0, 0, -1], jerk=[1, 0, 0])]}, "alone"),
        ({**OBJECTS, "waypoints": [segfmu.Waypoint([0, 0, -1], [None, 0, 0])]}, "for all axes"),
        ({"bridge_mass": 1.0}, "this is a crane file"),
        ({**OBJECTS, "waypoints": [[0, 0, 0]]}, "waypoints.1"),
    ],
)
def test_what_is_no_mission_is_refused(given: object, words: str) -> None:
    with pytest.raises(segfmu.InputError, match=words):
        segfmu.load_mission(given)


@pytest.fixture(scope="module")
def run() -> segfmu.Run:
    return segfmu.simulate(OBJECTS)


@needs_native
def test_a_run_knows_its_signals(run: segfmu.Run) -> None:
    assert run.passed and run.time[0] == 0.0
    # the load follows the plan, computed without the FMUs
    planned = run.trajectory(run.time)
    shown = np.stack([run[f"load.position.{axis}"] for axis in "xyz"], axis=1)
    assert np.abs(shown - planned).max() < 1e-7
    assert "sway.x.angle" in run and "sway.x" not in run
    with pytest.raises(segfmu.InputError, match=r"no variable 'sway.x.angel' .* mean sway.x.angle"):
        run["sway.x.angel"]
    with pytest.raises(segfmu.InputError, match=r"run\.signals has all names"):
        run[3]


@needs_native
def test_a_run_iterates_over_its_names(run: segfmu.Run) -> None:
    assert tuple(run) == run.signals and "time" in list(run)


@needs_native
def test_a_run_is_read_only(run: segfmu.Run) -> None:
    for column in (run["error.load.norm"], run.time, run.rows, run.rows["time"]):
        with pytest.raises(ValueError, match="read-only"):
            column[5] = column[4]
    table = run.to_pandas()
    table.loc[table.index[5], "error.load.norm"] = 99.0
    assert run["error.load.norm"].max() < 1.0


@needs_native
def test_a_run_as_a_table(run: segfmu.Run, tmp_path: Path) -> None:
    table = run.to_pandas()
    assert table.index.name == "time" and len(table) == run.time.size
    assert np.array_equal(table["drive.bridge.force"], run["drive.bridge.force"])
    assert run.to_csv(tmp_path / "run.csv") == ""
    read = read_table(tmp_path / "run.csv")
    assert np.array_equal(read["time"], run.time)


@needs_native
def test_without_pandas_the_message_says_what_to_install(run: segfmu.Run, monkeypatch) -> None:
    monkeypatch.setitem(sys.modules, "pandas", None)
    with pytest.raises(segfmu.InputError, match="pip install pandas"):
        run.to_pandas()


@needs_native
@pytest.mark.parametrize("what", ["run", "plan", "path", "drives"])
def test_a_run_plots(run: segfmu.Run, what: str, tmp_path: Path) -> None:
    run.plot(what).savefig(tmp_path / "figure.png")
    assert (tmp_path / "figure.png").stat().st_size > 10_000


@needs_native
def test_reprs_are_short(run: segfmu.Run) -> None:
    assert len(repr(run)) < 200 and "tracking error below 1e-6 mm" in repr(run)
    assert "<table>" in run._repr_html_()
    with pytest.raises(segfmu.InputError, match="must be run, plan, path or drives"):
        run.plot("force")


@needs_native
def test_fmus_that_are_removed_meanwhile_are_told(tmp_path: Path) -> None:
    def remove(what: str, share: float) -> None:
        if what == "co-simulating":
            shutil.rmtree(tmp_path / "out", ignore_errors=True)

    with pytest.raises(InputError, match=r"GantryFeedforward\.fmu: was written and is gone"):
        segfmu.simulate(OBJECTS, output=tmp_path / "out", progress=remove)
    assert not list(tmp_path.iterdir())


@needs_native
def test_a_suite_is_a_table_of_its_criteria(tmp_path: Path) -> None:
    suite = segfmu.validate([MODELS / "scenarios" / "lag.toml", stopped(tmp_path)])
    table = suite.to_pandas()
    assert len(suite) == 2 and set(table["scenario"]) == {r.scenario.file.name for r in suite}
    judged = table[table["error"] == ""]
    assert np.allclose(judged["margin"] / judged["bound"].abs(), judged["normalised"])
    (row,) = table[table["error"] != ""].itertuples()
    assert "end stop" in row.error and not row.passed and row.unit == ""
    assert list(judged["unit"]) == [f.unit for f in suite.results[0].findings]
    assert len(repr(suite)) < 100 and "<table>" in suite._repr_html_()
    assert len(suite.plot().axes[0].get_yticks()) == len(judged)


@needs_native
def test_the_hoist_of_another_load_is_shown_less_its_weight() -> None:
    """It was less the weight that is planned for: 5 N at rest."""
    changes = {"true_crane": {"payload_mass": 1.5}, "simulation": {"settle": 8.0}}
    run = segfmu.simulate(segfmu.load_mission(MODELS / "paper.toml", changes), step=0.01)
    (hoist,) = (
        line for line in run.plot().axes[2].lines if line.get_label() == "hoist less weight"
    )
    assert hoist.get_ydata()[-1] == pytest.approx(0.0, abs=0.02)
