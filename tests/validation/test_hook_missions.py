"""Missions of a crane with a hook through the functions of the commands, from plan to report."""

from __future__ import annotations

from itertools import product
from pathlib import Path

import numpy as np
import pytest

import segfmu
from segfmu.cosim import simulate
from segfmu.validation.files.mission_file import load_mission
from segfmu.validation.output import plan_samples
from segfmu.validation.report.run_page import run_page
from tests.campaign import soaked
from tests.compiler import require_native

MODELS = Path(__file__).parents[2] / "models"
MISSIONS = ("hook_lab", "overhead")


@pytest.fixture(scope="module", params=product(MISSIONS, ("force", "velocity")))
def run(request) -> segfmu.Run:
    require_native()
    name, drive = request.param
    # drives apply forces, or follow velocities without lag
    return segfmu.simulate(load_mission(MODELS / f"{name}.toml", {"crane": {"drive": drive}}))


def test_the_load_keeps_to_its_plan_and_rests_behind_it(run) -> None:
    assert run.passed
    # 0.3 nm at 1 kg, 0.05 nm at 10 t
    assert run.criteria.tracking_error < 1e-9
    assert run.criteria.residual_sway < 1e-4
    assert max(np.abs(run["sling.y.angle"]).max(), np.abs(run["sway.y.angle"]).max()) > 0.01


def test_a_drive_is_used_in_full(run) -> None:
    assert 0.999 < max(use.use for use in run.criteria.uses) < 1.0 + 1e-3


def test_the_report_shows_hook_and_sling(run) -> None:
    page = run_page(run)
    (scene,) = page.scenes
    assert len(scene["frames"]) == 12
    hook, load = (np.array(scene["frames"][i]) for i in (slice(7, 10), slice(2, 5)))
    distance = np.linalg.norm(hook - load, axis=0)
    assert distance == pytest.approx(run.mission.crane.hook.sling, rel=2e-3)
    titles = [chart.title for section in page.sections for chart in section.charts]
    assert {"sway along x", "sway along y", "sling along x", "sling along y"} <= set(titles)
    told = [cell for table in page.sections[-1].tables for row in table.rows for cell in row]
    assert "hook" in told and "sling" in told


def test_plots_of_a_run_show_the_sling(run) -> None:
    labels = [t.get_text() for axes in run.plot().axes for t in axes.get_legend().get_texts()]
    assert "ψy, sling" in labels


@pytest.mark.parametrize("name", ["overhead", *soaked("hook_lab")])
def test_archives_of_a_mission_plan_it_by_themselves(tmp_path, name: str) -> None:
    require_native()
    mission = load_mission(MODELS / f"{name}.toml")
    archives = segfmu.build(mission, tmp_path)
    assert archives.feedforward.name == "HookFeedforward.fmu"
    end = mission.plan().duration + 1.0
    rows = simulate(*archives, stop_time=end, step=mission.simulation.step)
    last = rows[-1]
    assert last["plan.done"]
    assert [last[f"load.position.{a}"] for a in "xyz"] == pytest.approx(
        mission.waypoints[-1].position, abs=1e-5
    )


def test_a_longer_sling_makes_a_longer_plan() -> None:
    durations = [
        load_mission(MODELS / "overhead.toml", {
            "crane": {"hook": {"sling": sling}},
            "waypoints": [{"position": [0.0, y, -6.0 - sling]} for y in (0.0, 20.0)],
        }).plan().duration for sling in (0.5, 4.0, 6.0)
    ]
    assert durations == sorted(durations) and durations[-1] > 1.01 * durations[0]


def test_tables_of_plans_have_forces_that_do_not_jump() -> None:
    limits = {a: {"velocity": 1.0, "acceleration": 0.1, "jerk": 0.1} for a in "xyz"}
    drive = {"velocity_max": None, "acceleration_max": None}
    free = {"crane": dict.fromkeys(("bridge", "trolley", "hoist"), drive), "limits": limits}
    for smoothness in (5, 6):
        own = load_mission(MODELS / "overhead.toml", {**free, "smoothness": smoothness})
        names = plan_samples(own, own.plan(), 10).dtype.names
        assert ("force.trolley" in names) is (smoothness == 6)
        assert "velocity.trolley" in names


def test_the_scenario_passes_as_it_says() -> None:
    require_native()
    suite = segfmu.validate(MODELS / "scenarios" / "hook.toml")
    assert suite.passed
    (result,) = suite
    # carriages and rope start as planned, so the load hangs lower by what the sling is longer
    assert result.rows["load.position.z"][0] == pytest.approx(-10.4, abs=1e-6)


def test_the_feedback_helps_a_plan_that_leaves_the_drives_no_room() -> None:
    """It knows the velocity bounds: it does not take for made what a drive cannot follow."""
    require_native()
    far = []
    for enabled in (False, True):
        run = segfmu.simulate(load_mission(MODELS / "overhead.toml", {
            "true_crane": {"payload_mass": 13000.0, "hook": {"sling": 4.4}},
            "simulation": {"step": 0.01, "feedback": enabled},
        }))
        error = np.hypot(run["error.load.x"], run["error.load.y"])
        far.append((error.max(), error[run.time > run.trajectory.duration + 6.4].max()))
    assert far[1][0] < 0.6 * far[0][0]
    assert far[1][1] < 0.1 * far[0][1]
