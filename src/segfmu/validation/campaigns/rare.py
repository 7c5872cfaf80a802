"""The probability of rare failures: subset simulation over the factors, by OpenTURNS.

Each step draws, by Markov chains, from the cases whose margin is below that of the worst tenth of
the step before, until a tenth of them fails; the probability is the product of the steps' shares.
As the search for worst cases, it is made again from its beginning whenever runs have come.

S.-K. Au, J. L. Beck: Estimation of small failure probabilities in high dimensions by subset
simulation, Probabilistic Engineering Mechanics 16 (2001) 263-277.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from importlib.util import find_spec
from math import exp, isnan
from typing import Any

import numpy as np

from segfmu.arrays import FloatArray
from segfmu.errors import InputError
from segfmu.validation.campaigns.probability import Probability, percent
from segfmu.validation.campaigns.sampling import Sample, at
from segfmu.validation.campaigns.search import Case
from segfmu.validation.files.campaign_tables import FactorTable, SamplingTable

# steps of a search, and batches of a step, which run side by side
STEPS, BATCHES = 5, 10
SHARE = 0.1
# standard deviations of normal distributions: of two ends at 95 %, and of one
TWO_SIDED, ONE_SIDED = 1.96, 1.645
# a share of a step from which on its threshold counts as between margins, and not on many that are
# equal, from which no step leads on
EVEN = 0.5 * SHARE
# in place of margins that are no numbers
NEVER, ALWAYS = 1e300, -1e300


@dataclass(frozen=True)
class RareProbability:
    """A probability from subset simulation.

    Attributes
    ----------
    probability : float
        The estimate; where `below`, that of the last step, in which no tenth failed yet.
    deviation : float
        Its coefficient of variation.
    runs : int
    below : bool
        Whether the runs ended before a tenth of a step failed.
    """

    probability: float
    deviation: float
    runs: int
    below: bool = False

    @property
    def interval(self) -> tuple[float, float]:
        """At 95 %, as if the logarithm of the estimate were normal."""
        if self.below:
            return 0.0, min(1.0, self.probability * exp(ONE_SIDED * self.deviation))
        factor = exp(TWO_SIDED * self.deviation)
        return self.probability / factor, min(1.0, self.probability * factor)

    def __str__(self) -> str:
        low, high = self.interval
        if self.below:
            return f"below {percent(high, up=True)} %"
        return f"{percent(low, up=False)} to {percent(high, up=True)} %"


Found = Probability | RareProbability


class _Unknown(Exception):
    """Margins are needed to go on."""


@dataclass
class _Margins:
    """The function that OpenTURNS looks at: margins by places of the factors."""

    factors: Sequence[FactorTable]
    known: Mapping[Case, float | None]
    missing: list[Case] = field(default_factory=list)
    first: int = 0
    failed: int = 0
    runs: int = 0
    step: int = 0

    def __call__(self, points: Any) -> list[list[float]]:
        cases = [
            tuple(at(f, place) for f, place in zip(self.factors, point, strict=True))
            for point in np.clip(points, 0.0, 1.0).tolist()
        ]
        self.missing = [c for c in dict.fromkeys(cases) if c not in self.known]
        if self.missing:
            raise _Unknown
        margins = [self.known[case] for case in cases]
        if self.runs < self.step:
            # of draws that are independent, those with a verdict
            self.first += sum(m is not None for m in margins)
            self.failed += sum(m is not None and not m >= 0.0 for m in margins)
        self.runs += len(cases)
        return [[_value(margin)] for margin in margins]


def _value(margin: float | None) -> float:
    if margin is None:
        return NEVER
    return ALWAYS if isnan(margin) else margin


def require_package() -> None:
    """Refuse to begin without OpenTURNS.

    Raises
    ------
    InputError
        That names it.
    """
    if find_spec("openturns") is None:
        raise InputError(
            'search = "rare" needs openturns: pip install \'segfmu[rare]\' installs it'
        )


def rare_cases(
    sampling: SamplingTable, factors: Sequence[FactorTable], margins: Mapping[Case, float | None]
) -> list[Sample]:
    """The runs that the search needs next; none when it is at its end. As `search.next_cases`."""
    found = _simulated(sampling, factors, margins)
    if isinstance(found, list):
        names = [f.name for f in factors]
        return [dict(zip(names, case, strict=True)) for case in found]
    return []


def rare_probability(
    sampling: SamplingTable, factors: Sequence[FactorTable], margins: Mapping[Case, float | None]
) -> Found | None:
    """What a search that is at its end has found; None if no run of its first step has a verdict.

    A probability that is not rare, or of a margin with many equal values, from which no step leads
    on, is that of the first step, whose draws are independent.
    """
    found = _simulated(sampling, factors, margins)
    assert not isinstance(found, list)
    return found


def _simulated(
    sampling: SamplingTable, factors: Sequence[FactorTable], known: Mapping[Case, float | None]
) -> list[Case] | Found | None:
    import openturns

    size = (sampling.runs or 0) // (STEPS * BATCHES)
    margins = _Margins(factors, known, step=size * BATCHES)
    with _seeded(sampling.seed):
        cube = openturns.JointDistribution([openturns.Uniform(0.0, 1.0)] * len(factors))
        function = openturns.PythonFunction(len(factors), 1, func_sample=margins)
        margin = openturns.CompositeRandomVector(function, openturns.RandomVector(cube))
        event = openturns.ThresholdEvent(margin, openturns.Less(), 0.0)
        algorithm = openturns.SubsetSampling(event)
        algorithm.setConditionalProbability(SHARE)
        algorithm.setMaximumOuterSampling(BATCHES)
        algorithm.setBlockSize(size)
        # all steps but the last one end above it
        algorithm.setMinimumProbability(SHARE ** (STEPS - 0.5))
        try:
            algorithm.run()
        except RuntimeError:
            # of the function, which the library wraps, or below the minimum
            if margins.missing:
                return margins.missing
    return _told(
        margins, np.array(algorithm.getThresholdPerStep()),
        np.array(algorithm.getProbabilityEstimatePerStep()),
        np.array(algorithm.getCoefficientOfVariationPerStep()),
    )


def _told(
    margins: _Margins, thresholds: FloatArray, estimates: FloatArray, deviations: FloatArray
) -> Found | None:
    shares = estimates[:-1] / np.append(1.0, estimates[:-2])
    if estimates.size == 1 or shares.min() < EVEN:
        return Probability(margins.failed, margins.first) if margins.first else None
    return RareProbability(
        float(estimates[-1]), float(deviations[-1]), margins.runs, bool(thresholds[-1] > 0.0)
    )


@contextmanager
def _seeded(seed: int) -> Iterator[None]:
    """The library's random numbers from a seed; those of the caller go on behind it."""
    import openturns

    state = openturns.RandomGenerator.GetState()
    openturns.RandomGenerator.SetSeed(seed)
    try:
        yield
    finally:
        openturns.RandomGenerator.SetState(state)
