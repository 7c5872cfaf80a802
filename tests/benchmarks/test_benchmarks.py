"""The benchmarks run: what needs neither Ruckig nor casadi, and no assertion on time."""

from __future__ import annotations

import json
import subprocess
from importlib import import_module
from pathlib import Path

import numpy as np
import pytest
import typer
from benchmarks import __main__ as command
from benchmarks.drivers import KERNELS, NATIVE
from benchmarks.effort import OPTIMA, TOLERANCE, transitions
from benchmarks.optimal_control import Transition, linear_program, smoothest
from benchmarks.problems import KINDS, random_problems
from benchmarks.timing import interleaved, ratios
from typer.testing import CliRunner

from segfmu import plan, verify
from tests.compiler import CC, needs_cc


def run(*arguments: str):
    app = typer.Typer()
    app.command()(command.main)
    return CliRunner().invoke(app, arguments)


def test_every_part_is_a_module_with_one_entry_and_needs_no_peer_to_be_imported() -> None:
    for module, _ in command.PARTS.values():
        assert callable(import_module(f"benchmarks.{module}").measure)


def test_a_run_prints_and_saves_the_same_records(tmp_path: Path) -> None:
    target = tmp_path / "found.json"
    done = run("--quick", "--only", "f", "--output", str(target))
    assert done.exit_code == 0, done.output
    content = json.loads(target.read_text(encoding="utf-8"))
    assert content["machine"]["numpy"] == np.__version__
    records = content["parts"]["evaluation"]["sections"][0]["records"]
    assert [r["evaluated by"] for r in records] == ["scipy PPoly, by axis", "segfmu.Trajectory"]
    assert f"{records[1]['median ms']:.4g}" in done.output


def test_an_unknown_part_is_refused(tmp_path: Path) -> None:
    assert run("--only", "none", "--output", str(tmp_path / "found.json")).exit_code == 2


def test_contestants_take_turns() -> None:
    calls: list[str] = []
    times = interleaved({name: lambda _, n=name: calls.append(n) for name in "ab"}, 3, 2)
    assert "".join(calls) == "aaabbb" + "baabba" + "abbaab"
    assert all(values.shape == (2, 3) and (values > 0.0).all() for values in times.values())


def test_ratios_are_of_the_same_pass() -> None:
    found = ratios(np.array([2.0, 9.0, 8.0]), np.array([1.0, 3.0, 2.0]))
    assert found == {"ratio": 3.0, "least": 2.0, "largest": 4.0}


@pytest.mark.parametrize("kind", KINDS)
def test_random_problems_are_repeatable_and_keep_their_limits(kind: str) -> None:
    first, second = (random_problems(kind, 2, 200, 4) for _ in range(2))
    assert (first.positions == second.positions).all()
    for values, column in ((first.velocities, 0), (first.accelerations, 1)):
        assert (np.abs(values) <= first.limits[:, None, :, column]).all()
        assert values.any() == (kind != "rest to rest")
    assert (first.positions[:, 0] == 0.0).all()


def test_a_problem_means_the_same_to_the_planner() -> None:
    problems = random_problems("rest to rest", 2, 5, 4)
    trajectory = plan(problems.waypoints(3), problems.bounds(3, 4))
    assert verify(trajectory).passed
    assert trajectory(trajectory.duration) == pytest.approx(problems.positions[3, 1], abs=1e-12)
    assert (trajectory.limits.table(2, 4) == problems.table(4)[3]).all()


def test_linear_programs_find_the_optimum_of_snap_alone() -> None:
    transition = Transition("", (0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (9.0, 9.0, 9.0, 8.0))
    duration, _ = linear_program(transition, 32, TOLERANCE)
    # farthest point at rest: c_4 / 3! times the least L1 norm of a monic cubic over T, T^4 / 64,
    # that of the Chebyshev polynomial of the second kind
    assert duration == pytest.approx((384.0 / 8.0) ** 0.25, rel=0.003)


def test_the_smoothest_motion_is_a_polynomial_of_degree_seven_where_no_limit_matters() -> None:
    wide = Transition("", (0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (9.0, 90.0, 900.0, 9000.0))
    # 35 s^4 - 84 s^5 + 70 s^6 - 20 s^7, whose fourth derivative has the mean square 100800
    assert smoothest(wide, 2.0, 60) == pytest.approx(np.sqrt(100800.0) / 2.0**4, rel=2e-3)


def test_the_smoothest_motion_keeps_its_limits() -> None:
    rest, end = (0.0, 0.0, 0.0), (1.0, 0.0, 0.0)
    free, slow, none = (
        smoothest(Transition("", rest, end, (velocity, 9.0, 200.0, 9000.0)), 1.0, 60)
        for velocity in (2.2, 1.5, 1.01)
    )
    # the polynomial peaks at 35/16 m/s
    assert slow > 1.3 * free
    assert np.isnan(none)


def test_the_table_of_optima_belongs_to_the_mission_file() -> None:
    assert [t.name for t in transitions()] == list(OPTIMA)
    assert [t.limits[3] for t in transitions()] == [10.0, 10.0, 5.0, 5.0]


@needs_cc
def test_the_driver_fits_the_kernels() -> None:
    flags = ["-std=c99", "-fsyntax-only", "-Wall", "-Werror=incompatible-pointer-types"]
    done = subprocess.run(
        [CC, *flags, f"-I{KERNELS}", str(NATIVE / "segfmu_driver.c")],
        capture_output=True, text=True,
    )
    assert done.returncode == 0, done.stderr
