"""A small picture of a trajectory for notebooks, as SVG, without a plotting library."""

from __future__ import annotations

from html import escape
from typing import Protocol

import numpy as np
from numpy.typing import ArrayLike

from segfmu.arrays import FloatArray

# dark enough for text on white, on which all is drawn: notebooks may be dark
COLOURS, SOFT = ("#0072b2", "#b84a00", "#00734f", "#8a5aa8"), "#595959"
PANELS = (("position", "m"), ("velocity", "m/s"), ("acceleration", "m/s²"))
POINTS = 240
# pixels
WIDTH, HEIGHT, LEFT, GAP = 560, 88, 96, 14
# share of the largest value below which another one is none
ROUNDING = 1e-12


class Motion(Protocol):
    """What is drawn."""

    @property
    def axis_names(self) -> tuple[str, ...]: ...

    @property
    def duration(self) -> float: ...

    @property
    def waypoint_times(self) -> FloatArray: ...

    def __call__(self, t: ArrayLike, derivative: int = 0) -> FloatArray: ...


def sketch(motion: Motion, title: str) -> str:
    """Position, velocity and acceleration over time; vertical lines at the waypoints."""
    times = np.linspace(0.0, motion.duration, POINTS)
    rows = [
        _panel(order * (HEIGHT + GAP) + 22, name, unit, times, motion(times, order), motion)
        for order, (name, unit) in enumerate(PANELS)
    ]
    names = " ".join(
        f'<tspan fill="{COLOURS[i % len(COLOURS)]}">{escape(name)}</tspan>'
        for i, name in enumerate(motion.axis_names)
    )
    bottom = len(PANELS) * (HEIGHT + GAP) + 36
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{LEFT + WIDTH + 10}" '
        f'height="{bottom + 4}" font-family="sans-serif" font-size="12" role="img" '
        f'aria-label="{escape(title)}">'
        '<rect width="100%" height="100%" fill="#ffffff"/>'
        f'<text x="0" y="13">{escape(title)}   {names}</text>{"".join(rows)}'
        f'<text x="{LEFT}" y="{bottom}">0 s</text>'
        f'<text x="{LEFT + WIDTH}" y="{bottom}" text-anchor="end">{motion.duration:.4g} s</text>'
        "</svg>"
    )


def _panel(
    top: float, name: str, unit: str, times: FloatArray, values: FloatArray, motion: Motion
) -> str:
    least, most = float(values.min()), float(values.max())
    noise = ROUNDING * max(abs(least), abs(most))
    least, most = (0.0 if abs(value) <= noise else value for value in (least, most))
    span = most - least if most > least else 1.0
    across = LEFT + WIDTH * times / max(motion.duration, 1e-300)
    marks = "".join(
        f'<path d="M{LEFT + WIDTH * t / max(motion.duration, 1e-300):.1f},{top}v{HEIGHT}" '
        'stroke="#bbbbbb"/>'
        for t in motion.waypoint_times
    )
    curves = "".join(
        f'<polyline fill="none" stroke="{COLOURS[i % len(COLOURS)]}" stroke-width="1.5" points="'
        + " ".join(f"{x:.1f},{top + HEIGHT * (most - y) / span:.1f}"
                   for x, y in zip(across, column, strict=True))
        + '"/>'
        for i, column in enumerate(values.T)
    )
    scale = "".join(
        f'<text x="{LEFT - 6}" y="{y}" text-anchor="end" fill="{SOFT}">{value:.3g}</text>'
        for y, value in ((top + 10, most), (top + HEIGHT, least))
    )
    return (
        f'{marks}{curves}{scale}<text x="0" y="{top + 0.5 * HEIGHT:.0f}">{name}</text>'
        f'<text x="0" y="{top + 0.5 * HEIGHT + 15:.0f}" fill="{SOFT}">{unit}</text>'
    )
