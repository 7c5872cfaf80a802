"""GantryFeedforward finds limits of the load by itself: as the package does, within all bounds."""

from __future__ import annotations

import os
from typing import Any

import numpy as np
import pytest

import segfmu
import segfmu.cosim.load
from segfmu.crane import Friction
from segfmu.fmu.gantry_feedforward.interface import POINTS
from segfmu.kernels.crane.records import DriveBounds
from tests.campaign import soaked_rows
from tests.fmu.gantry_feedforward.test_drive_bounds import (
    CRANES,
    bound_values,
    changed,
    demands,
    initialised,
    lag_values,
)

KINDS = [("native", 2), ("native", 3), ("python", 2)]
FIND = {"planner.finds_limits": True}
NAMES = ("velocity", "acceleration", "jerk", "snap")


@pytest.fixture(params=KINDS, ids=lambda kind: f"{kind[0]} {kind[1]}")
def archive(request, native_fmus, fmus):
    kind, fmi = request.param
    return native_fmus[fmi][0] if kind == "native" else fmus[0]


def problem(
    rng, size: str, share: float = 1.0, lag: float = 0.0
) -> tuple[dict[str, Any], dict[str, Any]]:
    """Parameters of a random change, and the arguments of `plan_actuated` that say the same.

    share: of the bounds in the negative direction; lag: of the velocity loops [s].
    """
    values, trajectory, masses = changed(rng, size)
    given, magnitudes = bound_values(size)
    values |= given | FIND | NONE
    force, velocity, acceleration, power = magnitudes[:12].reshape(4, 3)
    bounds = segfmu.ActuatorBounds(
        force, velocity, acceleration, magnitudes[12:], power,
        velocity_min=-share * velocity, acceleration_min=-share * acceleration, lag=lag,
    )
    values |= lag_values(lag)
    if share != 1.0:
        record = bounds.record.tolist()
        values |= {name: record[place] for place, name, _ in DriveBounds.feeds()}
    arguments = {
        "crane": segfmu.Crane(*masses), "waypoints": trajectory.waypoints, "limits": None,
        "bounds": bounds,
    }
    return values, arguments


@pytest.mark.soak
@pytest.mark.parametrize(("size", "share", "lag"), [
    ("lab", 0.6, 0.2),
    *soaked_rows(("ship to shore", 1.0, 0.0), ("lab", 1.0, 0.0), ("ship to shore", 0.6, 0.2)),
])
def test_the_plan_is_that_of_the_package(native_fmus, size: str, share: float, lag: float) -> None:
    rng = np.random.default_rng(8)
    planned = refused = 0
    for _ in range(100 if os.environ.get("SEGFMU_SOAK") else 3):
        values, arguments = problem(rng, size, share, lag)
        found = initialised(native_fmus[2][0], values)
        try:
            own = segfmu.plan_actuated(**arguments)
        except segfmu.InfeasibleError:
            assert isinstance(found, str)
            refused += 1
            continue
        assert isinstance(found, dict), found
        assert found["plan.duration"] == pytest.approx(own.trajectory.duration, rel=1e-9)
        masses = (*CRANES[size][0][:2], arguments["crane"].payload_mass)
        shares = demands(own.trajectory, masses, lag)
        uses = [v for n, v in found.items() if n.startswith("plan.use.") and "_time" not in n]
        assert 1.0 - 1e-6 <= max(uses) <= 1.0 + 1e-9
        # the larger bounds are in the positive direction
        assert (shares / bound_values(size)[1]).max() <= 1.0 + 2e-3
        planned += 1
    assert planned > refused


def test_limits_that_are_given_hold_as_well(archive) -> None:
    found = initialised(
        archive, FIND | {"drive.trolley.acceleration_max": 0.6, "drive.bridge.velocity_max": 0.35}
    )
    assert isinstance(found, dict), found
    own = segfmu.plan_actuated(
        segfmu.Crane(2.2, 1.155, 1.0),
        [segfmu.Waypoint(*states) for states in POINTS],
        segfmu.Limits([1, 0.4, 0.3], [1, 0.5, 0.5], [1, 0.5, 0.5], [10, 5, 5]),
        segfmu.ActuatorBounds(velocity=[0.35, None, None], acceleration=[None, 0.6, None]),
    )
    assert found["plan.duration"] == pytest.approx(own.trajectory.duration, rel=1e-9)
    assert found["plan.use.bridge.velocity"] <= 1.0 + 1e-9


def test_limits_within_the_bounds_stay_as_they_are(archive) -> None:
    plain = initialised(archive, {})
    assert initialised(archive, FIND) == plain
    assert initialised(archive, FIND | {"drive.trolley.acceleration_max": 50.0})[
        "plan.duration"
    ] == plain["plan.duration"]


