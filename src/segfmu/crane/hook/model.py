"""The crane with a hook as a flat system."""

from __future__ import annotations

import numpy as np

from segfmu.arrays import FloatArray
from segfmu.crane.flat_model import FlatModel
from segfmu.crane.hook.parameters import HookCrane
from segfmu.crane.rope import LoadTrajectory, joined_pieces, require_met, rope_bounds, rope_work
from segfmu.kernels import backend
from segfmu.kernels.crane.records import (
    Coordinates,
    FlatOrders,
    Masses,
    PlantState,
    RopeFault,
    State,
)
from segfmu.kernels.hook.records import HookInverse, HookModel, HookPath, HookState, SlingSeries


def _invert(hook: HookCrane, flat: FloatArray, found: FloatArray) -> None:
    masses = np.array(hook.masses)
    series = np.zeros((SlingSeries.SIZE, FlatOrders.CRANE))
    backend.hook_derivatives(
        flat, 0, masses[: Masses.SIZE], hook.hook_mass, hook.sling, series, found
    )


def _require_taut(hook: HookCrane, trajectory: LoadTrajectory) -> None:
    """Check the same of the hook, and that the sling stays taut.

    Raises
    ------
    InfeasibleError
        As `require_rope`.
    """
    timing, coefficients, offsets = joined_pieces(trajectory, 4)
    report = np.zeros(RopeFault.SIZE)
    status = backend.check_hook(
        timing, coefficients, offsets, timing[offsets[1:] - 1].sum(axis=1),
        np.array(hook.crane.masses), *hook.tackle, rope_bounds(hook.crane), rope_work(coefficients),
        np.zeros((HookPath.SIZE, HookPath.COLUMNS)), report,
    )
    require_met(status, report)


HOOK = FlatModel(
    HookCrane, HookModel.ORDERS, 5, HookInverse, HookState,
    np.concatenate([
        np.arange(Coordinates.SIZE),
        PlantState.SLING_ANGLE + np.arange(2),
        State.VELOCITY + np.arange(Coordinates.SIZE),
        PlantState.SLING_RATE + np.arange(2),
    ]),
    _invert, _require_taut, "the rope above a hook, and the sling below it",
)
