"""Names of users in figures: long ones, and ones that could be taken for mathematics."""

from __future__ import annotations

import warnings
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pyarrow
import pytest
from matplotlib.figure import Figure

from segfmu import CampaignResult, Clearance, Limits, Waypoint, plan
from segfmu.validation.plots.campaign import plot_campaign
from segfmu.validation.plots.path import plot_path
from segfmu.validation.plots.plan import plot_plan
from segfmu.validation.plots.style import label
from segfmu.validation.suite_plots import plot_margins
from tests.campaign import soaked

# as long as a name can be
LONG = ("a name that somebody wrote in full sentences " * 3)[:100]
MATHS = r"from $5 to $\frac_{x and \$ 7"


def margins(name: str) -> Figure:
    finding = SimpleNamespace(name=name, normalised=0.3)
    scenario = SimpleNamespace(file=SimpleNamespace(name=name))
    result: Any = SimpleNamespace(scenario=scenario, findings=[finding] * 3)
    return plot_margins([result, result])


def campaign(name: str) -> Figure:
    table = pyarrow.table({
        "run": [0, 1, 2], "scenario": ["s"] * 3, "passed": [True] * 3, "error": [None] * 3,
        name: [0.1, 0.2, 0.3], f"margin.{name}": [0.00775, 0.00875, 0.00975],
        f"holds.{name}": [True, False, True],
    })
    return plot_campaign(CampaignResult(name, Path(), (name,), (name,), table))


def test_runs_of_a_campaign_are_counted_whole() -> None:
    left = campaign("a").axes[0]
    assert all(float(place).is_integer() for place in left.get_yticks())


def motion(name: str, plot: Any, *more: Any) -> Figure:
    points = [Waypoint([0.0, 0.0, -2.0]), Waypoint([1.0, 0.0, -2.0])]
    figure: Figure = plot(plan(points, Limits(1.0, 1.0, 5.0)), name, *more)
    return figure


@pytest.mark.parametrize("name", [LONG, MATHS, *soaked(LONG.upper())])
@pytest.mark.parametrize("plot", [
    margins, campaign, lambda name: motion(name, plot_plan),
    lambda name: motion(name, plot_path, Clearance([])),
], ids=["margins", "campaign", "plan", "path"])
def test_names_are_within_the_figure(plot: Any, name: str, tmp_path: Path) -> None:
    figure = plot(name)
    with warnings.catch_warnings():
        # of panels without room
        warnings.simplefilter("error")
        figure.savefig(tmp_path / "figure.png")
    whole = figure.get_tightbbox()
    wide, high = figure.get_size_inches()
    assert whole.x0 > -0.01 and whole.x1 < wide + 0.01
    assert whole.y0 > -0.01 and whole.y1 < high + 0.01
    for panel in figure.axes:
        boxes = [text.get_window_extent() for text in panel.get_xticklabels()]
        assert not any(box.count_overlaps(boxes[:i]) for i, box in enumerate(boxes))
    assert all(panel.get_window_extent().width > 100.0 for panel in figure.axes)


def test_a_label_is_what_it_says() -> None:
    drawn = Figure().text(0.0, 0.0, label(MATHS))
    assert drawn._preprocess_math(drawn.get_text()) == (MATHS, False)
    assert label(" ".join(["word"] * 8), 20).count("\n") == 1
