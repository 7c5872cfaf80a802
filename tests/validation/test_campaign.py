"""Runs of the campaign: metrics against published and closed-form values."""

from __future__ import annotations

import numpy as np
import pytest

from segfmu.crane.shaping import Trapezoid
from segfmu.validation.campaign import SETTLED, Outcome, run_campaign, run_case
from segfmu.validation.disturbances import DISTURBANCES, Disturbance
from segfmu.validation.files.mission import Mission
from segfmu.validation.methods import METHODS, Method
from tests.validation.moves import DIAGONAL, STRAIGHT, mission

ROWS = {row.name: row for row in DISTURBANCES}
COLUMNS = {method.name: method for method in METHODS}
NONE = ROWS["none"]


def run(
    task: Mission, mode: str, disturbance: Disturbance = NONE, method: str = "feedforward"
) -> Outcome:
    return run_case(task, task.plan(), mode, disturbance, COLUMNS[method])


@pytest.mark.parametrize(
    ("distance", "rope", "velocity", "acceleration", "sway"),
    [(0.4, 0.5, 0.3, 0.6, 2.363), (0.4, 0.7, 0.3, 0.6, 6.791), (1.0, 0.5, 1.0, 1.0, 14.914)],
)
def test_residual_sway_of_an_unshaped_move_is_the_published_one(
    distance: float, rope: float, velocity: float, acceleration: float, sway: float
) -> None:
    task = mission(
        (0.0, 0.0, -rope), (distance, 0.0, -rope), velocity=velocity, acceleration=acceleration
    )
    found = run(task, "velocity", method="no control")
    assert found.residual_sway == pytest.approx(sway, rel=1e-2)
    assert found.last_sway == pytest.approx(sway, rel=1e-2)
    assert found.duration == pytest.approx(Trapezoid(distance, velocity, acceleration).duration)


@pytest.mark.parametrize("mode", ["velocity", "force"])
def test_undisturbed_feedforward_is_exact_and_settles_with_the_plan(mode: str) -> None:
    found = run(DIAGONAL, mode)
    trajectory = DIAGONAL.plan()
    assert found.rms_error <= found.peak_error < 2e-4
    assert found.residual_sway < 0.02
    times = np.linspace(0.0, trajectory.duration, 5001)
    away = np.linalg.norm(trajectory(times) - trajectory(trajectory.duration), axis=1) > SETTLED
    assert found.settling_time == pytest.approx(times[away][-1], abs=2.0 * 0.002)


def test_a_free_pendulum_keeps_its_amplitude() -> None:
    """At rest, 5 degrees: rms of a sine, and twice 2 sin(2.5 deg) l at most."""
    found = run(STRAIGHT, "velocity", ROWS["initial sway 5 deg"])
    amplitude = 0.5 * np.sin(np.radians(5.0))
    assert found.peak_error == pytest.approx(2.0 * 0.5 * np.sin(np.radians(2.5)), rel=0.1)
    assert found.rms_error == pytest.approx(amplitude / np.sqrt(2.0), rel=0.1)
    assert found.residual_sway > 4.0
    assert found.settling_time == np.inf


def test_a_rope_error_is_pulled_in_at_once_where_it_is_measured_and_else_on_the_way() -> None:
    seen = run(DIAGONAL, "velocity", ROWS["rope +5 %, measured"], "feedforward + flatness")
    unseen = run(DIAGONAL, "velocity", ROWS["rope +5 %, unmeasured"], "feedforward + flatness")
    assert seen.peak_error == pytest.approx(0.025, rel=1e-3)
    assert seen.settling_time < 4.0
    alone = run(DIAGONAL, "velocity", ROWS["rope +5 %, unmeasured"])
    assert alone.rms_error == pytest.approx(0.025, rel=0.01)
    assert seen.rms_error < unseen.rms_error < 0.5 * alone.rms_error
    assert unseen.settling_time < 5.0
    assert unseen.rms_horizontal < alone.rms_horizontal / 3.0


def test_a_load_that_the_force_does_not_hold_fails_with_the_reason() -> None:
    found = run(DIAGONAL, "force", ROWS["payload +50 %"])
    assert "rope at 0.8 m is at its end stop" in found.failure
    assert np.isnan(found.rms_error)
    held = run(DIAGONAL, "force", ROWS["payload +50 %"], "feedforward + LQR")
    assert held.failure == ""
    assert held.peak_error < 0.03


def test_order_and_processes_do_not_matter() -> None:
    rows = (NONE, ROWS["encoder 4096/rev"])
    columns: tuple[Method, ...] = (COLUMNS["ZV"], COLUMNS["feedforward + LQR"])
    shares: list[float] = []
    one = run_campaign(DIAGONAL, ("velocity",), rows, columns, progress=shares.append)
    two = run_campaign(DIAGONAL, ("velocity",), rows, columns, jobs=2)
    assert one == two
    assert [(o.disturbance, o.method) for o in one] == [
        (row.name, column.name) for row in rows for column in columns
    ]
    assert shares == [0.5, 1.0]


def test_feedback_on_quantised_signals_leaves_an_exact_feedforward_alone() -> None:
    alone = run(DIAGONAL, "velocity", ROWS["encoder 4096/rev"])
    aided = run(DIAGONAL, "velocity", ROWS["encoder 4096/rev"], "feedforward + flatness")
    assert aided.rms_error <= alone.rms_error + 1e-6
    assert aided.residual_sway < 0.01
