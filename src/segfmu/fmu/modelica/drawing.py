"""Icons and places of connectors: inputs at the left edge, outputs at the right one."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import groupby

from segfmu.fmu.gantry_crane.pair import GANTRY
from segfmu.fmu.modelica.names import title
from segfmu.fmu.pair import GREY
from segfmu.fmu.pairs import PAIRS
from segfmu.fmu.standard.spec import Spec, Variable

# size of an icon, and distance between connectors
HALF_WIDTH, DISTANCE, HALF_CONNECTOR = 200, 20, 8


@dataclass(frozen=True)
class Place:
    """The middle of a connector in the coordinates of its icon."""

    x: int
    y: int

    @property
    def annotation(self) -> str:
        """The annotation of a component at this place."""
        return f"annotation(Placement(transformation({extent(self.x, self.y, HALF_CONNECTOR)})))"


def extent(x: int, y: int, half_width: int, half_height: int | None = None) -> str:
    """A rectangle about a middle."""
    high = half_width if half_height is None else half_height
    return (
        f"extent = {{{{{x - half_width}, {y - high}}}, {{{x + half_width}, {y + high}}}}}"
    )


def half_height(spec: Spec) -> int:
    """Half the height of an icon with room for all connectors of its fuller edge."""
    rows = max(_rows(spec.where("input")), _rows(spec.where("output")))
    return rows * DISTANCE // 2 + DISTANCE


def _rows(variables: tuple[Variable, ...]) -> int:
    """Connectors of one edge, with a free row between groups."""
    return len(variables) + sum(1 for _ in groupby(title(v.name) for v in variables))


def places(spec: Spec) -> dict[str, Place]:
    """The place of every connector."""
    found = {}
    for x, variables in (
        (-HALF_WIDTH - HALF_CONNECTOR, spec.where("input")),
        (HALF_WIDTH + HALF_CONNECTOR, spec.where("output")),
    ):
        y, before = _rows(variables) * DISTANCE // 2, ""
        for v in variables:
            if before not in ("", title(v.name)):
                y -= DISTANCE
            before = title(v.name)
            found[v.name] = Place(x, y)
            y -= DISTANCE
    return found


def icon(spec: Spec) -> str:
    """Coordinate system and picture: a crane, and the names of the groups at the edges."""
    high = half_height(spec)
    system = f"coordinateSystem({extent(0, 0, HALF_WIDTH, high)})"
    shapes = [
        f"Rectangle({extent(0, 0, HALF_WIDTH, high)}, lineColor = {{60, 60, 60}}, "
        "fillColor = {255, 255, 255}, fillPattern = FillPattern.Solid)",
        f"Text({extent(0, high + 40, HALF_WIDTH, 30)}, textString = \"%name\", "
        "textColor = {0, 0, 255})",
        "Line(points = {{-60, 60}, {60, 60}}, color = {60, 60, 60}, thickness = 3)",
        *_hanging(spec),
        *_labels(spec),
    ]
    shown = ",\n      ".join(shapes)
    return (
        f"\n    Diagram({system}),\n    Icon({system}, graphics = {{\n      {shown}}})"
    )


def _hanging(spec: Spec) -> list[str]:
    """Rope, load, and what is between them."""
    pair = next((pair for pair in PAIRS if spec.name in pair.names), GANTRY)
    points = ", ".join(f"{{{x}, {y}}}" for x, y in pair.ropes)
    return [
        f"Line(points = {{{points}}}, color = {GREY})",
        *(f"Ellipse({extent(x, y, half)}, lineColor = {colour}, fillColor = {colour}, "
          "fillPattern = FillPattern.Solid)" for x, y, half, colour in pair.hanging),
    ]


def _labels(spec: Spec) -> list[str]:
    found = []
    where = places(spec)
    for edge, side, alignment in (("input", -1, "Left"), ("output", 1, "Right")):
        seen = set()
        for v in spec.variables:
            if v.causality == edge and title(v.name) not in seen:
                seen.add(title(v.name))
                middle = side * (HALF_WIDTH - 60)
                found.append(
                    f"Text({extent(middle, where[v.name].y, 50, 8)}, "
                    f'textString = "{title(v.name)}", horizontalAlignment = '
                    f"TextAlignment.{alignment}, textColor = {{60, 60, 60}})"
                )
    return found
