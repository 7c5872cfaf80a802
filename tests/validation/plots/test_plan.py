"""Plots of plans of all sizes."""

from __future__ import annotations

import numpy as np
import pytest

from segfmu import Limits, Waypoint, plan
from segfmu.validation.plots.plan import plot_plan
from segfmu.validation.report.motion import load_section

LIMITS = Limits(1.0, 1.0, 5.0)


@pytest.mark.parametrize(("way", "shown", "unit"), [
    (2e-6, 2.0, "µm"), (0.002, 2.0, "mm"), (-0.002, -2.0, "mm"), (100.0, 100.0, "m"),
])
def test_a_way_fills_its_panel(way: float, shown: float, unit: str) -> None:
    points = [Waypoint([x, 5.0, -20.0]) for x in (3.0, 3.0 + way)]
    trajectory = plan(points, LIMITS, axis_names="xyz")
    panel = plot_plan(trajectory, "m").axes[0]
    assert panel.get_ylabel() == f"way from the\nstart [{unit}]"
    assert np.ptp(panel.get_ylim()) < 1.2 * abs(shown)
    assert panel.lines[0].get_ydata()[-1] == pytest.approx(shown, rel=1e-6)
    assert panel.lines[2].get_label() == "z, from -20 m"
    chart = load_section(trajectory).charts[0]
    assert (chart.unit, chart.curves[0].y[-1]) == (unit, pytest.approx(shown, rel=1e-4))
    assert chart.caption.endswith("z -20 to -20 m")


def test_a_load_that_rests_has_no_way() -> None:
    trajectory = plan([Waypoint([0.1, 0.2, -0.3])] * 2, LIMITS)
    panel = plot_plan(trajectory, "m").axes[0]
    assert panel.get_ylabel().endswith("[m]")
    assert not any(line.get_ydata().any() for line in panel.lines[:3])
