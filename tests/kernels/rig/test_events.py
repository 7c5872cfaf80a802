"""Changes of the payload, in whatever order they are given."""

from __future__ import annotations

from itertools import permutations

import numpy as np
import pytest

from segfmu.kernels.crane.records import Plant
from segfmu.kernels.rig.events import change_payload, next_change
from segfmu.kernels.rig.records import Clock, Loop, Memory, PayloadChange, Settings

CHANGES = ((0.1, 1.5), (0.3, 2.0), (0.7, 1.2))


@pytest.mark.parametrize("order", list(permutations(range(3))))
@pytest.mark.parametrize("start", [0.0, 100.0])
def test_the_last_change_that_is_due_counts(order: tuple[int, ...], start: float) -> None:
    settings = np.zeros((Settings.SIZE, Settings.COLUMNS))
    settings[Settings.LOOP, Loop.PERIOD] = 0.01
    memory = np.zeros((Memory.SIZE, Memory.COLUMNS))
    memory[Memory.PLANT, Plant.PAYLOAD_MASS] = 1.0
    memory[Memory.CLOCK, Clock.START] = start
    changes = np.zeros((3, PayloadChange.SIZE))
    for row, i in enumerate(order):
        changes[row, PayloadChange.TIME] = start + CHANGES[i][0]
        changes[row, PayloadChange.MASS] = CHANGES[i][1]
    found, time = [], 0.0
    for _ in CHANGES:
        time = next_change(changes, time, memory)
        change_payload(settings, changes, start + time, memory)
        found.append((time, memory[Memory.PLANT, Plant.PAYLOAD_MASS]))
    assert np.array(found) == pytest.approx(np.array(CHANGES), abs=1e-12)
    assert next_change(changes, time, memory) == 1e300
