"""Estimates that no crane has: what tells so, and that what cranes have is let be."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import segfmu
from segfmu.errors import InputError
from segfmu.validation.files.crane_file import CraneFile
from segfmu.validation.identification.log import Log
from segfmu.validation.identification.possible import impossible
from segfmu.validation.identification.quantities import Sizes, greatest, quantity
from tests.validation.identification.swapped import swapped

MASSES: dict[str, Any] = {"bridge_mass": 2.2, "trolley_mass": 1.1, "payload_mass": 1.0}
# of a rope that is measured from 0.4 to 0.6 m, and angles from -0.1 to 0.1 rad
SIZES = Sizes((4.3, 2.1, 1.0), 0.5, 0.4, 9.81)
MOST = greatest("friction.sway.viscous", SIZES)


def reasons(key: str, value: float, **more: Any) -> list[str]:
    """What is said of an estimate in the units of the crane's FMU."""
    file = CraneFile(**MASSES, drive="force", **more)
    measured = np.full((41, 5), np.nan)
    measured[:, 2] = np.linspace(0.4, 0.6, 41)
    measured[:, 3] = np.linspace(-0.1, 0.1, 41)
    log = Log("log", np.arange(41.0), np.zeros((41, 3)), measured)
    known = {name: file.model_dump().get(name, 0.0) for name in MASSES}
    unknown = quantity(key, file, lambda name: known.get(name.removeprefix("crane."), 0.0), SIZES)
    return [str(one) for one in impossible(file, [(unknown, value)], [log], SIZES)]


@pytest.mark.parametrize(("key", "value", "more", "told"), [
    ("sensors.rope.zero", -14.0, {}, "zero -14 m: the rope would be 14.5 m long on average, where"),
    ("sensors.rope.zero", -0.8, {"rope_max": 1.2}, "1.3 m long on average, more than rope_max 1.2"),
    ("sensors.rope.zero", 0.15, {"rope_min": 0.4}, "0.35 m long on average, less than rope_min 0."),
    ("sensors.rope.zero", 0.199, {}, "the log asks for more than the greatest there is, 0.2 m"),
    ("friction.sway.viscous", MOST, {}, "the log asks for more than the greatest there is, "),
    ("sensors.sway_x.zero", -0.3, {}, "zero -17.19 deg: the load would hang 11.46 deg or more bes"),
    ("sensors.sway_x.zero", 0.3, {}, "all the time; measured are -5.73 to 5.73 deg"),
    ("payload_mass", 23.0, {}, "payload_mass 23 kg: the crane file has 1 kg, more than 10 times"),
    ("bridge_mass", 2.2e-3, {}, "bridge_mass 0.0022 kg: the crane file has 2.2 kg, more than 10 t"),
])
def test_what_no_crane_has_is_told(
    key: str, value: float, more: dict[str, Any], told: str
) -> None:
    (reason,) = reasons(key, value, **more)
    assert told in reason


@pytest.mark.parametrize(("key", "value", "more"), [
    ("sensors.rope.zero", -0.6, {}), ("sensors.rope.zero", -3.0, {"rope_max": 4.0}),
    ("sensors.rope.zero", 0.1, {"rope_min": 0.2, "rope_max": 0.6}),
    ("friction.sway.viscous", 0.3 * MOST, {}), ("sensors.sway_x.zero", 0.15, {}),
    ("payload_mass", 5.0, {}), ("bridge.dead_time", 0.3, {}),
])
def test_what_a_crane_may_have_is_let_be(key: str, value: float, more: dict[str, Any]) -> None:
    assert not reasons(key, value, **more)


def test_a_crane_that_there_is_not_has_no_file(tmp_path: Any) -> None:
    columns, crane = swapped()
    found = segfmu.identify(columns, crane, fit=["sensors.rope.zero", "sensors.sway_y.zero"])
    with pytest.raises(InputError, match=r"^no crane has sensors\.rope\.zero -.*; there is no cra"):
        found.write(tmp_path / "crane.toml")
    assert not list(tmp_path.iterdir()) and found.poor
