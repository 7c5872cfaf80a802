"""Limits of an axis, and the parameters of its acceleration ramps.

A ramp takes the acceleration from one level to another, as in (11a-d). Two shapes exist:

* smoothstep (shape 0): the paper's polynomial Psi of (12) with k = n - 2 (errata E1, E2);
* plateau (shape 1): the jerk rises, stays, and falls; so does the snap within each rise of the
  jerk, and so on up to the derivative n + 1 (ramp.py).

Both are symmetric, so a ramp from a to b lasting tau gains the velocity (a + b) / 2 * tau and,
from (15), the distance v tau + a tau^2 / 2 + (b - a) (tau^2 / 8 + V / 2), where V is the
variance of the jerk seen as a density in time: tau^2 / (4 (2 k + 3)) for the polynomial.

The duration of a ramp respects every limit c_3 .. c_{n+1} (errata E3). Its parameters are fields of
the record `Axis`, set once per axis by `ramp_parameters`. A smoothstep ramp lasts at least
(q_e * change)^(1/e) for each e from 1 on. From a change of LINEAR_FROM on the jerk limit determines
the duration, which is then linear in the change.

A rise that no limit determines takes a share of the rise it belongs to. From the crackle on the
least share holds also beside a limit, so that a loose limit changes nothing.
"""

from segfmu.kernels.numerics.numbers import NEVER
from segfmu.kernels.planner.ramp import plateau_duration, ramp_duration, rise_moments
from segfmu.kernels.planner.records import Axis, Shape
from segfmu.kernels.planner.sides import top_acceleration
from segfmu.kernels.planner.transition import transition_peaks

# share of a rise in the rise that it belongs to, and what is left of it where rises are steeper
USUAL = 0.1
STEEPER = 0.2
# what ramps of the snap save without smoothness is half of such a share, and a little
SAVED = 0.6
# a rise that no limit ends [s]: its powers do not overflow
LONGEST = 1e60


def axis_limits(smoothness: int, shape: int, limits: 'float[:]', axis: 'float[:]') -> None:
    """Set smoothness, shape and limits of an axis (Axis): limits[i] is c_{i+1}, 0 where absent.

    They are the same in both directions until `set_lower`.
    """
    for i in range(Axis.SIZE):
        axis[i] = 0.0
    axis[Axis.SMOOTHNESS] = smoothness
    axis[Axis.SHAPE] = shape
    for i in range(smoothness + 1):
        axis[Axis.VELOCITY + i] = limits[i]
    for i in range(2):
        axis[Axis.LOWER + i] = limits[i]


def usual_share(axis: 'float[:]') -> float:
    """Share of a rise in the rise it belongs to, where no limit bounds it; the limits are set.

    Ramps bounded by the snap alone take 1 / sqrt(1 - share) of those with jumps of the snap: 3 %
    more where the crackle may jump, at the smoothness 4, else 5 %. The derivatives without a limit
    grow with its inverse, and with them the errors of forces that are held from sample to sample.
    """
    raised = int(axis[Axis.RAISED])
    if axis[Axis.SMOOTHNESS] + raised == 4.0 and raised < 2 and axis[Axis.JERK + 1 - raised] > 0.0:
        return 0.5 * USUAL
    return USUAL


def moderate_share() -> float:
    """Share where the limits leave no room for the usual rises, at first."""
    return STEEPER * USUAL


def steepest_share() -> float:
    """Share where they leave no room for moderate rises."""
    return STEEPER * moderate_share()


def ramps_suffice(axis: 'float[:]') -> bool:
    """Whether no limit above the snap makes ramps of the acceleration take longer than needed."""
    return axis[Axis.RISES + 1] == 0.0


def snap_is_last(axis: 'float[:]') -> bool:
    """Whether the snap is the highest limit of an axis whose ramp parameters are set."""
    return axis[Axis.SHARES] == 0.0 and ramps_suffice(axis)


def saving(axis: 'float[:]') -> float:
    """The share of their duration that ramps of the snap save without smoothness, and a little."""
    return SAVED * axis[Axis.SHARES + 1]


