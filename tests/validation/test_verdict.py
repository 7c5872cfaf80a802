"""The verdict on made-up outcomes."""

from __future__ import annotations

from math import inf, isnan, nan

import pytest

from segfmu.validation.campaign import Outcome
from segfmu.validation.disturbances import Disturbance
from segfmu.validation.verdict import Comparison, compare

DEMANDED = Disturbance("demanded", demanded=True)
OTHER = Disturbance("other")
BLIND = Disturbance("blind", rope=0.05, demanded=True)


def outcome(method: str, row: Disturbance, error: float, sway: float, **more) -> Outcome:
    return Outcome(
        "force", row.name, method, 1.0, rms_error=error, residual_sway=sway,
        **{"rms_horizontal": error, **more},
    )


def judged(row: Disturbance, alone: tuple, aided: tuple, **more) -> Comparison:
    outcomes = [
        outcome("ZV", row, 9.0, 9.0),
        outcome("feedforward", row, *alone),
        outcome("feedforward + LQR", row, *aided, **more),
    ]
    (found,) = compare(outcomes, [row])
    return found


def test_both_factors_are_demanded() -> None:
    assert judged(DEMANDED, (0.03, 1.0), (0.01, 0.1)).reached
    assert not judged(DEMANDED, (0.029, 1.0), (0.01, 0.1)).reached
    assert not judged(DEMANDED, (0.03, 0.99), (0.01, 0.1)).reached
    found = judged(DEMANDED, (0.03, 1.0), (0.01, 0.1))
    assert (found.error_ratio, found.sway_ratio) == pytest.approx((3.0, 10.0))


def test_elsewhere_it_only_must_not_be_worse() -> None:
    assert judged(OTHER, (0.03, 1.0), (0.03, 1.0)).reached
    assert judged(OTHER, (0.03, 1.0), (0.031, 1.0)).worse
    assert judged(OTHER, (0.03, 1.0), (0.03, 1.1)).worse


def test_what_is_small_is_neither_gained_nor_lost() -> None:
    found = judged(DEMANDED, (1e-6, 1e-4), (5e-5, 5e-3))
    assert isnan(found.error_ratio) and isnan(found.sway_ratio)
    assert found.reached and not found.worse
    assert judged(DEMANDED, (1e-6, 1e-4), (2e-4, 5e-3)).worse


def test_failures() -> None:
    alone = Outcome("force", "demanded", "feedforward", 1.0, failure="fell")
    aided = outcome("feedforward + LQR", DEMANDED, 0.01, 0.1)
    (found,) = compare([alone, aided], [DEMANDED])
    assert (found.error_ratio, found.sway_ratio) == (inf, inf)
    assert found.reached
    lost = judged(OTHER, (0.01, 0.1), (nan, nan), failure="fell")
    assert lost.worse and not lost.reached


def test_a_height_that_no_sensor_tells_does_not_count() -> None:
    found = judged(BLIND, (0.04, 1.0), (0.04, 0.05), rms_horizontal=0.01)
    assert found.error_ratio == pytest.approx(4.0)
    assert found.reached
