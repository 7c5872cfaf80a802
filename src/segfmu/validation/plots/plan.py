"""Plot of a plan: position and its derivatives, against their limits."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from segfmu.planning import Trajectory
from segfmu.validation.plots.style import COLOURS, SAMPLES, finish, legend, stack

QUANTITIES = (
    ("position", "m"), ("velocity", "m/s"), ("acceleration", "m/s²"), ("jerk", "m/s³"),
    ("snap", "m/s⁴"),
)
# [% of limit] where the axis ends
EDGE = 115.0


def plot_plan(trajectory: Trajectory, title: str) -> Figure:
    """Position and its derivatives, relative to their limits if there are any."""
    figure, panels = stack(len(QUANTITIES))
    times = np.linspace(0.0, trajectory.duration, SAMPLES)
    table = trajectory.limits.sides(trajectory.axes, trajectory.smoothness)
    for order, ((quantity, unit), panel) in enumerate(zip(QUANTITIES, panels, strict=True)):
        values = trajectory(times, order)
        limited = order > 0 and bool((table[0, :, order - 1] > 0.0).all())
        for axis, name in enumerate(trajectory.axis_names):
            label, column = name, values[:, axis]
            if limited:
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
