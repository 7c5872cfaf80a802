"""How well a fitted crane follows measured signals: residuals, fit index, tubes, load's path."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from segfmu.arrays import FloatArray
from segfmu.validation.comparison import Excess, compare
from segfmu.validation.identification.log import OUTPUTS, Log
from segfmu.validation.identification.model import Model, load_path
from segfmu.validation.identification.noise import dependence
from segfmu.validation.units import pretty

LOAD = tuple(f"load.position.{axis}" for axis in "xyz")
# share of a range that was fitted, by which others may leave it
BEYOND = 0.5
# a fit index that is too low where what is left is no noise, of which samples count for themselves
POOR, NOISE = 0.5, 5.0
# share of the squares of differences from which on a time explains them
MOSTLY = 0.5
OFFSETS = [f"sensor.{name.removeprefix('measured.')}.offset" for name in OUTPUTS]


@dataclass(frozen=True)
class SignalFit:
    """A measured signal against the simulated one.

    Attributes
    ----------
    signal : str
    index : float
        Fit index 1 - |measured - simulated| / |measured - its mean| (NRMSE); 1 for equal signals.
    deviation : float
        Root mean square of the difference [m] or [rad].
    largest : float
        Its greatest absolute value.
    dependence : float
        How many of its samples count as one; far above 1 where the crane has what the model has
        not, or samples are held.
    """

    signal: str
    index: float
    deviation: float
    largest: float
    dependence: float


@dataclass(frozen=True, eq=False)
class Prediction:
    """A part of a log that was not fitted, or was, against the fitted crane.

    Attributes
    ----------
    log : str
    columns : dict of str to ndarray
        "time", and of every signal NAME its "NAME" and "simulated.NAME".
    signals : tuple of SignalFit
    load : float or None
        Fit index of the load's path, all axes together; None if a coordinate was not measured.
    outside : tuple of Excess
        Signals that leave their tubes.
    """

    log: str
    columns: dict[str, FloatArray]
    signals: tuple[SignalFit, ...]
    load: float | None
    outside: tuple[Excess, ...]


def prediction(
    log: Log, simulated: FloatArray, zeros: FloatArray, tube: float
) -> Prediction:
    """Compare a log with simulated signals, shape (rows, 5).

    zeros: of the sensors (5,); tube: half its width, as a share of each signal's greatest value.
    """
    columns: dict[str, FloatArray] = {"time": log.times}
    for place in log.known:
        columns[OUTPUTS[place]] = log.measured[:, place]
        columns[f"simulated.{OUTPUTS[place]}"] = simulated[:, place]
    index = None
    if len(log.known) == len(OUTPUTS):
        paths = [load_path(t - zeros) for t in (log.measured, simulated)]
        for axis, name in enumerate(LOAD):
            columns[name], columns[f"simulated.{name}"] = (path[:, axis] for path in paths)
        index = fit_index(*paths)
    signals = tuple(_signal(n, columns) for n in columns if f"simulated.{n}" in columns)
    measured = {n: columns[n] for n in ("time", *(s.signal for s in signals))}
    model = {n: columns[f"simulated.{n}"] for n in measured if n != "time"}
    outside = compare(
        {"time": log.times, **model}, measured, tube_time=0.0, tube_value=tube, relative=True
    )
    return Prediction(log.name, columns, signals, index, tuple(outside))


@dataclass(frozen=True)
class Beyond:
    """A signal that leaves what was fitted: what it shows there, no fit could tell.

    Attributes
    ----------
    log, signal : str
    range, fitted : tuple of 2 float
        What the log has and what was fitted, [m] or [rad].
    """

    log: str
    signal: str
    range: tuple[float, float]
    fitted: tuple[float, float]

    def __str__(self) -> str:
        own, known = (f"{pretty(low)} to {pretty(high)}" for low, high in (self.range, self.fitted))
        return (
            f"{self.log}: {self.signal} is {own}, in what was fitted only {known}; the rest is "
            "not told by the fit"
        )


def beyond(fitted: Sequence[Prediction], predicted: Sequence[Prediction]) -> Iterator[Beyond]:
    """Where rope and sway leave the ranges that were fitted by more than half of these."""
    for signal in (name for name in OUTPUTS if name.endswith((".length", ".angle"))):
        known = [part.columns[signal] for part in fitted if signal in part.columns]
        if not known:
            continue
        low, high = min(float(v.min()) for v in known), max(float(v.max()) for v in known)
        margin = BEYOND * (high - low)
        for part in predicted:
            values = part.columns.get(signal)
            if values is None:
                continue
            least, most = float(values.min()), float(values.max())
            if least < low - margin or most > high + margin:
                yield Beyond(part.log, signal, (least, most), (low, high))


@dataclass(frozen=True)
class Poor:
    """Signals of a log that what was fitted does not follow.

    Attributes
    ----------
    log : str
    signals : tuple of SignalFit
    """

    log: str
    signals: tuple[SignalFit, ...]

    def __str__(self) -> str:
        names = ", ".join(f"{s.signal} (fit index {told(s.index)})" for s in self.signals)
        return (
            f"{self.log}: the fitted crane does not follow {names}, so its values are of no use: "
            "columns may be swapped or have another sign or unit, or the crane has what the model "
            "has not"
        )


def poor(fitted: Sequence[Prediction]) -> Iterator[Poor]:
    """Logs with signals of which more than half is left, other than noise."""
    for part in fitted:
        own = (s for s in part.signals if s.signal in OUTPUTS)
        found = tuple(s for s in own if s.index < POOR and s.dependence > NOISE)
        if found:
            yield Poor(part.log, found)


@dataclass(frozen=True)
class Shifted:
    """A drive that moves before or behind the fitted crane.

    Attributes
    ----------
    log, signal : str
    time : float
        By which it is behind; negative where it is before [s].
    """

    log: str
    signal: str
    time: float

    def __str__(self) -> str:
        where = f"{self.log}: {self.signal} is {pretty(abs(self.time))} s"
        if self.time > 0.0:
            return f"{where} behind the fitted crane: fit lag and dead time of its drive"
        return (
            f"{where} before the fitted crane, which no lag or dead time explains: setpoints and "
            "measured signals have not one clock, or what the crane file has is too long"
        )


def shifted(fitted: Sequence[Prediction]) -> Iterator[Shifted]:
    """Positions of drives whose differences are mostly those of another time, by a row or more."""
    for part in fitted:
        times = part.columns["time"]
        for signal in OUTPUTS[:3]:
            if signal not in part.columns:
                continue
            simulated = part.columns[f"simulated.{signal}"]
            rate, away = np.gradient(simulated, times), part.columns[signal] - simulated
            rate, away = rate - rate.mean(), away - away.mean()
            square, common = float(rate @ rate), float(rate @ away)
            if common**2 <= MOSTLY * square * float(away @ away):
                continue
            if abs(common) >= square * float(np.median(np.diff(times))):
                yield Shifted(part.log, signal, -common / square)


def fit_index(measured: FloatArray, simulated: FloatArray) -> float:
    """1 - |measured - simulated| / |measured - its mean|, of one signal or several together."""
    # the mean of equal numbers may differ from them by rounding
    if not np.ptp(measured, axis=0).any():
        return float("nan")
    spread = float(np.linalg.norm(measured - measured.mean(axis=0)))
    away = float(np.linalg.norm(measured - simulated))
    return 1.0 - away / spread


def told(index: float) -> str:
    """A fit index; far below 0 it tells no more than that the signal rests, or is not followed."""
    if np.isnan(index):
        return "rests"
    return f"{index:.3f}" if index > -10.0 else "below -10"


def zeros_of(model: Model, changes: dict[str, float]) -> FloatArray:
    """Zeros of the sensors, shape (5,)."""
    return np.array([changes.get(name, model.value(name)) for name in OFFSETS])


def _signal(name: str, columns: dict[str, FloatArray]) -> SignalFit:
    measured, simulated = columns[name], columns[f"simulated.{name}"]
    away = measured - simulated
    return SignalFit(
        name, fit_index(measured, simulated), float(np.sqrt(np.mean(away**2))),
        float(np.abs(away).max()), dependence(away),
    )
