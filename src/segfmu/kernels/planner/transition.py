"""Transition polynomials (12) and the acceleration ramps built from them.

A ramp takes the acceleration from one level to another, as in (11a-d). Two shapes exist:

* smoothstep (shape 0): the paper's polynomial Psi of (12) with k = n - 2 (errata E1, E2);
* plateau (shape 1): the jerk rises with the polynomial of order k - 1, stays, and falls. Where
  no limit above the snap is given, the snap has a plateau in the same way: within each rise of
  the jerk it rises with the polynomial of order k - 2 in a share of the time, stays, and falls.

Both are symmetric, so a ramp from a to b lasting tau gains the velocity (a + b) / 2 * tau and,
from (15), the distance v tau + a tau^2 / 2 + (b - a) (tau^2 / 8 + V / 2), where V is the
variance of the jerk seen as a density in time: tau^2 / (4 (2 k + 3)) for the polynomial, and
(tau - rise)^2 / 12 + rise^2 R for the plateau, which is a box convolved with the density of its
rise. That density has the variance R = 1 / (4 (2 k + 1)) or, with a plateau of the snap whose rise
takes the share s, R = (1 - s)^2 / 12 + s^2 / (4 (2 k - 1)).

The duration of a ramp respects every limit c_3 .. c_{n+1} (errata E3). Its parameters are fields
of the record `Axis`, set once per axis by `ramp_parameters`: the ramp, or with a plateau its rise,
lasts at least (q_e * change)^(1/e) for each e from 1 on, and from a change of LINEAR_FROM on the
jerk limit rules and the duration is linear in the change. CURVE is a polynomial in the share s of
the duration of the curved part: the acceleration as a share of the change (smoothstep), or the
acceleration gained in a rise as a share of jerk * rise (plateau), or with a plateau of the snap
that of its rise.
"""

from math import sqrt

from segfmu.kernels.planner.records import Axis, Shape


def transition_coefficients(order: int, coefficients: 'float[:]') -> None:
    """Coefficients of Psi(s, 1) of (12) in ascending powers of s; 2 order + 2 of them."""
    for i in range(2 * order + 2):
        coefficients[i] = 0.0
    # Psi' is (2k+1)!/(k!)^2 s^k (1-s)^k; expanding the binomial gives the sum in (12).
    scale = 1.0
    for i in range(1, order + 1):
        scale = scale * (order + 1 + i) / i
    scale = scale * (order + 1)
    binomial = 1.0
    for i in range(order + 1):
        coefficients[order + 1 + i] = scale * binomial / (order + 1 + i)
        binomial = -binomial * (order - i) / (i + 1)


def polynomial_derivative(coefficients: 'float[:]', count: int, times: int, s: float) -> float:
    """Value at s of a derivative of the polynomial with `count` ascending coefficients."""
    value = 0.0
    for j in range(count - times):
        i = count - 1 - j
        factor = 1.0
        for m in range(times):
            factor = factor * (i - m)
        value = value * s + factor * coefficients[i]
    return value


def transition_peaks(order: int, coefficients: 'float[:]', peaks: 'float[:]') -> None:
    """M_j of errata E3: peaks[j] = max over [0, 1] of |d^j Psi / ds^j|, j = 1 .. order + 1.

    `coefficients` is work space for 2 order + 2 numbers. All extrema of these derivatives of
    s^k (1-s)^k lie in [0, 1]; the largest is the first one, next to s = 0, or the end itself.
    """
    count = 2 * order + 2
    transition_coefficients(order, coefficients)
    peaks[0] = 1.0
    samples = 64 * (order + 1)
    for j in range(1, order + 2):
        best = 0.0
        at = 0
        for i in range(samples + 1):
            value = abs(polynomial_derivative(coefficients, count, j, i / (2.0 * samples)))
            if value > best:
                best = value
                at = i
        lower = (at - 1) / (2.0 * samples)
        upper = (at + 1) / (2.0 * samples)
        if at == 0:
            lower = 0.0
        # bisect the next derivative, which changes sign at an interior extremum
        left = polynomial_derivative(coefficients, count, j + 1, lower)
        for i in range(60):
            middle = 0.5 * (lower + upper)
            slope = polynomial_derivative(coefficients, count, j + 1, middle)
            if slope * left > 0.0:
                lower = middle
            else:
                upper = middle
        value = abs(polynomial_derivative(coefficients, count, j, 0.5 * (lower + upper)))
        if value > best:
            best = value
        peaks[j] = best


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

    share is that of a plateau which each of its rises takes when no limit bounds that rise: the
    smaller, the faster, and the larger the derivatives that are not bounded. `work` has two rows of
    2 smoothness numbers or more. Returns False where no limit bounds the ramp.
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
            # where the root of the order e is no longer than the linear duration
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


