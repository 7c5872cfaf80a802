"""Estimates that no crane has: where they come out, columns are swapped or in another unit."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from segfmu.arrays import FloatArray
from segfmu.errors import InputError
from segfmu.validation.files.crane_file import CraneFile
from segfmu.validation.identification.log import ANGLES, OUTPUTS, ROPE, Log
from segfmu.validation.identification.quantities import (
    FAR,
    MASSES,
    SMALL,
    Quantity,
    Sizes,
    greatest,
)
from segfmu.validation.units import pretty

# share of the greatest value that is possible, from which on an estimate is at it
REACHED = 0.99
# times the longest rope of a log by the zero of the crane file: without rope_max none is longer
LONGER = 2.0


@dataclass(frozen=True)
class Impossible:
    """An estimate that no crane has, which no crane file gets.

    Attributes
    ----------
    key, unit : str
        Of the crane file.
    value : float
    reason : str
        What it would mean, and what else can be done.
    """

    key: str
    unit: str
    value: float
    reason: str

    def __str__(self) -> str:
        return f"{self.key} {pretty(self.value)} {self.unit}: {self.reason}"


def require_possible(found: Sequence[Impossible]) -> None:
    """Refuse estimates that no crane has.

    Raises
    ------
    InputError
        With all of them.
    """
    if found:
        raise InputError(
            f"no crane has {'; '.join(map(str, found))}; there is no crane file of it: look for "
            "columns of the logs that are swapped or have another sign or unit, or fit other keys "
            "with --fit"
        )


def impossible(
    file: CraneFile, values: Iterable[tuple[Quantity, float]], logs: Sequence[Log], sizes: Sizes
) -> Iterator[Impossible]:
    """Those of the values, in the units of GantryCrane, that no crane with these logs has."""
    measured = np.concatenate([log.measured for log in logs])
    for q, value in values:
        reason = _reason(file, q, value, measured, sizes)
        if reason:
            yield Impossible(q.key, q.unit, value * q.factor, reason)


def _reason(
    file: CraneFile, q: Quantity, value: float, measured: FloatArray, sizes: Sizes
) -> str:
    """Why no crane has a value; empty for one that a crane may have."""
    most = greatest(q.key, sizes)
    if value >= REACHED * most:
        told = f"{pretty(q.factor * most)} {q.unit}"
        return f"the log asks for more than the greatest there is, {told}"
    if q.key in MASSES and not q.before / FAR < value < FAR * q.before:
        return (
            f"the crane file has {pretty(q.before)} {q.unit}, more than {FAR:g} times as much or "
            "as little; give it a nearer value if that is only a guess"
        )
    if q.key == "sensors.rope.zero":
        return _of_rope(file, q.before, value, measured[:, OUTPUTS.index(ROPE)])
    name = q.variable.removeprefix("sensor.").removesuffix(".offset")
    if f"measured.{name}" in ANGLES:
        return _of_angle(q, value, measured[:, OUTPUTS.index(f"measured.{name}")])
    return ""


def _of_rope(file: CraneFile, before: float, zero: float, measured: FloatArray) -> str:
    length, longest = float(measured.mean()) - zero, LONGER * float(measured.max() - before)
    low, high = file.rope_min or 0.0, file.rope_max or longest
    if low <= length <= high:
        return ""
    told = f"the rope would be {pretty(length)} m long on average"
    if length < low:
        return f"{told}, less than rope_min {pretty(low)} m"
    if file.rope_max is not None:
        return f"{told}, more than rope_max {pretty(high)} m"
    return (
        f"{told}, where {pretty(float(measured.mean()))} m are measured; give rope_max if the load "
        "hangs so far below what is measured"
    )


def _of_angle(q: Quantity, zero: float, measured: FloatArray) -> str:
    """A load swings about the vertical, which is where the zero is."""
    low, high = float(measured.min()), float(measured.max())
    beside = max(low - zero, zero - high)
    if not beside > SMALL:
        return ""
    away, least, most = (pretty(q.factor * value) for value in (beside, low, high))
    return (
        f"the load would hang {away} deg or more beside the vertical all the time; measured are "
        f"{least} to {most} deg"
    )
