"""What obstacles cost a search within drive bounds, beside the same search without them."""

from __future__ import annotations

from collections.abc import Callable
from time import process_time

import numpy as np

from benchmarks.report import Part, Record, Section, Settings
from benchmarks.timing import ratios
from segfmu import ActuatorBounds, Clearance, Crane, Obstacle, Waypoint, plan_actuated

CRANE = Crane(bridge_mass=2.2, trolley_mass=1.155, payload_mass=1.0)
BOUNDS = ActuatorBounds(force=[12.0, 8.0, 20.0], velocity=[0.5, 0.4, 0.3])
POINTS = [
    Waypoint([0.0, 0.0, -0.5]), Waypoint([0.4, 0.3, -0.5], "free", "free"),
    Waypoint([1.0, 0.5, -0.4]),
]


def measure(settings: Settings) -> Part:
    """Times of one search: without boxes, with some far away, with some near that it passes."""
    cases = {
        "no boxes": (),
        "1 box beyond the path": _row(1, 3.0),
        "100 boxes beyond the path": _row(100, 3.0),
        "10 boxes below the path": _row(10, 0.0),
    }
    calls = {name: _search(boxes) for name, boxes in cases.items()}
    taken = {name: np.zeros(settings.repetitions) for name in calls}
    order = list(calls)
    for repetition in range(settings.repetitions):
        # another one begins every time
        order.append(order.pop(0))
        for name in order:
            begun = process_time()
            calls[name]()
            taken[name][repetition] = process_time() - begun
    reference = taken["no boxes"]
    records: list[Record] = [
        {"boxes": name, "median CPU s": float(np.median(values)), **ratios(values, reference)}
        for name, values in taken.items()
    ]
    return Part("Obstacles", (Section("A search with one free waypoint", records),))


def _row(count: int, away: float) -> tuple[Obstacle, ...]:
    """Boxes side by side, below the load's path by 0.1 m, or far from it."""
    edges = np.linspace(0.0, 1.0, count + 1)
    return tuple(
        Obstacle(f"box {i}", [edges[i] + away, 0.0, -1.0], [edges[i + 1] + away, 0.5, -0.6])
        for i in range(count)
    )


def _search(boxes: tuple[Obstacle, ...]) -> Callable[[], object]:
    clearance = Clearance(boxes) if boxes else None
    return lambda: plan_actuated(CRANE, POINTS, None, BOUNDS, clearance=clearance)
