"""The crane file: every parameter of both cranes has a key or a reason, and every key arrives."""

from __future__ import annotations

import math
import tomllib
from pathlib import Path

import numpy as np
import pytest

from segfmu.errors import InputError
from segfmu.fmu.gantry_crane import interface as gantry_crane
from segfmu.fmu.gantry_feedforward import interface as gantry_feedforward
from segfmu.fmu.hook_crane import interface as hook_crane
from segfmu.fmu.standard.spec import Spec, started
from segfmu.validation.files import crane_parameters
from segfmu.validation.files.crane_file import CraneFile
from segfmu.validation.files.keys import entries
from segfmu.validation.files.mission import Mission
from segfmu.validation.files.mission_file import load_mission
from segfmu.validation.files.reading import checked
from segfmu.validation.scenario import crane_values, ending, feedforward_values, specs

MODELS = Path(__file__).parents[3] / "models"
# has all of GantryCrane, and hook and sling
SPEC = hook_crane.spec()
PARAMETERS = SPEC.where("parameter")
# start values, where the cranes differ of GantryCrane
NEUTRAL = {v.name: v.start for v in (*PARAMETERS, *gantry_crane.spec().where("parameter"))}
FED = {name for entry in entries(CraneFile) for name in entry.feeds}
MASSES = 'bridge_mass = 300e3\ntrolley_mass = 15e3\npayload_mass = 40e3\n'

# every key with a value that is not the FMU's start value
EVERYTHING = MASSES + """
name = "everything"
gravity = 9.82
rope_min = 14.0
rope_max = 32.0
drive = "velocity"
sway_max = [8.0, 5.0]
[bridge]
lag = 0.3
dead_time = 0.03
velocity_max = 0.75
velocity_min = -0.7
acceleration_max = 0.2
acceleration_min = -0.3
force_max = 300e3
force_min = -200e3
power_max = 100e3
brake_deceleration = 0.4
[trolley]
lag = 0.2
dead_time = 0.02
velocity_max = 4.0
velocity_min = -3.5
acceleration_max = 0.8
acceleration_min = -0.9
force_max = 100e3
force_min = -90e3
power_max = 200e3
brake_deceleration = 1.1
[hoist]
lag = 0.1
dead_time = 0.01
velocity_max = 1.5
velocity_min = -1.2
acceleration_max = 0.5
acceleration_min = -0.4
force_max = 600e3
force_min = -550e3
power_max = 400e3
brake_deceleration = 0.9
[travel]
bridge = [-10.0, 300.0]
trolley = [-5.0, 55.0]
rope = [13.0, 33.0]
stiffness = [1e6, 5e5, 2e5]
damping = [1e4, 2e4, 3e4]
slack = "free_fall"
[friction]
width = 0.002
presliding = 2e-5
bridge = { viscous = 100.0, coulomb = 3000.0, static = 3500.0, drag = 10.0 }
trolley = { viscous = 200.0, coulomb = 1000.0, static = 1500.0, drag = 20.0 }
hoist = { viscous = 300.0, coulomb = 2000.0, static = 2500.0, drag = 30.0 }
sway = { viscous = 400.0 }
[sensors]
sample_time = 0.01
dead_time = 0.02
seed = 7
bridge = { resolution = 0.001, noise = 0.0002, zero = 0.01 }
trolley = { resolution = 0.002, noise = 0.0003, zero = 0.02 }
rope = { resolution = 0.003, noise = 0.0004, zero = 0.03 }
sway_x = { resolution = 0.088, noise = 0.01, zero = 0.5 }
sway_y = { resolution = 0.176, noise = 0.02, zero = -0.5 }
[load]
mass_range = [10e3, 65e3]
drag_area = 40.0
changes = [{ time = 3.0, mass = 20e3 }, { time = 5.0, mass = 30e3 }]
[controller]
offset_cause = "sensor"
rope_offset = true
enabled = false
source = "measured"
design = "flatness"
sample_time = 0.02
bandwidth = 0.9
hoist_bandwidth = 2.5
damping = 0.8
fade = 0.5
payload_time = 3.0
weight = { position = 2.0, angle = 3.0, velocity = 4.0, rate = 5.0, effort = 6.0 }
rejection = { carriage = 0.5, load = 0.6 }
[controller.observer]
position = 0.001
length = 0.002
angle = 0.1
drift = 0.01
wind = 0.003
wake = 4.0
offset = 0.02
[wind]
constant = [9e3, 8e3, 7e3]
gust = { start = 4.0, duration = 6.0, shape = "sine", force = [5e3, 4e3, 3e3], speed = [9, 8, 7] }
speed = [6.0, 5.0, 1.0]
air_density = 1.3
turbulence = { deviation = [1.0, 1.1, 1.2], length = 900.0, bandwidth = 0.7, seed = 5 }
noise = { deviation = [1e3, 2e3, 3e3], bandwidth = 0.5, seed = 9 }
"""
HOOK = "[hook]\nmass = 900.0\nsling = 3.0\n"


