"""The worst case of a criterion: differential evolution over the factors, batch by batch.

A search is made again from its beginning whenever runs have come, with the margins that are known;
it stops at the first batch that has unknown ones, which are the next runs. So a search that was
interrupted goes on by itself.

R. Storn, K. Price: Differential evolution, Journal of Global Optimization 11 (1997) 341-359.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from contextlib import suppress
from itertools import count, islice, product
from math import inf, isnan, prod
from typing import Any

import numpy as np

from segfmu.arrays import FloatArray
from segfmu.validation.campaigns.sampling import Sample, at, levels, places
from segfmu.validation.files.campaign_tables import FactorTable, SamplingTable

# values of all factors, in their order
Case = tuple[Any, ...]

# of the runs of a search: those of corners at most, and those drawn before an evolution begins
CORNERS, DRAWN = 0.1, 0.15
# of an evolution; it is at its end when its margins scatter by less than this share of those of its
# draws, and the next one begins from other draws, so that no valley takes all runs
POPULATION, SETTLED = 12, 0.01
# of the runs those that are left for a last evolution, from the best that all before have found
LAST = 0.3
# the evolution's cube is larger than that of the factors by this at each side, so that their ends,
# where worst cases often are, are cases and not limits that are never met
BEYOND = 0.1


class _Unknown(Exception):
    """Cases whose margins the search needs to go on."""

    def __init__(self, cases: list[Case]) -> None:
        super().__init__(cases)
        self.cases = cases


class _Spent(Exception):
    """The search has had all of its runs."""


def next_cases(
    sampling: SamplingTable, factors: Sequence[FactorTable], margins: Mapping[Case, float | None]
) -> list[Sample]:
    """The runs that the search for the least margin needs next; none when it is at its end.

    Parameters
    ----------
    sampling : SamplingTable
        How the first runs are drawn, how many the search may have, and its seed.
    factors : sequence of FactorTable
    margins : mapping
        Margins by the values of all factors; None of a run that has no verdict.
    """
    search = _Search(sampling, factors, margins)
    try:
        search.run()
    except _Unknown as unknown:
        names = [f.name for f in factors]
        return [dict(zip(names, case, strict=True)) for case in unknown.cases]
    except _Spent:
        pass
    return []


class _Search:
    def __init__(
        self, sampling: SamplingTable, factors: Sequence[FactorTable],
        margins: Mapping[Case, float | None],
    ) -> None:
        assert sampling.runs is not None
        self._sampling, self._factors, self._margins = sampling, factors, margins
        self._runs = sampling.runs
        # runs that the evolutions may have so far, and places of those that they had
        self._limit = self._runs
        self._seen: dict[Case, list[float]] = {}

    def run(self) -> None:
        """Look everywhere, then where it was worst."""
        self._limit = round((1.0 - LAST) * self._runs)
        with suppress(_Spent):
            self._explore()
        self._limit = self._runs
        self._evolve(np.array(list(self._seen.values())), self._sampling.seed)

    def _explore(self) -> None:
        """Evolutions one after the other, until their runs are spent or nothing new comes."""
        first = self._corners()
        for attempt in count():
            before = len(self._seen)
            seed = self._sampling.seed + attempt
            own = self._sampling.model_copy(update={"seed": seed})
            drawn = places(own, len(self._factors), max(int(DRAWN * self._runs), POPULATION))
            self._evolve(np.concatenate([first, drawn]), seed)
            if len(self._seen) == before:
                return
            first = first[:0]

    def _evolve(self, points: FloatArray, seed: int) -> None:
        """One evolution from the best of points, shape (points, factors)."""
        from scipy.optimize import differential_evolution

        margins = self._values(points.T)
        known = margins[np.isfinite(margins)]
        scatter = float(np.ptp(known)) if known.size else 0.0
        differential_evolution(
            self._values, [(-BEYOND, 1.0 + BEYOND)] * len(self._factors),
            init=points[np.argsort(margins, kind="stable")[:POPULATION]], maxiter=self._runs,
            tol=0.0, atol=SETTLED * scatter, polish=False, seed=seed, updating="deferred",
            vectorized=True,
        )

    def _corners(self) -> FloatArray:
        """All combinations of ends and choices, or some; shape (corners, factors)."""
        ends = [_ends(f) for f in self._factors]
        # without ranges there is nothing else
        ranges = any(f.range is not None for f in self._factors)
        most = int(CORNERS * self._runs) if ranges else self._runs
        if prod(map(len, ends)) <= most:
            return np.array(list(product(*ends)))
        draw = np.random.default_rng(self._sampling.seed)
        return np.array([[draw.choice(e) for e in ends] for _ in range(most)])

    def _values(self, points: FloatArray) -> FloatArray:
        """Margins at places, shape (factors, runs); a run without one is the best."""
        clipped = np.clip(points.T, 0.0, 1.0).tolist()
        cases = [
            tuple(at(f, place) for f, place in zip(self._factors, point, strict=True))
            for point in clipped
        ]
        new = {c: p for c, p in zip(cases, clipped, strict=True) if c not in self._seen}
        mine = dict(islice(new.items(), self._limit - len(self._seen)))
        self._seen |= mine
        unknown = [case for case in mine if case not in self._margins]
        if unknown:
            raise _Unknown(unknown)
        if len(mine) < len(new):
            raise _Spent
        return np.array([_least(self._margins[case]) for case in cases])


def _ends(factor: FactorTable) -> list[float]:
    """Places of the ends of a range, or of all choices."""
    if factor.range is not None:
        return [0.0, 1.0]
    count = len(levels(factor, 0))
    return [(i + 0.5) / count for i in range(count)]


def _least(margin: float | None) -> float:
    if margin is None:
        return inf
    return -inf if isnan(margin) else margin
