"""Exact peaks of what a plan asks of the drives.

The demands are analytic functions of time where no polynomial piece begins and friction keeps its
law. There they are interpolated at Chebyshev points; an interval is halved until the last
coefficients vanish, and peaks are found on the interpolating polynomial (Trefethen, Approximation
Theory and Approximation Practice, 2013). An interval whose coefficients leave no room for a larger
value is passed over.

timing, coefficients, offsets and ends are those of the plan, see trajectory/evaluate.py; contacts:
its `Contact` rows of each axis; `work` is a `DemandPeaks`.
"""

from math import cos, sqrt

from segfmu.kernels.crane.demand import motion_demand
from segfmu.kernels.crane.records import Contact, Demand, DemandPeaks, Sought
from segfmu.kernels.crane.suspension import flat_orders
from segfmu.kernels.crane.travel import is_place
from segfmu.kernels.numerics.numbers import NEVER
from segfmu.kernels.trajectory.breaks import next_break
from segfmu.kernels.trajectory.evaluate import evaluate_near

# least samples of an interval between two joints: with four, a search for limits ends in plans that
# use up to 1.5 of a bound, as jerk and snap of a ramp have several peaks
SAMPLES = 8


def demand_peaks(
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
    offsets: 'int[:]',
    ends: 'float[:]',
    resistance: 'float[:]',
    contacts: 'float[:,:,:]',
    work: 'float[:,:]',
    peaks: 'float[:,:]',
    times: 'float[:,:]',
) -> None:
    """Greatest magnitudes of all demands in the positive and in the negative direction.

    Writes them to peaks, and when they are reached [s] to times, (2, Demand.SIZE) both; 0 at time 0
    where there is none in a direction. Of places, the greatest and minus the least one.
    """
    duration = clear_peaks(ends, work, peaks, times)
    for i in range(Demand.SIZE):
        work[DemandPeaks.SCALE, i] = 0.0
    write_transform(work)
    note_value(0.0, timing, coefficients, offsets, ends, resistance, contacts, work, peaks, times)
    # joints that nearly coincide are one; each axis still ends at its end
    for axis in range(ends.shape[0]):
        note_value(
            ends[axis], timing, coefficients, offsets, ends, resistance, contacts, work, peaks,
            times,
        )
    begin = 0.0
    end = next_joint(begin, duration, timing, offsets, ends, contacts)
    while end < NEVER:
        for share in range(2):
            demand_at(
                begin + 0.5 * share * (end - begin), DemandPeaks.CANDIDATE, timing, coefficients,
                offsets, ends, resistance, contacts, work,
            )
            for i in range(Demand.SIZE):
                found = abs(work[DemandPeaks.CANDIDATE, i])
                work[DemandPeaks.SCALE, i] = max(work[DemandPeaks.SCALE, i], found)
        begin = end
        end = next_joint(begin, duration, timing, offsets, ends, contacts)
    share_scale(work)
    begin = 0.0
    end = next_joint(begin, duration, timing, offsets, ends, contacts)
    while end < NEVER:
        search_interval(
            begin, end, timing, coefficients, offsets, ends, resistance, contacts, work, peaks,
            times,
        )
        begin = end
        end = next_joint(begin, duration, timing, offsets, ends, contacts)


def demand_samples(
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
    offsets: 'int[:]',
    ends: 'float[:]',
    resistance: 'float[:]',
    contacts: 'float[:,:,:]',
    work: 'float[:,:]',
    peaks: 'float[:,:]',
    times: 'float[:,:]',
) -> None:
    """As `demand_peaks`, among samples: a fast look that may miss a little of a peak."""
    duration = clear_peaks(ends, work, peaks, times)
    begin = 0.0
    end = next_joint(begin, duration, timing, offsets, ends, contacts)
    while end < NEVER:
        # many intervals are halves and quarters of a plan: rounding must not decide
        count = SAMPLES + int(64.0 * (end - begin) / duration + 1e-6)
        for j in range(count):
            note_value(
                begin + (end - begin) * j / count, timing, coefficients, offsets, ends, resistance,
                contacts, work, peaks, times,
            )
        begin = end
        end = next_joint(begin, duration, timing, offsets, ends, contacts)


def clear_peaks(
    ends: 'float[:]', work: 'float[:,:]', peaks: 'float[:,:]', times: 'float[:,:]'
) -> float:
    """Begin at the first pieces, with no peaks so far. Returns the duration of the plan [s]."""
    duration = 0.0
    for axis in range(ends.shape[0]):
        duration = max(duration, ends[axis])
        work[DemandPeaks.NEAR, axis] = 0.0
    for i in range(Demand.SIZE):
        for side in range(2):
            peaks[side, i] = 0.0
            times[side, i] = 0.0
            if is_place(i):
                peaks[side, i] = -NEVER
    return duration


