"""Arguments of plans that are none, copies of frozen objects, and numbers in messages."""

from __future__ import annotations

import copy
import dataclasses
import pickle
from dataclasses import replace

import numpy as np
import pytest

from segfmu import (
    ActuatorBounds,
    Clearance,
    InfeasibleError,
    InputError,
    Limits,
    Obstacle,
    Waypoint,
    plan,
    reach_velocity,
)

ONE = Limits(1, 1, 1, 1)
MOVE = [Waypoint([0.0]), Waypoint([1.0])]
MASKED = np.ma.array([1.0, 2.0], mask=[False, True])


@pytest.mark.parametrize("given", [
    lambda: Waypoint(MASKED), lambda: Waypoint([0, 0], velocity=MASKED),
    lambda: Limits(MASKED, 1, 1), lambda: plan(MOVE, ONE)(MASKED),
    lambda: Clearance([], np.ma.array([0.0, 0.0, 0.0], mask=True)),
])
def test_masked_arrays_are_refused(given) -> None:
    with pytest.raises(InputError, match="must not be a masked array; leave out or fill"):
        given()


@pytest.mark.parametrize(("given", "words"), [
    (lambda: Limits(None, 1), r"limits.velocity must be finite, got None$"),
    (lambda: Limits([None, 1], 1), r"limits.velocity must be finite, got \[None, 1\]$"),
    (lambda: Limits(1, 1, [-1, None]), r"limits.jerk must be greater than 0, got \[-1, None\]$"),
    (lambda: Limits(1, 1, np.array([-1.0, 2.0])), r"greater than 0, got \[-1.0, 2.0\]$"),
    (lambda: Waypoint([1, 2], velocity=[None, "a"]), r"velocity must be .*, got \[None, 'a'\]$"),
    (lambda: Waypoint([1, 2], [None, np.inf]), r"velocity must be .*, got \[None, inf\]$"),
])
def test_messages_show_what_was_given(given, words: str) -> None:
    with pytest.raises(InputError, match=words):
        given()


@pytest.mark.parametrize(("given", "words"), [
    (lambda: Clearance([], [np.inf] * 3), "minimum must be finite, or None or -inf for no bound"),
    (lambda: Clearance([], None, [-np.inf] * 3), "maximum must be finite, or None or inf for no"),
    (lambda: Clearance([], 0), "workspace: minimum must have 3 values, got 1"),
    (lambda: Clearance([], "abc"), "workspace: minimum must be a number or a list of numbers"),
    (lambda: Clearance([], ["a", 1, 2]), "workspace: minimum must be a number or a list of"),
    (lambda: Clearance([], [[1, 2], [1], 3]), "workspace: minimum must be a number or a list of"),
    (lambda: Clearance(Obstacle("a", [0, 0, 0], [1, 1, 1])), "obstacles must be a sequence"),
    (lambda: Clearance({"stack": None}), "obstacles must be a sequence, got {'stack': None}"),
    (lambda: Clearance(None), "obstacles must be a sequence, got None"),
])
def test_clearances_that_are_none(given, words: str) -> None:
    with pytest.raises(InputError, match=words):
        given()


def test_a_workspace_may_be_open() -> None:
    found = Clearance([], [None, -np.inf, 0.0], None)
    assert found.minimum.tolist() == [-np.inf, -np.inf, 0.0]
    assert not found.minimum.flags.writeable and not found.maximum.flags.writeable


def test_positions_are_bounded_for_one_axis_alone() -> None:
    points, limits = [Waypoint([0, 0]), Waypoint([1, 1])], Limits(1, 1, 1, 1)
    for low in (None, -np.inf, [None, None], [None, -1.0], [-np.inf, 0.0], [0.0, None]):
        plan(points, limits, position_min=low)
    for high in (np.inf, [None, 2.0], [1.0, np.inf]):
        plan(points, limits, position_max=high)
    with pytest.raises(InfeasibleError, match=r"axis y, .*position_max is 0.5 m"):
        plan(points, limits, position_max=[None, 0.5])
    with pytest.raises(InfeasibleError, match=r"axis y, .*position_min is 0.5 m"):
        plan(points, limits, position_min=[None, 0.5])
    for name, wrong in (("position_min", np.inf), ("position_max", [None, -np.inf])):
        with pytest.raises(InputError, match=rf"{name} must be finite, or None"):
            plan(points, limits, **{name: wrong})


