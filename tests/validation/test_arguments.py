"""Arguments of the functions for missions and scenarios that are none."""

from __future__ import annotations

from pathlib import Path

import pytest

from segfmu import InputError, Limits, Suite, build, load_mission, simulate, validate
from segfmu.validation.output import file_path
from segfmu.validation.runs import Run
from tests.compiler import require_native

MISSION = Path(__file__).parents[2] / "models" / "paper.toml"


@pytest.mark.parametrize("changes", [[], 5, "x", [1]])
def test_changes_of_a_mission_are_a_dict(changes) -> None:
    with pytest.raises(InputError, match="changes of a mission are a dict, got"):
        load_mission(MISSION, changes)
    with pytest.raises(InputError, match="changes of a mission are a dict, got"):
        load_mission(load_mission(MISSION), changes)


def test_limits_of_a_mission_are_those_of_three_axes() -> None:
    source = load_mission(MISSION).model_dump(exclude_unset=True)
    with pytest.raises(InputError, match=r"limits.velocity has 2 values for 3 axes; give one"):
        load_mission({**source, "limits": Limits([1, 1], 1, 1)})
    found = load_mission({**source, "limits": Limits([1, 2, 3], 0.5, [4, None, 6])}).build_limits()
    assert repr(found) == (
        "Limits(velocity=[1.0, 2.0, 3.0], acceleration=[0.5, 0.5, 0.5], jerk=[4.0, None, 6.0])"
    )


@pytest.mark.parametrize(("scenarios", "words"), [
    ([], "no scenarios; name files"), ((), "no scenarios; name files"),
    (None, "scenarios must be a sequence, got None"),
    ([None], "scenarios must be files or folders, got None"), (5, "scenarios must be a sequence"),
    ({"name": "s"}, "scenarios must be a sequence, got {'name': 's'}"),
])
def test_scenarios_that_are_none(scenarios, words: str) -> None:
    with pytest.raises(InputError, match=words):
        validate(scenarios)


@pytest.mark.parametrize("path", [None, 5, ""])
def test_reports_need_a_path(path) -> None:
    with pytest.raises(InputError, match="the path of a file must be given, got"):
        file_path(path)
    with pytest.raises(InputError, match="the path of a file must be given, got"):
        Suite(()).report(path)
    with pytest.raises(InputError, match="the path of a file must be given, got"):
        Run(None, None, None, None).to_csv(path)  # type: ignore[arg-type]


@pytest.mark.parametrize("platforms", ["", " ", ","])
def test_platforms_are_named_or_left_out(platforms: str, tmp_path: Path) -> None:
    with pytest.raises(InputError, match="platforms is empty; name some, or all, or omit it"):
        build(output=tmp_path / "fmus", platforms=platforms)
    assert not (tmp_path / "fmus").exists()


@pytest.mark.parametrize("waypoints", [1, 257, 10**400])
def test_there_is_room_for_2_to_256_waypoints(waypoints: int, tmp_path: Path) -> None:
    with pytest.raises(InputError, match="waypoints must be from 2 to 256, got"):
        build(output=tmp_path / "fmus", waypoints=waypoints)
    assert not (tmp_path / "fmus").exists()


@pytest.mark.parametrize("run", [simulate, build])
def test_a_crane_without_gains_is_refused_by_its_file(run, tmp_path: Path) -> None:
    require_native()
    weight = {"position": 1e300}
    wrong = load_mission(MISSION, {"crane": {"controller": {"weight": weight}}})
    words = r"paper\.toml: the feedback has no gain .*: controller\.weight\.position 1e[+]300"
    with pytest.raises(InputError, match=words):
        run(wrong, output=tmp_path)
    assert not list(tmp_path.iterdir())


def test_a_run_without_a_duration_is_refused_with_its_key(tmp_path: Path) -> None:
    rest = [{"position": [0, 0, -0.5]}] * 2
    mission = load_mission(MISSION, {"waypoints": rest, "simulation": {"settle": 0.0}})
    with pytest.raises(InputError, match=r"simulation\.settle: a plan of 0 s needs a time > 0 s"):
        simulate(mission, output=tmp_path)
    assert not list(tmp_path.iterdir())
