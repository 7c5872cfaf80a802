"""The crane linearised about the load hanging at rest, and sampled.

It decouples into bridge with phi_x, trolley with phi_y, and hoist. In the equations of one axis,
the sign of the sway angle is such that the load is at position + l * angle.
"""

from __future__ import annotations

import numpy as np

from segfmu.arrays import FloatArray, as_index, numbers, shown
from segfmu.crane.parameters import Crane
from segfmu.errors import InputError
from segfmu.kernels import backend
from segfmu.kernels.control.records import RopeRange
from segfmu.kernels.crane.records import Axes, State
from segfmu.kernels.messages import SETUP
from segfmu.kernels.rig.records import SetupFault, SetupStatus

Masses = tuple[float, float, float, float]

# signs of phi_x and phi_y in the load's position
SIGNS = (1.0, -1.0)

# of a table: as usual, and at most
ROWS, MOST_ROWS = 17, 10_000

# period of a feedback over sqrt(l / g), at most
PERIOD_SHARE = 0.08


def moved_masses(masses: Masses) -> FloatArray:
    """Masses [kg] moved by the drives of bridge, trolley and hoist, from `Crane.masses`."""
    bridge, trolley, payload, _ = masses
    return np.array([bridge + trolley, trolley, payload])


def linearised(crane: Crane, length: float, driven: bool) -> tuple[FloatArray, FloatArray]:
    """A (10, 10) and B (10, 3) about the load hanging at rest.

    The inputs are the three drive forces, or if `driven` the accelerations of bridge, trolley and
    rope.
    """
    return matrices(crane.masses, length, driven)


def matrices(masses: Masses, length: float, driven: bool) -> tuple[FloatArray, FloatArray]:
    """`linearised` for any masses; with a load of 0 kg the hoist's equation is meaningless."""
    payload, gravity = masses[2:]
    moved = moved_masses(masses)
    a = np.zeros((State.SIZE, State.SIZE))
    a[: State.VELOCITY, State.VELOCITY :] = np.eye(State.VELOCITY)
    b = np.zeros((State.SIZE, Axes.SIZE))
    for axis, sign in enumerate(SIGNS):
        angle, velocity, rate = State.ANGLE + axis, State.VELOCITY + axis, State.RATE + axis
        if driven:
            b[velocity, axis] = 1.0
        else:
            a[velocity, angle] = sign * payload * gravity / moved[axis]
            b[velocity, axis] = 1.0 / moved[axis]
        # l phi'' = -g phi - sign * carriage acceleration
        a[rate] = -sign * a[velocity] / length
        a[rate, angle] -= gravity / length
        b[rate] = -sign * b[velocity] / length
    if driven:
        b[State.VELOCITY + Axes.ROPE, Axes.ROPE] = 1.0
    elif payload > 0.0:
        b[State.VELOCITY + Axes.ROPE, Axes.ROPE] = 1.0 / payload
    return a, b


def sampled(a: FloatArray, b: FloatArray, sample_time: float) -> tuple[FloatArray, FloatArray]:
    """Transition and input matrices over a sample with the inputs held."""
    from scipy.linalg import expm

    n, m = b.shape
    block = np.zeros((n + m, n + m))
    block[:n, :n], block[:n, n:] = a * sample_time, b * sample_time
    transition = expm(block)
    return transition[:n, :n], transition[:n, n:]


def lagged(
    a: FloatArray, b: FloatArray, lag: FloatArray, driven: bool
) -> tuple[FloatArray, FloatArray]:
    """A (13, 13) and B (13, 3) with velocity commands as additional states.

    The input is the rate of the command; the drive follows the command with its lag [s], (3,):
    v' = (command - v) / lag. Without lag, or in force mode, a command has no effect and stays 0.
    """
    own, size = State.SIZE, State.SIZE + Axes.SIZE
    extended, inputs = np.zeros((size, size)), np.zeros((size, Axes.SIZE))
    extended[:own, :own], inputs[:own] = a, b
    for axis in np.flatnonzero(np.asarray(lag) > 0.0) if driven else ():
        # the drive's acceleration takes the place of the carriage's
        extended[:own, own + axis] = b[:, axis] / lag[axis]
        extended[:own, State.VELOCITY + axis] -= b[:, axis] / lag[axis]
        inputs[:own, axis] = 0.0
        inputs[own + axis, axis] = 1.0
    return extended, inputs


def scheduled_lengths(shortest: float, longest: float, rows: int = ROWS) -> FloatArray:
    """Rope lengths [m] of a table, in equal ratios; one if both are the same.

    Raises
    ------
    InputError
        For rope lengths that are not positive or not ascending.
    """
    ends, fault = numbers("rope lengths", [shortest, longest]), np.zeros(SetupFault.SIZE)
    if ends.ndim > 1:
        raise InputError(
            f"rope lengths must be two numbers, got {shown(shortest)} and {shown(longest)}"
        )
    status = backend.check_lengths(ends, fault)
    if status != SetupStatus.FITS:
        raise InputError(SETUP.text(status, fault.tolist()))
    lengths = np.zeros(as_index("rows", rows, MOST_ROWS, least=1))
    first, last = ends.tolist()
    return lengths[: backend.table_lengths(first, last, lengths.size, lengths)].copy()


def rope_range(crane: Crane, length: float) -> tuple[float, float]:
    """Ends [m] of a controller's table: the crane's range, or by the rope's length at the start."""
    found = np.zeros(RopeRange.SIZE)
    backend.rope_range(length, crane.rope_min or 0.0, crane.rope_max or 0.0, found)
    return float(found[RopeRange.SHORTEST]), float(found[RopeRange.LONGEST])


def usual_sample_time(gravity: float, shortest: float, sampling: float = 0.0) -> float:
    """Period [s] of a feedback that is short for the pendulum at its shortest rope [m].

    It is 1, 2 or 5 of a decade and at most PERIOD_SHARE of sqrt(l / g); with sampled signals, whole
    samples [s], at least one.
    """
    most = PERIOD_SHARE * float(np.sqrt(shortest / gravity))
    if sampling > 0.0:
        return sampling * max(1.0, float(np.floor(most / sampling + 1e-9)))
    decade = float(10.0 ** np.floor(np.log10(most)))
    return max(d * decade for d in (1.0, 2.0, 5.0) if d == 1.0 or d * decade <= most)
