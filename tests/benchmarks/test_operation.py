"""The benchmark of random commands: its linear program, and that it finds what is exceeded."""

from __future__ import annotations

import numpy as np
import pytest
from benchmarks.joystick import rows_of, swung
from benchmarks.operated import LAB
from benchmarks.operation import Found, judge, run, shortest_overrun


def test_without_limits_above_the_acceleration_a_stop_is_a_parabola() -> None:
    found = shortest_overrun(np.array([0.8, 0.0, 0.0]), np.array([1.0, 0.5, 1e3, 1e6]), 4.0)
    assert found == pytest.approx(0.8**2 / (2.0 * 0.5), rel=0.05)


def test_an_acceleration_carries_a_load_further() -> None:
    limits = np.array([1.0, 0.5, 1.0, 10.0])
    ways = [shortest_overrun(np.array([0.5, a, 0.0]), limits, 4.0) for a in (-0.2, 0.0, 0.2)]
    assert ways == sorted(ways)


def test_a_run_exceeds_nothing_and_is_judged() -> None:
    found = Found()
    run(LAB, np.random.default_rng((71, 7)), found)
    assert found.samples == 400 * 16
    assert sum(found.outcomes.values()) > 5
    assert found.exceeded.total() == 0


def test_what_is_exceeded_is_counted() -> None:
    motion = np.zeros((100, 5, 3))
    times = 0.02 / 16 * np.arange(100.0)
    # through the box, too fast, and out of the workspace
    motion[:, 0, 0], motion[:, 1, 0] = 0.3 + 9.0 * times, 9.0
    motion[:, 0, 2] = -0.6
    found = Found()
    judge(LAB, motion, found)
    assert set(+found.exceeded) == {"limits", "drives", "workspace", "boxes"}


def test_a_trolley_that_starts_to_accelerate_swings_its_load_to_twice_the_lean() -> None:
    times = 0.001 * np.arange(4000.0)
    most = 0.3
    _, speed, angle = swung(LAB, times, np.full(times.size, most), np.full(times.size, 0.45))
    assert angle.min() == pytest.approx(-2.0 * np.arctan(most / LAB.crane.gravity), rel=1e-4)
    assert speed[-1] == pytest.approx(most * times[-1], abs=0.2)


def test_a_shaped_stick_leaves_no_sway_and_a_flat_ramp_does() -> None:
    rows = {str(r["way to follow"]): r for r in rows_of(LAB)}
    assert float(rows["flat ramp"]["largest sway [deg]"]) > 5.0
    for name in ("ZV", "ZVD", "operator"):
        assert float(rows[name]["sway at rest [deg]"]) < 0.02
