"""Bounds of the drives as parameters of GantryFeedforward: kept, or refused by name."""

from __future__ import annotations

import os
import re
from typing import Any

import numpy as np
import pytest
from fmpy.fmi1 import FMICallException

import segfmu
from segfmu.cosim.load import load
from segfmu.errors import SimulationError
from segfmu.kernels.crane.records import BOUNDED
from tests.campaign import soaked, soaked_rows
from tests.fmu.native.importer import Importer

# in the order of `demands`; end stops have tests of their own
DRIVEN = tuple(name for name in BOUNDED if not name.startswith("travel."))
KINDS = [("native", 2), ("native", 3), ("python", 2)]
GRAVITY = 9.81
UP = (0.0, 0.0, GRAVITY)
CRANES = {
    # masses [kg], bounds of force, velocity, acceleration, power and sway, largest way [m], rope
    "lab": ((2.2, 1.155, 1.0), ((6.0, 3.0, 11.0), 0.7, 0.9, (4.0, 2.0, 4.0), 0.09), 1.0, 0.8),
    "ship to shore": (
        (7.5e5, 2.5e4, 4e4), ((6e5, 8e4, 4.71e5), (0.75, 4.0, 1.5), (0.3, 0.8, 0.75),
                              (4e5, 3e5, 5.89e5), 0.12), 70.0, 30.0,
    ),
}


@pytest.fixture(params=KINDS, ids=lambda kind: f"{kind[0]} {kind[1]}")
def archive(request, native_fmus, fmus):
    kind, fmi = request.param
    return native_fmus[fmi][0] if kind == "native" else fmus[0]


ROW = re.compile(r"(waypoint|obstacle)\[(\d+)\]\.(\w+)(?:\.([xyz]))?$")


def with_arrays(unit, values) -> dict[str, Any]:
    """Values of rows as the FMU has them: one by one, or as whole arrays that it has else."""
    given = dict(values)
    for name in [n for n in values if ROW.match(n) and n not in unit.variables]:
        part, row, field, axis = ROW.match(name).groups()
        array = f"{part}.{field}"
        if array not in given:
            channel = unit.channel([array])
            channel.read()
            rows = int(unit.variables[array].dimensions[0].start)
            given[array] = channel.values.copy().reshape(rows, -1)
        given[array][int(row) - 1, "xyz".index(axis) if axis else 0] = given.pop(name)
    return given


def initialised(archive, values) -> dict[str, float] | str:
    """Duration and uses of the plan, or why it is refused."""
    names = [f"plan.use.{n}{what}" for n in BOUNDED for what in ("", "_time")]
    names += ["plan.duration", "plan.pace"]
    with load(archive) as unit:
        try:
            unit.set(with_arrays(unit, values))
            unit.enter_initialization(0.0, 1.0)
            unit.exit_initialization()
        except SimulationError as error:
            return str(error)
        channel = unit.channel(names)
        channel.read()
        return dict(zip(names, channel.values.tolist(), strict=True))


def test_without_bounds_nothing_is_used(archive) -> None:
    found = initialised(archive, {})
    assert found.pop("plan.duration") > 0.0
    assert found.pop("plan.pace") == 1.0
    assert set(found.values()) == {0.0}


@pytest.mark.parametrize(
    ("name", "value", "told"),
    [
        ("drive.bridge.force_max", 1.0, r"needs 2\.\d+ N, drive.bridge.force_max is 1 N; lower limi"
         r"ts.x or the masses"),
        ("drive.trolley.force_min", -0.5, r"needs -0.\d+ N, drive.trolley.force_min is -0.5 N"),
        ("drive.hoist.force_max", 9.8, r"needs 9.\d+ N, drive.hoist.force_max is 9.8 N; lower li"),
        ("drive.trolley.velocity_max", 0.1, r"needs 0.\d+ m/s, drive.trolley.velocity_max is 0.1"),
        ("drive.bridge.acceleration_max", 0.2, r"needs [01].\d+ m/s2, drive.bridge.acceleration_"),
        ("drive.bridge.power_max", 0.5, r"needs \d.\d+ W, drive.bridge.power_max is 0.5 W; lower "),
        ("sway.y.angle_max", 0.01, r"needs 0.0\d+ rad, sway.y.angle_max is 0.01 rad; lower limits"),
    ],
)
def test_what_is_exceeded_is_named(archive, name, value, told) -> None:
    message = initialised(archive, {name: value})
    assert isinstance(message, str)
    assert re.search(rf"at \d\.\d+ s: the plan {told}", message), message
    assert message.endswith("move the waypoints, or raise the bound")


