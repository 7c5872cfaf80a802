"""Scenarios whose missions have the same plan share it."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from segfmu import load_mission
from segfmu.validation.suite import Runner

MISSION = load_mission(Path(__file__).parents[2] / "models" / "paper.toml")


@pytest.mark.parametrize("changes", [
    {"crane": {"controller": {"enabled": False}}}, {"crane": {"sensors": {"sample_time": 0.05}}},
    {"crane": {"drive": "velocity"}}, {"crane": {"wind": {"constant": [1.0, 0.0, 0.0]}}},
    {"true_crane": {"payload_mass": 1.2}}, {"simulation": {"settle": 2.0}},
])
def test_what_a_plan_does_not_depend_on_makes_none(changes: dict[str, Any]) -> None:
    other = load_mission(MISSION, changes)
    assert other != MISSION
    with Runner() as runner:
        first = runner._plan(MISSION)
        assert runner._plan(other) is first
    assert np.array_equal(other.plan().coefficients, first.coefficients)


@pytest.mark.parametrize("changes", [
    {"crane": {"payload_mass": 1.2}}, {"crane": {"rope_max": 5.0}}, {"smoothness": 5},
    {"crane": {"bridge": {"velocity_max": 0.4}}}, {"limits": {"x": {"velocity": 0.4}}},
    {"crane": {"friction": {"bridge": {"coulomb": 0.2}}}},
    {"actuators": {"sway_angle": [2.0, 2.0]}},
])
def test_what_a_plan_depends_on_makes_one(changes: dict[str, Any]) -> None:
    with Runner() as runner:
        first = runner._plan(MISSION)
        assert runner._plan(load_mission(MISSION, changes)) is not first
