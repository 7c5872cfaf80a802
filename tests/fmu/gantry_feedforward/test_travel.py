"""End stops as parameters of the planners: every plan stays between them, or is refused by name."""

from __future__ import annotations

import re
from itertools import product

import numpy as np
import pytest

import segfmu
from segfmu.fmu.gantry_feedforward.interface import native_spec
from segfmu.fmu.gantry_feedforward.slave import FeedforwardSlave
from segfmu.validation.scenario import feedforward_values, limits_to_find
from tests.campaign import campaign
from tests.fmu.bench import SlaveBench, bench
from tests.fmu.gantry_feedforward.test_drive_bounds import CRANES, KINDS, UP, changed, initialised

AXES = ("bridge", "trolley", "rope")
NAMES = [f"plan.use.travel.{axis}" for axis in AXES]
SAID = re.compile(
    r"at (\S+) s: the plan takes the (\w+) to (\S+) m, beyond its end stop travel\.\w+\.(min|max) "
    r"at (\S+) m; move the waypoints, or lower their velocities and accelerations along ([xyz])"
)


def farthest(trajectory: segfmu.Trajectory) -> tuple[np.ndarray, np.ndarray]:
    """Least and greatest places of bridge, trolley and rope (2, 3), and when, by Newton's laws.

    The rope is along the load's acceleration plus gravity, and ends at the height 0.
    """
    times = np.linspace(0.0, trajectory.duration, 40_001)
    place, pull = trajectory(times), np.add(trajectory(times, 2), UP)
    way = place[:, 2:] / pull[:, 2:] * pull
    places = np.column_stack([(place - way)[:, :2], np.linalg.norm(way, axis=1)])
    rows = np.array([places.argmin(axis=0), places.argmax(axis=0)])
    return np.take_along_axis(places, rows, axis=0), times[rows]


def stops(places: np.ndarray) -> dict[str, float]:
    """Parameters of end stops at places (2, 3)."""
    ends = product(range(2), range(3))
    return {f"travel.{AXES[k]}.{('min', 'max')[i]}": float(places[i, k]) for i, k in ends}


@pytest.fixture(params=KINDS, ids=lambda kind: f"{kind[0]} {kind[1]}")
def archive(request, native_fmus, fmus):
    kind, fmi = request.param
    return native_fmus[fmi][0] if kind == "native" else fmus[0]


@campaign(12, 300)
@pytest.mark.parametrize("crane", CRANES)
def test_whatever_is_changed_end_stops_are_kept_or_named(native_fmus, crane, count: int) -> None:
    rng = np.random.default_rng(21)
    for _ in range(count):
        values, trajectory, _ = changed(rng, crane, haste=0.5)
        places, times = farthest(trajectory)
        room = 2e-3 * np.ptp(places, axis=0)
        wide = places + np.array([-room, room])
        found = initialised(native_fmus[2][0], values | stops(wide))
        assert isinstance(found, dict), found
        # the way from the middle to the farther place, over that to the end stop
        half = 0.5 * np.ptp(wide, axis=0)
        shares = np.abs(places - wide.mean(axis=0)).max(axis=0) / half
        assert [found[n] for n in NAMES] == pytest.approx(shares.tolist(), rel=1e-4)
        side, axis = int(rng.integers(2)), int(rng.integers(3))
        near = wide.copy()
        near[side, axis] = places[side, axis] + (1.0 - 2.0 * side) * room[axis]
        said = SAID.search(str(initialised(native_fmus[2][0], values | stops(near))))
        assert said is not None
        assert said[2] == AXES[axis] and said[4] == ("min", "max")[side]
        assert said[6] == "xyz"[axis]
        assert float(said[3]) == pytest.approx(places[side, axis], abs=1e-2 * room[axis])
        assert float(said[5]) == pytest.approx(near[side, axis], rel=1e-8)
        if np.ptp(places[:, axis]) > 1e-3:
            there = trajectory(np.array([float(said[1]), times[side, axis]]))[:, axis]
            assert abs(np.diff(there)[0]) < 0.05 * np.ptp(places[:, axis])


