"""The feedback of cranes that differ from the planned ones; the benchmark p has 200 of them.

The weak drives are simulated by Newton's laws.
"""

from __future__ import annotations

import numpy as np
import pytest
from benchmarks.feedback import compare
from benchmarks.feedback_cranes import perturbed_cranes

from segfmu import Crane
from segfmu.crane.feedback import design
from segfmu.crane.flat_feedback import design_flat
from segfmu.crane.observer import Uncertainty, design_observer
from segfmu.crane.tracking import TrackingController
from tests.campaign import campaign, soaked_rows
from tests.crane.loop import Rig, simulate

DESIGNS = ("lqr", "flatness")


@campaign(6, 10)
def test_feedback_is_no_worse_than_none_and_damps_and_keeps_the_rope_taut(count: int) -> None:
    moved = [compare(case) for case in perturbed_cranes(count)]
    assert {crane.move.case.driven for crane in moved} == {True, False}
    for crane in moved:
        for kind in DESIGNS:
            assert not crane.worse(kind), crane.name
            assert not crane.slack(kind), crane.name
            assert not (crane.move.case.driven and crane.swings(kind)), crane.name


@pytest.mark.parametrize(("size", "lag"), [
    ("lab", 0.5), ("ship", 0.0), *soaked_rows(("lab", 0.0), ("ship", 0.5)),
])
@pytest.mark.parametrize("kind", DESIGNS)
def test_drives_at_their_bounds_damp_what_they_could_not_follow(
    kind: str, size: str, lag: float
) -> None:
    """From 5 degrees with 2 % of gravity; lag in units of the pendulum's time."""
    crane, rope = (Crane(2.2, 1.155, 1.0), 0.6) if size == "lab" else (Crane(3e5, 15e3, 4e4), 30.0)
    time = np.sqrt(rope / crane.gravity)
    period, lags, most = 0.04 * time, (lag * time,) * 3, [0.02 * crane.gravity] * 3
    ranges = {
        "sample_time": period, "shortest": 0.9 * rope, "longest": 1.1 * rope, "driven": True,
        "lag": lags,
    }
    observer = design_observer(crane, strongest=most, uncertainty=Uncertainty(wake=0.0), **ranges)
    gains = (
        design(crane, strongest=most, **ranges) if kind == "lqr" else design_flat(crane, **ranges)
    )
    loop = TrackingController(
        observer, gains, lower=-np.array(most), upper=most,
        velocity_max=[0.1 * np.sqrt(crane.gravity * rope)] * 3,
    )
    rest = crane.hanging([0.0, 0.0, -rope])
    start = rest.copy()
    start[3:5] = np.radians(5.0)
    states, corrections = simulate(
        Rig(crane.masses, driven=True, lag=lags), loop, start, 2.0 * np.pi * 6.0 * time,
        lambda t: rest,
    )
    assert np.abs(corrections[:, :2]).max() == pytest.approx(most[0])
    last = states[-round(2.0 * np.pi * time / period) :]
    assert np.degrees(np.abs(last[:, 3:5]).max()) < 1.0
