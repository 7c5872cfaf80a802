"""Baselines: limits, stops, what shaping and PD leave; and the comparison as the docs tell it."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

from segfmu.validation.baselines.course import changes
from segfmu.validation.baselines.methods import course
from segfmu.validation.baselines.trapezoids import Trapezoids
from segfmu.validation.campaigns.result import load_result
from segfmu.validation.files.mission_file import load_mission
from segfmu.validation.files.scenario_file import build_scenario, read_source
from segfmu.validation.suite import Runner
from tests.campaign import campaign, soaked_rows
from tests.compiler import require_native
from tests.validation.campaigns.files import run

ROOT = Path(__file__).parents[2]
CAMPAIGNS = ROOT / "models" / "campaigns"
VELOCITY = {"crane": {"drive": "velocity"}}
LEVEL = CAMPAIGNS / "_methods_lab_level.toml"


def test_baselines_stop_at_every_waypoint_within_limits_and_bounds() -> None:
    mission = load_mission(ROOT / "models" / "inteco.toml", {
        "limits": {"x": {"velocity": 1.0, "acceleration": 2.0}},
    })
    for method in ("trapezoid", "pd", "zv", "zvd"):
        own = course(mission, method)
        times = np.linspace(0.0, own.duration, 20001)
        points, speeds, gains = (
            np.stack([m(times, order) for m in own.motions], axis=-1) for order in range(3)
        )
        # the bounds of the drives are lower than these limits along x
        assert np.all(np.abs(speeds).max(axis=0) <= np.array([0.3, 0.22, 0.2]) + 1e-9)
        assert np.all(np.abs(gains).max(axis=0) <= np.array([0.6, 0.3, 0.3]) + 1e-9)
        assert points[-1] == pytest.approx([0.25, 0.3, 0.7], abs=1e-12)
        resting = points[np.abs(speeds).max(axis=1) < 1e-3]
        if method in ("trapezoid", "pd"):
            assert np.linalg.norm(resting - [0.0, 0.0, 0.5], axis=1).min() < 1e-3


def residual(own: Trapezoids, axis: int, frequency: float) -> float:
    """Amplitude of a linear pendulum behind the motion, by the Fourier integral of a''."""
    times = np.linspace(0.0, own.duration, 400_001)
    force = own.motions[axis](times, 2) * np.exp(1j * frequency * times)
    return float(abs(np.trapezoid(force, times))) / frequency


def test_shapers_leave_no_swing_and_references_end_at_rest() -> None:
    mission = load_mission(ROOT / "models" / "inteco_level.toml", VELOCITY)
    frequency = np.sqrt(9.81 / 0.6)
    bare = residual(course(mission, "trapezoid"), 0, frequency)
    for method in ("zv", "zvd"):
        own = course(mission, method)
        assert residual(own, 0, frequency) < 1e-4 * bare
        state, _ = own.reference(np.array([own.duration, own.duration + 1.0]))
        assert state[:, 3:] == pytest.approx(np.zeros((2, 7)), abs=1e-12)


def test_the_reference_of_a_shaper_is_a_motion() -> None:
    own = course(load_mission(ROOT / "models" / "inteco.toml"), "zv")
    times = np.linspace(0.0, own.duration, 40001)
    states, _ = own.reference(times)
    rates = np.gradient(states[:, :5], times, axis=0)
    assert states[:, 5:] == pytest.approx(rates, abs=2e-3)
    assert np.abs(states[:, 3]).max() > 0.01


def test_inputs_move_the_carriage_exactly_and_end_at_the_place() -> None:
    own = course(load_mission(ROOT / "models" / "inteco.toml"), "trapezoid")
    times = np.arange(0.0, own.duration + 0.5, 0.01)
    found = changes(own, "GantryCrane", times)
    assert found[0].time == 0.0 and found[-1].time < own.duration + 0.02
    # velocities that are held from change to change
    moved = np.zeros(3)
    for change, end in zip(found, [*(c.time for c in found[1:]), times[-1]], strict=True):
        rate = [change.values[f"velocity.{d}"] for d in ("bridge", "trolley", "hoist")]
        moved += (end - change.time) * np.array(rate)
    assert moved == pytest.approx([0.5, 0.6, -0.1], abs=1e-9)


def swing(runner: Runner, method: str, **changes: object) -> tuple[float, float]:
    """Largest sway along x behind the motion [rad], and its least within the last period."""
    scenario = build_scenario(read_source(LEVEL), {"method": method, **changes})
    result = runner.run(scenario)
    assert result.rows is not None, result.error
    times, sway = result.rows["time"], np.abs(result.rows["sway.x.angle"])
    end = result.known["end"]
    return (
        float(sway[times >= result.known["arrival"]].max()), float(sway[times > end - 1.6].max())
    )


OFF = {"controller": {"enabled": False}}


def test_the_fmu_swings_as_the_linear_pendulum(runner: Runner) -> None:
    mission = load_mission(ROOT / "models" / "inteco_level.toml", VELOCITY)
    expected = residual(course(mission, "trapezoid"), 0, np.sqrt(9.81 / 0.6)) / 0.6
    bare, _ = swing(runner, "trapezoid", **OFF)
    assert expected > 0.05
    assert bare == pytest.approx(expected, rel=0.02)
    shaped, _ = swing(runner, "zv", **OFF)
    assert shaped < 0.001 * bare


def test_pd_knows_nothing_of_the_sway_and_feedback_does(runner: Runner) -> None:
    sway = {"simulation": {"initial_sway": [0.5, 0.0]}}
    _, last = swing(runner, "pd", **sway)
    # the carriages hold their places, so most of the swing stays
    assert 0.5 < last / swing(runner, "trapezoid", **sway, **OFF)[1] < 1.05
    assert swing(runner, "zv", **sway)[1] < 0.02 * swing(runner, "zv", **sway, **OFF)[1]


def told() -> list[dict[tuple[str, str], float]]:
    """The tables of the page: distances [mm] by disturbance and method."""
    page = (ROOT / "docs" / "methods.md").read_text(encoding="utf-8")
    found = []
    for block in re.findall(r"^\| \[mm\] .*(?:\n\|.*)+", page, re.MULTILINE):
        head, _, *rows = [
            [cell.strip() for cell in line.strip("|").split("|")] for line in block.splitlines()
        ]
        found.append({
            (disturbance, name): float(value)
            for row in rows for disturbance in row[0].split(", ")
            for name, value in zip(head[1:], row[1:], strict=True)
        })
    return found


def every(step: int, name: str, folder: Path) -> Path:
    """The campaign's file with its first scenario and each `step`-th disturbance."""
    text = (CAMPAIGNS / f"methods_{name}.toml").read_text(encoding="utf-8")
    head, disturbances, methods = text.split("[[factors]]")
    head = re.sub(r'scenarios = \["(.+?)".*\]', rf'scenarios = ["{CAMPAIGNS.as_posix()}/\1"]', head)
    first, *variants = re.split(r"(?m)^(?=\[factors\.variants\.)", disturbances)
    chosen = first + "".join(variants[::step])
    (folder / "campaign.toml").write_text("[[factors]]".join([head, chosen, methods]), "utf-8")
    return folder / "campaign.toml"


@pytest.mark.parametrize(("name", "place"), [("quay", 1), *soaked_rows(("lab", 0))])
@campaign(2, 13, "disturbances")
def test_the_comparison_is_as_told_and_every_drive_within_its_bounds(
    name: str, place: int, disturbances: int, tmp_path: Path
) -> None:
    require_native()
    path = every(12 // (disturbances - 1), name, tmp_path)
    run(path, "-o", tmp_path, "--jobs", "1", code=1, threads=True)
    result = load_result(tmp_path)
    assert not result.errors
    assert all(result.column("holds.drives"))
    table = told()[place]
    count = 0
    for i, method in enumerate(result.column("method")):
        row = result.column("disturbance")[i]
        distance = 1e3 * (result.column("bound.distance")[i] - result.column("margin.distance")[i])
        assert distance == pytest.approx(table[row, method], abs=0.06, rel=1e-3), (row, method)
        arrival = table["arrival [s]", method]
        assert result.column("arrival")[i] == pytest.approx(arrival, abs=0.06)
        count += 1
    assert len(table) == 14 * 8
    assert count == disturbances * 8
