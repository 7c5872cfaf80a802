"""Data classes from variables and back: no field is forgotten, every value returns."""

from __future__ import annotations

from dataclasses import fields
from typing import Any

import pytest

from segfmu.crane import (
    Crane,
    Drive,
    Friction,
    Gust,
    PayloadChange,
    Rig,
    Sensors,
    TravelLimits,
    Wind,
)
from segfmu.crane.disturbance import GUST, PAYLOAD, WIND
from segfmu.crane.equipment import DRIVE, FRICTION, TRAVEL
from segfmu.crane.hook import HookCrane
from segfmu.crane.observer import UNCERTAINTY, Uncertainty
from segfmu.crane.parameters import CRANE
from segfmu.crane.sensors import SENSORS
from segfmu.crane.variables import build, kept, values
from segfmu.errors import InputError
from segfmu.kernels.crane.records import Plant

CASES = [
    (CRANE, Crane(2.0, 1.0, 0.5, 9.8, None, 1.5)),
    (FRICTION, Friction((1.0, 2.0, 3.0), (4.0, 5.0, 6.0), 0.02, 0.1)),
    (TRAVEL, TravelLimits((-1.0, 2.0), None, (0.1, 0.9))),
    (SENSORS, Sensors(0.01, 0.02, (1e-3,) * 5, (1e-4,) * 5, (0.1, 0.2, 0.3, 0.4, 0.5), 7)),
    (GUST, Gust(1.0, 2.0, (0.1, 0.2, 0.3), "sine")),
    (PAYLOAD, PayloadChange(1.0, 2.0)),
    (UNCERTAINTY, Uncertainty(1e-3, 2e-3, 3e-3, 0.4, 0.5, 6.0, 0.07)),
    *((mapping, Drive(0.1, None, 2.0)) for mapping in DRIVE),
]


@pytest.mark.parametrize(("mapping", "own"), CASES, ids=lambda c: type(c).__name__)
def test_every_field_returns(mapping, own) -> None:
    assert set(mapping) == {f.name for f in fields(own) if f.init}
    assert build(type(own), mapping, values(own, mapping).__getitem__) == own


@pytest.mark.parametrize("gust", [None, Gust(1.0, 2.0, (0.1, 0.2, 0.3))])
def test_wind_with_and_without_a_gust(gust: Gust | None) -> None:
    assert {*WIND, "gust", "turbulence"} == {f.name for f in fields(Wind) if f.init}
    own = Wind((0.1, 0.2, 0.3), gust, (0.4, 0.5, 0.6), 2.0, 9)
    assert Wind.of(own.values().__getitem__) == own


def test_variables_of_drives_are_their_own() -> None:
    names = [v for mapping in DRIVE for f in mapping.values() for v in f.variables]
    assert len(set(names)) == len(names) == 3 * len(fields(Drive))


def test_all_that_is_fed_into_the_plant_comes_from_a_class() -> None:
    own = Rig(hoist=Drive(0.3), wind=Wind((0.1, 0.0, 0.0)))
    # a variable without a field would be missing here
    found = own.parameters(Crane(2.0, 1.0, 0.5), driven=True)
    assert found[Plant.LAG : Plant.LAG + 3].tolist() == [0.0, 0.0, 0.3]
    assert found[Plant.WIND : Plant.GUST_START].tolist() == [0.1, 0.0, 0.0]


def test_equal_numbers_give_the_same_part_and_others_another_one() -> None:
    known = values(Friction(viscous=(1.0, 2.0, 3.0)), FRICTION)
    first, again = (kept(Friction, FRICTION, known.__getitem__) for _ in range(2))
    other = kept(Friction, FRICTION, (known | {next(iter(known)): 1.5}).__getitem__)
    assert first is again
    assert first == build(Friction, FRICTION, known.__getitem__)
    assert other != first


def test_wrong_numbers_are_refused_each_time() -> None:
    known = dict.fromkeys(values(Friction(), FRICTION), -1.0)
    for _ in range(2):
        with pytest.raises(InputError, match="friction"):
            kept(Friction, FRICTION, known.__getitem__)


@pytest.mark.parametrize("kind", [Crane, Rig, Wind, HookCrane])
@pytest.mark.parametrize("value", [None, 3, "mass", {"mass": 1.0}])
def test_what_gives_no_values_by_names_is_refused(kind: Any, value: Any) -> None:
    with pytest.raises(InputError, match=r"^value must be a function of a variable's name, got "):
        kind.of(value)
