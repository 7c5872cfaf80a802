"""Objects and times of other kinds are refused where they are given, not where they are used."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from segfmu import Crane, FlatInverse, InputError, Limits, Waypoint, plan
from segfmu.crane import (
    Compensation,
    Feedforward,
    Friction,
    Gust,
    PayloadChange,
    Plant,
    Rig,
    Setpoints,
    Shaped,
    Shaper,
    Trapezoid,
    TravelLimits,
    Weights,
    Wind,
    zv,
)

CRANE = Crane(2.2, 1.155, 1.0)


@pytest.mark.parametrize("name", ["bridge", "hoist", "friction", "travel", "sensors", "wind"])
@pytest.mark.parametrize("value", [None, 0, "x", {"lag": 0.1}, PayloadChange(1.0, 1.0)])
def test_parts_of_a_rig_are_objects_of_their_class(name: str, value: Any) -> None:
    with pytest.raises(InputError, match=f"{name} must be of class [A-Z][A-Za-z]*, got "):
        Rig(**{name: value})


@pytest.mark.parametrize(("value", "words"), [
    (None, "payload must be a sequence, got None"),
    (1.0, "payload must be a sequence, got 1.0"),
    ((1.0,), "a change of the payload must be of class PayloadChange, got float"),
])
def test_changes_of_the_payload_are_objects(value: Any, words: str) -> None:
    with pytest.raises(InputError, match=words):
        Rig(payload=value)


@pytest.mark.parametrize(("changes", "words"), [
    ({"rig": {}}, "rig must be of class Rig, got dict"),
    ({"setpoints": [0.0] * 3}, "setpoints must be of class Setpoints, got list"),
    ({"controller": None}, "controller sample_time must be a finite number > 0, got None"),
])
def test_what_a_plant_is_made_of(changes: dict[str, Any], words: str) -> None:
    class Idle:
        sample_time = 0.01

    given = {"setpoints": Setpoints(np.zeros(3), np.zeros(3), np.zeros(10)), "controller": Idle()}
    with pytest.raises(InputError, match=words):
        Plant(CRANE, CRANE.hanging([0.0, 0.0, -0.5]), **(given | changes))


def test_whole_numbers_are_numbers() -> None:
    given = Friction(viscous=[3, 2, 1], coulomb=[1, 2, 3], static=[2, 2, 4])
    assert Rig(friction=given).parameters(CRANE, driven=False).size


@pytest.mark.parametrize("made", [
    lambda value: Weights(position=value), lambda value: Wind(gust=value),
    lambda value: Wind(turbulence=value), lambda value: TravelLimits(slack=value),
    lambda value: Gust(1.0, 1.0, shape=value), lambda value: Shaper(value, [1.0]),
    lambda value: Shaper([0.0], value), lambda value: Setpoints(force=value).vector,
])
@pytest.mark.parametrize("value", ["1", True, {}, np.array([]), 1j, np.array([0.5, 0.5])])
def test_equipment_of_other_kinds_is_refused(made: Callable[[Any], Any], value: Any) -> None:
    with pytest.raises(InputError):
        made(value)


def test_setpoints_of_other_sizes_do_not_reach_the_kernels() -> None:
    with pytest.raises(InputError, match=r"have 3, 3, 10 and 3 values, got .* \(2,\), \(3,\)"):
        _ = Setpoints(force=np.zeros(2)).vector
    assert Setpoints(force=[1, 2, 3]).vector[:3].tolist() == [1.0, 2.0, 3.0]


@pytest.mark.parametrize(("times", "shares", "words"), [
    ([0.1, 1.0], [0.5, 0.5], "ascend from 0"), ([0.0, 1.0, 0.5], [0.5, 0.25, 0.25], "ascend"),
    ([0.0, 1.0], [1.0], "as many as its times"), ([0.0, 1.0], [0.5, 0.6], "their sum is 1"),
])
def test_impulses_of_a_shaper(times: list[float], shares: list[float], words: str) -> None:
    with pytest.raises(InputError, match=words):
        Shaper(times, shares)  # type: ignore[arg-type]


@pytest.mark.parametrize("time", [True, "1", b"1", None, 1j, {}, np.datetime64("2026-01-01")])
def test_times_are_numbers(time: Any) -> None:
    points = [Waypoint([0.0, 0.0, -0.5]), Waypoint([1.0, 0.8, -0.5])]
    inverse = FlatInverse(CRANE, plan(points, Limits(1.0, 0.5, 0.5, 5.0)))
    ahead, ramp = Feedforward(inverse, Compensation()), Trapezoid(1.0, 0.5, 0.5)
    for called in (inverse.force, inverse.velocity, inverse.state, ahead.force, ahead.state,
                   ahead.load, ramp, Shaped(ramp, zv(3.0))):
        with pytest.raises(InputError, match="t must be a number or a list of numbers, got"):
            called(time)
