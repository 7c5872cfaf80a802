"""Trajectories that were put together of what does not make one."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from segfmu import InputError, Limits, Waypoint, plan, verify

SOUND = plan([Waypoint([0.0, 0.0]), Waypoint([1.0, 2.0])], Limits(1.0, 1.0, 1.0, 1.0))


@pytest.mark.parametrize(("change", "words"), [
    ({"limits": None}, "trajectory: limits must be Limits, got None"),
    ({"waypoints": ("a", "b")}, r"trajectory: waypoints must be a tuple of Waypoint, got \('a', "),
    ({"waypoints": None}, "trajectory: waypoints must be a tuple of Waypoint, got None"),
    ({"axis_names": ("x", None)}, "trajectory: axis_names must be a tuple of str"),
    ({"axis_names": "x"}, "trajectory: axis_names must be a tuple of str, got 'x'"),
    ({"smoothness": None}, "trajectory: smoothness must be an integer, got None"),
    ({"smoothness": 0}, "trajectory: smoothness must be from 1 to 6, got 0"),
    ({"synchronize": None}, "synchronize None, not one of"),
    ({"offsets": np.zeros(1, dtype=int)}, "2 waypoints of 0 axes, but the times of 2 x 2"),
    ({"offsets": np.zeros(3)}, "trajectory: offsets must be an array of integers"),
    ({"coefficients": np.zeros(3)}, r"coefficients must have 2 dimensions, got shape \(3,\)"),
    ({"timing": np.array(["a"])}, "trajectory: timing must be an array of numbers"),
])
def test_attributes_have_their_types(change: dict, words: str) -> None:
    with pytest.raises(InputError, match=words):
        verify(replace(SOUND, **change))


@pytest.mark.parametrize(
    "name", ["timing", "coefficients", "offsets", "axis_waypoint_times", "axis_durations"]
)
def test_arrays_are_arrays(name: str) -> None:
    with pytest.raises(InputError, match=f"trajectory: {name} must be an array of .*, got None"):
        verify(replace(SOUND, **{name: None}))
