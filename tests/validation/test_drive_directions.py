"""Missions whose drives differ by direction: runs of both FMUs, judged by Newton's laws."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import segfmu
from segfmu.errors import InputError
from tests.campaign import soaked
from tests.compiler import needs_native
from tests.crane.newton import accelerations
from tests.test_cli import invoke

LAB: dict[str, Any] = {
    "crane": {
        "bridge_mass": 2.2, "trolley_mass": 1.155, "payload_mass": 1.0, "drive": "force",
        "bridge": {"velocity_max": 1.0, "acceleration_max": 1.0},
        # brakes harder than it drives, on the way there
        "trolley": {"velocity_max": 1.0, "force_max": 0.8, "force_min": -2.0},
        # lowers faster than it lifts
        "hoist": {"velocity_max": 0.4, "velocity_min": -0.15, "acceleration_max": 0.8},
    },
    "waypoints": [{"position": [0, 0, -0.5]}, {"position": [0, 1, -0.9]},
                  {"position": [0, 1, -0.5]}],
    "simulation": {"settle": 0.5},
}
STS: dict[str, Any] = {
    "crane": {
        "bridge_mass": 3e5, "trolley_mass": 1.5e4, "payload_mass": 4e4, "drive": "velocity",
        "bridge": {"lag": 0.1, "velocity_max": 0.75, "acceleration_max": 0.15},
        "trolley": {"lag": 0.1, "velocity_max": 4.0, "acceleration_max": 0.4,
                    "acceleration_min": -0.8},
        "hoist": {"lag": 0.1, "velocity_max": 2.5, "velocity_min": -1.2,
                  "acceleration_max": 0.7, "acceleration_min": -0.5},
    },
    "waypoints": [{"position": [0, 0, -20]}, {"position": [0, 40, -20]},
                  {"position": [0, 40, -36]}, {"position": [0, 40, -22]}],
    "simulation": {"settle": 2.0},
}
SIGNALS = {
    "velocity": ("bridge.velocity", "trolley.velocity", "rope.velocity"),
    "force": tuple(f"drive.{d}.force" for d in ("bridge", "trolley", "hoist")),
}
STATE = (
    "bridge.position", "trolley.position", "rope.length", "sway.x.angle", "sway.y.angle",
    "bridge.velocity", "trolley.velocity", "rope.velocity", "sway.x.rate", "sway.y.rate",
)
MASSES = ("bridge_mass", "trolley_mass", "payload_mass")


@needs_native
@pytest.mark.parametrize("mission", [STS, *soaked(LAB)])
def test_no_drive_exceeds_a_direction_and_the_stronger_one_is_used(mission: dict) -> None:
    step = 0.002 if mission is LAB else 0.01
    run = segfmu.simulate(mission, step=step)
    assert run.passed, run
    rows, crane = run.rows, mission["crane"]
    found = {name: np.column_stack([rows[s] for s in signals]) for name, signals in SIGNALS.items()}
    # forces that the FMU tells move the crane by Newton's laws
    masses = (*(crane[name] for name in MASSES), 9.81)
    states = np.column_stack([rows[name] for name in STATE])
    acting = np.array([
        accelerations(state, force, np.zeros(3), *masses)
        for state, force in zip(states, found["force"], strict=True)
    ])
    gained = states[1:, 5:] - states[0, 5:]
    summed = np.cumsum(0.5 * step * (acting[1:] + acting[:-1]), axis=0)
    assert (np.abs(gained - summed).max(axis=0) <= 2e-3 * np.ptp(gained, axis=0) + 1e-12).all()
    found["acceleration"] = acting[:, :3]
    for i, drive in enumerate(("bridge", "trolley", "hoist")):
        for name, values in found.items():
            most = crane[drive].get(f"{name}_max", np.inf)
            least = crane[drive].get(f"{name}_min", -most)
            assert values[:, i].max() <= most * 1.001, (drive, name)
            assert values[:, i].min() >= least * 1.001, (drive, name)
    # beyond what the weaker direction has
    weak = found["force"][:, 1] / 0.8 if mission is LAB else found["acceleration"][:, 1] / 0.4
    assert weak.min() < -1.2
    assert found["velocity"][:, 2].max() > -1.2 * crane["hoist"]["velocity_min"]
    # and a crane with the weaker bounds in both directions takes longer
    names = ("force", "velocity", "acceleration")
    weaker = {}
    for drive, own in crane.items():
        if isinstance(own, dict):
            least = {n: min(own[f"{n}_max"], -own[f"{n}_min"]) for n in names if f"{n}_min" in own}
            both = {f"{n}_max": m for n, m in least.items()}
            weaker[drive] = own | both | {f"{n}_min": -m for n, m in least.items()}
    slow = segfmu.load_mission({**mission, "crane": crane | weaker}).plan()
    assert run.trajectory.duration < 0.95 * slow.duration


def test_a_mission_bounds_its_drives_by_direction() -> None:
    task = segfmu.load_mission(LAB, {"actuators": {"velocity_min": [-0.5, -0.6, -0.3]}})
    bounds = task.build_bounds()
    assert bounds is not None
    assert bounds.lower("velocity").tolist() == [0.5, 0.6, 0.15]
    assert bounds.velocity.tolist() == [1.0, 1.0, 0.4]
    assert bounds.lower("force").tolist() == [np.inf, 2.0, np.inf]


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"crane": {"hoist": {"velocity_min": 0.5}}}, r"crane\.hoist\.velocity_min: .*0\.5"),
        ({"crane": {"trolley": {"force_min": 0.0}}}, r"crane\.trolley\.force_min: .*0\.0"),
        ({"actuators": {"acceleration_min": [-1.0, 0.0, -1.0]}},
         r"actuators\.acceleration_min, trolley: must be at most -1e-05 m/s2, got 0\.0"),
        ({"actuators": {"force_min": [-1.0, -1.0]}}, r"actuators\.force_min: "),
    ],
)
def test_a_bound_of_the_wrong_sign_is_one_error(changes: dict, words: str) -> None:
    with pytest.raises(InputError, match=words) as told:
        segfmu.load_mission(LAB, changes)
    assert "\n" not in str(told.value)


def test_the_command_line_shows_both_directions_and_refuses_a_wrong_sign(
    tmp_path: Path, monkeypatch, capsys
) -> None:
    text = """
waypoints = [{ position = [0, 0, -0.5] }, { position = [0, 0.5, -0.8] }]
[crane]
bridge_mass = 2.2
trolley_mass = 1.155
payload_mass = 1.0
bridge = { velocity_max = 1.0, acceleration_max = 1.0 }
trolley = { velocity_max = 0.5, acceleration_max = 0.5 }
hoist = { velocity_max = 0.3, velocity_min = -0.2, acceleration_max = 0.6 }
"""
    path = tmp_path / "mission.toml"
    path.write_text(text, encoding="utf-8")
    code, shown, _ = invoke(monkeypatch, capsys, "plan", str(path))
    assert code == 0 and "hoist velocity_min" in shown
    path.write_text(text.replace("-0.2", "0.2"), encoding="utf-8")
    code, _, error = invoke(monkeypatch, capsys, "plan", str(path))
    assert code == 2
    assert "crane.hoist.velocity_min: must be at most -1e-05 m/s, got 0.2" in error
