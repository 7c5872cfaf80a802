"""Sensitivities against the inverse of the rank correlation matrix, and by hand."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.stats import spearmanr

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
