"""Use of the drives' bounds in plans and runs; obstacles, workspace and limits in missions."""

from __future__ import annotations

from io import StringIO
from pathlib import Path

import numpy as np
import pytest
from benchmarks.drive_oracle import demands
from rich.console import Console

from segfmu.crane import ActuatorBounds, bound_uses
from segfmu.errors import InfeasibleError, InputError
from segfmu.kernels.crane.records import Demand
from segfmu.validation.criteria import judge
from segfmu.validation.drive_use import PLACES, bound_table, run_uses
from segfmu.validation.files.crane_file import CraneFile
from segfmu.validation.files.crane_parameters import bounds as crane_bounds
from segfmu.validation.files.mission_file import load_mission
from segfmu.validation.files.reading import checked
from segfmu.validation.monitor import Signals, drive_use
from segfmu.validation.plots.drives import plot_drives

CRANE = """
bridge_mass = 2.2
trolley_mass = 1.155
payload_mass = 1.0
[bridge]
velocity_max = 0.5
acceleration_max = 0.8
[trolley]
velocity_max = 0.5
acceleration_max = 0.8
[hoist]
velocity_max = 0.3
acceleration_max = 0.5
"""
MISSION = """
crane = "crane.toml"
[[waypoints]]
position = [0.0, 0.0, -1.0]
[[waypoints]]
position = [1.0, 0.5, -0.8]
"""


def mission(folder: Path, more: str = "", crane: str = CRANE):
    (folder / "crane.toml").write_text(crane, encoding="utf-8")
    (folder / "mission.toml").write_text(MISSION + more, encoding="utf-8")
    return load_mission(folder / "mission.toml")


def test_a_mission_without_limits_is_as_fast_as_the_drives(tmp_path: Path) -> None:
    task = mission(tmp_path)
    trajectory, bounds = task.plan(), task.build_bounds()
    found = bound_uses(task.build_crane(), trajectory, bounds)
    # samples alone miss a peak with a kink
    times = np.union1d(np.linspace(0.0, trajectory.duration, 20_001), trajectory.events)
    largest = np.abs(demands(task.build_crane(), trajectory, times)).max(axis=0)
    driven = [use for use in found if use.unit != "m"]
    peaks = np.delete(largest, slice(Demand.PLACE, Demand.SWAY))
    for use, peak in zip(driven, peaks, strict=True):
        assert use.peak == pytest.approx(peak, rel=1e-3, abs=1e-9)
    assert 0.999 < max(use.use for use in found) <= 1.0 + 1e-9
    printed = StringIO()
    Console(width=100, file=printed).print(bound_table(found))
    assert "bridge velocity" in printed.getvalue()
    assert "hoist force" not in printed.getvalue()


def test_a_mission_without_limits_and_bounds_is_refused(tmp_path: Path) -> None:
    ideal = CRANE.split("[bridge]")[0]
    with pytest.raises(InputError, match=r"limits: neither limits .* nor bounds .* are known"):
        mission(tmp_path, crane=ideal).plan()


def test_obstacles_and_workspace_of_a_mission_are_kept(tmp_path: Path) -> None:
    box = """
[[obstacles]]
name = "post"
minimum = [0.4, 0.0, -2.0]
maximum = [0.6, 0.6, 0.0]
"""
    with pytest.raises(InfeasibleError, match="obstacle post: the load meets it from"):
        mission(tmp_path, box).plan()
    with pytest.raises(InfeasibleError, match="workspace: axis y leaves its range"):
        mission(tmp_path, "[workspace]\ny = [-1.0, 0.4]\n").plan()
    with pytest.raises(InputError, match=r"mission.toml: .*post: minimum x 0.7 m is not below"):
        mission(tmp_path, box.replace("[0.4,", "[0.7,"))


def test_the_use_of_a_run_is_part_of_its_verdict() -> None:
    names = (
        *(f"drive.{d}.force" for d in ("bridge", "trolley", "hoist")), "bridge.velocity",
        "trolley.velocity", "rope.velocity", "sway.x.angle", "sway.y.angle", "error.load.norm",
        "time", *PLACES,
    )
    rows = np.zeros(101, dtype=[(name, float) for name in names])
    rows["time"] = np.linspace(0.0, 1.0, 101)
    rows["trolley.velocity"] = 0.4 * rows["time"]
    rows["drive.trolley.force"] = -5.0
    bounds = ActuatorBounds(power=[None, 2.1, None], acceleration=[None, 0.5, None])
    by_name = {use.name: use for use in run_uses(rows, bounds)}
    assert by_name["trolley power"].peak == pytest.approx(2.0)
    assert by_name["trolley power"].time == pytest.approx(1.0)
    assert by_name["trolley acceleration"].peak == pytest.approx(0.4)
    assert judge(rows, 1.0, 1e-3, 0.1, bounds).passed
    tight = ActuatorBounds(acceleration=[None, 0.39, None])
    failed = [row for row in judge(rows, 1.0, 1e-3, 0.1, tight).rows if not row.passed]
    assert [row.name for row in failed] == ["use of the bound of trolley acceleration"]


