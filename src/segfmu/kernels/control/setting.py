"""Parameters of the tracking controller."""

from math import ceil, exp, floor, sqrt

from segfmu.kernels.control.records import Tracking, TrackingDesign, Uncertainty
from segfmu.kernels.crane.bounds import acceleration_bound, carriage_mass, static_bound
from segfmu.kernels.crane.records import Axes, DriveMode, Plant


def nominal_payload(expected: float, payload: float) -> float:
    """Mass [kg] of the load that feedback and observer are for; expected 0: the crane's own."""
    if expected > 0.0:
        return expected
    return payload


def signal_age(dead_time: float, sampling: float, period: float) -> float:
    """Age [s] of the signals at a tick of the controller.

    dead_time [s]: from sampling to the signal; sampling, period [s]: of the sensors, 0 for
    continuous ones, and of the controller. A sample becomes a signal within its dead time, so the
    latest signal at a tick is that of a whole number of samples before; on average half a sample
    more, if ticks and samples are not in step.
    """
    if sampling <= 0.0:
        return dead_time
    age = sampling * ceil(dead_time / sampling - 1e-6)
    ratio = period / sampling
    if abs(ratio - floor(ratio + 0.5)) > 1e-6:
        age = dead_time + 0.5 * sampling
    return age


def drive_bound(plant: 'float[:]', axis: int, sign: float) -> float:
    """Greatest size of a setpoint of a drive of a `Plant` in the direction of a sign, N or m/s2.

    1e99 where there is none. The acceleration of a velocity drive is also bounded by its force,
    with which it moves carriage and load; a hoist lifts the load with it, and lowers it by its
    weight.
    """
    bound = static_bound(plant, axis, sign)
    if int(plant[Plant.MODE]) == DriveMode.VELOCITY:
        moved = carriage_mass(plant, axis) + plant[Plant.PAYLOAD_MASS]
        by_force = bound / moved
        if axis == Axes.ROPE and sign > 0.0:
            by_force = 0.0
        elif axis == Axes.ROPE and bound > 0.0:
            by_force = max(by_force - plant[Plant.GRAVITY], 1e-3 * plant[Plant.GRAVITY])
        bound = acceleration_bound(plant, axis, sign)
        if by_force > 0.0 and (bound <= 0.0 or by_force < bound):
            bound = by_force
    if bound > 0.0:
        return bound
    return 1e99


def weak_drive() -> float:
    """Acceleration of a carriage over gravity below which its drive is weak."""
    return 0.1


def drive_strength(plant: 'float[:]', axis: int) -> float:
    """Share of the usual tunings that the drive of a carriage can follow: 1 unless it is weak."""
    weight = plant[Plant.GRAVITY]
    if int(plant[Plant.MODE]) == DriveMode.FORCE:
        weight = weight * carriage_mass(plant, axis)
    weaker = min(drive_bound(plant, axis, 1.0), drive_bound(plant, axis, -1.0))
    return min(weaker / (weak_drive() * weight), 1.0)


def set_walks(plant: 'float[:]', uncertainty: 'float[:]') -> None:
    """Make the wind of an `Uncertainty` what the drives of a `Plant` can answer.

    Otherwise its estimate would follow the sensors' noise, and a weak drive would always be at its
    bound.
    """
    strength = min(drive_strength(plant, Axes.BRIDGE), drive_strength(plant, Axes.TROLLEY))
    uncertainty[Uncertainty.WIND] = strength * uncertainty[Uncertainty.WIND]


def set_drives(plant: 'float[:]', tracking: 'float[:]') -> None:
    """Fill in mode, masses and bounds of a `Tracking`; a hoist cannot push its rope."""
    tracking[Tracking.MODE] = plant[Plant.MODE]
    tracking[Tracking.MASSES + Axes.BRIDGE] = carriage_mass(plant, Axes.BRIDGE)
    tracking[Tracking.MASSES + Axes.TROLLEY] = carriage_mass(plant, Axes.TROLLEY)
    tracking[Tracking.MASSES + Axes.ROPE] = plant[Plant.PAYLOAD_MASS]
    tracking[Tracking.GRAVITY] = plant[Plant.GRAVITY]
    for axis in range(Axes.SIZE):
        tracking[Tracking.GREATEST + axis] = drive_bound(plant, axis, 1.0)
        tracking[Tracking.LEAST + axis] = -drive_bound(plant, axis, -1.0)
        tracking[Tracking.VELOCITY_MAX + axis] = plant[Plant.VELOCITY_MAX + axis]
        tracking[Tracking.VELOCITY_MIN + axis] = plant[Plant.VELOCITY_MIN + axis]
        tracking[Tracking.POWER_MAX + axis] = plant[Plant.POWER_MAX + axis]
    greatest = 0.0
    if int(plant[Plant.MODE]) == DriveMode.VELOCITY:
        greatest = min(0.9 * plant[Plant.GRAVITY], tracking[Tracking.GREATEST + Axes.ROPE])
    tracking[Tracking.GREATEST + Axes.ROPE] = greatest


def set_tracking(
    plant: 'float[:]', design: 'float[:]', longest: float, tracking: 'float[:]'
) -> None:
    """Fill in what a `Tracking` with a PERIOD has beside switches and gains.

    plant: a `Plant` with the mass of the load that the observer is for; design: a `TrackingDesign`;
    longest: rope length of the observer [m].
    """
    period = tracking[Tracking.PERIOD]
    set_drives(plant, tracking)
    age = signal_age(
        design[TrackingDesign.DEAD_TIME], design[TrackingDesign.SAMPLING], period
    )
    tracking[Tracking.AGE] = age / period
    for axis in range(Axes.SIZE):
        tracking[Tracking.DELAY + axis] = (age + plant[Plant.DEAD_TIME + axis]) / period
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
