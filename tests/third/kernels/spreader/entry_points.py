"""The kernel of a load with a spreader that other layers call."""

from segfmu.kernels.crane.records import Axes, Coordinates, Resistance, State
from segfmu.kernels.entry_point import entry

ENTRY_POINTS = (
    entry(
        "spreader.suspended", "spreader_inverse", flat=(5, 3), resistance=Resistance.SIZE,
        force=Axes.SIZE, state=State.SIZE, acceleration=Coordinates.SIZE,
    ),
)
