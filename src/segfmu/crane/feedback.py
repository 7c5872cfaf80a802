"""Sway feedback Delta u = -K(l) (x - x*) of section 4.4: sampled LQR, scheduled.

Gains are scheduled by rope length and, in force mode, by payload; with velocity drives the payload
has no effect on the motion. Each design is discretised with a zero-order hold over the period. The
weights apply to the crane made dimensionless with the rope length l and the pendulum's frequency
sqrt(g / l), so that one set of weights suits every crane.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from functools import lru_cache

import numpy as np
from numpy.typing import ArrayLike

from segfmu.arrays import (
    FloatArray,
    as_flag,
    as_tuple,
    finite_number,
    finite_vector,
    shown,
    sized,
    table_of,
)
from segfmu.crane.checks import (
    lags_of,
    require_kind,
    require_not_negative,
    require_positive,
    require_weights,
)
from segfmu.crane.linear import (
    ROWS,
    lagged,
    linearised,
    moved_masses,
    sampled,
    scheduled_lengths,
)
from segfmu.crane.parameters import Crane
from segfmu.errors import InputError
from segfmu.kernels.control.records import GainInputs, Gains
from segfmu.kernels.control.setting import weak_drive
from segfmu.kernels.crane.records import Axes, State

# unit of the effort, as a multiple of the moved weight
EFFORT = 3.0

# pendulum's frequency times dead time and period [rad] from which on effort costs more
PATIENCE, HOIST_PATIENCE = 0.25, 0.15

# ratio of weights or masses from which on it is the reason why there is no gain
FAR = 1e6
MASSES = ("bridge_mass", "trolley_mass", "payload_mass")

# these weights must be positive: without them no gain exists, or nothing holds the position
NEEDED = ("position", "effort", "rope")


@dataclass(frozen=True)
class Weights:
    """Weights of the dimensionless design: carriage position, sway, their rates, and effort.

    `rope` weights the rope's length; 9 gives the hoist a bandwidth of three times the pendulum's
    frequency, which does not limit it.
    """

    position: float = 1.0
    angle: float = 1.0
    velocity: float = 1.0
    rate: float = 1.0
    effort: float = 1.0
    rope: float = 9.0

    def __post_init__(self) -> None:
        require_weights(vars(self), NEEDED)


@dataclass(frozen=True, eq=False)
class SwayFeedback:
    """Gain table over rope length.

    Attributes
    ----------
    sample_time : float
        Period of the sampled feedback [s].
    lengths : ndarray, shape (rows,)
        Rope lengths [m], ascending.
    gains : ndarray, shape (rows, 3, 11)
        From the state error to the corrections of the three forces [N], or in velocity mode of
        the three accelerations [m/s2]; the last column is by the velocity that the corrections of
        the axis have added, and may be left out where no drive has a lag.
    payload : float
        Design payload [kg].
    table : ndarray, shape (rows, 4, 11)
        Lengths and gains for the kernels, one `Gains` per row.

    Raises
    ------
    InputError
        For other shapes, rope lengths that are not positive and ascending, and a period or a
        payload that is not positive.
    """

    sample_time: float
    lengths: FloatArray
    gains: FloatArray
    payload: float
    table: FloatArray = field(init=False, repr=False)

    def __post_init__(self) -> None:
        require_positive("sample_time", self.sample_time)
        require_positive("payload", self.payload)
        lengths = _ascending("lengths", self.lengths, "m")
        gains = table_of("gains", self.gains, lengths.size, Axes.SIZE, None)
        if gains.shape[2] not in (State.SIZE, GainInputs.SIZE):
            raise InputError(
                f"gains must be by {State.SIZE} or {GainInputs.SIZE} errors, got {gains.shape[2]}"
            )
        table = np.zeros((lengths.size, Gains.SIZE, Gains.COLUMNS))
        table[:, Gains.LENGTH, 0] = lengths
        table[:, Gains.AXES :, : gains.shape[2]] = gains
        found = {"lengths": lengths, "gains": gains, "table": table}
        for name, value in found.items():
            object.__setattr__(self, name, value)


def _ascending(name: str, value: ArrayLike, unit: str) -> FloatArray:
    values = finite_vector(name, value)
    if values[0] <= 0.0 or (np.diff(values) <= 0.0).any():
        raise InputError(
            f"{name} must be positive and ascending, got {shown(values.tolist())} {unit}"
        )
    return values


# the interface of an FMU is described several times in a build, with the same table of gains
@lru_cache(maxsize=1024)
# numbers that are too large are refused below, with their names
@np.errstate(all="ignore")
def gain(
    crane: Crane,
    length: float,
    sample_time: float,
    weights: Weights,
    driven: bool,
    lag: tuple[float, ...],
    dead_time: float = 0.0,
    strongest: tuple[float, ...] | None = None,
) -> FloatArray:
    """Discrete-time LQR gain at one rope length, shape (3, 11); a row is a `GainInputs`.

    The velocity command of a drive with lag is a state beside those of the crane. Effort costs more
    where dead time [s] and period are not short for the pendulum, or for the faster hoist, and
    where the `strongest` corrections of a carriage (3,) [N] or [m/s2] are a tenth of the
    weight or less: gains so high that a drive is always at its bound damp no sway.
    """
    from scipy.linalg import solve_discrete_are

    lagging = np.flatnonzero(lag) if driven else np.zeros(0, dtype=int)
    kept = [*range(State.SIZE), *(State.SIZE + lagging)]
    a, b = lagged(*linearised(crane, length, driven), np.array(lag), driven)
    ad, bd = sampled(a[np.ix_(kept, kept)], b[kept], sample_time)
    frequency = np.sqrt(crane.gravity / length)
    coordinates = np.array([1.0 / length] * 3 + [1.0] * 2)
    scale = np.concatenate([coordinates, coordinates / frequency])
    w = weights
    values = [w.position] * 2 + [w.rope] + [w.angle] * 2 + [w.velocity] * 3 + [w.rate] * 2
    state_cost = np.diag(np.append(scale**2 * values, np.zeros(lagging.size)))
    unit = np.ones(3) if driven else moved_masses(crane.masses)
    late = frequency * (dead_time + sample_time) / np.array([PATIENCE, PATIENCE, HOIST_PATIENCE])
    patience = np.maximum(late, 1.0) ** 4
    largest = EFFORT * unit * crane.gravity
    if strongest is not None:
        weak = np.array(strongest[: Axes.ROPE]) / (weak_drive() * unit[: Axes.ROPE] * crane.gravity)
        largest[: Axes.ROPE] *= np.minimum(weak, 1.0)
    # corrections as shares of the largest: a solver finds no gain where N are large and m small
    bd = bd * largest
    effort = np.diag(w.effort * patience)
    try:
        riccati = solve_discrete_are(ad, bd, state_cost, effort)
        solved = np.linalg.solve(effort + bd.T @ riccati @ bd, bd.T @ riccati @ ad)
    except (np.linalg.LinAlgError, ValueError):
        raise _without_gain(crane, length, dead_time, weights) from None
    if not np.isfinite(solved).all():
        raise _without_gain(crane, length, dead_time, weights)
    solved *= largest[:, np.newaxis]
    found = np.zeros((Axes.SIZE, GainInputs.SIZE))
    found[:, : State.SIZE] = solved[:, : State.SIZE]
    for column, axis in enumerate(lagging, State.SIZE):
        found[axis, GainInputs.COMMAND] = solved[axis, column]
    return found


def _without_gain(crane: Crane, length: float, dead_time: float, weights: Weights) -> InputError:
    """Why there is no gain: a weight or a mass far from the others; all of them if none is."""
    positive = {n: v for n, v in vars(weights).items() if v > 0.0}
    name, value = max(positive.items(), key=lambda item: abs(np.log10(item[1])))
    masses = dict(zip(MASSES, crane.masses, strict=False))
    (light, least), *_, (heavy, most) = sorted(masses.items(), key=lambda item: item[1])
    if not 1.0 / FAR <= value <= FAR:
        cause = f"feedback.weight.{name} {value:g} is too far from 1; choose one nearer to it"
    elif most > FAR * least:
        cause = f"{heavy} {most:g} kg is too far from {light} {least:g} kg; check both"
    else:
        given = ", ".join(f"{v:g}" for v in masses.values())
        cause = (
            f"check the masses ({given} kg) and dead times ({dead_time:g} s), or raise the weights "
            "of angle and rate"
        )
    return InputError(f"the feedback has no gain at {length:.6g} m of rope: {cause}")


def design(
    crane: Crane,
    *,
    sample_time: float,
    shortest: float,
    longest: float,
    weights: Weights | None = None,
    driven: bool = False,
    lag: ArrayLike = 0.0,
    dead_time: float = 0.0,
    strongest: ArrayLike | None = None,
    rows: int = ROWS,
) -> SwayFeedback:
    """Design the gain table between two rope lengths.

    Parameters
    ----------
    crane : Crane
    sample_time : float
        [s]
    shortest, longest : float
        Rope lengths [m].
    weights : Weights, optional
    driven : bool
        True: corrections are accelerations; False: forces.
    lag : array_like
        Lags of the velocity drives [s], one or three.
    dead_time : float
        Age of the signals and dead time of the drives [s].
    strongest : array_like, shape (3,), optional
        Largest corrections that the drives can make [N] or [m/s2].
    rows : int

    Raises
    ------
    InputError
        For a period, rope lengths or corrections that are not positive, negative lags, and weights
        without a solution.
    """
    chosen = Weights() if weights is None else weights
    driven = as_flag("driven", driven)
    require_kind("crane", crane, Crane)
    require_kind("weights", chosen, Weights)
    require_positive("sample_time", sample_time)
    require_not_negative("feedback dead_time", dead_time)
    lags = lags_of("feedback lag", lag)
    lengths = scheduled_lengths(shortest, longest, rows)
    most = None if strongest is None else sized("strongest", strongest, Axes.SIZE)
    for value in () if most is None else most:
        require_positive("strongest correction", value)
    bounds = None if most is None else tuple(most.tolist())
    table = [
        gain(crane, float(x), sample_time, chosen, driven, tuple(lags.tolist()), dead_time, bounds)
        for x in lengths
    ]
    return SwayFeedback(sample_time, lengths, np.array(table), crane.payload_mass)


@dataclass(frozen=True, eq=False)
class PayloadSchedule:
    """Gain tables over rope length for several payloads.

    Attributes
    ----------
    payloads : ndarray, shape (payloads,)
        [kg], ascending.
    tables : tuple of SwayFeedback
        One per payload, over the same rope lengths.

    Raises
    ------
    InputError
        For payloads that are not positive and ascending, and tables that are not one for each, of
        one period and the same rope lengths.
    """

    payloads: FloatArray
    tables: tuple[SwayFeedback, ...]

    def __post_init__(self) -> None:
        payloads = _ascending("payloads", self.payloads, "kg")
        tables = as_tuple("tables", self.tables)
        for table in tables:
            require_kind("a table", table, SwayFeedback)
        alike = {(t.sample_time, t.lengths.tobytes(), t.gains.shape) for t in tables}
        if len(tables) != payloads.size or len(alike) > 1:
            raise InputError(
                f"tables must be one for each of {payloads.size} payloads, of one sample_time and "
                f"the same rope lengths, got {len(tables)} with {len(alike)} kinds of them"
            )
        object.__setattr__(self, "payloads", payloads)
        object.__setattr__(self, "tables", tables)

    def at(self, payload: float) -> SwayFeedback:
        """Gains for a payload [kg]: linear between the tables, constant outside."""
        payload = finite_number("payload", payload)
        last = self.payloads.size - 1
        place = float(np.interp(payload, self.payloads, np.arange(last + 1.0)))
        row = min(int(place), max(last - 1, 0))
        share = place - row
        first, second = self.tables[row], self.tables[min(row + 1, last)]
        gains = (1.0 - share) * first.gains + share * second.gains
        mass = (1.0 - share) * first.payload + share * second.payload
        return SwayFeedback(first.sample_time, first.lengths, gains, mass)


def design_schedule(
    crane: Crane,
    payloads: ArrayLike,
    *,
    sample_time: float,
    shortest: float,
    longest: float,
    weights: Weights | None = None,
    driven: bool = False,
    lag: ArrayLike = 0.0,
    dead_time: float = 0.0,
) -> PayloadSchedule:
    """Design gain tables for ascending payloads [kg] in place of the crane's; rest as in `design`.

    Raises
    ------
    InputError
        As `design`, and for payloads that are not positive and ascending.
    """
    require_kind("crane", crane, Crane)
    values = _ascending("payloads", payloads, "kg")
    tables = tuple(
        design(
            replace(crane, payload_mass=float(payload)), sample_time=sample_time,
            shortest=shortest, longest=longest, weights=weights, driven=driven, lag=lag,
            dead_time=dead_time,
        )
        for payload in values
    )
    return PayloadSchedule(values, tables)
