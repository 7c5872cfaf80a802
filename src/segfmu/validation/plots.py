"""Plots (PNG): trajectory against limits, setpoints, sway, tracking error, path."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from segfmu.cosim.result import replacing
from segfmu.planning import Trajectory

COLOURS = ("#1f6fb2", "#d9662b", "#3a9b5c")
QUANTITIES = (
    ("position", "m"), ("velocity", "m/s"), ("acceleration", "m/s²"), ("jerk", "m/s³"),
    ("snap", "m/s⁴"),
)
SAMPLES = 3000


def save(figure: Figure, path: Path) -> None:
    """Write a figure as PNG; the file appears when it is complete."""
    try:
        with replacing(path) as temporary:
            figure.savefig(temporary, format="png", dpi=130)
    finally:
        plt.close(figure)


def plot_plan(trajectory: Trajectory, title: str) -> Figure:
    """Position and its derivatives, relative to their limits if there are any."""
    figure, panels = plt.subplots(
        len(QUANTITIES), 1, sharex=True, figsize=(9, 11), layout="constrained"
    )
    times = np.linspace(0.0, trajectory.duration, SAMPLES)
    table = trajectory.limits.table(trajectory.axes, trajectory.smoothness)
    for order, ((quantity, unit), panel) in enumerate(zip(QUANTITIES, panels, strict=True)):
        values = trajectory(times, order)
        limited = order > 0 and bool((table[:, order - 1] > 0.0).all())
        for axis, name in enumerate(trajectory.axis_names):
            scale = 100.0 / table[axis, order - 1] if limited else 1.0
            panel.plot(times, scale * values[:, axis], color=COLOURS[axis % 3], label=name)
        if limited:
            for side in (-100.0, 100.0):
                panel.axhline(side, color="#888888", linestyle="--", linewidth=1.0)
            panel.set_ylim(-115.0, 115.0)
        panel.set_ylabel(f"{quantity}\n[{'% of limit' if limited else unit}]")
        marks(panel, trajectory.waypoint_times)
    panels[0].legend(loc="upper left", ncols=trajectory.axes, frameon=False)
    panels[-1].set_xlabel("time [s]")
    figure.suptitle(title, parse_math=False)
    return figure


def plot_run(rows: NDArray[np.void], waypoint_times: NDArray[np.float64], title: str) -> Figure:
    """Forces, velocities, sway and tracking error of a co-simulation."""
    figure, panels = plt.subplots(4, 1, sharex=True, figsize=(9, 10), layout="constrained")
    time = rows["time"]
    forces, velocities, sway, error = panels
    for i, (drive, rate) in enumerate(
        (("bridge", "bridge.velocity"), ("trolley", "trolley.velocity"), ("hoist", "rope.velocity"))
    ):
        force = rows[f"drive.{drive}.force"]
        label, shift = drive, 0.0
        if drive == "hoist":
            shift = float(force[-1])
            label = f"hoist {-shift:+.2f} N"
        forces.plot(time, force - shift, color=COLOURS[i], label=label)
        velocities.plot(time, rows[rate], color=COLOURS[i], label=drive)
        velocities.plot(time, rows[f"velocity.{drive}"], color="black", linestyle=":", linewidth=1)
    for i, axis in enumerate("xy"):
        sway.plot(time, np.degrees(rows[f"sway.{axis}.angle"]), color=COLOURS[i], label=f"φ{axis}")
        reference = np.degrees(rows[f"reference.sway.{axis}.angle"])
        sway.plot(time, reference, color="black", linestyle=":", linewidth=1)
    for i, axis in enumerate("xyz"):
        error.plot(time, 1e3 * rows[f"error.load.{axis}"], color=COLOURS[i], label=axis)
    for panel, label in zip(
        panels,
        ("force [N]", "velocity [m/s]\n(dotted: setpoint)", "sway [deg]\n(dotted: planned)",
         "load error [mm]"),
        strict=True,
    ):
        panel.set_ylabel(label)
        panel.legend(loc="upper right", ncols=3, frameon=False)
        marks(panel, waypoint_times)
    panels[-1].set_xlabel("time [s]")
    figure.suptitle(title, parse_math=False)
    return figure


def plot_path(trajectory: Trajectory, title: str) -> Figure:
    """The load's path from above and from the side, with the waypoints."""
    figure, panels = plt.subplots(1, 2, figsize=(11, 5), layout="constrained")
    points = trajectory(np.linspace(0.0, trajectory.duration, SAMPLES))
    marks = np.array([w.position for w in trajectory.waypoints])
    for panel, (i, j), label in zip(
        panels, ((0, 1), (0, 2)), ("from above", "from the side"), strict=True
    ):
        panel.plot(points[:, i], points[:, j], color=COLOURS[0])
        panel.plot(marks[:, i], marks[:, j], "o", color=COLOURS[1])
        for number, mark in enumerate(marks, 1):
            panel.annotate(
                str(number), (mark[i], mark[j]), xytext=(5, 6), textcoords="offset points"
            )
        panel.set_title(label)
        panel.set_xlabel(f"{'xyz'[i]} [m]")
        panel.set_ylabel(f"{'xyz'[j]} [m]")
        if np.ptp(points[:, j]) < 0.02 * np.ptp(points[:, i]):
            middle, half = float(points[:, j].mean()), 0.1 * float(np.ptp(points[:, i])) + 1e-3
            panel.set_ylim(middle - half, middle + half)
        _grid(panel)
    figure.suptitle(title, parse_math=False)
    return figure


def marks(panel: Axes, times: Any) -> None:
    """Show times of arrival, and a grid."""
    for time in times:
        panel.axvline(float(time), color="#bbbbbb", linewidth=0.8, zorder=0)
    _grid(panel)


def _grid(panel: Axes) -> None:
    panel.grid(True, color="#eeeeee", zorder=0)
    for side in ("top", "right"):
        panel.spines[side].set_visible(False)