def crane(text: str = "") -> CraneFile:
    return checked(CraneFile, tomllib.loads(MASSES + text), "crane.toml")


def starts(text: str, spec: Spec = SPEC) -> dict[str, float]:
    """Start values of a crane's FMU for a crane file."""
    own = checked(CraneFile, tomllib.loads(text), "crane.toml")
    changed = started(spec, crane_parameters.parameters(own))
    return {v.name: v.start for v in changed.variables}


def has_key(name: str) -> bool:
    """Whether a crane file sets a parameter; those of rows are named by the first one."""
    head, bracket, rest = name.partition("[")
    return (f"{head}[{{}}]{rest.partition(']')[2]}" if bracket else name) in FED


def test_every_parameter_has_a_key_or_a_reason() -> None:
    assert len(PARAMETERS) > 80
    reasons = crane_parameters.WITHOUT_KEY
    missing = [
        v.name for v in PARAMETERS if not has_key(v.name) and not v.name.startswith(tuple(reasons))
    ]
    assert not missing, "give these a key in validation/crane_file.py, or a reason"
    assert all(len(reason) > 20 for reason in reasons.values())


def test_reasons_are_for_parameters_that_exist_and_have_no_key() -> None:
    names = [v.name for v in hook_crane.native_spec().where("parameter")]
    for start in crane_parameters.WITHOUT_KEY:
        assert any(n.startswith(start) for n in names), start
        assert not any(n.startswith(start) for n in FED), start


def test_units_of_keys_are_those_of_the_parameters() -> None:
    spelled = {"rad": "deg"}
    for entry in entries(CraneFile):
        for name in entry.feeds:
            unit = SPEC.variable(name.replace("{}", "1")).unit or ""
            assert entry.key.unit == spelled.get(unit, unit).replace(".", " "), entry.path


def test_every_key_arrives() -> None:
    """A file with all keys changes all parameters that have one, to its values in SI units."""
    given = starts(EVERYTHING + HOOK)
    same = [
        v.name for v in PARAMETERS if has_key(v.name) and given[v.name] == NEUTRAL[v.name]
        # of eight changes two are used
        and not v.name.startswith(tuple(f"payload[{i}]" for i in range(3, 9)))
    ]
    assert not same
    assert given["drive.trolley.lag"] == 0.2
    assert given["travel.rope.max"] == 33.0
    assert given["sensor.sway.y.angle.offset"] == pytest.approx(-math.pi / 360.0)
    assert (given["hook.mass"], given["hook.sling"]) == (900.0, 3.0)
    assert given["payload.count"] == 2 and given["payload[2].mass"] == 30e3
    assert SPEC.variable("drive.mode").enumeration.items[given["drive.mode"] - 1] == "velocity"


def test_every_key_of_the_model_is_in_that_file() -> None:
    data = tomllib.loads(EVERYTHING + HOOK)
    for entry in entries(CraneFile):
        value = data
        for name in entry.path:
            value = value[0] if isinstance(value, list) else value
            assert name in value, ".".join(entry.path)
            value = value[name]


def test_a_bare_crane_is_ideal_and_has_no_rope_bounds() -> None:
    spec = gantry_crane.spec()
    given = starts(MASSES, spec)
    neutral = {v.name: v.start for v in spec.where("parameter")}
    changed = {n for n in neutral if given[n] != neutral[n]}
    assert changed == {
        "crane.bridge_mass", "crane.trolley_mass", "crane.payload_mass", "crane.rope_min",
        "crane.rope_max",
    }
    assert given["crane.rope_min"] == given["crane.rope_max"] == 0.0


def test_bounds_are_those_of_file_and_mission_whichever_is_less() -> None:
    own = crane_parameters.bounds(crane("trolley = { velocity_max = 4.0, force_max = 1e5 }\n"))
    assert own.velocity.tolist() == [np.inf, 4.0, np.inf]
    both = crane_parameters.tighter(
        own, {"force": None, "velocity": [5.0, 5.0, 1.0], "acceleration": None,
              "sway_angle": [5.0, 10.0]},
    )
    assert both.velocity.tolist() == [5.0, 4.0, 1.0]
    assert both.force.tolist() == [np.inf, 1e5, np.inf]
    assert np.rad2deg(both.sway_angle) == pytest.approx([5.0, 10.0])


def mission(tmp_path: Path, crane_text: str, more: str = "") -> Mission:
    (tmp_path / "crane.toml").write_text(crane_text, encoding="utf-8")
    limits = "".join(
        f"[limits.{a}]\nvelocity = 2.0\nacceleration = 1.0\njerk = 1.0\n" for a in "xyz"
    )
    points = "[[waypoints]]\nposition = [0, 0, -20]\n[[waypoints]]\nposition = [0, 30, -20]\n"
    path = tmp_path / "mission.toml"
    path.write_text('crane = "crane.toml"\n' + limits + points + more, encoding="utf-8")
    return load_mission(path)