@pytest.mark.parametrize("dwells", [(2.0, 0.0), (0.5, 1.5)])
def test_the_same_waypoint_twice_adds_the_dwells(dwells: tuple[float, float]) -> None:
    assert plan([Waypoint([0.0], dwell=d) for d in dwells], ONE).duration == 2.0
    assert plan([Waypoint([0.0]), Waypoint([0.0])], ONE).duration == 0.0


def test_numbers_that_differ_read_differently() -> None:
    above = 1.0000001
    for name, unit in (("velocity", "m/s"), ("acceleration", "m/s2")):
        points = [MOVE[0], Waypoint([1.0], **{name: [above]}), Waypoint([2.0])]
        with pytest.raises(InfeasibleError) as info:
            plan(points, ONE)
        assert f"{name} 1.0000001 {unit} exceeds the limit 1 {unit};" in str(info.value)
    with pytest.raises(InfeasibleError, match=r"velocity 1.0000001 m/s exceeds the limit 1 m/s;"):
        reach_velocity(MOVE[0], [above], limits=ONE)
    with pytest.raises(InfeasibleError) as info:
        plan(MOVE, ONE, position_max=1.0 - 1e-11)
    assert "position reaches 1 m" in str(info.value)
    assert "position_max is 0.99999999999 m" in str(info.value)
    shortest = plan(MOVE, ONE).duration
    with pytest.raises(InfeasibleError) as info:
        plan(MOVE, ONE, duration=shortest * (1.0 - 1e-10))
    wanted, found = str(info.value).removeprefix("duration ").split(" s is shorter than the ")
    assert float(wanted) < float(found.split(", ")[1].split(" s;")[0])


def test_a_workspace_just_left_reads_so() -> None:
    trajectory = plan([Waypoint([0, 0, -1]), Waypoint([1, 0, -1])], Limits(1, 1, 1, 1))
    with pytest.raises(InfeasibleError) as info:
        Clearance([], None, [1.0 - 1e-8, None, None]).require(trajectory)
    assert "range -inf to 0.99999999 m" in str(info.value)
    assert "from 0 to 1 m" in str(info.value)


FROZEN = [
    Limits(np.array([1.0, 2.0]), 1, [1, np.inf]), Waypoint([0.0, 1.0], [1.0, 0.0]),
    Obstacle("a", [0, 0, 0], [1, 1, 1]), Clearance([], [0, 0, None]), ActuatorBounds([1, 2, 3], 1),
]


@pytest.mark.parametrize("copied", [
    copy.copy, copy.deepcopy, lambda one: pickle.loads(pickle.dumps(one)),
])
@pytest.mark.parametrize("given", FROZEN, ids=lambda one: type(one).__name__)
def test_copies_are_frozen_as_well(given, copied) -> None:
    other = copied(given)
    for name, value in vars(given).items():
        if isinstance(value, np.ndarray):
            assert np.array_equal(getattr(other, name), value, equal_nan=True)
            with pytest.raises(ValueError, match=r"read-only"):
                getattr(other, name)[...] = 0.5


VALUES = {
    "Waypoint": lambda x: Waypoint([0.0, x], velocity="free", dwell=1.0),
    "Limits": lambda x: Limits([1.0, x], 1.0, None, 3.0),
    "Obstacle": lambda x: Obstacle("a", [0, 0, -x], [1, 1, -1]),
    "Clearance": lambda x: Clearance([Obstacle("a", [0, 0, -2], [1, 1, -1])], [x, 0, 0]),
    "ActuatorBounds": lambda x: ActuatorBounds(force=[1.0, x, None]),
}


