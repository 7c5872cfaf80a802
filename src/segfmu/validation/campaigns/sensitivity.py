"""How much the margins depend on the factors.

Of a number: its partial rank correlation with the margin, -1 to 1, in which the linear effect of
all other factors on the ranks is taken out. Of a choice: the share of the margin's ranks, 0 to 1,
that it explains beside the others. S. Marino, I. B. Hogue, C. J. Ray, D. E. Kirschner, A
methodology for performing global uncertainty and sensitivity analysis in systems biology, J. Theor.
Biol. 254 (2008).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from segfmu.arrays import FloatArray

# variances of ranks below this are rounding
ROUNDING = 1e-9


@dataclass(frozen=True)
class Sensitivity:
    """The effect of a factor on the margin of a criterion.

    Attributes
    ----------
    criterion, factor : str
    effect : float
        Of a number the partial rank correlation; of a choice the partial share of the ranks.
    signed : bool
        Whether it is a correlation.
    chance : float
        Probability of so large an effect without any dependence, from the F distribution.
    """

    criterion: str
    factor: str
    effect: float
    signed: bool
    chance: float


def sensitivities(
    factors: Mapping[str, Sequence[Any]], margins: Mapping[str, Sequence[float | None]]
) -> list[Sensitivity]:
    """Effects of all factors on all margins, by criterion; the largest first.

    Parameters
    ----------
    factors : mapping of str to sequence
        Numbers, text or truth values of all runs, None where they are not known.
    margins : mapping of str to sequence of float
        None for runs without one. Such runs are left out.
    """
    from scipy.stats import rankdata

    found = []
    for criterion, margin in margins.items():
        known = [
            i for i, m in enumerate(margin)
            if m is not None and np.isfinite(m) and all(v[i] is not None for v in factors.values())
        ]
        ranks = rankdata([margin[i] for i in known]) if known else np.zeros(0)
        designs = {n: _design([v[i] for i in known]) for n, v in factors.items()}
        own = [_effect(criterion, name, designs, ranks) for name in factors]
        found += sorted((s for s in own if s), key=lambda s: -abs(s.effect))
    return found


@dataclass(frozen=True, eq=False)
class _Design:
    """A factor in a regression: ranks of numbers, or indicators of choices, without their mean."""

    columns: FloatArray
    signed: bool


def _design(values: Sequence[Any]) -> _Design:
    from scipy.stats import rankdata

    signed = all(isinstance(v, int | float) and not isinstance(v, bool) for v in values)
    if signed:
        table = np.reshape(rankdata(values), (len(values), 1))
    else:
        choices = sorted({str(v) for v in values})[1:]
        table = np.array([[float(str(v) == c) for c in choices] for v in values])
        table = table.reshape(len(values), len(choices))
    return _Design(table - table.mean(axis=0) if values else table, signed)


def _effect(
    criterion: str, name: str, designs: Mapping[str, _Design], ranks: FloatArray
) -> Sensitivity | None:
    """The effect of one factor; None where there is nothing to tell."""
    from scipy.stats import f as f_distribution

    own, signed = designs[name].columns, designs[name].signed
    if ranks.size < 3 or not own.size:
        return None
    beside = [d.columns for n, d in designs.items() if n != name]
    others = np.hstack([np.zeros((ranks.size, 1)), *beside])
    left, rest = _without(ranks[:, None] - ranks.mean(), others), _without(own, others)
    total = float(np.sum(left**2))
    rank = int(np.linalg.matrix_rank(rest, tol=ROUNDING * max(1.0, float(np.abs(own).max()))))
    freedom = ranks.size - 1 - int(np.linalg.matrix_rank(others)) - rank
    if total < ROUNDING * ranks.size or rank == 0 or freedom < 1:
        return None
    share = min(1.0, 1.0 - float(np.sum(_without(left, rest) ** 2)) / total)
    ratio = share / max(1.0 - share, 1e-300) * freedom / rank
    chance = float(f_distribution.sf(ratio, rank, freedom))
    effect = float(np.sign(np.sum(left * rest))) * share**0.5 if signed else share
    return Sensitivity(criterion, name, effect, signed, chance)


def _without(values: FloatArray, others: FloatArray) -> FloatArray:
    """What least squares by other columns leaves."""
    fit = np.linalg.lstsq(others, values, rcond=None)[0]
    left: FloatArray = values - others @ fit
    return left
