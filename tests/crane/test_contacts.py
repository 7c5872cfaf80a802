"""Friction along a plan: its history against a plain recursion, its derivatives, what it does."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from benchmarks.drive_oracle import friction_along

import segfmu
from segfmu.crane import Drive, Friction, Plant, Rig, Setpoints
from segfmu.crane.contacts import Contacts
from segfmu.crane.feedback import design
from segfmu.crane.inverse import FORCE, POSITION, VELOCITY
from segfmu.kernels import backend
from segfmu.kernels.crane.records import Contact, FrictionSeries
from tests.campaign import soaked

LAB, STS = segfmu.Crane(2.2, 1.155, 1.0), segfmu.Crane(300e3, 15e3, 40e3)
WEIGHTS = 9.81 * np.array([355e3, 55e3, 40e3])
CASES = {
    "lab": (LAB, Friction(coulomb=(4.0, 4.0, 4.0))),
    "lab, all": (LAB, Friction((20.0, 10.0, 8.0), (4.0, 3.0, 1.0), drag=(2.0, 2.0, 1.0),
                               static=(5.0, 4.0, 0.0), width=2e-3)),
    "40 t": (STS, Friction(coulomb=tuple(0.01 * WEIGHTS), viscous=(1e4, 2e3, 1e3))),
    "40 t, static": (STS, Friction(coulomb=tuple(0.005 * WEIGHTS),
                                   static=(*(0.006 * WEIGHTS[:2]), 0.0))),
}
BY_CASE = pytest.mark.parametrize("case", CASES)


@cache
def trajectory(case: str) -> segfmu.Trajectory:
    """There and back, with a rest on the way and hoisting."""
    if CASES[case][0] is LAB:
        limits = segfmu.Limits(0.5, 0.5, 2.0, 20.0)
        places = [[0.0, 0.0, -0.5], [0.6, 0.3, -0.4], [0.2, 0.5, -0.6]]
        rest = 0.5
    else:
        limits = segfmu.Limits([0.5, 2.0, 0.5], [0.1, 0.4, 0.2], [0.1, 0.3, 0.2], [0.1, 0.3, 0.2])
        places = [[0.0, 0.0, -30.0], [3.0, 20.0, -20.0], [1.0, 30.0, -25.0]]
        rest = 2.0
    points = [segfmu.Waypoint(p, dwell=rest if i == 1 else 0.0) for i, p in enumerate(places)]
    return segfmu.plan(points, limits)


@cache
def inverse(case: str) -> segfmu.FlatInverse:
    crane, friction = CASES[case]
    return segfmu.FlatInverse(crane, trajectory(case), friction)


@pytest.mark.parametrize("case", ["lab, all", "40 t, static", *soaked("lab", "40 t")])
def test_forces_are_those_of_the_ideal_crane_and_friction(case: str) -> None:
    """The contacts are followed in small steps; only rests and stops are other."""
    crane, friction = CASES[case]
    plan = trajectory(case)
    ideal = segfmu.FlatInverse(crane, plan)
    times = np.linspace(0.0, plan.duration, 40_001)
    values = ideal.evaluate(times)
    added = inverse(case).force(times) - values[:, FORCE]
    expected = friction_along(crane, friction, values[:, POSITION], values[:, VELOCITY])
    for axis in range(3):
        rows = inverse(case).contacts.rows[axis]
        used = np.ones(times.size, dtype=bool)
        for row in rows[rows[:, Contact.RELEASED] > 0.0]:
            begun = row[Contact.BEGUN]
            # a rest, its stop, and what the recursion does not know of it
            used &= (times < begun) | (times > row[Contact.SLIDES])
        first = np.flatnonzero(~used)
        if first.size:
            used[first[0]:] = False
        scale = max(friction.coulomb[axis], friction.static[axis])
        assert used.sum() > 5000
        assert added[used, axis] == pytest.approx(expected[used, axis], abs=2e-3 * scale)


@BY_CASE
def test_a_crane_at_rest_is_not_pushed(case: str) -> None:
    crane, _ = CASES[case]
    plan = trajectory(case)
    weight = [0.0, 0.0, -crane.payload_mass * crane.gravity]
    arrived = plan.waypoint_times[1]
    for time in (-1.0, 0.0, arrived + 0.99 * plan.waypoints[1].dwell, plan.duration + 5.0):
        assert inverse(case).force(time) == pytest.approx(weight, rel=1e-9, abs=1e-9)


def test_before_a_plan_that_begins_in_motion_nothing_rubs() -> None:
    crane = segfmu.Crane(bridge_mass=2.2, trolley_mass=1.155, payload_mass=1.0)
    points = [segfmu.Waypoint([0.0, 0.0, -1.0], [0.3, 0.2, 0.0]), segfmu.Waypoint([1.0, 0.8, -1.0])]
    moving = segfmu.plan(points, segfmu.Limits(1.0, 1.0, 4.0, 30.0))
    found = segfmu.FlatInverse(crane, moving, segfmu.crane.Friction(coulomb=(4.0, 3.0, 0.0)))
    assert found.force(0.0)[:2] == pytest.approx([4.0, 3.0], rel=1e-6)
    assert found.force(-1.0) == pytest.approx([0.0, 0.0, -9.81], abs=1e-9)


@BY_CASE
def test_derivatives_of_friction_are_those_of_its_values(case: str) -> None:
    crane, friction = CASES[case]
    plan, contacts = trajectory(case), Contacts(crane, friction, trajectory(case))
    ideal = segfmu.FlatInverse(crane, plan)
    random = np.random.default_rng(3)
    nodes = np.unique(np.concatenate([contacts.times, plan.events]))
    near = [n + random.uniform(0.0, 0.03, 12) for n in contacts.times]
    times = np.concatenate([*near, random.uniform(0.0, plan.duration, 50)])
    reach = 2e-5
    work = np.zeros((FrictionSeries.SIZE, 4))
    compared = 0
    for time in times:
        if np.abs(nodes - time).min() < 3.0 * reach:
            continue
        at = time + reach * np.arange(-2, 3)
        values = ideal.evaluate(at)
        for axis in range(3):
            found = [
                contacts.friction(axis, t, row[POSITION][axis], row[VELOCITY][axis])
                for t, row in zip(at, values, strict=True)
            ]
            slope = (found[0] - 8.0 * found[1] + 8.0 * found[3] - found[4]) / (12.0 * reach)
            motion = np.array([values[2][POSITION][axis], values[2][VELOCITY][axis],
                               ideal.acceleration(time)[axis]])
            got = backend.friction_derivative(
                contacts.resistance, axis, time, motion, 1, contacts.rows[axis], work
            )
            scale = max(friction.coulomb[axis], friction.static[axis]) / 0.01
            assert got == pytest.approx(slope, rel=2e-4, abs=2e-6 * scale)
            compared += 1
    assert compared > 100


def largest_error(case: str, step: float, known: Friction) -> tuple[float, float]:
    """Largest distance of the load from its plan, and at the end [m], by force drives alone."""
    crane, friction = CASES[case]
    plan = trajectory(case)
    flat = segfmu.FlatInverse(crane, plan, known)
    times = np.arange(int((plan.duration + 2.0) / step) + 1) * step
    nodes, time = [], 0.0
    while np.isfinite(time):
        nodes.append(time)
        time = min(plan.next_event(time),
                   *(flat.contacts.next_event(time, axis) for axis in range(3)))
    times = np.unique(np.round(np.concatenate([times, nodes]), 9))
    forces, states, planned = flat.force(times), flat.state(times), plan(times)
    rope = float(states[0, 2])
    gains = design(crane, sample_time=0.1, shortest=0.3 * rope, longest=2.0 * rope, rows=2)
    plant = Plant(
        crane, states[0], Setpoints(forces[0]), gains, enabled=False,
        rig=Rig(Drive(), Drive(), Drive(), friction=friction),
    )
    largest = 0.0
    for length, force, load in zip(np.diff(times), forces[1:], planned[1:], strict=True):
        plant.step(float(length), Setpoints(force))
        largest = max(largest, float(np.linalg.norm(plant.load[0] - load)))
    return largest, float(np.linalg.norm(plant.load[0] - planned[-1]))


@BY_CASE
def test_a_crane_with_known_friction_follows_its_plan(case: str) -> None:
    """Within 1 mm, on the way and at the end, without feedback; unknown friction stops it."""
    step = 1e-3 if CASES[case][0] is LAB else 5e-3
    largest, last = largest_error(case, step, CASES[case][1])
    assert largest < 1e-3
    assert last < 1e-3
    assert largest_error(case, 10.0 * step, Friction())[1] > 0.1


@pytest.mark.parametrize("last", [[0.8, 0.6, -0.6], [0.7, 0.5, -0.55]], ids=["mirrored", "other"])
def test_static_friction_acts_where_an_axis_passes_through_rest(last: list[float]) -> None:
    """Halfway to the stop it was taken for slow since there, and had Coulomb friction alone."""
    friction = Friction(coulomb=(4.0, 4.0, 4.0), static=(4.5, 4.5, 0.0))
    points = [segfmu.Waypoint(p) for p in ([0.0, 0.0, -0.6], [0.4, 0.3, -0.6], last)]
    plan = segfmu.plan(points, segfmu.Limits(0.5, 0.5, 5.0, 50.0))
    flat = segfmu.FlatInverse(LAB, plan, friction)
    for axis in range(2):
        rows = flat.contacts.rows[axis]
        (stop,) = rows[rows[:, Contact.RELEASED] > 0.0]
        before = np.linspace(stop[Contact.BEGUN], plan.duration, 500)
        assert (np.diff(np.abs(flat.velocity(before)[:, axis])) < 0.0).all()
        # where it starts, too, what changes much is over soon
        assert rows[0, Contact.SETTLED] < 0.05
    times = np.linspace(0.0, plan.duration, 40_001)
    values = segfmu.FlatInverse(LAB, plan).evaluate(times)
    added = flat.force(times) - values[:, FORCE]
    expected = friction_along(LAB, friction, values[:, POSITION], values[:, VELOCITY])
    passed = np.abs(times - plan.waypoint_times[1]) < 0.2
    assert added[passed, :2] == pytest.approx(expected[passed, :2], abs=0.01)
    assert added[passed, :2].min() > 3.9 and added[passed, :2].max() > 4.49


@BY_CASE
def test_a_step_ends_where_a_contact_begins_to_slide(case: str) -> None:
    """The slope of the friction jumps there; what a step passes over it grows with static friction.

    Steps ended in 16 equal parts of the time until static friction has fallen, which may be long.
    """
    contacts = inverse(case).contacts
    for axis in range(3):
        events, time = [], 0.0
        while np.isfinite(time := contacts.next_event(time, axis)):
            events.append(time)
        rows = contacts.rows[axis]
        for row in rows[rows[:, Contact.TIME] < 1e300]:
            first, slides = row[[Contact.TIME, Contact.SLIDES]]
            if slides > first:
                assert np.abs(np.array(events) - slides).min() < 1e-12
                assert sum(first < t <= slides + 1e-12 for t in events) >= 16


def test_only_friction_is_taken() -> None:
    with pytest.raises(segfmu.InputError, match=r"must be a segfmu.crane.Friction, got float"):
        segfmu.FlatInverse(LAB, trajectory("lab"), 4.0)
