"""Plans of missions: end stops between waypoints, friction of the crane file."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from benchmarks.drive_oracle import demands
from scipy.optimize import minimize_scalar

from segfmu import Trajectory, Waypoint
from segfmu.crane import FlatInverse, bound_uses
from segfmu.crane.inverse import POSITION
from segfmu.errors import InfeasibleError
from segfmu.validation import planned
from segfmu.validation.files.mission import Mission
from segfmu.validation.files.mission_file import load_mission
from segfmu.validation.output import plan_samples

CRANE = """bridge_mass = 2.0
trolley_mass = 1.0
payload_mass = 1.0
[travel]
bridge = [0.0, {stop!r}]
"""
LIMITS = "".join(
    f"[limits.{a}]\nvelocity = 0.5\nacceleration = 1.0\njerk = 6.0\nsnap = 60.0\n" for a in "xyz"
)
POINTS = """[[waypoints]]
position = [0.0, 0.0, -0.5]
[[waypoints]]
position = [0.3, 0.0, -0.5]
velocity = [0.3, 0.0, 0.0]
[[waypoints]]
position = [0.3, 0.0, -0.45]
"""


def mission(folder: Path, stop: float) -> Mission:
    path = folder / "mission.toml"
    (folder / "crane.toml").write_text(CRANE.format(stop=stop), encoding="utf-8")
    path.write_text('crane = "crane.toml"\n' + LIMITS + POINTS, encoding="utf-8")
    return load_mission(path)


def farthest(free: Mission, trajectory: Trajectory) -> float:
    """Where the bridge is farthest [m], from samples of the flat inverse."""
    inverse = FlatInverse(free.build_crane(), trajectory)

    def place(time: float) -> float:
        return float(inverse.evaluate(np.array([time]))[0, POSITION][0])

    times = np.linspace(0.0, trajectory.duration, 2001)
    near = times[np.argmax(inverse.evaluate(times)[:, POSITION][:, 0])]
    step = times[1]
    found = minimize_scalar(
        lambda t: -place(t), bounds=(near - step, near + step), method="bounded",
        options={"xatol": 1e-9},
    )
    return -float(found.fun)


def test_a_stop_is_met_exactly_at_the_farthest_place(tmp_path: Path) -> None:
    free = mission(tmp_path, 9.0)
    trajectory = free.plan()
    place = farthest(free, trajectory)
    kept = planned.planned(mission(tmp_path, place + 1e-5))
    assert kept.duration == trajectory.duration
    # a little less needs other limits, which are found
    slower = planned.planned(mission(tmp_path, place - 1e-5))
    assert slower.duration > trajectory.duration
    assert farthest(free, slower) <= place - 1e-5 + 1e-9


def test_stops_of_both_sides_are_met(tmp_path: Path) -> None:
    path = tmp_path / "mission.toml"
    words = "takes the bridge to (-?)0.3.* m, beyond its end stop travel.bridge.(min|max) at"
    for sign in (1.0, -1.0):
        crane = CRANE.replace("[0.0, {stop!r}]", str(sorted([0.0, sign * 0.301])))
        (tmp_path / "crane.toml").write_text(crane, encoding="utf-8")
        points = POINTS if sign > 0.0 else POINTS.replace("[0.3", "[-0.3")
        path.write_text('crane = "crane.toml"\n' + LIMITS + points, encoding="utf-8")
        with pytest.raises(InfeasibleError, match=words) as refused:
            planned.planned(load_mission(path))
        assert sign * refused.value.value > 0.301


def test_friction_of_the_crane_file_is_part_of_plan_and_tables() -> None:
    """6 N drives with 4 N of friction: the plan keeps 6 N, and the table says how much of it."""
    friction = {d: {"coulomb": 4.0} for d in ("bridge", "trolley", "hoist")}
    drive = {"force_max": 6.0, "velocity_max": 1.0}
    data = {
        "crane": {"bridge_mass": 2.2, "trolley_mass": 1.155, "payload_mass": 1.0, "bridge": drive,
                  "trolley": drive, "friction": friction},
        "waypoints": [Waypoint([0.0, 0.0, -0.5]), Waypoint([1.0, 0.8, -0.5])],
    }
    task = load_mission(data)
    trajectory = task.plan()
    bounds = task.build_bounds()
    assert bounds is not None
    times = np.linspace(0.0, trajectory.duration, 20_001)
    known = task.build_friction()
    needs = np.abs(demands(task.build_crane(), trajectory, times, known)).max(axis=0)
    used = bound_uses(task.build_crane(), trajectory, bounds, known)
    assert max(use.use for use in used) == pytest.approx(1.0, abs=1e-5)
    # samples come that close to the peak, and no sample exceeds the bound
    assert 0.999 < (needs / bounds.vector).max() < 1.0 + 1e-6
    assert trajectory.duration > 1.3 * load_mission(
        data | {"crane": data["crane"] | {"friction": {}}}
    ).plan().duration
    rows = plan_samples(task, trajectory, 1)
    # the peak is a narrow one, where the friction changes its sign
    assert 5.9 < np.abs(rows["force.bridge"]).max() <= 6.0
    # moving and braking: the friction is on one side
    assert rows["force.bridge"].min() > -3.0
