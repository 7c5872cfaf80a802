"""The paper's figures 3, 6 and 7, computed anew."""

from __future__ import annotations

from importlib.resources import files
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from segfmu.cosim import write_csv
from segfmu.cosim.result import replacing
from segfmu.planning import Limits, Trajectory, Waypoint, plan
from segfmu.validation.plots.style import COLOURS, SAMPLES, marks, panels_of, save
from segfmu.validation.units import signal_units

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

# the paper's mission (24) on a rig as in section 4.4
MISSION = Path(str(files("segfmu.validation"))) / "missions" / "paper_rig.toml"
CAPTIONS = {
    3: "Segmented transition profile (paper, Fig. 3)",
    6: "Computed trajectories with second derivatives, three points (paper, Fig. 6)",
    7: "Feedforward force and load position (paper, Fig. 7)",
}
# of (11) and their durations, in the order in which they follow each other
PHASES = ("I.1", "I.c", "I.2", "c", "II.1", "II.c", "II.2")
TIMES = ("T_{1v1}", "T_{1c}", "T_{1v2}", "T_{c}", "T_{2v1}", "T_{2c}", "T_{2v2}")
# by which the paper shows the force smaller
FORCE_SCALE = 0.25


def profile() -> Trajectory:
    """A transition between moving points that has all seven phases of Fig. 3."""
    ends = (Waypoint(0.0, 0.1, 0.25), Waypoint(3.0, 0.2, -0.3))
    return plan(ends, Limits(1.0, 0.8, 1.6), smoothness=4, shape="smoothstep")


def plot_profile(trajectory: Trajectory) -> Figure:
    """Fig. 3: the acceleration, a polynomial (11) or a constant a phase."""
    figure, panel = panels_of(size=(9, 4.2))
    times = np.linspace(0.0, trajectory.duration, SAMPLES)
    panel.plot(times, trajectory(times, 2)[:, 0], color=COLOURS[0])
    starts, lengths, _ = trajectory.pieces(0)
    top = 1.25 * float(trajectory.extrema(2)[1][0])
    for start, length, phase, name in zip(starts, lengths, PHASES, TIMES, strict=True):
        panel.axvline(start, color="#bbbbbb", linewidth=0.8)
        panel.text(
            start + 0.5 * length, top, f"{phase}\n${name}$", ha="center", va="bottom", fontsize=9
        )
    for time, value, name in (
        (0.0, trajectory(0.0, 2)[0], r"$\ddot{y}^*_0$"),
        (trajectory.duration, trajectory(trajectory.duration, 2)[0], r"$\ddot{y}^*_f$"),
    ):
        panel.plot(time, value, "o", color=COLOURS[1])
        panel.annotate(name, (time, value), xytext=(6, -12), textcoords="offset points")
    panel.set_ylim(top=1.6 * top)
    panel.set_ylabel("acceleration [m/s²]")
    return _finished(figure, [panel], trajectory, 3)


def plot_trajectories(trajectory: Trajectory) -> Figure:
    """Fig. 6: positions x and y of the load, and their second derivatives."""
    figure, panels = panels_of(2, sharex=True, size=(9, 6))
    times = np.linspace(0.0, trajectory.duration, SAMPLES)
    for panel, order, label in zip(
        panels, (0, 2), ("position [m]", "acceleration [m/s²]"), strict=True
    ):
        for axis, name in enumerate("xy"):
            curve = f"${name}_p^*$" if order == 0 else rf"$\ddot{{{name}}}_p^*$"
            panel.plot(times, trajectory(times, order)[:, axis], color=COLOURS[axis], label=curve)
        panel.set_ylabel(label)
        panel.legend(loc="center left", bbox_to_anchor=(1.0, 0.5), frameon=False)
    return _finished(figure, list(panels), trajectory, 6)


def plot_forces(rows: NDArray[np.void], trajectory: Trajectory) -> Figure:
    """Fig. 7: the feedforward's force of the bridge, smaller as in the paper, and the load."""
    figure, panel = panels_of(size=(9, 4.2))
    moving = rows[rows["time"] <= trajectory.duration + 0.5]
    time = moving["time"]
    panel.plot(
        time, FORCE_SCALE * moving["force.bridge"], color=COLOURS[1], label=r"$F_x / 4$ [N]"
    )
    panel.plot(
        time, moving["load.position.x"], color=COLOURS[0], label="$x_p$ [m]\n(co-simulated)"
    )
    panel.plot(
        time, moving["reference.load.position.x"], color="black", linestyle=":",
        label="$x_p^*$ [m]",
    )
    panel.set_ylabel("force [N], position [m]")
    panel.legend(loc="center left", bbox_to_anchor=(1.0, 0.5), frameon=False)
    return _finished(figure, [panel], trajectory, 7)


def write_figures(
    folder: Path, trajectory: Trajectory, rows: NDArray[np.void]
) -> list[tuple[Path, str]]:
    """Write the figures, the mission and its co-simulation; returns what each file is."""
    written = []
    for number, figure in (
        (3, plot_profile(profile())), (6, plot_trajectories(trajectory)),
        (7, plot_forces(rows, trajectory)),
    ):
        written.append((folder / f"figure_{number}.png", CAPTIONS[number]))
        save(figure, written[-1][0])
    write_csv(folder / "run.csv", rows, signal_units())
    written.append((folder / "run.csv", "co-simulation of the mission"))
    with replacing(folder / MISSION.name) as temporary:
        temporary.write_bytes(MISSION.read_bytes())
    return [*written, (folder / MISSION.name, "the mission, for segfmu simulate")]


def _finished(figure: Figure, panels: list[Axes], trajectory: Trajectory, number: int) -> Figure:
    for panel in panels:
        marks(panel, trajectory.waypoint_times)
    panels[-1].set_xlabel("time [s]")
    figure.suptitle(CAPTIONS[number], parse_math=False)
    return figure
