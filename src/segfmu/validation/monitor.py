"""Margins of criteria over the rows of a run.

A margin is the robustness of signal temporal logic: the distance of the signal from its bound, at
the worst time of an "always", at the best of an "eventually"; positive where the criterion holds.
A. Donzé, O. Maler, Robust satisfaction of temporal logic over real-valued signals, FORMATS 2010.
Between rows signals are linear, so the extremes are at rows and at the ends of the window.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from segfmu.arrays import FloatArray
from segfmu.errors import InputError, meant, no_variable
from segfmu.validation.files.crane_file import CraneFile
from segfmu.validation.files.crane_parameters import bounds
from segfmu.validation.files.keys import DRIVES
from segfmu.validation.files.scenario_tables import CriterionTable, moment
from segfmu.validation.signal_table import read_table

# combinations of variables that have a name of their own
DERIVED = {"error.load.horizontal": ("error.load.x", "error.load.y")}
# s; times that differ by less are equal
INSTANT = 1e-9
# a drive at its bound is within it
ROUNDING = 1e-12
# what bounds and margins of drives are, in place of a unit
SHARE = "of the bounds"


@dataclass(frozen=True)
class Finding:
    """A criterion of a run.

    Attributes
    ----------
    name, kind, signal : str
    bound : float
        In the unit of the signal; of drives the share.
    margin : float
        In the unit of the signal; positive where the criterion holds, NaN for a signal that is.
    unit : str
        Of the signal, of a norm that of its first one; empty where it is not known, and of shares.
    """

    name: str
    kind: str
    signal: str
    bound: float
    margin: float
    unit: str = ""

    @property
    def normalised(self) -> float | None:
        """The margin over the bound; None for a bound of zero, or one of rounding alone."""
        if self.bound == 0.0 or abs(self.bound) <= ROUNDING * abs(self.margin):
            return None
        return self.margin / abs(self.bound)

    @property
    def passed(self) -> bool:
        """Whether the margin is not negative."""
        return self.margin >= 0.0


class Signals:
    """The columns of a run's rows, each read once: rows are wide, criteria have columns in common.

    Parameters
    ----------
    rows : structured array
        "time" and the variables of the run.

    Attributes
    ----------
    times : array, shape (rows,)
        [s]
    """

    def __init__(self, rows: NDArray[np.void]) -> None:
        self.times: FloatArray = np.ascontiguousarray(rows["time"])
        self._rows = rows
        self._columns: dict[str, FloatArray] = {}

    def __getitem__(self, name: str) -> FloatArray:
        """The column of a variable.

        Raises
        ------
        InputError
            For a variable that the run does not have.
        """
        if name not in self._columns:
            names = [n for n in self._rows.dtype.names or () if n != "time"]
            if name not in names:
                raise no_variable(name, names)
            self._columns[name] = self._rows[name].astype(np.float64)
        return self._columns[name]


def judge(
    criterion: CriterionTable, rows: Signals, known: Mapping[str, float],
    crane: CraneFile, units: Mapping[str, str], nominal: Signals | None = None,
) -> Finding:
    """Judge a run by one criterion.

    Parameters
    ----------
    criterion : CriterionTable
    rows : Signals
        Of the run.
    known : mapping
        Times of "start", "arrival" and "end" [s].
    crane : CraneFile
        Whose bounds of the drives are meant.
    units : mapping
        Of the variables of the run.
    nominal : Signals, optional
        The run that the bound is relative to.

    Raises
    ------
    InputError
        For variables that the run does not have, and an empty window.
    """
    times, span = rows.times, _window(criterion, known)
    if criterion.kind == "drives":
        bound = 1.0 if criterion.bound is None else criterion.bound
        use = drive_use(rows, crane)
        margin = bound - float(_within(times, use, span).max())
        signal = "use of the drives"
        return Finding(criterion.name, "drives", signal, bound, _rounded(margin, bound))
    assert criterion.bound is not None
    bound = criterion.bound
    if nominal is not None:
        compared = _within(nominal.times, _quantity(criterion, nominal), span)
        bound *= float(np.abs(compared).max())
    values = _within(times, _quantity(criterion, rows), span)
    sign = -1.0 if criterion.sense == "at least" else 1.0
    distances = sign * (bound - values)
    best = criterion.kind == "eventually"
    margin = float(distances.max() if best else distances.min())
    return Finding(
        criterion.name, criterion.kind, title(criterion), bound, _rounded(margin, bound),
        _unit(criterion, units),
    )


def variables(criteria: Iterable[CriterionTable], crane: CraneFile) -> set[str]:
    """The variables of a run that criteria read."""
    found: set[str] = set()
    for criterion in criteria:
        if criterion.kind == "drives":
            found |= {signal for _, signal, *_ in _bounded(crane)}
        else:
            found |= set(_parts(criterion))
        if criterion.reference is not None and not _is_file(criterion.reference):
            found.add(criterion.reference)
    return found


def measure(criterion: CriterionTable, units: Mapping[str, str]) -> str:
    """The unit of a criterion's bound and margin, or `SHARE`; empty where it is not known."""
    return SHARE if criterion.kind == "drives" else _unit(criterion, units)