def slowest_root(change: float, first: int, axis: 'float[:]') -> 'tuple[float, float]':
    """max over e >= first of (q_e change)^(1/e), and its derivative with the change."""
    slowest = 0.0
    exponent = 1
    if first <= 1 and axis[Axis.POWERS] > 0.0:
        slowest = axis[Axis.POWERS] * change
    if axis[Axis.POWERS + 1] > 0.0:
        root = sqrt(axis[Axis.POWERS + 1] * change)
        if root > slowest:
            slowest = root
            exponent = 2
    for e in range(3, 9):
        if axis[Axis.POWERS + e - 1] > 0.0:
            root = (axis[Axis.POWERS + e - 1] * change) ** (1.0 / e)
            if root > slowest:
                slowest = root
                exponent = e
    return slowest, slowest / (exponent * change)


def ramp_duration(change: float, axis: 'float[:]') -> 'tuple[float, float, float]':
    """Duration of the ramp for an acceleration change >= 0, that of its jerk rise [s], and the
    derivative of the duration with the change (0 for no change, where it is not finite)."""
    if change <= 0.0:
        return 0.0, 0.0, 0.0
    if axis[Axis.LINEAR_FROM] >= 0.0 and change >= axis[Axis.LINEAR_FROM]:
        slope = axis[Axis.LINEAR_SLOPE]
        duration = change * slope + axis[Axis.LINEAR_CONSTANT]
        return duration, axis[Axis.RISE] + axis[Axis.RISE_SHARE] * duration, slope
    if axis[Axis.PLATEAU] < 0.5:
        root, slope = slowest_root(change, 1, axis)
        return root, 0.0, slope
    root, slope = slowest_root(change, 2, axis)
    return 2.0 * root, root, 2.0 * slope


def ramp_rise(duration: float, axis: 'float[:]') -> float:
    """Duration of the jerk rise of the ramp that lasts `duration`."""
    if axis[Axis.PLATEAU] < 0.5:
        return 0.0
    if axis[Axis.LINEAR_FROM] >= 0.0 and duration >= 2.0 * axis[Axis.RISE]:
        return axis[Axis.RISE] + axis[Axis.RISE_SHARE] * duration
    return 0.5 * duration


def fastest_power(duration: float, first: int, axis: 'float[:]') -> 'tuple[float, float]':
    """Inverse of `slowest_root`: min over e >= first of duration^e / q_e, and its derivative."""
    fastest = -1.0
    exponent = 1
    power = 1.0
    for e in range(1, 9):
        power = power * duration
        if e >= first and axis[Axis.POWERS + e - 1] > 0.0:
            change = power / axis[Axis.POWERS + e - 1]
            if fastest < 0.0 or change < fastest:
                fastest = change
                exponent = e
    return fastest, exponent * fastest / duration


def ramp_change(duration: float, axis: 'float[:]') -> 'tuple[float, float]':
    """Inverse of `ramp_duration`: the acceleration change of a ramp, and its derivative with
    the duration. Small ramps are solved for in their duration, which loses no digits."""
    if duration <= 0.0:
        return 0.0, 0.0
    start = axis[Axis.LINEAR_FROM]
    if start >= 0.0:
        slope = axis[Axis.LINEAR_SLOPE]
        constant = axis[Axis.LINEAR_CONSTANT]
        if duration >= start * slope + constant:
            return (duration - constant) / slope, 1.0 / slope
    if axis[Axis.PLATEAU] < 0.5:
        return fastest_power(duration, 1, axis)
    change, growth = fastest_power(0.5 * duration, 2, axis)
    return change, 0.5 * growth


def ramp_distance(
    v: float, a: float, b: float, duration: float, rise: float, axis: 'float[:]'
) -> float:
    """Distance covered by the ramp from acceleration a to b that starts with velocity v."""
    flat = duration - rise
    variance = axis[Axis.FLAT_VARIANCE] * flat * flat + axis[Axis.RISE_VARIANCE] * rise * rise
    return (
        v * duration
        + 0.5 * a * duration * duration
        + (b - a) * (0.125 * duration * duration + 0.5 * variance)
    )


