"""The flat inverse (7) of the crane: the load's position determines everything (E7, E8).

With w = p'' + g e_z the rope pulls along w: F_l = -m_p |w|, the unit vector from trolley to load
is -w / |w|, and the trolley lies where the rope meets its height, z = 0. Rates and accelerations
follow by total differentiation, which needs p up to its fourth derivative in all three axes.
"""

from __future__ import annotations

import sympy as sp

ORDERS = 5


def flat_symbols() -> sp.Matrix:
    """Symbols of the flat output's derivatives, shape (5, 3): row d is the d-th derivative."""
    return sp.Matrix(ORDERS, 3, lambda d, i: sp.Symbol(f"p{d}{'xyz'[i]}", real=True))


def total_derivative(expression: sp.Expr, flat: sp.Matrix) -> sp.Expr:
    """d/dt of an expression in the derivatives of the flat output below the highest one."""
    return sp.Add(
        *[
            expression.diff(flat[d, i]) * flat[d + 1, i]
            for d in range(ORDERS - 1)
            for i in range(3)
        ]
    )


def configuration(flat: sp.Matrix, gravity: sp.Symbol) -> sp.Matrix:
    """Coordinates (x_t, y_t, l, phi_x, phi_y) from p and p''."""
    wx, wy, wz = flat[2, 0], flat[2, 1], flat[2, 2] + gravity
    return sp.Matrix(
        [
            flat[0, 0] - flat[0, 2] * wx / wz,
            flat[0, 1] - flat[0, 2] * wy / wz,
            -flat[0, 2] * sp.sqrt(wx**2 + wy**2 + wz**2) / wz,
            sp.atan2(-wx, sp.sqrt(wy**2 + wz**2)),
            sp.atan2(wy, wz),
        ]
    )


def inverse(
    flat: sp.Matrix,
    bridge_mass: sp.Symbol,
    trolley_mass: sp.Symbol,
    payload_mass: sp.Symbol,
    gravity: sp.Symbol,
) -> tuple[sp.Matrix, sp.Matrix, sp.Matrix]:
    """Drive forces (3, 1), state (10, 1) and accelerations (5, 1) of the crane."""
    q = configuration(flat, gravity)
    rate = q.applyfunc(lambda f: total_derivative(f, flat))
    acceleration = rate.applyfunc(lambda f: total_derivative(f, flat))
    wx, wy, wz = flat[2, 0], flat[2, 1], flat[2, 2] + gravity
    force = sp.Matrix(
        [
            (bridge_mass + trolley_mass) * acceleration[0] + payload_mass * flat[2, 0],
            trolley_mass * acceleration[1] + payload_mass * flat[2, 1],
            -payload_mass * sp.sqrt(wx**2 + wy**2 + wz**2),
        ]
    )
    return force, q.col_join(rate), acceleration
