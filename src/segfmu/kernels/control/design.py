"""Design of the controllers' tables over rope length: lengths, gains in closed form, observer."""

from math import sqrt

from segfmu.kernels.control.feedback import feedback_bandwidth, feedback_gains
from segfmu.kernels.control.kalman import observer_design
from segfmu.kernels.control.records import (
    Expected,
    FlatDesign,
    Observer,
    RopeRange,
    Uncertainty,
)
from segfmu.kernels.crane.records import Axes, Coordinates, DriveMode, Plant
from segfmu.kernels.rig.records import Sensors


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
    """Largest bandwidth of bridge and trolley times the time that it acts late [rad]."""
    return 0.25


def largest_hoist_angle() -> float:
    """The same for the hoist; two poles instead of four tolerate more."""
    return 0.5


def acts_late(plant: 'float[:]', design: 'float[:]') -> float:
    """Time [s] that limits the bandwidth: period, dead times, and a quarter of the longest lag.

    The gains know the lag, so only what is wrong with it counts. Lags are those of velocity drives.
    """
    dead = 0.0
    lag = 0.0
    for axis in range(Axes.SIZE):
        dead = max(dead, plant[Plant.DEAD_TIME + axis])
        lag = max(lag, plant[Plant.LAG + axis])
    if int(plant[Plant.MODE]) != DriveMode.VELOCITY:
        lag = 0.0
    return design[FlatDesign.PERIOD] + design[FlatDesign.DEAD_TIME] + dead + 0.25 * lag


def design_flat_gains(
    plant: 'float[:]', design: 'float[:]', length: float, gains: 'float[:,:]'
) -> None:
    """Gains (Gains) at a rope length [m].

    plant: a `Plant` with the design payload. design: a `FlatDesign`.
    """
    delay = acts_late(plant, design)
    gravity = plant[Plant.GRAVITY]
    ratio = design[FlatDesign.BANDWIDTH]
    bandwidth = feedback_bandwidth(ratio, length, gravity, delay, largest_angle())
    hoist = feedback_bandwidth(
        design[FlatDesign.HOIST_BANDWIDTH], length, gravity, delay, largest_hoist_angle()
    )
    # a slower carriage leaves the pendulum its frequency
    pendulum = ratio * sqrt(gravity / length)
    feedback_gains(
        plant, length, bandwidth, pendulum, hoist, design[FlatDesign.DAMPING], gains
    )


def flat_table(
    plant: 'float[:]', design: 'float[:]', rows: int, lengths: 'float[:]', table: 'float[:,:,:]'
) -> None:
    """`design_flat_gains` at rope lengths (rows,) [m]; table (rows, 4, 11): one `Gains` per row."""
    for row in range(rows):
        design_flat_gains(plant, design, lengths[row], table[row, :, :])


def sensor_step(sensors: 'float[:]', signal: int) -> float:
    """Step [m] or [rad] whose quantisation has the variance of a sensor's errors."""
    step = sensors[Sensors.RESOLUTION + signal]
    deviation = sensors[Sensors.DEVIATION + signal]
    return sqrt(step * step + 12.0 * deviation * deviation)


def set_steps(sensors: 'float[:]', longest: float, uncertainty: 'float[:]') -> None:
    """Fill in the steps of an `Uncertainty` that are 0: those of the sensors, noise included.

    sensors: a `Sensors`; longest [m]: rope length. Sensors without an error are taken for usual
    encoders: steps of 1 / 5000 of the rope's length, and 4096 in a turn.
    """
    if uncertainty[Uncertainty.POSITION] == 0.0:
        bridge = sensor_step(sensors, Coordinates.POSITION)
        trolley = sensor_step(sensors, Coordinates.POSITION + Axes.TROLLEY)
        uncertainty[Uncertainty.POSITION] = max(bridge, trolley)
    if uncertainty[Uncertainty.LENGTH] == 0.0:
        uncertainty[Uncertainty.LENGTH] = sensor_step(sensors, Coordinates.POSITION + Axes.ROPE)
    if uncertainty[Uncertainty.ANGLE] == 0.0:
        first = sensor_step(sensors, Coordinates.ANGLE)
        uncertainty[Uncertainty.ANGLE] = max(first, sensor_step(sensors, Coordinates.ANGLE + 1))
    if uncertainty[Uncertainty.POSITION] == 0.0:
        uncertainty[Uncertainty.POSITION] = 2e-4 * longest
    if uncertainty[Uncertainty.LENGTH] == 0.0:
        uncertainty[Uncertainty.LENGTH] = 2e-4 * longest
    if uncertainty[Uncertainty.ANGLE] == 0.0:
        uncertainty[Uncertainty.ANGLE] = 6.283185307179586 / 4096.0


def expect_errors(
    uncertainty: 'float[:]',
    gravity: float,
    length: float,
    sample_time: float,
    expected: 'float[:]',
) -> None:
    """What an `Uncertainty` is at a rope length [m], an `Expected`.

    Quantisation errors stay while a signal stays within a step. They count as new ones only every
    twentieth of the pendulum's time sqrt(l / g), however short the samples are.
    """
    time = sqrt(length / gravity)
    repeated = sqrt(max(1.0, 0.05 * time / sample_time))
    expected[Expected.POSITION] = repeated * uncertainty[Uncertainty.POSITION]
    expected[Expected.LENGTH] = repeated * uncertainty[Uncertainty.LENGTH]
    expected[Expected.ANGLE] = repeated * uncertainty[Uncertainty.ANGLE]
    expected[Expected.DRIFT] = uncertainty[Uncertainty.DRIFT] * gravity / sqrt(time)
    expected[Expected.WIND] = uncertainty[Uncertainty.WIND] * gravity / sqrt(time)


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

    uncertainty: an `Uncertainty` with its steps; expected: work space, an `Expected`; table (rows,
    19, 10): one `Observer` per row.
    """
    finite = True
    for row in range(rows):
        expect_errors(uncertainty, plant[Plant.GRAVITY], lengths[row], sample_time, expected)
        observer_design(plant, sample_time, lengths[row], expected, work, table[row, :, :])
        for i in range(Observer.SIZE):
            for j in range(Observer.COLUMNS):
                finite = finite and abs(table[row, i, j]) <= 1.7976931348623157e308
    return finite