NONE = {f"limits.{a}.{n}": 0.0 for a in "xyz" for n in NAMES}


@pytest.mark.parametrize(("changes", "told"), [
    ({"drive.hoist.force_max": 9.8}, "drive.hoist.force_max is 9.8 N"),
    (NONE, "axis x: nothing bounds the acceleration; give a bound of the bridge's acceleration"),
    (NONE | {"drive.bridge.velocity_max": 1e-7, "drive.bridge.acceleration_max": 1.0},
     "bridge velocity must have a bound of at least 1e-05 m/s, got 1e-07 m/s"),
    ({"drive.bridge.velocity_max": 0.35, "planner.duration": 1.0}, "duration 1 s is shorter than"),
])
def test_what_cannot_be_found_is_refused(archive, changes, told: str) -> None:
    message = initialised(archive, FIND | changes)
    assert isinstance(message, str), message
    assert told in message


def test_a_duration_and_a_sample_time_are_kept(archive) -> None:
    given = FIND | {"drive.bridge.velocity_max": 0.35}
    shortest = initialised(archive, given)["plan.duration"]
    assert initialised(archive, given | {"planner.duration": 1.4 * shortest})[
        "plan.duration"
    ] == pytest.approx(1.4 * shortest, rel=1e-12)
    whole = initialised(archive, given | {"planner.sample_time": 0.1})["plan.duration"]
    assert shortest <= whole < shortest + 0.25
    assert whole * 10.0 == pytest.approx(round(whole * 10.0), abs=1e-9)


def test_a_load_that_stays_needs_no_limits(native_fmus, fmus) -> None:
    values = {f"waypoint[2].{n}.{a}": 0.0 for n in ("velocity", "acceleration") for a in "xyz"}
    values |= {f"waypoint[2].position.{a}": v for a, v in zip("xyz", (0, 0, -0.5), strict=True)}
    for archive in (native_fmus[2][0], fmus[0]):
        found = initialised(archive, FIND | NONE | values | {"waypoint.count": 2})
        assert isinstance(found, dict), found
        assert found["plan.duration"] == 0.0


def test_friction_and_an_obstacle_are_heeded(native_fmus, fmus) -> None:
    given = FIND | {
        "waypoint.count": 2, "waypoint[2].position.x": 1.0, "waypoint[2].position.y": 0.8,
        "drive.bridge.force_max": 6.0, "drive.trolley.force_max": 4.0,
        **{f"waypoint[2].{n}.{a}": 0.0 for n in ("velocity", "acceleration") for a in "xyz"},
        **NONE,
    }
    free = initialised(native_fmus[2][0], given)
    rubbing = initialised(
        native_fmus[2][0], given | {"friction.bridge.coulomb": 3.0, "friction.presliding": 1e-4}
    )
    assert rubbing["plan.duration"] > 1.1 * free["plan.duration"]
    own = segfmu.plan_actuated(
        segfmu.Crane(2.2, 1.155, 1.0),
        [segfmu.Waypoint([0, 0, -0.5]), segfmu.Waypoint([1.0, 0.8, -0.5])], None,
        segfmu.ActuatorBounds(force=[6.0, 4.0, None]),
        friction=Friction(coulomb=[3.0, 0.0, 0.0], presliding=1e-4),
    )
    assert rubbing["plan.duration"] == pytest.approx(own.trajectory.duration, rel=1e-9)
    wall = {"obstacle.count": 1, "obstacle[1].rope": False} | {
        f"obstacle[1].{end}.{a}": v
        for end, place in (("minimum", (0.4, -1.0, -2.0)), ("maximum", (0.6, 2.0, 0.0)))
        for a, v in zip("xyz", place, strict=True)
    }
    told = [
        str(initialised(archive, given | wall)).partition("obstacle 1: ")[2]
        for archive in (native_fmus[2][0], fmus[0])
    ]
    assert told[0].startswith("the load meets it") and told[1] == told[0]


def test_the_limits_that_are_found_are_shown(native_fmus) -> None:
    values, arguments = problem(np.random.default_rng(2), "ship to shore")
    own = segfmu.plan_actuated(**arguments).trajectory.limits
    with segfmu.cosim.load.load(native_fmus[2][0]) as unit:
        unit.set(values)
        unit.enter_initialization(0.0, 1.0)
        unit.exit_initialization()
        names = [f"plan.limits.{a}.{n}" for a in "xyz" for n in NAMES]
        channel = unit.channel(names)
        channel.read()
        shown = channel.values.copy()
    assert shown == pytest.approx(own.table(3, 4)[:, :4].ravel(), rel=1e-9)
