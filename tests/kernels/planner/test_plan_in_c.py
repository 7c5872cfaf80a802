"""The pure-C entry point, in a program without Python, gives what `plan` gives."""

from __future__ import annotations

import subprocess
from pathlib import Path

import numpy as np
import pytest

from segfmu import Limits, Waypoint, plan
from segfmu.planning.problem import SHAPES, SYNCHRONIZATIONS
from tests.compiler import needs_cc
from tests.kernels.planner.c_planner import compiled
from tests.sharing import shared

POINTS = [
    Waypoint([0.0, 0.0, -1.0]), Waypoint([0.07, 0.055, -0.9], [0.2, 0.1, 0.0], [0.3, 0.2, 0.0]),
    Waypoint([1.0, 0.8, -0.5], dwell=0.3), Waypoint([1.4, 0.8, -0.9]),
]
LIMITS = Limits([1.0, 0.4, 0.5], [1.0, 0.5, 0.8], [1.0, 0.5, 4.0], [10.0, 5.0, 30.0])

pytestmark = needs_cc


@pytest.fixture(scope="module")
def driver(tmp_path_factory: pytest.TempPathFactory, kernels_in_c: Path) -> Path:
    """The driver, compiled from the sources that ship."""
    source = Path(__file__).with_name("plan_driver.c")
    return shared(
        tmp_path_factory, "plan_driver",
        lambda folder: compiled(folder / "driver", kernels_in_c, source),
    ) / "driver"


def run(driver: Path, points, limits, *, smoothness=4, shape="plateau",
        synchronize="waypoints", sample_time=0.0, duration=0.0) -> list[list[float]]:
    axes = points[0].axes
    head = [len(points), axes, smoothness]
    head += [SHAPES.index(shape), SYNCHRONIZATIONS.index(synchronize)]
    states = [np.ravel([getattr(p, q) for p in points]) for q in
              ("position", "velocity", "acceleration", "dwell")]
    numbers = np.concatenate(
        [[sample_time, duration], *states, limits.table(axes, smoothness).ravel()]
    )
    text = " ".join([str(h) for h in head] + [float(x).hex() for x in numbers])
    done = subprocess.run(
        [driver], input=text, capture_output=True, text=True, check=True, timeout=20
    )
    return [[float(x) for x in line.split()] for line in done.stdout.splitlines()]


@pytest.mark.parametrize(
    "options",
    [
        {}, {"shape": "smoothstep"}, {"synchronize": "total"}, {"synchronize": "none"},
        {"sample_time": 0.02}, {"duration": 12.0}, {"smoothness": 6},
    ],
)
def test_the_same_trajectory(driver: Path, options) -> None:
    found = run(driver, POINTS, LIMITS, **options)
    trajectory = plan(POINTS, LIMITS, **options)
    assert found[0] == [0, pytest.approx(trajectory.duration, rel=1e-12)]
    times = trajectory.duration * np.arange(50) / 49.0
    values = np.concatenate([trajectory(times, d) for d in range(3)], axis=1)
    assert np.allclose(found[1:], values, rtol=1e-12, atol=1e-12)


@pytest.mark.parametrize("options", [{}, {"sample_time": 0.07}, {"synchronize": "total"}])
def test_equal_waypoints_are_one(driver: Path, options) -> None:
    points = [POINTS[0], *POINTS, POINTS[-1]]
    points.insert(3, Waypoint(POINTS[2].position, dwell=0.1))
    found = run(driver, points, LIMITS, **options)
    trajectory = plan(points, LIMITS, **options)
    assert found[0] == [0, pytest.approx(trajectory.duration, rel=1e-12)]
    values = trajectory(trajectory.duration * np.arange(50) / 49.0)
    assert np.allclose(np.array(found[1:])[:, :3], values, rtol=1e-12, atol=1e-12)
    assert run(driver, [POINTS[0]] * 3, LIMITS)[0] == [0, 0.0]


def test_many_waypoints_fit_the_space(driver: Path) -> None:
    random = np.random.default_rng(2)
    places = np.cumsum(random.uniform(0.1, 1.0, (16, 3)), axis=0)
    points = [Waypoint(places[0])]
    points += [Waypoint(p, random.uniform(0.0, 0.2, 3)) for p in places[1:-1]]
    points.append(Waypoint(places[-1]))
    found = run(driver, points, LIMITS)
    assert found[0] == [0, pytest.approx(plan(points, LIMITS).duration, rel=1e-12)]


def test_refusals_carry_their_code(driver: Path) -> None:
    fast = [POINTS[0], Waypoint([1.0, 0.5, -1.0], [0.0, 0.5, 0.0])]
    assert run(driver, fast, LIMITS)[0] == [-7, 1]
    assert run(driver, POINTS, LIMITS, duration=1.0)[0][0] == -5
    braking = [Waypoint([0.0], [0.99], [1.0]), Waypoint([9.0])]
    assert run(driver, braking, Limits(1.0, 1.0, 1.0, 10.0))[0] == [-1, 0]