@pytest.mark.parametrize(("name", "stop", "use"), [
    ("travel.trolley.max", 3.0, 0.0), ("travel.trolley.min", -1.0, 0.0),
    ("travel.bridge.max", 1.5, 0.5),
])
def test_one_end_stop_alone_is_kept_by_metres(archive, name, stop, use) -> None:
    """The paper's mission ends at 1 m and 0.8 m; no carriage goes farther."""
    found = initialised(archive, {name: stop})
    assert isinstance(found, dict), found
    own = f"plan.use.{name.rpartition('.')[0]}"
    assert found.pop(own) == pytest.approx(use, abs=1e-3)
    assert {v for n, v in found.items() if n.startswith("plan.use.") and "time" not in n} == {0.0}


def test_end_stops_without_room_are_refused(archive) -> None:
    message = initialised(archive, {"travel.rope.min": 2.0, "travel.rope.max": 1.0})
    assert "travel.rope: min 2 m must be below max 1 m" in str(message)


# the trolley has to run ahead of a load that brakes late
OVER = {
    "crane": {"bridge_mass": 2.2, "trolley_mass": 1.155, "payload_mass": 1.0,
              "travel": {"trolley": [-0.01, 0.5]}},
    "limits": segfmu.Limits(0.6, 1.0, 5.0, 60.0),
    "waypoints": [
        segfmu.Waypoint([0.0, 0.0, -0.9]),
        segfmu.Waypoint([0.2, 0.45, -0.9], [0.0, 0.3, 0.0], [0.0, 0.9, 0.0]),
        segfmu.Waypoint([0.4, 0.1, -0.9]),
    ],
}


def test_package_and_fmus_say_the_same(native_fmus, fmus) -> None:
    task = segfmu.load_mission(OVER)
    with pytest.raises(segfmu.InfeasibleError) as refused:
        task.plan()
    text = str(refused.value)
    said = SAID.search(text)
    assert said is not None
    assert refused.value.value == pytest.approx(float(said[3]), rel=1e-8)
    assert refused.value.time == pytest.approx(float(said[1]), abs=1e-3)
    # the same mission without end stops gives the parameters
    free = segfmu.load_mission(OVER, {"crane": {"travel": {"trolley": None}}})
    values = feedforward_values(free, free.plan()) | limits_to_find(task)
    values |= {"travel.trolley.min": -0.01, "travel.trolley.max": 0.5}
    for archive in (native_fmus[2][0], native_fmus[3][0], fmus[0]):
        assert text in str(initialised(archive, values))


def test_a_build_has_the_end_stops_of_the_mission() -> None:
    task = segfmu.load_mission(OVER, {"crane": {"travel": {"trolley": [-0.5, 2.5]}}})
    values = feedforward_values(task, task.plan())
    assert (values["travel.trolley.min"], values["travel.trolley.max"]) == (-0.5, 2.5)
    assert limits_to_find(task)["planner.finds_limits"] is True
    assert min(values["travel.rope.max"], -values["travel.bridge.min"]) >= 1e9