def test_a_refused_instance_plans_with_other_parameters(native_fmus) -> None:
    with Importer(native_fmus[2][0]) as fmu:
        fmu.set({"drive.bridge.velocity_max": 0.1})
        with pytest.raises(FMICallException):
            fmu.initialise()
        fmu.fmu.reset()
        fmu.set({"drive.bridge.velocity_max": 10.0})
        fmu.initialise()
        assert 0.0 < float(fmu.get("plan.use.bridge.velocity")[0]) < 0.5


def demands(trajectory, masses, lag=0.0) -> np.ndarray:
    """Greatest magnitudes in the order of DRIVEN, by Newton's laws and finite differences.

    Of the velocities the setpoint's, which leads by the lag [s] of the velocity loop.

    The rope points along the load's acceleration plus gravity; nothing else pulls at the load.
    """
    bridge, trolley, load = masses
    # some pieces are short
    pieces = [trajectory.pieces(axis)[:2] for axis in range(3)]
    shares = np.linspace(0.0, 1.0, 81)
    times = np.concatenate([
        (starts[:, None] + lengths[:, None] * shares).ravel() for starts, lengths in pieces
    ])
    h = trajectory.duration * 1e-5

    def carriage(t):
        place, pull = trajectory(t), np.add(trajectory(t, 2), UP)
        way = place[:, 2:] / pull[:, 2:]
        top = place - way * pull
        return np.column_stack([top[:, :2], np.linalg.norm(place - top, axis=1)])

    near = [carriage(times + k * h) for k in (-1, 0, 1)]
    velocity, acceleration = (near[2] - near[0]) / (2 * h), (near[2] - 2 * near[1] + near[0]) / h**2
    pull = np.add(trajectory(times, 2), UP)
    force = np.column_stack([
        (bridge + trolley) * acceleration[:, 0] + load * pull[:, 0],
        trolley * acceleration[:, 1] + load * pull[:, 1],
        -load * np.linalg.norm(pull, axis=1),
    ])
    down = pull / np.linalg.norm(pull, axis=1)[:, None]
    sway = np.column_stack([np.arcsin(down[:, 0]), np.arctan2(down[:, 1], down[:, 2])])
    setpoint = velocity + lag * acceleration
    rows = np.hstack([force, setpoint, acceleration, force * velocity, sway])
    return np.abs(rows).max(axis=0)


def changed(
    rng, crane, haste=-1.0
) -> tuple[dict[str, float], segfmu.Trajectory, tuple[float, ...]]:
    """Parameters of a random change of masses, limits and waypoints, and what it plans."""
    masses, _, way, rope = CRANES[crane]
    masses = (*masses[:2], masses[2] * float(rng.uniform(0.15, 1.5)))
    y = np.cumsum([0.0, *rng.uniform(0.05, 0.5, 3)]) * way
    z = -rope * rng.uniform(0.6, 1.2, 4)
    points = [segfmu.Waypoint([0.3 * a, a, b]) for a, b in zip(y, z, strict=True)]
    swing = (rope / GRAVITY) ** 0.5
    speed = np.exp(rng.uniform(haste - 3.5, haste))
    velocity, acceleration = way**0.5 * speed * np.array([1.0, 0.3])
    jerk = acceleration / swing
    shares = np.array([1.0, 1.0, 0.5])
    limits = segfmu.Limits(
        velocity * shares, acceleration * shares, jerk, 3.0 * jerk / swing
    )
    values = dict(zip((f"crane.{n}_mass" for n in ("bridge", "trolley", "payload")), masses,
                      strict=True))
    values |= {"crane.rope_max": 0.0, "crane.rope_min": 0.0, "waypoint.count": len(points)}
    for i, point in enumerate(points, 1):
        for axis, position in zip("xyz", point.position, strict=True):
            values[f"waypoint[{i}].position.{axis}"] = float(position)
            for name in ("velocity", "acceleration"):
                values[f"waypoint[{i}].{name}.{axis}"] = 0.0
    for k, axis in enumerate("xyz"):
        for name in ("velocity", "acceleration", "jerk", "snap"):
            limit = np.broadcast_to(getattr(limits, name), (3,))
            values[f"limits.{axis}.{name}"] = float(limit[k])
    return values, segfmu.plan(points, limits), masses


