"""Sensitivities against the inverse of the rank correlation matrix, and by hand."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.stats import f_oneway, rankdata, spearmanr
from scipy.stats import t as student

from segfmu.validation.campaigns.sensitivity import sensitivities

RANDOM = np.random.default_rng(5)
A, B, C = RANDOM.random((3, 200))
MARGIN = np.exp(3.0 * A) - B + 0.3 * RANDOM.normal(size=200)


def test_numbers_have_the_partial_rank_correlation() -> None:
    found = sensitivities(
        {"a": A.tolist(), "b": B.tolist(), "c": C.tolist()}, {"m": MARGIN.tolist()}
    )
    inverse = np.linalg.inv(spearmanr(np.column_stack([A, B, C, MARGIN])).statistic)
    expected = -inverse[:3, 3] / np.sqrt(np.diag(inverse)[:3] * inverse[3, 3])
    effects = {s.factor: s.effect for s in found}
    assert [effects[n] for n in "abc"] == pytest.approx(expected.tolist(), abs=1e-9)
    assert found[0].factor == "a" and found[0].effect > 0.9 and found[0].chance < 1e-50
    assert effects["b"] < -0.5
    assert next(s for s in found if s.factor == "c").chance > 0.01


def test_choices_have_the_share_that_they_explain() -> None:
    # ranks of the margin are 1 to 6, group means 2 and 5: between groups 2 * 3 * 1.5^2 of 17.5
    found = sensitivities({"k": list("xxxyyy")}, {"m": [1.0, 2.0, 3.0, 10.0, 20.0, 30.0]})
    assert [(s.factor, s.signed) for s in found] == [("k", False)]
    assert found[0].effect == pytest.approx(13.5 / 17.5, abs=1e-12)


def test_runs_without_a_margin_are_left_out() -> None:
    margins: list[float | None] = [*MARGIN.tolist(), None, float("nan")]
    both = sensitivities({"a": [*A.tolist(), 0.5, 0.5]}, {"m": margins})
    assert both == sensitivities({"a": A.tolist()}, {"m": MARGIN.tolist()})


@pytest.mark.parametrize("factors", [{}, {"a": [1.0, 1.0, 1.0]}, {"a": [None, 1.0, 2.0]}])
def test_where_there_is_nothing_to_tell(factors: dict[str, list[float | None]]) -> None:
    assert sensitivities(factors, {"m": [1.0, 2.0, 3.0]}) == []
    assert sensitivities({"a": [1.0, 2.0, 3.0]}, {"m": [1.0, 1.0, 1.0]}) == []


@pytest.mark.parametrize("count", [6, 12, 60])
def test_the_chance_of_a_number_is_that_of_the_partial_correlation(count: int) -> None:
    """Student's t with two degrees of freedom less than there are runs and other factors."""
    a, b, c, m = np.random.default_rng(count).random((4, count))
    found = sensitivities({"a": a.tolist(), "b": b.tolist(), "c": c.tolist()}, {"m": m.tolist()})
    for one in found:
        freedom = count - 2 - 2
        ratio = abs(one.effect) * (freedom / (1.0 - one.effect**2)) ** 0.5
        assert one.chance == pytest.approx(2.0 * student.sf(ratio, freedom), rel=1e-9)


def test_the_chance_of_a_choice_is_that_of_the_analysis_of_variance() -> None:
    kinds, margin = list("xyzxyzxyzxy"), np.random.default_rng(4).random(11)
    ranks = rankdata(margin)
    groups = [[r for r, k in zip(ranks, kinds, strict=True) if k == kind] for kind in "xyz"]
    (one,) = sensitivities({"k": kinds}, {"m": margin.tolist()})
    assert one.chance == pytest.approx(f_oneway(*groups).pvalue, rel=1e-9)


def test_factors_that_say_the_same_take_one_degree_of_freedom() -> None:
    a, b, m = np.random.default_rng(8).random((3, 9))
    alone = sensitivities({"a": a.tolist(), "b": b.tolist()}, {"m": m.tolist()})
    twice = sensitivities(
        {"a": a.tolist(), "b": b.tolist(), "c": b.tolist()}, {"m": m.tolist()}
    )
    chance = {s.factor: s.chance for s in alone}["a"]
    assert {s.factor: s.chance for s in twice}["a"] == pytest.approx(chance, rel=1e-9)
