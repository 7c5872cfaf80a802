"""Baselines of a crane with a hook: its swings, what shapers leave, and the page's tables."""

from __future__ import annotations

import re
from math import inf
from pathlib import Path

import numpy as np
import pytest

from segfmu.crane import Crane
from segfmu.crane.hook import HookCrane
from segfmu.errors import InputError
from segfmu.validation.baselines.course import changes
from segfmu.validation.baselines.methods import course
from segfmu.validation.baselines.swings import swings
from segfmu.validation.campaigns.result import load_result
from segfmu.validation.files.mission_file import load_mission
from segfmu.validation.files.scenario_file import build_scenario, read_source
from segfmu.validation.suite import Runner
from tests.compiler import require_native
from tests.validation.campaigns.files import run

ROOT = Path(__file__).parents[2]
CAMPAIGNS = ROOT / "models" / "campaigns"
PORT = HookCrane(Crane(8e4, 1.2e4, 1e4), 500.0, 4.0)


def test_swings_of_a_driven_carriage_are_those_of_the_model() -> None:
    for rope in (2.0, 6.0, 12.0):
        found = swings(PORT, rope, inf)
        assert [s.frequency for s in found] == pytest.approx(PORT.frequencies(rope), rel=1e-12)
        # at first all stays where it is
        assert sum(s.end for s in found) == pytest.approx(1.0)
        assert sum(s.load for s in found) == pytest.approx(1.0)
        # under a constant acceleration rope and sling hang in one line
        hook, load = (sum(getattr(s, n) / s.frequency**2 for s in found) for n in ("end", "load"))
        assert [hook, load] == pytest.approx([rope / 9.81, (rope + 4.0) / 9.81])


def test_swings_of_a_carriage_that_yields_conserve_momentum() -> None:
    """Against the equations of three free bodies, Newton's, in absolute coordinates."""
    carriage, hook, load, g, rope, sling = 1.2e4, 500.0, 1e4, 9.81, 6.0, 4.0
    first, second = (hook + load) * g / rope, load * g / sling
    newton = np.array([
        [first, -first, 0.0], [-first, first + second, -second], [0.0, -second, second],
    ]) / np.array([carriage, hook, load])[:, None]
    expected = np.sqrt(np.sort(np.linalg.eigvals(newton).real)[1:])
    assert [s.frequency for s in swings(PORT, rope, carriage)] == pytest.approx(expected)


def test_one_load_swings_as_a_pendulum() -> None:
    (one,) = swings(PORT.crane, 9.0, inf)
    assert (one.frequency, one.end, one.load) == pytest.approx((np.sqrt(9.81 / 9.0), 1.0, 1.0))


def test_shapers_of_both_swings_leave_neither() -> None:
    """By the Fourier integral of the trolley's acceleration."""
    mission = load_mission(ROOT / "models" / "overhead.toml")
    slow, fast = PORT.frequencies(6.0)
    left = {}
    for method in ("trapezoid", "zv", "zvd_both", "zv_both"):
        own = course(mission, method)
        times = np.linspace(0.0, own.duration, 400_001)
        force = np.gradient(own.motion(times, 1)[:, 1], times)
        left[method] = [
            abs(np.trapezoid(force * np.exp(1j * f * times), times)) for f in (slow, fast)
        ]
    for method in ("zv_both", "zvd_both"):
        assert max(left[method]) < 1e-3 * min(left["trapezoid"])
    assert left["zv"][0] < 1e-3 * left["trapezoid"][0]
    assert left["zv"][1] > 100.0 * left["zv_both"][1]


