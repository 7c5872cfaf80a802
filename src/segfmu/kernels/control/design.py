"""Design of the flatness-based feedback, and of the tracking controller's noise thresholds."""

from math import sqrt

from segfmu.kernels.control.feedback import feedback_bandwidth, feedback_gains
from segfmu.kernels.control.records import FlatDesign, Tracking, Uncertainty
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


def set_noise(
    uncertainty: 'float[:]', gravity: float, longest: float, tracking: 'float[:]'
) -> None:
    """Fill in a `Tracking` that has a PERIOD, from WAKE_POSITION on, by an `Uncertainty`.

    The bandwidth of the filter that finds the rope's offset is in units of the frequency of the
    longest rope [m], but no more than half a radian in a sample.
    """
    wake = uncertainty[Uncertainty.WAKE]
    tracking[Tracking.WAKE_POSITION] = wake * uncertainty[Uncertainty.POSITION]
    tracking[Tracking.WAKE_LENGTH] = wake * uncertainty[Uncertainty.LENGTH]
    tracking[Tracking.WAKE_ANGLE] = wake * uncertainty[Uncertainty.ANGLE]
    tracking[Tracking.OFFSET_EXPECTED] = uncertainty[Uncertainty.OFFSET]
    tracking[Tracking.OFFSET_BANDWIDTH] = min(
        4.0 * sqrt(gravity / longest), 0.5 / tracking[Tracking.PERIOD]
    )
    angle = uncertainty[Uncertainty.ANGLE]
    place = max(uncertainty[Uncertainty.POSITION], uncertainty[Uncertainty.LENGTH])
    tracking[Tracking.ANGLE_VARIANCE] = angle * angle / 12.0
    tracking[Tracking.POSITION_VARIANCE] = place * place / 12.0
