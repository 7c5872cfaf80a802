"""What limits are searched for: the axes of a motion and the bounds of their drives.

positions, velocities, accelerations: of the waypoints in x, y and z, (points, 3); bounds: a
`DriveBounds`; resistance: a `Resistance`; axes: an `AxisTask` per row.
"""

from math import exp

from segfmu.kernels.crane.bounds import hanging_mass
from segfmu.kernels.crane.records import Axes, Demand, DriveBounds, Resistance
from segfmu.kernels.crane.travel import is_place
from segfmu.kernels.crane.uses import bound_magnitude, bound_origin
from segfmu.kernels.limits.records import AxisTask, LimitRow, Unknown
from segfmu.kernels.numerics.numbers import NEVER


def write_axes(
    narrow: bool,
    positions: 'float[:,:]',
    velocities: 'float[:,:]',
    accelerations: 'float[:,:]',
    bounds: 'float[:]',
    caps: 'float[:,:]',
    resistance: 'float[:]',
    axes: 'float[:,:]',
) -> None:
    """Write the rows of all axes; caps (3, LimitRow.SIZE): largest limits, 0: none.

    narrow: bounds and caps are those of `narrow_bounds`, and friction gives no direction either.
    """
    for axis in range(axes.shape[0]):
        row = axes[axis, :]
        for i in range(AxisTask.SIZE):
            row[i] = 0.0
        for i in range(LimitRow.SIZE):
            row[AxisTask.CAP + i] = NEVER
            if caps[axis, i] > 0.0:
                row[AxisTask.CAP + i] = caps[axis, i]
        write_motion_of(axis, positions, velocities, accelerations, row)
        write_farthest(axis, positions, resistance, row)
        if row[AxisTask.MOVES] > 0.5:
            row[AxisTask.HELD] = max(
                resistance[Resistance.STATIC + axis], resistance[Resistance.COULOMB + axis]
            )
        write_directions(axis, bounds, row)
        if not narrow and is_braked_by_friction(axis, bounds, row):
            row[AxisTask.DIRECTED + 1] = 1.0
        write_floors(axis, velocities, accelerations, row)
        if axis == Axes.ROPE:
            row[AxisTask.HELD + 1] = hanging_mass(resistance) * resistance[Resistance.GRAVITY]


def narrow_bounds(bounds: 'float[:]', caps: 'float[:,:]') -> None:
    """Put the smaller of the bounds, and of the limits, of both directions in both.

    But for the force of the hoist: what the rope carries has no other direction.
    """
    for i in range(Demand.POWER):
        least = bounds[DriveBounds.FORCE_MIN + i]
        if least < 0.0 and i != Demand.FORCE + Axes.ROPE:
            if bounds[i] == 0.0 or -least < bounds[i]:
                bounds[i] = -least
            bounds[DriveBounds.FORCE_MIN + i] = 0.0
    for axis in range(caps.shape[0]):
        for i in range(LimitRow.SIZE - LimitRow.VELOCITY_MIN):
            ahead = caps[axis, i]
            back = caps[axis, LimitRow.VELOCITY_MIN + i]
            least = min(ahead, back)
            if least <= 0.0:
                least = max(ahead, back)
            caps[axis, i] = least
            caps[axis, LimitRow.VELOCITY_MIN + i] = least


def write_motion_of(
    axis: int, positions: 'float[:,:]', velocities: 'float[:,:]', accelerations: 'float[:,:]',
    row: 'float[:]',
) -> None:
    """Write how an axis moves. A hoist goes the other way than the load."""
    ahead = 0.0
    back = 0.0
    for k in range(positions.shape[0]):
        velocity = velocities[k, axis]
        row[AxisTask.FASTEST] = max(row[AxisTask.FASTEST], abs(velocity))
        way = 0.0
        if k > 0:
            way = positions[k, axis] - positions[k - 1, axis]
        row[AxisTask.DISTANCE] = max(row[AxisTask.DISTANCE], abs(way))
        if velocity > 0.0 or way > 0.0:
            ahead = 1.0
        if velocity < 0.0 or way < 0.0:
            back = 1.0
        if velocity != 0.0 or accelerations[k, axis] != 0.0 or way != 0.0:
            row[AxisTask.MOVES] = 1.0
    if ahead < 0.5 and back < 0.5:
        # it swings back and forth, if it is only accelerated
        ahead = row[AxisTask.MOVES]
        back = row[AxisTask.MOVES]
    row[AxisTask.GOES] = ahead
    row[AxisTask.GOES + 1] = back
    if axis == Axes.ROPE:
        row[AxisTask.GOES] = back
        row[AxisTask.GOES + 1] = ahead


def write_farthest(
    axis: int, positions: 'float[:,:]', resistance: 'float[:]', row: 'float[:]'
) -> None:
    """Write how far waypoints take a carriage, or the rope, if the load rests there."""
    for side in range(2):
        row[AxisTask.FARTHEST + side] = -NEVER
    for k in range(positions.shape[0]):
        place = positions[k, axis]
        if axis == Axes.ROPE:
            place = -place - resistance[Resistance.SLING]
        row[AxisTask.FARTHEST] = max(row[AxisTask.FARTHEST], place)
        row[AxisTask.FARTHEST + 1] = max(row[AxisTask.FARTHEST + 1], -place)


def differs(i: int, bounds: 'float[:]') -> bool:
    """Whether a demand has another bound in the negative direction."""
    return bound_magnitude(i, 0, bounds) != bound_magnitude(i, 1, bounds)


