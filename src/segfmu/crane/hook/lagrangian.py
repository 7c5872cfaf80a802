"""Lagrange's equations of a crane whose load hangs by a sling on a hook: a double pendulum.

Coordinates q = (x_t, y_t, l, phi_x, phi_y, psi_x, psi_y): those of the gantry crane, with its rope
from trolley to hook, and the angles of the sling against the vertical in the convention of (16).
Hook and load are points, rope and sling have no mass, and the sling has a fixed length. Forces are
those of crane/lagrangian.py; no torque acts on the sling.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from segfmu.crane.lagrangian import gram, load_position


@dataclass(frozen=True)
class Symbols:
    """The symbols of the equations; vectors as 1-column matrices."""

    q: sp.Matrix
    rate: sp.Matrix
    force: sp.Matrix
    load_force: sp.Matrix
    bridge_mass: sp.Symbol
    trolley_mass: sp.Symbol
    payload_mass: sp.Symbol
    gravity: sp.Symbol
    hook_mass: sp.Symbol
    sling: sp.Symbol


def symbols() -> Symbols:
    """Return fresh symbols, all real; masses, gravity and lengths positive."""
    names = ("x_t", "y_t", "l", "phi_x", "phi_y", "psi_x", "psi_y")
    scalars = ("bridge_mass", "trolley_mass", "payload_mass", "gravity", "hook_mass", "sling")
    return Symbols(
        sp.Matrix([sp.Symbol(n, real=True, positive=n == "l" or None) for n in names]),
        sp.Matrix([sp.Symbol(f"{n}_rate", real=True) for n in names]),
        sp.Matrix([sp.Symbol(f"f_{n}", real=True) for n in names[:5]]),
        sp.Matrix([sp.Symbol(f"w_{n}", real=True) for n in "xyz"]),
        *(sp.Symbol(n, positive=True) for n in scalars),
    )


def hook_position(s: Symbols) -> sp.Matrix:
    """Position of the hook: (16) of the rope."""
    return load_position(s.q[:5, :])


def positions(s: Symbols) -> tuple[sp.Matrix, sp.Matrix]:
    """Positions of hook and load: (16) of the rope, and of the sling below the hook."""
    hook = hook_position(s)
    return hook, hook + load_position(sp.Matrix([0, 0, s.sling, s.q[5], s.q[6]]))


def velocities(s: Symbols) -> tuple[sp.Matrix, sp.Matrix]:
    """Velocities of hook and load."""
    hook, load = (place.jacobian(s.q) * s.rate for place in positions(s))
    return hook, load


def energies(s: Symbols) -> tuple[sp.Expr, sp.Expr]:
    """Kinetic and potential energy, as (17a) and (17b) with the hook's."""
    hook, load = velocities(s)
    kinetic = (
        s.hook_mass / 2 * hook.dot(hook) + s.payload_mass / 2 * load.dot(load)
        + s.trolley_mass / 2 * (s.rate[0] ** 2 + s.rate[1] ** 2)
        + s.bridge_mass / 2 * s.rate[0] ** 2
    )
    below, lowest = positions(s)
    return kinetic, s.gravity * (s.hook_mass * below[2] + s.payload_mass * lowest[2])


def residual(s: Symbols, acceleration: sp.Matrix) -> sp.Matrix:
    """Lagrange's equations: zero for the true accelerations, shape (7, 1)."""
    kinetic, potential = energies(s)
    lagrangian = kinetic - potential
    momentum = sp.Matrix([lagrangian]).jacobian(s.rate).T
    change = momentum.jacobian(s.q) * s.rate + momentum.jacobian(s.rate) * acceleration
    work = s.force.col_join(sp.zeros(2, 1)) + positions(s)[1].jacobian(s.q).T * s.load_force
    return change - sp.Matrix([lagrangian]).jacobian(s.q).T - work


def is_solution(s: Symbols, acceleration: sp.Matrix) -> bool:
    """Whether accelerations solve the equations, checked in exact arithmetic at a generic point."""
    triples = ((3, 4, 5), (-5, 12, 13), (8, 15, 17), (-7, 24, 25))
    angles = {}
    for angle, (opposite, adjacent, long) in zip(s.q[3:, :], triples, strict=True):
        angles[sp.sin(angle)] = sp.Rational(opposite, long)
        angles[sp.cos(angle)] = sp.Rational(adjacent, long)
    # at once: subs would take the names one after the other
    rest = residual(s, acceleration).xreplace(angles)
    names = sorted(rest.free_symbols, key=str)
    point = {name: sp.Rational(sp.prime(i + 4), 7) for i, name in enumerate(names)}
    return all(value.xreplace(point) == 0 for value in rest)


