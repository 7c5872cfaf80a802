"""End stops between waypoints: extremes are found between samples."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from scipy.optimize import minimize_scalar

from segfmu.crane import FlatInverse
from segfmu.crane.inverse import POSITION
from segfmu.errors import InfeasibleError
from segfmu.validation import planned
from segfmu.validation.files.mission import Mission, load_mission

CRANE = """bridge_mass = 2.0
trolley_mass = 1.0
payload_mass = 1.0
[travel]
bridge = [0.0, {stop!r}]
"""
LIMITS = "".join(
    f"[limits.{a}]\nvelocity = 0.5\nacceleration = 1.0\njerk = 6.0\nsnap = 60.0\n" for a in "xyz"
)
POINTS = """[[waypoints]]
position = [0.0, 0.0, -0.5]
[[waypoints]]
position = [0.3, 0.0, -0.5]
velocity = [0.3, 0.0, 0.0]
[[waypoints]]
position = [0.3, 0.0, -0.45]
"""


def mission(folder: Path, stop: float) -> Mission:
    path = folder / "mission.toml"
    (folder / "crane.toml").write_text(CRANE.format(stop=stop), encoding="utf-8")
    path.write_text('crane = "crane.toml"\n' + LIMITS + POINTS, encoding="utf-8")
    return load_mission(path)


def test_a_stop_is_met_exactly_at_the_farthest_place(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    free = mission(tmp_path, 9.0)
    trajectory = free.plan()
    inverse = FlatInverse(free.build_crane(), trajectory)

    def place(time: float) -> float:
        return float(inverse.evaluate(np.array([time]))[0, POSITION][0])

    times = np.linspace(0.0, trajectory.duration, 2001)
    near = times[np.argmax(inverse.evaluate(times)[:, POSITION][:, 0])]
    step = times[1]
    found = minimize_scalar(
        lambda t: -place(t), bounds=(near - step, near + step), method="bounded",
        options={"xatol": 1e-9},
    )
    farthest = -float(found.fun)
    # as coarse as a plan of hours has them
    monkeypatch.setattr(planned, "SAMPLES", 12)
    planned.planned(mission(tmp_path, farthest + 1e-5))
    with pytest.raises(InfeasibleError) as refused:
        planned.planned(mission(tmp_path, farthest - 1e-5))
    assert refused.value.value == pytest.approx(farthest, abs=1e-6)
    assert refused.value.time == pytest.approx(found.x, abs=0.01)
