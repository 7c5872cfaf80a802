"""When profiles whose acceleration keeps its sign can exist: against motions that do."""

from __future__ import annotations

import numpy as np
import pytest

from segfmu.kernels.planner.ramp import ramp_distance, ramp_duration
from segfmu.kernels.planner.records import Problem
from segfmu.kernels.planner.window import early_window, short_window
from tests.campaign import campaign
from tests.problems import packed_axis

TOP, JERK = 1.7, 2.3


def motion(random: np.random.Generator) -> tuple[float, np.ndarray]:
    """Duration and problem of a random acceleration >= 0 within the limits of it and the jerk."""
    count = int(random.integers(2, 6))
    times = 10.0 ** random.uniform(-2.0, 0.5, count)
    levels = [float(random.choice([0.0, TOP, random.uniform(0.0, TOP)]))]
    for time in times:
        change = random.choice([-1.0, 1.0, random.uniform(-1.0, 1.0)]) * JERK * time
        levels.append(float(np.clip(levels[-1] + change, 0.0, TOP)))
    v = y = 0.0
    start = random.normal()
    for time, a, b in zip(times, levels[:-1], levels[1:], strict=True):
        y += (start + v) * time + time * time * (2.0 * a + b) / 6.0
        v += 0.5 * (a + b) * time
    problem = np.zeros(Problem.SIZE)
    problem[[Problem.V, Problem.A, Problem.W, Problem.B, Problem.DISTANCE]] = (
        start, levels[0], start + v, levels[-1], y
    )
    return float(times.sum()), problem


def mirrored(problem: np.ndarray) -> np.ndarray:
    """The same motion in the other direction."""
    return -problem


def reversed_in_time(problem: np.ndarray) -> np.ndarray:
    """The same path from its end, velocities kept."""
    v, a, w, b, y = problem[
        [Problem.V, Problem.A, Problem.W, Problem.B, Problem.DISTANCE]
    ]
    back = np.zeros(Problem.SIZE)
    back[[Problem.V, Problem.A, Problem.W, Problem.B, Problem.DISTANCE]] = w, -b, v, -a, y
    return back


@campaign(1000, 4000)
@pytest.mark.parametrize("snap", [0.0, 1e6])
@pytest.mark.parametrize("turned", [np.copy, mirrored, reversed_in_time])
def test_no_motion_that_exists_is_excluded(turned, snap: float, count: int) -> None:
    axis = packed_axis(4 if snap else 3, 1, [100.0, TOP, JERK, snap, 0.0][: 5 if snap else 4])
    random = np.random.default_rng(3)
    tried = 0
    for _ in range(count):
        duration, problem = motion(random)
        a, b = problem[[Problem.A, Problem.B]]
        single, _ = ramp_duration(abs(b - a), axis)
        gain = problem[Problem.W] - problem[Problem.V]
        # the ramps of a plan are smoother than those of the motion: they last longer and gain more
        if a + b == 0.0 or duration < single or gain < 0.5 * (a + b) * single:
            continue
        tried += 1
        problem = turned(problem)
        assert early_window(duration * (1.0 + 1e-6), problem, axis) >= duration * (1.0 - 1e-6)
        assert early_window(3.0 * duration, problem, axis) >= duration * (1.0 - 1e-6)
    assert tried > count // 2


def test_a_distance_out_of_reach_is_excluded() -> None:
    axis = packed_axis(4, 1, [100.0, TOP, JERK, 1e6, 0.0])
    problem = np.zeros(Problem.SIZE)
    # 1 m/s is gained from rest in at least 1 / TOP; later than at the end is not possible
    problem[[Problem.A, Problem.W, Problem.B]] = 0.2, 1.0, 0.2
    near, far = problem.copy(), problem.copy()
    near[Problem.DISTANCE], far[Problem.DISTANCE] = 0.05, 1.5
    assert early_window(20.0, near, axis) == 0.0
    assert early_window(20.0, far, axis) > 1.5
    assert early_window(1.0, far, axis) == 0.0


@campaign(150, 500)
@pytest.mark.parametrize("turned", [np.copy, mirrored, reversed_in_time])
def test_a_small_acceleration_of_unlike_sign_is_set_aside(turned, count: int) -> None:
    axis = packed_axis(3, 1, [100.0, TOP, JERK, 0.0])
    random = np.random.default_rng(4)
    tried = 0
    while tried < count:
        duration, problem = motion(random)
        a, b = problem[[Problem.A, Problem.B]]
        single, _ = ramp_duration(a, axis)
        gain = problem[Problem.W] - problem[Problem.V]
        if a == 0.0 or b > 0.0 or duration < single or gain < 0.5 * a * single:
            continue
        tried += 1
        last = -random.uniform(0.01, 0.19) * a
        spent, _ = ramp_duration(-last, axis)
        w = problem[Problem.W]
        problem[Problem.DISTANCE] += ramp_distance(w, 0.0, last, spent, spent, axis)
        problem[[Problem.W, Problem.B]] = w + 0.5 * last * spent, last
        problem = turned(problem)
        assert early_window(9.0, problem, axis) == 0.0
        whole = duration + spent
        assert short_window(3.0 * whole, problem, axis, np.zeros_like(problem)) >= whole * 0.999999
        # as large as the other one, it is not
        problem[[Problem.A, Problem.B]] = a, -a
        assert short_window(3.0 * whole, problem, axis, np.zeros_like(problem)) == 0.0