def write_transform(work: 'float[:,:]') -> None:
    """The matrix from values at the Chebyshev points to the coefficients of the series."""
    last = Sought.NODES - 1
    for k in range(Sought.NODES):
        for j in range(Sought.NODES):
            weight = 2.0 / last
            if j == 0 or j == last:
                weight = 0.5 * weight
            if k == 0 or k == last:
                weight = 0.5 * weight
            angle = 3.141592653589793 * k * (last - j) / last
            work[DemandPeaks.TRANSFORM + k, j] = weight * cos(angle)


def next_joint(
    time: float, duration: float, timing: 'float[:,:]', offsets: 'int[:]', ends: 'float[:]',
    contacts: 'float[:,:,:]',
) -> float:
    """First time [s] after another one at which a piece begins or friction changes its law.

    NEVER after the end of the plan.
    """
    after = time + 1e-12 * duration
    following = next_break(after, timing, offsets, ends)
    for axis in range(contacts.shape[0]):
        for row in range(contacts.shape[1]):
            if contacts[axis, row, Contact.TIME] < NEVER:
                following = sooner(contacts[axis, row, Contact.TIME], after, following)
                following = sooner(contacts[axis, row, Contact.BEGUN], after, following)
                following = sooner(contacts[axis, row, Contact.SLIDES], after, following)
                following = sooner(contacts[axis, row, Contact.SETTLED], after, following)
    if following > duration:
        return NEVER
    return following


def sooner(time: float, after: float, following: float) -> float:
    """The smaller of two times [s], of which the first one counts only after a third."""
    if time > after:
        return min(time, following)
    return following


def demand_at(
    time: float, row: int, timing: 'float[:,:]', coefficients: 'float[:,:]', offsets: 'int[:]',
    ends: 'float[:]', resistance: 'float[:]', contacts: 'float[:,:,:]', work: 'float[:,:]',
) -> None:
    """Write the `Demand` at a time [s] to a row of the work space."""
    load = work[DemandPeaks.LOAD:DemandPeaks.LOAD + flat_orders(resistance), :]
    near = work[DemandPeaks.NEAR, :]
    evaluate_near(time, near, timing, coefficients, offsets, ends, load)
    motion_demand(load, time, resistance, contacts, work, work[row, :])


def sample_demands(
    begin: float, end: float, timing: 'float[:,:]', coefficients: 'float[:,:]', offsets: 'int[:]',
    ends: 'float[:]', resistance: 'float[:]', contacts: 'float[:,:,:]', work: 'float[:,:]',
) -> None:
    """Write the demands at the Chebyshev points between two times [s], ends included."""
    last = Sought.NODES - 1
    for j in range(Sought.NODES):
        time = begin + 0.5 * (end - begin) * (1.0 + cos(3.141592653589793 * (last - j) / last))
        demand_at(
            time, DemandPeaks.VALUES + j, timing, coefficients, offsets, ends, resistance,
            contacts, work,
        )


def share_scale(work: 'float[:,:]') -> None:
    """Resolve drives that hardly act relative to the one that acts most; no sway to rounding."""
    scale = work[DemandPeaks.SCALE, :]
    for group in range(0, Demand.SIZE, 3):
        last = min(group + 3, Demand.SIZE)
        most = 0.0
        for i in range(group, last):
            most = max(most, scale[i])
        for i in range(group, last):
            scale[i] = max(scale[i], 1e-3 * most)
    for i in range(Demand.SWAY, Demand.SIZE):
        scale[i] = max(scale[i], 1e-6)


def search_interval(
    begin: float,
    end: float,
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
    offsets: 'int[:]',
    ends: 'float[:]',
    resistance: 'float[:]',
    contacts: 'float[:,:,:]',
    work: 'float[:,:]',
    peaks: 'float[:,:]',
    times: 'float[:,:]',
) -> None:
    """Note the peaks between two joints [s]; halves of halves follow each other in time."""
    depth = 0
    place = 0
    while depth > 0 or place == 0:
        length = (end - begin) * 0.5 ** depth
        start = begin + place * length
        sample_demands(
            start, start + length, timing, coefficients, offsets, ends, resistance, contacts, work
        )
        if is_resolved(depth, work):
            note_peaks(
                start, length, timing, coefficients, offsets, ends, resistance, contacts, work,
                peaks, times,
            )
            place = place + 1
            while depth > 0 and place % 2 == 0:
                place = place // 2
                depth = depth - 1
        else:
            place = 2 * place
            depth = depth + 1


