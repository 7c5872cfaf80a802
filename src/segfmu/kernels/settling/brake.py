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

from segfmu.kernels.numerics.numbers import FINE, NEVER
from segfmu.kernels.planner.records import Axis
from segfmu.kernels.settling.brake_limits import set_box
from segfmu.kernels.settling.brake_pieces import (
    end_brake,
    note_extremes,
    split_brake,
    time_inside,
)
from segfmu.kernels.settling.chain import STEEPER
from segfmu.kernels.settling.inside import bring_highest, bring_inside
from segfmu.kernels.settling.kept_brakes import keep_brake, kept_brake
from segfmu.kernels.settling.records import KeptBrake, LeadRows, LeadTask, LeadWork
from segfmu.kernels.trajectory.records import Brake, Timing

# derivatives that nothing limits are raised so often, as long as the time of a brake becomes less
# than this share
STEEPEST = 8
SHORTER = 0.997


def clip_reached(lead: 'float[:,:]') -> None:
    """Bring the state BRAKED of `lead` inside by rounding."""
    for i in range(1, int(lead[LeadWork.AXIS, Axis.SMOOTHNESS]) + 1):
        value = max(lead[LeadWork.BRAKED, i], lead[LeadWork.LOWEST, i])
        lead[LeadWork.BRAKED, i] = min(value, lead[LeadWork.HIGHEST, i])


def brake_within(
    steep: float, loose: int, whole: bool, limits: 'float[:]', lead: 'float[:,:]',
    timing: 'float[:,:]', coefficients: 'float[:,:]',
) -> int:
    """`find_brake` with natural limits of one steepness, and loose limits (`set_box`)."""
    smoothness = limits.shape[0] - 1
    report = lead[LeadWork.BRAKE, :]
    report[Brake.UNTIL] = 0.0
    report[Brake.COUNT] = 0.0
    if not set_box(steep, loose, limits, lead):
        return -1
    lead[LeadWork.BRAKED, :] = lead[LeadWork.NOW, :]
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
    return int(report[Brake.COUNT])


def best_steepness(
    loose: int, whole: bool, limits: 'float[:]', lead: 'float[:,:]', timing: 'float[:,:]',
    coefficients: 'float[:,:]',
) -> 'tuple[float, float]':
    """The steepness (`natural_limit`) of the soonest brake, 0 if there is none, and its time [s].

    A time of 0: no brake is needed. Derivatives that nothing limits are raised as long as that
    shortens it (SHORTER).
    """
    highest = 1
    for i in range(limits.shape[0]):
        if limits[i] <= 0.0:
            highest = STEEPEST
    best, steep, chosen = NEVER, 1.0, 0.0
    for i in range(highest):
        count = brake_within(steep, loose, whole, limits, lead, timing, coefficients)
        until = lead[LeadWork.BRAKE, Brake.UNTIL]
        if count >= 0 and until == 0.0:
            return steep, 0.0
        if count > 0 and until < SHORTER * best:
            best = until
            chosen = steep
        elif best < NEVER and i > 1:
            break
        steep = STEEPER * steep
    return chosen, best


def find_brake(
    whole: bool, limits: 'float[:]', lead: 'float[:,:]', timing: 'float[:,:]',
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
    report[:] = 0.0
    count = -1
    kept = kept_brake(whole, limits, lead)
    if kept < 0:
        count = choose_brake(whole, limits, lead, timing, coefficients)
    elif lead[kept, KeptBrake.STEEP] > 0.0:
        for i in range(limits.shape[0]):
            report[Brake.GENTLE + i] = lead[kept, KeptBrake.GENTLE + i]
        count = brake_within(
            lead[kept, KeptBrake.STEEP], int(lead[kept, KeptBrake.LOOSE]), whole, limits, lead,
            timing, coefficients,
        )
    first = 2 * LeadRows.PIECES
    for row in range(first, first + count):
        if timing[row, Timing.START] < report[Brake.UNTIL]:
            note_extremes(row, lead, timing, coefficients)
    return count


def choose_brake(
    whole: bool, limits: 'float[:]', lead: 'float[:,:]', timing: 'float[:,:]',
    coefficients: 'float[:,:]',
) -> int:
    """Search for the soonest brake and keep its choices; the number of its pieces, as above."""
    lead[LeadWork.TASK, LeadTask.COARSE] = 1.0
    steep, loose, until = choose_limits(whole, limits, lead, timing, coefficients)
    if steep > 0.0 and until > 0.0:
        choose_gentle(steep, loose, whole, limits, lead, timing, coefficients)
    lead[LeadWork.TASK, LeadTask.COARSE] = 0.0
    if until == 0.0:
        return int(lead[LeadWork.BRAKE, Brake.COUNT])
    keep_brake(whole, steep, loose, limits, lead)
    if steep == 0.0:
        return -1
    return brake_within(steep, loose, whole, limits, lead, timing, coefficients)


def choose_limits(
    whole: bool, limits: 'float[:]', lead: 'float[:,:]', timing: 'float[:,:]',
    coefficients: 'float[:,:]',
) -> 'tuple[float, int, float]':
    """The steepness of the soonest brake, the order of its loose limits, and its time [s].

    As in `best_steepness`: a steepness of 0: there is none, a time of 0: none is needed.
    """
    report = lead[LeadWork.BRAKE, :]
    smoothness = limits.shape[0] - 1
    loose = smoothness + 1
    chosen, best = best_steepness(loose, whole, limits, lead, timing, coefficients)
    if best == 0.0:
        return chosen, loose, best
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
    return chosen, loose, best


def choose_gentle(
    steep: float, loose: int, whole: bool, limits: 'float[:]', lead: 'float[:,:]',
    timing: 'float[:,:]', coefficients: 'float[:,:]',
) -> None:
    """Choose how gently each derivative comes inside.

    What comes inside at once may have to turn round again for the ones below.
    """
    report = lead[LeadWork.BRAKE, :]
    smoothness = limits.shape[0] - 1
    brake_within(steep, loose, whole, limits, lead, timing, coefficients)
    best = report[Brake.UNTIL]
    for order in range(2, smoothness):
        inside = lead[LeadWork.INSIDE, order]
        gentle = report[Brake.GENTLE + order]
        if 0.0 < inside < report[Brake.UNTIL]:
            for i in range(1, 5):
                report[Brake.GENTLE + order] = 0.25 * i
                count = brake_within(steep, loose, whole, limits, lead, timing, coefficients)
                if count > 0 and report[Brake.UNTIL] < (1.0 - FINE) * best:
                    best = report[Brake.UNTIL]
                    gentle = report[Brake.GENTLE + order]
            report[Brake.GENTLE + order] = gentle
            # the last one that was tried is there
            if gentle < 1.0 and order + 1 < smoothness:
                brake_within(steep, loose, whole, limits, lead, timing, coefficients)
