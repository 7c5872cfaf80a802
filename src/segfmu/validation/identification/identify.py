"""`segfmu.identify`: parameters of a crane from its logs."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from math import ceil
from pathlib import Path
from typing import Any

import numpy as np

from segfmu.arrays import FloatArray, as_names, finite_number, require_callable
from segfmu.errors import InputError
from segfmu.validation.files.crane_file import CraneFile
from segfmu.validation.identification.arguments import (
    checked_columns,
    crane_of,
    logs_of,
    unseen_of,
)
from segfmu.validation.identification.fit import Problem
from segfmu.validation.identification.found import Fit
from segfmu.validation.identification.gaps import longest_gap, sections
from segfmu.validation.identification.log import (
    FEWEST,
    OUTPUTS,
    ROPE,
    Log,
    LogSource,
)
from segfmu.validation.identification.model import Model
from segfmu.validation.identification.possible import impossible
from segfmu.validation.identification.prediction import Prediction, prediction, zeros_of
from segfmu.validation.identification.quantities import FAR, SMALL, Quantity, Sizes, quantity, usual
from segfmu.validation.identification.result import Estimate, Identification, Untold
from segfmu.validation.identification.unknowns import Unknowns
from segfmu.validation.progress import Progress, quiet

# share of a log that is not fitted
HELD_OUT = 0.25
# half the width of the tubes of the validation
TUBE = 0.05
# periods of the pendulum: of the start of a log that is not fitted; of a piece of a log with force
# drives, in which small errors of forces grow, so that a long one has many valleys
PERIODS, PIECE = 1.0, 2.0
# share of the rows whose rope is too short to be believed
RARE = 0.01


def identify(
    logs: LogSource | Sequence[LogSource],
    crane: str | Path | Mapping[str, Any],
    *,
    fit: Sequence[str] | None = None,
    columns: Mapping[str, str] | None = None,
    held_out: float = HELD_OUT,
    piece: float | None = None,
    validation: LogSource | None = None,
    tube: float = TUBE,
    progress: Progress = quiet,
) -> Identification:
    """Fit parameters of a crane file to measured signals, through the model of GantryCrane.

    The crane is simulated with the setpoints of the log; least squares make its sensors show what
    was measured. Noise is estimated from the residuals.

    Parameters
    ----------
    logs : path, mapping or sequence of these
        CSV files, or columns by name: "time" [s]; setpoints of the drives, "velocity.bridge"
        [m/s] or "force.bridge" [N] and so on, corrections of a feedback included; and what was
        measured, "measured.bridge.position" and the other outputs of GantryCrane of this kind [m]
        and [rad].
    crane : path or mapping
        A crane file, or what it would say. Its values are where the search begins.
    fit : sequence of str, optional
        Keys of the crane file; by default all that such a log usually tells.
    columns : mapping of str to str, optional
        Names of columns in the logs that have others than those above.
    held_out : float
        Share of each log, at its end, that is only predicted.
    piece : float, optional
        Logs are cut into pieces of at most this length [s], whose starts are unknowns too; by
        default not with velocity drives, and after two periods of the pendulum with force drives.
    validation : path or mapping, optional
        A log that is only predicted, but for its start, which is found from its first period.
    tube : float
        Half the width of the tubes about predicted signals, as a share of their greatest values.
    progress : callable
        Called with what is being done and the share of it that is done.

    Returns
    -------
    Identification

    Raises
    ------
    InputError
        For files that are wrong, and a crane that cannot do what the log has.

    Examples
    --------
    >>> import segfmu
    >>> found = segfmu.identify("log.csv", "crane.toml")  # doctest: +SKIP
    >>> found["friction.sway.viscous"].high  # doctest: +SKIP
    0.0123
    """
    require_callable("progress", progress)
    held_out, tube = finite_number("held_out", held_out), finite_number("tube", tube)
    if not 0.0 <= held_out <= 0.9:
        raise InputError(f"held_out must be from 0 to 0.9, got {held_out}")
    if tube < 0.0:
        raise InputError(f"tube must be at least 0, got {tube}")
    columns = checked_columns(columns)
    file, source = crane_of(crane)
    keys = list(as_names("fit", usual(file.drive) if fit is None else fit))
    if not keys or len(set(keys)) < len(keys):
        raise InputError("fit: name keys of the crane file, each once")
    whole = logs_of(logs, file, columns)
    # before the fit, which may take minutes
    unseen = None if validation is None else unseen_of(validation, logs, file, columns)
    period = _sizes(file, whole).period
    every = [part for log in whole for part in sections(log, period)]
    fitted = [log.rows(0, round((1.0 - held_out) * log.times.size)) for log in every]
    model = Model(file)
    sizes = _sizes(file, fitted)
    cut = [_pieces(log, _length(piece, file, sizes)) for log in fitted]
    parts = [part for own in cut for part in own]
    chosen = [quantity(key, file, model.value, sizes) for key in keys]
    unknowns = Unknowns(model, parts, chosen, sizes)
    found = Problem(model, parts, unknowns, sizes.period).fit(
        _begin(model, cut, unknowns, sizes, progress), lambda share: progress("fit", share)
    )
    changes = unknowns.changes(found.point, found.free)
    followed = _Followed(model.changed(changes), zeros_of(model, changes), tube)
    starts = [unknowns.start(found.point, i) for i in range(len(parts))]
    known, later = followed.logs(every, cut, starts)
    if unseen is not None:
        later += [followed.unseen(part, sizes) for part in sections(unseen, period)]
    return Identification(
        source, file, _estimates(unknowns, found), _untold(unknowns, found), tuple(known),
        tuple(later), found.converged,
        tuple(gap for log in every if (gap := longest_gap(log)) is not None),
        tuple(impossible(file, _told(unknowns, found), fitted, sizes)),
    )


def _begin(
    model: Model, cut: Sequence[Sequence[Log]], unknowns: Unknowns, sizes: Sizes,
    progress: Progress,
) -> FloatArray | None:
    """Where the search begins for logs in pieces: what fits their halves, which have less valleys.

    None for logs that are whole, and where the crane cannot do the halves.
    """
    if all(len(own) == 1 for own in cut):
        return None
    parts = [part for own in cut for part in own]
    halves = [_pieces(p, 0.5 * (p.times[-1] - p.times[0])) for p in parts]
    every = [half for own in halves for half in own]
    short = Unknowns(model, every, unknowns.quantities, sizes)
    try:
        problem = Problem(model, every, short, sizes.period)
        point = problem.begin(lambda share: progress("first fit", share))
    except InputError:
        return None
    firsts = np.cumsum([0, *map(len, halves[:-1])])
    return unknowns.taken(short, point, firsts.tolist())


@dataclass(frozen=True)
class _Followed:
    """How a fitted crane follows logs."""

    model: Model
    zeros: FloatArray
    tube: float

    def logs(
        self, every: Sequence[Log], cut: Sequence[Sequence[Log]], starts: Sequence[FloatArray]
    ) -> tuple[list[Prediction], list[Prediction]]:
        """The fitted parts of logs, cut into pieces with these starts, and the rest of each."""
        begin = iter(starts)
        known, later = [], []
        for log, pieces in zip(every, cut, strict=True):
            runs = [self.model.run(p, {}, next(begin)) for p in _to_end(log, pieces)]
            simulated = np.concatenate(runs)
            rows = sum(part.times.size for part in pieces)
            known.append(self._compared(log.rows(0, rows), simulated[:rows]))
            if rows < log.times.size:
                rest = log.rows(rows, log.times.size)
                later.append(self._compared(rest, simulated[rows:]))
        return known, later

    def unseen(self, log: Log, sizes: Sizes) -> Prediction:
        """A log of which only the start is found."""
        last = log.times[0] + PERIODS * sizes.period
        first = log.rows(0, max(int(np.searchsorted(log.times, last)), FEWEST))
        unknowns = Unknowns(self.model, [first], (), sizes)
        found = Problem(self.model, [first], unknowns, sizes.period).fit()
        return self._compared(log, self.model.run(log, {}, unknowns.start(found.point, 0)))

    def _compared(self, log: Log, simulated: FloatArray) -> Prediction:
        return prediction(log, simulated, self.zeros, self.tube)


def _length(piece: float | None, file: CraneFile, sizes: Sizes) -> float:
    """The greatest length of a piece [s]."""
    if piece is not None:
        piece = finite_number("piece", piece)
        if not piece > 0.0:
            raise InputError(f"piece must be positive, got {piece} s")
        return piece
    return PIECE * sizes.period if file.drive == "force" else np.inf


def _pieces(log: Log, length: float) -> list[Log]:
    """Pieces of equal length, of enough rows each."""
    most = max(1, log.times.size // FEWEST)
    span = float(log.times[-1] - log.times[0])
    # also where the quotient is beyond all numbers
    count = most if span >= most * length else max(1, ceil(span / length))
    ends = np.linspace(0, log.times.size, count + 1).round().astype(int)
    return [log.rows(*pair) for pair in pairwise(ends.tolist())]


def _to_end(log: Log, pieces: Sequence[Log]) -> list[Log]:
    """The pieces, the last one with all that follows."""
    first = sum(part.times.size for part in pieces[:-1])
    return [*pieces[:-1], log.rows(first, log.times.size)]


def _sizes(file: CraneFile, logs: Sequence[Log]) -> Sizes:
    ropes = np.concatenate([log.measured[:, OUTPUTS.index(ROPE)] for log in logs])
    length = float(ropes.mean())
    if length <= 0.0:
        raise InputError(
            f"{logs[0].name}: the rope's mean length is {length:.4g} m; "
            "name the column of the rope's length in metres, which is above 0"
        )
    low, high = (file.rope_min or 0.0) / FAR, FAR * (file.rope_max or np.inf)
    if not low <= length <= high:
        name = "rope_min" if length < low else "rope_max"
        raise InputError(
            f"{logs[0].name}: the rope's mean length is {length:.4g} m, {name} of the crane file "
            f"is {getattr(file, name):.4g} m; name the column of the rope's length in metres"
        )
    load = file.payload_mass
    masses = (file.bridge_mass + file.trolley_mass + load, file.trolley_mass + load, load)
    shortest = max(float(np.quantile(ropes, RARE)), SMALL * length)
    return Sizes(masses, length, shortest, file.gravity)


def _told(unknowns: Unknowns, fit: Fit) -> list[tuple[Quantity, float]]:
    """Parameters that the log tells, and their values."""
    values = unknowns.values(fit.point).tolist()
    return [(q, values[i]) for i, q in enumerate(unknowns.quantities) if i in fit.free]


def _estimates(unknowns: Unknowns, fit: Fit) -> tuple[Estimate, ...]:
    found = []
    for q, value in _told(unknowns, fit):
        half = fit.half[unknowns.quantities.index(q)] * q.scale
        ends = np.clip([value - half, value + half], q.low, q.high) * q.factor
        found.append(Estimate(q.key, q.unit, q.before * q.factor, value * q.factor, *ends.tolist()))
    return tuple(found)


def _untold(unknowns: Unknowns, fit: Fit) -> tuple[Untold, ...]:
    """Parameters; a start that nothing tells, as a drive's velocity without lag, is left out."""
    found = []
    for direction in fit.directions:
        if direction.held < unknowns.parameters:
            q = unknowns.quantities[direction.held]
            parts = tuple((unknowns.name(i), weight) for i, weight in direction.parts)
            found.append(Untold(q.key, q.unit, q.before * q.factor, parts))
    return tuple(found)
