"""The brake of one axis: from a state outside its limits to one inside, as soon as possible.

The derivatives come inside one after the other, the highest one first, each as soon as those above
permit. To the next derivative it is what a position is to a velocity: that goes as far as its
limit, is held there, and would be let go in time (attempt.py). One that is about to leave its
limits, as those above cannot turn it round in time, is brought back in the same way. So a brake
ends in a state from which all derivatives can stay inside.

Where a derivative comes inside at once, those above it have to turn round again before the ones
below can follow. So it is also brought inside gently, if that makes the whole brake shorter.

With the smoothness 2 this is the brake of Ruckig (Berscheid and Kroeger, Jerk-limited Real-time
Trajectory Generation with Arbitrary Target States, RSS 2021).
"""

from segfmu.kernels.planner.parameters import axis_limits, ramp_parameters, usual_share
from segfmu.kernels.planner.records import Axis, Lower, Shape
from segfmu.kernels.planner.sides import set_lower
from segfmu.kernels.settling.attempt import (
    inside_from,
    lead_to,
    outside_by,
    part_hull,
    stays_inside,
    try_brake,
)
from segfmu.kernels.settling.chain import chain_limits, set_chains
from segfmu.kernels.settling.records import Chain, LeadRows, LeadWork
from segfmu.kernels.trajectory.check import rounding_error
from segfmu.kernels.trajectory.cut import copy_piece
from segfmu.kernels.trajectory.evaluate import evaluate_piece
from segfmu.kernels.trajectory.records import Brake, Check, Timing


def set_box(steep: float, loose: int, limits: 'float[:]', lead: 'float[:,:]') -> bool:
    """Set the limits of a brake, and the chains; False if there are no ramps within them.

    Where a limit is absent a natural one, which the state NOW of `lead` keeps, takes its place.
    steep as in `natural_limit`. Derivatives from the order `loose` on may stay as large as in NOW.
    """
    smoothness = limits.shape[0] - 1
    axis = lead[LeadWork.AXIS, :]
    state = lead[LeadWork.STATE, :]
    axis_limits(smoothness, int(Shape.PLATEAU), limits, axis)
    set_lower(lead[LeadWork.LOWER, :], axis)
    for i in range(loose, smoothness + 1):
        if limits[i - 1] > 0.0:
            axis[Axis.VELOCITY + i - 1] = max(limits[i - 1], abs(lead[LeadWork.NOW, i]))
    if not ramp_parameters(usual_share(axis), axis, lead[LeadWork.CHAINS:LeadWork.PLAN, :]):
        return False
    for i in range(Chain.SIZE):
        state[i] = 0.0
    for i in range(1, smoothness + 1):
        lead[LeadWork.ROUNDING, i] = rounding_error(i, limits)
        if limits[i - 1] <= 0.0:
            state[i] = lead[LeadWork.NOW, i]
    chain_limits(steep, axis, state, lead[LeadWork.LIMITS, :])
    set_chains(steep, axis, lead[LeadWork.LIMITS, :], lead[LeadWork.CHAINS:LeadWork.PLAN, :])
    for i in range(1, smoothness + 2):
        lead[LeadWork.LOWEST, i] = -lead[LeadWork.LIMITS, i]
        if i <= Lower.SIZE:
            lead[LeadWork.LOWEST, i] = -axis[Axis.LOWER + i - 1]
        lead[LeadWork.HIGHEST, i] = lead[LeadWork.LIMITS, i]
    return True


def lower_limit(order: int, limits: 'float[:]', lead: 'float[:,:]') -> float:
    """The limit of a derivative in the negative direction, 0 if absent."""
    if order <= Lower.SIZE and lead[LeadWork.LOWER, order - 1] > 0.0:
        return lead[LeadWork.LOWER, order - 1]
    return limits[order - 1]


def is_outside(limits: 'float[:]', lead: 'float[:,:]') -> bool:
    """Whether a derivative in the row NOW of `lead` is beyond its limit by more than rounding."""
    for i in range(1, limits.shape[0]):
        value = lead[LeadWork.NOW, i]
        bound = limits[i - 1]
        if value < 0.0:
            bound = lower_limit(i, limits, lead)
        if bound > 0.0 and abs(value) > bound * (1.0 + 1e-12):
            return True
    return False


