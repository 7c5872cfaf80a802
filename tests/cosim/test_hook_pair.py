"""HookFeedforward and HookCrane, coupled by the master: the load on its plan, ideal and real."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from segfmu.cosim import simulate
from segfmu.validation.files.mission_file import load_mission
from segfmu.validation.scenario import crane_values, feedforward_values
from tests.tables import require_length, rows_of

ROOT = Path(__file__).parents[2]

# s; the load has arrived a second before
STOP = 9.0
FEEDBACK = {"feedback.enabled": True, "crane.rope_min": 0.2, "crane.rope_max": 1.2}


@pytest.mark.parametrize(
    ("fmi", "mode", "most"), [(2, "force", 2e-8), (2, "velocity", 2e-8), (3, "velocity", 2e-5)]
)
def test_an_ideal_crane_carries_the_load_along_its_plan(
    hook_fmus, fmi: int, mode: str, most: float
) -> None:
    """With steps of 1 ms; in FMI 2 the master passes derivatives on, in FMI 3 values alone."""
    rows = simulate(*hook_fmus[fmi], stop_time=STOP, step=1e-3, sink_values={"drive.mode": mode})
    assert rows["plan.done"][-1]
    assert rows["error.load.norm"].max() < most
    assert np.abs(rows["sway.x.angle"]).max() > 0.03
    for name in ("sway.x.angle", "sway.y.angle", "sling.x.angle", "sling.y.angle"):
        assert rows[name] == pytest.approx(rows[f"reference.{name}"], abs=10.0 * most), name


def real(hook_fmus, enabled: bool) -> np.ndarray:
    """A run with drives with lag, friction, quantised signals, and another load than planned."""
    lag = {f"drive.{d}.lag": 0.03 for d in ("bridge", "trolley", "hoist")}
    friction = {"friction.bridge.coulomb": 0.5, "friction.trolley.coulomb": 0.3}
    rows: np.ndarray = simulate(
        *hook_fmus[2], stop_time=STOP + 3.0, step=2e-3, source_values=lag | friction,
        sink_values=FEEDBACK | lag | friction | {
            "feedback.enabled": enabled, "drive.mode": "velocity", "crane.payload_mass": 1.3,
            "feedback.payload_mass": 1.0, "hook.sling": 0.33, "sensor.sample_time": 0.01,
            "sensor.sway.x.angle.resolution": 1e-3, "sensor.sway.y.angle.resolution": 1e-3,
        },
    )
    return rows[rows["time"] > STOP]


def test_feedback_calms_another_load_on_another_sling(hook_fmus) -> None:
    swings = [
        np.hypot(r["load.velocity.x"], r["load.velocity.y"]).max()
        for r in (real(hook_fmus, False), real(hook_fmus, True))
    ]
    assert swings[0] > 5e-3
    assert swings[1] < 1.5e-3


def test_errors_are_as_told(hook_fmus) -> None:
    ideal = {
        f"drive.{d}.{n}": 0.0 for d in ("bridge", "trolley", "hoist") for n in ("lag", "dead_time")
    }
    for name, step, *told in rows_of(ROOT / "docs" / "cosimulation.md", "mission"):
        file = name.partition(",")[0].strip("`")
        planner: dict[str, Any] = {}
        crane, stop = ideal, STOP
        if file.endswith(".toml"):
            mission = load_mission(ROOT / file)
            plan = mission.plan()
            planner, crane = feedforward_values(mission, plan), crane_values(mission) | ideal
            stop = plan.duration + 0.5
        for mode, length in zip(("force", "velocity"), told, strict=True):
            rows = simulate(
                *hook_fmus[2], stop_time=stop, step=1e-3 * float(step.removesuffix(" ms")),
                source_values=planner,
                sink_values=crane | {"feedback.enabled": False, "drive.mode": mode},
            )
            require_length(length, rows["error.load.norm"].max())
