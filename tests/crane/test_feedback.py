"""Linearisation, gains and the damping of an initial sway, on the nonlinear plant."""

from __future__ import annotations

import numpy as np
import pytest

from segfmu import Crane, InputError
from segfmu.crane.feedback import EFFORT, Weights, design, design_schedule
from segfmu.crane.linear import linearised
from segfmu.crane.plant import Plant, Setpoints

LAB = (2.2, 1.155, 1.0)


@pytest.mark.parametrize("length", [0.16, 1.0, 20.0])
def test_linearisation_is_the_derivative_of_the_rhs(length: float) -> None:
    crane = Crane(*LAB)
    a, b = linearised(crane, length, driven=False)
    state, force = crane.hanging([0.0, 0.0, -length]), np.array([0.0, 0.0, -9.81])
    h = 1e-6
    for i, unit in enumerate(np.eye(10)):
        numeric = crane.rhs(state + h * unit, force) - crane.rhs(state - h * unit, force)
        assert numeric / (2.0 * h) == pytest.approx(a[:, i], abs=1e-6 / length)
    for i, unit in enumerate(np.eye(3)):
        numeric = crane.rhs(state, force + h * unit) - crane.rhs(state, force - h * unit)
        assert numeric / (2.0 * h) == pytest.approx(b[:, i], abs=1e-6 / length)


@pytest.mark.parametrize("driven", [False, True])
def test_gain_is_the_limit_of_the_riccati_recursion(driven: bool) -> None:
    """Dynamic programming over 20 s, with the weights of the crane made dimensionless."""
    # takes half a second, which collection would take in each process
    from scipy.signal import cont2discrete

    length, weights = 0.4, Weights(2.0, 0.5, 0.7, 1.5, 0.8, 10.0)
    found = design(
        Crane(*LAB), sample_time=0.01, shortest=length, longest=length, weights=weights,
        driven=driven,
    ).gains[0]
    a, b = linearised(Crane(*LAB), length, driven)
    a, b = cont2discrete((a, b, np.eye(10), np.zeros((10, 3))), 0.01)[:2]
    units = np.array([length] * 3 + [1.0] * 2)
    units = np.concatenate([units, units * np.sqrt(9.81 / length)])
    cost = np.diag([2.0, 2.0, 10.0, 0.5, 0.5, 0.7, 0.7, 0.7, 1.5, 1.5] / units**2)
    masses = np.ones(3) if driven else np.array([3.355, 1.155, 1.0])
    effort = np.diag(0.8 / (EFFORT * 9.81 * masses) ** 2)
    value = cost
    for _ in range(2000):
        gain = np.linalg.solve(effort + b.T @ value @ b, b.T @ value @ a)
        value = cost + a.T @ value @ (a - b @ gain)
    assert found[:, :10] == pytest.approx(gain, rel=1e-6, abs=1e-6 * np.abs(gain).max())
    assert not found[:, 10:].any()


def test_payload_schedule() -> None:
    options = {"sample_time": 0.01, "shortest": 0.3, "longest": 0.9, "rows": 3}
    schedule = design_schedule(
        Crane(*LAB), [0.5, 1.0, 3.0], sample_time=0.01, shortest=0.3, longest=0.9
    )
    for payload, table in zip((0.5, 1.0, 3.0), schedule.tables, strict=True):
        assert schedule.at(payload).gains == pytest.approx(table.gains)
        same = design(Crane(2.2, 1.155, payload), **{**options, "rows": table.lengths.size})
        assert table.gains == pytest.approx(same.gains)
    between = schedule.at(2.0)
    assert between.payload == 2.0
    expected = 0.5 * (schedule.tables[1].gains + schedule.tables[2].gains)
    assert between.gains == pytest.approx(expected)
    assert schedule.at(0.1).payload == 0.5
    assert schedule.at(9.0).gains == pytest.approx(schedule.tables[2].gains)
    for payloads in ([1.0, 0.5], [0.0, 1.0], [1.0, 1.0]):
        with pytest.raises(InputError, match="payloads must be positive and ascending"):
            design_schedule(Crane(*LAB), payloads, **{k: options[k] for k in list(options)[:3]})


