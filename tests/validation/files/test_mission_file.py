"""Missions that have most in common with one that was found right: the rest is checked."""

from __future__ import annotations

import shutil
from pathlib import Path
from typing import Any

import pytest

from segfmu import Crane, InputError, Mission
from segfmu.validation.files.mission_file import load_mission
from segfmu.validation.files.scenario_file import load_scenario

RIGHT = Path(__file__).parents[3] / "models" / "paper.toml"
CRITERION = '[[criteria]]\nname = "c"\nkind = "always"\nsignal = "error.load.norm"\nbound = 1.0\n'
LOW = [0.5, 0.0, 0.1]


@pytest.mark.parametrize(("changes", "words"), [
    ({"workspace": {"x": [1.0, 0.0]}}, "workspace"),
    ({"waypoints": [{"position": [0.0, 0.0, -0.5]}, {"position": LOW}]}, "waypoints.2.position"),
    ({"crane": {"travel": {"bridge": [5.0, 6.0]}}}, "end stops"),
    ({"limits": {"x": {"velocity": 0.5}}, "waypoints": [
        {"position": [0.0, 0.0, -0.5]},
        {"position": [0.5, 0.0, -0.5], "velocity": [0.9, 0.0, 0.0]},
        {"position": [1.0, 0.0, -0.5]},
    ]}, "exceeds"),
    ({"true_crane": {"rope_min": 2.0, "rope_max": 1.0}}, "true_crane"),
    ({"true_crane": {"hook": {"mass": 0.2, "sling": 0.2}}}, "true_crane.hook"),
])
def test_what_differs_from_a_right_mission_is_checked(changes: dict, words: str) -> None:
    load_mission(RIGHT)
    load_mission(RIGHT, {"simulation": {"settle": 1.0}})
    with pytest.raises(InputError, match=words):
        load_mission(RIGHT, changes)
    load_mission(RIGHT)


def test_links_to_files_tell_where_the_files_that_they_name_are_looked_for(tmp_path: Path) -> None:
    """A link to a mission in another folder was refused for a crane file that is not there."""
    shared = tmp_path / "shared"
    shared.mkdir()
    for name in ("paper.toml", "crane_lab.toml"):
        shutil.copy(RIGHT.parent / name, shared)
    link = tmp_path / "paper.toml"
    link.symlink_to(shared / "paper.toml")
    words = f"{link}: crane: .*No such file.*; {link} is a link, .* beside the link, not beside "
    with pytest.raises(InputError, match=words + str(shared / "paper.toml")):
        load_mission(link)
    scenario, link = shared / "scenario.toml", tmp_path / "scenario.toml"
    link.symlink_to(scenario)
    for text in (
        'name = "s"\nmission = "none.toml"\n' + CRITERION, 'base = "none.toml"\nevents = []',
    ):
        scenario.write_text(text, encoding="utf-8")
        with pytest.raises(InputError, match=r"is a link, .* not beside"):
            load_scenario(link)
        with pytest.raises(InputError, match=r"No such file or directory$"):
            load_scenario(scenario)
    (tmp_path / "crane_lab.toml").write_text("bridge_mass = 1.0\n", encoding="utf-8")
    with pytest.raises(InputError, match=r"crane_lab\.toml: .*missing[^;]*$"):
        load_mission(tmp_path / "paper.toml")


MADE = {
    "crane": {"bridge_mass": 2.2, "trolley_mass": 1.155, "payload_mass": 1.0},
    "limits": {axis: {"velocity": 1.0, "acceleration": 1.0, "jerk": 2.0} for axis in "xyz"},
    "waypoints": [{"position": [0.0, 0.0, -0.5]}, {"position": [1.0, 0.0, -0.5]}],
}


def test_a_mission_may_be_made_of_its_keys() -> None:
    assert Mission(**MADE) == load_mission(MADE)


@pytest.mark.parametrize(("changed", "told"), [
    ({"smoothness": 9}, "smoothness: must be at most 6, got 9"),
    ({"crane": None}, "crane: must be a table, got None"),
    ({"crane": Crane(1.0, 1.0, 1.0)}, r"crane: must be a table, got Crane\(bridge_mass=1"),
    ({"waypoints": []}, r"waypoints: must have at least 2 values, got \[\]"),
    ({"smothness": 4}, r"smothness: unknown key; did you mean smoothness\?"),
    ({"self": 4}, "self: unknown key"),
])
def test_keys_of_another_kind_are_one_error_as_in_files(
    changed: dict[str, Any], told: str
) -> None:
    with pytest.raises(InputError, match=f"^{told}"):
        Mission(**MADE | changed)
    if "crane" not in changed:
        with pytest.raises(InputError, match=f"^mission: {told}"):
            load_mission(MADE | changed)


@pytest.mark.parametrize(("key", "words"), [
    ("crane", "crane: must be the name of a crane file, or a table, got 3"),
    ("waypoints", r"waypoints: must be the name of a CSV file, or tables \[\[waypoints\]\], got 3"),
])
def test_a_key_that_may_name_a_file_says_so(tmp_path: Path, key: str, words: str) -> None:
    path = tmp_path / "mission.toml"
    path.write_text(f"{key} = 3\n")
    with pytest.raises(InputError, match=words):
        load_mission(path)