def curved_part(s: float, axis: 'float[:]') -> 'tuple[float, float, float]':
    """Polynomial of the curved part at s, its derivative and its integral from 0."""
    if axis[Axis.SNAP_SHARE] > 0.0:
        if s > 0.5:
            # the rise is symmetric: what is gained from s on follows from what is gained to 1 - s
            value, slope, integral = snap_plateau_half(1.0 - s, axis)
            middle, rate, half = snap_plateau_half(0.5, axis)
            whole = 2.0 * half + 0.125
            return (
                s - 0.5 + value,
                1.0 - slope,
                whole - 0.5 * s * (1.0 - s) - integral,
            )
        return snap_plateau_half(s, axis)
    count = int(axis[Axis.CURVE_SIZE])
    value = 0.0
    slope = 0.0
    integral = 0.0
    for j in range(count):
        i = count - 1 - j
        value = value * s + axis[Axis.CURVE + i]
        integral = integral * s + axis[Axis.CURVE + i] / (i + 1.0)
        if i > 0:
            slope = slope * s + i * axis[Axis.CURVE + i]
    return value, slope, integral * s


def snap_plateau_half(s: float, axis: 'float[:]') -> 'tuple[float, float, float]':
    """`curved_part` for s <= 1/2 of a jerk rise whose snap has a plateau."""
    share = axis[Axis.SNAP_SHARE]
    count = int(axis[Axis.CURVE_SIZE])
    peak = 1.0 / (1.0 - share)
    u = min(s / share, 1.0)
    first = 0.0
    second = 0.0
    third = 0.0
    for j in range(count):
        i = count - 1 - j
        first = first * u + axis[Axis.CURVE + i] / (i + 1.0)
        second = second * u + axis[Axis.CURVE + i] / ((i + 1.0) * (i + 2.0))
        third = third * u + axis[Axis.CURVE + i] / ((i + 1.0) * (i + 2.0) * (i + 3.0))
    first = peak * share * u * first
    second = peak * share * share * u * u * second
    third = peak * share * share * share * u * u * u * third
    rest = max(s - share, 0.0)
    return (
        second + first * rest + 0.5 * peak * rest * rest,
        first + peak * rest,
        third + second * rest + 0.5 * first * rest * rest + peak * rest * rest * rest / 6.0,
    )


def invert_curved_part(value: float, upper: float, axis: 'float[:]') -> float:
    """The s in [0, upper] at which the increasing curved part, 1/2 at `upper`, has the given value.

    Close enough for an extremum, of which an error in s has only its square. The curved part is
    nearly a square at its upper end.
    """
    low = 0.0
    high = upper
    s = upper * sqrt(min(max(2.0 * value, 0.0), 1.0))
    for i in range(100):
        at, slope, integral = curved_part(s, axis)
        if at > value:
            high = s
        else:
            low = s
        step = 0.5 * (low + high) - s
        if slope > 0.0:
            newton = (value - at) / slope
            if s + newton > low and s + newton < high:
                step = newton
        s = s + step
        if abs(step) <= 1e-9:
            return s
    return s


def ramp_extreme_velocity(
    v: float, a: float, b: float, duration: float, rise: float, axis: 'float[:]'
) -> float:
    """Velocity where the acceleration of a ramp from a to b, of opposite signs, is zero."""
    if abs(a) > abs(b):
        # the symmetric ramp, run backwards from its end, crosses zero in its first half
        return ramp_extreme_velocity_first_half(
            v + 0.5 * (a + b) * duration, -b, -a, duration, rise, axis
        )
    return ramp_extreme_velocity_first_half(v, a, b, duration, rise, axis)


def ramp_extreme_velocity_first_half(
    v: float, a: float, b: float, duration: float, rise: float, axis: 'float[:]'
) -> float:
    """`ramp_extreme_velocity` for |a| <= |b|."""
    if axis[Axis.PLATEAU] < 0.5:
        if axis[Axis.CURVE_SIZE] == 2.0:
            return v - 0.5 * a * a * duration / (b - a)
        s = invert_curved_part(a / (a - b), 0.5, axis)
        value, slope, integral = curved_part(s, axis)
        return v + duration * (a * s + (b - a) * integral)
    jerk = (b - a) / (duration - rise)
    if abs(a) <= 0.5 * abs(jerk) * rise:
        s = invert_curved_part(-a / (jerk * rise), 1.0, axis)
        value, slope, integral = curved_part(s, axis)
        return v + rise * (a * s + jerk * rise * integral)
    value, slope, integral = curved_part(1.0, axis)
    start = a + 0.5 * jerk * rise
    return v + rise * (a + jerk * rise * integral) - 0.5 * start * start / jerk