def test_a_run_is_compared_with_the_bound_of_each_direction() -> None:
    names = (
        *(f"drive.{d}.force" for d in ("bridge", "trolley", "hoist")), "bridge.velocity",
        "trolley.velocity", "rope.velocity", "sway.x.angle", "sway.y.angle", "time", *PLACES,
        *(f"drive.{d}.power" for d in ("bridge", "trolley", "hoist")),
    )
    rows = np.zeros(101, dtype=[(name, float) for name in names])
    time = rows["time"] = np.linspace(0.0, 1.0, 101)
    rows["trolley.velocity"] = np.where(time < 0.6, time, 0.6 - 2.0 * (time - 0.6))
    rows["drive.trolley.force"] = np.where(time < 0.6, 2.0, -4.0)
    own = {"velocity_max": 1.2, "velocity_min": -0.25, "force_max": 2.5, "force_min": -5.0,
           "acceleration_max": 4.0, "acceleration_min": -2.5}
    crane = checked(CraneFile, {
        "bridge_mass": 2.2, "trolley_mass": 1.155, "payload_mass": 1.0, "trolley": own,
    }, "crane")
    found = {use.name: use for use in run_uses(rows, crane_bounds(crane))}
    expected = {
        "trolley velocity": 0.5, "trolley velocity_min": 0.8, "trolley force": 0.8,
        "trolley force_min": 0.8, "trolley acceleration": 0.25, "trolley acceleration_min": 0.8,
    }
    for name, use in expected.items():
        assert found[name].use == pytest.approx(use, rel=1e-2), name
    assert found["trolley velocity_min"].time == pytest.approx(1.0)
    use = drive_use(Signals(rows), crane)
    # 2 of 2.5 N ahead, then 2 of 2.5 m/s2 and 4 of 5 N back
    assert use == pytest.approx(0.8, rel=1e-2)


def test_a_run_uses_what_its_rows_have_at_most() -> None:
    """Of every demand the greatest magnitude, of either sign, and when."""
    time = np.linspace(0.0, 2.0, 2001)
    found = {}
    for sign in (1.0, -1.0):
        rows = np.zeros(time.size, dtype=[(n, float) for n in (
            "time", *(f"drive.{d}.force" for d in ("bridge", "trolley", "hoist")),
            "bridge.velocity", "trolley.velocity", "rope.velocity", "sway.x.angle", "sway.y.angle",
            *PLACES,
        )])
        rows["time"] = time
        # accelerations from -0.2 to 0.8 m/s2, the greatest at the end
        rows["bridge.velocity"] = sign * (0.25 * time**2 - 0.2 * time)
        rows["drive.bridge.force"] = sign * np.where(time < 1.5, -7.0, 3.0)
        rows["sway.y.angle"] = sign * 0.3 * np.sin(np.pi * time)
        bounds = ActuatorBounds(
            force=[10.0, None, None], acceleration=[1.0, None, None], velocity=[1.0, None, None],
            sway_angle=0.5,
        )
        found[sign] = {u.name: u for u in run_uses(rows, bounds) if np.isfinite(u.bound)}
    for uses in found.values():
        assert uses["bridge acceleration"].use == pytest.approx(0.8, abs=1e-3)
        assert uses["bridge acceleration"].time == pytest.approx(2.0, abs=1e-3)
        assert uses["bridge force"].use == pytest.approx(0.7)
        assert uses["bridge velocity"].use == pytest.approx(0.6)
        assert max(u.use for n, u in uses.items() if "sway" in n) == pytest.approx(0.6, abs=1e-5)


def test_the_plot_shows_the_hoists_pull_without_the_weight(tmp_path: Path) -> None:
    task = mission(tmp_path)
    bounds = ActuatorBounds(force=[None, None, 12.0])
    figure = plot_drives(task.build_crane(), task.plan(), bounds, "drives")
    force = figure.axes[2]
    dashed = [line.get_ydata()[0] for line in force.lines if line.get_linestyle() == "--"]
    assert sorted(dashed) == pytest.approx([-9.81, 12.0 - 9.81])