@dataclass(frozen=True)
class _Pendulum:
    """A rope of fixed or changing length: unit vector along it, and how its lower end moves.

    `columns` are the derivatives of the end by both angles, orthogonal to each other and to
    the rope, `gram` their squares, and `drift` what rates alone accelerate the end by.
    """

    along: sp.Matrix
    columns: sp.Matrix
    gram: tuple[sp.Expr, sp.Expr]
    drift: sp.Matrix

    def across(self, vector: sp.Matrix) -> list[sp.Expr]:
        """Components by which the angles' accelerations follow from that of the lower end."""
        return [self.columns[:, i].dot(vector) / self.gram[i] for i in range(2)]


def _pendulum(length: sp.Expr, angles: sp.Matrix, rates: sp.Matrix) -> _Pendulum:
    """rates: of the length and the angles."""
    q = sp.Matrix([sp.Symbol("length", positive=True), *angles])
    end = load_position(sp.Matrix([0, 0, *q]))
    jacobian = end.jacobian(q)
    drift = ((jacobian * rates).jacobian(q) * rates).subs(q[0], length)
    squares = gram(jacobian)
    if not squares.is_diagonal() or squares[0, 0] != 1:
        raise AssertionError("the directions of a rope are orthogonal by construction")
    return _Pendulum(
        jacobian[:, 0], jacobian[:, 1:].subs(q[0], length),
        tuple(squares[i, i].subs(q[0], length) for i in (1, 2)), drift,
    )


def _suspension(s: Symbols) -> tuple[_Pendulum, _Pendulum]:
    """Rope and sling."""
    rope = _pendulum(s.q[2], s.q[3:5, :], s.rate[2:5, :])
    return rope, _pendulum(s.sling, s.q[5:, :], sp.Matrix([0, *s.rate[5:, :]]))


def _gravity(s: Symbols) -> sp.Matrix:
    return sp.Matrix([0, 0, s.gravity])


def _torques(s: Symbols, rope: _Pendulum) -> sp.Matrix:
    """Force on the hook of the torques on the rope's angles."""
    return sum(
        (rope.columns[:, i] * s.force[3 + i] / rope.gram[i] for i in range(2)), sp.zeros(3, 1)
    )


def accelerations(s: Symbols) -> tuple[sp.Matrix, sp.Expr]:
    """Second derivatives of q, shape (7, 1), and the tension of the sling.

    Rope and sling pull at hook and load; the tension of the sling keeps its length, a scalar
    equation. So Lagrange's equations are solved without a mass matrix.
    """
    rope, sling = _suspension(s)
    pull = rope.along * s.force[2] + _torques(s, rope)
    apart = s.load_force / s.payload_mass - pull / s.hook_mass - sling.drift
    tension = sling.along.dot(apart) / (1 / s.payload_mass + 1 / s.hook_mass)
    hook = (pull + sling.along * tension) / s.hook_mass - _gravity(s)
    load = (s.load_force - sling.along * tension) / s.payload_mass - _gravity(s)
    carriage = sp.Matrix(
        [
            (s.force[0] - pull[0]) / (s.bridge_mass + s.trolley_mass),
            (s.force[1] - pull[1]) / s.trolley_mass,
            0,
        ]
    )
    below = hook - carriage - rope.drift
    angles = [*rope.across(below), *sling.across(load - hook - sling.drift)]
    return sp.Matrix([carriage[0], carriage[1], rope.along.dot(below), *angles]), tension


def driven_accelerations(
    s: Symbols, carriage: sp.Matrix
) -> tuple[sp.Matrix, sp.Matrix, sp.Expr]:
    """Motion with prescribed accelerations of bridge, trolley and rope.

    Returns the seven accelerations, the drive forces for the prescribed motion, and the tension of
    the sling; the torques s.force[3:] and the force on the load still act.
    """
    rope, sling = _suspension(s)
    moved = sp.Matrix([carriage[0], carriage[1], 0]) + rope.along * carriage[2] + rope.drift
    swing = [
        (s.force[3 + i] / s.hook_mass - rope.columns[:, i].dot(_gravity(s) + moved)) / rope.gram[i]
        for i in range(2)
    ]
    # the hook without a sling, and what the sling's tension adds to its acceleration
    free = moved + rope.columns[:, 0] * swing[0] + rope.columns[:, 1] * swing[1]
    given = rope.across(sling.along / s.hook_mass)
    added = rope.columns[:, 0] * given[0] + rope.columns[:, 1] * given[1]
    apart = s.load_force / s.payload_mass - _gravity(s) - free - sling.drift
    tension = sling.along.dot(apart) / (1 / s.payload_mass + sling.along.dot(added))
    hook = free + added * tension
    load = (s.load_force - sling.along * tension) / s.payload_mass - _gravity(s)
    pull = s.hook_mass * (hook + _gravity(s)) - sling.along * tension
    forces = sp.Matrix(
        [
            (s.bridge_mass + s.trolley_mass) * carriage[0] + pull[0],
            s.trolley_mass * carriage[1] + pull[1],
            rope.along.dot(pull),
        ]
    )
    angles = [swing[i] + given[i] * tension for i in range(2)]
    angles += sling.across(load - hook - sling.drift)
    return sp.Matrix([*carriage, *angles]), forces, tension
