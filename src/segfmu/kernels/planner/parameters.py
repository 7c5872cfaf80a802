"""Limits of an axis, and the parameters of its acceleration ramps.

A ramp takes the acceleration from one level to another, as in (11a-d). Two shapes exist:

* smoothstep (shape 0): the paper's polynomial Psi of (12) with k = n - 2 (errata E1, E2);
* plateau (shape 1): the jerk rises with the polynomial of order k - 1, stays, and falls. If no
  limit above the snap is given, the snap has a plateau too: within each rise of the jerk it rises
  with the polynomial of order k - 2 in a share of the time, stays, and falls.

Both are symmetric, so a ramp from a to b lasting tau gains the velocity (a + b) / 2 * tau and,
from (15), the distance v tau + a tau^2 / 2 + (b - a) (tau^2 / 8 + V / 2), where V is the
variance of the jerk seen as a density in time: tau^2 / (4 (2 k + 3)) for the polynomial, and
(tau - rise)^2 / 12 + rise^2 R for the plateau, which is a box convolved with the density of its
rise. That density has the variance R = 1 / (4 (2 k + 1)) or, with a plateau of the snap whose rise
takes the share s, R = (1 - s)^2 / 12 + s^2 / (4 (2 k - 1)).

The duration of a ramp respects every limit c_3 .. c_{n+1} (errata E3). Its parameters are fields of
the record `Axis`, set once per axis by `ramp_parameters`: the ramp, or with a plateau its rise,
lasts at least (q_e * change)^(1/e) for each e from 1 on. From a change of LINEAR_FROM on the jerk
limit determines the duration, which is then linear in the change. CURVE is a polynomial in the
share s of the duration of the curved part. For smoothstep it is the acceleration relative to the
change; for plateau the acceleration gained in a rise relative to jerk * rise; with a plateau of the
snap the same for the snap's rise.
"""

from segfmu.kernels.planner.ramp import ramp_duration
from segfmu.kernels.planner.records import Axis, Shape
from segfmu.kernels.planner.transition import transition_coefficients, transition_peaks


def axis_limits(
    smoothness: int, shape: int, limits: 'float[:]', axis: 'float[:]'
) -> None:
    """Set smoothness, shape and limits of an axis (Axis): limits[i] is c_{i+1}, 0 where absent."""
    for i in range(Axis.SIZE):
        axis[i] = 0.0
    axis[Axis.SMOOTHNESS] = smoothness
    axis[Axis.SHAPE] = shape
    for i in range(smoothness + 1):
        axis[Axis.VELOCITY + i] = limits[i]


def ramp_parameters(share: float, axis: 'float[:]', work: 'float[:,:]') -> bool:
    """Set the ramp parameters of an axis whose limits are set (Axis).

    share: duration of each rise relative to its ramp, if no limit bounds the rise. A smaller share
    makes faster ramps with larger unbounded derivatives. `work` has two rows of 2 smoothness
    numbers or more. Returns False if no limit bounds the ramp.
    """
    smoothness = int(axis[Axis.SMOOTHNESS])
    shape = int(axis[Axis.SHAPE])
    for i in range(Axis.FULL_RAMP, Axis.SIZE):
        axis[i] = 0.0
    axis[Axis.LINEAR_FROM] = -1.0
    bounded = False
    if shape == Shape.PLATEAU and smoothness > 2:
        bounded = plateau_parameters(share, axis, work[0, :], work[1, :])
    else:
        bounded = smoothstep_parameters(axis, work[0, :], work[1, :])
    if bounded:
        duration, rise, slope = ramp_duration(axis[Axis.ACCELERATION], axis)
        axis[Axis.FULL_RAMP] = duration
    return bounded


def smoothstep_parameters(axis: 'float[:]', psi: 'float[:]', peaks: 'float[:]') -> bool:
    """`ramp_parameters` of the polynomial of order k = n - 2."""
    k = int(axis[Axis.SMOOTHNESS]) - 2
    bounded = False
    transition_peaks(k, psi, peaks)
    axis[Axis.CURVE_SIZE] = 2.0 * k + 2.0
    for j in range(2 * k + 2):
        axis[Axis.CURVE + j] = psi[j]
    axis[Axis.FLAT_VARIANCE] = 1.0 / (4.0 * (2 * k + 3))
    for j in range(1, k + 2):
        limit = axis[Axis.JERK + j - 1]
        if limit > 0.0:
            axis[Axis.POWERS + j - 1] = peaks[j] / limit
            bounded = True
    slope = axis[Axis.POWERS]
    if slope > 0.0:
        axis[Axis.LINEAR_FROM] = 0.0
        axis[Axis.LINEAR_SLOPE] = slope
        for e in range(2, k + 2):
            # the change above which the root of order e is not longer than the linear duration
            change = (axis[Axis.POWERS + e - 1] / slope**e) ** (1.0 / (e - 1))
            axis[Axis.LINEAR_FROM] = max(axis[Axis.LINEAR_FROM], change)
    return bounded


def plateau_parameters(
    share: float, axis: 'float[:]', psi: 'float[:]', peaks: 'float[:]'
) -> bool:
    """`ramp_parameters` where the jerk has a plateau."""
    k = int(axis[Axis.SMOOTHNESS]) - 2
    jerk = axis[Axis.JERK]
    axis[Axis.PLATEAU] = 1.0
    axis[Axis.FLAT_VARIANCE] = 1.0 / 12.0
    plateau_curve(share, axis, psi, peaks)
    bounded = False
    rise = 0.0
    for j in range(1, k + 1):
        limit = axis[Axis.JERK + j]
        if limit > 0.0:
            power = peaks[j] / limit
            axis[Axis.POWERS + j] = power
            rise = max(rise, (jerk * power) ** (1.0 / j))
            bounded = True
    if jerk > 0.0 and not bounded:
        axis[Axis.RISE_SHARE] = share
        bounded = True
    axis[Axis.RISE] = rise
    if jerk > 0.0:
        axis[Axis.LINEAR_FROM] = jerk * rise
        axis[Axis.LINEAR_SLOPE] = 1.0 / (jerk * (1.0 - axis[Axis.RISE_SHARE]))
        axis[Axis.LINEAR_CONSTANT] = rise
    return bounded


def plateau_curve(
    share: float, axis: 'float[:]', psi: 'float[:]', peaks: 'float[:]'
) -> None:
    """Set the curved part of a ramp with a plateau and its variance; M_j of its rise in `peaks`."""
    k = int(axis[Axis.SMOOTHNESS]) - 2
    steep = k > 1 and axis[Axis.JERK + 1] > 0.0
    for j in range(2, k + 1):
        if axis[Axis.JERK + j] > 0.0:
            steep = False
    if steep:
        transition_coefficients(k - 2, psi)
        peaks[1] = 1.0 / (1.0 - share)
        flat = 1.0 - share
        axis[Axis.RISE_VARIANCE] = flat * flat / 12.0 + share * share / (4.0 * (2 * k - 1))
        axis[Axis.CURVE_SIZE] = 2.0 * k - 2.0
        axis[Axis.SNAP_SHARE] = share
        for j in range(2 * k - 2):
            axis[Axis.CURVE + j] = psi[j]
    else:
        transition_peaks(k - 1, psi, peaks)
        axis[Axis.RISE_VARIANCE] = 1.0 / (4.0 * (2 * k + 1))
        axis[Axis.CURVE_SIZE] = 2.0 * k + 1.0
        for j in range(2 * k):
            axis[Axis.CURVE + 1 + j] = psi[j] / (j + 1.0)
