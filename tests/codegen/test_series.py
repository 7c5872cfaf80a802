"""The walk over an expression forms what the expression is."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp

from segfmu.codegen.flat import LOAD, PULL
from segfmu.codegen.series import INTERMEDIATE, _Walk
from segfmu.kernels.numerics import series

X, Y, Z = LOAD
W = PULL[2]
COUNT = 6


def walked(expression: sp.Expr, rows: dict[str, np.ndarray]) -> np.ndarray:
    """Run the statements of the walk."""
    walk = _Walk()
    walk.result("found", expression)
    names = vars(series) | rows | {"count": COUNT, "found": np.zeros(COUNT)}
    names |= {name: np.zeros(COUNT) for name in INTERMEDIATE}
    exec("\n".join(walk.lines), names)
    return np.asarray(names["found"])


@pytest.mark.parametrize(
    "expression",
    [X + Y, X - Y, -X, X * Y * Z, -X * Y, X / Y, -X * Z / Y, sp.sqrt(Y) - X**2, X - (Y + Z) * W],
    ids=str,
)
def test_statements_give_the_series_of_the_expression(expression: sp.Expr) -> None:
    t = sp.Symbol("t")
    of_time = {X: 1 + 2 * t - t**3, Y: 3 - t + t**4, Z: sp.exp(t), W: 2 + sp.sin(t)}
    rows = {str(name): coefficients(value, t) for name, value in of_time.items()}
    expected = coefficients(expression.xreplace(of_time), t)
    assert walked(expression, rows) == pytest.approx(expected, rel=1e-12, abs=1e-12)


def coefficients(value: sp.Expr, t: sp.Symbol) -> np.ndarray:
    return np.array([float(value.diff(t, k).subs(t, 0) / sp.factorial(k)) for k in range(COUNT)])


@pytest.mark.parametrize("expression", [sp.sin(X), X**3, -X - Y], ids=str)
def test_what_series_do_not_offer_is_refused(expression: sp.Expr) -> None:
    with pytest.raises(AssertionError, match="no operation on series"):
        _Walk().result("found", expression)