def is_resolved(depth: int, work: 'float[:,:]') -> bool:
    """Write the series of the samples; whether they need no further halving.

    Coefficients that halving does not lower are rounding, as that of the time in a long plan with
    short ramps.
    """
    resolved = True
    for k in range(Sought.NODES):
        series = work[DemandPeaks.SERIES + k, :]
        for i in range(Demand.SIZE):
            series[i] = 0.0
        for j in range(Sought.NODES):
            weight = work[DemandPeaks.TRANSFORM + k, j]
            values = work[DemandPeaks.VALUES + j, :]
            # one sum behind the other would wait for each addition
            for i in range(Demand.SIZE):
                series[i] = series[i] + weight * values[i]
    for i in range(Demand.SIZE):
        last = DemandPeaks.SERIES + Sought.NODES - 1
        tail = max(abs(work[last, i]), abs(work[last - 1, i]))
        scale = work[DemandPeaks.SCALE, i]
        rounding = False
        if depth > 0:
            before = work[DemandPeaks.TAILS + depth - 1, i]
            rounding = tail <= 1e-5 * scale and tail > 0.1 * before
        if tail > 1e-11 * scale and not rounding:
            resolved = False
        work[DemandPeaks.TAILS + depth, i] = tail
    return resolved or depth == Sought.HALVINGS


def series_value(i: int, place: float, work: 'float[:,:]') -> float:
    """Value of the series of a demand at a place from -1 to 1, by Clenshaw's recurrence."""
    second = 0.0
    first = 0.0
    for j in range(Sought.NODES - 1):
        coefficient = work[DemandPeaks.SERIES + Sought.NODES - 1 - j, i]
        value = coefficient + 2.0 * place * first - second
        second = first
        first = value
    return work[DemandPeaks.SERIES, i] + place * first - second


def note_peaks(
    start: float,
    length: float,
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
    offsets: 'int[:]',
    ends: 'float[:]',
    resistance: 'float[:]',
    contacts: 'float[:,:,:]',
    work: 'float[:,:]',
    peaks: 'float[:,:]',
    times: 'float[:,:]',
) -> None:
    """Note what exceeds the peaks so far in a resolved interval from a start [s] on."""
    for i in range(Demand.SIZE):
        room = 0.0
        for k in range(1, Sought.NODES):
            room = room + abs(work[DemandPeaks.SERIES + k, i])
        # the series knows its values but for this
        rounding = 1e-13 * (abs(work[DemandPeaks.SERIES, i]) + room)
        for side in range(2):
            sign = 1.0 - 2.0 * side
            known = peaks[side, i] - rounding
            if sign * work[DemandPeaks.SERIES, i] + room > known:
                place = peak_place(i, sign, work)
                if sign * series_value(i, place, work) > known:
                    note_value(
                        start + 0.5 * (place + 1.0) * length, timing, coefficients, offsets, ends,
                        resistance, contacts, work, peaks, times,
                    )


def peak_place(i: int, sign: float, work: 'float[:,:]') -> float:
    """Place from -1 to 1 of the largest value of a demand in a direction.

    The best of a grid, then golden sections around it.
    """
    reach = 2.0 / (Sought.GRID - 1)
    best = -1.0
    most = sign * series_value(i, best, work)
    for k in range(1, Sought.GRID):
        value = sign * series_value(i, -1.0 + k * reach, work)
        if value > most:
            most = value
            best = -1.0 + k * reach
    lower = max(best - reach, -1.0)
    upper = min(best + reach, 1.0)
    golden = 0.5 * (sqrt(5.0) - 1.0)
    for _ in range(40):
        left = upper - golden * (upper - lower)
        right = lower + golden * (upper - lower)
        if sign * series_value(i, left, work) < sign * series_value(i, right, work):
            lower = left
        else:
            upper = right
    inner = 0.5 * (lower + upper)
    if sign * series_value(i, inner, work) > most:
        return inner
    return best


def note_value(
    time: float,
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
    offsets: 'int[:]',
    ends: 'float[:]',
    resistance: 'float[:]',
    contacts: 'float[:,:,:]',
    work: 'float[:,:]',
    peaks: 'float[:,:]',
    times: 'float[:,:]',
) -> None:
    """Note all demands at a time [s] that exceed the peaks so far."""
    demand_at(
        time, DemandPeaks.CANDIDATE, timing, coefficients, offsets, ends, resistance, contacts,
        work,
    )
    for i in range(Demand.SIZE):
        for side in range(2):
            value = (1.0 - 2.0 * side) * work[DemandPeaks.CANDIDATE, i]
            if value > peaks[side, i]:
                peaks[side, i] = value
                times[side, i] = time
