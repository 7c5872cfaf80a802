"""Samples of the factors of a campaign: for every run the values of its factors."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Iterator, Sequence
from itertools import product
from math import exp, log, prod
from typing import Any

import numpy as np

from segfmu.arrays import FloatArray
from segfmu.errors import InputError
from segfmu.validation.files.campaign_tables import MOST_RUNS, FactorTable, SamplingTable

# name of a factor -> its value; without a name it keeps the value of the files
Sample = dict[str, Any]


def samples(sampling: SamplingTable, factors: Sequence[FactorTable]) -> list[Sample]:
    """The samples of all runs of a scenario, in their order; the same seed gives the same ones.

    Raises
    ------
    InputError
        For more than a million.
    """
    if not factors:
        return [{} for _ in range(sampling.runs or 1)]
    return list(KINDS[sampling.kind](sampling, factors))


def levels(factor: FactorTable, count: int) -> list[Any]:
    """All values of a factor, and of a range so many at even distances."""
    if factor.range is None:
        return list(factor.values or factor.variants or ())
    return [at(factor, i / (count - 1)) for i in range(count)]


def at(factor: FactorTable, place: float) -> Any:
    """The value of a factor at a place from 0 to 1."""
    if factor.range is None:
        every = levels(factor, 0)
        return every[min(int(place * len(every)), len(every) - 1)]
    low, high = factor.range
    if factor.scale == "log":
        value = exp(log(low) + place * (log(high) - log(low)))
    else:
        value = low + place * (high - low)
    # ends are exact, and rounding must not leave the range
    value = high if place == 1.0 else min(max(value, low), high)
    return round(value) if factor.integer else value


def known_value(factor: FactorTable, kept: Any) -> Any:
    """The value of a factor that a table of runs keeps; numbers that are alike there have types."""
    if factor.values is not None:
        return next(value for value in factor.values if value == kept)
    return round(kept) if factor.integer else kept


def _random(sampling: SamplingTable, factors: Sequence[FactorTable]) -> Iterator[Sample]:
    assert sampling.runs is not None
    points = places(sampling, len(factors), sampling.runs)
    for row in points.tolist():
        yield {f.name: at(f, place) for f, place in zip(factors, row, strict=True)}


def places(sampling: SamplingTable, dimensions: int, count: int) -> FloatArray:
    """Points in the unit cube that are drawn at random, shape (count, dimensions)."""
    from scipy.stats import qmc

    kind, seed = sampling.kind, sampling.seed
    if kind == "sobol" and dimensions > qmc.Sobol.MAXDIM:
        raise InputError(f"sampling: sobol has at most {qmc.Sobol.MAXDIM} factors")
    if kind == "random":
        return np.random.default_rng(seed).random((count, dimensions))
    maker = qmc.Sobol if kind == "sobol" else qmc.LatinHypercube
    with warnings.catch_warnings():
        # a count that is no power of 2 is less even, and what was asked for
        warnings.simplefilter("ignore", UserWarning)
        points: FloatArray = maker(dimensions, seed=seed).random(count)
    return points


def _combined(factors: Sequence[FactorTable], every: Sequence[Sequence[Any]]) -> Iterator[Sample]:
    if prod(map(len, every)) > MOST_RUNS:
        raise InputError(f"factors: their combinations are more than {MOST_RUNS} runs")
    for values in product(*every):
        yield dict(zip((f.name for f in factors), values, strict=True))


def _corners(_: SamplingTable, factors: Sequence[FactorTable]) -> Iterator[Sample]:
    return _combined(factors, [levels(f, 2) for f in factors])


def _matrix(_: SamplingTable, factors: Sequence[FactorTable]) -> Iterator[Sample]:
    return _combined(factors, [levels(f, f.levels) for f in factors])


def _alone(_: SamplingTable, factors: Sequence[FactorTable]) -> Iterator[Sample]:
    """The nominal run, then each factor alone."""
    yield {}
    for factor in factors:
        for value in levels(factor, 2):
            yield {factor.name: value}


KINDS: dict[str, Callable[[SamplingTable, Sequence[FactorTable]], Iterator[Sample]]] = {
    "latin hypercube": _random, "random": _random, "sobol": _random, "corners": _corners,
    "matrix": _matrix, "one at a time": _alone,
}
