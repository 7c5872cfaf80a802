"""Maps: limits of the carriage, no residual sway on the nonlinear plant, stable loops."""

from __future__ import annotations

from math import pi, sqrt

import numpy as np
import pytest

from segfmu import Crane, FlatInverse, InfeasibleError, Limits, Waypoint, plan
from segfmu.crane import Plant, Setpoints
from segfmu.crane.shaping import Trapezoid
from segfmu.validation.maps import (
    DESIGNS,
    Setting,
    carriage_usage,
    eigenvalue_maps,
    fastest,
    move_times,
)
from segfmu.validation.methods import NO_FEEDBACK

LIMITS = (0.3, 0.6)
GRAVITY = 9.81
CRANE = Crane(2.2, 1.155, 1.0, rope_min=0.16, rope_max=0.98)


def test_the_fastest_plan_moves_the_carriage_within_its_limits_and_leaves_no_sway() -> None:
    """In three axes, through the flat inverse and the nonlinear plant."""
    distance, height = 0.4, 0.5
    time, setting = fastest([distance], LIMITS, height, GRAVITY)
    frequency = sqrt(GRAVITY / height)
    bounds = Limits(
        *LIMITS, setting.jerk * LIMITS[1] * frequency, setting.snap * LIMITS[1] * frequency**2
    )
    points = [Waypoint([0.0, 0.0, -height]), Waypoint([distance, 0.0, -height])]
    trajectory = plan(points, bounds, shape=setting.shape)
    assert trajectory.duration == pytest.approx(time, rel=1e-9)
    inverse = FlatInverse(CRANE, trajectory)
    times = np.arange(round((time + 1.5) / 1e-3)) * 1e-3
    states, velocities = inverse.state(times), inverse.velocity(times)
    start = Setpoints(velocity=velocities[0], reference=states[0])
    plant = Plant(CRANE, states[0], start, NO_FEEDBACK, driven=True)
    speeds, swing = [], 0.0
    for moment, velocity, state in zip(times[1:], velocities[1:], states[1:], strict=True):
        plant.step(1e-3, Setpoints(velocity=velocity, reference=state))
        speeds.append(plant.state[5])
        swing = max(swing, abs(plant.state[3]) if moment > time else 0.0)
    assert plant.state[0] == pytest.approx(distance, abs=1e-6)
    assert np.abs(speeds).max() <= LIMITS[0] * (1.0 + 1e-4)
    assert np.abs(np.diff(speeds)).max() / 1e-3 <= LIMITS[1] * (1.0 + 1e-3)
    assert swing < 1e-5


def test_usage_is_that_of_the_carriage() -> None:
    """Without a lever the load's own peaks; with a lever more."""
    trajectory = Setting("plateau", 1.0, 1.0).plan(0.1, LIMITS, 0.5, GRAVITY)
    still = carriage_usage(trajectory, LIMITS, 1e-9, GRAVITY)
    peaks = [np.abs(trajectory.extrema(k + 1)).max() / LIMITS[k] for k in range(2)]
    assert still == pytest.approx(max(peaks), rel=1e-3)
    assert carriage_usage(trajectory, LIMITS, 0.5, GRAVITY) > 1.1 * still


def test_limits_that_no_setting_keeps_are_refused(monkeypatch) -> None:
    monkeypatch.setattr("segfmu.validation.maps.COARSE", np.array([50.0]))
    with pytest.raises(InfeasibleError, match=r"rope length of 0\.5 m"):
        fastest([0.4], LIMITS, 0.5, GRAVITY)


def test_move_times() -> None:
    heights, distances = np.array([0.2, 0.9]), np.array([0.1, 0.8])
    rows = move_times(heights, distances, LIMITS, GRAVITY)
    assert rows["height"].tolist() == [0.2, 0.2, 0.9, 0.9]
    assert rows["distance"].tolist() == [0.1, 0.8, 0.1, 0.8]
    for row in rows:
        least = Trapezoid(float(row["distance"]), *LIMITS).duration
        assert row["trapezoid"] == least
        assert row["zv"] - least == pytest.approx(pi * sqrt(row["height"] / GRAVITY))
        assert row["zvd"] - row["zv"] == pytest.approx(row["zv"] - least)
        # nothing that stops the load as well beats the bare trapezoid
        assert least < row["plan"] <= row["fixed"] * (1.0 + 1e-9)
    # one setting is made for the longest rope, so the shaper wins with a short one
    assert rows["fixed"][0] > rows["zv"][0]
    assert (rows["fixed"][:2] == rows["fixed"][2:]).all()


def test_every_loop_is_stable_for_every_rope_and_payload() -> None:
    rows = eigenvalue_maps(CRANE, (0.16, 0.98), 3, 3)
    assert rows.size == 2 * len(DESIGNS) * 9
    assert set(rows["payload"]) == {0.0, 1.0, 2.0}
    assert rows["length"].min() == pytest.approx(0.16)
    assert rows["length"].max() == pytest.approx(0.98)
    assert rows["eigenvalue"].min() > 0.5
    assert rows["eigenvalue"].max() < 1.0
