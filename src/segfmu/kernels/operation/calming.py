"""A swing that is taken over: the load comes to rest, somewhere or in a target.

Velocities of bridge and trolley are cubic B-splines inside the bounds of their drives (centre.py).
With the pull of the rope known, the ways that end the swing follow from two linear conditions an
axis (controlled.py), and those to a target from a third one. The pull is first taken from a load
that only swings on, then from the last motion, until the load hangs still. Without a target the
hoist brakes as fast as it can. The time is the least for which there are such ways, by halving.
"""

from math import sqrt

from segfmu.kernels.crane.records import Demand, DriveBounds, Masses
from segfmu.kernels.numerics.numbers import NEVER
from segfmu.kernels.operation.centre import control_bound, decline_line, find_centre, most_change
from segfmu.kernels.operation.controlled import (
    fits_plan,
    run_controlled,
    set_control_start,
    swing_frequency,
    write_controlled,
)
from segfmu.kernels.operation.proof import prove_crane
from segfmu.kernels.operation.records import (
    Aim,
    Control,
    Known,
    Operation,
    OperationStatus,
    OperationWork,
    Swing,
)


def used_share() -> float:
    """Share of the bounds that is used, so that the proof does not need many intervals."""
    return 0.998


def brake_hoist(share: float, interval: float, known: 'float[:,:]', work: 'float[:,:]') -> bool:
    """Let the hoist brake as fast as a share of its bound permits; whether it rests at the end."""
    points = work[OperationWork.CONTROL + 2, :]
    for i in range(Control.FREE, Control.POINTS):
        fall = most_change(2, -1.0, share, interval, known)
        rise = most_change(2, 1.0, share, interval, known)
        points[i] = points[i - 1] + min(max(-points[i - 1], -fall), rise)
    return points[Control.INTERVALS] == 0.0


def calms_within(
    duration: float, share: float, operation: 'float[:,:]', known: 'float[:,:]',
    work: 'float[:,:]',
) -> bool:
    """Whether a share of the bounds brings the load of the state SWING to rest in a time [s].

    If the AIM is a target, the load rests there.

    The control points of the way are in `work` then.
    """
    swing = operation[Operation.SWING, :]
    aims = work[OperationWork.AIM, :]
    last = int(Control.PLACE)
    interval = duration / Control.INTERVALS
    frequency = swing_frequency(known[Known.CRANE, Masses.GRAVITY], swing)
    set_control_start(interval, swing, work)
    for axis in range(2):
        decline_line(axis, work)
    if operation[Operation.AIM, Aim.IS_TARGET] > 0.5:
        last = int(Control.CONDITIONS)
        set_way(2, operation, work)
        if not find_centre(2, share, interval, Control.PLACE, last, aims, known, work):
            return False
    elif not brake_hoist(share, interval, known, work):
        return False
    if not fits_plan(interval, operation, known, work):
        return False
    before = NEVER
    for _ in range(most_runs()):
        angle = run_controlled(interval, operation, known, work)
        # rounding is left
        if angle < 1e-12 or (angle < 1e-10 and angle > 0.5 * before):
            return True
        before = angle
        for axis in range(2):
            set_way(axis, operation, work)
            aims[Control.SWING] = swing[Swing.RATE + axis]
            aims[Control.SWING + 1] = -frequency * swing[Swing.PATH + axis]
            if not find_centre(axis, share, interval, Control.SWING, last, aims, known, work):
                return False
    return False


def set_way(axis: int, operation: 'float[:,:]', work: 'float[:,:]') -> None:
    """Set the way of a drive [m] from the state SWING to where the load is in the target."""
    sense = 1.0
    if axis == 2:
        # the rope grows downwards
        sense = -1.0
    work[OperationWork.AIM, Control.PLACE] = (
        sense * operation[Operation.AIM, Aim.VALUE + axis]
        - operation[Operation.SWING, Swing.POSITION + axis]
    )


def most_runs() -> int:
    """Most motions until the load hangs still."""
    return 30


def least_time(
    share: float, operation: 'float[:,:]', known: 'float[:,:]', work: 'float[:,:]'
) -> float:
    """A time [s] less than any in which the load can be brought to rest, without nonlinearities.

    An acceleration changes the velocity of carriage and load by no more than itself.
    """
    swing = operation[Operation.SWING, :]
    frequency = swing_frequency(known[Known.CRANE, Masses.GRAVITY], swing)
    found = 1e-3 / frequency
    for axis in range(3):
        least = min(
            control_bound(Demand.ACCELERATION + axis, 1.0, share, 0.0, known),
            control_bound(Demand.ACCELERATION + axis, -1.0, share, 0.0, known),
        )
        velocity = abs(swing[Swing.VELOCITY + axis])
        if axis < 2:
            place = frequency * swing[Swing.PATH + axis]
            rate = swing[Swing.RATE + axis]
            velocity = max(velocity, sqrt(place * place + rate * rate))
        found = max(found, velocity / least)
        if operation[Operation.AIM, Aim.IS_TARGET] > 0.5:
            set_way(axis, operation, work)
            way = work[OperationWork.AIM, Control.PLACE]
            fastest = control_bound(Demand.VELOCITY + axis, way, share, 0.0, known)
            if fastest > 0.0:
                found = max(found, abs(way) / fastest)
    return found


def seek_calm(
    share: float, operation: 'float[:,:]', known: 'float[:,:]', work: 'float[:,:]'
) -> float:
    """The least time [s] in which the load comes to rest; 0: none is known.

    The control points of the way are in `work` then.
    """
    tried = least_time(share, operation, known, work)
    missed = tried
    count = 0
    while not calms_within(tried, share, operation, known, work):
        missed = tried
        tried = 1.25 * tried
        count = count + 1
        if count == most_growths():
            return 0.0
    found = tried
    while found > 1.01 * missed:
        tried = 0.5 * (missed + found)
        if calms_within(tried, share, operation, known, work):
            found = tried
        else:
            missed = tried
    if tried != found and not calms_within(found, share, operation, known, work):
        return 0.0
    return found


def most_growths() -> int:
    """How often the time is prolonged by a quarter."""
    return 20


def plan_calm(
    operation: 'float[:,:]', known: 'float[:,:]', timing: 'float[:,:,:]',
    coefficients: 'float[:,:,:]', offsets: 'int[:]', work: 'float[:,:]', stack: 'float[:,:,:]',
) -> int:
    """Plan from the state SWING to rest, by AIM, into the slot TRIED: an `OperationStatus`.

    Where forces or powers do not allow it, with less of the accelerations.
    """
    for drive in range(3):
        if not known[Known.BOUNDS, DriveBounds.ACCELERATION_MAX + drive] > 0.0:
            return OperationStatus.DRIVES
    status = int(OperationStatus.DRIVES)
    share = used_share()
    for _ in range(4):
        duration = seek_calm(share, operation, known, work)
        if duration == 0.0:
            return OperationStatus.DRIVES
        write_controlled(
            duration / Control.INTERVALS, operation, known, timing, coefficients, offsets, work
        )
        status = prove_crane(Demand.SWAY, known, timing, coefficients, offsets, work, stack)
        if status != OperationStatus.DRIVES:
            return status
        share = 0.7 * share
    return status
