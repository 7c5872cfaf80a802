"""Missions that have most in common with one that was found right: the rest is checked."""

from __future__ import annotations

from pathlib import Path

import pytest

from segfmu import InputError
from segfmu.validation.files.mission_file import load_mission

RIGHT = Path(__file__).parents[3] / "models" / "paper.toml"
LOW = [0.5, 0.0, 0.1]


@pytest.mark.parametrize(("changes", "words"), [
    ({"workspace": {"x": [1.0, 0.0]}}, "workspace"),
    ({"waypoints": [{"position": [0.0, 0.0, -0.5]}, {"position": LOW}]}, "waypoints.2.position"),
    ({"crane": {"travel": {"bridge": [5.0, 6.0]}}}, "end stops"),
    ({"limits": {"x": {"velocity": 0.5}}, "waypoints": [
        {"position": [0.0, 0.0, -0.5]},
        {"position": [0.5, 0.0, -0.5], "velocity": [0.9, 0.0, 0.0]},
        {"position": [1.0, 0.0, -0.5]},
    ]}, "exceeds"),
    ({"true_crane": {"rope_min": 2.0, "rope_max": 1.0}}, "true_crane"),
    ({"true_crane": {"hook": {"mass": 0.2, "sling": 0.2}}}, "true_crane.hook"),
])
def test_what_differs_from_a_right_mission_is_checked(changes: dict, words: str) -> None:
    load_mission(RIGHT)
    load_mission(RIGHT, {"simulation": {"settle": 1.0}})
    with pytest.raises(InputError, match=words):
        load_mission(RIGHT, changes)
    load_mission(RIGHT)