def bound_values(crane) -> tuple[dict[str, float], np.ndarray]:
    """Parameters of a crane's bounds, and their magnitudes in the order of DRIVEN."""
    *drives, sway = CRANES[crane][1]
    numbers = np.concatenate([*(np.broadcast_to(b, (3,)) for b in drives), [sway, sway]])
    names = [f"drive.{n}_max" for n in DRIVEN[:-2]] + ["sway.x.angle_max", "sway.y.angle_max"]
    return dict(zip(names, numbers.tolist(), strict=True)), numbers


def lag_values(lag: float) -> dict[str, float]:
    return {f"drive.{d}.lag": lag for d in ("bridge", "trolley", "hoist")}


@pytest.mark.soak
@pytest.mark.parametrize(("crane", "lag"), [
    ("lab", 0.5), ("ship to shore", 0.0), *soaked_rows(("lab", 0.0), ("ship to shore", 0.5)),
])
def test_whatever_is_changed_bounds_are_kept_or_named(native_fmus, crane, lag) -> None:
    count = 500 if os.environ.get("SEGFMU_SOAK") else 25
    rng = np.random.default_rng(3)
    given, bounds = bound_values(crane)
    given |= lag_values(lag)
    kept = refused = 0
    for _ in range(count):
        values, trajectory, masses = changed(rng, crane)
        shares = demands(trajectory, masses, lag) / bounds
        found = initialised(native_fmus[2][0], values | given)
        if isinstance(found, str):
            refused += 1
            worst = re.search(r"(?:drive\.)?(\w+\.\w+?)(?:_max|_min|\.angle_max) is", found)
            assert shares.max() > 0.999, found
            assert worst is not None, found
            assert shares[DRIVEN.index(worst[1])] > 0.999 * shares.max(), found
        else:
            kept += 1
            uses = [found[f"plan.use.{n}"] for n in DRIVEN]
            assert max(uses) <= 1.0 + 1e-9
            # differences see a peak but for their own error
            assert uses == pytest.approx(shares.tolist(), rel=2e-3, abs=1e-3)
            assert found["plan.duration"] == pytest.approx(trajectory.duration, rel=1e-12)
    assert kept > count / 10 and refused > count / 10, (kept, refused)


@pytest.mark.parametrize("crane", ["lab", *soaked("ship to shore")])
def test_a_motion_is_slowed_until_it_just_keeps_the_bounds(native_fmus, crane) -> None:
    rng = np.random.default_rng(5)
    given, bounds = bound_values(crane)
    given["planner.slows_down"] = True
    slowed = refused = 0
    for _ in range(25):
        values, trajectory, masses = changed(rng, crane, haste=1.6)
        values["waypoint[2].velocity.y"] = 0.2 * values["limits.y.velocity"]
        found = initialised(native_fmus[2][0], values | given)
        if isinstance(found, str):
            # the load is too heavy at any pace, or the moving waypoint has no plan
            assert GRAVITY * masses[2] > bounds[2] or "axis y, waypoints" in found, found
            refused += 1
            continue
        use = max(found[f"plan.use.{n}"] for n in BOUNDED)
        assert use <= 1.0 + 1e-9
        pace = found["plan.pace"]
        if pace < 1.0:
            slowed += 1
            assert use >= 1.0 - 1e-6
            free = initialised(native_fmus[2][0], values)
            assert found["plan.duration"] * pace == pytest.approx(free["plan.duration"], rel=1e-6)
    assert slowed > 8 and refused < 12, (slowed, refused)


def test_both_backends_slow_down_alike(native_fmus, fmus) -> None:
    values = {"planner.slows_down": True, "drive.trolley.acceleration_max": 0.1,
              "sway.x.angle_max": 0.02}
    kinds = (native_fmus[2][0], native_fmus[3][0], fmus[0])
    one, *others = (initialised(archive, values) for archive in kinds)
    assert 0.1 < one["plan.pace"] < 0.9
    assert all(other == pytest.approx(one, rel=1e-9) for other in others)
