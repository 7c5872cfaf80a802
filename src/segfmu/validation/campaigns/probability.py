"""How probable it is that a criterion fails: an interval from draws at random.

C. J. Clopper, E. S. Pearson: The use of confidence or fiducial limits illustrated in the case of
the binomial, Biometrika 26 (1934) 404-413.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import ceil, floor, log10

CONFIDENCE = 0.95


@dataclass(frozen=True)
class Probability:
    """The probability that a criterion fails, in draws of the factors.

    Attributes
    ----------
    failed, draws : int
        Draws in which it fails, and all that came to a verdict; at least one.
    """

    failed: int
    draws: int

    @property
    def interval(self) -> tuple[float, float]:
        """Clopper-Pearson interval at 95 %, from 0 to 1.

        One-sided if none or all of the draws fail, since the other end is 0 or 1 by itself;
        two-sided, with 2.5 % at each end, in between.
        """
        from scipy.stats import binomtest

        kind = {0: "less", self.draws: "greater"}.get(self.failed, "two-sided")
        found = binomtest(self.failed, self.draws, alternative=kind).proportion_ci(CONFIDENCE)
        return float(found.low), float(found.high)

    def __str__(self) -> str:
        low, high = self.interval
        if self.failed == 0:
            return f"below {percent(high, up=True)} %"
        if self.failed == self.draws:
            return f"above {percent(low, up=False)} %"
        return f"{percent(low, up=False)} to {percent(high, up=True)} %"


def percent(value: float, *, up: bool) -> str:
    """In per cent, two digits from the nearer of 0 and 100 %, rounded outwards."""
    if value > 0.5:
        return f"{100.0 - _rounded(100.0 * (1.0 - value), up=not up):.12g}"
    return f"{_rounded(100.0 * value, up=up):.12g}"


def _rounded(value: float, *, up: bool) -> float:
    if value == 0.0:
        return 0.0
    unit = 10.0 ** (floor(log10(value)) - 1)
    return unit * (ceil(value / unit) if up else floor(value / unit))
