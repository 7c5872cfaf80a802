"""What a trajectory, limits and a flat inverse look like at a prompt and in a notebook."""

from __future__ import annotations

import xml.etree.ElementTree as ET

import numpy as np
import pytest
from numpy.typing import ArrayLike

from segfmu import Crane, FlatInverse, Limits, Trajectory, Waypoint, plan
from segfmu.arrays import FloatArray
from segfmu.planning.sketch import HEIGHT, LEFT, POINTS, WIDTH, sketch

SVG = "{http://www.w3.org/2000/svg}"


@pytest.fixture(scope="module")
def trajectory() -> Trajectory:
    points = [Waypoint([0, 0, -5]), Waypoint([3, 0, -4]), Waypoint([30, 4, -5])]
    return plan(points, Limits(1, 1, 4, 20), axis_names=("x", "y", "<z>"))


def test_reprs_are_short(trajectory: Trajectory) -> None:
    assert repr(trajectory) == (
        f"<Trajectory of x, y, <z>: 3 waypoints, {trajectory.duration:.6g} s, smoothness 4, "
        "plateau>"
    )
    assert repr(Limits([1, 2], 3)) == "Limits(velocity=[1.0, 2.0], acceleration=3.0)"
    assert eval(repr(Limits(1, 2, 3))).jerk == 3.0
    inverse = FlatInverse(Crane(300e3, 15e3, 40e3), trajectory)
    assert "Crane(bridge_mass=300000.0" in repr(inverse) and "Trajectory" in repr(inverse)


def test_the_picture_shows_the_curves(trajectory: Trajectory) -> None:
    picture = ET.fromstring(trajectory._repr_svg_())
    curves = [c.attrib["points"].split() for c in picture.iter(f"{SVG}polyline")]
    assert len(curves) == 9 and all(len(c) == POINTS for c in curves)
    x = np.array([[float(v) for v in p.split(",")] for p in curves[0]])
    assert np.allclose(x[[0, -1], 0], [LEFT, LEFT + WIDTH])
    # the position of x reaches from the lowest to the highest place but for z below it
    position = trajectory(np.linspace(0.0, trajectory.duration, POINTS))
    expected = (position[:, 0].max() - position[:, 0]) / np.ptp(position) * HEIGHT
    assert np.allclose(x[:, 1] - x[:, 1].min(), expected, atol=0.11)
    assert "<z>" in "".join(picture.itertext())


def test_the_picture_is_read_on_a_dark_page() -> None:
    """Texts were black, without a ground of their own."""
    still = plan([Waypoint([0.0]), Waypoint([1.0])], Limits(1, 1, 1))
    first = next(iter(ET.fromstring(still._repr_svg_())))
    assert (first.tag, first.attrib["fill"]) == (f"{SVG}rect", "#ffffff")


def test_rounding_is_no_number_of_the_picture() -> None:
    """-7.32e-17 m/s was told as the least velocity."""
    moved = plan([Waypoint([0.0]), Waypoint([1.0])], Limits(1, 1, 1))

    class Noisy:
        axis_names, duration, waypoint_times = ("x",), moved.duration, moved.waypoint_times

        def __call__(self, t: ArrayLike, derivative: int = 0) -> FloatArray:
            return moved(t, derivative) - 7.32e-17

    assert "e-17" not in sketch(Noisy(), "")


def test_a_trajectory_that_stays_has_a_picture() -> None:
    still = plan([Waypoint([1.0, 0.0]), Waypoint([1.0, 2.0])], Limits(1, 1, 1))
    assert "nan" not in still._repr_svg_()
