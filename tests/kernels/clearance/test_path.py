"""The first contact of a path with boxes."""

from __future__ import annotations

import re

import numpy as np
import pytest

from segfmu import Clearance, InfeasibleError, Limits, Obstacle, Waypoint, plan
from segfmu.kernels import backend
from segfmu.kernels.clearance.records import Box

LIMITS = Limits(1.0, 1.0, 4.0, 30.0)


@pytest.mark.parametrize(("size", "left"), [(2.0, 2.0 - 2e-9), (1e-9, 0.5e-9), (0.0, 0.0)])
def test_boxes_lose_what_may_be_touched_and_thin_ones_half(size: float, left: float) -> None:
    boxes = np.zeros((3, Box.SIZE))
    for high in (Box.LOAD_HIGH, Box.ROPE_HIGH):
        boxes[:, high : high + 3] = size
    boxes[:, Box.ROPE] = 1.0
    backend.shrink_boxes(1e-9, boxes)
    for low, high in ((Box.LOAD_LOW, Box.LOAD_HIGH), (Box.ROPE_LOW, Box.ROPE_HIGH)):
        kept = boxes[:, high : high + 3] - boxes[:, low : low + 3]
        assert kept == pytest.approx(np.full((3, 3), left), rel=1e-12)
    assert (boxes[:, Box.ROPE] == 1.0).all()


@pytest.mark.parametrize("part", ["load", "rope"])
def test_a_contact_ends_where_that_of_all_times_does(part: str) -> None:
    # it lasts over many pieces, with a dwell, and comes again on the way back
    points = [
        Waypoint([0.0, 0.0, -1.5]), Waypoint([1.0, 0.3, -1.4], dwell=1.0),
        Waypoint([1.1, 0.0, -1.6]), Waypoint([2.0, 0.0, -1.5]), Waypoint([1.0, 0.0, -1.5]),
    ]
    trajectory = plan(points, LIMITS)
    low, high = (-2.0, -1.0) if part == "load" else (-0.8, -0.6)
    box = Obstacle("box", [0.7, -1.0, low], [1.4, 1.0, high])
    clearance = Clearance([box])
    contact = clearance.contact if part == "load" else clearance.rope_contact
    times = contact(trajectory, box)
    assert len(times) == 2
    with pytest.raises(InfeasibleError, match=f"the {part} meets it") as caught:
        clearance.require(trajectory)
    told = re.search(r"from ([\d.]+) s to ([\d.]+) s", str(caught.value))
    assert told is not None
    assert [float(t) for t in told.groups()] == pytest.approx(times[0].tolist(), abs=6e-4)
