"""Check that rope and sling stay taut, and the rope within its range, along a load's trajectory.

That the load stays below the trolley and its sling taut is proved as for a load on the rope
(crane/rope.py). The path of the hook is no polynomial: what it has to keep is looked at among
samples of each interval between breaks, and where a sample is least, around it.
"""

from math import sqrt

from segfmu.kernels.crane.records import FlatSeries, Masses, RopeBounds, RopeDemand, RopeFault
from segfmu.kernels.crane.rope import check_rope
from segfmu.kernels.hook.inverse import write_sling
from segfmu.kernels.hook.records import HookMargins, HookPath
from segfmu.kernels.numerics.numbers import NEVER
from segfmu.kernels.trajectory.breaks import next_break
from segfmu.kernels.trajectory.evaluate import evaluate_orders


def check_hook(
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
    offsets: 'int[:]',
    ends: 'float[:]',
    masses: 'float[:]',
    hook_mass: float,
    sling: float,
    bounds: 'float[:]',
    polynomials: 'float[:,:]',
    work: 'float[:,:]',
    report: 'float[:]',
) -> int:
    """Check a trajectory x, y, z, as `check_rope` with the same arguments does.

    masses (Masses.SIZE), mass of the hook [kg] and length of the sling [m]; polynomials: the work
    space of `check_rope`; work: HookPath. Returns a `RopeDemand`.
    """
    free = work[HookPath.FREE, :]
    free[RopeBounds.GRAVITY] = bounds[RopeBounds.GRAVITY]
    free[RopeBounds.SHORTEST] = 0.0
    free[RopeBounds.LONGEST] = 0.0
    status = check_rope(timing, coefficients, offsets, free, polynomials, report)
    if status != RopeDemand.MET:
        return status
    for i in range(HookMargins.SIZE):
        work[HookPath.FIRST, i] = NEVER
        work[HookPath.LEAST, i] = NEVER
    begin = 0.0
    end = next_break(begin, timing, offsets, ends)
    write_margins(
        begin, timing, coefficients, offsets, ends, masses, hook_mass, sling, bounds, work
    )
    while end < NEVER:
        look_around(
            begin, end, timing, coefficients, offsets, ends, masses, hook_mass, sling, bounds, work
        )
        begin = end
        end = next_break(begin, timing, offsets, ends)
    return judge_margins(bounds, work, report)


def look_around(
    begin: float, end: float, timing: 'float[:,:]', coefficients: 'float[:,:]', offsets: 'int[:]',
    ends: 'float[:]', masses: 'float[:]', hook_mass: float, sling: float, bounds: 'float[:]',
    work: 'float[:,:]',
) -> None:
    """Note the margins of samples between two times [s], and of the least ones between samples."""
    count = 32
    for j in range(count + 1):
        for i in range(HookMargins.SIZE):
            work[HookPath.SAMPLES, i] = work[HookPath.SAMPLES + 1, i]
            work[HookPath.SAMPLES + 1, i] = work[HookPath.SAMPLES + 2, i]
        time = begin + (end - begin) * j / count
        write_margins(
            time, timing, coefficients, offsets, ends, masses, hook_mass, sling, bounds, work
        )
        if j > 1 and is_dip(work):
            lower = begin + (end - begin) * (j - 2) / count
            for k in range(1, count):
                write_margins(
                    lower + (time - lower) * k / count, timing, coefficients, offsets, ends,
                    masses, hook_mass, sling, bounds, work,
                )
            write_margins(
                time, timing, coefficients, offsets, ends, masses, hook_mass, sling, bounds, work
            )


def is_dip(work: 'float[:,:]') -> bool:
    """Whether a margin may become negative around the middle one of the last three samples."""
    for i in range(HookMargins.SIZE):
        before = work[HookPath.SAMPLES, i]
        middle = work[HookPath.SAMPLES + 1, i]
        after = work[HookPath.SAMPLES + 2, i]
        if middle <= min(before, after) and 2.0 * middle < max(before, after):
            return True
    return False


