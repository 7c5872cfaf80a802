"""A criterion over all runs of a campaign, and the run that is worst for it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from segfmu.validation.campaigns.rare import Found
from segfmu.validation.units import pretty, with_unit


@dataclass(frozen=True)
class Summary:
    """A criterion in all runs.

    Attributes
    ----------
    criterion : str
    judged, held : int
        Runs that came to a verdict, and those in which it holds.
    worst : float or None
        The least margin; None without a verdict.
    run : int or None
        Number of the run that has it.
    fails : Probability, RareProbability or None
        That it fails; None without a verdict, and of runs that were chosen otherwise than at random
        or for this.
    unit : str
        Of the margin; "of the bounds" for the share of drives, empty where it is not known.
    """

    criterion: str
    judged: int
    held: int
    worst: float | None
    run: int | None
    fails: Found | None = None
    unit: str = ""

    @property
    def least(self) -> str:
        """The least margin as it is told; empty without a verdict."""
        return "" if self.worst is None else with_unit(pretty(self.worst), self.unit)

    @property
    def share(self) -> float:
        """Of the runs with a verdict those in which it holds; 0 without any."""
        return self.held / self.judged if self.judged else 0.0


@dataclass(frozen=True)
class WorstCase:
    """The run with the least margin of a criterion.

    Attributes
    ----------
    run : int
    margin : float
    factors : dict
        Values of all factors by name.
    command : str
        That makes it again.
    unit : str
        Of the margin, as in a `Summary`.
    """

    run: int
    margin: float
    factors: dict[str, Any]
    command: str
    unit: str = ""
