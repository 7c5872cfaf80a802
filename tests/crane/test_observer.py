"""The observer: its gains against an iterated Riccati equation, its estimates against the truth."""

from __future__ import annotations

import numpy as np
import pytest

from segfmu import Crane, InputError
from segfmu.crane.flat_feedback import design_flat
from segfmu.crane.observer import Uncertainty, design_observer
from segfmu.crane.tracking import TrackingController
from segfmu.kernels.control.records import Observer as Table
from tests.crane.kalman import axis_model, axis_table
from tests.crane.loop import Rig, simulate

LAB = Crane(2.2, 1.155, 1.0)
MASSES = LAB.masses
T = 0.01
REST = LAB.hanging([0.1, -0.2, -0.6])
HOLD = np.array([0.0, 0.0, -9.81])
LAGS = (0.025, 0.02, 0.03)


def controller(driven: bool, *, delayed: bool = False, **options) -> TrackingController:
    observer = design_observer(
        LAB, sample_time=T, shortest=0.16, longest=0.98, driven=driven,
        lag=LAGS if driven else (0.0, 0.0, 0.0), delayed=delayed, uncertainty=Uncertainty(wake=0.0),
    )
    gains = design_flat(LAB, sample_time=T, shortest=0.16, longest=0.98, driven=driven)
    return TrackingController(observer, gains, **options)


def rig(driven: bool, **values) -> Rig:
    return Rig(MASSES, driven=driven, lag=LAGS if driven else (0.0, 0.0, 0.0), **values)


def held(driven: bool):
    return lambda t: np.zeros(3) if driven else HOLD


@pytest.mark.parametrize("driven", [False, True])
@pytest.mark.parametrize("axis", [0, 1, 2])
def test_gain_is_the_limit_of_the_riccati_recursion(axis: int, driven: bool) -> None:
    # takes half a second, which collection would take in each process
    from scipy.signal import cont2discrete

    length, expected = 0.4, Uncertainty(position=2e-4, length=3e-4, drift=0.2, wind=0.07)
    observer = design_observer(
        LAB, sample_time=T, shortest=length, longest=length, driven=driven, lag=LAGS,
        uncertainty=expected,
    )
    kept = np.arange(6) if axis < 2 else np.array([0, 2, 4])
    outputs = kept[kept < 2]
    a, b = (m[kept] for m in axis_model(LAB, axis, length, driven, LAGS[axis]))
    a = a[:, kept]
    size = kept.size
    # the covariance of the walks by a sum over a thousand parts of the sample
    walks = np.zeros((size, size))
    time = np.sqrt(length / 9.81)
    walks[kept == 4, kept == 4] = (0.2 * 9.81) ** 2 / time
    walks[kept == 5, kept == 5] = (0.07 * 9.81) ** 2 / time
    part = cont2discrete((a, b, np.eye(size), np.zeros((size, 2))), T / 1000.0)[0]
    covariance, transition = np.zeros((size, size)), np.eye(size)
    for _ in range(1000):
        middle = 0.5 * (transition + part @ transition)
        covariance += middle @ walks @ middle.T * T / 1000.0
        transition = part @ transition
    steps = np.array([2e-4 if axis < 2 else 3e-4, 2.0 * np.pi / 4096.0])
    noise = np.diag(steps[: outputs.size] ** 2)
    noise *= max(1.0, 0.05 * time / T) / 12.0
    read = np.eye(size)[: outputs.size]
    spread, gain = np.eye(size), np.zeros((size, outputs.size))
    for _ in range(4000):
        gain = spread @ read.T @ np.linalg.inv(read @ spread @ read.T + noise)
        spread = transition @ (spread - gain @ read @ spread) @ transition.T + covariance
    block = observer.table[0, Table.BRIDGE :][6 * axis : 6 * axis + 6]
    assert block[np.ix_(kept, kept)] == pytest.approx(transition, abs=1e-9)
    assert block[np.ix_(kept, 8 + outputs)] == pytest.approx(gain, rel=1e-4, abs=1e-6)