def note_extremes(row: int, lead: 'float[:,:]', timing: 'float[:,:]', coefficients: 'float[:,:]'
) -> None:
    """Widen the extremes in the row BRAKE of `lead` by those of a piece, or by close bounds."""
    check = lead[LeadWork.CHECK:LeadWork.SIZE, :]
    report = lead[LeadWork.BRAKE, :]
    width = coefficients.shape[1]
    parts = 8
    step = timing[row, Timing.LENGTH] / parts
    for order in range(1, width // 2 + 2):
        for part in range(parts):
            part_hull(order, row, part * step, step, lead, coefficients)
            for i in range(width - order):
                value = check[Check.HULLS, i]
                report[Brake.LOWEST + order] = min(report[Brake.LOWEST + order], value)
                report[Brake.HIGHEST + order] = max(report[Brake.HIGHEST + order], value)


def append_pieces(
    until: float, last: int, lead: 'float[:,:]', timing: 'float[:,:]', coefficients: 'float[:,:]'
) -> None:
    """Append what was tried, as far as a time [s], to the brake; BRAKED goes on to there."""
    report = lead[LeadWork.BRAKE, :]
    for row in range(int(LeadRows.PIECES), last):
        target = 2 * LeadRows.PIECES + int(report[Brake.COUNT])
        if timing[row, Timing.START] >= until or target >= LeadRows.ALL:
            break
        copy_piece(timing, coefficients, row, timing, coefficients, target)
        report[Brake.COUNT] = report[Brake.COUNT] + 1.0
    end_brake(until, lead, timing, coefficients)


def end_brake(
    until: float, lead: 'float[:,:]', timing: 'float[:,:]', coefficients: 'float[:,:]'
) -> None:
    """Leave out what a brake does after a time [s]; BRAKED becomes the state at its end."""
    report = lead[LeadWork.BRAKE, :]
    reached = lead[LeadWork.BRAKED, :]
    width = coefficients.shape[1]
    first = 2 * LeadRows.PIECES
    count = int(report[Brake.COUNT])
    while count > 0 and timing[first + count - 1, Timing.START] >= until:
        count = count - 1
    report[Brake.COUNT] = count
    if count > 0:
        row = first + count - 1
        length = min(timing[row, Timing.LENGTH], until - timing[row, Timing.START])
        timing[row, Timing.LENGTH] = length
        for i in range(width // 2 + 1):
            reached[i] = evaluate_piece(coefficients, row, width, length, i)
        reached[Chain.TIME] = timing[row, Timing.START] + length


def split_brake(
    until: float, lead: 'float[:,:]', timing: 'float[:,:]', coefficients: 'float[:,:]'
) -> None:
    """Let a piece of the brake end at a time [s], and another one begin."""
    report = lead[LeadWork.BRAKE, :]
    width = coefficients.shape[1]
    first = 2 * LeadRows.PIECES
    last = first + int(report[Brake.COUNT])
    for row in range(first, last):
        local = until - timing[row, Timing.START]
        if local > 0.0 and local < timing[row, Timing.LENGTH] and last < LeadRows.ALL:
            for i in range(last - row):
                copy_piece(timing, coefficients, last - 1 - i, timing, coefficients, last - i)
            factorial = 1.0
            for i in range(width):
                if i > 0:
                    factorial = factorial * i
                value = evaluate_piece(coefficients, row, width, local, i)
                coefficients[row + 1, i] = value / factorial
            timing[row + 1, Timing.START] = until
            timing[row + 1, Timing.LENGTH] = timing[row, Timing.LENGTH] - local
            timing[row, Timing.LENGTH] = local
            report[Brake.COUNT] = report[Brake.COUNT] + 1.0
            break


def time_inside(
    limits: 'float[:]', lead: 'float[:,:]', timing: 'float[:,:]', coefficients: 'float[:,:]'
) -> float:
    """Time [s] from which on all derivatives are inside the limits themselves in the brake."""
    first = 2 * LeadRows.PIECES
    last = first + int(lead[LeadWork.BRAKE, Brake.COUNT])
    until = 0.0
    for i in range(1, limits.shape[0]):
        if limits[i - 1] > 0.0 and last > first:
            lead[LeadWork.LOWEST, i] = -lower_limit(i, limits, lead)
            lead[LeadWork.HIGHEST, i] = limits[i - 1]
            row, local = inside_from(i, first, last, lead, timing, coefficients)
            until = max(until, timing[row, Timing.START] + local)
    return until


def level_limit(order: int, side: float, lead: 'float[:,:]') -> float:
    """The limit of the derivative above one that is to come back from a side."""
    if side < 0.0:
        return lead[LeadWork.HIGHEST, order + 1]
    return lead[LeadWork.LOWEST, order + 1]


def best_level(
    order: int,
    side: float,
    settled: bool,
    lead: 'float[:,:]',
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
) -> 'tuple[float, float]':
    """The soonest time of `try_brake`, 1e300 if there is none, and its level."""
    edge = level_limit(order, side, lead)
    least = try_brake(order, side, edge, settled, lead, timing, coefficients)
    best = edge
    share = 1.0
    if least < 0.0:
        # the deepest level from which the derivative does not end beyond its other limit
        least = 1e300
        low = 0.0
        high = 1.0
        for i in range(60):
            share = 0.5 * (low + high)
            time = try_brake(order, side, share * edge, settled, lead, timing, coefficients)
            if time < 0.0:
                high = share
            else:
                low = share
                if time < least:
                    least = time
                    best = share * edge
    for i in range(6):
        share = 0.5 * share
        if i == 5:
            share = 0.0
        if least > lead[LeadWork.BRAKED, Chain.TIME]:
            time = try_brake(order, side, share * edge, settled, lead, timing, coefficients)
            if time >= 0.0 and time < least:
                least = time
                best = share * edge
    return least, best


def level_time(
    order: int,
    side: float,
    gentle: float,
    settled: bool,
    lead: 'float[:,:]',
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
) -> 'tuple[float, float]':
    """The time of `try_brake` and its level: a part of the limit, the best one if gentle is 0."""
    if gentle > 0.0:
        level = (1.0 - gentle) * level_limit(order, side, lead)
        time = try_brake(order, side, level, settled, lead, timing, coefficients)
        if time >= 0.0 and time < 1e299:
            return time, level
    return best_level(order, side, settled, lead, timing, coefficients)


def side_beyond(
    order: int, lead: 'float[:,:]', timing: 'float[:,:]', coefficients: 'float[:,:]'
) -> float:
    """1 for a derivative that is or gets beyond its upper limit, -1 for the lower one, 0: neither.

    Though the one above it goes to zero at once.
    """
    state = lead[LeadWork.STATE, :]
    reached = lead[LeadWork.BRAKED, :]
    low = lead[LeadWork.LOWEST, order]
    first = int(LeadRows.PIECES)
    for i in range(Chain.SIZE):
        state[i] = reached[i]
    last = lead_to(order + 1, 0.0, first, lead, timing, coefficients)
    for i in range(2):
        value = state[order]
        if i == 1:
            value = reached[order]
        if outside_by(value, order, lead) > 0.0:
            if value > low:
                return 1.0
            return -1.0
    if last >= 0 and stays_inside(order, first, last, lead, timing, coefficients):
        return 0.0
    if reached[order + 1] > 0.0:
        return 1.0
    return -1.0


def bring_highest(
    lead: 'float[:,:]', timing: 'float[:,:]', coefficients: 'float[:,:]'
) -> None:
    """Bring the derivative n inside."""
    order = int(lead[LeadWork.AXIS, Axis.SMOOTHNESS])
    value = lead[LeadWork.BRAKED, order]
    end = min(max(value, lead[LeadWork.LOWEST, order]), lead[LeadWork.HIGHEST, order])
    if outside_by(value, order, lead) > 0.0:
        for i in range(Chain.SIZE):
            lead[LeadWork.STATE, i] = lead[LeadWork.BRAKED, i]
        last = lead_to(order, end, int(LeadRows.PIECES), lead, timing, coefficients)
        until = lead[LeadWork.STATE, Chain.TIME]
        append_pieces(until, last, lead, timing, coefficients)
        lead[LeadWork.BRAKE, Brake.UNTIL] = until
    lead[LeadWork.BRAKED, order] = end


def bring_gently(
    order: int, lead: 'float[:,:]', timing: 'float[:,:]', coefficients: 'float[:,:]'
) -> bool:
    """Bring a derivative to its limit, those above it to zero; False: that is not possible."""
    first = int(LeadRows.PIECES)
    reached = lead[LeadWork.BRAKED, :]
    state = lead[LeadWork.STATE, :]
    value = reached[order]
    if not outside_by(value, order, lead) > 0.0:
        return False
    end = min(max(value, lead[LeadWork.LOWEST, order]), lead[LeadWork.HIGHEST, order])
    for i in range(Chain.SIZE):
        state[i] = reached[i]
    last = lead_to(order, end, first, lead, timing, coefficients)
    if last < 0:
        return False
    for i in range(order + 1, int(lead[LeadWork.AXIS, Axis.SMOOTHNESS]) + 2):
        if not stays_inside(i, first, last, lead, timing, coefficients):
            return False
    until = state[Chain.TIME]
    append_pieces(until, last, lead, timing, coefficients)
    for i in range(order + 1, int(lead[LeadWork.AXIS, Axis.SMOOTHNESS]) + 1):
        reached[i] = 0.0
    reached[order] = end
    lead[LeadWork.BRAKE, Brake.UNTIL] = until
    return True


def bring_inside(
    order: int,
    whole: bool,
    lead: 'float[:,:]',
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
) -> bool:
    """Bring a derivative inside, those above it are; False: no attempt does.

    whole: let it go as well, so that those above end at zero.
    """
    report = lead[LeadWork.BRAKE, :]
    reached = lead[LeadWork.BRAKED, :]
    gentle = report[Brake.GENTLE + order]
    if gentle == 1.0 and bring_gently(order, lead, timing, coefficients):
        return True
    side = side_beyond(order, lead, timing, coefficients)
    if side == 0.0 and not whole:
        return True
    time = 1e300
    level = 0.0
    settled = False
    for i in range(2):
        if time > 1e299:
            settled = i == 1
            if side == 0.0:
                time = try_brake(order, 1.0, 0.0, settled, lead, timing, coefficients)
            else:
                time, level = level_time(order, side, gentle, settled, lead, timing, coefficients)
    if time > 1e299:
        return False
    start = reached[Chain.TIME]
    if side != 0.0:
        try_brake(order, side, level, settled, lead, timing, coefficients)
    if time > start:
        report[Brake.UNTIL] = time
    elif not whole:
        return True
    if whole:
        time = 1e300
    append_pieces(time, int(report[Brake.LAST]), lead, timing, coefficients)
    for i in range(order, reached.shape[0] - 2):
        if i <= int(lead[LeadWork.AXIS, Axis.SMOOTHNESS]):
            if whole and i > order:
                reached[i] = 0.0
            low = lead[LeadWork.LOWEST, i]
            reached[i] = min(max(reached[i], low), lead[LeadWork.HIGHEST, i])
    return True


def clip_reached(lead: 'float[:,:]') -> None:
    """Bring the state BRAKED of `lead` inside by rounding."""
    for i in range(1, int(lead[LeadWork.AXIS, Axis.SMOOTHNESS]) + 1):
        value = max(lead[LeadWork.BRAKED, i], lead[LeadWork.LOWEST, i])
        lead[LeadWork.BRAKED, i] = min(value, lead[LeadWork.HIGHEST, i])


def brake_within(
    steep: float,
    loose: int,
    whole: bool,
    limits: 'float[:]',
    lead: 'float[:,:]',
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
) -> int:
    """`find_brake` with natural limits of one steepness, and loose limits (`set_box`)."""
    smoothness = limits.shape[0] - 1
    report = lead[LeadWork.BRAKE, :]
    report[Brake.UNTIL] = 0.0
    report[Brake.COUNT] = 0.0
    for i in range(smoothness + 2):
        report[Brake.LOWEST + i] = 0.0
        report[Brake.HIGHEST + i] = 0.0
    if not set_box(steep, loose, limits, lead):
        return -1
    for i in range(Chain.SIZE):
        lead[LeadWork.BRAKED, i] = lead[LeadWork.NOW, i]
    bring_highest(lead, timing, coefficients)
    let_go = whole or loose <= smoothness
    for i in range(1, smoothness):
        order = smoothness - i
        if not bring_inside(order, let_go and order == 1, lead, timing, coefficients):
            return -1
    if let_go:
        # where limits are loose, all end inside the given ones only as they are let go
        if loose <= smoothness:
            report[Brake.UNTIL] = time_inside(limits, lead, timing, coefficients)
        split_brake(report[Brake.UNTIL], lead, timing, coefficients)
        if not whole:
            end_brake(report[Brake.UNTIL], lead, timing, coefficients)
            clip_reached(lead)
    first = 2 * LeadRows.PIECES
    for row in range(first, first + int(report[Brake.COUNT])):
        if timing[row, Timing.START] < report[Brake.UNTIL]:
            note_extremes(row, lead, timing, coefficients)
    return int(report[Brake.COUNT])


def best_steepness(
    loose: int,
    whole: bool,
    limits: 'float[:]',
    lead: 'float[:,:]',
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
) -> 'tuple[float, float]':
    """The steepness (`natural_limit`) of the soonest brake, 0 if there is none, and its time [s].

    A time of 0: no brake is needed. Derivatives that nothing limits are raised as long as that
    shortens it by more than 0.3 %.
    """
    highest = 1
    for i in range(limits.shape[0]):
        if limits[i] <= 0.0:
            highest = 8
    best = 1e300
    steep = 1.0
    chosen = 0.0
    for i in range(highest):
        count = brake_within(steep, loose, whole, limits, lead, timing, coefficients)
        until = lead[LeadWork.BRAKE, Brake.UNTIL]
        if count >= 0 and until == 0.0:
            return steep, 0.0
        if count > 0 and until < 0.997 * best:
            best = until
            chosen = steep
        elif best < 1e299 and i > 2:
            break
        steep = 10.0 * steep
    return chosen, best


def find_brake(
    whole: bool,
    limits: 'float[:]',
    lead: 'float[:,:]',
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
) -> int:
    """Find the brake from the state in the row NOW of `lead`; the number of its pieces.

    0: the state can stay inside its limits. -1: no brake was found. limits are c_1 .. c_{n+1}, 0
    where absent; the caller sets the row LOWER as well. whole: the brake goes on until all
    derivatives above the velocity are zero.

    Written: the rows BRAKE and BRAKED, and pieces from the row 2 LeadRows.PIECES on of timing and
    coefficients, which have LeadRows.ALL rows.
    """
    smoothness = limits.shape[0] - 1
    if smoothness < 2 or smoothness > 6 or coefficients.shape[1] != 2 * smoothness:
        return -1
    report = lead[LeadWork.BRAKE, :]
    for i in range(Brake.SIZE):
        report[i] = 0.0
    loose = smoothness + 1
    chosen, best = best_steepness(loose, whole, limits, lead, timing, coefficients)
    if best == 0.0:
        return int(report[Brake.COUNT])
    # a jerk far beyond its limit takes so long to come inside that the velocity gets beyond all
    # bounds; so it may stay as large as it is, in both directions, where that halves the time
    for i in range(smoothness - 2):
        order = smoothness - i
        if limits[order - 1] > 0.0 and abs(lead[LeadWork.NOW, order]) > limits[order - 1]:
            steep, until = best_steepness(order, whole, limits, lead, timing, coefficients)
            if steep > 0.0 and until < 0.5 * best:
                chosen = steep
                best = until
                loose = order
    if chosen == 0.0 and smoothness > 2:
        # an acceleration that comes inside at once may leave the velocity no way to follow
        report[Brake.GENTLE + 2] = 0.5
        chosen, best = best_steepness(loose, whole, limits, lead, timing, coefficients)
    if chosen == 0.0:
        return -1
    # what comes inside at once may have to turn round again for the ones below
    for order in range(2, smoothness):
        gentle = report[Brake.GENTLE + order]
        for i in range(1, 5):
            report[Brake.GENTLE + order] = 0.25 * i
            count = brake_within(chosen, loose, whole, limits, lead, timing, coefficients)
            if count > 0 and report[Brake.UNTIL] < 0.999 * best:
                best = report[Brake.UNTIL]
                gentle = report[Brake.GENTLE + order]
        report[Brake.GENTLE + order] = gentle
    return brake_within(chosen, loose, whole, limits, lead, timing, coefficients)
