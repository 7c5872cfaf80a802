"""Plot of a co-simulation: drives against their bounds, sway, tracking error."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from segfmu.arrays import FloatArray
from segfmu.crane import ActuatorBounds
from segfmu.crane.bounds import DRIVES
from segfmu.crane.kinds import AnyCrane
from segfmu.validation.criteria import angles
from segfmu.validation.drive_use import SWAYS, run_demands
from segfmu.validation.plots.drives import BOUNDS, PANELS, draw_demands
from segfmu.validation.plots.style import COLOURS, finish, legend, stack

# [m] errors below this are numerical noise, which is not enlarged to a landscape
NOISE = 1e-9
# [m] errors below this are in micrometres
SMALL = 1e-5
DOTTED: dict[str, Any] = {"color": "black", "linestyle": ":", "linewidth": 1.0}
QUANTITIES = [quantity for quantity, _, _ in PANELS]
VELOCITY, SWAY = QUANTITIES.index("velocity"), QUANTITIES.index("sway angle")


def plot_run(
    rows: NDArray[np.void], waypoint_times: FloatArray, title: str,
    crane: AnyCrane, bounds: ActuatorBounds,
) -> Figure:
    """Drives with setpoints and bounds, sway with the planned one, tracking error of the load."""
    figure, panels = stack(len(PANELS) + 1)
    time = rows["time"]
    factors = draw_demands(panels[:-1], time, run_demands(rows), bounds, crane)
    for drive in DRIVES:
        panels[VELOCITY].plot(time, factors[VELOCITY] * rows[f"velocity.{drive}"], **DOTTED)
    for signal in angles(rows):
        if signal not in SWAYS:
            link, axis, _ = signal.split(".")
            panels[SWAY].plot(
                time, factors[SWAY] * rows[signal], color=COLOURS["xy".index(axis)],
                linestyle="--", label=f"ψ{axis}, {link}",
            )
        panels[SWAY].plot(time, factors[SWAY] * rows[f"reference.{signal}"], **DOTTED)
    for panel, what in ((panels[VELOCITY], "setpoint"), (panels[SWAY], "planned")):
        panel.plot([], [], label=what, **DOTTED)
        legend(panel)
    _errors(panels[-1], rows)
    return finish(figure, panels, waypoint_times, title, BOUNDS)


def _errors(panel: Axes, rows: NDArray[np.void]) -> None:
    errors = {axis: rows[f"error.load.{axis}"] for axis in "xyz"}
    # the distance, as the measures of a run have it
    largest = float(np.sqrt(sum(error * error for error in errors.values())).max())
    factor, unit = (1e6, "µm") if NOISE <= largest < SMALL else (1e3, "mm")
    for colour, (axis, error) in zip(COLOURS, errors.items(), strict=True):
        panel.plot(rows["time"], factor * error, color=colour, label=axis)
    panel.set_ylabel(f"load error\n[{unit}]")
    noise = largest < NOISE
    legend(panel, "below 1e-6 mm" if noise else "")
    if noise:
        panel.set_ylim(-1e3 * NOISE, 1e3 * NOISE)
