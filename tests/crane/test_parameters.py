"""The crane's parameters and the errors for bad ones."""

from __future__ import annotations

from dataclasses import astuple

import numpy as np
import pytest

from segfmu import Crane, InputError


@pytest.mark.parametrize("name", ["bridge_mass", "trolley_mass", "payload_mass", "gravity"])
@pytest.mark.parametrize("value", [0.0, -1.0, float("nan"), float("inf"), "1", None, True])
def test_bad_mass_is_named(name: str, value: object) -> None:
    good = {"bridge_mass": 1.0, "trolley_mass": 1.0, "payload_mass": 1.0, "gravity": 9.81}
    with pytest.raises(InputError, match=name):
        Crane(**{**good, name: value})


def test_empty_rope_range_is_refused() -> None:
    with pytest.raises(InputError, match="rope_min"):
        Crane(1.0, 1.0, 1.0, rope_min=2.0, rope_max=1.0)


@pytest.mark.parametrize("kind", [np.float16, np.float32, np.longdouble, np.int8, int])
def test_numbers_of_any_type_become_floats(kind: type) -> None:
    crane = Crane(*map(kind, (2, 1, 1, 10)), rope_min=kind(1), rope_max=kind(3))
    assert repr(astuple(crane)) == "(2.0, 1.0, 1.0, 10.0, 1.0, 3.0)"


def test_a_number_too_large_for_a_float_is_refused() -> None:
    with pytest.raises(InputError, match="payload_mass must be a finite number > 0"):
        Crane(1.0, 1.0, 10**400)


def test_wrong_sizes_are_named() -> None:
    crane = Crane(1.0, 1.0, 1.0)
    with pytest.raises(InputError, match="state must have 10 values"):
        crane.rhs([0.0] * 9, [0.0] * 3)
    with pytest.raises(InputError, match="force must have 3 values"):
        crane.rhs([0.0, 0.0, 1.0, *[0.0] * 7], [0.0] * 2)


@pytest.mark.parametrize("length", [0.0, -1.0])
def test_a_rope_has_a_length(length: float) -> None:
    with pytest.raises(InputError, match=rf"rope length must be > 0 m, got {length} m$"):
        Crane(1.0, 1.0, 1.0).rhs([0.0, 0.0, length, *[0.0] * 7], [0.0, 0.0, -9.81])


def test_hanging_state_puts_the_load_where_asked() -> None:
    crane = Crane(1.0, 1.0, 1.0)
    assert crane.load(crane.hanging([1.0, -2.0, -3.0]))[0].tolist() == [1.0, -2.0, -3.0]
    with pytest.raises(InputError, match="below the trolley"):
        crane.hanging([0.0, 0.0, 0.1])


@pytest.mark.parametrize(("given", "words"), [
    ((np.eye(2),), "driven must be True or False"),
    ((None,), "driven must be True or False"),
    ((True, np.eye(2)), "lag must be one number per axis"),
    ((True, "x"), "lag must be a number or a list"),
    ((True, {}), "lag must be a number or a list"),
    ((True, 10**400), "lag must be a number or a list"),
    ((True, float("nan")), "lag must be finite"),
    ((True, float("inf")), "lag must be finite"),
    ((True, -1.0), r"lag must be one or three times >= 0 s, got \[-1.0\]"),
    ((True, [0.1, 0.2]), r"lag must be one or three times >= 0 s, got \[0.1, 0.2\]"),
])
def test_a_plant_of_wrong_values_is_refused(given: tuple, words: str) -> None:
    with pytest.raises(InputError, match=words):
        Crane(1.0, 1.0, 1.0).plant(*given)
