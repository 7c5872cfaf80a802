"""The flat inverse with a hook: in 40 digits, without a hook, and derivatives of it."""

from __future__ import annotations

from itertools import product

import numpy as np
import pytest
import sympy as sp

from segfmu.kernels import backend
from segfmu.kernels.crane.records import (
    Axes,
    Contact,
    Demand,
    DemandWork,
    FlatInverse,
    FlatOrders,
    FlatSeries,
    Masses,
    MostSeries,
    Resistance,
    State,
)
from segfmu.kernels.hook.records import (
    HookCoordinates,
    HookInverse,
    HookModel,
    HookState,
    SlingSeries,
)
from tests.campaign import soaked
from tests.crane.hook_digits import HookDigits, path_derivatives

# bridge, trolley, load, gravity, hook, sling; the second one with a path ten times as large
CRANES = {
    "lab": (("2.2", "1.155", "1.0", "9.81", "0.25", "0.3"), 1),
    "hall": (("12000", "3000", "10000", "9.81", "500", "4"), 10),
    "heavy hook": (("2.2", "1.155", "0.01", "9.81", "2.0", "0.7"), 1),
}
TIMES = [sp.Rational(0), sp.Rational(7, 10), sp.Rational(19, 10)]


def test_the_work_space_of_all_models_has_room() -> None:
    assert SlingSeries.SIZE <= MostSeries.SIZE
    assert HookModel.ORDERS <= FlatOrders.MOST


def inverse(flat: np.ndarray, crane: np.ndarray, order: int = 0) -> np.ndarray:
    found = np.zeros(HookInverse.SIZE)
    work = np.zeros((SlingSeries.SIZE, order + 5))
    backend.hook_derivatives(
        flat, order, crane[: Masses.SIZE].copy(), float(crane[-2]), float(crane[-1]), work, found
    )
    return found


def numbers(name: str) -> np.ndarray:
    return np.array([float(v) for v in CRANES[name][0]])


# the last crane; the first one's demands are compared below; in a soak all at all times
PLACES = [(list(CRANES)[-1], TIMES[len(CRANES) - 1])]


@pytest.mark.parametrize("place", [
    *PLACES, *soaked(*(p for p in product(CRANES, TIMES) if p not in PLACES)),
], ids=lambda place: f"{place[0]}-{place[1]}")
def test_forty_digits_agree(place: tuple[str, sp.Rational]) -> None:
    name, time = place
    masses, scale = CRANES[name]
    exact = HookDigits(masses, scale).inverse(time)
    found = inverse(np.array(path_derivatives(time, 7, scale)), numbers(name))
    for i, value in enumerate(exact):
        assert abs(found[i] - float(value)) <= 1e-12 * max(1.0, abs(float(value))), i


def test_no_hook_leaves_the_crane() -> None:
    """A hook without mass on a sling without length hangs nothing in between."""
    crane = numbers("lab")
    crane[-2:] = 0.0
    for time in TIMES:
        flat = np.array(path_derivatives(time, 7))
        alone = np.zeros(FlatInverse.SIZE)
        work = np.zeros((FlatSeries.SIZE, 3))
        backend.flat_derivatives(flat[:5].copy(), 0, crane[: Masses.SIZE].copy(), work, alone)
        found = inverse(flat, crane)
        state = found[HookInverse.STATE : HookInverse.ACCELERATION]
        rates = state[HookState.VELOCITY : HookState.SLING_RATE]
        same = np.concatenate([
            found[: HookInverse.STATE], state[: HookState.SLING_ANGLE], rates,
            found[HookInverse.ACCELERATION :][: HookCoordinates.SLING_ANGLE],
        ])
        assert same == pytest.approx(alone, rel=1e-9, abs=1e-9)
        # and the sling's angles are the rope's
        assert state[HookState.SLING_ANGLE : HookState.VELOCITY] == pytest.approx(
            alone[FlatInverse.STATE + State.ANGLE :][:2], abs=1e-9
        )


@pytest.mark.parametrize("order", [1, 2, 3])
def test_each_order_is_the_rate_of_the_one_before(order: int) -> None:
    crane, h = numbers("lab"), 1e-3
    for t in (0.3, 1.1):
        rows = [
            inverse(np.array(path_derivatives(sp.Float(t + i * h), order + 6)), crane, order - 1)
            for i in (-2, -1, 1, 2)
        ]
        quotient = (rows[0] - 8.0 * rows[1] + 8.0 * rows[2] - rows[3]) / (12.0 * h)
        found = inverse(np.array(path_derivatives(sp.Float(t), order + 7)), crane, order)
        assert found == pytest.approx(quotient, rel=1e-7, abs=1e-7 * np.abs(found).max())


def test_demands_of_a_hook_need_all_orders() -> None:
    """With a sling the kernel reads two derivatives more, and refuses arrays without them."""
    known = np.zeros(Resistance.SIZE)
    known[: Masses.SIZE] = numbers("lab")[: Masses.SIZE]
    known[Resistance.SUSPENSION : Resistance.SLING + 1] = HookModel.CODE, *numbers("lab")[-2:]
    flat = np.array([path_derivatives(TIMES[1], 7)])
    arrays = np.zeros(1), known, np.zeros((Axes.SIZE, 1, Contact.SIZE))
    work, found = np.zeros((DemandWork.SIZE, DemandWork.COLUMNS)), np.zeros((1, Demand.SIZE))
    with pytest.raises(IndexError):
        backend.drive_demands(flat[:, :5].copy(), *arrays, work, found)
    backend.drive_demands(flat, *arrays, work, found)
    exact = HookDigits(CRANES["lab"][0]).inverse(TIMES[1])
    assert found[0, : Demand.VELOCITY] == pytest.approx([float(f) for f in exact[:3]], rel=1e-12)