def write_directions(axis: int, bounds: 'float[:]', row: 'float[:]') -> None:
    """Write which limits of an axis differ by direction.

    A velocity backwards does not tell where an axis does not turn, nor the force of a hoist, which
    pulls, whichever way the load is accelerated.
    """
    turns = row[AxisTask.GOES] > 0.5 and row[AxisTask.GOES + 1] > 0.5
    if turns and differs(Demand.VELOCITY + axis, bounds):
        row[AxisTask.DIRECTED] = 1.0
    forced = axis != Axes.ROPE and differs(Demand.FORCE + axis, bounds)
    if forced or differs(Demand.ACCELERATION + axis, bounds):
        row[AxisTask.DIRECTED + 1] = 1.0
    for i in range(2):
        caps = AxisTask.CAP + i
        if row[caps] != row[caps + LimitRow.VELOCITY_MIN]:
            row[AxisTask.DIRECTED + i] = 1.0


def is_braked_by_friction(axis: int, bounds: 'float[:]', row: 'float[:]') -> bool:
    """Whether an axis can brake harder than it can drive, as it goes in one direction alone."""
    turns = row[AxisTask.GOES] > 0.5 and row[AxisTask.GOES + 1] > 0.5
    forced = bounds[DriveBounds.FORCE_MAX + axis] > 0.0
    return forced and row[AxisTask.HELD] > 0.0 and not turns and axis != Axes.ROPE


def held_force(side: int, row: 'float[:]') -> float:
    """What no slower motion reduces of a drive's force in a direction [N]; below 0: it helps."""
    weight = row[AxisTask.HELD + 1]
    if weight > 0.0:
        return max(row[AxisTask.HELD] + (2.0 * side - 1.0) * weight, 0.0)
    if row[AxisTask.GOES + side] < 0.5:
        return -row[AxisTask.HELD]
    return row[AxisTask.HELD]


def write_floors(
    axis: int, velocities: 'float[:,:]', accelerations: 'float[:,:]', row: 'float[:]'
) -> None:
    """Write the least limits of velocity and acceleration, which admit the states."""
    for k in range(velocities.shape[0]):
        for i in range(2):
            state = velocities[k, axis]
            if i == 1:
                state = accelerations[k, axis]
            ahead = AxisTask.FLOOR + LimitRow.VELOCITY + i
            back = AxisTask.FLOOR + LimitRow.VELOCITY_MIN + i
            directed = row[AxisTask.DIRECTED + i] > 0.5
            if state > 0.0 or not directed:
                row[ahead] = max(row[ahead], abs(state))
            if state < 0.0 or not directed:
                row[back] = max(row[back], abs(state))


def write_kinds(axes: 'float[:,:]', kinds: 'float[:]') -> None:
    """Write which limits are searched for, the first 3 LimitRow.SIZE unknowns (`Unknown`)."""
    for axis in range(axes.shape[0]):
        for i in range(LimitRow.SIZE):
            kinds[axis * LimitRow.SIZE + i] = Unknown.GIVEN
            own = axes[axis, AxisTask.MOVES] > 0.5
            if i >= LimitRow.VELOCITY_MIN:
                same = i - LimitRow.VELOCITY_MIN
                own = own and axes[axis, AxisTask.DIRECTED + same] > 0.5
            if own:
                kinds[axis * LimitRow.SIZE + i] = Unknown.LIMIT


def write_limits(unknowns: 'float[:]', axes: 'float[:,:]', table: 'float[:,:]') -> None:
    """Write the limits (3, LimitRow.SIZE) that unknowns stand for, within floors and caps."""
    for axis in range(axes.shape[0]):
        for i in range(LimitRow.SIZE):
            own = i
            if i >= LimitRow.VELOCITY_MIN:
                same = i - LimitRow.VELOCITY_MIN
                if axes[axis, AxisTask.DIRECTED + same] < 0.5:
                    own = same
            value = exp(min(max(unknowns[axis * LimitRow.SIZE + own], -300.0), 300.0))
            value = max(value, axes[axis, AxisTask.FLOOR + own])
            table[axis, i] = min(value, axes[axis, AxisTask.CAP + own])


def write_shares(
    peaks: 'float[:,:]', bounds: 'float[:]', axes: 'float[:,:]', uses: 'float[:]'
) -> None:
    """Write what motion uses of that which bounds leave for it, (2 Demand.SIZE).

    No slower plan reduces dry friction and weight, nor how far the waypoints are. In the positive,
    then in the negative direction; 0 without a bound. At most 1 exactly where the peaks
    (2, Demand.SIZE) are within the bounds.
    """
    for i in range(Demand.SIZE):
        for side in range(2):
            bound = bound_magnitude(i, side, bounds)
            used = peaks[side, i] - bound_origin(i, side, bounds)
            held = 0.0
            if i < Demand.VELOCITY:
                held = held_force(side, axes[i, :])
            if is_place(i):
                held = axes[i - Demand.PLACE, AxisTask.FARTHEST + side]
                held = held - bound_origin(i, side, bounds)
            full = bound <= held * (1.0 + 1e-6)
            if full:
                held = 0.0
            uses[side * Demand.SIZE + i] = 0.0
            if bound > 0.0:
                uses[side * Demand.SIZE + i] = max(used - held, 0.0) / (bound - held)
            # a waypoint at an end stop leaves nothing to use
            if is_place(i) and full and used <= bound * (1.0 + 1e-9):
                uses[side * Demand.SIZE + i] = 0.0
