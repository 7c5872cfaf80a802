"""Verdict on a campaign: the gain by feedback over feedforward alone."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from math import inf, nan

from segfmu.validation.campaign import Outcome
from segfmu.validation.disturbances import DISTURBANCES, Disturbance
from segfmu.validation.methods import FEEDFORWARD

# factors demanded of RMS tracking error and residual sway
ERROR_FACTOR = 3.0
SWAY_FACTOR = 10.0

# smaller errors count as zero: nothing to gain, nothing worse [m], [deg]
SMALL_ERROR = 1e-4
SMALL_SWAY = 0.01


@dataclass(frozen=True)
class Comparison:
    """Feedforward with a feedback against feedforward alone.

    Attributes
    ----------
    mode, disturbance, method : str
    error_ratio, sway_ratio : float
        RMS tracking error and residual sway of the feedforward over those with the feedback;
        infinite if only the feedforward's run failed, NaN if both are small.
    demanded : bool
        Whether the factors are required.
    worse : bool
    """

    mode: str
    disturbance: str
    method: str
    error_ratio: float
    sway_ratio: float
    demanded: bool
    worse: bool

    @property
    def reached(self) -> bool:
        """Whether it is not worse and, if demanded, better by both factors."""
        missed = self.error_ratio < ERROR_FACTOR or self.sway_ratio < SWAY_FACTOR
        return not self.worse and not (self.demanded and missed)

    def __str__(self) -> str:
        worse = "worse than without" if self.worse else (
            f"RMS error {self.error_ratio:.3g} of {ERROR_FACTOR:g} times less, "
            f"residual sway {self.sway_ratio:.3g} of {SWAY_FACTOR:g} times less"
        )
        return f"{self.mode} mode, {self.disturbance}, {self.method}: {worse}"


def compare(
    outcomes: Iterable[Outcome], disturbances: Iterable[Disturbance] = DISTURBANCES
) -> list[Comparison]:
    """Compare every outcome with feedback with that of the feedforward alone.

    If the load's height has an error that no sensor measures, the horizontal error is compared.
    """
    rows = {row.name: row for row in disturbances}
    found = list(outcomes)
    alone = {(o.mode, o.disturbance): o for o in found if o.method == FEEDFORWARD}
    return [
        _compared(alone[o.mode, o.disturbance], o, rows[o.disturbance])
        for o in found
        if o.method.startswith(FEEDFORWARD) and o.method != FEEDFORWARD
    ]


def _compared(alone: Outcome, aided: Outcome, row: Disturbance) -> Comparison:
    blind = row.blind
    errors = [o.rms_horizontal if blind else o.rms_error for o in (alone, aided)]
    sways = [alone.residual_sway, aided.residual_sway]
    failed = bool(aided.failure)
    if failed or alone.failure:
        ratios = (0.0, 0.0) if failed else (inf, inf)
        worse = failed and not alone.failure
    else:
        ratios = _ratio(errors, SMALL_ERROR), _ratio(sways, SMALL_SWAY)
        worse = _worse(errors, SMALL_ERROR) or _worse(sways, SMALL_SWAY)
    return Comparison(
        aided.mode, aided.disturbance, aided.method, *ratios, demanded=row.demanded, worse=worse
    )


def _ratio(pair: list[float], small: float) -> float:
    """First over second; NaN if the first one is small: there is nothing to gain."""
    alone, aided = pair
    if alone <= small:
        return nan
    return alone / aided if aided > 0.0 else inf


def _worse(pair: list[float], small: float) -> bool:
    alone, aided = pair
    return aided > max(alone, small)
