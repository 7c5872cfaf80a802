"""Outputs that follow from the state, against the load's position."""

from __future__ import annotations

import numpy as np
import pytest

from segfmu.kernels.crane._crane import crane_load
from segfmu.kernels.crane.records import State
from segfmu.kernels.rig.outputs import total_sway


@pytest.mark.parametrize(
    "angles", [(0.0, 0.0), (0.1, 0.0), (0.0, -0.3), (0.4, 0.2), (-1.2, 1.1), (1e-9, -1e-9)]
)
def test_total_sway_is_the_angle_of_the_rope(angles: tuple[float, float]) -> None:
    state, load = np.zeros(State.SIZE), np.zeros((2, 3))
    state[State.POSITION + 2] = 2.5
    state[State.ANGLE : State.ANGLE + 2] = angles
    crane_load(state, load)
    aside = np.hypot(load[0, 0], load[0, 1])
    assert total_sway(*angles) == pytest.approx(np.arctan2(aside, -load[0, 2]), abs=1e-15)
