"""`[hook]` in crane files and missions: what it means, and what is refused with the way out."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import segfmu
from segfmu.errors import InputError
from segfmu.fmu.pairs import GANTRY, HOOK
from segfmu.validation.files import crane_parameters
from segfmu.validation.files.mission import Mission
from segfmu.validation.files.mission_file import load_mission
from segfmu.validation.scenario import crane_values, specs

CRANE = {
    "bridge_mass": 8e4, "trolley_mass": 1.2e4, "payload_mass": 1e4, "rope_min": 2.0,
    "drive": "velocity", "hook": {"mass": 500.0, "sling": 4.0},
}
DRIVES = {
    name: {"velocity_max": 1.0, "acceleration_max": 0.3} for name in ("bridge", "trolley", "hoist")
}
LIMITS = {
    axis: {"velocity": 1.0, "acceleration": 0.2, "jerk": 0.1, "snap": 0.1} for axis in "xyz"
}
POINTS = [{"position": [1.0, 0.0, -10.0]}, {"position": [1.0, 5.0, -10.0]}]


def mission(crane: dict[str, Any] | None = None, **keys: Any) -> Mission:
    """A mission with other keys of crane and mission."""
    return load_mission({
        "crane": {**CRANE, **(crane or {})}, "limits": LIMITS, "waypoints": POINTS, **keys,
    })


def test_a_hook_makes_another_crane_and_other_models() -> None:
    own = mission()
    assert own.build_crane() == segfmu.HookCrane(
        segfmu.Crane(8e4, 1.2e4, 1e4, rope_min=2.0), 500.0, 4.0
    )
    assert (own.smoothness, own.shape) == (6, "smoothstep")
    assert crane_parameters.models(own.crane) is HOOK
    plain = {name: value for name, value in CRANE.items() if name != "hook"}
    without = load_mission({"crane": plain, "limits": LIMITS, "waypoints": POINTS})
    assert crane_parameters.models(without.crane) is GANTRY
    assert (without.smoothness, without.shape) == (4, "plateau")


def test_a_crane_with_a_hook_may_be_an_object() -> None:
    own = mission()
    made = load_mission({"crane": own.build_crane(), "limits": LIMITS, "waypoints": POINTS})
    assert made.build_crane() == own.build_crane()
    assert made.plan().duration == own.plan().duration


def test_the_rope_ends_at_the_hook() -> None:
    values = crane_values(mission(simulation={"initial_sway": [1.0, 2.0]}))
    assert values["rope.length"] == 6.0
    assert values["sling.y.angle"] == values["sway.y.angle"] > 0.03
    assert values["feedback.source"] == "measured"


def test_another_sling_starts_with_the_planned_rope() -> None:
    own = mission(true_crane={"hook": {"sling": 4.5}})
    values = crane_values(own)
    assert values["feedback.sling"] == 4.0
    assert (values["rope.length"], values["hook.sling"], values["hook.mass"]) == (6.0, 4.5, 500.0)
    _, crane = specs(own, own.plan())
    starts = {v.name: v.start for v in crane.variables}
    assert starts["reference.bridge.position"] == 1.0
    assert starts["reference.rope.length"] == 6.0
    assert starts["reference.load.position.z"] == -10.5
    assert starts["force.hoist"] == pytest.approx(-10500.0 * 9.81)


REFUSED: dict[str, tuple[dict[str, Any], dict[str, Any], str]] = {
    "negative sling": ({"hook": {"mass": 1.0, "sling": -1.0}}, {},
                       r"hook\.sling: must be at least"),
    "no mass": ({"hook": {"sling": 1.0}}, {}, r"hook\.mass: this key is missing"),
    "light hook": ({"hook": {"mass": 0.9, "sling": 1.0}}, {}, r"hook\.mass: .* give it 1 kg"),
    "of the mission": ({}, {"hook": {"mass": 1.0, "sling": 1.0}}, r"elsewhere: crane\.hook"),
    "state": ({"controller": {"source": "state"}}, {}, r"controller\.source: .* leave it out"),
    "state here": ({}, {"simulation": {"feedback_source": "state"}}, r"simulation\.feedback_sou"),
    "design": ({"controller": {"design": "flatness"}}, {}, r"controller\.design: .* leave it out"),
    "observer": ({"controller": {"observer": {"wake": 0.0}}}, {}, r"controller\.observer: "),
    "free fall": ({"travel": {"slack": "free_fall"}}, {}, r'travel\.slack: .* use "error"'),
    "smoothness 4": ({}, {"smoothness": 4}, "smoothness: 4 .* write smoothness = 6"),
    "force drives": ({"drive": "force"}, {"smoothness": 5}, "smoothness: 5 .* force drives"),
    "bounds": (DRIVES, {"smoothness": 5}, "smoothness: 5 .* bounds of drives"),
    "rope at obstacles": (
        {}, {"obstacles": [{"name": "a", "minimum": [3, 3, -20], "maximum": [4, 4, -19]}]},
        r"obstacles\.1\.rope: .* rope = false",
    ),
    "hook at the trolley": (
        {}, {"waypoints": [POINTS[0], {"position": [1.0, 5.0, -4.0]}]}, r"waypoints\.2\.position: "
    ),
    "beyond an end stop": ({"travel": {"rope": [0.0, 5.9]}}, {}, "takes the rope to 6.0 m"),
}


@pytest.mark.parametrize("name", REFUSED)
def test_refusals_name_the_key_and_the_way_out(name: str) -> None:
    crane, keys, words = REFUSED[name]
    with pytest.raises(InputError, match=words) as caught:
        mission(crane, **keys)
    assert "\n" not in str(caught.value)


def test_a_hook_of_the_true_crane_alone_is_refused() -> None:
    plain = {name: value for name, value in CRANE.items() if name != "hook"}
    with pytest.raises(InputError, match=r"true_crane\.hook: .* add \[crane\.hook\]"):
        load_mission({
            "crane": plain, "true_crane": {"hook": CRANE["hook"]}, "limits": LIMITS,
            "waypoints": POINTS,
        })


def test_what_a_hook_lacks_is_refused_with_the_way_out(tmp_path) -> None:
    own = mission()
    with pytest.raises(InputError, match=r"no operator; take \[hook\] out"):
        own.operator()
    with pytest.raises(InputError, match=r"no page; take \[hook\] out"):
        segfmu.live(own, tmp_path / "live.html")
    with pytest.raises(InputError, match="no commands"):
        segfmu.build(own, tmp_path, commands="inputs")
    assert not list(tmp_path.iterdir())


def test_a_crane_with_a_hook_is_not_identified() -> None:
    with pytest.raises(InputError, match=r"^crane: hook: .* take \[hook\] out"):
        segfmu.identify({"time": np.arange(30.0)}, CRANE)


def test_smoothness_5_serves_velocity_drives_without_bounds() -> None:
    assert mission(smoothness=5).plan().duration < mission().plan().duration
