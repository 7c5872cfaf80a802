"""Missions whose velocity drives have lags."""

from __future__ import annotations

import pytest

import segfmu
from segfmu.cosim.load import load
from segfmu.validation.planned import unknown_wind
from tests.compiler import needs_native, require_native

LAG = {"lag": 0.2}
STS = {
    "crane": {
        "bridge_mass": 1e6, "trolley_mass": 2.5e4, "payload_mass": 4e4, "drive": "velocity",
        "bridge": {"velocity_max": 0.75, "acceleration_max": 0.15, **LAG},
        "trolley": {"velocity_max": 4.0, "acceleration_max": 0.6, **LAG},
        "hoist": {"velocity_max": 1.5, "acceleration_max": 0.7, **LAG},
    },
    "waypoints": [{"position": [0, 0, -35]}, {"position": [0, 45, -20]}],
}
HALL = {
    "crane": {
        "bridge_mass": 6000.0, "trolley_mass": 1500.0, "payload_mass": 5000.0,
        "drive": "velocity",
        "bridge": {"velocity_max": 0.67, "acceleration_max": 0.3, **LAG},
        "trolley": {"velocity_max": 0.33, "acceleration_max": 0.3, **LAG},
        "hoist": {"velocity_max": 0.13, "acceleration_max": 0.2, **LAG},
    },
    "limits": {
        "x": {"velocity": 0.6, "acceleration": 0.25, "jerk": 0.5},
        "y": {"velocity": 0.6, "acceleration": 0.25, "jerk": 0.5},
        "z": {"velocity": 0.1, "acceleration": 0.15, "jerk": 0.5},
    },
    "waypoints": [{"position": [0, 0, -7]}, {"position": [4, 1, -5]}],
    "simulation": {"settle": 1.0},
}


@needs_native
@pytest.mark.parametrize("mission", [STS, HALL], ids=["40 t", "5 t"])
def test_drives_with_lag_follow_plans_without_limits_of_the_snap(mission: dict) -> None:
    found = segfmu.simulate(mission, step=0.005)
    assert found.passed and not found.note
    assert found.criteria.tracking_error < 1e-6


@needs_native
@pytest.mark.parametrize("bounds", [
    {"velocity_max": 0.13}, {"velocity_max": 2.0, "velocity_min": -0.13},
    {"velocity_max": 0.05, "velocity_min": -2.0},
], ids=["both", "lifting", "coming to rest"])
def test_the_setpoint_keeps_the_bound_of_the_velocity(bounds: dict) -> None:
    """The hoist lifts with 0.1 m/s and 0.15 m/s2: its setpoint of 1 s of lag would pass 0.13."""
    drive = {**HALL["crane"]["hoist"], "lag": 1.0, **bounds}
    mission = {**HALL, "crane": {**HALL["crane"], "hoist": drive}}
    run = segfmu.simulate(mission, step=0.005)
    assert run.passed
    assert run.criteria.tracking_error < 1e-6
    told = run.rows["velocity.hoist"]
    most, low = drive["velocity_max"], drive.get("velocity_min", -drive["velocity_max"])
    assert told.max() <= most * (1.0 + 1e-9) and told.min() >= low * (1.0 + 1e-9)
    assert max(told.max() / most, told.min() / low) > 0.99
    # a crane without this lag needs less time
    quick = segfmu.load_mission({**HALL, "crane": {**HALL["crane"], "hoist": drive | {"lag": 0.0}}})
    assert quick.plan().duration < run.trajectory.duration


@pytest.mark.parametrize("backend", ["native", "python"])
def test_a_lag_that_no_run_could_follow_is_refused(backend: str, tmp_path) -> None:
    if backend == "native":
        require_native()
    words = r"drive\.hoist\.lag must be 0 or at least 1e-05 s, got 1e-06 s; 0 is an ideal drive"
    paths = segfmu.build(output=tmp_path, backend=backend)
    with load(paths.crane) as unit:
        unit.set({"drive.mode": 2, "drive.hoist.lag": 1e-6})
        unit.enter_initialization(0.0, 1.0)
        with pytest.raises(segfmu.SimulationError, match=words):
            unit.exit_initialization()


@pytest.mark.parametrize(("source", "enabled", "wind", "told"), [
    ("state", True, {"constant": [0.0, 200.0, 0.0]}, True),
    ("state", True, {"speed": [5.0, 0.0, 0.0]}, True),
    ("measured", True, {"constant": [0.0, 200.0, 0.0]}, False),
    ("state", False, {"constant": [0.0, 200.0, 0.0]}, False), ("state", True, {}, False),
])
def test_a_feedback_that_does_not_know_the_wind(
    source: str, enabled: bool, wind: dict, told: bool
) -> None:
    changes = {"wind": wind, "controller": {"source": source, "enabled": enabled}}
    said = unknown_wind(segfmu.load_mission({**HALL, "true_crane": changes}))
    assert bool(said) == told and said.startswith("the feedback does not know the wind" * told)
