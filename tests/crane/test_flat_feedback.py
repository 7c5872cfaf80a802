"""Closed-form gains: the poles that NumPy finds are the chosen ones."""

from __future__ import annotations

import numpy as np
import pytest

from segfmu import Crane, InputError
from segfmu.crane.flat_feedback import HOIST_LARGEST, LARGEST, design_flat, flat_gain
from tests.crane.newton import accelerations

LAB = Crane(2.2, 1.155, 1.0)
HARBOUR = Crane(20000.0, 5000.0, 30000.0)


def newtonian(crane: Crane, length: float, driven: bool) -> tuple[np.ndarray, np.ndarray]:
    """A and B about rest by central differences of Newton's laws."""
    rest = np.array([0.0, 0.0, length, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0])
    weight = np.array([0.0, 0.0, -crane.payload_mass * crane.gravity])

    def slope(state: np.ndarray, drive: np.ndarray) -> np.ndarray:
        if not driven:
            found = accelerations(state, weight + drive, np.zeros(3), *crane.masses)
            return np.concatenate([state[5:], found])
        base = accelerations(state, np.zeros(3), np.zeros(3), *crane.masses)
        columns = [accelerations(state, f, np.zeros(3), *crane.masses) - base for f in np.eye(3)]
        matrix = np.array(columns).T
        force = np.linalg.solve(matrix[:3], drive - base[:3])
        return np.concatenate([state[5:], base + matrix @ force])

    h, zero = 1e-6, np.zeros(3)
    a = [(slope(rest + h * u, zero) - slope(rest - h * u, zero)) / (2.0 * h) for u in np.eye(10)]
    scale = 1.0 if driven else crane.payload_mass
    b = [
        (slope(rest, h * scale * u) - slope(rest, -h * scale * u)) / (2.0 * h * scale)
        for u in np.eye(3)
    ]
    return np.array(a).T, np.array(b).T


def characteristic(bandwidth: float, damping: float, order: int) -> np.ndarray:
    return np.poly1d([1.0, 2.0 * damping * bandwidth, bandwidth**2]) ** order


@pytest.mark.parametrize("driven", [False, True])
@pytest.mark.parametrize(("crane", "length"), [(LAB, 0.16), (LAB, 0.98), (HARBOUR, 20.0)])
@pytest.mark.parametrize("damping", [0.6, 1.0, 1.3])
def test_poles_are_the_chosen_ones(crane, length: float, damping: float, driven: bool) -> None:
    bandwidth, hoist = 1.2 * np.sqrt(9.81 / length), 2.0 * np.sqrt(9.81 / length)
    a, b = newtonian(crane, length, driven)
    loop = a - b @ flat_gain(crane, length, bandwidth, damping, driven, hoist)[:, :10]
    groups = (([0, 3, 5, 8], bandwidth, 2), ([1, 4, 6, 9], bandwidth, 2), ([2, 7], hoist, 1))
    for rows, w, order in groups:
        # coefficients, as multiple poles are sensitive; scaled to a bandwidth of 1
        found = np.poly(loop[np.ix_(rows, rows)] / w)
        assert found == pytest.approx(characteristic(1.0, damping, order).coeffs, abs=1e-5)
        others = np.setdiff1d(np.arange(10), rows)
        assert np.abs(loop[np.ix_(rows, others)]).max() < 1e-5 * w**2


def test_the_table_has_the_gains_of_its_lengths() -> None:
    feedback = design_flat(
        LAB, sample_time=0.001, shortest=0.3, longest=0.9, ratio=0.9, hoist_ratio=2.0, damping=0.7
    )
    assert feedback.payload == 1.0
    assert feedback.gains.shape == (feedback.lengths.size, 3, 11)
    for length, gains in zip(feedback.lengths, feedback.gains, strict=True):
        frequency = np.sqrt(9.81 / length)
        expected = flat_gain(LAB, length, 0.9 * frequency, 0.7, False, 2.0 * frequency)
        assert gains == pytest.approx(expected)


@pytest.mark.parametrize("lag", [0.02, 0.3])
@pytest.mark.parametrize(("crane", "length"), [(LAB, 0.16), (LAB, 0.98), (HARBOUR, 20.0)])
def test_a_drive_keeps_the_pole_of_its_lag(crane, length: float, lag: float) -> None:
    """The command is one more state: v' = (c - v) / T and c' is the correction."""
    w, hoist = 1.2 * np.sqrt(9.81 / length), 2.0 * np.sqrt(9.81 / length)
    a, b = newtonian(crane, length, True)
    gains = flat_gain(crane, length, w, 0.9, True, hoist, lag)
    for axis, rows, order in ((0, [0, 3, 5, 8], 2), (1, [1, 4, 6, 9], 2), (2, [2, 7], 1)):
        size, velocity = len(rows), rows.index(5 + axis)
        loop = np.zeros((size + 1, size + 1))
        loop[:size, :size] = a[np.ix_(rows, rows)]
        loop[:size, size] = b[rows, axis] / lag
        loop[:size, velocity] -= b[rows, axis] / lag
        loop[size, :size], loop[size, size] = -gains[axis, rows], -gains[axis, 10]
        scale = hoist if axis == 2 else w
        expected = characteristic(1.0, 0.9, order) * np.poly1d([1.0, 1.0 / (lag * scale)])
        assert np.poly(loop / scale) == pytest.approx(expected.coeffs, rel=1e-4, abs=1e-4)


@pytest.mark.parametrize(
    ("sample_time", "dead_time", "lag"), [(0.05, 0.0, 0.0), (0.01, 0.04, 0.0), (0.01, 0.03, 0.04)]
)
def test_a_slow_loop_bounds_the_bandwidths(
    sample_time: float, dead_time: float, lag: float
) -> None:
    """The rope by its bandwidth; the carriage's position, with the pendulum as fast as ever."""
    feedback = design_flat(
        LAB, sample_time=sample_time, shortest=0.16, longest=0.16, damping=0.9, lag=lag,
        dead_time=dead_time, driven=True,
    )
    pendulum, w, hoist = np.sqrt(9.81 / 0.16), LARGEST / 0.05, HOIST_LARGEST / 0.05
    assert pendulum > w
    assert feedback.gains[0, 2, 2] == pytest.approx(hoist**2)
    assert feedback.gains[0, 0, 0] == pytest.approx(0.16 / 9.81 * (w * pendulum) ** 2)


@pytest.mark.parametrize(
    "name", ["sample_time", "ratio", "hoist_ratio", "damping", "lag", "dead_time"]
)
def test_bad_values_are_refused(name: str) -> None:
    values = {"sample_time": 0.01, "shortest": 0.1, "longest": 1.0, name: -1.0}
    with pytest.raises(InputError, match=name):
        design_flat(LAB, **values)