def ramp_parameters(share: float, axis: 'float[:]', work: 'float[:,:]') -> bool:
    """Set the ramp parameters of an axis whose limits are set (Axis).

    share: of a rise in the rise it belongs to, where no limit bounds it. A smaller share makes
    faster ramps with larger unbounded derivatives. `work` has two rows of 2 smoothness numbers or
    more. Returns False if no limit bounds the ramp.
    """
    for i in range(Axis.FULL_RAMP, Axis.SIZE):
        axis[i] = 0.0
    axis[Axis.LINEAR_FROM] = NEVER
    bounded = False
    if int(axis[Axis.SHAPE]) == Shape.PLATEAU:
        bounded = plateau_parameters(share, axis)
    else:
        bounded = smoothstep_parameters(axis, work[0, :], work[1, :])
    if bounded:
        duration, slope = ramp_duration(top_acceleration(axis), axis)
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
    axis[Axis.VARIANCE] = 1.0 / (4.0 * (2 * k + 3))
    for j in range(1, k + 2):
        limit = axis[Axis.JERK + j - 1]
        if limit > 0.0:
            axis[Axis.POWERS + j - 1] = peaks[j] / limit
            bounded = True
    slope = axis[Axis.POWERS]
    if slope > 0.0:
        axis[Axis.LINEAR_FROM] = 0.0
        axis[Axis.LINEAR_SLOPE] = slope
        axis[Axis.LINEAR_RATE] = 1.0 / slope
        for e in range(2, k + 2):
            # the change above which the root of order e is not longer than the linear duration
            change = (axis[Axis.POWERS + e - 1] / slope**e) ** (1.0 / (e - 1))
            axis[Axis.LINEAR_FROM] = max(axis[Axis.LINEAR_FROM], change)
    return bounded


def plateau_parameters(share: float, axis: 'float[:]') -> bool:
    """`ramp_parameters` where all derivatives have plateaus."""
    boxes = int(axis[Axis.SMOOTHNESS]) - 1
    axis[Axis.PLATEAU] = 1.0
    last = -1
    for level in range(boxes):
        if axis[Axis.JERK + level] > 0.0:
            last = level
    if last < 0:
        return False
    axis[Axis.ABOVE] = min((last + 1) // 2, 2)
    for level in range(boxes - 1):
        if level > 0 or last == 0:
            axis[Axis.SHARES + level] = share
            if level > last:
                # it costs no time, and nested steep rises leave pieces of nanoseconds
                axis[Axis.SHARES + level] = max(share, usual_share(axis))
            if level + axis[Axis.RAISED] == 2.0 and last + axis[Axis.RAISED] >= 2.0:
                # the pop beside a limit of the crackle: errors of forces that are held
                axis[Axis.SHARES + level] = STEEPER * share
    for i in range(last):
        level = last - 1 - i
        limit = axis[Axis.JERK + level]
        # without a limit the rise takes half of the one it belongs to
        rise = LONGEST
        if limit > 0.0:
            rise, slope = plateau_duration(limit, level + 1, axis)
        axis[Axis.RISES + level] = rise
    if last == 1:
        # the snap alone determines a small ramp
        axis[Axis.SQUARE_RATE] = 0.25 * axis[Axis.JERK + 1] * (1.0 - axis[Axis.SHARES + 1])
        axis[Axis.SQUARE] = 1.0 / axis[Axis.SQUARE_RATE]
    if last <= 1:
        # so have all ramps below the jerk limit the same proportions
        time = axis[Axis.RISES] if last == 1 else 1.0
        variance, fourth = rise_moments(time, 0, axis)
        axis[Axis.VARIANCE] = variance / (time * time)
    jerk = axis[Axis.JERK]
    if jerk > 0.0:
        rise = axis[Axis.RISES]
        axis[Axis.LINEAR_FROM] = jerk * rise
        axis[Axis.LINEAR_RATE] = jerk * (1.0 - axis[Axis.SHARES])
        axis[Axis.LINEAR_SLOPE] = 1.0 / axis[Axis.LINEAR_RATE]
        axis[Axis.LINEAR_CONSTANT] = rise
        if rise > 0.0:
            axis[Axis.INNER_VARIANCE], fourth = rise_moments(rise, 1, axis)
    return True