def sway_after(masses, length: float, periods: float, *, driven: bool, enabled: bool) -> float:
    """Largest sway angle [deg] in the period after `periods` from 5 degrees in both angles."""
    crane = Crane(*masses)
    period = 2.0 * np.pi * np.sqrt(length / crane.gravity)
    feedback = design(
        crane, sample_time=period / 100.0, shortest=0.5 * length, longest=2.0 * length,
        driven=driven,
    )
    start = crane.hanging([0.0, 0.0, -length])
    hold = Setpoints(
        force=np.array([0.0, 0.0, -masses[2] * crane.gravity]), reference=start.copy()
    )
    start[3:5] = np.radians([5.0, -5.0])
    plant = Plant(crane, start, hold, feedback, driven=driven, enabled=enabled)
    largest = 0.0
    for i in range(int(100 * (periods + 1.0))):
        plant.step(period / 100.0, hold)
        if i >= 100 * periods:
            largest = max(largest, float(np.abs(plant.state[3:5]).max()))
    return float(np.degrees(largest))


@pytest.mark.parametrize("driven", [False, True])
@pytest.mark.parametrize(
    ("masses", "length"),
    [(LAB, 0.16), (LAB, 0.98), ((2000.0, 500.0, 5000.0), 10.0), ((20000.0, 5000.0, 100.0), 20.0)],
)
def test_sway_of_5_degrees_is_gone_within_four_periods(masses, length, driven: bool) -> None:
    assert sway_after(masses, length, 4.0, driven=driven, enabled=True) < 0.1


def test_without_feedback_the_sway_stays() -> None:
    assert sway_after(LAB, 0.5, 4.0, driven=True, enabled=False) > 4.5


def test_bad_designs_are_refused() -> None:
    crane = Crane(*LAB)
    with pytest.raises(InputError, match="sample_time"):
        design(crane, sample_time=0.0, shortest=0.1, longest=1.0)
    with pytest.raises(InputError, match="rope lengths"):
        design(crane, sample_time=0.01, shortest=2.0, longest=1.0)
    with pytest.raises(InputError, match="weight effort"):
        Weights(effort=0.0)
    with pytest.raises(InputError, match="weight rope"):
        Weights(rope=0.0)
    with pytest.raises(InputError, match="raise the weights of angle and rate"):
        design(
            crane, sample_time=0.01, shortest=0.16, longest=0.98,
            driven=True,
            weights=Weights(angle=0.0, rate=0.0),
        )


@pytest.mark.parametrize("factor", [1e-9, 1e9])
def test_gains_of_all_masses_are_in_proportion(factor: float) -> None:
    # (1, 1, 1) kg at lengths where a solver found none for 1e9 times as much
    given = {"sample_time": 0.01, "shortest": 0.1, "longest": 2.5}
    one = design(Crane(1.0, 1.0, 1.0), **given).gains
    found = design(Crane(factor, factor, factor), **given).gains
    np.testing.assert_allclose(found / factor, one, rtol=1e-6, atol=1e-6 * np.abs(one).max())


@pytest.mark.parametrize(("masses", "weights", "words"), [
    (LAB, {"position": 1e300}, "feedback.weight.position 1e[+]300 is too far from 1; choose one"),
    (LAB, {"position": 1e-300}, "feedback.weight.position 1e-300 is too far from 1"),
    (LAB, {"velocity": 1.7e308}, "feedback.weight.velocity 1.7e[+]308 is too far from 1"),
    (LAB, {"angle": 1e30}, "feedback.weight.angle 1e[+]30 is too far from 1"),
    (LAB, {"effort": 1e15}, "feedback.weight.effort 1e[+]15 is too far from 1"),
    ((2.2, 1.155, 1e9), {}, "payload_mass 1e[+]09 kg is too far from trolley_mass 1.155 kg; check"),
])
@pytest.mark.filterwarnings("error")
def test_why_there_is_no_gain(masses, weights: dict, words: str) -> None:
    # the first rope that has none differs from one linear algebra library to another
    message = rf"^the feedback has no gain at [0-9.]+ m of rope: {words}"
    with pytest.raises(InputError, match=message):
        design(
            Crane(*masses), sample_time=0.01, shortest=0.16, longest=0.98,
            weights=Weights(**weights),
        )
