"""The flat inverse (7) of the crane: the load's position determines everything (E7, E8).

It is stated only here. From it codegen writes the inverse itself (kernels/crane/_crane.py), its
time derivatives of any order (_series.py) and the demands on the rope (_rope.py).

With w = p'' + g e_z the rope pulls along w: F_l = -m_p |w|. The unit vector from trolley to load is
-w / |w|, and the trolley is where the line of the rope reaches z = 0. Rates and accelerations
follow by total differentiation, which needs p up to its fourth derivative in all three axes.
"""

from __future__ import annotations

from collections.abc import Sequence

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


def pull(flat: sp.Matrix, gravity: sp.Symbol) -> sp.Matrix:
    """w = p'' + g e_z, the rope's force per mass of the load [m/s2], shape (3, 1)."""
    return sp.Matrix([flat[2, 0], flat[2, 1], flat[2, 2] + gravity])


def pull_size(w: sp.Matrix) -> sp.Expr:
    """|w| [m/s2]."""
    return sp.sqrt(w[0] ** 2 + w[1] ** 2 + w[2] ** 2)


def rope_length(load: sp.Matrix, w: sp.Matrix) -> sp.Expr:
    """Rope length [m] from the load's position and w."""
    return -load[2] * pull_size(w) / w[2]


def configuration(load: sp.Matrix, w: sp.Matrix) -> sp.Matrix:
    """Coordinates (x_t, y_t, l, phi_x, phi_y) from the load's position and w, shape (5, 1)."""
    return sp.Matrix(
        [
            load[0] - load[2] * w[0] / w[2],
            load[1] - load[2] * w[1] / w[2],
            rope_length(load, w),
            sp.atan2(-w[0], sp.sqrt(w[1] ** 2 + w[2] ** 2)),
            sp.atan2(w[1], w[2]),
        ]
    )


def forces(
    acceleration: sp.Matrix, flat: sp.Matrix, w: sp.Matrix, masses: Sequence[sp.Symbol]
) -> sp.Matrix:
    """Drive forces F_x, F_y, F_l [N], shape (3, 1).

    `acceleration` is that of the coordinates; `masses` are those of bridge, trolley and payload.
    """
    bridge_mass, trolley_mass, payload_mass = masses
    return sp.Matrix(
        [
            (bridge_mass + trolley_mass) * acceleration[0] + payload_mass * flat[2, 0],
            trolley_mass * acceleration[1] + payload_mass * flat[2, 1],
            -payload_mass * pull_size(w),
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
    w = pull(flat, gravity)
    q = configuration(flat[0, :], w)
    rate = q.applyfunc(lambda f: total_derivative(f, flat))
    acceleration = rate.applyfunc(lambda f: total_derivative(f, flat))
    force = forces(acceleration, flat, w, (bridge_mass, trolley_mass, payload_mass))
    return force, q.col_join(rate), acceleration
