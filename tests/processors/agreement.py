"""Durations beside those of this environment: how far apart, and where."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from tests.processors.problems import Problem
from tests.processors.variants import Variant

ROOT = Path(__file__).parents[2]
# largest share by which durations may differ
TOLERANCE = 1e-9
# workers of linear algebra would wait for each other
THREADS = {"OPENBLAS_NUM_THREADS": "1"}


@dataclass(frozen=True, eq=False)
class Difference:
    """Durations (problems,) [s] beside those expected; negative where a plan is refused."""

    name: str
    found: np.ndarray
    expected: np.ndarray

    @property
    def shares(self) -> np.ndarray:
        """Relative differences (problems,); infinite where one of two is refused."""
        planned = (self.found >= 0.0) & (self.expected >= 0.0)
        larger = np.maximum(np.maximum(self.found, self.expected), 1e-300)
        apart = np.abs(self.found - self.expected) / larger
        return np.where(planned, apart, np.where(self.found == self.expected, 0.0, np.inf))

    @property
    def wrong(self) -> np.ndarray:
        """Places of the problems that differ by more than the tolerance."""
        return np.flatnonzero(~(self.shares <= TOLERANCE))

    def __str__(self) -> str:
        shares = self.shares
        both = shares[np.isfinite(shares)]
        return (
            f"{self.name:34} largest difference {both.max(initial=0.0):8.1e}, {len(self.wrong):4} "
            f"above {TOLERANCE:g}, {int(np.isinf(shares).sum()):4} refused by one"
        )


def durations(given: list[Problem], folder: Path, variant: Variant | None = None) -> np.ndarray:
    """Durations [s] in a process of its own."""
    file = folder / "problems.json"
    file.write_text(json.dumps(given), "utf-8")
    variant = variant or Variant("here")
    command = [sys.executable, str(Path(__file__).with_name("durations.py")), str(file)]
    if variant.kernels is not None:
        command.append(str(variant.kernels))
    done = subprocess.run(
        command, env=os.environ | THREADS | variant.environment, stdout=subprocess.PIPE, text=True,
        check=True, cwd=ROOT,
    )
    return np.array(json.loads(done.stdout))
