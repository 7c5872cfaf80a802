"""Drives that trip: brakes by closed forms, the load by Newton's laws."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from benchmarks.operated import LAB, SITES, Site

from segfmu import ActuatorBounds, InputError, Operator, Waypoint, load_mission
from segfmu.kernels.crane.records import DRIVES
from tests.crane.test_emergency import moving, swung

# of the brakes, over the greatest decelerations of the drives: gentler and rougher ones
SHARES = {"gentle": 0.4, "rough": 1.5}


def brakes_of(site: Site, share: float) -> np.ndarray:
    return share * np.asarray(site.bounds.acceleration) * np.ones(3)


def stopping(site: Site, drives: tuple[str, ...], share: float) -> Site:
    """A site whose greatest decelerations are those that the carriages brake with."""
    tripped = np.isin(DRIVES, drives)
    found = np.where(tripped, brakes_of(site, share), brakes_of(site, 1.0))
    return replace(site, bounds=ActuatorBounds(acceleration=found))


@pytest.mark.parametrize("share", SHARES.values(), ids=SHARES)
@pytest.mark.parametrize("drives", [("bridge",), ("trolley",), ("hoist",), DRIVES], ids=str)
@pytest.mark.parametrize("name", SITES)
def test_a_brake_stops_its_axis_and_the_drives_the_others(
    name: str, drives: tuple[str, ...], share: float
) -> None:
    site = SITES[name]
    operator = moving(site, brakes=brakes_of(site, share))
    start = operator.setpoints[3:13].copy()
    operator.trip(*drives)
    assert operator.tripped == drives
    foreseen, begin = operator.emergency, operator.time
    times, loads, carriages = [], [], []
    for _ in range(150):
        operator.step(site.step)
        times.append(operator.time - begin)
        loads.append(operator.load[0])
        carriages.append(operator.setpoints[3:6])
    given = stopping(site, drives, share)
    stops = np.abs(start[5:8]) / np.asarray(given.bounds.acceleration)
    assert foreseen.duration == pytest.approx(stops.max(), rel=1e-9)
    assert operator.emergency == foreseen
    # where a carriage comes to rest
    ways = 0.5 * start[5:8] * stops
    np.testing.assert_allclose(carriages[-1] - start[:3], ways, atol=1e-9 * -site.start[2])
    np.testing.assert_allclose(
        loads, swung(given, start, np.array(times)), atol=1e-6 * -site.start[2]
    )


def test_a_brake_is_as_strong_as_its_drive_unless_told() -> None:
    operator, other = moving(LAB), moving(LAB)
    operator.trip("trolley")
    other.command("emergency")
    for _ in range(40):
        np.testing.assert_array_equal(operator.step(LAB.step), other.step(LAB.step))


def test_nothing_is_followed_until_the_drive_is_reset() -> None:
    operator = moving(LAB, brakes=brakes_of(LAB, 1.5))
    operator.trip("hoist")
    operator.step(LAB.step)
    assert operator.status == "taken"
    stands = operator.time + operator.emergency.duration
    for mode in ("velocity", "target", "stop", "inching", "mission"):
        operator.command(mode, velocity=[0.2, 0.0, 0.0], target=[0.1, 0.1, -0.5], distance=0.1)
        for _ in range(40):
            operator.step(LAB.step)
    place = operator.setpoints[3:6]
    assert operator.time > stands
    for _ in range(40):
        operator.step(LAB.step)
    np.testing.assert_allclose(operator.setpoints[3:6], place, atol=1e-9)
    assert operator.rests_at == np.inf
    operator.reset()
    assert operator.tripped == ()
    operator.command("stop")
    operator.step(LAB.step)
    assert operator.time < operator.rests_at < np.inf
    while operator.time < operator.rests_at:
        operator.step(LAB.step)
    np.testing.assert_allclose(operator.load[1:4], 0.0, atol=1e-8)


def stepped(operator: Operator, step: float, count: int) -> tuple[np.ndarray, np.ndarray]:
    """Times from now on [s], shape (count,), and positions of the load [m], (count, 3)."""
    begin, times, loads = operator.time, [], []
    for _ in range(count):
        operator.step(step)
        times.append(operator.time - begin)
        loads.append(operator.load[0])
    return np.array(times), np.array(loads)


@pytest.mark.parametrize("name", SITES)
def test_a_drive_trips_during_an_emergency_stop(name: str) -> None:
    site, share = SITES[name], 0.4
    operator = moving(site, brakes=brakes_of(site, share))
    operator.command("emergency")
    operator.step(site.step)
    middle = operator.setpoints[3:13].copy()
    operator.trip("trolley")
    times, loads = stepped(operator, site.step, 100)
    expected = swung(stopping(site, ("trolley",), share), middle, times)
    np.testing.assert_allclose(loads, expected, atol=1e-6 * -site.start[2])


def test_a_drive_trips_while_a_swing_is_calmed() -> None:
    operator = moving(LAB, brakes=brakes_of(LAB, 0.6))
    operator.command("emergency")
    while operator.time < 3.0:
        operator.step(LAB.step)
    operator.command("stop")
    for _ in range(10):
        operator.step(LAB.step)
    assert operator.rests_at < np.inf
    start = operator.setpoints[3:13].copy()
    operator.trip("bridge")
    times, loads = stepped(operator, LAB.step, 60)
    expected = swung(stopping(LAB, ("bridge",), 0.6), start, times)
    np.testing.assert_allclose(loads, expected, atol=1e-6)


def test_a_crane_at_rest_stays_there() -> None:
    operator = LAB.operator()
    operator.trip("hoist")
    operator.command("velocity", velocity=[0.1, 0.1, 0.1])
    for _ in range(20):
        operator.step(LAB.step)
    np.testing.assert_allclose(operator.load[0], LAB.start, atol=1e-12)


def test_what_cannot_trip_is_told() -> None:
    with pytest.raises(InputError, match="a drive is one of bridge, trolley, hoist, got 'winch'"):
        LAB.operator().trip("winch")
    with pytest.raises(InputError, match="brakes must be decelerations > 0"):
        LAB.operator(brakes=[0.5, -0.1, 0.5])
    unbounded = ActuatorBounds(acceleration=[0.9, np.inf, 0.7])
    operator = Operator(LAB.crane, LAB.limits, LAB.start, bounds=unbounded)
    with pytest.raises(InputError, match=r"a drive that trips needs .* trolley has no bound"):
        operator.trip("hoist")
    # the brake of the one that has no bound is known
    braked = Operator(LAB.crane, LAB.limits, LAB.start, bounds=unbounded, brakes=0.5)
    braked.trip("trolley")
    braked.step(LAB.step)
    assert braked.tripped == ("trolley",)


def test_brakes_are_those_of_the_crane_file() -> None:
    drives = {"acceleration_max": 0.9, "velocity_max": 0.6}
    operator = load_mission({
        "name": "across",
        "crane": {
            "bridge_mass": 2.2, "trolley_mass": 1.155, "payload_mass": 1.0, "rope_min": 0.2,
            "rope_max": 0.9, "bridge": {**drives, "brake_deceleration": 0.3}, "trolley": drives,
            "hoist": drives,
        },
        "limits": LAB.limits,
        "waypoints": [Waypoint([0.0, 0.0, -0.5]), Waypoint([0.5, 0.3, -0.4])],
    }).operator()
    operator.command("velocity", velocity=[0.2, 0.2, 0.0])
    for _ in range(200):
        operator.step(0.01)
    usual = operator.emergency.duration
    operator.trip("trolley")
    assert operator.emergency.duration == usual
    operator.trip("bridge")
    # behind three forces and five places
    velocity = operator.setpoints[8]
    assert operator.emergency.duration == pytest.approx(velocity / 0.3)