def write_margins(
    time: float, timing: 'float[:,:]', coefficients: 'float[:,:]', offsets: 'int[:]',
    ends: 'float[:]', masses: 'float[:]', hook_mass: float, sling: float, bounds: 'float[:]',
    work: 'float[:,:]',
) -> None:
    """Write the margins (HookMargins) at a time [s] to the last row of samples; note negative ones.

    Lengths are allowed to differ by what rounding makes of a plan at its bound.
    """
    tolerance = 1e-9
    motion = work[HookPath.MOTION:HookPath.FREE, :]
    margins = work[HookPath.SAMPLES + 2, :]
    evaluate_orders(time, timing, coefficients, offsets, ends, motion)
    share = hook_mass / masses[Masses.PAYLOAD_MASS]
    write_sling(motion, 3, masses, hook_mass, sling, work)
    w_x = work[FlatSeries.PULL, 0]
    w_y = work[FlatSeries.PULL + 1, 0]
    w_z = work[FlatSeries.PULL + 2, 0]
    depth = -work[FlatSeries.LOAD + 2, 0]
    margins[HookMargins.TAUT] = w_z / (1.0 + share) - tolerance * masses[Masses.GRAVITY]
    margins[HookMargins.BELOW] = depth - tolerance
    margins[HookMargins.SHORT] = NEVER
    margins[HookMargins.LONG] = NEVER
    # a rope that is not taut, or leads downwards, has no length
    if w_z > 0.0 and depth > 0.0:
        length = depth * sqrt(w_x * w_x + w_y * w_y + w_z * w_z) / w_z
        if bounds[RopeBounds.LONGEST] > 0.0:
            margins[HookMargins.SHORT] = bounds[RopeBounds.LONGEST] * (1.0 + tolerance) - length
        if bounds[RopeBounds.SHORTEST] > 0.0:
            margins[HookMargins.LONG] = length - bounds[RopeBounds.SHORTEST] * (1.0 - tolerance)
    for i in range(HookMargins.SIZE):
        work[HookPath.LEAST, i] = min(work[HookPath.LEAST, i], margins[i])
        if margins[i] < 0.0:
            work[HookPath.FIRST, i] = min(work[HookPath.FIRST, i], time)


def judge_margins(bounds: 'float[:]', work: 'float[:,:]', report: 'float[:]') -> int:
    """The first demand that the margins do not meet, and the report on it."""
    first = work[HookPath.FIRST, :]
    least = work[HookPath.LEAST, :]
    if first[HookMargins.TAUT] < NEVER:
        report[RopeFault.TIME] = first[HookMargins.TAUT]
        report[RopeFault.BOUND] = bounds[RopeBounds.GRAVITY]
        report[RopeFault.WORST] = bounds[RopeBounds.GRAVITY] - least[HookMargins.TAUT]
        return RopeDemand.ALL_TAUT
    if first[HookMargins.BELOW] < NEVER:
        report[RopeFault.TIME] = first[HookMargins.BELOW]
        report[RopeFault.BOUND] = 0.0
        report[RopeFault.WORST] = -least[HookMargins.BELOW]
        return RopeDemand.END_BELOW_TROLLEY
    if first[HookMargins.SHORT] < NEVER:
        report[RopeFault.TIME] = first[HookMargins.SHORT]
        report[RopeFault.BOUND] = bounds[RopeBounds.LONGEST]
        report[RopeFault.WORST] = bounds[RopeBounds.LONGEST] - least[HookMargins.SHORT]
        return RopeDemand.NOT_TOO_LONG
    if first[HookMargins.LONG] < NEVER:
        report[RopeFault.TIME] = first[HookMargins.LONG]
        report[RopeFault.BOUND] = bounds[RopeBounds.SHORTEST]
        report[RopeFault.WORST] = bounds[RopeBounds.SHORTEST] + least[HookMargins.LONG]
        return RopeDemand.NOT_TOO_SHORT
    return RopeDemand.MET
