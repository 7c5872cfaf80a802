"""The path is seen along its motion, with what stands in its way."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from matplotlib.text import Text

from segfmu import Clearance, Limits, Obstacle, Waypoint, plan
from segfmu.validation.plots.path import motion, plot_path
from tests.campaign import soaked_rows


@pytest.mark.parametrize(("end", "direction", "name"), [
    ([4.0, 0.0, 1.0], [1.0, 0.0, 0.0], "x"),
    ([0.0, -45.0, 1.0], [0.0, 1.0, 0.0], "y"),
    ([0.0, 0.0, 1.0], [1.0, 0.0, 0.0], "x"),
    ([3.0, 4.0, 0.0], [0.6, 0.8, 0.0], "along the motion, 53 deg from x"),
    ([-3.0, 4.0, 0.0], [-0.6, 0.8, 0.0], "along the motion, 127 deg from x"),
])
def test_direction_of_the_side_view(end: list[float], direction: list[float], name: str) -> None:
    found = motion(np.array([[0.0, 0.0, 0.0], end]))
    assert found[0] == pytest.approx(direction)
    assert found[1] == name


def test_a_motion_along_y_is_seen_from_the_side_with_its_obstacle() -> None:
    points = [Waypoint([0.0, 0.0, -2.0]), Waypoint([0.0, 5.0, -1.0])]
    trajectory = plan(points, Limits(1.0, 1.0, 5.0, 50.0))
    stack = Obstacle("stack", [-1.0, 2.0, -3.0], [1.0, 3.0, -2.5])
    side = plot_path(trajectory, "move", Clearance([stack])).axes[1]
    curve = side.lines[0].get_xydata()
    assert side.get_xlabel() == "y [m]"
    assert curve[0] == pytest.approx([0.0, -2.0])
    assert curve[-1] == pytest.approx([5.0, -1.0])
    (box,) = side.patches
    assert (box.get_xy(), box.get_width(), box.get_height()) == ((2.0, -3.0), 1.0, 0.5)


def test_waypoints_at_one_place_of_a_view_share_a_label() -> None:
    points = [Waypoint([0.0, 0.0, -2.0]), Waypoint([0.0, 0.0, -1.0]), Waypoint([0.0, 1.0, -2.0])]
    trajectory = plan(points, Limits(1.0, 1.0, 5.0, 50.0))
    panels = plot_path(trajectory, "move", Clearance([])).axes
    above, side = ([(t.get_text(), t.xy) for t in panel.texts] for panel in panels)
    assert [text for text, _ in above] == ["1, 2", "3"]
    assert sorted(text for text, _ in side) == ["1", "2", "3"]
    assert above[1][1] == pytest.approx([0.0, 1.0])


def test_numbers_are_beside_the_path() -> None:
    """That of a waypoint on a slope lay on the curve."""
    points = [Waypoint([0.0, 0.0, -2.0]), Waypoint([1.0, 1.2, -1.5]), Waypoint([2.0, 2.4, -2.0])]
    figure = plot_path(plan(points, Limits(1.0, 1.0, 5.0, 50.0)), "move", Clearance([]))
    for panel in figure.axes:
        curve = panel.transData.transform(panel.lines[0].get_xydata())
        assert len(panel.texts) == 3
        assert not any(t.get_window_extent().count_contains(curve) for t in panel.texts)


@pytest.mark.parametrize("moved", [0.0, 1e-13])
def test_a_load_that_rests_is_seen_in_a_view_of_a_metre(moved: float) -> None:
    points = [Waypoint([100.0, 0.0, -2.0]), Waypoint([100.0 + moved, 0.0, -2.0])]
    trajectory = plan(points, Limits(1.0, 1.0, 5.0, 50.0))
    for panel in plot_path(trajectory, "rest", Clearance([])).axes:
        assert np.diff(panel.get_xlim()) == pytest.approx(1.0)
        assert np.diff(panel.get_ylim()) == pytest.approx(1.0)


def test_titles_of_any_script_are_drawn_without_warnings(tmp_path: Path) -> None:
    trajectory = plan([Waypoint([0.0, 0.0, -2.0]), Waypoint([1.0, 0.0, -2.0])],
                      Limits(1.0, 1.0, 5.0))
    plot_path(trajectory, "\u6b66\u6c49 \U0001f3d7", Clearance([])).savefig(tmp_path / "path.png")
    assert (tmp_path / "path.png").stat().st_size > 0


def crossings(texts: list[Text]) -> list[str]:
    """Texts of a drawn figure that lie on one before them."""
    boxes = [text.get_window_extent() for text in texts]
    return [t.get_text() for i, t in enumerate(texts) if boxes[i].count_overlaps(boxes[:i])]


@pytest.mark.parametrize(("wide", "away"), [
    (1e-3, 0.0), (40.0, 1234.5),
    *soaked_rows((1e-3, 1234.5), (40.0, 0.0), (1.0, 0.0), (1.0, 1234.5)),
])
def test_numbers_of_waypoints_and_axes_are_apart(wide: float, away: float, tmp_path: Path) -> None:
    places = np.random.default_rng(7).normal(size=(40, 3)) * [0.0, wide, 0.3 * wide]
    points = [Waypoint(away + place - [0.0, 0.0, away + 2.0 + 3.0 * wide]) for place in places]
    trajectory = plan(points, Limits(wide, wide, 5.0 * wide, 50.0 * wide))
    figure = plot_path(trajectory, "many", Clearance([]))
    figure.savefig(tmp_path / "path.png")
    for panel in figure.axes:
        numbers = [t.get_text() for t in panel.texts]
        assert not crossings(panel.texts) and not crossings(panel.get_xticklabels())
        assert "1" in numbers[0].split(", ") and len(numbers) > 3
        for text in panel.texts:
            assert figure.bbox.x0 <= text.get_window_extent().x0
            assert text.get_window_extent().x1 <= figure.bbox.x1
