"""Pages on which a crane is driven: where the load may go and how fast, and what is refused."""

from __future__ import annotations

import re
import sys
from pathlib import Path

import numpy as np
import pytest

import segfmu
from segfmu import cli
from segfmu.crane import bound_uses
from segfmu.errors import BuildError, InputError
from segfmu.fmu.gantry_crane.interface import MODES
from segfmu.fmu.native import binaries, compilers
from segfmu.planning import Waypoint
from segfmu.validation.live.space import limits, space, speeds
from segfmu.validation.live.system import interfaces
from segfmu.validation.planned import planned
from tests.validation.live.compiler import needs_wasm

MODELS = Path(__file__).parents[3] / "models"
LIMITS = segfmu.Limits(velocity=1.0, acceleration=1.0, jerk=2.0, snap=20.0)


def mission(**changes: object) -> segfmu.Mission:
    crane = {"bridge_mass": 2.2, "trolley_mass": 1.155, "payload_mass": 1.0}
    waypoints = [Waypoint([0.0, 0.0, -0.5]), Waypoint([0.4, 0.1, -0.4])]
    return segfmu.load_mission(
        {"crane": crane, "limits": LIMITS, "waypoints": waypoints}, changes
    )


def test_the_room_is_that_of_stops_rope_and_workspace() -> None:
    bare = mission()
    found = space(bare, planned(bare))
    # half of the rope beyond the path, and below the trolley
    np.testing.assert_allclose(found, [[-0.25, 0.65], [-0.25, 0.35], [-0.75, -0.2]], atol=1e-9)
    told = mission(
        crane={"rope_max": 0.8, "rope_min": 0.1, "travel": {"bridge": [-0.1, 0.5]}},
        workspace={"y": [-0.2, 0.2]},
    )
    found = space(told, planned(told))
    assert -0.1 < found[0, 0] < -0.08 and 0.48 < found[0, 1] < 0.5
    assert found[1].tolist() == [-0.2, 0.2]
    assert -0.8 < found[2, 0] < -0.77 and -0.11 < found[2, 1] < -0.1


@pytest.mark.parametrize("name", ["container", "factory"])
def test_limits_that_a_mission_leaves_to_the_drives_serve_every_axis(name: str) -> None:
    own = segfmu.load_mission(MODELS / f"{name}.toml")
    plan = planned(own)
    room = space(own, plan)
    found = limits(own, plan, room)
    bounds = own.build_bounds()
    assert bounds is not None
    assert (np.asarray(found.velocity) < bounds.velocity).all()
    assert (np.asarray(found.acceleration) < bounds.acceleration).all()
    # each axis alone, which rests in the mission, within the bounds of the drives
    for axis in range(3):
        ends = [room[:, 0] + 0.25 * np.ptp(room, axis=1) for _ in range(2)]
        ends[1][axis] += 0.5 * np.ptp(room[axis])
        alone = segfmu.plan([Waypoint(end) for end in ends], found, shape=own.shape)
        uses = bound_uses(own.build_crane(), alone, bounds)
        assert max(use.use for use in uses if np.isfinite(use.bound)) < 1.01


def test_a_joystick_commands_what_load_and_drive_can() -> None:
    free = mission(crane={"bridge": {"velocity_max": 0.5, "acceleration_max": 0.7}})
    velocity, acceleration = speeds(free, planned(free), LIMITS)
    np.testing.assert_allclose(velocity, [0.475, 1.0, 1.0])
    np.testing.assert_allclose(acceleration, [0.7, 1.0, 1.0])


def test_the_crane_is_the_missions_but_begins_at_rest_without_stops() -> None:
    own = mission(
        crane={"drive": "force", "sensors": {"sample_time": 0.01}, "travel": {"bridge": [-1, 1]}},
        simulation={"initial_sway": [5.0, 0.0]},
    )
    plan = planned(own)
    feedforward, crane = interfaces(own, plan, space(own, plan), LIMITS)
    known = {v.name: v.start for v in (*feedforward.variables, *crane.variables)}
    assert known["sway.x.angle"] == 0.0 and known["travel.bridge.max"] > 1e6
    assert known["sensor.sample_time"] == 0.01 and known["command.enabled"] is True
    assert MODES.items[int(known["drive.mode"]) - 1] == "velocity"


@pytest.mark.parametrize(
    ("crane", "words"),
    [
        ({"trolley": {"dead_time": 0.1}}, "trolley.dead_time is 0.1 s"),
        ({"friction": {"bridge": {"coulomb": 1.0}}}, "friction.bridge: no command"),
    ],
)
def test_a_crane_that_follows_no_command_is_refused(
    tmp_path: Path, crane: dict[str, object], words: str
) -> None:
    with pytest.raises(InputError, match=words) as refused:
        segfmu.live(mission(crane=crane), tmp_path / "live.html")
    assert "\n" not in str(refused.value) and "leave it out" in str(refused.value)
    assert not list(tmp_path.iterdir())


def test_without_compiler_the_way_out_is_told(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(compilers, "_has_zig", lambda: False)
    monkeypatch.setattr(binaries, "_packaged", lambda _: {})
    with pytest.raises(BuildError, match=r"install the extra segfmu\[platforms\]"):
        segfmu.live(mission(), tmp_path / "live.html")
    assert not list(tmp_path.iterdir())


@needs_wasm
def test_the_command_writes_one_file(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    target = tmp_path / "of" / "live.html"
    words = ["live", str(MODELS / "paper.toml"), "-o", str(target)]
    monkeypatch.setattr(sys, "argv", ["segfmu", *words])
    with pytest.raises(SystemExit) as stopped:
        cli.main()
    assert not stopped.value.code
    assert "open it in a browser" in capsys.readouterr().out
    assert list(target.parent.iterdir()) == [target]
    text = target.read_text(encoding="utf-8")
    assert set(re.findall(r"https?://[^\"]*", text)) == {"http://www.w3.org/2000/svg"}


def test_a_target_that_is_a_folder_is_refused(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="cannot be written"):
        segfmu.live(mission(), tmp_path)
