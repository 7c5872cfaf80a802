"""Plot of a plan: the way from its start, and its derivatives against their limits."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from segfmu.arrays import FloatArray
from segfmu.planning import Trajectory
from segfmu.validation.plots.style import COLOURS, SAMPLES, finish, legend, stack
from segfmu.validation.units import resting, ways_from_start

QUANTITIES = (
    ("velocity", "m/s"), ("acceleration", "m/s²"), ("jerk", "m/s³"),
    ("snap", "m/s⁴"),
)
# [% of limit] where the axis ends
EDGE = 115.0


def plot_plan(trajectory: Trajectory, title: str, given: bool = True) -> Figure:
    """The way from the start, and its derivatives, relative to their limits if there are any.

    given: whether the limits are the mission's, not those of the search within the drives' bounds.
    """
    figure, panels = stack(1 + len(QUANTITIES))
    times = np.linspace(0.0, trajectory.duration, SAMPLES)
    table = trajectory.limits.sides(trajectory.axes, trajectory.smoothness)
    rests = resting(trajectory)
    _way(panels[0], trajectory, times)
    for order, ((quantity, unit), panel) in enumerate(zip(QUANTITIES, panels[1:], strict=True), 1):
        values = trajectory(times, order)
        limited = bool((table[0, :, order - 1] > 0.0).all())
        for axis, (name, rest) in enumerate(zip(trajectory.axis_names, rests, strict=True)):
            label, column = name, values[:, axis]
            # for an axis that rests no limits are searched for
            if limited and (given or not rest):
                upper, lower = table[:, axis, order - 1].tolist()
                label = f"{name}, of {upper:.4g} {unit}"
                if lower != upper:
                    label = f"{name}, of -{lower:.4g} to {upper:.4g} {unit}"
                column = 100.0 * column / np.where(column < 0.0, lower, upper)
            panel.plot(times, column, color=COLOURS[axis % len(COLOURS)], label=label)
        if limited:
            for low, high in ((100.0, EDGE), (-EDGE, -100.0)):
                panel.axhspan(low, high, color="#888888", alpha=0.25, linewidth=0.0)
            panel.set_ylim(-EDGE, EDGE)
        panel.set_ylabel(f"{quantity}\n[{'% of limit' if limited else unit}]")
        legend(panel)
    return finish(figure, panels, trajectory.waypoint_times, title)


def _way(panel: Axes, trajectory: Trajectory, times: FloatArray) -> None:
    """The way of each axis: beside where it is, a short one would be flat."""
    ways, factor, unit = ways_from_start(trajectory, times)
    for axis, (name, start) in enumerate(zip(trajectory.axis_names, trajectory(0.0), strict=True)):
        panel.plot(
            times, factor * ways[:, axis], color=COLOURS[axis % len(COLOURS)],
            label=f"{name}, from {start:.4g} m",
        )
    panel.set_ylabel(f"way from the\nstart [{unit}]")
    legend(panel)
