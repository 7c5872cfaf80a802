"""Stability of the sampled closed loop: its largest eigenvalue over rope length and payload.

The plant is the linearised crane with first-order velocity drives, sampled exactly. The transition
of the controller is computed column by column by calling the kernel `track_setpoint`, so it
includes observer, schedule, disturbance rejection and dead time.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from segfmu.crane.checks import require_not_negative, require_positive, sized
from segfmu.crane.linear import lagged, matrices, sampled
from segfmu.crane.tracking import ESTIMATE, TrackingController
from segfmu.kernels import backend
from segfmu.kernels.control.records import (
    AxisTable,
    Correction,
    Estimate,
    Fading,
    Held,
    Tick,
    Tracker,
    VelocityCommand,
)
from segfmu.kernels.control.records import Observer as Table
from segfmu.kernels.crane.records import Axes, Coordinates, State
from segfmu.kernels.records import field
from segfmu.planning.arrays import FloatArray

# mass of the hook, which the hoist moves without load, as a share of the nominal payload
HOOK = 0.05

# deviation for the columns of the transition [m], [rad] and their rates
PROBE = 1e-6


class LoopState(State):
    """State of the sampled loop."""

    COMMAND = field("velocity commands before the tick", "m/s", size=3)
    ESTIMATE = field("estimates of the observer", size=3 * Estimate.SIZE)
    INPUT = field("corrections as the observer takes them", size=3)
    SIGNALS = field("deviations of the signals one sample before", size=Coordinates.SIZE)
    PAYLOAD = field("estimate of the payload over the nominal one, minus 1")


HOIST = LoopState.POSITION + Axes.ROPE
COMMAND = slice(LoopState.COMMAND, LoopState.ESTIMATE)
ESTIMATES = slice(LoopState.ESTIMATE, LoopState.INPUT)
INPUT = slice(LoopState.INPUT, LoopState.SIGNALS)
SIGNALS = slice(LoopState.SIGNALS, LoopState.PAYLOAD)


def largest_eigenvalue(
    controller: TrackingController,
    length: float,
    payload: float,
    lag: ArrayLike = (0.0, 0.0, 0.0),
) -> float:
    """Largest eigenvalue magnitude of the loop about rest; stable below 1.

    Parameters
    ----------
    controller : TrackingController
        Its observer gives the nominal crane, the drive mode and the dead time.
    length : float
        Rope length [m].
    payload : float
        True payload [kg], 0 or more; a hoist with force drive moves at least HOOK times the nominal
        payload, because its equation needs a mass.
    lag : array_like, shape (3,)
        True lags of the velocity drives [s].

    Raises
    ------
    InputError
        For a length that is not positive, and for a negative payload or lag.
    """
    require_positive("length", length)
    require_not_negative("payload", payload)
    lags = sized("lag", lag, 3).copy()
    for value in lags:
        require_not_negative("lag", value)
    observer = controller.observer
    effect = observer.table[0, Table.BRIDGE :, AxisTable.COMMAND].reshape(3, Estimate.SIZE)
    commanded = (effect != 0.0).any(axis=1)
    if observer.driven:
        # a command that the observer uses is a state, even if the drive has no lag
        lags[commanded] = np.maximum(lags[commanded], 1e-3 * observer.sample_time)
    bridge, trolley, nominal, gravity = observer.crane.masses
    a, b = matrices((bridge, trolley, payload, gravity), length, observer.driven)
    rest = np.zeros(LoopState.SIZE)
    rest[HOIST] = length
    if not observer.driven:
        hoisted = max(payload, HOOK * nominal)
        b[State.VELOCITY + Axes.ROPE, Axes.ROPE] = 1.0 / hoisted
        rest[LoopState.PAYLOAD] = hoisted / nominal - 1.0
    plant = sampled(*lagged(a, b, lags, observer.driven), observer.sample_time)
    loop = _loop(controller, plant, rest)
    kept = [*range(State.SIZE), *range(LoopState.ESTIMATE, LoopState.SIGNALS)]
    if observer.driven:
        kept += [LoopState.COMMAND + int(i) for i in np.flatnonzero(lags)]
    else:
        kept.append(LoopState.PAYLOAD)
    kept += range(LoopState.SIGNALS, LoopState.PAYLOAD) if observer.delayed else ()
    return float(np.abs(np.linalg.eigvals(loop[np.ix_(kept, kept)])).max())


def stability_map(
    controller: TrackingController,
    lengths: ArrayLike,
    payloads: ArrayLike,
    lag: ArrayLike = (0.0, 0.0, 0.0),
) -> FloatArray:
    """`largest_eigenvalue` at rope lengths (m,) [m] and payloads (n,) [kg], shape (m, n)."""
    return np.array(
        [
            [largest_eigenvalue(controller, float(x), float(m), lag) for m in np.asarray(payloads)]
            for x in np.asarray(lengths)
        ]
    )


def _loop(
    controller: TrackingController, plant: tuple[FloatArray, FloatArray], rest: FloatArray
) -> FloatArray:
    """Transition over a sample about rest, for the states of `LoopState`; shape (40, 40)."""
    transition, inputs = plant

    def after(start: FloatArray) -> FloatArray:
        end, correction = _respond(controller, start, rest)
        driven = np.append(start[: State.SIZE], end[COMMAND])
        end[: State.SIZE] = (transition @ driven + inputs @ correction)[: State.SIZE]
        return end

    origin = after(rest)
    columns = [after(rest + PROBE * unit) - origin for unit in np.eye(LoopState.SIZE)]
    return np.array(columns).T / PROBE


def _respond(
    controller: TrackingController, start: FloatArray, rest: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """The controller's states of `_loop` after a tick, and the correction."""
    observer, feedback = controller.observer, controller.feedback
    reference = rest[: State.SIZE].copy()
    true = start[: Coordinates.SIZE]
    tick = np.zeros((Tick.SIZE, Tick.COLUMNS))
    tick[Tick.REFERENCE] = reference
    tick[Tick.SIGNALS, : Coordinates.SIZE] = (
        start[SIGNALS] + reference[: Coordinates.SIZE] if observer.delayed else true
    )
    memory = np.zeros((Tracker.SIZE, Tracker.COLUMNS))
    command, held = memory[Tracker.COMMAND], memory[Tracker.HELD]
    estimate, fading = memory[ESTIMATE, : Estimate.SIZE], memory[Tracker.FADING]
    estimate[:] = start[ESTIMATES].reshape(3, Estimate.SIZE)
    command[: VelocityCommand.STARTED], command[VelocityCommand.STARTED] = start[COMMAND], 1.0
    held[: Held.CORRECTION], held[Held.AWAKE] = start[INPUT], 1.0
    memory[Tracker.REFERENCE] = reference
    fading[Fading.PAYLOAD] = start[LoopState.PAYLOAD]
    backend.track_setpoint(controller.parameters, observer.table, feedback.table, tick, memory)
    end = np.concatenate(
        [
            start[: State.SIZE], command[: VelocityCommand.STARTED], estimate.reshape(-1),
            held[: Held.CORRECTION], true - reference[: Coordinates.SIZE],
            [fading[Fading.PAYLOAD]],
        ]
    )
    return end, tick[Tick.CORRECTION, Correction.VALUE : Correction.FADING]
