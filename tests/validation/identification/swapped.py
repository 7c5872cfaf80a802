"""A log whose columns of both sway angles are exchanged, which the tests share."""

from __future__ import annotations

from typing import Any

from benchmarks.synthetic_logs import synthetic

PAIR = "measured.sway.x.angle", "measured.sway.y.angle"


def swapped() -> tuple[dict[str, Any], dict[str, Any]]:
    """Its columns and the crane, but for the zeros of rope and sway."""
    made = synthetic("lab", "velocity", 1, rows=100)
    columns = dict(made.columns)
    columns |= {one: made.columns[other] for one, other in (PAIR, PAIR[::-1])}
    return columns, made.crane_without("sensors.rope.zero", "sensors.sway_y.zero")
