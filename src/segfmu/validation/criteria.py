"""Verdict on a co-simulated mission: tracking, residual sway, peaks."""

from __future__ import annotations

from dataclasses import dataclass
from math import isfinite

import numpy as np
from numpy.typing import NDArray

from segfmu.crane.bounds import ActuatorBounds, BoundUse
from segfmu.errors import InputError
from segfmu.validation.drive_use import RUN_MARGIN, run_uses
from segfmu.validation.files.crane_models import MODELS
from segfmu.validation.units import with_unit

DRIVES = ("bridge", "trolley", "hoist")
RATES = {"bridge": "bridge.velocity", "trolley": "trolley.velocity", "hoist": "rope.velocity"}
# what has sway angles: the rope, and links of models below it
PARTS = ("sway", *(link for model in MODELS for link in model.links))
# numbers below these are noise of the computation
NOISE = {"mm": 1e-6, "deg": 1e-6}


@dataclass(frozen=True)
class Row:
    """A measure of a run against what is allowed.

    Attributes
    ----------
    name : str
    value, allowed : float
    unit : str
        Of both.
    key : str
        That sets what is allowed.
    """

    name: str
    value: float
    allowed: float
    unit: str
    key: str

    @property
    def passed(self) -> bool:
        """Whether it is within what is allowed."""
        return self.value <= self.allowed

    @property
    def measured(self) -> str:
        """The value and its unit; of noise what it is below."""
        least = NOISE.get(self.unit, 0.0)
        value = f"below {least:g}" if self.value < least else f"{self.value:.4g}"
        return f"{value} {self.unit}".replace("e-0", "e-")

    def __str__(self) -> str:
        return f"{self.measured} (at most {self.allowed:g})"


@dataclass(frozen=True)
class Criteria:
    """The measures of a run and their tolerances.

    Attributes
    ----------
    duration : float
        Planned duration [s].
    peak_force, peak_velocity : dict
        Largest magnitude per drive [N], [m/s].
    tracking_error : float
        Largest distance of the load from its reference [m].
    residual_sway : float
        Largest sway angle, of the rope and of a sling, after the planned duration [deg].
    uses : tuple of BoundUse
        Of the bounds of the drives, if any are known.
    """

    duration: float
    peak_force: dict[str, float]
    peak_velocity: dict[str, float]
    tracking_error: float
    residual_sway: float
    tracking_tolerance: float
    sway_tolerance: float
    uses: tuple[BoundUse, ...] = ()

    @property
    def rows(self) -> tuple[Row, ...]:
        """What the verdict follows from."""
        return (
            Row(
                "largest tracking error", 1e3 * self.tracking_error, 1e3 * self.tracking_tolerance,
                "mm", "simulation.tracking_tolerance",
            ),
            Row(
                "residual sway", self.residual_sway, self.sway_tolerance, "deg",
                "simulation.sway_tolerance",
            ),
            *(
                Row(
                    f"use of the bound of {use.name}", 100.0 * use.use,
                    100.0 * (1.0 + RUN_MARGIN), "%", with_unit(f"{use.bound:.4g}", use.unit),
                )
                for use in self.uses if isfinite(use.bound)
            ),
        )

    @property
    def passed(self) -> bool:
        """The verdict."""
        return all(row.passed for row in self.rows)


def judge(
    rows: NDArray[np.void], duration: float, tracking_tolerance: float, sway_tolerance: float,
    bounds: ActuatorBounds | None = None,
) -> Criteria:
    """Judge the rows of a co-simulation, a structured array with the FMUs' variable names.

    Raises
    ------
    InputError
        If the run ends before the plan does.
    """
    after = rows["time"] >= duration - 1e-9
    if not after.any():
        raise InputError(
            f"the run ends at {rows['time'][-1]:.3f} s, before the plan does at {duration:.3f} s"
        )
    sway = np.max([np.abs(rows[name]) for name in angles(rows)], axis=0)
    return Criteria(
        duration=duration,
        peak_force={d: _peak(rows[f"drive.{d}.force"]) for d in DRIVES},
        peak_velocity={d: _peak(rows[RATES[d]]) for d in DRIVES},
        tracking_error=_peak(rows["error.load.norm"]),
        residual_sway=float(np.degrees(sway[after].max())),
        tracking_tolerance=tracking_tolerance,
        sway_tolerance=sway_tolerance,
        uses=() if bounds is None else run_uses(rows, bounds),
    )


def angles(rows: NDArray[np.void]) -> list[str]:
    """Names of the sway angles in rows: of the rope, and of the links of the model below it."""
    every = [f"{part}.{axis}.angle" for part in PARTS for axis in "xy"]
    return [name for name in every if name in (rows.dtype.names or ())]


def _peak(values: NDArray[np.float64]) -> float:
    return float(np.abs(values).max())
