"""A result against a reference: does it stay in a tube in time and value about every signal?"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from segfmu.arrays import FloatArray
from segfmu.errors import InputError, meant
from segfmu.validation.units import signal_units, with_unit

# s; times that differ by less are equal
INSTANT = 1e-9
# half the width of a tube where none is told: what digits of tables and other processors' rounding
# make of a signal
ALIKE = 1e-6


@dataclass(frozen=True)
class Excess:
    """Where a signal first leaves its tube.

    Attributes
    ----------
    signal : str
    time : float
        [s]
    excess : float
        By how much it is outside then, in the unit of the signal.
    largest : float
        Greatest excess of this signal, where it is a number.
    unit : str
        Empty where it is not known.
    """

    signal: str
    time: float
    excess: float
    largest: float
    unit: str = ""

    def __str__(self) -> str:
        if np.isnan(self.excess):
            return f"{self.signal} is not a number at {self.time:.6g} s"
        excess, largest = (
            with_unit(f"{value:.4g}", self.unit) for value in (self.excess, self.largest)
        )
        return (
            f"{self.signal} leaves its tube at {self.time:.6g} s by {excess} (at most by {largest})"
        )


def compare(
    result: Mapping[str, FloatArray], reference: Mapping[str, FloatArray], *,
    tube_time: float, tube_value: float | None, relative: bool = False,
    units: Mapping[str, str] | None = None,
) -> list[Excess]:
    """Signals of a result outside of tubes about those of the reference, by time.

    A point is inside if the reference has, at most `tube_time` earlier or later, a value at most
    `tube_value` lower and one at most as much higher. Between rows signals are linear; the
    result is looked at where it has rows.

    Parameters
    ----------
    result, reference : mapping of str to ndarray
        Columns, with "time" [s]; the rows may be at other times.
    tube_time : float
        [s]
    tube_value : float or None
        In the unit of each signal; with `relative` a share of the reference's greatest absolute
        value. None: 1e-6 of this, or of the unit where that is more.
    units : mapping of str to str, optional
        Of signals, in what is told; by default those of our FMUs.

    Raises
    ------
    InputError
        If the result lacks a signal of the reference, or does not last as long, the reference has
        none, or tubes are negative.
    """
    if not (0.0 <= tube_time < np.inf and 0.0 <= (tube_value or 0.0) < np.inf):
        raise InputError(
            f"tubes must be finite and at least 0, got {tube_time} s and {tube_value}"
        )
    if len(reference) < 2:
        raise InputError("the reference has no signal beside time: nothing would be compared")
    _require_alike(result, reference, tube_time)
    times, known = result["time"], signal_units() if units is None else units
    found = []
    for name in reference:
        if name == "time":
            continue
        peak = float(np.abs(reference[name]).max())
        wide = ALIKE * max(peak, 1.0) if tube_value is None else tube_value * (
            peak if relative else 1.0
        )
        low, high = _envelope(times, reference["time"], reference[name], tube_time)
        outside = np.maximum(low - wide - result[name], result[name] - high - wide)
        # a signal that is not a number is outside
        wrong = np.flatnonzero(~(outside <= 0.0))
        if wrong.size:
            first = wrong[0]
            found.append(Excess(
                name, float(times[first]), float(outside[first]), float(np.fmax.reduce(outside)),
                known.get(name, ""),
            ))
    return sorted(found, key=lambda e: e.time)


def _require_alike(
    result: Mapping[str, FloatArray], reference: Mapping[str, FloatArray], tube_time: float
) -> None:
    missing = [name for name in reference if name not in result]
    if missing:
        hint = meant(missing[0], result)
        raise InputError(f"the result has no signal {missing[0]}, which the reference has{hint}")
    for name, values in reference.items():
        wrong = np.flatnonzero(~np.isfinite(values))
        if wrong.size:
            time = reference["time"][wrong[0]]
            raise InputError(f"the reference has no number for {name} at {time:.6g} s")
    ends = np.array([table["time"][[0, -1]] for table in (result, reference)])
    if np.abs(ends[0] - ends[1]).max() > tube_time + INSTANT:
        raise InputError(
            f"the result is from {ends[0, 0]:.6g} to {ends[0, 1]:.6g} s, the reference from "
            f"{ends[1, 0]:.6g} to {ends[1, 1]:.6g} s"
        )


def _envelope(
    times: FloatArray, given: FloatArray, values: FloatArray, wide: float
) -> tuple[FloatArray, FloatArray]:
    """Least and greatest value of a signal about every time; its ends are held."""
    first, last = times - wide, times + wide
    ends = np.stack([np.interp(t, given, values) for t in (first, times, last)])
    low, high = ends.min(axis=0), ends.max(axis=0)
    start, stop = np.searchsorted(given, first), np.searchsorted(given, last, side="right")
    for i in np.flatnonzero(stop > start):
        inside = values[start[i]:stop[i]]
        low[i], high[i] = min(low[i], inside.min()), max(high[i], inside.max())
    return low, high
