"""States of a crane with a hook, and how the plant's kernels keep them."""

from __future__ import annotations

import numpy as np

from segfmu.kernels.crane.records import Coordinates, PlantState, State
from segfmu.kernels.hook.records import HookState
from segfmu.planning.arrays import FloatArray

# places of a `HookState` in a `PlantState`
PLACES = np.concatenate([
    np.arange(Coordinates.SIZE),
    PlantState.SLING_ANGLE + np.arange(2),
    State.VELOCITY + np.arange(Coordinates.SIZE),
    PlantState.SLING_RATE + np.arange(2),
])


def plant_state(state: FloatArray) -> FloatArray:
    """The kernels' `PlantState` of a state of a crane (10,), or with a hook (14,)."""
    own = np.zeros(PlantState.SIZE)
    if state.size == HookState.SIZE:
        own[PLACES] = state
    else:
        own[: State.SIZE] = state
    return own


def hook_state(state: FloatArray) -> FloatArray:
    """The `HookState` (14,) of the kernels' `PlantState`."""
    found: FloatArray = state[PLACES]
    return found
