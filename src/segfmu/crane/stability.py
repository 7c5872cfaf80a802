"""Stability of the sampled closed loop: its largest eigenvalue over rope length and payload.

The plant is the linearised crane with first-order velocity drives, sampled exactly. The transition
of the controller is computed column by column by calling the kernel `track_setpoint`, so it
includes observer, schedule, disturbance rejection and delays. A delay counts the same wherever it
is on the way around the loop; here all of it is on the way from the sensors to the controller.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from segfmu.arrays import FloatArray, as_tuple, shown, sized
from segfmu.crane.checks import require_kind, require_not_negative, require_positive
from segfmu.crane.linear import lagged, matrices, sampled
from segfmu.crane.tracking import ESTIMATE, TrackingController
from segfmu.errors import InputError
from segfmu.kernels import backend
from segfmu.kernels.control.records import (
    AxisTable,
    Correction,
    Estimate,
    Fading,
    GainInputs,
    Gains,
    Held,
    Past,
    Tick,
    Tracker,
    Tracking,
    VelocityCommand,
)
from segfmu.kernels.control.records import Observer as Table
from segfmu.kernels.crane.records import Axes, Coordinates, State

# mass of the hook, which the hoist moves without load, as a share of the nominal payload
HOOK = 0.05

# deviation for the columns of the transition [m], [rad] and their rates
PROBE = 1e-6

HOIST = State.POSITION + Axes.ROPE
PLANT = State.SIZE + Axes.SIZE
DELAY = slice(Tracking.DELAY, Tracking.DELAY + Axes.SIZE)


@dataclass(frozen=True)
class Layout:
    """Places in the state of the sampled loop.

    That is the plant's state, its velocity commands, the estimates, the estimate of the payload
    over the nominal one less 1, corrections of past ticks and late signals, the latest ones first.

    Attributes
    ----------
    delays : tuple of 3 float
        Delays of the axes, in samples.
    """

    delays: tuple[float, float, float]

    @property
    def late(self) -> int:
        """Rows of late signals, (5,) each."""
        return int(max(self.delays)) + 1

    @property
    def estimates(self) -> slice:
        """Estimates, (3, 6)."""
        return slice(PLANT, PLANT + Axes.SIZE * Estimate.SIZE)

    @property
    def payload(self) -> int:
        """Estimate of the payload."""
        return PLANT + Axes.SIZE * Estimate.SIZE

    @property
    def past(self) -> slice:
        """Corrections of past ticks, (late + 2, 3)."""
        first = self.payload + 1
        return slice(first, first + (self.late + 2) * Axes.SIZE)

    @property
    def signals(self) -> slice:
        """Late signals, (late, 5)."""
        return slice(self.past.stop, self.past.stop + self.late * Coordinates.SIZE)

    def axis_of(self, signal: int) -> int:
        """The axis that a signal belongs to."""
        return signal if signal < Coordinates.ANGLE else signal - Coordinates.ANGLE


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
        Its observer gives the nominal crane, the drive mode and the delays.
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
    require_kind("controller", controller, TrackingController)
    require_positive("length", length)
    require_not_negative("payload", payload)
    lags = sized("lag", lag, 3).copy()
    for value in lags:
        require_not_negative("lag", value)
    observer = controller.observer
    used = observer.driven & ((lags > 0.0) | _commanded(controller))
    # a command that the controller uses is a state, even if the drive has no lag
    lags = np.where(used, np.maximum(lags, 1e-3 * observer.sample_time), 0.0)
    first, second, third = controller.parameters[DELAY].tolist()
    layout = Layout((first, second, third))
    bridge, trolley, nominal, gravity = observer.crane.masses
    a, b = matrices((bridge, trolley, payload, gravity), length, observer.driven)
    rest = np.zeros(layout.signals.stop)
    rest[HOIST] = length
    rest[layout.signals] = np.tile(rest[: Coordinates.SIZE], layout.late)
    if not observer.driven:
        hoisted = max(payload, HOOK * nominal)
        b[State.VELOCITY + Axes.ROPE, Axes.ROPE] = 1.0 / hoisted
        rest[layout.payload] = hoisted / nominal - 1.0
    loop = _loop(controller, lagged(a, b, lags, observer.driven), rest, layout)
    kept = [*range(State.SIZE), *(State.SIZE + np.flatnonzero(used))]
    kept += range(layout.estimates.start, layout.estimates.stop)
    kept += range(layout.payload + observer.driven, layout.signals.stop)
    own = loop[np.ix_(kept, kept)]
    if not np.isfinite(own).all():
        raise InputError(
            f"the loop has no finite numbers at {length:.6g} m of rope with {payload:.6g} kg and "
            f"lags of {shown(lag)} s; take smaller ones"
        )
    return float(np.abs(np.linalg.eigvals(own)).max())


def _commanded(controller: TrackingController) -> NDArray[np.bool_]:
    """Whether observer or gains use the velocity command of an axis, shape (3,)."""
    effect = controller.observer.table[0, Table.BRIDGE :, AxisTable.COMMAND]
    gains = controller.feedback.table[0, Gains.AXES :, GainInputs.COMMAND]
    observed = (effect.reshape(3, Estimate.SIZE) != 0.0).any(axis=1)
    found: NDArray[np.bool_] = observed | (gains != 0.0)
    return found


def stability_map(
    controller: TrackingController,
    lengths: ArrayLike,
    payloads: ArrayLike,
    lag: ArrayLike = (0.0, 0.0, 0.0),
) -> FloatArray:
    """`largest_eigenvalue` at rope lengths (m,) [m] and payloads (n,) [kg], shape (m, n).

    Raises
    ------
    InputError
        As that does, and for what is no list.
    """
    rows, columns = as_tuple("lengths", lengths), as_tuple("payloads", payloads)
    return np.array(
        [[largest_eigenvalue(controller, x, m, lag) for m in columns] for x in rows]
    )


def _loop(
    controller: TrackingController,
    plant: tuple[FloatArray, FloatArray],
    rest: FloatArray,
    layout: Layout,
) -> FloatArray:
    """Transition over a sample about rest, for the states of a `Layout`."""
    period = controller.sample_time
    transition, inputs = sampled(*plant, period)
    # how the plant advances until the signals of each axis are sampled
    until = [sampled(*plant, (1.0 - d % 1.0) * period) for d in layout.delays]

    def after(start: FloatArray) -> FloatArray:
        end, correction = _respond(controller, start, rest, layout)
        driven = np.append(start[: State.SIZE], end[State.SIZE : PLANT])
        end[: State.SIZE] = (transition @ driven + inputs @ correction)[: State.SIZE]
        late = end[layout.signals].reshape(layout.late, Coordinates.SIZE)
        late[1:] = late[:-1].copy()
        for signal in range(Coordinates.SIZE):
            advance, act = until[layout.axis_of(signal)]
            late[0, signal] = advance[signal] @ driven + act[signal] @ correction
        return end

    origin = after(rest)
    columns = [after(rest + PROBE * unit) - origin for unit in np.eye(rest.size)]
    return np.array(columns).T / PROBE


def _respond(
    controller: TrackingController, start: FloatArray, rest: FloatArray, layout: Layout
) -> tuple[FloatArray, FloatArray]:
    """The state after a tick with that of the plant before it, and the correction."""
    reference = rest[: State.SIZE]
    tick = np.zeros((Tick.SIZE, Tick.COLUMNS))
    tick[Tick.REFERENCE, : State.SIZE] = reference
    tick[Tick.ADDED_TO, : Axes.SIZE] = controller.holding
    late = start[layout.signals].reshape(layout.late, Coordinates.SIZE)
    for signal in range(Coordinates.SIZE):
        delay = layout.delays[layout.axis_of(signal)]
        tick[Tick.SIGNALS, signal] = late[int(delay), signal]
    memory = np.zeros((Tracker.SIZE, Tracker.COLUMNS))
    command, held = memory[Tracker.COMMAND], memory[Tracker.HELD]
    estimate, fading = memory[ESTIMATE, : Estimate.SIZE], memory[Tracker.FADING]
    past = start[layout.past].reshape(-1, Axes.SIZE)
    rows = memory[Tracker.PAST :]
    estimate[:] = start[layout.estimates].reshape(Axes.SIZE, Estimate.SIZE)
    command[: VelocityCommand.STARTED] = start[State.SIZE : PLANT]
    command[VelocityCommand.STARTED] = held[Held.AWAKE] = 1.0
    held[: Held.CORRECTION] = past[0]
    rows[: len(past) - 1, : Past.REFERENCE] = past[1:]
    rows[:, Past.REFERENCE : Past.SIZE] = reference
    fading[Fading.PAYLOAD] = start[layout.payload]
    parameters, table, gains, _ = controller.arrays
    backend.track_setpoint(parameters, table, gains, tick, memory)
    end = start.copy()
    end[State.SIZE : PLANT] = command[: VelocityCommand.STARTED]
    end[layout.estimates] = estimate.reshape(-1)
    end[layout.payload] = fading[Fading.PAYLOAD]
    end[layout.past] = np.concatenate([held[: Held.CORRECTION], past[:-1].reshape(-1)])
    return end, tick[Tick.CORRECTION, Correction.VALUE : Correction.FADING]
