"""What the benchmark of hook and sling tells keeps what is promised."""

from __future__ import annotations

import pytest
from benchmarks import hooks

from tests.campaign import SOAK


def test_a_plan_takes_at_most_15_percent_longer_than_the_optimum() -> None:
    rows = {row["plan"]: row["over optimum"] for row in hooks._durations(100)}
    assert 1.0 < rows["smoothness 6, smoothstep"] < 1.15
    assert rows["trapezoid, ZV for both swings"] > 1.0


def test_the_feedforward_with_the_hook_leaves_no_sway() -> None:
    plain, smooth, hook = (row["sway deg"] for row in hooks._left())
    assert hook < 1e-5
    assert min(plain, smooth) > 0.01


@pytest.mark.soak
def test_the_feedback_leaves_less_than_a_quarter_of_the_gantrys() -> None:
    """Of that which is awake, and of that which sleeps and leaves what its feedforward does."""
    for row in hooks._corners(quick=not SOAK):
        assert row["hook + feedback deg"] < 0.005
        for other in ("gantry + feedback deg", "gantry deg"):
            assert not row["hook + feedback deg"] >= 0.25 * row[other]


def test_the_optimum_without_a_hook_is_that_of_one_pendulum(monkeypatch) -> None:
    """With next to no hook and sling it is the transfer of `benchmarks.drive_oracle`."""
    from benchmarks.drive_oracle import shortest_transfer

    light = hooks.HookCrane(hooks.CRANE.crane, 1e-2, 1e-2)
    monkeypatch.setattr(hooks, "CRANE", light)
    expected = shortest_transfer(
        hooks.DISTANCE, hooks.ROPE, 9.81, hooks.VELOCITY, hooks.ACCELERATION, 100, 1e-4
    )
    assert hooks.shortest(100) == pytest.approx(expected, rel=2e-2)
