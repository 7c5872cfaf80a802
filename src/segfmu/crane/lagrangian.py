"""Lagrange's equations of the 3-DOF gantry crane, (16)-(20) with errata E5, E6 and E8.

Coordinates q = (x_t, y_t, l, phi_x, phi_y). The bridge moves in x and carries the trolley, which
moves in y (E6). F_l is the generalised force that lengthens the rope; tension is negative (E8).
Besides the drive forces, every coordinate has a generalised force, and a force acts on the load.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

import sympy as sp


@dataclass(frozen=True)
class Symbols:
    """The symbols of the crane's equations; vectors as 1-column matrices."""

    q: sp.Matrix
    rate: sp.Matrix
    force: sp.Matrix
    load_force: sp.Matrix
    bridge_mass: sp.Symbol
    trolley_mass: sp.Symbol
    payload_mass: sp.Symbol
    gravity: sp.Symbol


def symbols() -> Symbols:
    """Return fresh symbols, all real; masses, gravity and rope length positive."""
    names = ("x_t", "y_t", "l", "phi_x", "phi_y")
    return Symbols(
        q=sp.Matrix([sp.Symbol(n, real=True, positive=n == "l" or None) for n in names]),
        rate=sp.Matrix([sp.Symbol(f"{n}_rate", real=True) for n in names]),
        force=sp.Matrix([sp.Symbol(f"f_{n}", real=True) for n in names]),
        load_force=sp.Matrix([sp.Symbol(f"w_{n}", real=True) for n in "xyz"]),
        bridge_mass=sp.Symbol("bridge_mass", positive=True),
        trolley_mass=sp.Symbol("trolley_mass", positive=True),
        payload_mass=sp.Symbol("payload_mass", positive=True),
        gravity=sp.Symbol("gravity", positive=True),
    )


def load_position(q: sp.Matrix) -> sp.Matrix:
    """Position of the load, (16)."""
    x, y, length, phi_x, phi_y = q
    return sp.Matrix(
        [
            x + length * sp.sin(phi_x),
            y - length * sp.cos(phi_x) * sp.sin(phi_y),
            -length * sp.cos(phi_x) * sp.cos(phi_y),
        ]
    )


def load_velocity(s: Symbols) -> sp.Matrix:
    """Velocity of the load."""
    return load_position(s.q).jacobian(s.q) * s.rate


def energies(s: Symbols) -> tuple[sp.Expr, sp.Expr]:
    """Kinetic and potential energy, (17a) and (17b)."""
    velocity = load_velocity(s)
    kinetic = (
        s.payload_mass / 2 * velocity.dot(velocity)
        + s.trolley_mass / 2 * (s.rate[0] ** 2 + s.rate[1] ** 2)
        + s.bridge_mass / 2 * s.rate[0] ** 2
    )
    return kinetic, s.gravity * s.payload_mass * load_position(s.q)[2]


def residual(s: Symbols, acceleration: sp.Matrix) -> sp.Matrix:
    """Lagrange's equations (20), corrected by E5: zero for the true accelerations."""
    kinetic, potential = energies(s)
    lagrangian = kinetic - potential
    momentum = sp.Matrix([lagrangian]).jacobian(s.rate).T
    change = momentum.jacobian(s.q) * s.rate + momentum.jacobian(s.rate) * acceleration
    work = s.force + load_position(s.q).jacobian(s.q).T * s.load_force
    return change - sp.Matrix([lagrangian]).jacobian(s.q).T - work


def is_solution(s: Symbols, acceleration: sp.Matrix) -> bool:
    """Whether accelerations satisfy (20), checked in exact arithmetic at a generic point."""
    phi_x, phi_y = s.q[3], s.q[4]
    angles = {
        sp.sin(phi_x): sp.Rational(3, 5), sp.cos(phi_x): sp.Rational(4, 5),
        sp.sin(phi_y): sp.Rational(-5, 13), sp.cos(phi_y): sp.Rational(12, 13),
    }
    rest = residual(s, acceleration).xreplace(angles)
    names = sorted(rest.free_symbols, key=str)
    point = {name: sp.Rational(sp.prime(i + 4), 7) for i, name in enumerate(names)}
    return all(value.xreplace(point) == 0 for value in rest)


def gram(columns: sp.Matrix) -> sp.Matrix:
    """Products of columns by each other; all equations of a crane ask for the same ones."""
    return (columns.T * columns).applyfunc(_simplified)


@cache
def _simplified(expression: sp.Expr) -> sp.Expr:
    return sp.simplify(expression)


def _suspension(s: Symbols) -> tuple[sp.Matrix, sp.Matrix, sp.Matrix]:
    """Columns d p / d (l, phi_x, phi_y), their Gram matrix, and the velocity-dependent part of p''.

    The columns are orthogonal, so the Gram matrix is diagonal. Therefore the equations can be
    solved for the accelerations without inverting the mass matrix.
    """
    jacobian = load_position(s.q).jacobian(s.q)
    columns = jacobian[:, 2:]
    squares = gram(columns)
    if not squares.is_diagonal():
        raise AssertionError("the suspension's directions are orthogonal by construction")
    return columns, squares, (jacobian * s.rate).jacobian(s.q) * s.rate


def _gravity(s: Symbols) -> sp.Matrix:
    return sp.Matrix([0, 0, s.gravity])


def accelerations(s: Symbols) -> sp.Matrix:
    """Solve (20) for the second derivatives of q, shape (5, 1).

    The last three equations do not contain the carriage's inertia; they give the load's
    acceleration. The first two then give the carriage's.
    """
    columns, squares, coriolis = _suspension(s)
    rope = columns * squares.inv() * s.force[2:, :]
    load = (rope + s.load_force) / s.payload_mass - _gravity(s)
    reaction = s.load_force - s.payload_mass * load
    carriage = sp.Matrix(
        [
            (s.force[0] + reaction[0]) / (s.bridge_mass + s.trolley_mass),
            (s.force[1] + reaction[1]) / s.trolley_mass,
        ]
    )
    relative = load - coriolis - sp.Matrix([carriage[0], carriage[1], 0])
    return carriage.col_join(squares.inv() * columns.T * relative)


def driven_accelerations(s: Symbols, carriage: sp.Matrix) -> tuple[sp.Matrix, sp.Matrix]:
    """Motion with prescribed accelerations of bridge, trolley and rope.

    Returns the five accelerations and the drive forces for the prescribed motion; the sway torques
    s.force[3:] and the force on the load still act.
    """
    columns, squares, coriolis = _suspension(s)
    moved = sp.Matrix([carriage[0], carriage[1], 0]) + columns[:, 0] * carriage[2] + coriolis
    free = s.load_force / s.payload_mass - _gravity(s)
    sway = [
        (s.force[2 + i] / s.payload_mass + columns[:, i].dot(free - moved)) / squares[i, i]
        for i in (1, 2)
    ]
    load = moved + columns[:, 1] * sway[0] + columns[:, 2] * sway[1]
    pull = s.payload_mass * (load - free)
    forces = sp.Matrix(
        [
            (s.bridge_mass + s.trolley_mass) * carriage[0] + s.payload_mass * load[0]
            - s.load_force[0],
            s.trolley_mass * carriage[1] + s.payload_mass * load[1] - s.load_force[1],
            columns[:, 0].dot(pull),
        ]
    )
    return sp.Matrix([*carriage, *sway]), forces
