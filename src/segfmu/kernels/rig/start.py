"""Where the crane starts, and whether that fits. Statuses are those of StartStatus.

The reference at initialisation puts the crane where a plan begins, whatever the plan is. Start
values of the state are then deviations: they count from the start values that the reference itself
has, so that a crane whose reference is not connected starts as its own start values say.
"""

from math import sqrt

from segfmu.kernels.crane.records import Axes, State
from segfmu.kernels.rig.records import StartFault, StartStatus


def start_state(
    own: 'float[:]', held: 'float[:]', reference: 'float[:]', state: 'float[:]'
) -> None:
    """The state at the start (State,), as far from its reference as its start values say.

    own: start values of the state; held: those of the reference; reference: its values at the
    start. What has the reference for a start value already does not deviate from it, so that models
    in which both follow a moved waypoint stay right. A reference without a rope is none: importers
    write zeros to inputs that they do not use.
    """
    none = reference[State.POSITION + Axes.ROPE] <= 0.0
    for i in range(State.SIZE):
        there = abs(own[i] - reference[i]) <= 1e-9 * (1.0 + abs(own[i]))
        if none or there or reference[i] == held[i]:
            state[i] = own[i]
        else:
            state[i] = reference[i] + (own[i] - held[i])


def check_start(state: 'float[:]', reference: 'float[:]', fault: 'float[:]') -> int:
    """The rope has a length and the load hangs below the trolley, in a state (State,)."""
    rope = State.POSITION + Axes.ROPE
    fault[StartFault.PLACE] = rope
    fault[StartFault.VALUE] = state[rope]
    fault[StartFault.BOUND] = reference[rope]
    if not state[rope] > 0.0:
        return StartStatus.NO_ROPE
    for i in range(State.ANGLE, State.VELOCITY):
        fault[StartFault.PLACE] = i
        fault[StartFault.VALUE] = state[i]
        if not abs(state[i]) < 1.5707963267948966:
            return StartStatus.SWAY
    return StartStatus.FITS


def judge_start(
    state: 'float[:]', reference: 'float[:]', gravity: float, fault: 'float[:]'
) -> int:
    """Whether a state (State,) that can be is near its reference, on the crane's own scale.

    That is a quarter of the rope's length, 45 degrees, and these by the pendulum's time
    sqrt(length / gravity) for rates. Without a rope, the reference is none.
    """
    length = reference[State.POSITION + Axes.ROPE]
    if length <= 0.0:
        return StartStatus.FITS
    farthest = 1.0
    status = StartStatus.FITS
    for i in range(State.SIZE):
        scale = 0.8
        if i < State.ANGLE or (i >= State.VELOCITY and i < State.RATE):
            scale = 0.25 * length
        if i >= State.VELOCITY:
            scale = scale * sqrt(gravity / length)
        distance = abs(state[i] - reference[i]) / scale
        if distance > farthest:
            farthest = distance
            fault[StartFault.PLACE] = i
            fault[StartFault.VALUE] = state[i]
            fault[StartFault.BOUND] = reference[i]
            status = StartStatus.FAR
    return status


def check_start_rope(
    length: float, shortest: float, longest: float, fault: 'float[:]'
) -> int:
    """The rope starts within its bounds [m]; a bound of 0 is none."""
    fault[StartFault.PLACE] = State.POSITION + Axes.ROPE
    fault[StartFault.VALUE] = length
    fault[StartFault.BOUND] = shortest
    if length < shortest:
        return StartStatus.RANGE
    fault[StartFault.BOUND] = longest
    if longest > 0.0 and length > longest:
        return StartStatus.RANGE
    return StartStatus.FITS


def is_elsewhere(before: 'float[:]', reference: 'float[:]', step: float) -> int:
    """1 where a reference (State,) is not what moves in the first step [s] from the one before.

    So it is where an importer hands on values only after initialisation.
    """
    if reference[State.POSITION + Axes.ROPE] <= 0.0:
        return 0
    for i in range(Axes.SIZE):
        moved = 2.0 * step * abs(reference[State.VELOCITY + i])
        small = 1e-3 * abs(reference[State.POSITION + Axes.ROPE])
        if abs(reference[State.POSITION + i] - before[State.POSITION + i]) > moved + small:
            return 1
    return 0
