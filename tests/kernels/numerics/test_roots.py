"""The first steps of a bracketed root search."""

from __future__ import annotations

import pytest

from segfmu.kernels.numerics.roots import root_share


def test_the_first_step_is_that_of_the_secant_within_the_bracket() -> None:
    assert root_share(1.0, 0.0, 0.0, 3.0, -1.0, -1.0) == pytest.approx(0.75)
    assert root_share(1.0, 0.0, 0.0, 1e6, -1e-6, -1e-6) == 0.9
    assert root_share(1.0, 0.0, 0.0, 1e-6, -1e6, -1e6) == 0.1


@pytest.mark.parametrize("error", [1.0, 1e-200, 0.0])
def test_errors_that_tell_nothing_halve_the_bracket(error: float) -> None:
    assert root_share(1.0, 0.0, 0.0, error, error, error) == 0.5