@pytest.mark.parametrize("lag", [0.0, 0.003, 0.05])
@pytest.mark.parametrize("driven", [False, True])
@pytest.mark.parametrize("period", [1e-3, 0.01, 0.05])
def test_the_table_is_that_of_scipy(period: float, driven: bool, lag: float) -> None:
    """Over four decades of rope length, and for sensors much better and worse than usual."""
    for expected in (
        Uncertainty(), Uncertainty(1e-2, 1e-6, 1e-5, 0.01, 0.2), Uncertainty(drift=1.0, wind=1e-3)
    ):
        observer = design_observer(
            LAB, sample_time=period, shortest=0.01, longest=100.0, driven=driven, lag=(lag,) * 3,
            uncertainty=expected, rows=5,
        )
        for length, block in zip(observer.lengths, observer.table[:, Table.BRIDGE :], strict=True):
            for axis in range(3):
                told = period, driven, lag, observer.uncertainty
                rows = axis_table(LAB, axis, float(length), told)
                found = block[6 * axis : 6 * axis + 6]
                assert found[:, :8] == pytest.approx(rows[:, :8], rel=1e-11, abs=1e-12)
                assert found[:, 8:] == pytest.approx(
                    rows[:, 8:], rel=1e-6, abs=1e-8 * np.abs(rows[:, 8:]).max()
                )


@pytest.mark.parametrize("delayed", [False, True])
@pytest.mark.parametrize("driven", [False, True])
def test_velocities_and_rates_are_found_from_positions_and_angles(
    driven: bool, delayed: bool
) -> None:
    """While the loop is closed: after half a second the estimate is the state."""
    start = REST + np.array([0.01, -0.02, 0.01, 0.01, 0.02, 0.05, -0.03, 0.02, 0.1, -0.1])
    tracker = controller(driven, delayed=delayed)
    states, _ = simulate(
        rig(driven, delayed=delayed), tracker, start, 0.5, lambda t: REST, held(driven)
    )
    # the estimate is that of the last tick, before the last state
    assert tracker.deviation == pytest.approx(states[-2] - REST, abs=3e-3)
    assert np.abs(states[-2] - REST).max() > 0.02


@pytest.mark.parametrize("driven", [False, True])
def test_a_constant_wind_is_found(driven: bool) -> None:
    wind = np.array([0.3, -0.2, 0.0])
    tracker = controller(driven)
    states, _ = simulate(
        rig(driven, wind=lambda t: wind), tracker, REST, 5.0, lambda t: REST, held(driven)
    )
    assert tracker.disturbance[1, :2] == pytest.approx([0.3, -0.2], abs=2e-3)
    assert states[-1][5:] == pytest.approx(np.zeros(5), abs=1e-4)


def test_a_constant_force_on_the_carriages_is_found() -> None:
    missing = np.array([0.8, -0.5, 0.0])
    tracker = controller(False)
    simulate(rig(False), tracker, REST, 5.0, lambda t: REST, lambda t: HOLD + missing)
    assert tracker.disturbance[0, :2] == pytest.approx(missing[:2] / [3.355, 1.155], abs=2e-3)


@pytest.mark.parametrize("payload", [0.4, 1.0, 2.0])
def test_the_payload_is_found_from_the_force_that_holds_it(payload: float) -> None:
    tracker = controller(False, payload_time=0.5)
    bridge, trolley, _, gravity = MASSES
    heavy = Rig((bridge, trolley, payload, gravity))
    states, _ = simulate(heavy, tracker, REST, 5.0, lambda t: REST, lambda t: HOLD)
    assert tracker.payload == pytest.approx(payload, abs=0.01)
    assert states[-1][2] == pytest.approx(0.6, abs=1e-3)


def test_switched_off_it_goes_on() -> None:
    start = REST + np.array([0.0, 0.0, 0.0, 0.05, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0])
    tracker = controller(True, enabled=False)
    states, corrections = simulate(rig(True), tracker, start, 1.0, lambda t: REST, held(True))
    assert not corrections.any()
    assert tracker.deviation[[3, 8]] == pytest.approx(states[-2][[3, 8]], abs=2e-3)


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"sample_time": 0.0}, "sample_time"),
        ({"shortest": 2.0}, "rope lengths"),
        ({"lag": (0.0, -0.1, 0.0)}, "lag of the trolley"),
        ({"lag": (0.0, 0.1)}, "lag must have 3 values"),
        ({"uncertainty": Uncertainty(wind=1e200)}, "no finite gains between 0.2 and 1 m"),
    ],
)
def test_bad_designs_are_refused(values, message: str) -> None:
    with pytest.raises(InputError, match=message):
        design_observer(LAB, **{"sample_time": T, "shortest": 0.2, "longest": 1.0, **values})


@pytest.mark.parametrize(
    ("name", "value"),
    [("position", -1.0), ("length", -1.0), ("angle", -1.0), ("drift", 0.0), ("wind", 0.0)],
)
def test_bad_uncertainties_are_refused(name: str, value: float) -> None:
    with pytest.raises(InputError, match=name):
        Uncertainty(**{name: value})
    with pytest.raises(InputError, match="wake"):
        Uncertainty(wake=-1.0)