def test_limits_are_found_with_which_end_stops_are_kept(native_fmus, fmus) -> None:
    """The rope becomes longer as the load is accelerated aside; more slowly it does so less."""
    crane = segfmu.Crane(2.2, 1.155, 1.0)
    points = [segfmu.Waypoint([0.0, 0.0, -0.9]), segfmu.Waypoint([0.0, 0.8, -0.9]),
              segfmu.Waypoint([0.0, 0.8, -0.4])]
    limits = segfmu.Limits(1.0, 3.0, 30.0, 600.0)
    free = segfmu.plan(points, limits)
    rope = farthest(free)[0][1, 2]
    stop = 0.9 + 0.4 * (rope - 0.9)
    bounds = segfmu.ActuatorBounds(travel=[None, None, stop])
    own = segfmu.plan_actuated(crane, points, limits, bounds)
    assert own.passed and own.trajectory.duration > free.duration
    assert farthest(own.trajectory)[0][1, 2] <= stop * (1.0 + 1e-9)
    assert max(own.uses, key=lambda use: use.use).name == "rope travel"
    values = {"crane.rope_max": 0.0, "crane.rope_min": 0.0, "waypoint.count": 3,
              "planner.finds_limits": True, "travel.rope.max": stop}
    for i, point in enumerate(points, 1):
        for axis, position in zip("xyz", point.position, strict=True):
            values[f"waypoint[{i}].position.{axis}"] = float(position)
            values |= {f"waypoint[{i}].{n}.{axis}": 0.0 for n in ("velocity", "acceleration")}
    for axis in "xyz":
        for name in ("velocity", "acceleration", "jerk", "snap"):
            values[f"limits.{axis}.{name}"] = float(getattr(limits, name))
    for archive in (native_fmus[2][0], fmus[0]):
        found = initialised(archive, values)
        assert isinstance(found, dict), found
        assert found["plan.duration"] == pytest.approx(own.trajectory.duration, rel=1e-9)


def test_a_hook_keeps_its_end_stops(hook_fmus) -> None:
    archive = hook_fmus[2][0]
    plain = initialised(archive, {})
    assert isinstance(plain, dict)
    message = str(initialised(archive, {"travel.rope.max": 0.01}))
    assert SAID.search(message) is not None, message


@campaign(6, 60)
def test_commands_keep_end_stops(count: int) -> None:
    """Sticks at random for 20 s; the carriages that belong to the load stay between their stops."""
    crane = segfmu.Crane(2.2, 1.155, 1.0)
    ends = np.array([[-0.4, -0.3, 0.6], [0.4, 0.3, 1.1]])
    bounds = segfmu.ActuatorBounds(travel=ends[1], travel_min=ends[0])
    limits = segfmu.Limits(0.5, 0.8, 4.0, 40.0)
    left = 0
    for seed in range(count):
        for kept in (bounds, segfmu.ActuatorBounds()):
            rng = np.random.default_rng(seed)
            operator = segfmu.Operator(crane, limits, [0.0, 0.0, -0.8], bounds=kept)
            places = []
            for _ in range(40):
                velocity = rng.choice([-1.0, 0.0, 1.0], 3) * rng.uniform(0.1, 0.5, 3)
                operator.command("velocity", velocity * [1.0, 1.0, 0.3])
                for _ in range(5):
                    load = operator.step(0.1)
                    pull = load[2] + UP
                    way = load[0, 2] / pull[2] * pull
                    places.append([*(load[0] - way)[:2], np.linalg.norm(way)])
            beyond = max(np.max(ends[0] - places), np.max(np.array(places) - ends[1]))
            if kept is bounds:
                assert beyond <= 1e-9
                # near enough: the sticks push on
                assert beyond > -5e-3
            else:
                left += beyond > 0.05
    assert left == count


def test_a_target_beyond_an_end_stop_is_refused_while_it_runs(native_fmus) -> None:
    start = {"command.enabled": True, "command.mode": "target", "command.target.x": 1.3,
             "command.target.z": -0.5, "travel.bridge.min": -0.5, "travel.bridge.max": 1.1}
    times = np.arange(21) / 10.0
    names = ["plan.refused", "reference.bridge.position"]
    slave = SlaveBench(FeedforwardSlave, names).run(start, lambda _: {}, times)
    with bench(native_fmus[2][0], native_spec(), names) as runs:
        rows = runs.run(start, lambda _: {}, times)
    assert slave is not None and rows is not None
    assert rows["plan.refused"][-1] == slave["plan.refused"][-1] == 8
    assert max(rows[names[1]]) <= 1.1 and max(slave[names[1]]) <= 1.1
