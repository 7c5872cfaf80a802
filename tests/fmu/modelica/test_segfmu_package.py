"""The Modelica package in OpenModelica, against our co-simulation and a plain crane."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

import segfmu
from segfmu.cosim import simulate
from segfmu.fmu.modelica.package import write_package
from tests.fmu.modelica.openmodelica import (
    SOLVERS,
    built,
    load_distance,
    require_omc,
    simulated,
)

require_omc()

LAGS = {f"drive.{d}.lag": 0.05 for d in ("bridge", "trolley", "hoist")}
VELOCITY = {"drive.mode": "velocity", "feedback.design": "flatness", **LAGS}

PLAIN = """model Plain
  extends Segfmu.Examples.AgainstPlainCrane(gantry(
    drive_mode = Segfmu.Types.DriveMode.velocity,
    feedback_design = Segfmu.Types.FeedbackDesign.flatness,
    drive_bridge_lag = 0.05, drive_trolley_lag = 0.04, drive_hoist_lag = 0.03));
end Plain;
"""
POINTS = """model Points
  extends Segfmu.Coupled(
    feedforward(
      waypoint_position = [0, 0, -0.5; 0.2, 0.1, -0.4; 0.5, 0.5, -0.6; 0.6, 0.7, -0.5],
      waypoint_velocity = zeros(4, 3), waypoint_acceleration = zeros(4, 3)),
    gantry(feedback_enabled = false, payload_count = 1, payload_1_time = 2, payload_1_mass = 1.3));
end Points;
"""
MOVED = """model Moved
  extends Segfmu.Coupled(feedforward(
    waypoint_position = [1, 0.4, -0.9; 1.5, 0.8, -0.6],
    waypoint_velocity = zeros(2, 3), waypoint_acceleration = zeros(2, 3)));
end Moved;
"""
ALONE = """model Alone
  Segfmu.GantryCrane gantry(use_force = false, use_velocity = false, use_reference = false);
end Alone;
"""
LOOP = """model Loop "a damper between load and ground, as an algebraic function of outputs"
  extends Segfmu.Coupled(gantry(use_wind = true));
equation
  gantry.wind_x = -0.2*gantry.load_velocity_x;
  gantry.wind_y = -0.2*gantry.load_velocity_y;
  gantry.wind_z = 0;
end Loop;
"""


@pytest.fixture(scope="module")
def package(native_fmus, hook_fmus, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the package and the FMUs in it."""
    folder = tmp_path_factory.mktemp("modelica")
    write_package(folder, archives=[*native_fmus[2], *hook_fmus[2]])
    return folder


def program(package: Path, model: str, text: str = "") -> Path:
    (package / "own.mo").write_text(text)
    loads = 'loadFile("Segfmu/package.mo");\n' + ('loadFile("own.mo");\n' if text else "")
    return built(package, model, loads, 5.0)


def with_every_solver(package: Path, model: str, crane: str, fmus) -> NDArray[np.void]:
    """Run an example with every solver; its load is where our own loop has it."""
    expected = simulate(*fmus, stop_time=5.0, step=1e-3)
    mission = program(package, model)
    for solver in SOLVERS:
        results, _ = simulated(mission, f"-s={solver}")
        assert load_distance(results, crane, expected) < 1e-6, solver
    return results


def test_the_paper_mission_with_every_solver(package, native_fmus) -> None:
    results = with_every_solver(package, "Segfmu.Examples.Mission", "gantry.", native_fmus[2])
    assert results["feedforward.plan_done"][-1] == 1.0
    assert set(results["feedforward.plan_interval"]) == {1.0, 2.0}


def test_a_load_on_hook_and_sling_with_every_solver(package, hook_fmus) -> None:
    results = with_every_solver(package, "Segfmu.Examples.HookMission", "crane.", hook_fmus[2])
    assert np.abs(results["crane.sling_x_angle"]).max() > 0.02


