"""GantryFeedforward chooses free velocities and accelerations of waypoints, as the package does."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import segfmu
from segfmu.cosim.load import load
from tests.campaign import soaked, soaked_rows
from tests.fmu.gantry_feedforward.test_drive_bounds import (
    CRANES,
    GRAVITY,
    bound_values,
    initialised,
)
from tests.fmu.gantry_feedforward.test_found_limits import FIND, NONE, problem

MODELS = Path(__file__).parents[3] / "models"
STATES = ("velocity", "acceleration")
KINDS = [("native", 2), ("native", 3), ("python", 2)]
EVERY = np.ones((2, 3), dtype=bool)


@pytest.fixture(params=KINDS, ids=lambda kind: f"{kind[0]} {kind[1]}")
def archive(request, native_fmus, fmus):
    kind, fmi = request.param
    return native_fmus[fmi][0] if kind == "native" else fmus[0]


def flags(number: int, free: np.ndarray) -> dict[str, bool]:
    """Parameters of a waypoint, from 1, of whose velocities and accelerations some are free."""
    return {
        f"waypoint[{number}].{state}_free.{axis}": bool(one)
        for state, row in zip(STATES, free, strict=True)
        for axis, one in zip("xyz", row, strict=True)
    }


def freed(rng, size: str, share: float) -> tuple[dict[str, Any], dict[str, Any]]:
    """A random change in which states are free, and the arguments of `plan_actuated`."""
    values, arguments = problem(rng, size, share)
    points = list(arguments["waypoints"])
    for i in range(1, len(points) - 1):
        free = rng.random((2, 3)) < 0.7
        # what is given beside a flag is no matter
        values |= flags(i + 1, free) | {f"waypoint[{i + 1}].velocity.y": 0.4 * float(free[0, 1])}
        states = np.where(free, None, 0.0).tolist()
        points[i] = segfmu.Waypoint(points[i].position, *states)
    return values, arguments | {"waypoints": points}


def uses(trajectory: segfmu.Trajectory, masses, bounds: np.ndarray) -> float:
    """The largest use of a bound among samples, by Newton's laws and the chain rule.

    The rope is along p'' + g, so the trolley is at p + q (p'' + g) with q = -z / (z'' + g).
    """
    bridge, trolley, load = masses
    times = np.linspace(0.0, trajectory.duration, 4001)
    place, rate, *pulls = (trajectory(times, order) for order in range(5))
    pulls[0] = pulls[0] + [0.0, 0.0, GRAVITY]
    top, (n, n1, n2) = [-place[:, 2], -rate[:, 2]], (p[:, 2] for p in pulls)
    top.append(GRAVITY - n)
    q = top[0] / n
    q1 = (top[1] - q * n1) / n
    q2 = (top[2] - 2.0 * q1 * n1 - q * n2) / n
    q, q1, q2 = (v[:, None] for v in (q, q1, q2))
    velocity = rate + q1 * pulls[0] + q * pulls[1]
    acceleration = pulls[0] + q2 * pulls[0] + 2.0 * q1 * pulls[1] + q * pulls[2]
    size = np.linalg.norm(pulls[0], axis=1)
    size1 = (pulls[0] * pulls[1]).sum(axis=1) / size
    size2 = ((pulls[1] ** 2 + pulls[0] * pulls[2]).sum(axis=1) - size1**2) / size
    length, *rates = q[:, 0], q1[:, 0], q2[:, 0]
    velocity[:, 2] = rates[0] * size + length * size1
    acceleration[:, 2] = rates[1] * size + 2.0 * rates[0] * size1 + length * size2
    force = np.column_stack([
        (bridge + trolley) * acceleration[:, 0] + load * pulls[0][:, 0],
        trolley * acceleration[:, 1] + load * pulls[0][:, 1], -load * size,
    ])
    sway = np.column_stack([
        np.arcsin(pulls[0][:, 0] / size), np.arctan2(pulls[0][:, 1], pulls[0][:, 2])
    ])
    found = np.hstack([force, velocity, acceleration, force * velocity, sway])
    return float((np.abs(found).max(axis=0) / bounds).max())


@pytest.mark.soak
@pytest.mark.parametrize(("size", "share"), [
    ("lab", 0.6),
    *soaked_rows(("lab", 1.0), ("ship to shore", 0.6), ("ship to shore", 1.0)),
])
def test_the_plan_is_that_of_the_package(native_fmus, size: str, share: float) -> None:
    rng = np.random.default_rng(6)
    planned = 0
    count = 60 if os.environ.get("SEGFMU_SOAK") else 1
    for _ in range(count):
        values, arguments = freed(rng, size, share)
        found = initialised(native_fmus[2][0], values)
        try:
            own = segfmu.plan_actuated(**arguments).trajectory
        except segfmu.InfeasibleError:
            assert isinstance(found, str)
            continue
        assert isinstance(found, dict), found
        planned += 1
        assert found["plan.duration"] == pytest.approx(own.duration, rel=1e-9)
        used = [v for n, v in found.items() if n.startswith("plan.use.") and "_time" not in n]
        assert 1.0 - 1e-6 <= max(used) <= 1.0 + 1e-9
        masses = (*CRANES[size][0][:2], arguments["crane"].payload_mass)
        assert uses(own, masses, bound_values(size)[1]) <= 1.0 + 1e-9
        rest = initialised(native_fmus[2][0], values | flags(2, ~EVERY) | flags(3, ~EVERY) | {
            f"waypoint[{i}].velocity.y": 0.0 for i in (2, 3)
        })
        assert found["plan.duration"] < rest["plan.duration"] * (1.0 + 1e-9)
    assert planned > count / 3


@pytest.fixture(scope="module", params=[2, *soaked(3)])
def built(request, tmp_path_factory: pytest.TempPathFactory):
    """GantryFeedforward as `segfmu build` makes it of the mission with containers."""
    folder = tmp_path_factory.mktemp(f"container{request.param}")
    mission = segfmu.load_mission(MODELS / "container.toml")
    return segfmu.build(mission, folder, fmi=request.param).feedforward


@pytest.mark.parametrize(("place", "mass"), [
    (40.0, 44e3), *soaked_rows((45.0, 4e4), (50.0, 8e3)),
])
def test_a_mission_stays_what_it_is_after_a_change(built, place: float, mass: float) -> None:
    mission = segfmu.load_mission(MODELS / "container.toml")
    *before, last = mission.waypoints
    last = last.model_copy(update={"position": [0.0, place, -30.0]})
    crane = mission.crane.model_copy(update={"payload_mass": mass})
    own = mission.model_copy(update={"waypoints": [*before, last], "crane": crane}).plan()
    found = initialised(built, {"waypoint[4].position.y": place, "crane.payload_mass": mass})
    assert isinstance(found, dict), found
    assert found["plan.duration"] == pytest.approx(own.duration, rel=1e-9)
    used = [v for n, v in found.items() if n.startswith("plan.use.") and "_time" not in n]
    assert 1.0 - 1e-6 <= max(used) <= 1.0 + 1e-9


LIMITS = np.array([[0.5, 0.4, 1.0, 8.0], [0.4, 0.4, 1.2, 9.0], [0.3, 0.3, 1.0, 6.0]])
PLACES = [[0.0, 0.0, -0.8], [0.4, 0.3, -0.7], [0.9, 0.5, -0.6], [1.3, 0.4, -0.6]]


@pytest.mark.parametrize(("smoothness", "shape", "synchronization"), [
    (4, "plateau", "waypoints"), (4, "plateau", "total"), (5, "smoothstep", "none"),
])
def test_states_are_chosen_within_given_limits_as_the_package_does(
    archive, smoothness: int, shape: str, synchronization: str
) -> None:
    values = {
        f"limits.{a}.{n}": float(v) for a, row in zip("xyz", LIMITS, strict=True)
        for n, v in zip((*STATES, "jerk", "snap"), row, strict=True)
    }
    values |= {
        f"waypoint[{i}].position.{a}": v for i, place in enumerate(PLACES, 1)
        for a, v in zip("xyz", place, strict=True)
    }
    values |= {"waypoint.count": 4, "planner.smoothness": smoothness, "planner.shape": shape,
               "planner.synchronization": synchronization} | flags(2, EVERY) | flags(3, EVERY)
    points = [segfmu.Waypoint(p, "free", "free") for p in PLACES]
    points[0], points[-1] = segfmu.Waypoint(PLACES[0]), segfmu.Waypoint(PLACES[-1])
    own = segfmu.plan(
        points, segfmu.Limits(*LIMITS.T), smoothness=smoothness, shape=shape,
        synchronize=synchronization,
    )
    resting = segfmu.plan(
        [segfmu.Waypoint(p) for p in PLACES], segfmu.Limits(*LIMITS.T), smoothness=smoothness,
        shape=shape, synchronize=synchronization,
    )
    found = initialised(archive, values)
    assert isinstance(found, dict), found
    assert found["plan.duration"] == pytest.approx(own.duration, rel=1e-9)
    assert found["plan.duration"] < 0.9 * resting.duration


def test_flags_of_waypoints_that_are_not_in_use_are_no_matter(archive) -> None:
    assert initialised(archive, flags(4, EVERY)) == initialised(archive, {})


def test_ends_turns_and_dwells_are_at_rest(native_fmus) -> None:
    bounds, _ = bound_values("lab")
    places = [(0.0, 0.0, -0.5), (0.5, 0.3, -0.5), (0.2, 0.5, -0.5), (0.6, 0.6, -0.5)]
    values = bounds | FIND | NONE | {"waypoint.count": 4, "waypoint[3].dwell": 0.5}
    values |= {f"waypoint[{i}].{n}.{a}": 0.0 for i in (1, 2, 3, 4) for n in STATES for a in "xyz"}
    for i, place in enumerate(places, 1):
        values |= {f"waypoint[{i}].position.{a}": p for a, p in zip("xyz", place, strict=True)}
    turn = np.zeros((2, 3), dtype=bool)
    turn[:, 0] = True
    free = flags(1, EVERY) | flags(2, turn) | flags(3, EVERY) | flags(4, EVERY)
    archive = native_fmus[2][0]
    rest = initialised(archive, values)
    assert initialised(archive, values | free) == rest
    onward = values | {"waypoint[2].position.x": 0.1, "waypoint[3].dwell": 0.0}
    rest, found = initialised(archive, onward), initialised(archive, onward | free)
    assert found["plan.duration"] < 0.98 * rest["plan.duration"]


def test_both_backends_choose_alike(native_fmus, fmus) -> None:
    values, _ = freed(np.random.default_rng(12), "lab", 1.0)
    one, *others = (initialised(a, values) for a in (native_fmus[2][0], native_fmus[3][0], fmus[0]))
    assert isinstance(one, dict), one
    assert all(other == pytest.approx(one, rel=1e-9) for other in others)


def test_flags_are_an_array_in_fmi_3(native_fmus) -> None:
    with load(native_fmus[3][0]) as unit:
        unit.set({"waypoint.velocity_free": np.eye(16, 3, dtype=bool).tolist()})
        channel = unit.channel(["waypoint.velocity_free"])
        channel.read()
        assert channel.values.reshape(16, 3).tolist() == np.eye(16, 3, dtype=bool).tolist()
