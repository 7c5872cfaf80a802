"""What comes of a scenario: the rows of its run, and its verdicts."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from segfmu.validation.files.scenario_file import Scenario
from segfmu.validation.monitor import Finding
from segfmu.validation.units import with_unit

Rows = NDArray[np.void]


@dataclass(frozen=True, eq=False)
class Result:
    """A scenario that was run.

    Attributes
    ----------
    scenario : Scenario
    known : mapping
        Times of "start", "arrival" and "end" [s]; empty if there is no plan.
    rows : structured array or None
        Of the run, if it came to its end and they were wanted.
    findings : tuple of Finding
        Of the criteria.
    error : str
        Why there is no run; empty if there is.
    """

    scenario: Scenario
    known: Mapping[str, float]
    rows: Rows | None = None
    findings: tuple[Finding, ...] = ()
    error: str = ""

    @property
    def passed(self) -> bool:
        """Whether the run came to its end and all criteria hold."""
        return not self.error and all(f.passed for f in self.findings)

    @property
    def right(self) -> bool:
        """Whether it passed or failed as its file expects."""
        return self.passed is (self.scenario.file.expect == "pass")

    def require(self) -> None:
        """AssertionError with all that failed, if it did not go as its file expects."""
        if self.right:
            return
        wrong = [
            f"{f.name}: margin {with_unit(f'{f.margin:.4g}', f.unit)}"
            for f in self.findings if not f.passed
        ]
        reasons = "; ".join([self.error] if self.error else wrong) or "passed, expected to fail"
        raise AssertionError(f"{self.scenario.path}: {reasons}")
