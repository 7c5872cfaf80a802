"""Stability of the sampled closed loop: its largest eigenvalue over rope length and payload.

The plant is the linearised crane with velocity drives of first order, sampled exactly. The
controller is the one that runs: its transition is read from the kernel `track_setpoint` column by
column, so observer, schedule, disturbance rejection and dead time are all in.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from segfmu.crane.checks import require_not_negative, require_positive, sized
from segfmu.crane.linear import lagged, matrices, sampled
from segfmu.crane.tracking import MEMORY, TrackingController
from segfmu.kernels import backend
from segfmu.planning.arrays import FloatArray

# of the nominal payload: what the hook weighs, which the hoist moves when there is no load
HOOK = 0.05

# of the loop, see `_loop`
STATES = 40

# deviations by which the controller is read [m], [rad] and their rates
PROBE = 1e-6


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
        Its observer has the nominal crane, the mode of the drives, and the dead time.
    length : float
        Rope length [m].
    payload : float
        True payload [kg], down to 0; a hoist with force drive moves at least HOOK of the nominal
        one, as a rope with nothing on it is not a system.
    lag : array_like, shape (3,)
        True lags of the velocity drives [s].

    Raises
    ------
    InputError
        For a length that is not positive, a negative payload or lag.
    """
    require_positive("length", length)
    require_not_negative("payload", payload)
    lags = sized("lag", lag, 3).copy()
    for value in lags:
        require_not_negative("lag", value)
    observer = controller.observer
    commanded = (observer.table[0, :, 6].reshape(3, 6) != 0.0).any(axis=1)
    if observer.driven:
        # a command that the observer reckons with is a state, however fast the drive is
        lags[commanded] = np.maximum(lags[commanded], 1e-3 * observer.sample_time)
    bridge, trolley, nominal, gravity = observer.crane.masses
    a, b = matrices((bridge, trolley, payload, gravity), length, observer.driven)
    rest = np.zeros(STATES)
    rest[2] = length
    if not observer.driven:
        hoisted = max(payload, HOOK * nominal)
        b[7, 2] = 1.0 / hoisted
        rest[-1] = hoisted / nominal - 1.0
    plant = sampled(*lagged(a, b, lags, observer.driven), observer.sample_time)
    loop = _loop(controller, plant, rest)
    kept = [*range(10), *range(13, 34)]
    kept += [10 + int(i) for i in np.flatnonzero(lags)] if observer.driven else [STATES - 1]
    kept += range(34, 39) if observer.delayed else ()
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
    """Transition over a sample about rest, (STATES, STATES).

    The states are the plant's (10), the velocity commands before the tick (3), the estimate (18),
    the inputs that the observer takes (3), the signals one sample before (5), and the estimate of
    the payload.
    """
    transition, inputs = plant

    def after(start: FloatArray) -> FloatArray:
        end, correction = _respond(controller, start, rest)
        end[:10] = (transition @ np.append(start[:10], end[10:13]) + inputs @ correction)[:10]
        return end

    origin = after(rest)
    columns = [after(rest + PROBE * unit) - origin for unit in np.eye(STATES)]
    return np.array(columns).T / PROBE


def _respond(
    controller: TrackingController, start: FloatArray, rest: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """The states of `_loop` after a tick, but for the plant's own, and the correction."""
    observer, feedback = controller.observer, controller.feedback
    reference = rest[:10].copy()
    signals = (start[34:39] + reference[:5]) if observer.delayed else start[:5].copy()
    memory, correction = np.zeros(MEMORY), np.zeros(3)
    memory[:3, :6] = start[13:31].reshape(3, 6)
    memory[3, :3], memory[4, :3], memory[6] = start[10:13], start[31:34], reference
    memory[3, 3], memory[4, 6], memory[5, 3] = 1.0, 1.0, start[-1]
    backend.track_setpoint(
        controller.parameters, observer.lengths, observer.table, feedback.lengths, feedback.gains,
        signals, reference, np.zeros(3), memory, correction,
    )
    end = np.concatenate(
        [
            start[:10], memory[3, :3], memory[:3, :6].reshape(-1), memory[4, :3],
            start[:5] - reference[:5], memory[5, 3:4],
        ]
    )
    return end, correction
