"""Design of the flatness-based feedback for one rope length."""

from segfmu.kernels.control.feedback import feedback_bandwidth, feedback_gains
from segfmu.kernels.control.records import FlatDesign
from segfmu.kernels.crane.records import Axes, DriveMode, Plant


def largest_angle() -> float:
    """Largest bandwidth of bridge and trolley, in radians in a sample and a lag."""
    return 0.25


def largest_hoist_angle() -> float:
    """The same of the hoist, which with two poles instead of four bears more."""
    return 0.5


def design_flat_gains(
    plant: 'float[:]', design: 'float[:]', length: float, gains: 'float[:,:]'
) -> None:
    """Gains (Gains) at a rope length [m].

    plant: a `Plant` with the mass of the load that the gains are for; lags count for velocity
    drives alone. design: a `FlatDesign`.
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
