"""Uses of the bounds of the drives, beside plain loops over the two directions."""

from __future__ import annotations

from itertools import product

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from segfmu.kernels import backend
from segfmu.kernels.crane.records import BoundFault, BoundStatus, BoundUses, Demand, DriveBounds

SIDES = (2, Demand.SIZE)
PLACES = slice(Demand.PLACE, Demand.SWAY)
# bounds and peaks that are often equal, and often absent
LEVELS = st.sampled_from([0.0, 0.5, 1.0, 1.0 + 1e-10, 1.0 + 1e-8, 2.0, 1e300])


@given(arrays(float, SIDES, elements=LEVELS), arrays(float, DriveBounds.SIZE, elements=LEVELS))
def test_uses_are_the_largest_of_both_directions(peaks, bounds) -> None:
    bounds[DriveBounds.FORCE_MIN : DriveBounds.TRAVEL_MIN] *= -1.0
    least = bounds[DriveBounds.TRAVEL_MIN :]
    least[:] = np.minimum(least, 2.0)
    bounds[DriveBounds.TRAVEL_MAX : DriveBounds.SWAY_MAX] += 3.0
    times = np.arange(2.0 * Demand.SIZE).reshape(SIDES)
    uses, fault = np.full(BoundUses.SIZE, np.nan), np.zeros(BoundFault.SIZE)
    status = backend.bound_uses(peaks, times, bounds, uses, fault)
    shares = np.zeros(SIDES)
    for side, i in product(*map(range, SIDES)):
        bound, origin = bounds[i], 0.0
        if PLACES.start <= i < PLACES.stop:
            bound, origin = travel(side, bounds[DriveBounds.TRAVEL_MIN + i - Demand.PLACE], bound)
        if side and i < Demand.POWER and bounds[DriveBounds.FORCE_MIN + i]:
            bound = -bounds[DriveBounds.FORCE_MIN + i]
        if bound:
            shares[side, i] = (peaks[side, i] - origin) / bound
    shares = np.maximum(shares, 0.0)
    assert uses[: Demand.SIZE].tolist() == shares.max(axis=0).tolist()
    for i in np.flatnonzero(shares.any(axis=0)):
        assert uses[Demand.SIZE + i] == times[shares[:, i].argmax(), i]
    assert (status != BoundStatus.KEPT) == bool(shares.max() > 1.0 + 1e-9)
    if status != BoundStatus.KEPT:
        value, bound = fault[BoundFault.VALUE], fault[BoundFault.BOUND]
        worst = 3 * (status - BoundStatus.FORCE) + int(fault[BoundFault.DRIVE])
        assert shares[:, worst].max() == shares.max()
        side = int(fault[BoundFault.SIDE])
        if status == BoundStatus.TRAVEL:
            assert value == peaks[side, worst] * (1.0 - 2.0 * side)
            assert (value - bound) * (1.0 - 2.0 * side) > 0.0
        else:
            assert value / bound == shares.max()
            assert (bound < 0.0) == (side == 1)


def travel(side: int, least: float, greatest: float) -> tuple[float, float]:
    """Way from the middle between both ends to one, and where it begins, towards this end."""
    ends = [e for e in (greatest, -least) if e < 1e9]
    stop = (greatest, -least)[side]
    if stop >= 1e9:
        return 0.0, 0.0
    half = 0.5 * sum(ends) if len(ends) == 2 else 1.0
    return half, stop - half