def test_a_course_moves_rope_and_trolley_where_the_plan_does() -> None:
    mission = load_mission(ROOT / "models" / "overhead.toml", {
        "waypoints": [{"position": [0.0, 0.0, -10.0]}, {"position": [1.0, 20.0, -7.0]}],
    })
    for method in ("trapezoid", "zv_both", "one_load"):
        own = course(mission, method)
        times = np.arange(0.0, own.duration + 1.0, 0.01)
        state, load = own.reference(times)
        assert state[0, :3] == pytest.approx([0.0, 0.0, 6.0], abs=1e-9)
        assert state[-1] == pytest.approx([1.0, 20.0, 3.0, *np.zeros(7)], abs=1e-6)
        assert load[[0, -1]] == pytest.approx(np.array([[0.0, 0.0, -10.0], [1.0, 20.0, -7.0]]))
        _, velocity = own.setpoints(times)
        assert 0.01 * velocity.sum(axis=0) == pytest.approx([1.0, 20.0, -3.0], abs=1e-9)
        assert changes(own, "HookCrane", times)[-1].time <= own.duration + 0.02


def level(runner: Runner, method: str, **more: object) -> tuple[float, float]:
    """Distance of the load from the reference on the way, and from a swing later on [m]."""
    scenario = build_scenario(
        read_source(CAMPAIGNS / "_hook.toml"),
        {"method": method, "controller": {"enabled": False}, **more},
    )
    result = runner.run(scenario)
    assert result.rows is not None, result.error
    found = {f.name: f.bound - f.margin for f in result.findings}
    return found["on the way"], found["distance"]


def test_the_reference_swings_as_the_crane_does(runner: Runner) -> None:
    way, left = level(runner, "zv_both")
    assert way < 0.01
    assert left < 1e-4


def test_what_one_load_leaves(runner: Runner) -> None:
    _, left = level(runner, "one_load")
    assert 1e-3 < left < 1e-2
    assert level(runner, "feedforward")[1] < 1e-6


@pytest.mark.parametrize(("mission", "method", "words"), [
    ("overhead", "pd", "no method pd"), ("paper", "zvd_both", "for a crane with a hook"),
    ("paper", "one_load", "for a crane with a hook"),
])
def test_methods_for_another_crane_are_refused(mission: str, method: str, words: str) -> None:
    with pytest.raises(InputError, match=words):
        course(load_mission(ROOT / "models" / f"{mission}.toml"), method)


def told(title: str) -> dict[str, list[tuple[float, float]]]:
    """Distances [mm] and angles [deg] of the page's table whose head begins so, by method."""
    page = (ROOT / "docs" / "methods.md").read_text(encoding="utf-8")
    (block,) = re.findall(rf"^\| {title}.*\n\|.*((?:\n\|.*)+)", page, re.MULTILINE)
    rows = [[c.strip() for c in line.strip("|").split("|")] for line in block.split("\n")[1:]]
    return {
        row[0]: [(float(a), float(b)) for a, b in (cell.split(", ") for cell in row[2:])]
        for row in rows
    }


def test_the_comparison_is_as_told(tmp_path: Path) -> None:
    """At 1 kg on another load and sling, all methods with and without feedback."""
    require_native()
    text = (CAMPAIGNS / "hook_methods_lab.toml").read_text(encoding="utf-8")
    text = text.replace('"_hook', f'"{CAMPAIGNS.as_posix()}/_hook')
    own = tmp_path / "campaign.toml"
    own.write_text(text.replace('[factors.variants."exact"]\n', ""), encoding="utf-8")
    run(own, "-o", tmp_path, "--jobs", "1", code=1, threads=True)
    result = load_result(tmp_path)
    assert not result.errors and all(result.column("holds.drives"))
    table = told("1 kg")
    for i, (method, on) in enumerate(
        zip(result.column("method"), result.column("feedback"), strict=True)
    ):
        far, hook, sling = (
            result.column(f"bound.{n}")[i] - result.column(f"margin.{n}")[i]
            for n in ("distance", "hook", "sling")
        )
        expected = table[method][2 + int(on)]
        found = 1e3 * far, np.degrees(max(hook, sling))
        assert found[0] == pytest.approx(expected[0], abs=0.006, rel=1e-3), (method, on)
        assert found[1] == pytest.approx(expected[1], abs=0.0006, rel=1e-3), (method, on)
    assert len(table) * 2 == len(result.column("method")) == 14
