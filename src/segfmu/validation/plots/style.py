"""What all plots share: colours, units, legends beside the curves, marks of arrivals."""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from io import BytesIO
from pathlib import Path
from textwrap import wrap
from typing import Any

from matplotlib import rc_context
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.text import Text

from segfmu.cosim.result import replacing
from segfmu.validation.texts import encodable

# of Okabe and Ito, which colour-blind readers tell apart
COLOURS = ("#0072b2", "#d55e00", "#009e73")
SAMPLES = 3000


def save(figure: Figure, path: Path) -> None:
    """Write a figure as PNG; the file appears when it is complete."""
    with replacing(path) as temporary:
        _print(figure, temporary, 130.0)


def _print(figure: Figure, target: Path | BytesIO, resolution: float) -> None:
    """As `savefig`, which draws a figure that has a layout twice."""
    canvas, usual = figure.canvas, figure.dpi
    try:
        figure.set_dpi(resolution)
        FigureCanvasAgg(figure).print_png(target)
    finally:
        figure.set_dpi(usual)
        figure.set_canvas(canvas)


class Picture(Figure):
    """A figure that notebooks show and that no window is opened for."""

    def draw(self, renderer: Any) -> None:
        """As of any figure; characters that its font does not have are boxes, without a warning.

        Texts are none of LaTeX, also where the user's others are.
        """
        with warnings.catch_warnings(), rc_context({"text.usetex": False}):
            for text in self.findobj(Text):
                text.set_usetex(False)
            warnings.filterwarnings("ignore", r"Glyph \d+", UserWarning)
            super().draw(renderer)

    def _repr_png_(self) -> bytes:
        data = BytesIO()
        _print(self, data, 90.0)
        return data.getvalue()


def panels_of(
    rows: int = 1, columns: int = 1, *, size: tuple[float, float], sharex: bool = False,
    sharey: bool = False,
) -> tuple[Figure, Any]:
    """A figure of this size [inch] and its panels, as `pyplot.subplots` gives them."""
    figure = Picture(figsize=size, layout="constrained")
    return figure, figure.subplots(rows, columns, sharex=sharex, sharey=sharey)


def stack(count: int, height: float = 2.2) -> tuple[Figure, list[Axes]]:
    """A figure with panels below each other over one axis of time."""
    figure, panels = panels_of(count, sharex=True, size=(10, height * count + 0.8))
    return figure, list(panels)


def label(text: str, width: int = 80) -> str:
    """A name of the user in lines of so many characters; dollars in it are no mathematics."""
    return "\n".join(wrap(encodable(text), width)).replace("$", r"\$")


def legend(panel: Axes, title: str = "") -> None:
    """The legend beside the curves."""
    panel.legend(
        loc="upper left", bbox_to_anchor=(1.0, 1.0), frameon=False, title=title,
        alignment="left",
    )


def finish(
    figure: Figure, panels: Sequence[Axes], times: Any, title: str, lines: str = ""
) -> Figure:
    """Arrivals at waypoints, grid and title of a stack; lines: what others than curves are."""
    for panel in panels:
        marks(panel, times)
    told = ("time [s]", "grey: arrival at a waypoint" if len(times) else "", lines)
    panels[-1].set_xlabel("; ".join(filter(None, told)))
    figure.suptitle(label(title))
    return figure


def marks(panel: Axes, times: Any) -> None:
    """Show times of arrival, and a grid."""
    for time in times:
        panel.axvline(float(time), color="#bbbbbb", linewidth=0.8, zorder=0)
    grid(panel)


def apart(panel: Axes) -> None:
    """So few numbers along an axis of half a figure that long ones have room."""
    panel.locator_params(axis="x", nbins=5)


def grid(panel: Axes) -> None:
    """A grid behind curves and areas, without a frame."""
    panel.grid(True, color="#eeeeee")
    panel.set_axisbelow(True)
    for side in ("top", "right"):
        panel.spines[side].set_visible(False)
