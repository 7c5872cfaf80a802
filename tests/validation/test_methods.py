"""Baselines and courses: limits, stops, and what shaping does on the nonlinear plant."""

from __future__ import annotations

import numpy as np
import pytest

from segfmu.crane import Plant, Setpoints
from segfmu.crane.feedforward import Compensation
from segfmu.crane.shaping import zv, zvd
from segfmu.validation.methods import (
    NO_FEEDBACK,
    baseline_course,
    baseline_motions,
    planned_course,
    rope_range,
)
from tests.validation.moves import DIAGONAL, STRAIGHT, mission


def test_baselines_stop_at_every_waypoint_within_the_limits() -> None:
    task = mission((0.0, 0.0, -0.5), (0.4, 0.1, -0.3), (0.1, 0.2, -0.6))
    motions = baseline_motions(task, None, driven=True)
    times = np.linspace(0.0, motions[0].duration, 20001)
    points = np.stack([motion(times) for motion in motions], axis=-1)
    speeds = np.stack([motion(times, 1) for motion in motions], axis=-1)
    resting = np.flatnonzero(np.abs(speeds).max(axis=1) < 1e-4)
    middle = np.linalg.norm(points[resting] - [0.4, 0.1, 0.3], axis=1)
    assert middle.min() < 1e-4
    assert points[-1] == pytest.approx([0.1, 0.2, 0.6], abs=1e-12)
    assert np.abs(speeds).max() <= 0.3 + 1e-12
    assert max(np.abs(motion(times, 2)).max() for motion in motions) <= 0.6 + 1e-12
    assert len({motion.duration for motion in motions}) == 1


@pytest.mark.parametrize("driven", [True, False])
@pytest.mark.parametrize("shaper", [zv, zvd])
def test_shaping_leaves_no_sway_where_the_rope_is_constant(shaper, driven: bool) -> None:
    crane = STRAIGHT.build_crane()
    swings = []
    for chosen in (None, shaper):
        motions = baseline_motions(STRAIGHT, chosen, driven)
        duration = max(m.duration for m in motions)
        times = np.arange(round((duration + 1.5) / 1e-3)) * 1e-3
        course = baseline_course(crane, motions, Compensation(), times)
        aims = [
            Setpoints(*rows)
            for rows in zip(course.force, course.velocity, course.reference, strict=True)
        ]
        plant = Plant(crane, course.reference[0], aims[0], NO_FEEDBACK, driven=driven)
        swing = 0.0
        for time, aim in zip(times[1:], aims[1:], strict=True):
            plant.step(1e-3, aim)
            swing = max(swing, abs(plant.state[3]) if time >= duration else 0.0)
        swings.append(np.degrees(swing))
    assert swings[0] > 1.0
    # the shapers are those of the linear pendulum
    assert swings[1] < 0.05 * swings[0]


def test_the_planned_course_is_the_plan() -> None:
    crane, trajectory = DIAGONAL.build_crane(), DIAGONAL.plan()
    times = np.array([0.0, 0.5 * trajectory.duration, trajectory.duration + 1.0])
    course = planned_course(crane, trajectory, Compensation(), times)
    assert course.duration == trajectory.duration
    assert course.load[0] == pytest.approx([0.0, 0.0, -0.5])
    assert course.load[2] == pytest.approx([0.3, 0.2, -0.4])
    assert crane.load(course.reference[1])[0] == pytest.approx(course.load[1], abs=1e-12)
    assert course.force[2] == pytest.approx([0.0, 0.0, -9.81])


def test_rope_range_is_the_crane_s_or_that_of_the_move() -> None:
    assert rope_range(DIAGONAL.build_crane(), DIAGONAL.plan()) == (0.2, 0.8)
    assert rope_range(STRAIGHT.build_crane(), STRAIGHT.plan()) == pytest.approx((0.4, 0.6))
