"""Symbols shared by the generators that use crane/flatness.py."""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from segfmu.crane import flatness

MASSES = sp.symbols("bridge_mass trolley_mass payload_mass gravity", positive=True)
GRAVITY = MASSES[-1]
LOAD = sp.Matrix(sp.symbols("x y z", real=True))
PULL = sp.Matrix(sp.symbols("w_x w_y w_z", real=True))


def derivatives_of_load(values: sp.Matrix) -> Iterator[tuple[int, int, sp.Expr]]:
    """Order, axis and constant of values that are a derivative of the load's position plus a
    constant."""
    flat = flatness.flat_symbols()
    for value in values:
        (symbol,) = value.free_symbols & set(flat)
        order, axis = divmod(list(flat).index(symbol), 3)
        yield order, axis, value - symbol


def place(field: str, index: int) -> str:
    """Text of the index of an entry of a record's field."""
    return f"{field} + {index}" if index else field
