"""The sampled loop: its largest eigenvalue over the rig's range, against simulated decays."""

from __future__ import annotations

import numpy as np
import pytest

from segfmu import Crane, InputError
from segfmu.crane.feedback import SwayFeedback, design, design_schedule
from segfmu.crane.flat_feedback import design_flat
from segfmu.crane.observer import Uncertainty, design_observer
from segfmu.crane.stability import largest_eigenvalue, stability_map
from segfmu.crane.tracking import TrackingController
from tests.campaign import soaked_rows
from tests.crane.loop import Rig, simulate

INTECO = Crane(2.2, 1.155, 1.0)
SHORTEST, LONGEST = 0.16, 0.98
LENGTHS = np.geomspace(SHORTEST, LONGEST, 6)
PAYLOADS = np.array([0.0, 0.5, 1.0, 2.0])
DESIGNS = {"lqr": design, "flat": design_flat}


def controller(
    kind: str, driven: bool, *, period: float = 0.01, delayed: bool = False, factor: float = 1.0,
    **options,
) -> TrackingController:
    ranges = {
        "sample_time": period, "shortest": SHORTEST, "longest": LONGEST, "driven": driven,
    }
    observer = design_observer(
        INTECO, lag=lags(driven), delayed=delayed, uncertainty=Uncertainty(wake=0.0), **ranges
    )
    known = {"lag": max(lags(driven))} if kind == "flat" else {}
    found = DESIGNS[kind](INTECO, **ranges, **known)
    gains = SwayFeedback(period, found.lengths, factor * found.gains, found.payload)
    return TrackingController(observer, gains, **options)


def lags(driven: bool) -> tuple[float, float, float]:
    return (0.025, 0.025, 0.025) if driven else (0.0, 0.0, 0.0)


@pytest.mark.parametrize(
    ("period", "delayed"), [(0.005, False), (0.01, False), (0.01, True), (0.02, True)]
)
@pytest.mark.parametrize("driven", [False, True])
@pytest.mark.parametrize("kind", ["lqr", "flat"])
def test_stable_over_rope_lengths_and_payloads(
    kind: str, driven: bool, period: float, delayed: bool
) -> None:
    loop = controller(kind, driven, period=period, delayed=delayed)
    grid = stability_map(loop, LENGTHS, PAYLOADS, lags(driven))
    assert grid.shape == (LENGTHS.size, PAYLOADS.size)
    # nothing decays slower than in two seconds, the time of the payload's estimate, and some
    assert grid.max() < np.exp(-period / 2.5)
    assert grid.min() > 0.0


def test_stable_with_gains_for_the_payload() -> None:
    loop = controller("lqr", False)
    schedule = design_schedule(
        INTECO, [0.25, 0.5, 1.0, 2.0], sample_time=0.01, shortest=SHORTEST, longest=LONGEST
    )
    for payload in (0.3, 0.7, 1.4, 2.0):
        loop.feedback = schedule.at(payload)
        assert stability_map(loop, LENGTHS, [payload]).max() < np.exp(-0.01 / 2.5)


@pytest.mark.parametrize("kind", ["lqr", "flat"])
def test_stable_with_a_lag_that_is_not_the_observers(kind: str) -> None:
    for actual in (0.0, 0.013, 0.05):
        assert stability_map(controller(kind, True), LENGTHS, [1.0], [actual] * 3).max() < 1.0


def deviations(
    loop: TrackingController, length: float, payload: float, driven: bool, duration: float,
    size: float = 1e-4,
) -> np.ndarray:
    """Course of small deviations of the nonlinear crane by Newton's laws, (ticks + 1, 5)."""
    rest = INTECO.hanging([0.0, 0.0, -length])
    start = rest + size * np.array([1.0, -1.0, 0.3, 1.0, -1.0, 0.0, 0.0, 0.0, 0.0, 0.0])
    bridge, trolley, _, gravity = INTECO.masses
    rig = Rig((bridge, trolley, payload, gravity), driven=driven, lag=lags(driven), substeps=2)
    holding = np.zeros(3) if driven else np.array([0.0, 0.0, -gravity])
    states, _ = simulate(rig, loop, start, duration, lambda t: rest, lambda t: holding)
    return np.abs(states - rest)[:, :5]


def decay(sizes: np.ndarray) -> float:
    """Factor a sample by which a deviation shrinks, or grows, in the end."""
    half = sizes.size // 2
    parts = [np.linalg.norm(part) for part in (sizes[half:-half // 2], sizes[-half // 2 :])]
    return float((parts[1] / parts[0]) ** (2.0 / half))


@pytest.mark.parametrize(("kind", "length"), [
    ("lqr", 0.16), ("flat", 0.5),
    *soaked_rows(("lqr", 0.5), ("lqr", 0.98), ("flat", 0.16), ("flat", 0.98)),
])
def test_velocity_mode_decays_as_its_largest_eigenvalue_says(kind: str, length: float) -> None:
    loop = controller(kind, True)
    expected = largest_eigenvalue(loop, length, 1.0, lags(True))
    duration = 16.0 * np.sqrt(length)
    found = decay(np.linalg.norm(deviations(loop, length, 1.0, True, duration), axis=1))
    assert 1.0 - found == pytest.approx(1.0 - expected, rel=0.05)


@pytest.mark.parametrize("payload", [0.5, 1.5])
@pytest.mark.parametrize("kind", ["lqr", "flat"])
def test_force_mode_decays_as_its_largest_eigenvalue_says(kind: str, payload: float) -> None:
    """The slowest is the estimate of the payload, which the rope's length shows."""
    loop = controller(kind, False, payload_time=1.0)
    expected = largest_eigenvalue(loop, 0.5, payload)
    found = decay(deviations(loop, 0.5, payload, False, 6.0)[:, 2])
    assert 1.0 - found == pytest.approx(1.0 - expected, rel=0.05)


@pytest.mark.parametrize(("kind", "factor"), [("lqr", 12.0), ("flat", 8.0)])
def test_gains_that_are_too_high_are_unstable(kind: str, factor: float) -> None:
    loop = controller(kind, True, factor=factor)
    expected = largest_eigenvalue(loop, 0.5, 1.0, lags(True))
    assert expected > 1.05
    # until it has grown enough to be seen, and is still small
    duration = 0.01 * np.log(1e5) / np.log(expected)
    sizes = np.linalg.norm(deviations(loop, 0.5, 1.0, True, duration, 1e-8), axis=1)
    assert decay(sizes) == pytest.approx(expected, abs=0.02)


def test_without_feedback_the_pendulum_is_at_the_limit() -> None:
    assert largest_eigenvalue(controller("flat", True, enabled=False), 0.5, 1.0) == pytest.approx(
        1.0, abs=1e-3
    )


def test_the_map_has_the_eigenvalues_of_its_points() -> None:
    loop = controller("flat", False)
    grid = stability_map(loop, [0.2, 0.7], [0.5, 1.0, 1.5])
    assert grid[1, 0] == largest_eigenvalue(loop, 0.7, 0.5)
    assert grid[0, 2] == largest_eigenvalue(loop, 0.2, 1.5)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [((0.0, 1.0), "length"), ((0.5, -1.0), "payload"), ((0.5, 1.0, (0.0, 0.0, -0.1)), "lag"),
     ((0.5, 1.0, (0.0, 0.0)), "lag must have 3 values")],
)
def test_bad_values_are_refused(arguments, message: str) -> None:
    with pytest.raises(InputError, match=message):
        largest_eigenvalue(controller("flat", True), *arguments)