def test_a_late_start_is_the_start_of_the_motion(package, native_fmus) -> None:
    expected = simulate(*native_fmus[2], start_time=100.0, stop_time=105.0, step=1e-3)
    mission = program(package, "Segfmu.Examples.Mission")
    results, _ = simulated(mission, "-override=startTime=100,stopTime=105,stepSize=0.001")
    assert load_distance(results, "gantry.", expected) < 1e-6
    assert results["feedforward.reference_load_position_x"][0] == 0.0
    assert results["gantry.load_position_x"][-1] == pytest.approx(1.0, abs=1e-3)


def test_velocity_drives_with_lag_and_smoothstep(package, native_fmus) -> None:
    expected = simulate(
        *native_fmus[2], stop_time=5.0, step=1e-3, source_values={"planner.shape": "smoothstep"},
        sink_values=VELOCITY,
    )
    usual = simulate(*native_fmus[2], stop_time=5.0, step=1e-3)
    assert np.abs(expected["load.position.x"] - usual["load.position.x"]).max() > 1e-3
    drives = program(package, "Segfmu.Examples.VelocityDrives")
    for solver in SOLVERS:
        results, _ = simulated(drives, f"-s={solver}")
        assert load_distance(results, "gantry.", expected) < 1e-6, solver


def test_the_plain_crane_agrees_with_gantry_crane(package) -> None:
    results, _ = simulated(
        program(package, "Segfmu.Examples.AgainstPlainCrane"), "-override=tolerance=1e-10"
    )
    assert results["difference"].max() < 1e-7
    for i, axis in enumerate("xy", 1):
        angle = results[f"plain.sway_angle[{i}]"] - results[f"gantry.sway_{axis}_angle"]
        assert np.abs(angle).max() < 1e-6
    assert np.abs(results["gantry.load_position_x"]).max() > 0.9


def test_the_plain_crane_agrees_in_mode_velocity(package) -> None:
    results, _ = simulated(program(package, "Plain", PLAIN), "-override=tolerance=1e-10")
    assert results["difference"].max() < 1e-7
    assert np.abs(results["gantry.load_position_x"]).max() > 0.9


def test_waypoints_as_a_table_and_a_change_of_the_load(package, native_fmus) -> None:
    points = [[0.0, 0.0, -0.5], [0.2, 0.1, -0.4], [0.5, 0.5, -0.6], [0.6, 0.7, -0.5]]
    source = {"waypoint.count": 4}
    for i, point in enumerate(points, 1):
        for axis, value in zip("xyz", point, strict=True):
            source[f"waypoint[{i}].position.{axis}"] = value
            source[f"waypoint[{i}].velocity.{axis}"] = 0.0
            source[f"waypoint[{i}].acceleration.{axis}"] = 0.0
    expected = simulate(
        *native_fmus[2], stop_time=5.0, step=1e-3, source_values=source, sink_values={
            "feedback.enabled": False, "payload.count": 1, "payload[1].time": 2.0,
            "payload[1].mass": 1.3,
        },
    )
    results, _ = simulated(program(package, "Points", POINTS), "-override=tolerance=1e-10")
    assert load_distance(results, "gantry.", expected) < 1e-6


def test_a_crane_without_connections_hangs_at_rest(package) -> None:
    results, _ = simulated(program(package, "Alone", ALONE))
    assert np.ptp(results["gantry.load_position_z"]) < 1e-9
    assert np.abs(results["gantry.rope_force"] + 9.81).max() < 1e-9


def test_an_input_may_follow_from_a_state(package) -> None:
    """No algebraic loop, as outputs depend on no more inputs than the specification says."""
    loop = program(package, "Loop", LOOP)
    results, _ = simulated(loop)
    assert "nonlinear system" not in (loop.parent / "Loop_info.json").read_text()
    assert np.isfinite(results["gantry.load_position_x"]).all()


