"""The verdict on made-up runs."""

from __future__ import annotations

import numpy as np
import pytest

from segfmu.errors import InputError
from segfmu.validation.criteria import DRIVES, RATES, judge


def run(error: float, sway_during: float, sway_after: float) -> np.ndarray:
    names = [
        "time", "sway.x.angle", "sway.y.angle", "error.load.norm",
        *(f"drive.{d}.force" for d in DRIVES), *RATES.values(),
    ]
    rows = np.zeros(11, dtype=[(n, float) for n in names])
    rows["time"] = np.arange(11) * 0.5
    rows["error.load.norm"][3] = error
    rows["sway.x.angle"][:6] = np.radians(sway_during)
    rows["sway.y.angle"][7] = -np.radians(sway_after)
    rows["drive.hoist.force"][2] = -12.0
    rows["rope.velocity"][4] = -0.3
    return rows


def test_peaks_and_sway_after_the_plan_alone() -> None:
    found = judge(run(2e-4, 8.0, 0.01), 3.0, 1e-3, 0.02)
    assert found.passed
    assert found.residual_sway == pytest.approx(0.01)
    assert found.tracking_error == 2e-4
    assert found.peak_force["hoist"] == 12.0
    assert found.peak_velocity["hoist"] == 0.3


@pytest.mark.parametrize(("error", "sway"), [(2e-3, 0.0), (0.0, 0.5)])
def test_either_excess_fails(error: float, sway: float) -> None:
    assert not judge(run(error, 0.0, sway), 3.0, 1e-3, 0.02).passed


def test_run_that_ends_too_early_is_refused() -> None:
    with pytest.raises(InputError, match=r"ends at 5\.000 s"):
        judge(run(0.0, 0.0, 0.0), 9.0, 1e-3, 0.02)


def test_sway_just_before_the_end_of_the_plan_does_not_count() -> None:
    assert judge(run(2e-4, 8.0, 0.01), 2.505, 1e-3, 0.02).residual_sway == pytest.approx(0.01)
    assert judge(run(2e-4, 8.0, 0.01), 2.5, 1e-3, 0.02).residual_sway == pytest.approx(8.0)
