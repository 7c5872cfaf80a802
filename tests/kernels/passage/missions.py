"""A mission of two axes and four waypoints for the kernels of the central path."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from segfmu.kernels.passage.barrier import barrier_value, largest_node_share
from segfmu.kernels.passage.grid import write_grid
from segfmu.kernels.passage.path import begin_path, follow_path, try_move, write_step_of
from segfmu.kernels.passage.records import (
    Cells,
    GridRow,
    Link,
    Path,
    Spot,
    Square,
    Stretch,
    Track,
)
from segfmu.kernels.passage.search import write_scales_of, write_tracks

LIMITS = np.array([[1.0, 0.8, 2.0, 15.0], [0.6, 0.7, 3.0, 10.0]])
PLACES = np.array([[0.0, 0.0], [0.6, 0.2], [0.9, 0.9], [1.8, 0.7]])
EVERYWHERE = np.broadcast_to([-1e307, 1e307], (3, 2, 2))


@dataclass(eq=False)
class Mission:
    """Arrays of a passage whose inner states are free."""

    box: np.ndarray = field(default_factory=lambda: EVERYWHERE)

    def __post_init__(self) -> None:
        self.path, self.tracks = np.zeros(Path.SIZE), np.zeros((2, Track.SIZE))
        self.spots = np.zeros((8, Spot.SIZE, Spot.COLUMNS))
        self.links = np.zeros((6, Link.SIZE, Link.COLUMNS))
        self.spans = np.zeros((3, Stretch.SIZE))
        self.grid = np.zeros((Cells.ROWS, GridRow.SIZE))
        self.square = np.zeros((Square.SIZE, Square.COLUMNS))
        self.band = np.zeros((16, 9))
        self.path[Path.AXES], self.path[Path.ROOM] = 2.0, 1.0
        write_tracks(LIMITS, LIMITS[:, :2].copy(), self.path, self.tracks)
        write_grid(4, self.grid, self.square)
        self.spots[2:6, Spot.CHOSEN] = 1.0
        self.links[:, Link.BOX, :2] = self.box.reshape(6, 2)
        states = np.zeros((4, 2, 3))
        states[:, :, 0] = PLACES
        write_scales_of(
            False, states, self.path, self.tracks, self.spots, self.links, self.spans
        )

    @property
    def arrays(self) -> tuple[np.ndarray, ...]:
        """As the kernels take them, without the band."""
        return (
            self.path, self.tracks, self.spots, self.links, self.spans, self.grid, self.square
        )

    def followed(self, gap: float) -> Mission:
        """The mission at a point whose duration exceeds the shortest by the gap at most."""
        self.path[Path.START] = 10.0
        assert begin_path(*self.arrays, self.band)
        theta = self.path[Path.TERMS] / (10.0 * self.times.sum())
        assert follow_path(theta, gap, *self.arrays, self.band) > 0.0
        return self

    @property
    def times(self) -> np.ndarray:
        """Durations of the intervals [s]."""
        return np.exp(self.spans[:, Stretch.TIME])

    def step(self, theta: float) -> float:
        """Newton's step from the point; the decrease that it promises."""
        try_move(0.0, self.path, self.spots, self.links, self.spans)
        return write_step_of(theta, *self.arrays, self.band)

    def value(self, theta: float, share: float) -> float:
        """The barrier function after a share of the step."""
        for row, target, source in (
            (self.spots, Spot.TRIAL, Spot.SHARE), (self.links, Link.TRIAL, Link.POINT)
        ):
            row[:, target] = row[:, source]
        step = Spot.STEP
        self.spots[:, Spot.TRIAL] = self.spots[:, Spot.SHARE] + share * self.spots[:, step]
        moved = self.links[:, Link.POINT] + share * self.links[:, Link.STEP]
        moved[:, 0] = self.links[:, Link.POINT, 0]
        self.links[:, Link.TRIAL] = moved
        self.spans[:, Stretch.TRIAL] = self.spans[:, Stretch.TIME] - np.log1p(
            -share * self.spans[:, Stretch.STEP]
        )
        return barrier_value(theta, *self.arrays)

    def used(self, other: Mission) -> float:
        """The largest share of this mission's limits at the point of another one."""
        self.links[:, Link.TRIAL] = other.links[:, Link.POINT]
        self.spans[:, Stretch.TRIAL] = other.spans[:, Stretch.TIME]
        arrays = self.path, self.tracks, self.links, self.spans, self.grid, self.square
        return largest_node_share(*arrays)
