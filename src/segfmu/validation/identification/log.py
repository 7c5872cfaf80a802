"""Measured signals of a crane: what its drives were told, and what its sensors showed."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from difflib import get_close_matches
from math import pi
from pathlib import Path
from typing import Any

import numpy as np

from segfmu.arrays import FloatArray, numbers, shown
from segfmu.errors import InputError
from segfmu.kernels.rig.records import SIGNALS
from segfmu.planning.rows import UNIT, no_names
from segfmu.validation.files.keys import DRIVES
from segfmu.validation.signal_table import (
    bare_names,
    column_names,
    read_table,
    require_increasing,
)
from segfmu.validation.units import signal_units

# m and rad
OUTPUTS = tuple(f"measured.{signal}" for signal in SIGNALS)
ROPE, ANGLES = OUTPUTS[2], OUTPUTS[3:]
# rows of a log below which there is nothing to fit
FEWEST = 20
# of a way that is in another unit than its setpoint: the least factor between them, and the least
# share of it that follows the setpoint; noise about a drive that rests follows none
FACTOR, FOLLOWS = 10.0, 0.9
# usual distances of rows, from which on nobody knows what the drive was told between two
GAP = 10.0
# likeness of names, from which on one is the other misspelt
MISSPELT = 0.85

# a file, or columns by name
LogSource = str | Path | Mapping[str, Any]


@dataclass(frozen=True, eq=False)
class Log:
    """A run of a crane.

    Attributes
    ----------
    name : str
        Of its file.
    times : ndarray, shape (rows,)
        Ascending [s].
    setpoints : ndarray, shape (rows, 3)
        Of bridge, trolley and hoist: forces [N] or velocities [m/s], linear from row to row.
    measured : ndarray, shape (rows, 5)
        The `OUTPUTS`; NaN in the columns of those that were not measured.
    """

    name: str
    times: FloatArray
    setpoints: FloatArray
    measured: FloatArray

    @property
    def known(self) -> list[int]:
        """Places of the outputs that were measured."""
        return [int(i) for i in np.flatnonzero(~np.isnan(self.measured[0]))]

    def rows(self, first: int, last: int) -> Log:
        """Some of the rows."""
        part = slice(first, last)
        return Log(self.name, self.times[part], self.setpoints[part], self.measured[part])


def read_log(
    source: LogSource, drive: str, columns: Mapping[str, str], name: str = "log"
) -> Log:
    """A log from a table, whose columns are named as inputs and outputs of GantryCrane.

    Parameters
    ----------
    source : path or mapping
        A CSV file, or columns by name; with "time" [s], the setpoints ("velocity.bridge" or
        "force.bridge" and so on) and measured signals ("measured.bridge.position" and so on).
    drive : {"force", "velocity"}
    columns : mapping of str to str
        Of those that have another name in the table: that name.
    name : str
        In messages, of a source that is no file.

    Raises
    ------
    InputError
        If the table lacks what is needed, or has something else than numbers.
    """
    if not isinstance(source, str | Path | Mapping):
        raise InputError(f"{name} must be a file or a dict of columns, got {shown(source)}")
    needed = [f"{drive}.{axis}" for axis in DRIVES]
    own_names = ["time", *needed, *OUTPUTS]
    _require_used(columns, own_names)
    columns = {own: UNIT.sub("", c) for own, c in columns.items()}
    if isinstance(source, Mapping):
        names = bare_names(map(str, source), columns, name)
        table = {n: numbers(n, _counted(v)) for n, v in zip(names, source.values(), strict=True)}
        _require_times(table, name, columns.get("time", "time"))
        others: Iterable[str] = table
    else:
        name = str(source)
        others = column_names(Path(source))
        _require_time(name, columns.get("time", "time"), others)
        table = read_table(Path(source), {*own_names, *columns.values()}, columns)
    table = _renamed(name, table, columns, own_names)
    _require_spelt(name, table, columns, own_names[1:], others)
    if table["time"].size < FEWEST:
        raise InputError(f"{name}: {rows_told(table['time'].size)}, at least {FEWEST} are needed")
    # a velocity drive that was told nothing rests; a force is never nothing
    missing = [n for n in needed if n not in table]
    if missing and (drive == "force" or len(missing) == len(needed)):
        raise InputError(
            f"{name}: no column {missing[0]}, a setpoint of drive = {drive!r} of the crane file; "
            f"name the one that has it: --column {missing[0]}=COLUMN"
        )
    if ROPE not in table:
        raise InputError(
            f"{name}: no column {ROPE}, from which the sway's period follows; name the one that "
            f"has it: --column {ROPE}=COLUMN"
        )
    none = np.full(table["time"].size, np.nan)
    _require_angles(name, table)
    log = Log(
        name, table["time"],
        np.stack([table.get(n, 0.0 * table["time"]) for n in needed], axis=1),
        np.stack([table.get(n, none) for n in OUTPUTS], axis=1),
    )
    if drive == "velocity":
        _require_units(log)
    return log


def _counted(values: Any) -> Any:
    """Columns of yes and no, as a run has them, as the 0 and 1 of its table."""
    found = np.asarray(values) if hasattr(values, "dtype") else None
    return found.astype(np.float64) if found is not None and found.dtype == bool else values


def rows_told(count: int) -> str:
    """A number of rows in words."""
    return f"{count} row{'s' * (count != 1)}"


def _require_used(columns: Mapping[str, str], names: Sequence[str]) -> None:
    for own in columns:
        if own not in names:
            raise InputError(f"column {own}: no signal that is used; {', '.join(sorted(names))}")


def _renamed(
    where: str, table: Mapping[str, FloatArray], columns: Mapping[str, str], names: Sequence[str]
) -> dict[str, FloatArray]:
    found = dict(table)
    for own, other in columns.items():
        if other not in table:
            raise InputError(f"{where}: no column {other}, which is to be {own}")
        found[own] = table[other]
    sources: dict[str, str] = {}
    for own in filter(found.__contains__, names):
        source = columns.get(own, own)
        if source in sources:
            raise InputError(
                f"{where}: column {source} is to be {sources[source]} and {own}; name one of its "
                "own for each, with --column NAME=COLUMN"
            )
        sources[source] = own
    for own in names:
        wrong = np.flatnonzero(~np.isfinite(found[own])) if own in found else np.empty(0)
        if wrong.size:
            raise InputError(
                f"{where}: no number for {own} at {found['time'][wrong[0]]:.6g} s; leave out the "
                "rows that lack one"
            )
    return found


def _require_spelt(
    where: str, table: Mapping[str, FloatArray], columns: Mapping[str, str], used: Sequence[str],
    names: Iterable[str],
) -> None:
    """Refuse columns whose names are nearly those of signals that the table lacks.

    Other columns are those of other things, as tables of a simulation have them.
    """
    lacking = [n for n in used if n not in table]
    others = set(names) - {"time", *used, *columns.values()} - signal_units().keys()
    for name in sorted(others):
        near = get_close_matches(name.lower(), lacking, n=1, cutoff=MISSPELT)
        if near:
            raise InputError(
                f"{where}: column {shown(name)} is no signal; did you mean {near[0]}? Rename it, "
                f"or --column {near[0]}={name}; if it is something else, leave it out"
            )


def _require_time(name: str, time: str, found: Iterable[str]) -> None:
    names = list(found)
    if time not in names:
        hint = no_names(names) or "; name the one that has the times: --column time=COLUMN"
        raise InputError(f"{name}: no column {time} among {shown(', '.join(names))}{hint}")


def _require_times(table: Mapping[str, FloatArray], name: str, time: str) -> None:
    _require_time(name, time, table)
    for own, values in table.items():
        if values.ndim != 1:
            raise InputError(f"{name}: {own} must be a list of numbers")
        if values.shape != table[time].shape:
            raise InputError(f"{name}: {own} must have as many numbers as {time}")
    require_increasing(table[time], name)


def _require_units(log: Log) -> None:
    """Refuse ways that are those of velocity drives but for their unit or sign.

    No crane has them, so that the search would end anywhere.
    """
    steps = np.diff(log.times)
    known = steps <= GAP * np.median(steps)
    for place, drive in enumerate(DRIVES):
        setpoint, way = log.setpoints[:, place], log.measured[:, place]
        told = np.cumsum(np.where(known, 0.5 * steps * (setpoint[1:] + setpoint[:-1]), 0.0))
        moved = np.cumsum(np.where(known, np.diff(way), 0.0))
        spans = float(np.ptp(told)), float(np.ptp(moved))
        # one that was not measured has none
        if not (spans[0] > 0.0 and spans[1] > 0.0):
            continue
        told, moved = (told - told.mean()) / spans[0], (moved - moved.mean()) / spans[1]
        both = float(told @ moved)
        if both**2 < FOLLOWS * float(told @ told) * float(moved @ moved):
            continue
        names = OUTPUTS[place], f"velocity.{drive}"
        if not 1.0 / FACTOR < spans[1] / spans[0] < FACTOR:
            raise InputError(
                f"{log.name}: {names[0]} moves through {spans[1]:.4g} m, {names[1]} tells "
                f"{spans[0]:.4g} m: one of them, or time, is in another unit than m, m/s and s"
            )
        if both < 0.0:
            raise InputError(
                f"{log.name}: {names[0]} moves against {names[1]}; turn the sign of one of them"
            )


def _require_angles(name: str, table: Mapping[str, FloatArray]) -> None:
    for own in ANGLES:
        largest = np.abs(table[own]).max() if own in table else 0.0
        if largest > pi / 2.0:
            raise InputError(f"{name}: {own} reaches {largest:.4g}; angles are in rad, below pi/2")
