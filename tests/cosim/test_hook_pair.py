"""HookFeedforward and HookCrane, coupled by the master: the load on its plan, ideal and real."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from segfmu.cosim import simulate
from segfmu.fmu.build import build_all
from segfmu.fmu.choice import Choice
from segfmu.fmu.hook_crane import interface as hook_crane
from segfmu.fmu.hook_feedforward import interface as hook_feedforward
from tests.compiler import require_native
from tests.sharing import shared

# s; the load has arrived a second before
STOP = 9.0
FEEDBACK = {"feedback.enabled": True, "crane.rope_min": 0.2, "crane.rope_max": 1.2}


@pytest.fixture(scope="module")
def pairs(tmp_path_factory: pytest.TempPathFactory) -> dict[int, tuple[Path, Path]]:
    """Both archives by version of FMI."""
    require_native()
    specs = [hook_feedforward.spec(), hook_crane.spec()]
    found = {}
    for fmi in (2, 3):
        folder = shared(
            tmp_path_factory, f"hooks{fmi}",
            lambda place, fmi=fmi: build_all(place, Choice(True, fmi), specs),
        )
        found[fmi] = folder / "HookFeedforward.fmu", folder / "HookCrane.fmu"
    return found


@pytest.mark.parametrize(
    ("fmi", "mode", "most"), [(2, "force", 5e-7), (2, "velocity", 5e-7), (3, "velocity", 2e-5)]
)
def test_an_ideal_crane_carries_the_load_along_its_plan(
    pairs, fmi: int, mode: str, most: float
) -> None:
    """With steps of 1 ms; in FMI 2 the master passes derivatives on, in FMI 3 values alone."""
    rows = simulate(*pairs[fmi], stop_time=STOP, step=1e-3, sink_values={"drive.mode": mode})
    assert rows["plan.done"][-1]
    assert rows["error.load.norm"].max() < most
    assert np.abs(rows["sway.x.angle"]).max() > 0.03
    for name in ("sway.x.angle", "sway.y.angle", "sling.x.angle", "sling.y.angle"):
        assert rows[name] == pytest.approx(rows[f"reference.{name}"], abs=10.0 * most), name


def real(pairs, enabled: bool) -> np.ndarray:
    """A run with drives with lag, friction, quantised signals, and another load than planned."""
    lag = {f"drive.{d}.lag": 0.03 for d in ("bridge", "trolley", "hoist")}
    friction = {"friction.bridge.coulomb": 0.5, "friction.trolley.coulomb": 0.3}
    rows: np.ndarray = simulate(
        *pairs[2], stop_time=STOP + 3.0, step=2e-3, source_values=lag | friction,
        sink_values=FEEDBACK | lag | friction | {
            "feedback.enabled": enabled, "drive.mode": "velocity", "crane.payload_mass": 1.3,
            "feedback.payload_mass": 1.0, "hook.sling": 0.33, "sensor.sample_time": 0.01,
            "sensor.sway.x.angle.resolution": 1e-3, "sensor.sway.y.angle.resolution": 1e-3,
        },
    )
    return rows[rows["time"] > STOP]


def test_feedback_calms_another_load_on_another_sling(pairs) -> None:
    swings = [
        np.hypot(r["load.velocity.x"], r["load.velocity.y"]).max()
        for r in (real(pairs, False), real(pairs, True))
    ]
    assert swings[0] > 5e-3
    assert swings[1] < 1.5e-3
