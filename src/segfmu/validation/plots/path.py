"""Plot of the load's path: from above, and from the side along the motion."""

from __future__ import annotations

from itertools import product
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle
from matplotlib.transforms import Bbox, BboxBase

from segfmu.arrays import FloatArray
from segfmu.planning import Clearance, Trajectory
from segfmu.validation.plots.style import COLOURS, SAMPLES, apart, grid, label, panels_of

# share of a motion across it, below which it is along an axis, or waypoints share a label
STRAIGHT = 0.02
# a motion below this share of the places is none, and drawn as one of this size [m]
NOISE = 1e-9
STANDING = 5.0
# where a label can be from its waypoint [points], the first one that is free, of the path as well
# if there is one
PLACES = tuple((across, up) for up in (6, -6) for across in (5, -5))


def plot_path(trajectory: Trajectory, title: str, clearance: Clearance) -> Figure:
    """The load's path from above and from the side, with waypoints and obstacles.

    The side view has the horizontal direction of the motion as its abscissa; obstacles are in it as
    their widest section along this direction.
    """
    points = trajectory(np.linspace(0.0, trajectory.duration, SAMPLES))
    stops = np.array([w.position for w in trajectory.waypoints])
    direction, name = motion(stops)
    figure, (above, side) = panels_of(1, 2, size=(12, 5.2))
    top = np.array([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
    section = np.array([direction, [0.0, 0.0, 1.0]])
    _view(above, points, stops, top, clearance)
    _view(side, points, stops, section, clearance)
    above.set(title="from above", xlabel="x [m]", ylabel="y [m]")
    side.set(title="from the side", xlabel=f"{name} [m]", ylabel="z [m]")
    figure.suptitle(label(title))
    figure.draw_without_rendering()
    size = _size(points)
    for panel, view in ((above, top), (side, section)):
        _name(panel, labels(stops @ view.T, size), points @ view.T, figure.bbox)
    return figure


def motion(stops: FloatArray) -> tuple[FloatArray, str]:
    """Horizontal direction (3,) of the motion through waypoints (n, 3), and its name."""
    flat = stops[:, :2] - stops[:, :2].mean(axis=0)
    along = np.linalg.svd(flat, full_matrices=True)[2][0]
    along = along * np.sign(along[np.abs(along).argmax()])
    for axis, name in enumerate("xy"):
        if abs(along[1 - axis]) < STRAIGHT:
            return np.eye(3)[axis], name
    angle = np.degrees(np.arctan2(along[1], along[0]))
    return np.append(along, 0.0), f"along the motion, {angle:.0f} deg from x"


def labels(marks: FloatArray, size: float) -> list[tuple[str, FloatArray]]:
    """Numbers of waypoints (n, 2) and their places; those that lie at one place have one label."""
    found: list[tuple[list[str], FloatArray]] = []
    for number, mark in enumerate(marks, 1):
        near = [names for names, place in found if np.hypot(*(mark - place)) <= STRAIGHT * size]
        if near:
            near[0].append(str(number))
        else:
            found.append(([str(number)], mark))
    return [(", ".join(names), place) for names, place in found]


def _view(
    panel: Axes, points: FloatArray, stops: FloatArray, view: FloatArray, clearance: Clearance
) -> None:
    """The path as seen in two directions (2, 3)."""
    for box in clearance.obstacles:
        corners = np.array(np.meshgrid(*zip(box.minimum, box.maximum, strict=True))).reshape(3, -1)
        low, high = (view @ corners).min(axis=1), (view @ corners).max(axis=1)
        panel.add_patch(Rectangle(
            (low[0], low[1]), high[0] - low[0], high[1] - low[1], facecolor="#cccccc",
            edgecolor="#888888", label=box.name,
        ))
    path, marks = points @ view.T, stops @ view.T
    panel.plot(*path.T, color=COLOURS[0])
    panel.plot(*marks.T, "o", color=COLOURS[1])
    size = _size(points)
    for limits, values in ((panel.set_xlim, path[:, 0]), (panel.set_ylim, path[:, 1])):
        middle = 0.5 * float(values.min() + values.max())
        # a motion across the view is not enlarged to noise
        half = max(0.55 * float(np.ptp(values)), 0.1 * size)
        limits(middle - half, middle + half)
    apart(panel)
    grid(panel)


def _name(
    panel: Axes, names: list[tuple[str, FloatArray]], path: FloatArray, room: BboxBase
) -> None:
    """Write the numbers of waypoints where there is room, those of the ends first."""
    taken: list[Bbox] = []
    curve = panel.transData.transform(path)
    for text, (x, y) in [names[0], *names[:0:-1][:1], *names[1:-1]]:
        for over, (across, up) in product((False, True), PLACES):
            style: dict[str, Any] = {
                "ha": "left" if across > 0 else "right", "va": "bottom" if up > 0 else "top",
                "usetex": False,
            }
            number = panel.annotate(
                text, (x, y), xytext=(across, up), textcoords="offset points", **style
            )
            # the layout stays that in which it was placed
            number.set_in_layout(False)
            own = number.get_window_extent()
            inside = own.x0 >= room.x0 and own.x1 <= room.x1
            clear = over or not own.count_contains(curve)
            if inside and clear and not own.count_overlaps(taken):
                taken.append(own)
                break
            number.remove()


def _size(points: FloatArray) -> float:
    """Greatest extent of a path (n, 3) along an axis, or that of the view of a load that rests."""
    size = float(np.ptp(points, axis=0).max())
    return size if size > NOISE * float(np.abs(points).max()) else STANDING
