"""The pieces of a brake: appended, cut, split, and what they reach."""

from segfmu.kernels.settling.attempt import inside_from, part_hull
from segfmu.kernels.settling.brake_limits import lower_limit
from segfmu.kernels.settling.records import Chain, LeadRows, LeadWork
from segfmu.kernels.trajectory.cut import copy_piece
from segfmu.kernels.trajectory.evaluate import evaluate_piece
from segfmu.kernels.trajectory.records import Brake, Check, Timing


def note_extremes(
    row: int, lead: 'float[:,:]', timing: 'float[:,:]', coefficients: 'float[:,:]'
) -> None:
    """Widen the extremes in the row BRAKE of `lead` by those of a piece, or by close bounds."""
    check, report = lead[LeadWork.CHECK:LeadWork.SIZE, :], lead[LeadWork.BRAKE, :]
    width = coefficients.shape[1]
    parts = 8
    step = timing[row, Timing.LENGTH] / parts
    for order in range(1, width // 2 + 2):
        for part in range(parts):
            count = part_hull(order, row, part * step, step, lead, coefficients)
            for i in range(count):
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
    report, reached = lead[LeadWork.BRAKE, :], lead[LeadWork.BRAKED, :]
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
