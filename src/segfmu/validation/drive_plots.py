"""Plot of what a plan asks of the drives, against their bounds."""

from __future__ import annotations

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.figure import Figure

from segfmu.crane import ActuatorBounds, Crane
from segfmu.crane.bounds import DRIVES, UNITS
from segfmu.crane.demand import demands
from segfmu.kernels.crane.records import Demand
from segfmu.planning import Trajectory
from segfmu.planning.arrays import FloatArray
from segfmu.validation.files.units import scale
from segfmu.validation.plots import COLOURS, SAMPLES, marks

PANELS = (
    ("velocity", Demand.VELOCITY, DRIVES), ("acceleration", Demand.ACCELERATION, DRIVES),
    ("force", Demand.FORCE, DRIVES), ("power", Demand.POWER, DRIVES),
    ("sway angle", Demand.SWAY, ("φx", "φy")),
)


def plot_drives(
    crane: Crane, trajectory: Trajectory, bounds: ActuatorBounds, title: str
) -> Figure:
    """Velocity, acceleration, force and power of the drives, and the sway; bounds dashed.

    The hoist's force is shown without the load's weight, as the difference between pull and weight.
    """
    figure, panels = plt.subplots(
        len(PANELS), 1, sharex=True, figsize=(10, 12), layout="constrained"
    )
    times = np.linspace(0.0, trajectory.duration, SAMPLES)
    values = demands(crane, trajectory, times)
    limits = bounds.vector
    weight = crane.payload_mass * crane.gravity
    for panel, (quantity, first, names) in zip(panels, PANELS, strict=True):
        columns = slice(first, first + len(names))
        shown: FloatArray = values[:, columns].copy()
        upper, lower = limits[columns].copy(), -limits[columns]
        labels = list(names)
        if quantity == "force":
            # the rope only pulls: from no tension to the bound
            shown[:, 2], upper[2], lower[2] = -shown[:, 2] - weight, upper[2] - weight, -weight
            labels[2] = "hoist less weight"
        factor, unit = scale(float(np.abs(shown).max()), UNITS[quantity])
        for i, label in enumerate(labels):
            panel.plot(times, factor * shown[:, i], color=COLOURS[i], label=label)
            for bound in (upper[i], lower[i]):
                if np.isfinite(limits[columns][i]):
                    panel.axhline(
                        factor * bound, color=COLOURS[i], linestyle="--", linewidth=1.0
                    )
        panel.set_ylabel(f"{quantity} [{unit}]")
        panel.legend(loc="upper left", bbox_to_anchor=(1.0, 1.0), frameon=False)
        marks(panel, trajectory.waypoint_times)
    panels[-1].set_xlabel("time [s]")
    figure.suptitle(title, parse_math=False)
    return figure
