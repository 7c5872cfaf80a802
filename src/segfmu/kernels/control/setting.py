"""Parameters of the tracking controller."""

from math import exp, sqrt

from segfmu.kernels.control.records import Tracking, TrackingDesign, Uncertainty
from segfmu.kernels.crane.bounds import carriage_mass
from segfmu.kernels.crane.records import Axes, DriveMode, Plant


def nominal_payload(expected: float, payload: float) -> float:
    """Mass [kg] of the load that feedback and observer are for; expected 0: the crane's own."""
    if expected > 0.0:
        return expected
    return payload


def sampled_late(dead_time: float, sample_time: float) -> bool:
    """Whether signals with this dead time [s] count as one sample [s] old."""
    return dead_time >= 0.5 * sample_time


def drive_bound(plant: 'float[:]', axis: int) -> float:
    """Greatest setpoint of a drive of a `Plant`, N or m/s2; 1e99 where there is none."""
    bound = plant[Plant.FORCE_MAX + axis]
    if int(plant[Plant.MODE]) == DriveMode.VELOCITY:
        bound = plant[Plant.ACCELERATION_MAX + axis]
    if bound > 0.0:
        return bound
    return 1e99


def set_tracking(
    plant: 'float[:]', design: 'float[:]', longest: float, tracking: 'float[:]'
) -> None:
    """Fill in what a `Tracking` with a PERIOD has beside switches and gains.

    plant: a `Plant` with the mass of the load that the observer is for; design: a `TrackingDesign`;
    longest: rope length of the observer [m].
    """
    period = tracking[Tracking.PERIOD]
    tracking[Tracking.MODE] = plant[Plant.MODE]
    tracking[Tracking.DELAYED] = 0.0
    if sampled_late(design[TrackingDesign.DEAD_TIME], period):
        tracking[Tracking.DELAYED] = 1.0
    tracking[Tracking.MASSES + Axes.BRIDGE] = carriage_mass(plant, Axes.BRIDGE)
    tracking[Tracking.MASSES + Axes.TROLLEY] = carriage_mass(plant, Axes.TROLLEY)
    tracking[Tracking.MASSES + Axes.ROPE] = plant[Plant.PAYLOAD_MASS]
    tracking[Tracking.GRAVITY] = plant[Plant.GRAVITY]
    for axis in range(Axes.SIZE):
        bound = drive_bound(plant, axis)
        tracking[Tracking.GREATEST + axis] = bound
        tracking[Tracking.LEAST + axis] = -bound
    tracking[Tracking.PAYLOAD_SHARE] = period / design[TrackingDesign.PAYLOAD_TIME]
    set_noise(design, plant[Plant.GRAVITY], longest, tracking)


def set_fading(tracking: 'float[:]') -> None:
    """Fill in the DECAY of a `Tracking` by PERIOD and FADE."""
    fade = tracking[Tracking.FADE]
    tracking[Tracking.DECAY] = 0.0
    if fade > 0.0:
        tracking[Tracking.DECAY] = exp(-tracking[Tracking.PERIOD] / fade)


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