def _unit(criterion: CriterionTable, units: Mapping[str, str]) -> str:
    return units.get(_parts(criterion)[0], "")


def _rounded(margin: float, bound: float) -> float:
    """The margin; 0, without a sign, where it is negative by rounding alone."""
    return 0.0 if -ROUNDING * max(1.0, abs(bound)) <= margin <= 0.0 else margin


def title(criterion: CriterionTable) -> str:
    """The signal of a criterion as words."""
    signal = criterion.signal
    return f"norm({', '.join(signal)})" if isinstance(signal, list) else signal or "drives"


def drive_use(rows: Signals, crane: CraneFile) -> FloatArray:
    """Greatest use of force, velocity, acceleration and power of any drive, as a share of bounds.

    Raises
    ------
    InputError
        If the crane file has no such bounds.
    """
    shares = []
    for quantity, signal, sign, most in _bounded(crane):
        values = sign * rows[signal]
        if quantity == "acceleration":
            values = _acceleration(rows.times, values)
        shares.append(values / most)
    if not shares:
        raise InputError(
            "the kind drives needs force_max, velocity_max, acceleration_max or power_max of a "
            "drive of the crane"
        )
    use: FloatArray = np.maximum(np.max(shares, axis=0), 0.0)
    return use


def _bounded(crane: CraneFile) -> Iterator[tuple[str, str, float, float]]:
    """Of each bound of a drive: the quantity, its variable, the direction, and the value."""
    axes, known = {"bridge": "bridge", "trolley": "trolley", "hoist": "rope"}, bounds(crane)
    for i, drive in enumerate(DRIVES):
        signals = {
            "force": f"drive.{drive}.force", "velocity": f"{axes[drive]}.velocity",
            "acceleration": f"{axes[drive]}.velocity", "power": f"drive.{drive}.power",
        }
        for quantity, signal in signals.items():
            limits = getattr(known, quantity)[i], known.lower(quantity)[i]
            for sign, most in zip((1.0, -1.0), limits, strict=True):
                if np.isfinite(most):
                    yield quantity, signal, sign, most


def _acceleration(times: FloatArray, velocity: FloatArray) -> FloatArray:
    """Of each row the greater mean of the intervals beside it, at least 0."""
    if times.size < 2:
        return np.zeros(times.size)
    means = np.diff(velocity) / np.diff(times)
    found: FloatArray = np.maximum(np.append(means, 0.0), np.append(0.0, means))
    return found


def _quantity(criterion: CriterionTable, rows: Signals) -> FloatArray:
    """What is compared with the bound, at all rows."""
    parts = _parts(criterion)
    columns = [rows[name] for name in parts]
    if criterion.reference is not None:
        columns = [
            column - _reference(criterion.reference, name, rows)
            for column, name in zip(columns, parts, strict=True)
        ]
    if len(columns) > 1:
        norm: FloatArray = np.linalg.norm(columns, axis=0)
        return norm
    return np.abs(columns[0]) if criterion.sense == "within" else columns[0]


def _parts(criterion: CriterionTable) -> tuple[str, ...]:
    """The variables of the signal."""
    signal = criterion.signal
    assert signal is not None
    return DERIVED.get(signal, (signal,)) if isinstance(signal, str) else tuple(signal)


def _is_file(reference: str) -> bool:
    return reference.endswith(".csv")


def _reference(name: str, signal: str, rows: Signals) -> FloatArray:
    if not _is_file(name):
        return rows[name]
    table = read_table(Path(name))
    if signal not in table:
        raise InputError(f"{name}: no column {signal}{meant(signal, table)}")
    times, given = rows.times, table["time"]
    if given[0] > times[0] + INSTANT or given[-1] < times[-1] - INSTANT:
        raise InputError(f"{name}: does not last as long as the run, {times[-1]:.6g} s")
    column: FloatArray = np.interp(times, given, table[signal])
    return column


def _window(criterion: CriterionTable, known: Mapping[str, float]) -> tuple[float, float]:
    if criterion.kind == "at":
        assert criterion.at is not None
        time = moment(criterion.at, known)
        return time, time
    if criterion.kind == "settled":
        return known["arrival"] + criterion.delay, known["end"]
    first, last = (moment(value, known) for value in criterion.window)
    return first, last


def _within(
    times: FloatArray, values: FloatArray, span: tuple[float, float]
) -> FloatArray:
    """Values at the rows of a window and, interpolated, at its ends."""
    first, last = span
    if not times[0] - INSTANT <= first <= last <= times[-1] + INSTANT:
        raise InputError(
            f"the window from {first:.6g} s to {last:.6g} s is empty or outside of the "
            f"run from {times[0]:.6g} s to {times[-1]:.6g} s"
        )
    begin, end = np.searchsorted(times, first, "right"), np.searchsorted(times, last, "left")
    ends = np.interp([first, last], times, values)
    return np.concatenate([ends[:1], values[begin:end], ends[1:]])