def test_bounds_of_the_crane_file_hold_in_the_plan(tmp_path: Path) -> None:
    free = mission(tmp_path, MASSES)
    assert free.build_bounds() is None
    bound = mission(tmp_path, MASSES + "[trolley]\nacceleration_max = 0.3\n")
    assert bound.plan().duration > 1.1 * free.plan().duration


def test_the_true_crane_differs_where_it_says_so(tmp_path: Path) -> None:
    text = MASSES + "[trolley]\nlag = 0.2\nforce_max = 1e5\n"
    own = mission(tmp_path, text, "[true_crane]\npayload_mass = 45e3\ntrolley = { lag = 0.3 }\n")
    assert own.build_crane().payload_mass == 40e3
    values = crane_values(own)
    assert values["crane.payload_mass"] == 45e3
    assert values["feedback.payload_mass"] == 40e3
    assert values["drive.trolley.lag"] == 0.3
    assert values["drive.trolley.force_max"] == 1e5
    feedforward, plant = specs(own, own.plan())
    assert feedforward.variable("crane.payload_mass").start == 40e3
    assert plant.variable("crane.payload_mass").start == 45e3


# parameters of GantryFeedforward that no mission sets, and why
NOT_OF_MISSIONS = {
    "planner.start_time": "a mission begins at once",
    "setpoint.lead": "a matter of the importer that couples the FMUs",
    "planner.slows_down": "a mission's own plan keeps the bounds",
    "planner.finds_limits": "a mission has the limits that its plan has; see limits_to_find",
    **{
        name: "a matter of who operates the crane"
        for name in gantry_feedforward.spec().references
        if name.startswith(("command.", "measured."))
        or name == "limits.scale"
    },
    **{
        name: "the mission has no obstacles"
        for name in gantry_feedforward.spec().references
        if name.startswith("obstacle[")
    },
}


def test_a_mission_sets_every_parameter_of_the_feedforward(tmp_path: Path) -> None:
    own = mission(tmp_path, EVERYTHING.replace("sway_max", "# sway_max"))
    trajectory = own.plan()
    values = feedforward_values(own, trajectory)
    spec = gantry_feedforward.spec(len(trajectory.waypoints))
    assert {v.name for v in spec.where("parameter")} == {*values, *NOT_OF_MISSIONS}
    assert (values["drive.trolley.lag"], values["drive.hoist.dead_time"]) == (0.2, 0.01)
    assert values["drive.trolley.brake_deceleration"] == 1.1


def test_the_motion_ends_a_dead_time_later(tmp_path: Path) -> None:
    late = "hoist = { dead_time = 0.03 }\ntrolley = { dead_time = 0.25 }\n"
    own = mission(tmp_path, MASSES + late, "[true_crane]\ntrolley = { dead_time = 0.3 }\n")
    trajectory = own.plan()
    assert ending(own, trajectory) == trajectory.duration + 0.25
    feedforward, _ = specs(own, trajectory)
    assert feedforward.stop_time == pytest.approx(trajectory.duration + 3.25)


def test_a_mass_outside_its_range_is_refused(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"crane\.toml: payload_mass: 40000.0 kg is outside"):
        mission(tmp_path, MASSES + "[load]\nmass_range = [1e3, 20e3]\n")


def test_values_that_do_not_fit_are_refused_by_file(tmp_path: Path) -> None:
    for text in ("[sensors]\ndead_time = 0.1\n", "[travel]\nbridge = [2.0, 1.0]\n"):
        with pytest.raises(InputError, match=r"mission\.toml: crane: .*crane\.toml: "):
            mission(tmp_path, MASSES + text)


@pytest.mark.parametrize(("text", "words"), [
    ("sensors = { rope = { noise = 0.1 } }", "set sensors.sample_time above 0 s"),
    ("sensors = { sample_time = 1e-9 }", "true_crane: sensors.sample_time must be 0 or at least"),
    ("sensors = { sample_time = 0.1, dead_time = 1e6 }", "true_crane: sensors.dead_time 1000000 s"),
    ("friction = { hoist = { static = 1.0, coulomb = 2.0 } }", "friction.hoist.coulomb 2 N"),
])
def test_messages_name_keys_of_the_file(text: str, words: str, tmp_path: Path) -> None:
    with pytest.raises(InputError) as info:
        mission(tmp_path, MASSES, f"[true_crane]\n{text}\n")
    assert words in str(info.value)
    assert not any(name in str(info.value) for name in (" sensor.", "drive.", "feedback."))


@pytest.mark.parametrize("path", sorted(MODELS.glob("crane*.toml")), ids=lambda p: p.stem)
def test_values_of_shipped_cranes_have_a_comment(path: Path) -> None:
    for line in path.read_text(encoding="utf-8").splitlines():
        assert "=" not in line or "#" in line, f"{path.name}: {line}: say where this is from"
