"""What an identification found."""

from __future__ import annotations

from dataclasses import dataclass
from math import floor, log10
from pathlib import Path
from typing import TYPE_CHECKING, Any

from segfmu.errors import InputError
from segfmu.validation.files.crane_file import CraneFile
from segfmu.validation.identification.gaps import Gap
from segfmu.validation.identification.possible import Impossible
from segfmu.validation.identification.prediction import (
    Beyond,
    Poor,
    Prediction,
    Shifted,
    beyond,
    poor,
    shifted,
    told,
)
from segfmu.validation.units import pretty

if TYPE_CHECKING:
    from matplotlib.figure import Figure


@dataclass(frozen=True)
class Estimate:
    """A parameter that the log tells.

    Attributes
    ----------
    key : str
        Of the crane file, with dots.
    unit : str
        Of the crane file, also of the values.
    before, value : float
        In the crane file, and fitted.
    low, high : float
        Interval at 95 %.
    """

    key: str
    unit: str
    before: float
    value: float
    low: float
    high: float

    @property
    def rounded(self) -> float:
        """The value with digits down to a hundredth of its interval."""
        width = self.high - self.low
        if width <= 0.0:
            return self.value
        return round(self.value, 2 - floor(log10(width)))

    def __str__(self) -> str:
        return (
            f"{self.key} {pretty(self.rounded)} {self.unit} "
            f"({pretty(self.low)} to {pretty(self.high)})"
        )


@dataclass(frozen=True)
class Untold:
    """A combination of parameters that the log does not tell.

    Attributes
    ----------
    key : str
        The parameter that keeps the value of the crane file, so that the others are told.
    unit : str
    value : float
        That value.
    parts : tuple of (str, float)
        All that change together, and how much, in units of what is a large change of each: the
        signals are the same, or all but the same, for any amount of this.
    """

    key: str
    unit: str
    value: float
    parts: tuple[tuple[str, float], ...]

    def __str__(self) -> str:
        together = [name for name, _ in self.parts if name != self.key]
        beside = f" apart from {', '.join(together)}" if together else ""
        return f"{self.key} is not told{beside}; kept at {pretty(self.value)} {self.unit}"


@dataclass(frozen=True, eq=False, repr=False)
class Identification:
    """Parameters of a crane from its logs; `found["friction.sway.viscous"]` is one of them.

    Attributes
    ----------
    source : Path or None
        The crane file that the search began with.
    nominal : CraneFile
        Its content.
    estimates : tuple of Estimate
    untold : tuple of Untold
    fitted, predicted : tuple of Prediction
        The parts of the logs that were fitted, and those that were not; `load` of the latter is
        what the crane is worth.
    converged : bool
        False if least squares made their most steps without an end: the crane then has what the
        model has not, or the crane file is far from it.
    gaps : tuple of Gap
        The longest time of each log without rows, shorter than a period of the pendulum, in which
        setpoints changed.
    impossible : tuple of Impossible
        Estimates that no crane has; there is no crane file of them.
    """

    source: Path | None
    nominal: CraneFile
    estimates: tuple[Estimate, ...]
    untold: tuple[Untold, ...]
    fitted: tuple[Prediction, ...]
    predicted: tuple[Prediction, ...]
    converged: bool = True
    gaps: tuple[Gap, ...] = ()
    impossible: tuple[Impossible, ...] = ()

    def __getitem__(self, key: str) -> Estimate:
        for estimate in self.estimates:
            if estimate.key == key:
                return estimate
        raise KeyError(key)

    @property
    def crane(self) -> dict[str, Any]:
        """The crane as its file says it, with the estimates; for `load_mission` and others."""
        found: dict[str, Any] = self.nominal.model_dump(exclude_unset=True)
        for estimate in self.estimates:
            table = found
            *tables, name = estimate.key.split(".")
            for part in tables:
                table = table.setdefault(part, {})
            table[name] = estimate.value
        return found

    @property
    def poor(self) -> tuple[Poor, ...]:
        """Logs that the fitted crane does not follow, with signals: no values to use."""
        return tuple(poor(self.fitted))

    @property
    def beyond(self) -> tuple[Beyond, ...]:
        """Where rope and sway of what was only predicted are far from all that was fitted."""
        return tuple(beyond(self.fitted, self.predicted))

    @property
    def shifted(self) -> tuple[Shifted, ...]:
        """Drives that follow velocities before the fitted crane does, or behind it."""
        return tuple(shifted(self.fitted)) if self.nominal.drive == "velocity" else ()

    def write(self, path: str | Path) -> Path:
        """Write the crane file with the estimates and where they are from; returns the file.

        Comments and all other values are those of the file that the search began with.

        Raises
        ------
        InputError
            If it cannot be written, or an estimate is none that a crane has or its file may have.
        """
        from segfmu.validation.identification.crane_output import write

        return write(self, Path(path))

    def plot(self) -> Figure:
        """Measured and simulated signals, and their differences, of all that was predicted."""
        from segfmu.validation.plots.identification import plot_identification

        if self.predicted:
            return plot_identification(self.predicted, "only predicted")
        if not self.fitted:
            raise InputError("nothing was fitted or predicted")
        return plot_identification(self.fitted, "fitted")

    def __repr__(self) -> str:
        loads = ", ".join(told(p.load) for p in self.predicted if p.load is not None)
        values = ", ".join(map(str, self.estimates)) or "the logs tell nothing"
        return f"<Identification: {values}{f'; load {loads}' if loads else ''}>"