def test_the_listing_of_the_documentation(package) -> None:
    text = (Path(__file__).parents[3] / "docs" / "importing" / "openmodelica.md").read_text()
    listing = re.search(r"```modelica\n(model MyMission.*?)```", text, re.S)[1]
    results, _ = simulated(program(package, "MyMission", listing), "-override=stopTime=9")
    last = [results[f"gantry.load_position_{a}"][-1] for a in "xyz"]
    assert last == pytest.approx([0.8, 0.6, -0.5], abs=5e-3)


def test_errors_name_the_instance(package) -> None:
    own = "model Bad extends Segfmu.Coupled(feedforward(limits_x_velocity = 0)); end Bad;"
    bad = program(package, "Bad", own)
    with pytest.raises(AssertionError, match=r"Bad\.feedforward: initialisation failed: limits\.x"):
        simulated(bad)
    with pytest.raises(AssertionError, match="the folder of the unpacked FMU"):
        simulated(bad, "-override=feedforward.folder=nowhere")


@pytest.mark.parametrize("meets", [False, True])
def test_obstacles_are_tables(package, meets: bool) -> None:
    """The rope alone meets the second box, which it may if its row says so."""
    text = f"""model Boxes
  extends Segfmu.Coupled(feedforward(
    obstacle_minimum = [2, 2, -1; 0.4, 0, -0.3], obstacle_maximum = [3, 3, 0; 0.6, 1, -0.2],
    obstacle_rope = {{true, {str(meets).lower()}}}));
end Boxes;
"""
    boxes = program(package, "Boxes", text)
    if meets:
        with pytest.raises(AssertionError, match=r"obstacle 2: the rope meets it"):
            simulated(boxes)
    else:
        simulated(boxes)


def test_a_moved_first_waypoint_needs_no_second_change(package) -> None:
    results, said = simulated(program(package, "Moved", MOVED))
    places = ("bridge_position", "trolley_position", "rope_length")
    found = [results[f"gantry.{n}"][0] for n in places]
    assert found == pytest.approx([1.0, 0.4, 0.9], abs=1e-12)
    assert results["gantry.error_load_norm"].max() < 1e-6, said


@pytest.mark.parametrize("moved", [(1.0, 0.8, -0.6), (0.9, 0.4, -0.8)])
def test_a_moved_waypoint_is_planned_within_the_drives(package, moved) -> None:
    """Free states and limits are found in OpenModelica as in the package."""
    crane = segfmu.Crane(2.2, 1.155, 1.0, rope_min=0.16, rope_max=1.5)
    places = [[0.0, 0.0, -0.6], [0.2, 0.1, -0.4], [0.8, 0.6, -0.35], moved]
    first, *passed, last = (segfmu.Waypoint(place) for place in places)
    passed = [segfmu.Waypoint(point.position, "free", "free") for point in passed]
    bounds = segfmu.ActuatorBounds(velocity=[0.6, 0.5, 0.3], acceleration=[0.7, 0.6, 0.5])
    own = segfmu.plan_actuated(crane, [first, *passed, last], None, bounds)
    change = ", ".join(map(str, moved))
    text = f"model Move extends Segfmu.Examples.MovedWaypoint(moved = [{change}]); end Move;"
    results, _ = simulated(program(package, "Move", text), "-override=stopTime=8")
    # behind the last event its time
    ended = results["feedforward.plan_next_event"][-1]
    assert ended == pytest.approx(own.trajectory.duration, rel=1e-9)
    for axis, place in zip("xyz", moved, strict=True):
        assert results[f"gantry.load_position_{axis}"][-1] == pytest.approx(place, abs=1e-3)
    shares = [
        np.abs(results[f"feedforward.reference_{part}_{name}"]).max() / bound
        for name in ("velocity", "acceleration")
        for part, bound in zip(("bridge", "trolley", "rope"), getattr(bounds, name), strict=True)
    ]
    # the largest one is met at an instant, and points of the result are a millisecond apart
    assert 1.0 - 1e-3 <= max(shares) <= 1.0 + 1e-9
