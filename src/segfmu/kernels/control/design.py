"""Design of the controllers' tables over rope length: lengths, gains in closed form, observer."""

from segfmu.kernels.control.feedback import feedback_bandwidth, feedback_gains
from segfmu.kernels.control.kalman import observer_design
from segfmu.kernels.control.records import (
    Expected,
    FlatDesign,
    Observer,
    RopeRange,
    Uncertainty,
)
from segfmu.kernels.crane.records import Axes, DriveMode, Plant


def rope_range(length: float, shortest: float, longest: float, found: 'float[:]') -> None:
    """A `RopeRange` from a crane's bounds [m], or else from the rope length at the start [m]."""
    found[RopeRange.SHORTEST] = shortest
    found[RopeRange.LONGEST] = longest
    if not shortest > 0.0:
        found[RopeRange.SHORTEST] = 0.2 * length
    if not longest > 0.0:
        found[RopeRange.LONGEST] = 5.0 * length


def table_lengths(shortest: float, longest: float, rows: int, lengths: 'float[:]') -> int:
    """Rope lengths (rows,) [m] of a table, in equal ratios; returns their number.

    It is 1 if both ends are equal.
    """
    lengths[0] = shortest
    if not longest > shortest:
        return 1
    for row in range(1, rows - 1):
        lengths[row] = shortest * (longest / shortest) ** (row / (rows - 1))
    lengths[rows - 1] = longest
    return rows


def largest_angle() -> float:
    """Largest bandwidth of bridge and trolley times the sum of period and lag [rad]."""
    return 0.25


def largest_hoist_angle() -> float:
    """The same for the hoist; two poles instead of four tolerate more."""
    return 0.5


def design_flat_gains(
    plant: 'float[:]', design: 'float[:]', length: float, gains: 'float[:,:]'
) -> None:
    """Gains (Gains) at a rope length [m].

    plant: a `Plant` with the design payload; its lags are used for velocity drives only. design: a
    `FlatDesign`.
    """
    delay = design[FlatDesign.PERIOD]
    if int(plant[Plant.MODE]) == DriveMode.VELOCITY:
        lag = 0.0
        for axis in range(Axes.SIZE):
            lag = max(lag, plant[Plant.LAG + axis])
        delay = delay + lag
    gravity = plant[Plant.GRAVITY]
    bandwidth = feedback_bandwidth(
        design[FlatDesign.BANDWIDTH], length, gravity, delay, largest_angle()
    )
    hoist = feedback_bandwidth(
        design[FlatDesign.HOIST_BANDWIDTH], length, gravity, delay, largest_hoist_angle()
    )
    feedback_gains(plant, length, bandwidth, hoist, design[FlatDesign.DAMPING], gains)


def flat_table(
    plant: 'float[:]', design: 'float[:]', rows: int, lengths: 'float[:]', table: 'float[:,:,:]'
) -> None:
    """`design_flat_gains` at rope lengths (rows,) [m]; table (rows, 4, 10): one `Gains` per row."""
    for row in range(rows):
        design_flat_gains(plant, design, lengths[row], table[row, :, :])


def observer_table(
    plant: 'float[:]',
    sample_time: float,
    uncertainty: 'float[:]',
    rows: int,
    lengths: 'float[:]',
    expected: 'float[:]',
    work: 'float[:,:]',
    table: 'float[:,:,:]',
) -> bool:
    """`observer_design` at rope lengths (rows,) [m]; returns whether the whole table is finite.

    uncertainty: an `Uncertainty`; expected: work space, an `Expected`; table (rows, 19, 10): one
    `Observer` per row.
    """
    for i in range(Expected.SIZE):
        expected[i] = uncertainty[i]
    gravity = plant[Plant.GRAVITY]
    expected[Expected.DRIFT] = uncertainty[Uncertainty.DRIFT] * gravity
    expected[Expected.WIND] = uncertainty[Uncertainty.WIND] * gravity
    finite = True
    for row in range(rows):
        observer_design(plant, sample_time, lengths[row], expected, work, table[row, :, :])
        for i in range(Observer.SIZE):
            for j in range(Observer.COLUMNS):
                finite = finite and abs(table[row, i, j]) <= 1.7976931348623157e308
    return finite