@pytest.mark.parametrize("make", VALUES.values(), ids=VALUES)
def test_objects_of_the_same_values_are_equal(make) -> None:
    one, same, other = make(2.0), make(2.0), make(3.0)
    assert one == same == copy.copy(one) == pickle.loads(pickle.dumps(one))
    assert len({one, same, other}) == 2
    assert one != other
    assert one != "another type"


def test_minus_zero_is_zero_and_another_number_of_axes_is_another_value() -> None:
    assert len({Waypoint([-0.0]), Waypoint([0.0])}) == 1
    assert Limits(1.0, 1.0) != Limits([1.0], [1.0])
    assert Waypoint([0.0]) != Limits(1.0, 1.0)


def test_copied_limits_hold() -> None:
    limits = Limits(np.array([1.0]), 1, 1, 1)
    first = plan(MOVE, limits)
    for other in (copy.deepcopy(limits), pickle.loads(pickle.dumps(limits))):
        assert plan(MOVE, other).duration == first.duration


def test_limits_are_what_their_repr_says() -> None:
    for limits in (Limits(1, 1, [1, np.inf]), Limits([1, 2], 0.5, None, [3, None])):
        again = eval(repr(limits), {"Limits": Limits})
        assert repr(again) == repr(limits)
        assert np.array_equal(again.table(2, 4), limits.table(2, 4))


def test_limits_absent_on_one_axis_can_be_given_again() -> None:
    limits = Limits([1, 2], 0.5, None, [3, None])
    assert limits.snap.tolist() == [3.0, np.inf] and limits.jerk == np.inf
    faster = dataclasses.replace(limits, velocity=3.0)
    assert np.array_equal(faster.table(2, 3)[:, 1:], limits.table(2, 3)[:, 1:])
    assert np.array_equal(faster.table(2, 3)[:, 0], [3.0, 3.0])


def test_what_is_free_at_the_ends_and_in_dwells_is_zero() -> None:
    points = [
        Waypoint([0.0], "free", "free"), Waypoint([1.0], "free"),
        Waypoint([2.0], "free", dwell=0.5), Waypoint([3.0], "free"),
    ]
    found = [p.velocity[0] for p in plan(points, ONE).waypoints]
    assert found[0] == found[2] == found[3] == 0.0 and found[1] > 0.1


def test_limits_with_one_of_them_changed() -> None:
    found = replace(Limits(1.0, 1.0, 4.0), velocity=2.0)
    assert repr(found) == "Limits(velocity=2.0, acceleration=1.0, jerk=4.0)"
    assert plan([Waypoint(0.0), Waypoint(1.0)], found).duration > 0.0


@pytest.mark.parametrize(
    ("name", "smoothness"), [("jerk", 2), ("snap", 3), ("crackle", 4), ("pop", 5)]
)
def test_a_derivative_that_may_jump_is_not_given(name: str, smoothness: int) -> None:
    start = Waypoint([0.0], **{name: [0.1]})
    limits = Limits(*[1.0] * (smoothness + 1))
    with pytest.raises(InputError, match=f"waypoint 1: {name} is .*with smoothness {smoothness}"):
        plan([start, MOVE[1]], limits, smoothness=smoothness)


def test_a_start_on_another_plan_stays_as_it_is_to_the_last_bit() -> None:
    states = [[1e-18], [1e-18], [0.1]]
    found = plan([Waypoint([0.0], *states), MOVE[1]], ONE)
    start = found.waypoints[0]
    assert [start.velocity, start.acceleration, start.jerk] == states
    rounded = plan([Waypoint([0.0], *states[:2]), MOVE[1]], ONE).waypoints[0]
    assert [rounded.velocity, rounded.acceleration] == [[0.0], [0.0]]
