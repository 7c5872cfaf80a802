"""What a report consists of, and how it becomes one HTML file."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from segfmu.cosim.result import replacing
from segfmu.validation.output import file_path
from segfmu.validation.report.web import as_json, filled
from segfmu.validation.texts import encodable

# of a chart whose limits are far away: from this use on they are in the picture
NEAR = 0.2


# of a table: a text, or a text and the class of its look
Cell = str | tuple[str, str]


@dataclass(frozen=True)
class Curve:
    """A curve of a chart.

    Attributes
    ----------
    name : str
        In the legend and for readers of screens.
    role : str
        Its look: "x", "y" and "z" for axes or drives, "plan" for what was wanted.
    x, y : list of float
    """

    name: str
    role: str
    x: list[float]
    y: list[float]


@dataclass(frozen=True)
class Chart:
    """A chart, over time if nothing else is said.

    Attributes
    ----------
    title, unit : str
    caption : str
        What it shows, in words.
    curves : sequence of Curve
    limits : tuple of float
        Lower and upper limit; None for none, or for one that is far away.
    kind : str
        "lines", "points", or "steps": how often, with the limits along the abscissa.
    across : str
        What the abscissa is, and its unit.
    """

    title: str
    unit: str
    caption: str
    curves: Sequence[Curve]
    limits: tuple[float | None, float | None] = (None, None)
    kind: str = "lines"
    across: str = ""


@dataclass(frozen=True)
class Table:
    """A table; a cell is a text, or a text with the class of its look."""

    caption: str
    heads: Sequence[str]
    rows: Sequence[Sequence[Cell]]


@dataclass(frozen=True)
class Section:
    """A part of a report.

    Attributes
    ----------
    title : str
    text : str
        One paragraph.
    legend : sequence of (role, name)
        Of all charts of the section.
    charts, tables : sequence
    commands : sequence of str
        Ready to be copied.
    folded : bool
        Whether only the title shows at first.
    wide : bool
        Whether the charts are as wide as the page.
    columns : int
        Charts beside each other on a wide screen; 0 for as many as fit.
    scene : int or None
        Of the page's scenes, the one whose time is marked in the charts.
    arrivals : sequence of float
        Times at which the load is at the waypoints [s], marked in the charts.
    end : float
        Of the charts' axis of time [s].
    """

    title: str
    text: str = ""
    legend: Sequence[tuple[str, str]] = ()
    charts: Sequence[Chart] = ()
    tables: Sequence[Table] = ()
    commands: Sequence[str] = ()
    folded: bool = False
    wide: bool = False
    columns: int = 0
    scene: int | None = None
    arrivals: Sequence[float] = ()
    end: float = 0.0


@dataclass(frozen=True)
class Page:
    """A report.

    Attributes
    ----------
    title, kind : str
    passed : bool
    verdict : str
        In words.
    facts : sequence of (name, value)
        What one wants to know first.
    summary : Table
    scenes : sequence of mapping
        Of the view in three dimensions, see scene.py.
    sections : sequence of Section
    """

    title: str
    kind: str
    passed: bool
    verdict: str
    facts: Sequence[tuple[str, str]]
    summary: Table
    scenes: Sequence[Mapping[str, Any]]
    sections: Sequence[Section]


def write(path: str | Path, page: Page) -> Path:
    """Write a report; the file appears when it is complete. Returns its path.

    Raises
    ------
    InputError
        If the file cannot be written.
    """
    target = file_path(path)
    text = encodable(render(page))
    with replacing(target) as temporary:
        temporary.write_text(text, encoding="utf-8")
    return target


def render(page: Page) -> str:
    """The HTML of a report, with all that it needs."""
    from plotly.offline import get_plotlyjs

    return filled("page.html", PARTS, page=page, data=_data(page), plotly=get_plotlyjs())


PARTS = ("page.css", "view.html", "charts.js", "view.js", "scene.js")


def _data(page: Page) -> str:
    """What the scripts draw."""
    charts = [
        {
            "title": chart.title, "unit": chart.unit, "limits": chart.limits,
            "kind": chart.kind, "across": chart.across,
            "curves": [vars(curve) for curve in chart.curves], "scene": section.scene,
            "arrivals": section.arrivals, "end": section.end,
        }
        for section in page.sections for chart in section.charts
    ]
    return as_json({"charts": charts, "scenes": page.scenes})
