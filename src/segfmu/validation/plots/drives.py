"""Plot of what a motion asks of the drives, against their bounds."""

from __future__ import annotations

from collections.abc import Sequence
from textwrap import wrap

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from segfmu.arrays import FloatArray
from segfmu.crane import ActuatorBounds, Friction
from segfmu.crane.bounds import DRIVES, UNITS
from segfmu.crane.contacts import NONE
from segfmu.crane.demand import demands
from segfmu.crane.kinds import AnyCrane
from segfmu.kernels.crane.records import Demand
from segfmu.planning import Trajectory
from segfmu.validation.plots.style import COLOURS, SAMPLES, finish, legend, stack
from segfmu.validation.units import pretty, scale
from segfmu.validation.units import shown as in_unit

PANELS = (
    ("velocity", Demand.VELOCITY, DRIVES), ("acceleration", Demand.ACCELERATION, DRIVES),
    ("force", Demand.FORCE, DRIVES), ("power", Demand.POWER, DRIVES),
    ("sway angle", Demand.SWAY, ("φx", "φy")),
)
# where the axis of force ends, over what is above: a rope without tension may be far below
FARTHEST = 1.5
BOUNDS = "dashed: bounds of the drives"
# a panel's largest value below its nearest bound by this factor is shown without the bounds, which
# the legend has; below it by the other one it is noise
FAR, NOISE = 8.0, 1e-6
# characters of a line of the legend, which takes its width from the panels
LINE = 28
# of these lines [line widths]; where those of several drives lie in one place, the dashes
# of each are in the gaps of the others
DASH, GAP = 6.0, 12.0


def plot_drives(
    crane: AnyCrane, trajectory: Trajectory, bounds: ActuatorBounds, title: str,
    friction: Friction = NONE,
) -> Figure:
    """Velocity, acceleration, force and power of the drives, and the sway; bounds dashed."""
    figure, panels = stack(len(PANELS))
    times = np.linspace(0.0, trajectory.duration, SAMPLES)
    needs = demands(crane, trajectory, times, friction, bounds.lag)
    draw_demands(panels, times, needs, bounds, crane)
    return finish(figure, panels, trajectory.waypoint_times, title, BOUNDS)


def draw_demands(
    panels: Sequence[Axes], times: FloatArray, values: FloatArray, bounds: ActuatorBounds,
    crane: AnyCrane,
) -> list[float]:
    """Draw demands (times, 17) in the panels of `PANELS`; returns the factor of each panel.

    The hoist's force is shown without the weight on the rope, as the difference of the pull to it.
    """
    limits = bounds.table
    weight = crane.weight
    factors = []
    for panel, (quantity, first, names) in zip(panels, PANELS, strict=True):
        columns = slice(first, first + len(names))
        shown: FloatArray = values[:, columns].copy()
        upper, lower = limits[0, columns].copy(), -limits[1, columns]
        labels = list(names)
        if quantity == "force":
            # the rope only pulls: from no tension to the bound
            shown[:, 2], upper[2] = -shown[:, 2] - weight, -lower[2] - weight
            lower[2] = -weight if np.isfinite(upper[2]) else -np.inf
            labels[2] = "hoist less weight"
        known = np.abs([b for b in (*upper, *lower) if np.isfinite(b)])
        peak, nearest = float(np.abs(shown).max()), float(known.min(initial=np.inf))
        # what is near rest would be a line between bounds; what is noise is one
        small = NOISE * nearest < peak < nearest / FAR and known.size > 0
        largest = peak if small else float(known.max(initial=peak))
        factor, unit = scale(largest, UNITS[quantity])
        for i, label in enumerate(labels):
            bound = _bounds(lower[i], upper[i], UNITS[quantity]) if small else ""
            told = "\n".join(wrap(f"{label}{bound}", LINE))
            panel.plot(times, factor * shown[:, i], color=COLOURS[i], label=told)
            for bound in filter(np.isfinite, (upper[i], lower[i])):
                panel.axhline(
                    factor * bound, color=COLOURS[i], linestyle=(i * DASH, (DASH, GAP)),
                    linewidth=1.0,
                )
        if quantity == "force" and np.isfinite(upper[2]):
            near = max(upper[2], float(np.abs(shown).max()))
            panel.set_ylim(bottom=max(panel.get_ylim()[0], -FARTHEST * factor * near))
        if small:
            panel.set_ylim(-FARTHEST * factor * peak, FARTHEST * factor * peak)
        panel.set_ylabel(f"{quantity}\n[{unit}]")
        legend(panel)
        factors.append(factor)
    return factors


def _bounds(low: float, high: float, unit: str) -> str:
    """The end of a label: bounds that are out of view."""
    known = [bound for bound in (low, high) if np.isfinite(bound)]
    if not known:
        return ""
    values, name = in_unit(known, unit)
    told = " to ".join(map(pretty, values)) if low != -high else pretty(values[-1])
    return f", of {told} {name}"
