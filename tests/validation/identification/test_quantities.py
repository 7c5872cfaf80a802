"""Bounds of what is fitted: of cranes with any sling, and none whose simulation does not end."""

from __future__ import annotations

from math import inf, sqrt

import pytest

from segfmu.validation.files.crane_file import CraneFile
from segfmu.validation.identification.quantities import Sizes, quantity


@pytest.mark.parametrize(("load", "mean", "shortest"), [(1.0, 1.0, 0.4), (4e4, 30.0, 8.0)])
def test_a_rope_and_a_sway_are_left(load: float, mean: float, shortest: float) -> None:
    crane = CraneFile(bridge_mass=load, trolley_mass=load, payload_mass=load, drive="velocity")
    sizes = Sizes((3.0 * load, 2.0 * load, load), mean, shortest, 9.81)
    zero = quantity("sensors.rope.zero", crane, lambda _: 0.0, sizes)
    # the sensor shows true lengths and its zero; a load hangs below what is measured by any sling
    assert (zero.low, zero.high) == (-inf, pytest.approx(0.5 * shortest))
    damping = quantity("friction.sway.viscous", crane, lambda _: 0.0, sizes)
    critical = 2.0 * load * sqrt(9.81 * shortest**3)
    assert (damping.low, damping.high) == (0.0, pytest.approx(0.5 * critical))
    assert damping.low < damping.start < damping.high
